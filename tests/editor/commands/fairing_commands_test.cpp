#include "app/editor/commands/fairing_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/command_spec.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/geometric_distance.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class FairingCommands : public ::testing::Test {
  protected:
    FairingCommands() { open_text(editor_, sample_text); }
    const EditorState& state() const { return editor_.state(); }
    const std::string& message() const { return state().message.text; }
    bool run(const Command& command) { return editor_.run(command); }

    Editor editor_;
};

// How far the curve that is shown is from `before` at equal parameters.
double farthest(const core::Curve& before, const core::Curve& now) {
    double farthest = 0.0;
    for (int k = 0; k <= 1000; ++k)
        farthest =
            std::max(farthest, core::distance(core::point_at(before, k / 1000.0), core::point_at(now, k / 1000.0)));
    return farthest;
}

TEST_F(FairingCommands, fair_part_moves_the_part_alone_and_says_so) {
    const core::Curve before = curve(editor_);
    EXPECT_TRUE(run(FairPart{.from = 0.3, .to = 0.6, .distance = 0.1}));
    EXPECT_LE(core::geometric_distance(before, curve(editor_)), 0.1);
    EXPECT_NE(curve(editor_), before);
    EXPECT_EQ(points(editor_)[0], before.control_points()[0]);
    EXPECT_EQ(points(editor_)[1], before.control_points()[1]);
    EXPECT_EQ(points(editor_).back(), before.control_points().back());
    EXPECT_EQ(message().rfind("Faired from u = 0.3 to 0.6; ", 0), 0U) << message();
    EXPECT_TRUE(run(Undo{}));
    EXPECT_EQ(curve(editor_), before);
    EXPECT_FALSE(run(FairPart{.from = 0.6, .to = 0.3, .distance = 0.1}));
    EXPECT_EQ(message(), "the range begins at 0.6 and ends at 0.3; its end must be above its beginning");
}

TEST_F(FairingCommands, rebuild_gives_so_many_points_over_even_knots) {
    EXPECT_TRUE(run(Rebuild{.count = 12, .degree = 4}));
    EXPECT_EQ(points(editor_).size(), 12U);
    EXPECT_EQ(curve(editor_).degree(), 4);
    EXPECT_EQ(curve(editor_).knots().kind(), core::KnotKind::clamped_uniform);
    EXPECT_NE(message().find(" control points as 12 of degree 4 over even knots; "), std::string::npos) << message();
    ASSERT_TRUE(state().ghost.has_value());
    EXPECT_LT(state().ghost->deviation, 0.5);
    EXPECT_FALSE(run(Rebuild{.count = 4, .degree = 4}));
    EXPECT_EQ(message(), "4 control points were found; at least 5 are needed") << message();
}

TEST_F(FairingCommands, simplify_counts_what_it_took) {
    const core::Curve before = curve(editor_);
    EXPECT_TRUE(run(Simplify{.tolerance = 1.0}));
    EXPECT_LT(points(editor_).size(), before.control_points().size());
    EXPECT_LE(farthest(before, curve(editor_)), 1.0);
    EXPECT_EQ(message().rfind("Simplified from ", 0), 0U) << message();
    EXPECT_TRUE(run(Undo{}));
    EXPECT_TRUE(run(Simplify{.tolerance = 1e-9}));
    EXPECT_EQ(curve(editor_), before);
    EXPECT_EQ(message(), "Nothing had to be changed");
}

TEST_F(FairingCommands, deleted_points_with_a_fit_leave_the_curve_nearer) {
    const core::Curve before = curve(editor_);
    EXPECT_TRUE(run(DeletePoints{.points = {3}}));
    const double plain = farthest(before, curve(editor_));
    EXPECT_TRUE(run(Undo{}));
    EXPECT_TRUE(run(DeleteAndRefit{.points = {3}}));
    EXPECT_LT(farthest(before, curve(editor_)), 0.8 * plain);
    EXPECT_EQ(points(editor_).size() + 1, before.control_points().size());
    EXPECT_EQ(message().rfind("Deleted P₃ and fitted the rest to the old curve; ", 0), 0U) << message();
    EXPECT_TRUE(state().selection.points.empty());
}

TEST_F(FairingCommands, locked_curves_stay) {
    run(ActivateCurve{.index = 2});
    for (const Command& command :
         std::vector<Command>{FairPart{.from = 0.1, .to = 0.6, .distance = 0.1}, Rebuild{.count = 12, .degree = 3},
                              Simplify{.tolerance = 1.0}, DeleteAndRefit{.points = {1}}})
        EXPECT_FALSE(run(command)) << command.spec().name;
}

}  // namespace
}  // namespace batten::editor
