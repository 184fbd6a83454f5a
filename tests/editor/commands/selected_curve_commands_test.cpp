#include "app/editor/commands/selected_curve_commands.h"

#include <gtest/gtest.h>

#include "app/editor/command_spec.h"
#include "app/editor/commands/arranging_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/group_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/transform_commands.h"
#include "app/editor/state/selected_parts.h"
#include "core/edit/plane_map.h"
#include "core/make/fit_points.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using Indices = std::vector<std::size_t>;
using Points = std::vector<core::Point>;

// Two lines, a closed quadratic, and a locked line; all of whole numbers.
const char* four_curves = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "low", "degree": 1, "knots": [0,0,1,2,2], "points": [[0,0],[1,0],[2,0]] },
  { "name": "high", "degree": 1, "knots": [0,0,1,2,2], "points": [[0,4],[1,4],[2,4]] },
  { "name": "ring", "degree": 2, "knots": [0,1,2,3,4], "points": [[8,0],[10,0],[10,2],[8,2]], "periodic": true },
  { "name": "fixed", "degree": 1, "knots": [0,0,1,1], "points": [[0,0],[5,5]], "locked": true } ] })";

class SelectedCurveCommands : public ::testing::Test {
  protected:
    SelectedCurveCommands() { open_text(editor_, four_curves); }

    const EditorState& state() const { return editor_.state(); }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }
    const std::string& message() const { return state().message.text; }
    std::string selected() const { return text_of_parts(selected_parts(state())); }
    const core::DocumentCurve& entry(std::size_t i) const { return document(editor_).curves[i]; }
    Points points_of(std::size_t i) const {
        const auto all = entry(i).curve->control_points();
        return {all.begin(), all.end()};
    }
    std::vector<std::string> names() const {
        std::vector<std::string> all;
        for (const core::DocumentCurve& one : document(editor_).curves) all.push_back(one.name);
        return all;
    }
    bool select(const std::string& parts) { return run(SelectParts{.parts = parts}); }

    Editor editor_;
};

using Names = std::vector<std::string>;

TEST_F(SelectedCurveCommands, a_selection_over_curves_reads_back_as_it_is_written) {
    EXPECT_TRUE(select("2 1:2,0"));
    EXPECT_EQ(selected(), "1:0,2 2");
    EXPECT_TRUE(state().selection.points.empty());
    EXPECT_TRUE(select("0:0-2 2:3"));
    EXPECT_EQ(selected(), "0:0-2 2:3");
    EXPECT_EQ(state().selection.points, (Indices{0, 1, 2}));
    EXPECT_EQ(selected_curves(state()), (Indices{0, 2}));
    EXPECT_TRUE(select("0:0,1"));
    EXPECT_EQ(selected(), "0:0,1") << "two neighbors are shorter as they are";
    EXPECT_FALSE(state().selection.is_over_curves());
    EXPECT_TRUE(select("0 0:1"));
    EXPECT_EQ(selected(), "0");
    EXPECT_TRUE(state().selection.is_whole);
    EXPECT_TRUE(select(""));
    EXPECT_EQ(state().selection, Selection{});
    EXPECT_TRUE(type(R"(select-parts "1 0:1")")) << message();
    EXPECT_EQ(selected(), "0:1 1");
}

TEST_F(SelectedCurveCommands, what_cannot_be_selected_is_told) {
    EXPECT_FALSE(select("4"));
    EXPECT_EQ(message(), "there is no curve 4; the last one is 3");
    EXPECT_FALSE(select("0:1,3"));
    EXPECT_EQ(message(), "there is no control point 3 of 'low'; the last one is 2");
    for (const char* wrong : {"x", "0:", "0:2-1", "0:1;2", "0-1", "0:1,", "-1", "0:99999999999999999999999"}) {
        EXPECT_FALSE(select(wrong)) << wrong;
        EXPECT_EQ(message().rfind("found '", 0), 0U) << message();
    }
    EXPECT_FALSE(select("3"));
    EXPECT_EQ(message(), "curve 'fixed' is locked; unlock it in the inspector");
    run(SetCurveVisible{.index = 1, .visible = false});
    EXPECT_FALSE(select("1:0"));
    EXPECT_EQ(message(), "curve 'high' is hidden; show it in the inspector, or all with Ctrl+Shift+H");
    EXPECT_EQ(state().selection, Selection{});
}

TEST_F(SelectedCurveCommands, all_and_the_others) {
    EXPECT_TRUE(run(SelectAllCurves{}));
    EXPECT_EQ(selected(), "0 1 2") << "but the locked one";
    EXPECT_TRUE(run(InvertSelection{}));
    EXPECT_EQ(selected(), "");
    select("1");
    run(InvertSelection{});
    EXPECT_EQ(selected(), "0 2");
    select("0:1 2:0,3");
    run(InvertSelection{});
    EXPECT_EQ(selected(), "0:0,2 2:1,2");
    run(SelectNone{});
    run(InvertSelection{});
    EXPECT_EQ(selected(), "0:0-2");
    run(SelectNone{});
    run(SetCurveVisible{.index = 0, .visible = false});
    run(InvertSelection{});
    EXPECT_EQ(selected(), "") << "what is hidden is not selected";
    run(Undo{});
    select("0:1 2:0");
    run(SelectAll{});
    EXPECT_EQ(selected(), "0 2");
    EXPECT_FALSE(state().history.can_undo());
}

TEST_F(SelectedCurveCommands, move_points_of_several_curves_and_whole_ones_in_one_step) {
    select("0:2 1:0,1 2");
    EXPECT_TRUE(run(Move{.offset = {1, -2}, .what = MapTarget::selection}));
    EXPECT_EQ(points_of(0), (Points{{0, 0}, {1, 0}, {3, -2}}));
    EXPECT_EQ(points_of(1), (Points{{1, 2}, {2, 2}, {2, 4}}));
    EXPECT_EQ(points_of(2), (Points{{9, -2}, {11, -2}, {11, 0}, {9, 0}}));
    EXPECT_EQ(state().history.undo_label(), "Move 3 points of 2 curves and 'ring'");
    EXPECT_EQ(selected(), "0:2 1:0,1 2");
    run(Undo{});
    EXPECT_EQ(points_of(0), (Points{{0, 0}, {1, 0}, {2, 0}}));
    EXPECT_EQ(points_of(2)[0], core::Point(8, 0));
    EXPECT_FALSE(state().history.can_undo());
    EXPECT_EQ(selected(), "0:2 1:0,1 2") << "undo leaves the selection, whose points are the same";
}

TEST_F(SelectedCurveCommands, the_pivot_is_the_middle_of_all_that_is_selected) {
    select("1:1 2");
    // The box from (1, 0) to (10, 4) has the middle (5.5, 2).
    EXPECT_TRUE(type("rotate 180")) << message();
    EXPECT_EQ(points_of(0)[0], core::Point(0, 0));
    EXPECT_EQ(points_of(1), (Points{{0, 4}, {10, 0}, {2, 4}}));
    EXPECT_EQ(points_of(2), (Points{{3, 4}, {1, 4}, {1, 2}, {3, 2}}));
    EXPECT_EQ(message(),
              "Rotated P₁ of 'high' and 'ring' by 180° about (5.5, 2); the other control points stayed, so the curves "
              "have other shapes");
}

TEST_F(SelectedCurveCommands, keys_move_all_and_bursts_are_one_step) {
    select("1:2 2");
    EXPECT_TRUE(run(NudgeRight{.distance = 0.5, .continues = false}));
    EXPECT_TRUE(run(NudgeRight{.distance = 0.5, .continues = true}));
    EXPECT_EQ(points_of(1)[2], core::Point(3, 4));
    EXPECT_EQ(points_of(2)[0], core::Point(9, 0));
    EXPECT_EQ(state().history.undo_count(), 1U);
    select("2");
    EXPECT_TRUE(run(NudgeRight{.distance = 0.5, .continues = true}));
    EXPECT_EQ(state().history.undo_count(), 2U) << "another selection is another burst";
    EXPECT_EQ(message().rfind("Nudged 'ring' by (0.5, 0)", 0), 0U) << message();
}

TEST_F(SelectedCurveCommands, delete_takes_points_and_curves) {
    select("0 1:1 2:0");
    EXPECT_TRUE(run(Delete{}));
    EXPECT_EQ(names(), (Names{"high", "ring", "fixed"}));
    EXPECT_EQ(points_of(0), (Points{{0, 4}, {2, 4}}));
    EXPECT_EQ(points_of(1).size(), 3U);
    EXPECT_EQ(document(editor_).active, 0U);
    EXPECT_EQ(state().history.undo_label(), "Delete 2 points of 2 curves and 'low'");
    EXPECT_EQ(state().selection, Selection{});
    run(Undo{});
    EXPECT_EQ(names(), (Names{"low", "high", "ring", "fixed"}));
    run(ActivateCurve{.index = 2});
    select("0:0-2 1");
    EXPECT_TRUE(run(Delete{})) << "all points are the curve";
    EXPECT_EQ(names(), (Names{"ring", "fixed"}));
    EXPECT_EQ(document(editor_).active, 0U) << "the ring is still the active curve";
    EXPECT_FALSE(run(DeleteCurves{.curves = {0, 1}}));
    EXPECT_EQ(message(), "curve 'fixed' is locked; unlock it in the inspector");
    EXPECT_EQ(names().size(), 2U) << "nothing happens by half";
}

TEST_F(SelectedCurveCommands, cut_copy_and_duplicate_take_all_curves) {
    select("0:1 1");
    EXPECT_TRUE(run(Copy{}));
    EXPECT_EQ(message(), "Copied 2 curves");
    const std::string copied = state().clipboard;
    EXPECT_EQ(core::parse_document(copied)->curves.size(), 2U);
    EXPECT_TRUE(run(Duplicate{.shift = 1}));
    EXPECT_EQ(names(), (Names{"low", "high", "ring", "fixed", "low 2", "high 2"}));
    EXPECT_EQ(points_of(4)[0], core::Point(1, -1));
    EXPECT_EQ(selected(), "4 5") << "the copies, to be moved on";
    EXPECT_EQ(document(editor_).active, 5U);
    EXPECT_TRUE(run(Cut{}));
    EXPECT_EQ(names(), (Names{"low", "high", "ring", "fixed"}));
    EXPECT_EQ(state().history.undo_label(), "Cut 2 curves");
    run(Undo{});
    run(Undo{});
    EXPECT_FALSE(state().history.can_undo());
}

TEST_F(SelectedCurveCommands, hide_lock_and_color_together) {
    select("1:0 2");
    EXPECT_TRUE(type("color-curves #ff0000")) << message();
    EXPECT_FALSE(entry(0).color.has_value());
    EXPECT_EQ(entry(1).color, (core::DocumentColor{255, 0, 0}));
    EXPECT_EQ(entry(2).color, (core::DocumentColor{255, 0, 0}));
    EXPECT_EQ(state().history.undo_label(), "Set color of 2 curves");
    EXPECT_EQ(selected(), "1:0 2");
    EXPECT_TRUE(type("hide-curves"));
    EXPECT_FALSE(entry(1).visible);
    EXPECT_FALSE(entry(2).visible);
    EXPECT_EQ(selected(), "") << "what is hidden is not selected";
    EXPECT_TRUE(type("show-curves"));
    EXPECT_TRUE(entry(1).visible);
    EXPECT_TRUE(entry(2).visible);
    EXPECT_FALSE(type("show-curves"));
    EXPECT_EQ(message(), "no curve is hidden");
    select("0 1:1");
    EXPECT_TRUE(type("lock-curves"));
    EXPECT_TRUE(entry(0).locked);
    EXPECT_TRUE(entry(1).locked);
    EXPECT_EQ(selected(), "");
    EXPECT_TRUE(type("unlock-curves"));
    EXPECT_FALSE(entry(0).locked);
    EXPECT_FALSE(entry(3).locked) << "all that are locked";
    EXPECT_TRUE(type("hide-curves"));
    EXPECT_FALSE(entry(0).visible) << "the active one where nothing is selected";
    EXPECT_EQ(state().history.undo_label(), "Hide 'low'");
    for (int k = 0; k < 6; ++k) run(Undo{});
    EXPECT_FALSE(state().history.can_undo());
    EXPECT_FALSE(entry(1).color.has_value());
}

TEST_F(SelectedCurveCommands, a_locked_curve_that_is_selected_as_active_refuses_all) {
    select("0:1 1");
    run(LockCurves{.curves = {1}});
    EXPECT_EQ(selected(), "0:1");
    run(ActivateCurve{.index = 3});
    run(SelectPoints{.points = {1}});
    EXPECT_FALSE(run(Move{.offset = {1, 0}, .what = MapTarget::selection}));
    EXPECT_EQ(message(), "curve 'fixed' is locked; unlock it in the inspector");
}

TEST_F(SelectedCurveCommands, what_is_named_twice_counts_once) {
    EXPECT_TRUE(type("delete-curves 1,1,0"));
    EXPECT_EQ(message(), "Deleted 2 curves");
    EXPECT_EQ(names(), (Names{"ring", "fixed"}));
}

TEST_F(SelectedCurveCommands, moving_a_curve_in_the_list_keeps_where_it_is_held) {
    ASSERT_TRUE(run(ShowHandlebar{.u = 1.25}));
    EXPECT_TRUE(run(MoveCurve{.from = 0, .to = 2}));
    EXPECT_EQ(document(editor_).active, 2U);
    EXPECT_EQ(state().selection.handlebar, std::optional(1.25));
}

TEST_F(SelectedCurveCommands, what_is_selected_of_a_hidden_curve_stays_as_it_is) {
    const std::string sentence = "curve 'low' is hidden; show it in the inspector, or all with Ctrl+Shift+H";
    run(SetCurveVisible{.index = 0, .visible = false});
    ASSERT_TRUE(run(SelectAll{})) << "logs that do so go on";
    EXPECT_EQ(selected(), "0:0-2");
    for (const Command& command :
         {Command(Delete{}), Command(Nudge{.offset = {1, 0}}), Command(NudgeUpFar{.distance = 1.0, .continues = false}),
          Command(Rotate{.angle = 90.0, .what = MapTarget::selection}),
          Command(Align{.at = Alignment::left, .what = Arranged::points})}) {
        EXPECT_FALSE(run(command)) << command.spec().name;
        EXPECT_EQ(message(), sentence) << command.spec().name;
    }
    EXPECT_EQ(points_of(0), (Points{{0, 0}, {1, 0}, {2, 0}}));
    EXPECT_TRUE(run(MovePoints{.points = {1}, .offset = {0, 1}})) << "which says itself what it is about";
    EXPECT_EQ(points_of(0)[1], core::Point(1, 1));
    EXPECT_TRUE(run(ShowCurves{.curves = {0}}));
    EXPECT_TRUE(run(Nudge{.offset = {1, 0}}));
    EXPECT_EQ(points_of(0)[0], core::Point(1, 0));
}

TEST_F(SelectedCurveCommands, pinned_points_stay_unless_the_curve_goes_as_a_whole) {
    run(ActivateCurve{.index = 1});
    EXPECT_TRUE(type("pin-points 0")) << message();
    select("0:0 1:0,2");
    run(Move{.offset = {0, 1}, .what = MapTarget::selection});
    EXPECT_EQ(points_of(0)[0], core::Point(0, 1));
    EXPECT_EQ(points_of(1), (Points{{0, 4}, {1, 4}, {2, 5}}));
    select("1:0");
    EXPECT_FALSE(run(Move{.offset = {0, 1}, .what = MapTarget::selection}));
    EXPECT_EQ(message(), "P₀ is pinned; unpin it first");
    select("1");
    EXPECT_TRUE(run(Move{.offset = {0, 1}, .what = MapTarget::selection}));
    EXPECT_EQ(points_of(1), (Points{{0, 5}, {1, 5}, {2, 6}}));
}

TEST_F(SelectedCurveCommands, whole_curves_take_their_fit_points_along) {
    EXPECT_TRUE(type("new-curve 0,0,1,1,2,0"));
    EXPECT_TRUE(type("through-points 20,0,21,1,22,0,23,1")) << message();
    const std::size_t last = document(editor_).curves.size() - 1;
    ASSERT_NE(entry(last).fit, nullptr);
    select("0 " + std::to_string(last));
    EXPECT_TRUE(run(Move{.offset = {0.5, 1}, .what = MapTarget::selection}));
    ASSERT_NE(entry(last).fit, nullptr);
    EXPECT_EQ(entry(last).fit->points[1].place, core::Point(21.5, 2));
    EXPECT_EQ(points_of(0)[1], core::Point(1.5, 1));
}

TEST_F(SelectedCurveCommands, a_symmetry_goes_along_where_all_of_it_is_selected) {
    EXPECT_TRUE(type("link-mirror 20 0 90 no")) << message();
    ASSERT_EQ(document(editor_).curves.size(), 5U);
    EXPECT_EQ(points_of(4), (Points{{40, 0}, {39, 0}, {38, 0}}));
    select("0 1");
    EXPECT_TRUE(run(Move{.offset = {1, 0}, .what = MapTarget::selection}));
    EXPECT_EQ(points_of(0), (Points{{1, 0}, {2, 0}, {3, 0}}));
    EXPECT_EQ(points_of(4), (Points{{39, 0}, {38, 0}, {37, 0}})) << "the image of the curve, in the same line";
    EXPECT_EQ(points_of(1)[0], core::Point(1, 4));
    select("0 4");
    EXPECT_TRUE(run(Move{.offset = {1, 2}, .what = MapTarget::selection}));
    EXPECT_EQ(points_of(0), (Points{{2, 2}, {3, 2}, {4, 2}}));
    EXPECT_EQ(points_of(4), (Points{{40, 2}, {39, 2}, {38, 2}})) << "the line went along";
    EXPECT_EQ(entry(4).symmetry->center.x, 21.0);
    select("0:0 4:0");
    EXPECT_TRUE(run(Move{.offset = {0, 1}, .what = MapTarget::selection}));
    EXPECT_EQ(points_of(0)[0].y, points_of(4)[0].y) << "images still";
}

TEST_F(SelectedCurveCommands, points_and_curves_are_put_in_line_and_at_even_distances) {
    select("0:1 1:0 2");
    // What is seen of the ring, a closed quadratic over a square, goes from (8, 0) to (10, 2).
    EXPECT_TRUE(type("align top points")) << message();
    EXPECT_EQ(points_of(0), (Points{{0, 0}, {1, 4}, {2, 0}}));
    EXPECT_EQ(points_of(1)[0], core::Point(0, 4));
    EXPECT_EQ(points_of(2), (Points{{8, 2}, {10, 2}, {10, 4}, {8, 4}}));
    run(Undo{});
    select("1:0,1,2 2");
    // The middles are at 0, 1, 2 and 9.
    EXPECT_TRUE(type("distribute horizontal points")) << message();
    EXPECT_EQ(points_of(1), (Points{{0, 4}, {3, 4}, {6, 4}}));
    EXPECT_EQ(points_of(2)[0], core::Point(8, 0));
}

TEST_F(SelectedCurveCommands, groups_have_names) {
    select("0:1 2");
    EXPECT_TRUE(type("group")) << message();
    EXPECT_EQ(entry(0).group, "group");
    EXPECT_EQ(entry(1).group, "");
    EXPECT_EQ(entry(2).group, "group");
    EXPECT_EQ(curves_of_group(document(editor_), "group"), (Indices{0, 2}));
    EXPECT_EQ(with_groups(document(editor_), {2}), (Indices{0, 2}));
    EXPECT_EQ(with_groups(document(editor_), {1}), (Indices{1}));
    EXPECT_TRUE(type(R"(group "hull lines" 1,3)"));
    EXPECT_EQ(entry(3).group, "hull lines");
    EXPECT_EQ(state().history.undo_label(), "Group 'hull lines'");
    EXPECT_FALSE(type(R"(rename-group group "hull lines")"));
    EXPECT_EQ(message(), "there is a group 'hull lines' already; names must differ");
    EXPECT_FALSE(type("rename-group nothing it"));
    EXPECT_EQ(message(), "there is no group 'nothing'");
    EXPECT_TRUE(type("rename-group group keel"));
    EXPECT_EQ(entry(2).group, "keel");
    select("2");
    EXPECT_TRUE(type("ungroup"));
    EXPECT_EQ(entry(0).group, "") << "all of the group";
    EXPECT_EQ(entry(2).group, "");
    EXPECT_EQ(entry(3).group, "hull lines");
    EXPECT_TRUE(run(GroupCurves{.name = "group", .curves = {0}}));
    select("1 2");
    EXPECT_TRUE(type("group"));
    EXPECT_EQ(entry(2).group, "group 2") << "the first name that is free";
    EXPECT_FALSE(run(GroupCurves{.name = "", .curves = {0}}));
    EXPECT_EQ(message(), "a group needs a name; the one given is empty");
    while (state().history.can_undo()) run(Undo{});
    EXPECT_EQ(entry(3).group, "");
}

TEST_F(SelectedCurveCommands, a_curve_gets_another_place_in_the_list) {
    run(ActivateCurve{.index = 1});
    select("1:2 2");
    EXPECT_TRUE(type("move-curve 0 2")) << message();
    EXPECT_EQ(names(), (Names{"high", "ring", "low", "fixed"}));
    EXPECT_EQ(document(editor_).active, 0U);
    EXPECT_EQ(selected(), "0:2 1") << "the same points and curves";
    EXPECT_EQ(message(), "Moved 'low' in the list");
    EXPECT_TRUE(run(MoveCurve{.from = 3, .to = 0, .group = "g"}));
    EXPECT_EQ(names(), (Names{"fixed", "high", "ring", "low"}));
    EXPECT_EQ(entry(0).group, "g");
    EXPECT_EQ(selected(), "1:2 2");
    run(Undo{});
    EXPECT_EQ(names(), (Names{"high", "ring", "low", "fixed"}));
    EXPECT_EQ(entry(3).group, "");
    for (const SelectedPart& part : selected_parts(state()))
        EXPECT_TRUE(can_be_selected(entry(part.curve))) << part.curve;
    run(Undo{});
    EXPECT_EQ(names(), (Names{"low", "high", "ring", "fixed"}));
    EXPECT_EQ(document(editor_).active, 1U);
    EXPECT_FALSE(type("move-curve 0 4"));
    EXPECT_EQ(message(), "there is no curve 4; the last one is 3");
}

TEST_F(SelectedCurveCommands, a_group_gets_another_place_in_the_list_as_one) {
    run(GroupCurves{.name = "g", .curves = {0, 2}});
    run(ActivateCurve{.index = 1});
    select("0 1:2");
    const std::size_t before = state().history.undo_count();
    EXPECT_TRUE(type("move-group g")) << message();
    EXPECT_EQ(names(), (Names{"high", "fixed", "low", "ring"}));
    EXPECT_EQ(message(), "Moved the group 'g' in the list");
    EXPECT_EQ(document(editor_).active, 0U);
    EXPECT_EQ(selected(), "0:2 2") << "the same points and curves";
    EXPECT_EQ(state().history.undo_count(), before + 1);
    EXPECT_TRUE(type("move-group g 1")) << message();
    EXPECT_EQ(names(), (Names{"high", "low", "ring", "fixed"}));
    EXPECT_TRUE(run(MoveGroup{.group = "g", .before = 0}));
    EXPECT_EQ(names(), (Names{"low", "ring", "high", "fixed"}));
    run(Undo{});
    run(Undo{});
    run(Undo{});
    EXPECT_EQ(names(), (Names{"low", "high", "ring", "fixed"}));
    EXPECT_EQ(document(editor_).active, 1U);
    // Before one of its own: they come together there.
    EXPECT_TRUE(run(MoveGroup{.group = "g", .before = 2}));
    EXPECT_EQ(names(), (Names{"high", "low", "ring", "fixed"}));
    EXPECT_FALSE(type("move-group h 0"));
    EXPECT_EQ(message(), "there is no group 'h'");
    EXPECT_FALSE(type("move-group g 4"));
    EXPECT_EQ(message(), "there is no curve 4; the last one is 3");
}

TEST_F(SelectedCurveCommands, a_selection_follows_its_curves_or_is_dropped) {
    select("1:2 2");
    run(RenameCurve{.index = 2, .name = "hoop"});
    EXPECT_EQ(selected(), "1:2 2");
    run(DuplicateCurve{.index = 0, .shift = 1});
    EXPECT_EQ(selected(), "") << "another curve is active";
    run(ActivateCurve{.index = 0});
    select("0:0 2:3");
    run(ActivateCurve{.index = 2});
    EXPECT_EQ(selected(), "") << "a curve that is made active begins with nothing selected";
}

}  // namespace
}  // namespace batten::editor
