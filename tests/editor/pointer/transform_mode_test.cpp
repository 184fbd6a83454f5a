#include "app/editor/pointer/transform_mode.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/pin_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/commands/transform_commands.h"
#include "app/editor/pointer/cursor.h"
#include "app/editor/pointer/transform_box.h"
#include "app/editor/pointer/typed_place.h"
#include "app/editor/session.h"
#include "tests/editor/canvas_fixture.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using test::Indices;
using test::px;

// The box of the zigzag goes from (-4, -2) to (4, 2); its grips stand 12 pixels outside, those that turn 15 more.
const glm::dvec2 right_handle = px(4, 0) + glm::dvec2(12, 0);
const glm::dvec2 top_handle = px(0, 2) - glm::dvec2(0, 12);
const glm::dvec2 upper_right = px(4, 2) + glm::dvec2(12, -12);
const glm::dvec2 turning = px(4, 2) + glm::dvec2(27, -27);
const glm::dvec2 top_side = px(-2, 2) - glm::dvec2(0, 12);
const glm::dvec2 right_side = px(4, -1) + glm::dvec2(12, 0);

class Transforming : public test::CanvasFixture {
  protected:
    Transforming() { editor.run(SetTool{.tool = Tool::transform}); }

    void type(const std::u32string& text, glm::dvec2 at) {
        for (const char32_t character : text) {
            PointerEvent event{PointerAction::key, at, PointerButton::none, {}, false, 0.0};
            if (character == U'\n')
                event.key = Key::enter;
            else if (character == U'\t')
                event.key = Key::tab;
            else
                event.character = character;
            pointer.send(event);
        }
    }
    std::vector<core::Point> points() const {
        const auto found = test::committed(editor).control_points();
        return {found.begin(), found.end()};
    }
    void expect_points(const std::vector<core::Point>& expected) const { EXPECT_EQ(points(), expected); }
    void expect_unchanged() const {
        EXPECT_EQ(state().history.present().active_curve()->curve, first_curve);
        EXPECT_EQ(steps(), 0U);
        EXPECT_FALSE(state().preview);
    }
};

TEST_F(Transforming, a_side_scales_from_the_opposite_one) {
    pointer.drag(right_handle, right_handle + glm::dvec2(128, 0));
    expect_points({{-4, -2}, {-1.5, 2}, {1, -2}, {3.5, 2}, {6, -2}});
    EXPECT_EQ(steps(), 1U);
    pointer.drag(px(1, 2) - glm::dvec2(0, 12), px(1, 4) - glm::dvec2(0, 12));
    expect_points({{-4, -2}, {-1.5, 4}, {1, -2}, {3.5, 4}, {6, -2}});
}

TEST_F(Transforming, previews_and_commits_one_command_that_replays) {
    pointer.press(right_handle);
    pointer.move(right_handle + glm::dvec2(128, 0));
    EXPECT_EQ(state().active_curve()->control_points()[4], core::Point(6, -2));
    EXPECT_EQ(steps(), 0U);
    ASSERT_TRUE(state().placing.place);
    EXPECT_EQ(state().placing.place->reading, "125 % × 100 %");
    pointer.release(right_handle + glm::dvec2(128, 0));
    Editor other = test::zigzag_editor();
    other.run(Stretch{.along_x = 1.25, .along_y = 1.0, .what = MapTarget::curve, .pivot = core::Point(-4, 0)});
    EXPECT_EQ(test::committed(editor), test::committed(other));
}

TEST_F(Transforming, the_box_is_made_anew_only_where_what_is_selected_changes) {
    editor.run(SelectPoints{.points = {0, 1}});
    const auto kept = transform_box(state())->selected;
    EXPECT_EQ(kept->box.lower, core::Point(-4, -2));
    EXPECT_EQ(kept->box.upper, core::Point(-2, 2));
    EXPECT_EQ(transform_box(state())->selected, kept);
    editor.run(SetPoint{.index = 1, .position = {-1, 3}});
    EXPECT_EQ(transform_box(state())->selected->box.upper, core::Point(-1, 3));
    editor.run(SelectPoints{.points = {0, 2}});
    EXPECT_EQ(transform_box(state())->selected->box.upper, core::Point(0, -2));
    editor.run(Undo{});
    EXPECT_EQ(transform_box(state())->selected->parts, (SelectedParts{{0, {0, 2}}}));
}

TEST_F(Transforming, another_tool_has_no_grips_under_the_pointer) {
    pointer.move(right_handle);
    ASSERT_TRUE(std::holds_alternative<HoveredGrip>(state().hover));
    editor.run(SetTool{.tool = Tool::select});
    EXPECT_EQ(state().hover, Hover(HoveredNothing{}));
}

TEST_F(Transforming, the_pivot_stays_with_its_document) {
    pointer.drag(px(0, 0), px(1, 1));
    ASSERT_TRUE(transform_box(state())->has_own_pivot);
    editor.run(NewDocument{});
    editor.run(AnswerUnsaved{.answer = UnsavedAnswer::discard});
    ASSERT_EQ(state().active_curve(), nullptr);
    editor.run(SetTool{.tool = Tool::transform});
    EXPECT_FALSE(state().pivot);
}

TEST_F(Transforming, escape_brings_back_no_pivot_of_another_selection) {
    editor.run(SelectPoints{.points = {0, 1}});
    pointer.drag(px(-3, 0), px(1, 1));
    ASSERT_TRUE(transform_box(state())->has_own_pivot);
    editor.run(SelectPoints{.points = {1, 2}});
    ASSERT_FALSE(transform_box(state())->has_own_pivot);
    pointer.press(px(-1, 0));
    pointer.move(px(3, 1));
    pointer.escape(px(3, 1));
    EXPECT_FALSE(transform_box(state())->has_own_pivot);
    EXPECT_EQ(transform_box(state())->pivot, core::Point(-1, 0));
}

TEST_F(Transforming, a_corner_scales_both_and_with_shift_alike) {
    pointer.drag(upper_right, upper_right + glm::dvec2(128, -128));
    expect_points({{-4, -2}, {-1.5, 4}, {1, -2}, {3.5, 4}, {6, -2}});
    editor.run(Undo{});
    pointer.modifiers = test::shift;
    pointer.drag(upper_right, upper_right + glm::dvec2(128, -64));
    expect_points({{-4, -2}, {-1.5, 3}, {1, -2}, {3.5, 3}, {6, -2}});
}

TEST_F(Transforming, beyond_the_other_side_mirrors_and_nothing_is_flattened) {
    pointer.drag(right_handle, right_handle - glm::dvec2(16 * 64, 0));
    expect_points({{-4, -2}, {-6, 2}, {-8, -2}, {-10, 2}, {-12, -2}});
    editor.run(Undo{});
    pointer.press(right_handle);
    pointer.move(right_handle - glm::dvec2(64, 0));
    pointer.move(right_handle - glm::dvec2(8 * 64, 0));
    EXPECT_FALSE(state().preview);
    pointer.release(right_handle - glm::dvec2(8 * 64, 0));
    EXPECT_EQ(state().history.present().active_curve()->curve, first_curve);
}

TEST_F(Transforming, beyond_a_corner_turns_by_steps_with_ctrl) {
    // From (283, 155) seen from the middle, upward, by a quarter to (-155, 283).
    pointer.press(turning);
    pointer.modifiers = test::ctrl;
    pointer.move(px(0, 0) + glm::dvec2(-155, -283));
    EXPECT_EQ(state().placing.place->reading, "90°");
    pointer.release(px(0, 0) + glm::dvec2(-155, -283));
    expect_points({{2, -4}, {-2, -2}, {2, 0}, {-2, 2}, {2, 4}});
    EXPECT_EQ(steps(), 1U);
}

TEST_F(Transforming, turns_counterclockwise_by_what_is_typed) {
    pointer.press(turning);
    pointer.move(turning + glm::dvec2(10, 10));
    type(U"180\n", turning);
    expect_points({{4, 2}, {2, -2}, {0, 2}, {-2, -2}, {-4, 2}});
    EXPECT_EQ(steps(), 1U);
    EXPECT_TRUE(is_in<CanvasIdle>());
}

TEST_F(Transforming, a_side_drawn_along_itself_shears) {
    // The upper side goes 1 to the right of the lower one, which is 4 below.
    pointer.drag(top_side, top_side + glm::dvec2(64, 0));
    expect_points({{-4, -2}, {-1, 2}, {0, -2}, {3, 2}, {4, -2}});
    editor.run(Undo{});
    pointer.press(right_side);
    type(U"45\n", right_side);
    // Each place goes up by as much as it is to the right of the left side.
    expect_points({{-4, -2}, {-2, 4}, {0, 2}, {2, 8}, {4, 6}});
}

TEST_F(Transforming, takes_factors_and_percent) {
    pointer.press(right_handle);
    type(U"150%\n", right_handle);
    expect_points({{-4, -2}, {-1, 2}, {2, -2}, {5, 2}, {8, -2}});
    editor.run(Undo{});
    pointer.press(upper_right);
    type(U"2\t3\n", upper_right);
    expect_points({{-4, -2}, {0, 10}, {4, -2}, {8, 10}, {12, -2}});
    editor.run(Undo{});
    pointer.press(upper_right);
    type(U"1/2\n", upper_right);
    expect_points({{-4, -2}, {-3, 0}, {-2, -2}, {-1, 0}, {0, -2}});
    editor.run(Undo{});
    pointer.press(top_handle);
    type(U"2\n", top_handle);
    expect_points({{-4, -2}, {-2, 6}, {0, -2}, {2, 6}, {4, -2}});
}

TEST_F(Transforming, refuses_what_is_no_factor) {
    pointer.press(right_handle);
    type(U"0", right_handle);
    EXPECT_EQ(typed_problem(state().placing, {}, {}), "a factor of 0 would leave nothing");
    type(U"\n", right_handle);
    EXPECT_TRUE(state().message.is_error);
    pointer.escape(right_handle);
    pointer.escape(right_handle);
    expect_unchanged();
}

TEST_F(Transforming, moves_what_is_inside) {
    pointer.drag(px(-0.5, 0.5), px(1.5, 0.5));
    expect_points({{-2, -2}, {0, 2}, {2, -2}, {4, 2}, {6, -2}});
    EXPECT_EQ(steps(), 1U);
    pointer.press(px(1.5, 0.5));
    type(U"x-2\t1\n", px(1.5, 0.5));
    expect_points({{-4, -1}, {-2, 3}, {0, -1}, {2, 3}, {4, -1}});
}

TEST_F(Transforming, about_a_pivot_that_was_put_on_a_point) {
    pointer.drag(px(0, 0), px(-3.97, -1.98));
    ASSERT_TRUE(state().pivot);
    EXPECT_EQ(state().pivot->point, core::Point(-4, -2));
    EXPECT_EQ(steps(), 0U);
    pointer.press(turning);
    type(U"90\n", turning);
    expect_points({{-4, -2}, {-8, 0}, {-4, 2}, {-8, 4}, {-4, 6}});
    // It goes along with what is moved, and a click lets it go.
    pointer.drag(px(-6, 1), px(-5, 1));
    EXPECT_EQ(state().pivot->point, core::Point(-3, -2));
    pointer.click(px(-3, -2));
    EXPECT_FALSE(state().pivot);
}

TEST_F(Transforming, about_a_chosen_pivot_scales_to_both_sides) {
    pointer.click(px(0, 0));
    ASSERT_TRUE(state().pivot);
    pointer.drag(right_handle, right_handle + glm::dvec2(256, 0));
    expect_points({{-8, -2}, {-4, 2}, {0, -2}, {4, 2}, {8, -2}});
}

TEST_F(Transforming, the_pivot_stays_while_the_selection_does) {
    pointer.click(px(0, 0));
    EXPECT_TRUE(transform_box(state())->has_own_pivot);
    editor.run(SelectPoints{.points = {0, 1}});
    EXPECT_FALSE(transform_box(state())->has_own_pivot);
    EXPECT_EQ(transform_box(state())->pivot, core::Point(-3, 0));
}

TEST_F(Transforming, acts_on_selected_points) {
    editor.run(SelectPoints{.points = {1, 3}});  // a level line: nothing scales it upward
    const auto box = transform_box(state());
    ASSERT_TRUE(box);
    EXPECT_EQ(box->what, MapTarget::selection);
    EXPECT_TRUE(has_grip(*box, {GripKind::scale, 1, 0}));
    EXPECT_FALSE(has_grip(*box, {GripKind::scale, 1, 1}));
    EXPECT_FALSE(has_grip(*box, {GripKind::scale, 0, 1}));
    EXPECT_TRUE(has_grip(*box, {GripKind::shear, 1, 0}));
    EXPECT_FALSE(has_grip(*box, {GripKind::shear, 0, 1}));
    const glm::dvec2 handle = px(2, 2) + glm::dvec2(12, 0);
    pointer.drag(handle, handle + glm::dvec2(256, 0));
    expect_points({{-4, -2}, {-2, 2}, {0, -2}, {6, 2}, {4, -2}});
}

TEST_F(Transforming, a_single_point_can_only_be_moved) {
    editor.run(SelectPoints{.points = {2}});
    const auto box = transform_box(state());
    ASSERT_TRUE(box);
    EXPECT_TRUE(visible_grips(*box).empty());
    pointer.drag(px(0, -2) + glm::dvec2(10, 5), px(1, -2) + glm::dvec2(10, 5));
    EXPECT_EQ(points()[2], core::Point(1, -2));
    pointer.drag(px(1, -2), px(1, -3));
    EXPECT_EQ(points()[2], core::Point(1, -3));
    EXPECT_FALSE(state().pivot);
    EXPECT_EQ(selected(), Indices{2});
}

TEST_F(Transforming, a_move_that_is_refused_leaves_the_pivot) {
    editor.run(SelectPoints{.points = {1, 3}});
    editor.run(PinPoints{.points = {1, 3}});
    pointer.click(px(0, 2));
    ASSERT_TRUE(state().pivot);
    const std::size_t before = steps();
    pointer.drag(px(1, 2), px(1, 1));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_EQ(steps(), before);
    EXPECT_EQ(state().pivot->point, core::Point(0, 2));
}

TEST_F(Transforming, is_given_up_by_escape) {
    for (const glm::dvec2 grip : {right_handle, upper_right, turning, top_side, px(-0.5, 0.5)}) {
        pointer.press(grip);
        pointer.move(grip + glm::dvec2(40, 30));
        EXPECT_TRUE(state().preview);
        pointer.escape(grip);
        expect_unchanged();
    }
    pointer.press(px(0, 0));
    pointer.move(px(1, 1));
    pointer.escape(px(1, 1));
    EXPECT_FALSE(state().pivot);
}

TEST_F(Transforming, a_click_takes_a_point_and_shift_more) {
    pointer.click(px(-2, 2));
    EXPECT_EQ(selected(), (Indices{1}));
    editor.run(SelectPoints{.points = {1, 3}});
    pointer.modifiers = test::shift;
    pointer.click(px(0, -2));
    EXPECT_EQ(selected(), (Indices{1, 2, 3}));
    expect_unchanged();
}

TEST_F(Transforming, tells_what_the_grips_do) {
    const auto hint_at = [&](glm::dvec2 place) {
        pointer.move(place);
        return canvas_hint(pointer.mode(), state());
    };
    EXPECT_TRUE(hint_at(right_handle).starts_with("Drag to scale"));
    EXPECT_EQ(canvas_cursor(pointer.mode(), state(), false), Cursor::horizontal);
    EXPECT_TRUE(hint_at(top_handle).starts_with("Drag to scale"));
    EXPECT_EQ(canvas_cursor(pointer.mode(), state(), false), Cursor::vertical);
    EXPECT_TRUE(hint_at(turning).starts_with("Drag to turn"));
    EXPECT_TRUE(hint_at(top_side).starts_with("Drag along the side"));
    EXPECT_TRUE(hint_at(px(0, 0)).starts_with("Drag the pivot"));
    EXPECT_TRUE(hint_at(px(-0.5, 0.5)).starts_with("Drag to move"));
    EXPECT_TRUE(hint_at(px(9, 5)).starts_with("Drag the handles of the box"));
    editor.run(SelectPoints{.points = {2}});
    EXPECT_EQ(hint_at(px(9, 5)).find("handles"), std::string::npos) << "a single point has none";
}

TEST_F(Transforming, draws_finite_numbers_for_any_box) {
    for (const std::vector<core::Point>& points :
         {std::vector<core::Point>{{1, 1}, {1, 1}}, {{1e6, 1e6}, {1e6, 1e6 + 1}}, {{-1e300, 0}, {1e300, 1e-300}}}) {
        EditorState drawn = test::state_with({.degree = 1, .knots = {0, 0, 1, 1}, .points = points});
        drawn.tool = Tool::transform;
        drawn.view.camera.size_px = {1000.0, 600.0};
        EXPECT_TRUE(test::faults_of(test::canvas_picture(drawn), drawn.view.camera.size_px, 1e30).empty());
        static_cast<void>(hit_for_transform(drawn, {500.0, 300.0}));
    }
}

}  // namespace
}  // namespace batten::editor
