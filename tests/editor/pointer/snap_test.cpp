#include "app/editor/pointer/snap.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>
#include <string_view>

#include "app/editor/command_spec.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/making_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/snap_commands.h"
#include "app/editor/commands/tool_commands.h"
#include "app/editor/commands/unit_commands.h"
#include "app/editor/state/same_document.h"
#include "core/curve/knot_kinds.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

using test::px;

class Snapping : public test::CanvasFixture {
  protected:
    Snapping() { only({}); }

    void only(std::initializer_list<SnapKind> kinds) {
        for (const auto& kind : core::Names<SnapKind>::table) editor.run(SetSnap{.kind = kind.value, .on = false});
        for (const SnapKind kind : kinds) editor.run(SetSnap{.kind = kind, .on = true});
    }

    std::optional<Snap> at(core::Point place, std::optional<core::Point> from = {}, Dragged dragged = {}) {
        return snap_at(state(), {place, from, dragged});
    }

    void expect(core::Point place, core::Point wanted, const std::string& sentence,
                std::optional<core::Point> from = {}) {
        const auto snap = at(place, from);
        ASSERT_TRUE(snap) << sentence;
        EXPECT_LE(core::distance(snap->position, wanted), 1e-14) << snap->position.x << ", " << snap->position.y;
        EXPECT_EQ(snap->sentence, sentence);
    }
};

// 8 pixels are an eighth of a unit.
TEST_F(Snapping, to_points_ends_knots_midpoints_within_eight_pixels) {
    EXPECT_FALSE(at({-2.0, 2.0}));
    only({SnapKind::points});
    expect({-1.9, 2.07}, {-2, 2}, "Snaps to P₁");
    EXPECT_FALSE(at({-1.9, 2.08}));
    only({SnapKind::ends});
    expect({-3.95, -2.0}, {-4, -2}, "Snaps to the start of 'curve'");
    expect({4.05, -2.0}, {4, -2}, "Snaps to the end of 'curve'");
    EXPECT_FALSE(at({-2.0, 2.0}));
    only({SnapKind::knots});
    expect({-1.05, 0.05}, {-1, 0}, "Snaps to the knot 1.000 of 'curve'");
    expect({1.05, 0.05}, {1, 0}, "Snaps to the knot 2.000 of 'curve'");
    only({SnapKind::midpoints});
    expect({-2.95, 0.05}, {-3, 0}, "Snaps to the middle between P₀ and P₁");
}

// C(1.5) = (0, -1) with a level tangent: the nearest place of (0, -1.1).
TEST_F(Snapping, to_the_curve_its_perpendiculars_and_tangents) {
    only({SnapKind::curve});
    expect({0.0, -1.1}, {0, -1}, "Snaps to the nearest place of 'curve'");
    only({SnapKind::perpendicular});
    EXPECT_FALSE(at({0.05, -1.05}));
    expect({0.05, -1.05}, {0, -1}, "Snaps to where the line from the start is perpendicular to 'curve'",
           core::Point(0, 3));
    only({SnapKind::tangent});
    expect({0.05, -1.05}, {0, -1}, "Snaps to where the line from the start touches 'curve'", core::Point(3, -1));
    EXPECT_FALSE(at({0.05, -1.05}, core::Point(0, 3)));
    EXPECT_EQ(at({0.05, -1.05}, core::Point(3, -1))->lines, (std::vector<SnapLine>{{{3, -1}, {0, -1}}}));
}

TEST_F(Snapping, to_crossings_exactly) {
    editor.run(AddCircle{.center = {-1, 5}, .radius = std::sqrt(2.0), .polygon = core::CirclePolygon::square});
    editor.run(AddCircle{.center = {1, 5}, .radius = std::sqrt(2.0), .polygon = core::CirclePolygon::square});
    only({SnapKind::intersections});
    expect({0.03, 6.02}, {0, 6}, "Snaps to where 'circle' and 'circle 2' cross");
    expect({0.03, 3.98}, {0, 4}, "Snaps to where 'circle' and 'circle 2' cross");
    EXPECT_FALSE(at({0.03, 3.98}, {}, {.is_curve = true}));
}

// The first piece has the Bézier points (-4, -2), (-2, 2), (-1, 0), so that C(u) = (-4 + 4u - u^2, -2 + 8u - 6u^2): it
// passes x = -3 where u = 2 - sqrt(3). At its end (-1, 0) the guide through (0, 1) at 45 degrees crosses it.
TEST_F(Snapping, to_where_guides_cross_curves_exactly) {
    editor.run(AddGuide{.position = {-3.0, 7.0}, .angle = 90.0});
    editor.run(AddGuide{.position = {0.0, 1.0}, .angle = 45.0});
    only({SnapKind::intersections});
    const double u = 2.0 - std::sqrt(3.0);
    const double y = -2.0 + 8.0 * u - 6.0 * u * u;
    expect({-3.05, y + 0.05}, {-3.0, y}, "Snaps to where 'curve' crosses a guide");
    EXPECT_EQ(at({-3.05, y + 0.05})->position.x, -3.0);
    expect({-0.95, 0.04}, {-1, 0}, "Snaps to where 'curve' crosses a guide");
    EXPECT_FALSE(at({-3.05, y + 0.05}, {}, {.guide = 0}));
    EXPECT_FALSE(at({-3.05, y + 0.05}, {}, {.is_curve = true}));
    only({SnapKind::guides});
    EXPECT_EQ(at({-3.05, y + 0.05})->kind, SnapKind::guides);
}

TEST_F(Snapping, to_guides_and_where_they_cross) {
    editor.run(AddGuide{.position = {0.3, 3.0}, .angle = 0.0});
    editor.run(AddGuide{.position = {5.0, 7.0}, .angle = -90.0});
    editor.run(AddGuide{.position = {0.0, 0.0}, .angle = 225.0});
    only({SnapKind::guides});
    expect({1.0, 3.1}, {1, 3}, "Snaps to the guide y = 3");
    expect({5.1, -1.0}, {5, -1}, "Snaps to the guide x = 5");
    editor.run(SetUnits{.unit = UnitChoice::mm, .scale = 0.1});
    expect({1.0, 3.1}, {1, 3}, "Snaps to the guide y = 30 mm");
    expect({5.1, -1.0}, {5, -1}, "Snaps to the guide x = 50 mm");
    expect({1.05, 0.95}, {1, 1}, "Snaps to the guide at 45°");
    expect({5.05, 2.95}, {5, 3}, "Snaps to where two guides cross");
    expect({5.05, 4.95}, {5, 5}, "Snaps to where two guides cross");
    EXPECT_FALSE(at({1.0, 3.1}, {}, {.guide = 0}));
    EXPECT_EQ(at({5.05, 2.95})->position, core::Point(5, 3));  // to the last bit
}

TEST_F(Snapping, to_steps_of_the_angle_and_the_grid) {
    only({SnapKind::angles});
    expect({2.0, 3.4}, core::Point(0, 0) + (1.0 + 3.4 * std::sqrt(0.75)) * core::Vector(0.5, std::sqrt(0.75)),
           "Snaps to the direction 60°", core::Point(0, 0));
    expect({4.0, 0.1}, {4, 0}, "Snaps to the direction 0°", core::Point(0, 0));
    EXPECT_FALSE(at({2.0, 3.0}, core::Point(0, 0)));
    editor.run(SetAngleStep{.degrees = 90.0});
    EXPECT_FALSE(at({2.0, 3.4}, core::Point(0, 0)));
    expect({0.1, -3.0}, {0, -3}, "Snaps to the direction −90°", core::Point(0, 0));
    only({SnapKind::grid, SnapKind::points});
    expect({0.61, 0.99}, {0.5, 1.0}, "Snaps to the grid");
    expect({-1.99, 1.99}, {-2, 2}, "Snaps to P₁");
}

TEST_F(Snapping, not_to_what_is_dragged_hidden_or_not_shown) {
    only({SnapKind::points, SnapKind::knots, SnapKind::curve, SnapKind::midpoints, SnapKind::ends});
    const std::vector<std::size_t> first{0};
    EXPECT_FALSE(at({-4, -2}, {}, {.points = first}));
    EXPECT_FALSE(at({-3, 0}, {}, {.points = first}));
    EXPECT_TRUE(at({-2, 2}, {}, {.points = first}));
    const std::vector<std::size_t> middle{2};
    EXPECT_FALSE(at({-1, 0}, {}, {.points = middle}));  // the knot moves with it, and the leg
    EXPECT_FALSE(at({0, -1}, {}, {.points = middle}));
    EXPECT_TRUE(at({4, -2}, {}, {.points = middle}));
    EXPECT_FALSE(at({4, -2}, {}, {.is_curve = true}));
    editor.run(ToggleOverlay<Overlay::polygon>{});
    EXPECT_FALSE(at({-2, 2}));
    EXPECT_TRUE(at({-4, -2}));
    editor.run(SetCurveVisible{.index = 0, .visible = false});
    EXPECT_FALSE(at({-4, -2}));
}

TEST_F(Snapping, of_a_closed_curve_at_its_seam) {
    Editor closed;
    core::Document document;
    document.curves.emplace_back().curve =
        std::make_shared<const core::Curve>(core::Curve::make(test::closed_cubic()).value());
    document.curves.back().name = "ring";
    Editor ring(document);
    for (const auto& kind : core::Names<SnapKind>::table) ring.run(SetSnap{.kind = kind.value, .on = false});
    ring.run(SetSnap{.kind = SnapKind::knots, .on = true});
    // u = 0 is (P_{n-3} + 4 P_{n-2} + P_{n-1}) / 6 of the unrolled polygon, here the points 0, 1, 2.
    const core::Point seam{(2.0 + 4.0 - 1.0) / 6.0, (0.0 + 8.0 + 2.0) / 6.0};
    const auto snap = snap_at(ring.state(), {seam + core::Vector(0.02, 0.02)});
    ASSERT_TRUE(snap);
    EXPECT_LE(core::distance(snap->position, seam), 1e-15);
    const std::vector<std::size_t> one{1};
    EXPECT_FALSE(snap_at(ring.state(), {seam, {}, {.points = one}}));
    const std::vector<std::size_t> other{4};
    EXPECT_TRUE(snap_at(ring.state(), {seam, {}, {.points = other}}));
}

// Whatever is snapped to and typed, every step is one, and undoing all of them leads back to the last bit.
TEST_F(Snapping, random_gestures_undo_to_the_first_document) {
    for (const auto& kind : core::Names<SnapKind>::table) editor.run(SetSnap{.kind = kind.value, .on = true});
    const core::Document first = state().history.present();
    std::mt19937 random(5);
    const auto below = [&](unsigned count) { return static_cast<double>(random() % count); };
    const auto place = [&] { return glm::dvec2(200.0 + 4.0 * below(220), 100.0 + 4.0 * below(130)); };
    const auto key = [&](char32_t character, Key named) {
        PointerEvent event;
        event.action = PointerAction::key;
        event.position_px = place();
        event.character = character;
        event.key = named;
        pointer.send(event);
    };
    constexpr std::u32string_view characters = U"0123456789.,@<x-+";
    for (int i = 0; i < 500; ++i) {
        if (i % 25 == 0) editor.run(AddGuide{.position = {below(9) - 4.0, below(9) - 4.0}, .angle = 15.0 * below(12)});
        if (i % 10 == 0) editor.run(SetTool{.tool = i % 20 == 0 ? Tool::shape : Tool::select});
        if (i % 40 == 0)
            editor.run(Command(draw_shape_spec(static_cast<ShapeKind>(i / 40 % 9)),
                               draw_shape_spec(static_cast<ShapeKind>(i / 40 % 9)).run.make()));
        const auto points = state().active_curve()->control_points();
        const core::Point grabbed = points[random() % points.size()];
        pointer.modifiers = {random() % 8 == 0, random() % 8 == 0, random() % 8 == 0};
        pointer.press(render::screen_from_world(state().view.camera, grabbed));
        pointer.move(place());
        for (unsigned k = random() % 4; k > 0 && i % 3 == 0; --k)
            key(characters[random() % characters.size()], Key::none);
        if (i % 6 == 0) key(0, random() % 2 == 0 ? Key::tab : Key::backspace);
        if (i % 3 == 0) key(0, Key::enter);
        pointer.release(place());
        if (random() % 16 == 0) pointer.escape(place());
        for (const core::DocumentCurve& item : state().shown().curves)
            for (const core::Point point : item.curve->control_points()) ASSERT_TRUE(core::is_finite(point));
    }
    pointer.escape(place());
    EXPECT_GT(steps(), 150U);
    while (steps() > 0) editor.run(Undo{});
    EXPECT_TRUE(is_same_document(state().history.present(), first));
}

// A million points and a thousand curves, all within reach.
TEST(SnapAt, costs_little_however_much_there_is) {
    core::Document document;
    std::vector<core::Point> points;
    for (int i = 0; i < 1'000'000; ++i) points.emplace_back(1e-5 * i, std::sin(1e-3 * i));
    const auto add = [&](std::vector<core::Point> of) {
        const std::size_t count = of.size();
        document.curves.emplace_back().curve = std::make_shared<const core::Curve>(
            core::Curve::make(core::make_knots(core::KnotKind::clamped_uniform, 3, count).value(), std::move(of), {})
                .value());
    };
    add(std::move(points));
    for (int k = 0; k < 1000; ++k) add({{0.0, 0.01 * k}, {3.0, 0.0}, {6.0, 0.01 * k}, {9.0, 0.3}});
    Editor editor(document);
    for (const auto& kind : core::Names<SnapKind>::table) editor.run(SetSnap{.kind = kind.value, .on = true});
    for (const double scale : {64.0, 1.0, 1e-3}) {
        EditorState state = editor.state();
        state.view.camera.scale = scale;
        static_cast<void>(snap_at(state, {.place = {5.0, 0.0}, .from = core::Point(0.0, 2.0)}));
        const auto begin = std::chrono::steady_clock::now();
        constexpr int times = 10;
        for (int i = 0; i < times; ++i)
            static_cast<void>(snap_at(state, {.place = {5.0 + 1e-3 * i, 0.0}, .from = core::Point(0.0, 2.0)}));
        const double each = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() / times;
        RecordProperty(scale == 64.0 ? "near" : scale == 1.0 ? "half" : "far", std::to_string(each));
        EXPECT_LT(each, 0.5) << scale;  // without optimization, on a busy machine
    }
}

}  // namespace
}  // namespace batten::editor
