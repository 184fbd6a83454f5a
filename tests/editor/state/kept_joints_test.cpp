#include "app/editor/state/kept_joints.h"

#include <gtest/gtest.h>

#include <random>

#include "app/editor/commands/closing_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/joint_mark_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/piece_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/symmetry_commands.h"
#include "app/editor/state/old_entries.h"
#include "app/editor/state/same_document.h"
#include "tests/editor/random_session.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using core::JointMark;

/// Three quadratic Bézier pieces in a row, smooth at 1 and with a corner at 2; a ring with a marked seam.
const char* marked_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "row", "degree": 2, "knots": [0,0,0,1,1,2,2,3,3,3],
    "points": [[0,2],[1,2],[2,2],[3,2],[4,1],[6,1],[6,3]],
    "joints": [{"u": 1, "mark": "smooth"}, {"u": 2, "mark": "corner"}] },
  { "name": "ring", "degree": 3, "periodic": true, "knots": [0,0,1,2,3,4],
    "points": [[0,-8],[3,-8],[4,-6],[2,-4],[-1,-6]], "joints": [{"u": 0, "mark": "smooth"}] },
  { "name": "tail", "degree": 1, "knots": [0,0,1,1], "points": [[9,9],[9,12]] } ] })";

class KeptJoints : public testing::Test {
  protected:
    void SetUp() override { open_text(editor, marked_text); }
    const std::string& message() const { return editor.state().message.text; }
    const core::JointMarks& marks(std::size_t i) const { return document(editor).curves[i].joints; }

    Editor editor;
};

TEST_F(KeptJoints, a_mark_whose_knot_became_two_ends_is_told_of) {
    ASSERT_TRUE(editor.run(Split{.u = 1})) << message();
    EXPECT_TRUE(marks(0).is_empty());
    EXPECT_EQ(marks(1).knots, (std::vector<core::KnotMark>{{2, JointMark::corner}}));
    EXPECT_NE(message().find("; u = 1 is no knot inside a curve any more, and its mark is gone"), std::string::npos)
        << message();
    ASSERT_TRUE(editor.run(Undo{}));
    ASSERT_TRUE(editor.run(Split{.u = 1.5}));
    EXPECT_EQ(message().find("mark"), std::string::npos) << message();
    ASSERT_TRUE(editor.run(Undo{}));
    ASSERT_TRUE(editor.run(BezierPieces{}));
    EXPECT_NE(message().find("; 2 marks are gone, whose knots are inside no curve any more"), std::string::npos)
        << message();
}

TEST_F(KeptJoints, a_mark_of_a_seam_that_is_opened_or_of_a_knot_that_is_cut_off_is_told_of) {
    ASSERT_TRUE(editor.run(SubCurve{.begin = 0.0, .end = 1.5}));
    EXPECT_NE(message().find("; u = 2 is no knot inside a curve any more, and its mark is gone"), std::string::npos)
        << message();
    ASSERT_TRUE(editor.run(ActivateCurve{.index = 1}));
    ASSERT_TRUE(editor.run(CloseOrOpen{})) << message();
    EXPECT_TRUE(marks(1).is_empty());
    EXPECT_NE(message().find("; u = 0 is no knot inside a curve any more, and its mark is gone"), std::string::npos)
        << message();
}

TEST_F(KeptJoints, a_mark_that_the_seam_of_a_mirror_breaks_is_dropped_and_told_of) {
    ASSERT_TRUE(editor.run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = true}));
    EXPECT_EQ(message(), "Linked the curve to its mirror image");
    // The joint would turn the leg from (1, 2) on, which the mirror holds level.
    ASSERT_TRUE(editor.run(SetPoint{.index = 3, .position = {3, 3}}));
    EXPECT_EQ(document(editor).curves[0].curve->control_points()[3], core::Point(3, 3));
    EXPECT_EQ(document(editor).curves[0].curve->control_points()[1].y, 2.0);
    EXPECT_EQ(marks(0).knots, (std::vector<core::KnotMark>{{2, JointMark::corner}}));
    EXPECT_EQ(marks(3).knots, marks(0).knots);
    EXPECT_NE(message().find("the joint at u = 1 could not be kept smooth (G1), and its mark is gone"),
              std::string::npos)
        << message();
}

TEST_F(KeptJoints, only_curves_that_hang_together_with_one_that_changed_are_looked_at) {
    const core::Document& before = document(editor);
    core::Document after = before;
    after.curves[2].curve = document(editor).curves[0].curve;
    EXPECT_TRUE(keep_marked_joints(before, after).empty());
    for (const std::size_t i : {0U, 1U}) EXPECT_EQ(after.curves[i].curve, before.curves[i].curve);
}

TEST_F(KeptJoints, curves_are_found_by_place_by_shape_and_by_name) {
    const core::Document before = document(editor);
    core::Document after = before;
    std::swap(after.curves[0], after.curves[2]);
    after.curves[0].curve = std::make_shared<const core::Curve>(*after.curves[0].curve);
    after.curves.push_back(after.curves[0]);
    after.curves[3].name = "new";
    after.curves[3].curve = std::make_shared<const core::Curve>(*after.curves[0].curve);
    EXPECT_EQ(old_entries(before, after), (std::vector<const core::DocumentCurve*>{&before.curves[2], &before.curves[1],
                                                                                   &before.curves[0], nullptr}));
    after = before;
    after.curves[1].curve = before.curves[0].curve;
    EXPECT_EQ(old_entries(before, after)[1], &before.curves[1]) << "at its place";
}

TEST(KeptJointsInFiles, what_300_random_sessions_write_can_be_read) {
    std::size_t marked = 0;
    for (unsigned seed = 1; seed <= 300 && !testing::Test::HasFailure(); ++seed) {
        Editor editor;
        open_text(editor, marked_text);
        RandomSession commands(seed);
        std::mt19937 chance(seed);
        for (int k = 0; k < 25; ++k) {
            const core::Document before = document(editor);
            const core::DocumentCurve* active = before.active_curve();
            if (active != nullptr && chance() % 3 == 0) {
                const auto knots = active->curve->knots().stored();
                editor.run(
                    MarkJoint{.mark = static_cast<JointMark>(chance() % 3), .u = knots[chance() % knots.size()]});
            } else {
                editor.perform(commands.next(editor.state()));
            }
            if (has_same_content(before, document(editor))) continue;
            for (const core::DocumentCurve& entry : document(editor).curves)
                marked += entry.joints.is_empty() ? 0U : 1U;
            const std::string text = core::format_document(document(editor));
            const auto read = core::parse_document(text);
            ASSERT_TRUE(read) << seed << ", " << k << ": " << read.error().sentence() << "\n"
                              << editor.state().message.text << "\n"
                              << text;
        }
    }
    EXPECT_GT(marked, 1000U);
}

}  // namespace
}  // namespace batten::editor
