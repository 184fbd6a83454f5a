#include "app/editor/pointer/pencil_mode.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>

#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/stroke_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/nearest.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

using test::committed;
using test::px;

class PencilMode : public test::CanvasFixture {
  protected:
    PencilMode() { editor.run(SetTool{.tool = Tool::pencil}); }

    // Along an arc around the middle of the canvas, in whole pixels.
    static std::vector<glm::dvec2> arc(double from, double to, double radius_px) {
        std::vector<glm::dvec2> places;
        for (int k = 0; k <= 150; ++k) {
            const double angle = from + (to - from) * k / 150.0;
            places.push_back(glm::round(px(0, 0) + radius_px * glm::dvec2(std::cos(angle), -std::sin(angle))));
        }
        return places;
    }

    void draw(const std::vector<glm::dvec2>& places) {
        pointer.press(places.front());
        for (const glm::dvec2& place : places) pointer.move(place);
        pointer.release(places.back());
    }

    std::size_t curves() const { return state().history.present().curves.size(); }
};

TEST_F(PencilMode, draws_a_smooth_curve_in_one_step) {
    draw(arc(0.2, 2.9, 200.0));
    ASSERT_EQ(curves(), 2U);
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(state().history.undo_label(), "Draw stroke");
    EXPECT_EQ(state().history.present().active_curve()->name, "stroke");
    const core::Curve& curve = committed(editor);
    EXPECT_LE(curve.control_points().size(), 10U);
    for (int k = 0; k <= 20; ++k)
        EXPECT_NEAR(core::distance(core::point_at(curve, k / 20.0), {0, 0}), 200.0 / 64.0, 1.0 / 64.0);
    EXPECT_EQ(state().tool, Tool::pencil);
    EXPECT_EQ(*editor.log().back().as<FitStroke>()->points.begin(), *state().stroke->points->begin());
}

TEST_F(PencilMode, shows_a_smooth_line_that_ends_at_the_pointer) {
    const auto places = arc(0.2, 2.9, 200.0);
    pointer.press(places.front());
    for (const glm::dvec2& place : places) {
        pointer.move(place);
        const auto& stroke = std::get<PencilStroke>(pointer.mode());
        if (stroke.samples.size() > 5) {
            EXPECT_EQ(stroke.line.back(), stroke.samples.back());
        }
    }
    EXPECT_EQ(curves(), 1U);
    pointer.escape(places.back());
    EXPECT_TRUE(is_in<CanvasIdle>());
    EXPECT_EQ(steps(), 0U);
}

TEST_F(PencilMode, settles_the_line_of_a_long_stroke) {
    pointer.press(px(0, 0));
    for (int k = 1; k <= 2000; ++k) {
        const double angle = 0.01 * k;
        const double radius = 20.0 + 0.12 * k;
        pointer.move(glm::round(px(0, 0) + radius * glm::dvec2(std::cos(angle), std::sin(angle))));
        const auto& stroke = std::get<PencilStroke>(pointer.mode());
        EXPECT_LE(stroke.samples.size() - stroke.settled_samples, 257U);
    }
    const auto& stroke = std::get<PencilStroke>(pointer.mode());
    EXPECT_GT(stroke.settled_samples, 1500U);
    // The line goes on without a gap.
    EXPECT_LT(core::distance(stroke.settled.back(), stroke.line.front()), 6.0 / 64.0);
}

TEST_F(PencilMode, closes_a_stroke_that_comes_back) {
    draw(arc(0.0, 6.27, 150.0));
    EXPECT_TRUE(committed(editor).is_periodic());
    EXPECT_EQ(state().message.text.rfind("Drew a closed curve with ", 0), 0U) << state().message.text;
}

TEST_F(PencilMode, ignores_a_click) {
    pointer.click(px(1, 3));
    EXPECT_EQ(steps(), 0U);
}

TEST_F(PencilMode, is_given_up_with_its_tool) {
    pointer.press(px(1, 3));
    pointer.move(px(2, 3));
    editor.run(SetTool{.tool = Tool::select});
    pointer.move(px(3, 3));
    pointer.release(px(3, 3));
    EXPECT_EQ(curves(), 1U);
}

TEST_F(PencilMode, redraws_a_part_of_the_curve_it_begins_and_ends_on) {
    const core::Point from = core::point_at(*first_curve, 0.6);
    const core::Point to = core::point_at(*first_curve, 2.4);
    std::vector<glm::dvec2> places;
    for (int k = 0; k <= 100; ++k) {
        const double t = k / 100.0;
        const core::Point on_line = from + t * (to - from);
        places.push_back(glm::round(px(on_line.x, on_line.y + 1.5 * std::sin(3.14159 * t))));
    }
    draw(places);
    EXPECT_EQ(curves(), 1U);
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(state().history.undo_label(), "Redraw part");
    const core::Curve& curve = committed(editor);
    EXPECT_EQ(core::point_at(curve, 0.0), core::Point(-4, -2));
    EXPECT_LT(core::distance(core::nearest_point(curve, {0, from.y + 1.5}).point, core::Point(0, from.y + 1.5)), 0.05);
    EXPECT_LT(core::distance(core::point_at(curve, 0.4), core::point_at(*first_curve, 0.4)), 1e-9);
    pointer.modifiers = test::alt;
    draw(places);
    EXPECT_EQ(curves(), 2U) << "Alt draws a new curve";
}

TEST_F(PencilMode, redraws_past_an_end_which_goes_along) {
    const auto line_to = [](core::Point from, core::Point to) {
        std::vector<glm::dvec2> places;
        for (int k = 0; k <= 100; ++k) {
            const core::Point place = from + (k / 100.0) * (to - from);
            places.push_back(glm::round(px(place.x, place.y)));
        }
        return places;
    };
    // The curve ends in (4, -2), where it runs along (1, -2).
    const core::Point from = core::point_at(*first_curve, 2.5);
    draw(line_to(from, {4.75, -3.25}));
    EXPECT_EQ(curves(), 1U);
    ASSERT_EQ(state().history.undo_label(), "Redraw part");
    EXPECT_LT(core::distance(core::point_at(committed(editor), 3.0), {4.75, -3.25}), 0.02);
    EXPECT_LT(core::distance(core::point_at(committed(editor), 1.0), {-1, 0}), 1e-12);
    editor.run(Undo{});
    // What leads away from the way on is a new curve, and so is what begins at the end.
    draw(line_to(from, {6.0, -1.0}));
    EXPECT_EQ(curves(), 2U);
    editor.run(Undo{});
    draw(line_to({4, -2}, {4.75, -3.25}));
    EXPECT_EQ(curves(), 2U);
}

TEST_F(PencilMode, refits_the_last_stroke_in_its_own_step) {
    draw(arc(0.2, 2.9, 200.0));
    const core::Curve usual = committed(editor);
    EXPECT_TRUE(editor.run(RefitStroke{.smoothness = 10}));
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(curves(), 2U);
    EXPECT_LE(committed(editor).control_points().size(), usual.control_points().size());
    EXPECT_EQ(state().view.smoothness, 10);
    EXPECT_TRUE(editor.run(RefitStroke{.smoothness = core::usual_smoothness}));
    EXPECT_EQ(committed(editor), usual);
    EXPECT_TRUE(editor.run(Undo{}));
    EXPECT_EQ(curves(), 1U);
    EXPECT_FALSE(editor.run(RefitStroke{.smoothness = 3}));
    EXPECT_EQ(state().message.text, "the last step is no stroke; draw one with the pencil first");
    EXPECT_TRUE(editor.run(Redo{}));
    EXPECT_TRUE(editor.run(RefitStroke{.smoothness = 3}));
}

}  // namespace
}  // namespace batten::editor
