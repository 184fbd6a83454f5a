#include "app/editor/pointer/drawing.h"

#include <gtest/gtest.h>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/pen_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "core/evaluate/evaluate.h"
#include "core/make/fit_points.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

using test::committed;
using test::px;

class Drawing : public test::CanvasFixture {
  protected:
    void take_pen(PenMode mode) {
        editor.run(SetPenMode{.mode = mode});
        editor.run(SetTool{.tool = Tool::draw_curve});
    }
    void click_all(std::initializer_list<glm::dvec2> places) {
        for (const glm::dvec2 place : places) pointer.click(place);
    }
    void click_right(glm::dvec2 at) {
        pointer.button = PointerButton::right;
        pointer.click(at);
        pointer.button = PointerButton::left;
    }
    const DrawingCurve& drawing() const { return std::get<DrawingCurve>(pointer.mode()); }
    const core::FitPoints& fit() const { return *state().history.present().active_curve()->fit; }
    std::size_t curves() const { return state().history.present().curves.size(); }
};

const std::vector<std::pair<PenMode, core::FitKind>> passing{{PenMode::through_c2, core::FitKind::c2},
                                                             {PenMode::through_local, core::FitKind::local},
                                                             {PenMode::through_fair, core::FitKind::fair}};

TEST_F(Drawing, a_curve_through_the_points_is_one_step) {
    for (const auto& [mode, kind] : passing) {
        take_pen(mode);
        const std::size_t before = steps();
        click_all({px(-3, 0), px(-1, 2), px(1, 0)});
        pointer.double_click(px(3, 2));
        EXPECT_TRUE(is_in<CanvasIdle>());
        EXPECT_EQ(steps(), before + 1);
        EXPECT_EQ(fit().kind, kind);
        ASSERT_EQ(fit().points.size(), 4U);
        EXPECT_EQ(fit().points[1].place, core::Point(-1, 2));
        EXPECT_FALSE(fit().closed);
        EXPECT_LT(core::distance(core::point_at(committed(editor), fit().parameters[2]), core::Point(1, 0)), 1e-12);
        EXPECT_EQ(state().tool, Tool::select);
        editor.run(Undo{});  // nothing to snap to
    }
}

TEST_F(Drawing, what_is_shown_is_what_comes_of_it) {
    for (const PenMode mode : {PenMode::control_points, PenMode::through_c2, PenMode::through_local,
                               PenMode::through_fair, PenMode::bezier}) {
        take_pen(mode);
        click_all({px(-3, 0), px(-1, 2), px(1, 0)});
        pointer.move(px(3, 2));
        const auto shown = drawn_curve(drawing(), mode);
        ASSERT_TRUE(shown);
        pointer.click(px(3, 2));
        pointer.send(PointerAction::finish, {0, 0});
        EXPECT_EQ(*shown, committed(editor)) << core::name_of(mode);
        take_pen(mode);
        click_all({px(-3, 0), px(-1, 2), px(1, 0)});
        pointer.move(px(-3, 0) + glm::dvec2(3.0, 2.0));
        EXPECT_TRUE(drawing().closes);
        const auto ring = drawn_curve(drawing(), mode);
        ASSERT_TRUE(ring);
        pointer.click(px(-3, 0));
        EXPECT_EQ(*ring, committed(editor)) << core::name_of(mode);
        EXPECT_TRUE(committed(editor).is_periodic());
    }
}

TEST_F(Drawing, a_click_on_the_first_point_closes) {
    take_pen(PenMode::through_c2);
    click_all({px(-3, 0), px(-1, 2)});
    pointer.move(px(-3, 0));
    EXPECT_FALSE(drawing().closes) << "two points make no ring";
    click_all({px(1, 0), px(-3, 0)});
    EXPECT_TRUE(fit().closed);
    EXPECT_EQ(fit().points.size(), 3U);
    take_pen(PenMode::control_points);
    click_all({px(-3, 0), px(-1, 2), px(1, 0), px(-3, 0)});
    EXPECT_TRUE(committed(editor).is_periodic());
    EXPECT_EQ(committed(editor).control_points().size(), 3U);
    EXPECT_EQ(committed(editor).degree(), 3);
}

TEST_F(Drawing, enter_and_a_right_click_end_it) {
    take_pen(PenMode::through_c2);
    click_all({px(-3, 0), px(-1, 2)});
    pointer.send(PointerAction::finish, {0, 0});
    EXPECT_EQ(curves(), 2U);
    take_pen(PenMode::through_c2);
    click_all({px(-3, 0), px(-1, 2), px(2, 2)});
    click_right(px(3, 3));
    EXPECT_EQ(curves(), 3U);
    EXPECT_EQ(fit().points.size(), 3U);
    take_pen(PenMode::through_c2);
    pointer.click(px(-3, 0));
    pointer.send(PointerAction::finish, {0, 0});
    EXPECT_TRUE(is_in<DrawingCurve>()) << "one point is no curve";
    click_right(px(3, 3));
    EXPECT_TRUE(is_in<CanvasIdle>());
    EXPECT_EQ(curves(), 3U);
}

TEST_F(Drawing, the_last_point_is_taken_back) {
    take_pen(PenMode::through_c2);
    click_all({px(-3, 0), px(-1, 2), px(1, 0)});
    pointer.send(PointerAction::take_back, {0, 0});
    EXPECT_EQ(drawing().points, (std::vector<core::Point>{{-3, 0}, {-1, 2}}));
    pointer.click(px(2, 2));
    EXPECT_EQ(drawing().points.size(), 3U);
    for (int i = 0; i < 3; ++i) pointer.send(PointerAction::take_back, {0, 0});
    EXPECT_TRUE(is_in<CanvasIdle>());
    EXPECT_EQ(state().tool, Tool::draw_curve) << "the pen stays in hand";
    EXPECT_EQ(steps(), 0U);
}

// A point that was typed onto the first one cannot be passed twice by a closed curve.
TEST_F(Drawing, what_cannot_be_made_is_not_lost) {
    take_pen(PenMode::through_c2);
    const std::size_t before = curves();
    click_all({px(-3, 0), px(-1, 2), px(1, 0)});
    type(U"-3,0\n", px(2, 2));
    ASSERT_EQ(drawing().points.size(), 4U);
    pointer.click(px(-3, 0));
    EXPECT_EQ(curves(), before);
    EXPECT_TRUE(state().message.is_error) << state().message.text;
    ASSERT_TRUE(is_in<DrawingCurve>());
    EXPECT_EQ(drawing().points.size(), 4U);
    pointer.send(PointerAction::take_back, {0, 0});
    pointer.click(px(-3, 0));
    EXPECT_EQ(curves(), before + 1);
    EXPECT_TRUE(fit().closed);
    EXPECT_EQ(fit().points.size(), 3U);
}

TEST_F(Drawing, the_view_moves_meanwhile) {
    take_pen(PenMode::through_c2);
    click_all({px(-3, 0), px(-1, 2)});
    const glm::dvec2 center = state().view.camera.center;
    pointer.button = PointerButton::middle;
    pointer.drag(px(0, 0), px(1, 0));
    EXPECT_NEAR(state().view.camera.center.x, center.x - 1.0, 1e-12);
    pointer.button = PointerButton::left;
    pointer.space = true;
    pointer.drag(px(1, 0), px(0, 0));
    pointer.space = false;
    EXPECT_NEAR(state().view.camera.center.x, center.x, 1e-12);
    const double scale = state().view.camera.scale;
    pointer.send(PointerAction::wheel, px(0, 0), 1.0);
    EXPECT_GT(state().view.camera.scale, scale);
    EXPECT_EQ(drawing().points.size(), 2U);
}

TEST_F(Drawing, bezier_clicks_make_corners_and_drags_handles) {
    take_pen(PenMode::bezier);
    pointer.click(px(-3, 0));
    pointer.drag(px(0, 2), px(1, 2));
    EXPECT_EQ(drawn_handles(drawing()).size(), 1U);
    EXPECT_EQ(drawn_handles(drawing())[0].behind, core::Point(-1, 2));
    EXPECT_EQ(drawn_handles(drawing())[0].ahead, core::Point(1, 2));
    pointer.click(px(3, 0));
    pointer.click(px(3, -3));
    pointer.send(PointerAction::finish, {0, 0});
    const core::Curve& drawn = committed(editor);
    EXPECT_EQ(drawn.knots().kind(), core::KnotKind::piecewise_bezier);
    ASSERT_EQ(drawn.control_points().size(), 10U);
    EXPECT_EQ(drawn.control_points()[2], core::Point(-1, 2));
    EXPECT_EQ(drawn.control_points()[4], core::Point(1, 2));
    // A corner's piece leaves toward the handle of its other end; between two corners it is a line run evenly.
    EXPECT_LT(core::distance(drawn.control_points()[1], core::Point(-3 + 2.0 / 3.0, 2.0 / 3.0)), 1e-14);
    EXPECT_EQ(drawn.control_points()[7], core::Point(3, -1));
    EXPECT_EQ(drawn.control_points()[8], core::Point(3, -2));
    EXPECT_EQ(steps(), 1U);
}

TEST_F(Drawing, a_bezier_path_is_closed_by_a_click) {
    take_pen(PenMode::bezier);
    pointer.drag(px(-2, 0), px(-2, 1));
    pointer.drag(px(2, 0), px(2, -1));
    pointer.click(px(0, -3));
    pointer.click(px(-2, 0));
    const core::Curve& ring = committed(editor);
    EXPECT_TRUE(ring.is_periodic());
    EXPECT_EQ(core::point_at(ring, 0.0), core::Point(-2, 0));
    EXPECT_EQ(core::point_at(ring, 1.0), core::Point(2, 0));
    EXPECT_EQ(core::derivatives_at(ring, 0.0, 1, core::Side::right)[1], core::Vector(0, 3));
    EXPECT_EQ(core::derivatives_at(ring, 3.0, 1, core::Side::left)[1], core::Vector(0, 3));
}

TEST_F(Drawing, a_click_on_the_first_of_two_points_says_what_a_closed_curve_needs) {
    editor.run(UsePen<PenMode::through_c2>{});
    pointer.click(px(-2, 0));
    pointer.click(px(2, 0));
    pointer.click(px(-2, 0));
    ASSERT_TRUE(std::holds_alternative<DrawingCurve>(pointer.mode()));
    EXPECT_EQ(std::get<DrawingCurve>(pointer.mode()).points.size(), 2U);
    EXPECT_EQ(state().message.text, "a closed curve needs three points; click one more before the first");
    pointer.click(px(0, 3));
    pointer.click(px(-2, 0));
    EXPECT_TRUE(committed(editor).is_periodic());
}

// The handle of the first point is drawn out by the press that closes the curve: C' there is three times (0, -2).
TEST_F(Drawing, the_handle_of_the_first_point_is_drawn_out_while_the_curve_is_closed) {
    editor.run(UsePen<PenMode::bezier>{});
    pointer.click(px(-2, 0));
    pointer.click(px(2, 0));
    pointer.press(px(-2, 0));
    pointer.move(px(-2, -2));
    EXPECT_TRUE(std::get<DrawingCurve>(pointer.mode()).closes);
    pointer.release(px(-2, -2));
    const core::Curve& ring = committed(editor);
    ASSERT_TRUE(ring.is_periodic());
    EXPECT_EQ(core::derivatives_at(ring, 0.0, 1, core::Side::right)[1], core::Vector(0, -6));
    EXPECT_EQ(core::derivatives_at(ring, ring.domain().upper, 1, core::Side::left)[1], core::Vector(0, -6));
}

// Handles make a closed curve of two points: (0, 2) up at one, (0, -2) down at the other.
TEST_F(Drawing, two_points_with_handles_make_a_closed_curve) {
    editor.run(UsePen<PenMode::bezier>{});
    pointer.drag(px(-2, 0), px(-2, 2));
    pointer.drag(px(2, 0), px(2, -2));
    pointer.click(px(-2, 0));
    const core::Curve& ring = committed(editor);
    EXPECT_TRUE(ring.is_periodic());
    EXPECT_EQ(core::point_at(ring, 0.5), core::Point(0, 1.5));
    EXPECT_EQ(core::point_at(ring, 1.5), core::Point(0, -1.5));
}

TEST_F(Drawing, the_mode_is_kept_and_chosen_with_the_pen) {
    EXPECT_EQ(state().view.pen_mode, PenMode::through_c2);
    editor.run(UsePen<PenMode::bezier>{});
    EXPECT_EQ(state().view.pen_mode, PenMode::bezier);
    EXPECT_EQ(state().tool, Tool::draw_curve);
    pointer.click(px(-3, 0));
    editor.run(UsePen<PenMode::through_c2>{});
    CommandQueue queue;
    EXPECT_TRUE(std::holds_alternative<DrawingCurve>(with_present_tool(pointer.mode(), state(), queue)))
        << "what is half drawn goes on";
}

}  // namespace
}  // namespace batten::editor
