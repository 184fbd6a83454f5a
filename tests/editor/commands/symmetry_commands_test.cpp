#include "app/editor/commands/symmetry_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/piece_commands.h"
#include "app/editor/commands/pin_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/shape_commands.h"
#include "app/editor/commands/transform_commands.h"
#include "app/editor/state/same_document.h"
#include "app/editor/state/symmetry_links.h"
#include "core/edit/transform.h"
#include "core/make/fit_points.h"
#include "core/measure/curvature.h"
#include "tests/editor/random_session.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

// From (0, 2) on the upright axis, which it leaves at a right angle, to (0, -3), where it comes in aslant.
const char* half_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "half", "degree": 3, "knots": [0,0,0,0,0.5,1,1,1,1], "points": [[0,2],[1,2],[3,1],[2,-1],[0,-3]] } ] })";

class SymmetryCommands : public ::testing::Test {
  protected:
    SymmetryCommands() { open_text(editor_, half_text); }
    const std::string& message() const { return editor_.state().message.text; }
    bool run(const Command& command) { return editor_.run(command); }
    std::span<const core::Point> points_of(std::size_t i) const {
        return document(editor_).curves[i].curve->control_points();
    }
    void expect_mirrored() const {
        ASSERT_EQ(document(editor_).curves.size(), 2U);
        ASSERT_EQ(points_of(0).size(), points_of(1).size());
        EXPECT_EQ(document(editor_).curves[0].curve->knots(), document(editor_).curves[1].curve->knots());
        for (std::size_t i = 0; i < points_of(0).size(); ++i)
            EXPECT_EQ(points_of(1)[i], core::Point(-points_of(0)[i].x, points_of(0)[i].y)) << i;
    }

    Editor editor_;
};

TEST_F(SymmetryCommands, every_edit_of_either_curve_is_made_to_both) {
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 7.0}, .angle = 90.0, .is_smooth = false}));
    EXPECT_EQ(message(), "Linked the curve to its mirror image");
    expect_mirrored();
    EXPECT_TRUE(run(SetPoint{.index = 2, .position = {4.125, 1.7}}));
    expect_mirrored();
    EXPECT_TRUE(run(InsertKnot{.u = 0.3}));
    expect_mirrored();
    EXPECT_TRUE(run(ActivateCurve{.index = 1}));
    EXPECT_TRUE(run(SetPoint{.index = 3, .position = {-5.3, 0.1}}));
    EXPECT_EQ(points_of(0)[3], core::Point(5.3, 0.1));
    expect_mirrored();
    EXPECT_TRUE(run(SetWeight{.index = 2, .weight = 3.5}));
    EXPECT_EQ(document(editor_).curves[0].curve->weights()[2], 3.5);
    EXPECT_TRUE(run(PinPoints{.points = {1}}));
    EXPECT_EQ(document(editor_).curves[0].pinned, std::vector<std::size_t>{1});
    for (int k = 0; k < 5; ++k) EXPECT_TRUE(run(Undo{}));
    EXPECT_EQ(points_of(0)[2], core::Point(3, 1));
    expect_mirrored();
}

TEST_F(SymmetryCommands, images_that_are_joined_leave_the_link_and_the_others_stay) {
    ASSERT_TRUE(run(LinkRotation{.turns = 5, .center = {0.0, 0.0}}));
    const auto third = document(editor_).curves[2].curve;
    ASSERT_TRUE(run(Join{.other = "1", .continuity = core::JoinContinuity::c0}));
    ASSERT_EQ(document(editor_).curves.size(), 4U);
    EXPECT_FALSE(document(editor_).curves[0].symmetry);
    EXPECT_GT(points_of(0).size(), third->control_points().size());
    EXPECT_EQ(document(editor_).curves[1].curve, third) << "as it was";
    for (std::size_t i = 1; i < 4; ++i) EXPECT_TRUE(document(editor_).curves[i].symmetry) << i;
    // Of two mirror images one is left.
    Editor other;
    open_text(other, half_text);
    ASSERT_TRUE(other.run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = false}));
    ASSERT_TRUE(other.run(Join{.other = "1", .continuity = core::JoinContinuity::c0}));
    ASSERT_EQ(document(other).curves.size(), 1U);
    EXPECT_FALSE(document(other).curves[0].symmetry);
}

TEST_F(SymmetryCommands, a_seam_that_is_smooth_stays_so_and_a_corner_stays_a_corner) {
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = false}));
    EXPECT_TRUE(run(SetPoint{.index = 0, .position = {0.4, 2.5}}));
    EXPECT_EQ(points_of(0)[0], core::Point(0, 2.5));
    EXPECT_EQ(points_of(0)[1], core::Point(1, 2.5));
    EXPECT_TRUE(run(SetPoint{.index = 1, .position = {1.5, 3.0}}));
    EXPECT_EQ(points_of(0)[1], core::Point(1.5, 2.5));
    EXPECT_TRUE(run(SetPoint{.index = 4, .position = {0.2, -4.0}}));
    EXPECT_EQ(points_of(0)[4], core::Point(0, -4));
    EXPECT_EQ(points_of(0)[3], core::Point(2, -1));
    expect_mirrored();
    // G2: run through from one half into the other, the curvature is the same on both sides.
    const auto right = core::curvature_at(*document(editor_).curves[0].curve, 0.0);
    const auto left = core::curvature_at(*document(editor_).curves[1].curve, 0.0);
    ASSERT_TRUE(right && left);
    EXPECT_NEAR(*right, -*left, 1e-15);
}

TEST_F(SymmetryCommands, ends_near_the_line_are_made_smooth_where_that_is_asked_for) {
    EXPECT_TRUE(run(LinkMirror{.center = {0.001, 0.0}, .angle = 90.0, .is_smooth = true}));
    EXPECT_EQ(points_of(0)[0], core::Point(0.001, 2));
    EXPECT_EQ(points_of(0)[4], core::Point(0.001, -3));
    EXPECT_EQ(points_of(0)[3].y, -3.0);
}

TEST_F(SymmetryCommands, what_an_end_was_moved_and_turned_is_said) {
    // The last leg goes from (2, -1) to (0, -3), half a right angle off; the start is right already.
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = true}));
    EXPECT_EQ(message(),
              "Linked the curve to its mirror image; its end was turned by 45° to meet its image smoothly (G2); linked "
              "with 'smooth' off, it would keep its corners");
    EXPECT_TRUE(run(Undo{}));
    // Beside the line by 1/256; the leg is (1/2, 2) from there, and the angle of the turn has the tangent 4.
    EXPECT_TRUE(run(SetPoint{.index = 4, .position = {0.00390625, -3}}));
    EXPECT_TRUE(run(SetPoint{.index = 3, .position = {0.5, -1}}));
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = true}));
    EXPECT_EQ(message().find("Linked the curve to its mirror image; its end was moved by 0.00390625 onto the line; its "
                             "end was turned by 75.96375"),
              0U)
        << message();
    EXPECT_TRUE(run(Undo{}));
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = false}));
    EXPECT_EQ(message(), "Linked the curve to its mirror image; its end was moved by 0.00390625 onto the line");
}

TEST_F(SymmetryCommands, an_end_along_the_line_keeps_its_corner_and_its_shape) {
    EXPECT_TRUE(run(SetPoint{.index = 3, .position = {0, -1}}));
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = true}));
    EXPECT_EQ(message(),
              "Linked the curve to its mirror image; its end cannot be turned to meet its image smoothly and keeps a "
              "corner");
    EXPECT_EQ(points_of(0)[3], core::Point(0, -1));
}

TEST_F(SymmetryCommands, a_polygon_keeps_its_corners) {
    open_text(editor_, R"({ "format": "batten", "version": 1, "curves": [
      { "name": "roof", "degree": 1, "knots": [0,0,1,1], "points": [[0,2],[4,0]] } ] })");
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = true}));
    EXPECT_EQ(message(),
              "Linked the curve to its mirror image; its start cannot be turned to meet its image smoothly and keeps a "
              "corner");
    EXPECT_EQ(points_of(0)[1], core::Point(4, 0));
}

TEST_F(SymmetryCommands, a_turn_takes_fit_points_and_says_so) {
    EXPECT_TRUE(run_typed(editor_, "through-points 0,0,3,2,1,4"));
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = true}));
    EXPECT_NE(message().find("its start was turned by "), std::string::npos) << message();
    EXPECT_NE(message().find("; the curve is an ordinary one now, without fit points"), std::string::npos) << message();
}

TEST_F(SymmetryCommands, what_a_seam_holds_back_is_said) {
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = false}));
    EXPECT_TRUE(run(SetPoint{.index = 2, .position = {3.5, 1.0}}));
    EXPECT_EQ(message().find("on the mirror"), std::string::npos) << message();
    EXPECT_TRUE(run(SetPoint{.index = 1, .position = {1.5, 3.0}}));
    EXPECT_EQ(points_of(0)[1], core::Point(1.5, 2));
    EXPECT_NE(message().find("; ends of 'half' stay on the mirror, and at right angles to it where they were"),
              std::string::npos)
        << message();
    // Mapped with the line, nothing is held back but rounding.
    EXPECT_TRUE(run(Rotate{.angle = 31.0, .what = MapTarget::all, .pivot = core::Point(0.3, 0.7)}));
    EXPECT_EQ(message().find("on the mirror"), std::string::npos) << message();
}

TEST_F(SymmetryCommands, points_that_a_curve_passes_have_images_too) {
    EXPECT_TRUE(run_typed(editor_, "through-points 1,0,3,2,1,4"));
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = false}));
    ASSERT_EQ(document(editor_).curves.size(), 3U);
    EXPECT_TRUE(run_typed(editor_, "move-fit-point 1 5 2.5"));
    const auto fit = [&](std::size_t i) { return document(editor_).curves[i].fit; };
    ASSERT_TRUE(fit(1) != nullptr && fit(2) != nullptr);
    EXPECT_EQ(fit(1)->points[1].place, core::Point(5, 2.5));
    EXPECT_EQ(fit(2)->points[1].place, core::Point(-5, 2.5));
    for (std::size_t i = 0; i < points_of(1).size(); ++i)
        EXPECT_EQ(points_of(2)[i], core::Point(-points_of(1)[i].x, points_of(1)[i].y));
}

TEST_F(SymmetryCommands, rotated_images_follow_and_lead) {
    EXPECT_TRUE(run(LinkRotation{.turns = 4, .center = {0.0, 0.0}}));
    ASSERT_EQ(document(editor_).curves.size(), 4U);
    EXPECT_EQ(points_of(1)[2], core::Point(-1, 3));
    EXPECT_TRUE(run(ActivateCurve{.index = 2}));
    EXPECT_TRUE(run(SetPoint{.index = 2, .position = {-5.0, -6.0}}));
    EXPECT_EQ(points_of(0)[2], core::Point(5, 6));
    EXPECT_EQ(points_of(1)[2], core::Point(-6, 5));
    EXPECT_EQ(points_of(3)[2], core::Point(6, -5));
}

TEST_F(SymmetryCommands, rotated_images_that_are_mapped_are_what_their_file_says) {
    EXPECT_TRUE(run(LinkRotation{.turns = 4, .center = {0.0, 0.0}}));
    EXPECT_TRUE(run(Mirror{.angle = 30.0, .what = MapTarget::all, .pivot = core::Point(2, 1)}));
    const auto read = core::parse_document(core::format_document(document(editor_)));
    ASSERT_TRUE(read);
    EXPECT_TRUE(is_same_document(*read, document(editor_)));
}

TEST_F(SymmetryCommands, unlinking_leaves_ordinary_curves) {
    EXPECT_FALSE(run(Unlink{}));
    EXPECT_EQ(message(), "the curve is linked to no image");
    run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = false});
    EXPECT_FALSE(run(LinkRotation{.turns = 3, .center = {0.0, 0.0}}));
    EXPECT_EQ(message(), "the curve is an image already; unlink it first");
    EXPECT_TRUE(run(Unlink{}));
    for (const core::DocumentCurve& entry : document(editor_).curves) EXPECT_FALSE(entry.symmetry);
    EXPECT_TRUE(run(SetPoint{.index = 2, .position = {9.0, 9.0}}));
    EXPECT_EQ(points_of(1)[2], core::Point(-3, 1));
}

TEST_F(SymmetryCommands, copies_and_what_is_left_alone_are_ordinary) {
    run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = false});
    EXPECT_TRUE(run(DuplicateCurve{.index = 0, .shift = 1.0}));
    EXPECT_FALSE(document(editor_).curves[2].symmetry);
    EXPECT_TRUE(run(DeleteCurve{.index = 1}));
    EXPECT_FALSE(document(editor_).curves[0].symmetry);
}

// The axis of the rosette is the point (10, 10), a quarter turn apart; places 2 and 3 there are none of a mirror.
const char* rosette_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "half", "degree": 1, "knots": [0,0,1,1], "points": [[12,10],[13,11]],
    "symmetry": {"group": 0, "place": 0, "center": [10, 10], "turns": 4}, "locked": true },
  { "name": "b", "degree": 1, "knots": [0,0,1,1], "points": [[10,12],[9,13]],
    "symmetry": {"group": 0, "place": 1, "center": [10, 10], "turns": 4} },
  { "name": "c", "degree": 1, "knots": [0,0,1,1], "points": [[8,10],[7,9]],
    "symmetry": {"group": 0, "place": 2, "center": [10, 10], "turns": 4} } ] })";

TEST_F(SymmetryCommands, what_is_pasted_is_linked_to_nothing_that_was_there) {
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 7.0}, .angle = 90.0, .is_smooth = false}));
    const std::vector<core::Point> before(points_of(0).begin(), points_of(0).end());
    EXPECT_TRUE(run(PasteBeside{.text = rosette_text, .shift = 5.0}));
    ASSERT_EQ(document(editor_).curves.size(), 5U);
    EXPECT_EQ(std::vector(points_of(0).begin(), points_of(0).end()), before);
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_EQ(points_of(1)[i], core::Point(-before[i].x, before[i].y)) << i;
    EXPECT_EQ(points_of(2)[0], core::Point(17.0, 5.0));
    EXPECT_EQ(points_of(4)[1], core::Point(12.0, 4.0));
    // They are linked to each other around the center that went along, (15, 5).
    EXPECT_TRUE(run(SetPoint{.index = 1, .position = {11.0, 5.0}}));
    EXPECT_EQ(points_of(2)[1], core::Point(19.0, 5.0));
    EXPECT_EQ(points_of(3)[1], core::Point(15.0, 9.0));
    EXPECT_EQ(std::vector(points_of(0).begin(), points_of(0).end()), before);
}

TEST_F(SymmetryCommands, a_file_that_is_added_brings_its_own_links) {
    EXPECT_TRUE(run(LinkMirror{.center = {0.0, 7.0}, .angle = 90.0, .is_smooth = false}));
    const TemporaryFolder folder;
    EXPECT_TRUE(run(AddFile{.path = folder.write("rosette.json", rosette_text)})) << message();
    ASSERT_EQ(document(editor_).curves.size(), 5U);
    EXPECT_EQ(points_of(1)[0], core::Point(0.0, 2.0));
    EXPECT_EQ(document(editor_).curves[2].symmetry->group, 1U);
    EXPECT_EQ(document(editor_).curves[4].symmetry->place, 2U);
    EXPECT_EQ(points_of(4)[1], core::Point(7.0, 9.0));
    EXPECT_EQ(document(editor_).curves[2].name, "half 3");
}

TEST_F(SymmetryCommands, everything_moved_takes_the_mirror_along) {
    run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = false});
    EXPECT_TRUE(run(Move{.offset = {3.0, 1.0}, .what = MapTarget::all}));
    EXPECT_EQ(points_of(0)[2], core::Point(6, 2));
    EXPECT_EQ(points_of(1)[2], core::Point(0, 2));
    EXPECT_TRUE(run(Rotate{.angle = 90.0, .what = MapTarget::all, .pivot = core::Point(0.0, 0.0)}));
    EXPECT_LT(core::distance(points_of(0)[2], {-2, 6}), 1e-14);
    EXPECT_LT(core::distance(points_of(1)[2], {-2, 0}), 1e-14);
}

TEST_F(SymmetryCommands, a_locked_image_holds_the_curve) {
    run(LinkMirror{.center = {0.0, 0.0}, .angle = 90.0, .is_smooth = false});
    run(SetCurveLocked{.index = 1, .locked = true});
    EXPECT_FALSE(run(SetPoint{.index = 2, .position = {9.0, 9.0}}));
    EXPECT_EQ(message(), "'half 2' is locked, and it is an image of the curve; unlock it first");
}

TEST_F(SymmetryCommands, links_are_kept_in_the_file) {
    run(LinkMirror{.center = {0.5, 0.0}, .angle = 30.0, .is_smooth = false});
    const std::string text = core::format_document(document(editor_));
    const core::Document read = core::parse_document(text).value();
    EXPECT_TRUE(is_same_document(read, document(editor_)));
    EXPECT_EQ(read.curves[1].symmetry->angle, 30.0);
    EXPECT_EQ(core::format_document(read), text);
}

}  // namespace
}  // namespace batten::editor
