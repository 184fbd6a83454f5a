#include "app/editor/pointer/plot_mode.h"

#include <gtest/gtest.h>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/view_commands.h"
#include "core/measure/deviation.h"
#include "tests/editor/pointer_driver.h"

namespace batten::editor {
namespace {

using test::committed;
using test::stored_knots;
using Knots = std::vector<double>;

/// The cubic example with u = 0.4 in a dock of 1000 x 260: u runs from x = 32 to 968, so that a hundredth is 9.36 px,
/// and the strip is at y = 206.
class PlotModes : public testing::Test {
  protected:
    static constexpr double strip = 206.0;
    static glm::dvec2 at(double u, double y = strip) { return {32.0 + 936.0 * u, y}; }

    static Editor cubic_editor(const Knots& interior) {
        Editor editor;
        editor.run(NewCurve{.points = test::cubic().points});
        Knots knots{0, 0, 0, 0};
        knots.insert(knots.end(), interior.begin(), interior.end());
        knots.insert(knots.end(), 4, 1.0);
        editor.run(SetKnots{.knots = knots});
        editor.run(SetParameter{.u = 0.4});
        editor.run(SetKnotMove{.mode = core::KnotMove::stop});
        return editor;
    }

    void use(const Knots& interior) {
        editor = cubic_editor(interior);
        first_steps = state().history.undo_count();
    }
    const EditorState& state() const { return editor.state(); }
    std::size_t steps() const { return state().history.undo_count() - first_steps; }
    Knots interior() const {
        const Knots knots = stored_knots(committed(editor));
        return {knots.begin() + 4, knots.end() - 4};
    }

    Editor editor = cubic_editor({0.25, 0.5, 0.75});
    std::size_t first_steps = editor.state().history.undo_count();
    test::PlotPointer pointer{editor, test::PlotStep{}};
};

TEST_F(PlotModes, drag_moves_a_knot_by_as_much_as_the_pointer) {
    pointer.drag(at(0.25) + glm::dvec2(4, 0), at(0.35) + glm::dvec2(4, 0));
    EXPECT_NEAR(interior()[0], 0.35, 1e-15);
    EXPECT_EQ(interior()[1], 0.5);
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(state().history.undo_label(), "Move knot 0.25 to 0.35");
    EXPECT_EQ(state().selection.knot, std::optional<std::size_t>(4));
}

TEST_F(PlotModes, drag_previews_and_escape_restores_the_very_document) {
    const std::shared_ptr<const core::Curve> before = state().history.present().active_curve()->curve;
    pointer.press(at(0.25));
    pointer.move(at(0.35));
    EXPECT_NEAR(state().active_curve()->knots()[4], 0.35, 1e-15);
    EXPECT_EQ(state().history.present().active_curve()->curve, before);
    pointer.escape(at(0.35));
    pointer.release(at(0.35));
    EXPECT_EQ(state().shown().active_curve()->curve, before);
    EXPECT_EQ(steps(), 0U);
}

TEST_F(PlotModes, click_selects_a_knot_without_a_step) {
    pointer.drag(at(0.5), at(0.5) + glm::dvec2(2, 0));
    EXPECT_EQ(state().selection.knot, std::optional<std::size_t>(5));
    EXPECT_EQ(steps(), 0U);
}

TEST_F(PlotModes, stop_ends_before_the_neighbor) {
    pointer.drag(at(0.25), at(0.6));
    EXPECT_EQ(interior(), (Knots{0.495, 0.5, 0.75}));
    pointer.modifiers = test::ctrl;
    pointer.drag(at(0.75), at(0.5));
    EXPECT_EQ(interior(), (Knots{0.495, 0.5, 0.505})) << "also where Ctrl keeps to round numbers";
}

TEST_F(PlotModes, stop_does_not_snap_from_afar) {
    pointer.drag(at(0.25), at(0.495));
    EXPECT_NEAR(interior()[0], 0.495, 1e-15);
}

TEST_F(PlotModes, push_takes_the_neighbor_along) {
    editor.run(SetKnotMove{.mode = core::KnotMove::push});
    pointer.drag(at(0.25), at(0.6));
    EXPECT_NEAR(interior()[0], 0.6, 1e-15);
    EXPECT_GE(interior()[1], 0.6);
    EXPECT_LT(interior()[1], 0.7);
    EXPECT_EQ(interior()[2], 0.75);
    EXPECT_EQ(steps(), 1U);
}

TEST_F(PlotModes, snap_jumps_onto_a_knot_within_eight_pixels) {
    editor.run(SetKnotMove{.mode = core::KnotMove::snap});
    pointer.drag(at(0.25), at(0.5) - glm::dvec2(7, 0));
    EXPECT_EQ(interior(), (Knots{0.5, 0.5, 0.75}));
}

TEST_F(PlotModes, snap_leaves_a_knot_where_it_is_farther_away) {
    editor.run(SetKnotMove{.mode = core::KnotMove::snap});
    pointer.drag(at(0.25), at(0.5) - glm::dvec2(9.36, 0));
    EXPECT_NEAR(interior()[0], 0.49, 1e-15);
}

TEST_F(PlotModes, snap_reaches_as_far_on_the_screen_when_zoomed) {
    editor.change(SetPlotRange{{0.4, 0.6}});
    use({0.45, 0.5, 0.75});
    editor.change(SetPlotRange{{0.4, 0.6}});
    editor.run(SetKnotMove{.mode = core::KnotMove::snap});
    const auto zoomed = [](double u) { return glm::dvec2(32.0 + 936.0 * (u - 0.4) / 0.2, strip); };
    pointer.drag(zoomed(0.45), zoomed(0.497));
    EXPECT_NEAR(interior()[0], 0.497, 1e-15);
    pointer.drag(zoomed(0.497), zoomed(0.4985));
    EXPECT_EQ(interior()[0], 0.5);
}

TEST_F(PlotModes, one_knot_is_pulled_out_of_a_stack_to_either_side) {
    use({0.5, 0.5, 0.75});
    pointer.drag(at(0.5), at(0.4));
    EXPECT_NEAR(interior()[0], 0.4, 1e-15);
    EXPECT_EQ(interior()[1], 0.5);
    EXPECT_EQ(committed(editor).knots().multiplicity(0.5), 1);
    use({0.5, 0.5, 0.75});
    pointer.drag(at(0.5), at(0.6));
    EXPECT_EQ(interior()[0], 0.5);
    EXPECT_NEAR(interior()[1], 0.6, 1e-15);
}

TEST_F(PlotModes, the_knot_that_moves_is_the_hovered_one) {
    use({0.5, 0.5, 0.75});
    pointer.move(at(0.5));
    EXPECT_EQ(state().hover, Hover{HoveredKnot{5}});
    pointer.press(at(0.5));
    pointer.move(at(0.4));
    pointer.move(at(0.4) - glm::dvec2(1, 0));
    EXPECT_EQ(state().hover, Hover{HoveredKnot{4}});
    EXPECT_NE(plot_hint(pointer.mode(), state()).find("0.398932 (C²)"), std::string::npos);
}

TEST_F(PlotModes, ctrl_keeps_a_knot_to_round_numbers) {
    // 936 px a unit: major lines 0.1 apart, minor ones 0.02.
    pointer.modifiers = test::ctrl;
    pointer.drag(at(0.25), at(0.347));
    EXPECT_EQ(interior()[0], 0.34);
}

TEST_F(PlotModes, ctrl_keeps_the_parameter_to_knots_and_round_numbers) {
    // A knot is caught within 8 px, which is 0.0085 here; minor lines are 0.02 apart.
    pointer.modifiers = test::ctrl;
    pointer.press(at(0.4, 20.0));
    for (const auto& [to, u] :
         {std::pair(0.2585, 0.25), {0.2415, 0.25}, {0.2595, 0.26}, {0.3333, 0.34}, {0.2405, 0.24}}) {
        pointer.move(at(to, 20.0));
        EXPECT_EQ(state().parameter(), u) << to;
    }
    pointer.move(at(-0.3, 20.0));
    EXPECT_EQ(state().parameter(), 0.0);
    pointer.move(at(1.2, 20.0));
    EXPECT_EQ(state().parameter(), 1.0);
    pointer.modifiers = {};
    pointer.move(at(0.2585, 20.0));
    EXPECT_NEAR(state().parameter(), 0.2585, 1e-12);
    pointer.release(at(0.2585, 20.0));
}

TEST_F(PlotModes, double_click_on_a_knot_raises_it_and_keeps_the_shape) {
    const core::Curve before = committed(editor);
    pointer.double_click(at(0.5));
    EXPECT_EQ(interior(), (Knots{0.25, 0.5, 0.5, 0.75}));
    EXPECT_LT(core::largest_deviation(before, committed(editor)), 1e-14);
    EXPECT_EQ(steps(), 1U);
}

TEST_F(PlotModes, double_click_on_the_strip_inserts_a_knot_there) {
    pointer.double_click(at(0.375));
    EXPECT_EQ(interior(), (Knots{0.25, 0.375, 0.5, 0.75}));
    EXPECT_EQ(steps(), 1U);
}

TEST_F(PlotModes, a_second_press_at_once_still_drags) {
    pointer.press(at(0.375));
    pointer.release(at(0.375));
    pointer.send(PointerAction::double_click, at(0.375));
    pointer.move(at(0.625));
    EXPECT_NEAR(state().parameter(), 0.625, 1e-15);
    pointer.release(at(0.625));
    EXPECT_EQ(steps(), 0U);
    pointer.press(at(0.5));
    pointer.release(at(0.5));
    pointer.send(PointerAction::double_click, at(0.5));
    pointer.move(at(0.625));
    pointer.release(at(0.625));
    EXPECT_EQ(interior(), (Knots{0.25, 0.625, 0.75}));
    EXPECT_EQ(steps(), 1U);
}

TEST_F(PlotModes, press_sets_the_parameter_and_drags_it_within_the_domain) {
    pointer.press(at(0.625, 20.0));
    EXPECT_NEAR(state().parameter(), 0.625, 1e-15);
    pointer.move({2000.0, 20.0});
    EXPECT_EQ(state().parameter(), 1.0);
    pointer.release({2000.0, 20.0});
    EXPECT_EQ(steps(), 0U);
}

TEST_F(PlotModes, escape_puts_the_dragged_parameter_back) {
    pointer.press(at(0.4, 100.0));
    pointer.move(at(0.9, 100.0));
    pointer.escape(at(0.9, 100.0));
    EXPECT_EQ(state().parameter(), 0.4);
}

TEST_F(PlotModes, the_wheel_zooms_about_the_pointer_and_back_to_everything) {
    pointer.send(PointerAction::wheel, at(0.25), 1.0);
    ASSERT_TRUE(state().view.plot_range);
    EXPECT_NEAR(state().view.plot_range->lower, 0.25 - 0.25 / 1.15, 1e-15);
    EXPECT_NEAR(state().view.plot_range->upper, 0.25 + 0.75 / 1.15, 1e-15);
    pointer.send(PointerAction::wheel, at(0.25), -2.0);
    EXPECT_FALSE(state().view.plot_range);
}

TEST_F(PlotModes, zooming_stops_where_doubles_end) {
    for (int i = 0; i < 600; ++i) pointer.send(PointerAction::wheel, at(0.3), 1.0);
    ASSERT_TRUE(state().view.plot_range);
    EXPECT_GT(state().view.plot_range->length(), 1e-14);
    EXPECT_LT(state().view.plot_range->length(), 1e-12);
}

TEST_F(PlotModes, middle_and_space_drag_pan_within_the_knots) {
    editor.change(SetPlotRange{{0.2, 0.7}});
    pointer.button = PointerButton::middle;
    pointer.drag({500, 100}, {500 - 93.6, 100});
    EXPECT_NEAR(state().view.plot_range->lower, 0.25, 1e-12);
    EXPECT_NEAR(state().view.plot_range->upper, 0.75, 1e-12);
    pointer.button = PointerButton::left;
    pointer.space = true;
    pointer.drag({100, 100}, {900, 100});
    EXPECT_NEAR(state().view.plot_range->lower, 0.0, 1e-12);
    EXPECT_NEAR(state().view.plot_range->upper, 0.5, 1e-12);
    EXPECT_EQ(state().parameter(), 0.4);
}

TEST_F(PlotModes, a_sideways_wheel_pans_within_the_knots) {
    editor.change(SetPlotRange{{0.2, 0.7}});
    pointer.turn_sideways({500, 100}, -1.0);
    // 936 px are half a unit: 60 px to the left.
    EXPECT_NEAR(state().view.plot_range->lower, 0.2 + 30.0 / 936.0, 1e-12);
    EXPECT_NEAR(state().view.plot_range->upper, 0.7 + 30.0 / 936.0, 1e-12);
    pointer.modifiers.shift = true;
    pointer.send(PointerAction::wheel, {500, 100}, 100.0);
    EXPECT_NEAR(state().view.plot_range->lower, 0.0, 1e-12);
    EXPECT_NEAR(state().view.plot_range->upper, 0.5, 1e-12);
}

TEST_F(PlotModes, hover_tells_graphs_knots_and_spans_apart) {
    pointer.move(at(0.5, 80.0));
    EXPECT_EQ(state().hover, Hover{HoveredBasis{3}});
    pointer.move(at(0.5));
    EXPECT_EQ(state().hover, Hover{HoveredKnot{5}});
    pointer.move(at(0.6));
    EXPECT_EQ(state().hover, Hover{HoveredSpan{5}});
    pointer.move(at(0.6) + glm::dvec2(3, 0));
    EXPECT_FALSE(pointer.was_asked());
    pointer.move(at(0.4, 100.0));
    EXPECT_EQ(state().hover, Hover{HoveredParameter{}});
    pointer.send(PointerAction::leave, {});
    EXPECT_EQ(state().hover, Hover{HoveredNothing{}});
}

TEST_F(PlotModes, the_last_knot_of_an_unclamped_curve_follows_the_pointer_without_running_away) {
    editor.run(SetKind{.kind = core::KnotKind::uniform});
    const Knots before = stored_knots(committed(editor));
    const double length = before.back() - before.front();
    pointer.press({968, strip});
    for (const double x : {978.0, 988.0, 998.0}) pointer.move({x, strip});
    pointer.release({998, strip});
    EXPECT_NEAR(stored_knots(committed(editor)).back(), before.back() + length * 30.0 / 936.0, 1e-12);
}

TEST_F(PlotModes, a_locked_curve_keeps_its_knots) {
    editor.run(SetCurveLocked{.index = 0, .locked = true});
    pointer.drag(at(0.25), at(0.35));
    EXPECT_EQ(interior(), (Knots{0.25, 0.5, 0.75}));
    EXPECT_EQ(state().selection.knot, std::optional<std::size_t>(4));
}

TEST_F(PlotModes, a_hidden_curve_keeps_its_knots) {
    editor.run(SetCurveVisible{.index = 0, .visible = false});
    const std::size_t steps = state().history.undo_count();
    pointer.drag(at(0.25), at(0.35));
    for (const double u : {0.25, 0.6}) {
        pointer.double_click(at(u));
        EXPECT_NE(state().message.text.find("is hidden; show it"), std::string::npos) << state().message.text;
    }
    EXPECT_EQ(interior(), (Knots{0.25, 0.5, 0.75}));
    EXPECT_EQ(state().history.undo_count(), steps);
}

TEST_F(PlotModes, without_a_curve_nothing_breaks) {
    editor = Editor();
    pointer.drag(at(0.25), at(0.35));
    pointer.double_click(at(0.25));
    pointer.send(PointerAction::wheel, at(0.25), 1.0);
    EXPECT_EQ(state().history.undo_count(), 0U);
    EXPECT_EQ(plot_hint(pointer.mode(), state()), "");
}

TEST_F(PlotModes, hints_tell_the_knot_and_its_continuity) {
    use({0.25, 0.5, 0.5});
    pointer.move(at(0.5));
    EXPECT_EQ(plot_hint(pointer.mode(), state()),
              "Drag the knot 0.5 (×2, C¹) to move it; it stops before its neighbors · double-click to raise its "
              "multiplicity (keeps the shape)");
    pointer.move(at(0.3));
    EXPECT_EQ(plot_hint(pointer.mode(), state()),
              "Double-click to insert a knot between 0.25 and 0.5 (keeps the shape) · press to set u here");
}

TEST(PlotModesScaled, behave_alike_at_twice_the_interface_scale) {
    Editor editor = test::zigzag_editor();
    editor.change(SetInterfaceScale{2.0});
    editor.run(SetKnotMove{.mode = core::KnotMove::snap});
    test::PlotPointer pointer{editor, test::PlotStep{{2000.0, 520.0}}};
    // u = 0..3 runs from x = 64 to 1936, the strip is at y = 412; 16 px are the reach of snapping.
    const auto at = [](double u) { return glm::dvec2(64.0 + 624.0 * u, 412.0); };
    pointer.drag(at(1.0) + glm::dvec2(14, 0), at(1.0) + glm::dvec2(19, 0));
    EXPECT_EQ(test::stored_knots(committed(editor))[3], 1.0);
    pointer.drag(at(1.0) + glm::dvec2(14, 0), at(2.0) - glm::dvec2(1, 0));
    EXPECT_EQ(test::stored_knots(committed(editor))[3], 2.0);
}

}  // namespace
}  // namespace batten::editor
