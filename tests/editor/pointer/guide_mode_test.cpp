#include "app/editor/pointer/guide_mode.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/snap_commands.h"
#include "app/editor/commands/unit_commands.h"
#include "app/editor/pointer/cursor.h"
#include "app/editor/pointer/place_text.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

using test::px;

constexpr glm::dvec2 on_upper{400.0, -8.0};
constexpr glm::dvec2 on_left{-8.0, 200.0};

class RulerGuides : public test::CanvasFixture {
  protected:
    RulerGuides() { editor.run(ToggleOverlay<Overlay::rulers>{}); }
    const std::vector<core::Guide>& guides() const { return state().history.present().guides; }
};

TEST_F(RulerGuides, are_dragged_out_of_the_rulers) {
    pointer.press(on_upper);
    EXPECT_TRUE(is_in<PullingGuide>());
    pointer.move(px(1, 3));
    ASSERT_EQ(state().shown().guides.size(), 1U);
    EXPECT_TRUE(guides().empty());
    pointer.release(px(1, 3));
    ASSERT_EQ(guides().size(), 1U);
    EXPECT_EQ(guides()[0].angle, 0.0);
    EXPECT_EQ(guides()[0].point.y, 3.0);
    EXPECT_EQ(steps(), 1U);
    pointer.drag(on_left, px(-3, 1));
    ASSERT_EQ(guides().size(), 2U);
    EXPECT_EQ(guides()[1].angle, 90.0);
    EXPECT_EQ(guides()[1].point.x, -3.0);
    EXPECT_EQ(steps(), 2U);
}

TEST_F(RulerGuides, snap_to_points_on_their_way) {
    pointer.drag(on_upper, px(-1.95, 2.03));
    ASSERT_EQ(guides().size(), 1U);
    EXPECT_EQ(guides()[0].point, core::Point(-2, 2));
}

TEST_F(RulerGuides, are_given_up_on_a_ruler_and_by_escape) {
    pointer.press(on_upper);
    pointer.move(px(1, 3));
    pointer.move(on_upper);
    EXPECT_TRUE(state().shown().guides.empty());
    pointer.release(on_upper);
    pointer.press(on_left);
    pointer.move(px(1, 3));
    pointer.escape(px(1, 3));
    EXPECT_TRUE(state().shown().guides.empty());
    EXPECT_EQ(steps(), 0U);
    pointer.click(on_left);
    EXPECT_EQ(steps(), 0U);
}

TEST_F(RulerGuides, are_dropped_back_in_one_step) {
    editor.run(AddGuide{.position = {0.3, 3.5}, .angle = 0.0});
    const auto before = steps();
    pointer.press(px(3, 3.5));
    ASSERT_TRUE(is_in<DraggingGuide>());
    pointer.move(px(3, 4));
    EXPECT_EQ(state().shown().guides.size(), 1U);
    pointer.move(on_upper);
    EXPECT_TRUE(state().shown().guides.empty());
    pointer.release(on_upper);
    EXPECT_TRUE(guides().empty());
    EXPECT_EQ(steps(), before + 1);
    editor.run(Undo{});
    ASSERT_EQ(guides().size(), 1U);
    EXPECT_EQ(guides()[0].point, core::Point(0.3, 3.5));
}

TEST_F(RulerGuides, are_where_a_number_alone_says) {
    const auto type = [&](const char32_t* text) {
        for (; *text != 0; ++text) {
            PointerEvent event;
            event.action = PointerAction::key;
            event.position_px = px(1.5, 1);
            event.character = *text;
            pointer.send(event);
        }
    };
    editor.run(SetUnits{.unit = UnitChoice::mm, .scale = 0.5});
    pointer.press(on_upper);
    pointer.move(px(1.5, 1));
    type(U"3");
    EXPECT_EQ(state().shown().guides[0].point.y, 1.5) << "3 mm are 1.5 of the world";
    EXPECT_EQ(typed_reading(state().placing.typed, state().placing.place->typed_for), "y 3|");
    pointer.release(px(1.5, 1));
    pointer.press(on_left);
    pointer.move(px(1.5, 1));
    type(U"1in");
    pointer.release(px(1.5, 1));
    ASSERT_EQ(guides().size(), 2U);
    EXPECT_EQ(guides()[0].point.y, 1.5);
    EXPECT_EQ(guides()[1].point.x, 12.7);
}

TEST_F(RulerGuides, tell_what_a_drag_would_do) {
    pointer.move(on_upper);
    EXPECT_EQ(state().hover, Hover(HoveredRuler{RulerAxis::x}));
    EXPECT_EQ(canvas_hint(pointer.mode(), state()), "Drag a guide out of the ruler");
    EXPECT_EQ(canvas_cursor(pointer.mode(), state(), false), Cursor::vertical);
    pointer.move(on_left);
    EXPECT_EQ(canvas_cursor(pointer.mode(), state(), false), Cursor::horizontal);
}

TEST_F(RulerGuides, meet_where_the_unit_is_asked_for) {
    pointer.click({-8.0, -8.0});
    EXPECT_EQ(state().dialog, Dialog::command_form);
    EXPECT_EQ(state().form, &SetUnits::spec());
}

}  // namespace
}  // namespace batten::editor
