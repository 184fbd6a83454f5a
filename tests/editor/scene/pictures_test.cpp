#include "app/editor/scene/pictures.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/picture_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/pointer/cursor.h"
#include "tests/editor/canvas_fixture.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor::test {
namespace {

const std::filesystem::path ring = std::filesystem::path(BATTEN_TEST_DATA) / "pictures" / "ring_gray.png";

class Pictures : public CanvasFixture {
  protected:
    Pictures() {
        editor.run(AddPicture{.path = ring, .center = {0, 0}, .width = 2, .opacity = 0.25});
        first_steps = state().history.undo_count();
    }
    const core::Picture& picture() const { return state().history.present().pictures.front(); }
};

TEST_F(Pictures, are_drawn_below_everything) {
    const render::DrawList list = canvas_picture(state());
    ASSERT_TRUE(std::holds_alternative<render::ImageQuad>(list.commands.front()));
    const auto& quad = std::get<render::ImageQuad>(list.commands.front());
    EXPECT_EQ(quad.upper_left, px(-1, 1));
    EXPECT_EQ(quad.upper_right, px(1, 1));
    EXPECT_EQ(quad.lower_left, px(-1, -1));
    EXPECT_EQ(quad.opacity, 0.25);
    EXPECT_EQ(quad.image->width, 64);
    // The same image from frame to frame.
    EXPECT_EQ(std::get<render::ImageQuad>(canvas_picture(state()).commands.front()).image, quad.image);
    editor.run(ShowPicture{.picture = 0, .visible = false});
    EXPECT_TRUE(all_of<render::ImageQuad>(canvas_picture(state())).empty());
}

TEST_F(Pictures, turn_on_the_canvas) {
    editor.run(PlacePicture{.picture = 0, .position = {1, 1}, .width = 2, .rotation = 90});
    const auto quad = all_of<render::ImageQuad>(canvas_picture(state())).at(0);
    EXPECT_EQ(quad.lower_left, px(1, 1));
    EXPECT_EQ(quad.upper_left, px(-1, 1));
    EXPECT_EQ(quad.upper_right, px(-1, 3));
}

TEST_F(Pictures, a_missing_file_leaves_a_frame_with_the_reason) {
    core::Document document = state().history.present();
    document.pictures.front().path = "/no/such/scan.png";
    EditorState missing = state();
    missing.history = History(document);
    const render::DrawList list = canvas_picture(missing);
    EXPECT_TRUE(all_of<render::ImageQuad>(list).empty());
    EXPECT_TRUE(has_text(list, "scan.png: there is no such file"));
    const auto lines = all_of<render::Polyline>(list);
    EXPECT_LT(distance_to(lines, px(-1, 0)), 0.01);
    EXPECT_LT(distance_to(lines, px(0, 1)), 0.01);
}

// At (0.5, 0.5) there is nothing of the zigzag.
TEST_F(Pictures, follow_the_pointer_unless_they_are_locked) {
    pointer.drag(px(0.5, 0.6), px(1.5, 0.1));
    EXPECT_EQ(steps(), 1U);
    EXPECT_NEAR(picture().position.x, 0.0, 1e-12);
    EXPECT_NEAR(picture().position.y, -1.5, 1e-12);
    editor.run(LockPicture{.picture = 0, .locked = true});
    const auto before = picture();
    pointer.drag(px(1.5, 0.1), px(0.2, 0.9));
    EXPECT_EQ(picture(), before);
}

TEST_F(Pictures, are_told_of_where_they_can_be_dragged) {
    pointer.move(px(0.5, 0.6));
    EXPECT_EQ(state().hover, Hover(HoveredPicture{0}));
    EXPECT_EQ(canvas_hint(pointer.mode(), state()).substr(0, 27), "Drag the picture to move it");
    EXPECT_EQ(canvas_cursor(pointer.mode(), state(), false), Cursor::move);
    pointer.move(px(0, -2));
    EXPECT_EQ(state().hover, Hover(HoveredPoint{2}));
    editor.run(SetTool{.tool = Tool::pencil});
    pointer.move(px(0.5, 0.6));
    EXPECT_EQ(state().hover, Hover(HoveredNothing{}));
    editor.run(SetTool{.tool = Tool::select});
    pointer.move(px(0.5, 0.7));
    EXPECT_EQ(state().hover, Hover(HoveredPicture{0}));
    editor.run(RemovePicture{.picture = 0});
    EXPECT_EQ(state().hover, Hover(HoveredNothing{}));
    editor.run(Undo{});
    editor.run(LockPicture{.picture = 0, .locked = true});
    pointer.move(px(0.5, 0.6));
    EXPECT_EQ(state().hover, Hover(HoveredNothing{}));
}

TEST_F(Pictures, leave_points_to_be_taken) {
    pointer.press(px(0, -2));
    EXPECT_TRUE(is_in<DraggingPoints>());
    pointer.release(px(0, -2));
    pointer.press(px(3, 3));  // beside the picture
    EXPECT_TRUE(is_in<BoxSelecting>());
}

TEST_F(Pictures, clicks_gauge_them) {
    editor.run(MeasurePicture{.picture = 0});
    EXPECT_TRUE(canvas_hint(pointer.mode(), state()).starts_with("Click the first point"));
    pointer.click(px(-0.5, 0.5));
    EXPECT_TRUE(canvas_hint(pointer.mode(), state()).starts_with("Click the second point"));
    pointer.click(px(0.5, 0.5));
    ASSERT_TRUE(state().gauge);
    EXPECT_EQ(state().gauge->points, (std::vector<core::Point>{{-0.5, 0.5}, {0.5, 0.5}}));
    EXPECT_EQ(state().dialog, Dialog::command_form);
    EXPECT_EQ(state().message.text, "") << "no more clicks are asked for";
    EXPECT_EQ(steps(), 0U);
}

TEST_F(Pictures, points_that_gauge_them_stand_out_from_light_and_dark) {
    editor.run(MeasurePicture{.picture = 0});
    pointer.click(px(-0.5, 0.5));
    const Theme theme = shown_theme(state().view);
    int found = 0;
    for (const render::Marker& marker : all_of<render::Marker>(canvas_picture(state()))) {
        if (glm::distance(glm::dvec2(marker.center), px(-0.5, 0.5)) > 0.01) continue;
        ++found;
        EXPECT_EQ(marker.fill, theme.canvas);
        EXPECT_EQ(marker.outline, theme.accent);
        EXPECT_GE(marker.outline_px, 1.0F);
    }
    EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace batten::editor::test
