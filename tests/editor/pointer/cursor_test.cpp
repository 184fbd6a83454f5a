#include "app/editor/pointer/cursor.h"

#include <gtest/gtest.h>

#include "app/editor/commands/tool_commands.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

using test::px;

class Cursors : public test::CanvasFixture {
  protected:
    Cursor shown(bool space_is_held = false) const { return canvas_cursor(pointer.mode(), state(), space_is_held); }
    Cursor over(glm::dvec2 place) {
        pointer.move(place);
        return shown();
    }
};

// The points of the zigzag are (-4,-2) (-2,2) (0,-2) (2,2) (4,-2); C(1.5) = (0,-1), C(1) = (-1,0).
TEST_F(Cursors, of_the_select_tool_say_what_can_be_dragged) {
    EXPECT_EQ(over(px(-2, 2)), Cursor::move);
    EXPECT_EQ(over(px(0, -1)), Cursor::hand);
    EXPECT_EQ(over(px(-1, 0)), Cursor::hand);
    EXPECT_EQ(over(px(4, 3)), Cursor::arrow);
    EXPECT_EQ(shown(true), Cursor::move);
}

TEST_F(Cursors, of_every_other_tool_differ_from_the_arrow) {
    const std::vector<std::pair<Tool, Cursor>> cursors{
        {Tool::add_point, Cursor::crosshair}, {Tool::insert_knot, Cursor::crosshair},
        {Tool::weight, Cursor::crosshair},    {Tool::draw_curve, Cursor::crosshair},
        {Tool::parameter, Cursor::hand},      {Tool::pencil, Cursor::crosshair}};
    for (const auto& [tool, cursor] : cursors) {
        editor.run(SetTool{.tool = tool});
        EXPECT_EQ(over(px(4, 3)), cursor) << core::name_of(tool);
    }
    editor.run(SetTool{.tool = Tool::weight});
    EXPECT_EQ(over(px(-2, 2)), Cursor::vertical);
}

TEST_F(Cursors, of_a_gesture_stay_until_it_ends) {
    pointer.press(px(-2, 2));
    EXPECT_EQ(over(px(4, 3)), Cursor::move);
    pointer.release(px(4, 3));
    pointer.press(px(5, -3));
    EXPECT_EQ(over(px(-2, 1)), Cursor::crosshair) << "a box";
    pointer.release(px(5, -3));
    pointer.button = PointerButton::middle;
    pointer.press(px(5, 3));
    EXPECT_EQ(shown(), Cursor::move);
}

TEST_F(Cursors, of_the_plot_point_along_its_axis) {
    test::PlotPointer plot{editor, test::PlotStep{}};
    const PlotLayout layout = plot_layout(state(), {1000.0, 260.0});
    const auto over_plot = [&](glm::dvec2 place) {
        plot.move(place);
        return plot_cursor(plot.mode(), state(), false);
    };
    EXPECT_EQ(over_plot({x_from_parameter(layout, 1.0), layout.strip_px}), Cursor::horizontal);
    EXPECT_EQ(over_plot({x_from_parameter(layout, 1.5), layout.top_px + 5.0}), Cursor::horizontal);
    EXPECT_EQ(over_plot({x_from_parameter(layout, 0.05), 5.0}), Cursor::arrow);
    EXPECT_EQ(plot_cursor(plot.mode(), state(), true), Cursor::move);
}

}  // namespace
}  // namespace batten::editor
