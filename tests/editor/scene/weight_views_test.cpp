/// What the views of weights say and draw.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "app/editor/cards/weight_cards.h"
#include "app/editor/derived/active_conic.h"
#include "app/editor/derived/lifted_stage.h"
#include "app/editor/scene/insets.h"
#include "core/evaluate/farin_points.h"
#include "tests/editor/card_words.h"
#include "tests/editor/pointer_driver.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using render::MarkerShape;

constexpr double half_root = 0.7071067811865476;

EditorState conic_state(std::vector<double> weights, std::vector<core::Point> points = {{3, 0}, {3, 3}, {0, 3}}) {
    EditorState state = test::scene_state(
        {.degree = 2, .knots = {0, 0, 0, 1, 1, 1}, .points = std::move(points), .weights = std::move(weights)});
    state.view.camera.center = {1.5, 1.5};
    state.view.overlays.show(Overlay::conic, true);
    return state;
}

EditorState circle_state() {
    return test::scene_state({.degree = 2,
                              .knots = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1},
                              .points = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
                              .weights = {1, half_root, 1, half_root, 1, half_root, 1, half_root, 1}});
}

using test::says;

using test::screen;

bool has_marker_at(const render::DrawList& list, glm::dvec2 place) {
    return std::ranges::any_of(test::all_of<render::Marker>(list), [&](const render::Marker& marker) {
        return glm::distance(glm::dvec2(marker.center), place) < 0.01;
    });
}

TEST(ActiveConic, names_the_ends_of_its_piece) {
    const auto arc = active_conic(*circle_state().active_curve(), 0.6).value();
    EXPECT_EQ(arc.corner, 5U);
    EXPECT_TRUE(arc.has_own_ends);
    EXPECT_EQ(arc.names, (std::array<std::string, 3>{"P_{4}", "P_{5}", "P_{6}"}));
    const EditorState uniform =
        test::scene_state({.degree = 2, .knots = {0, 1, 2, 3, 4, 5, 6}, .points = {{0, 0}, {1, 2}, {3, 2}, {4, 0}}});
    const auto piece = active_conic(*uniform.active_curve(), 2.5).value();
    EXPECT_FALSE(piece.has_own_ends);
    EXPECT_EQ(piece.corner, 1U);
    EXPECT_EQ(piece.names[1], "P_{1}");
    EXPECT_EQ(piece.names[0].substr(0, 3), "C(2");
}

TEST(ConicCard, tells_kind_ratio_and_angle) {
    const Card circle = conic_card(conic_state({1, half_root, 1}));
    EXPECT_TRUE(says(circle, "Circle: w = √2/2 is sin a")) << card_text(circle);
    EXPECT_TRUE(says(circle, "|MX| / |MP₁| = w / (1 + w) = 0.4142")) << card_text(circle);
    EXPECT_TRUE(says(circle, "a = 45°, sin a = √2/2"));
    EXPECT_TRUE(says(circle, "180° − 2a = 90°"));
    const Card ellipse = conic_card(conic_state({1, 0.5, 1}));
    EXPECT_TRUE(says(ellipse, "Ellipse: w = 1/2 is less than 1")) << card_text(ellipse);
    EXPECT_TRUE(says(ellipse, "= w / (1 + w) = 1/3")) << card_text(ellipse);
    EXPECT_TRUE(says(conic_card(conic_state({1, 1, 1})), "Parabola: w = 1"));
    EXPECT_TRUE(says(conic_card(conic_state({1, 2, 1})), "Hyperbola: w = 2 is more than 1"));
    EXPECT_TRUE(says(conic_card(conic_state({1, 2, 1})), "= w / (1 + w) = 2/3"));
}

TEST(ConicCard, tells_standard_weight_and_unequal_legs) {
    const Card standard = conic_card(conic_state({4, 1, 1}));
    EXPECT_TRUE(says(standard, "w = w₁ / √(w₀ w₂) = 1/2")) << card_text(standard);
    const Card unequal = conic_card(conic_state({1, 1, 1}, {{4, 0}, {4, 3}, {0, 3}}));
    EXPECT_TRUE(says(unequal, "No weight makes a circle: |P₀P₁| = 3 and |P₁P₂| = 4 differ.")) << card_text(unequal);
    EXPECT_FALSE(says(unequal, "Circle"));
}

TEST(ConicCard, says_why_there_is_none) {
    const Card cubic = conic_card(test::sample_state());
    EXPECT_TRUE(says(cubic, "this curve has degree 3"));
    EXPECT_TRUE(says(cubic, "Example"));
    EXPECT_TRUE(says(conic_card(conic_state({1, 1, 1}, {{0, 0}, {1, 1}, {2, 2}})), "it is straight"));
    EXPECT_TRUE(says(conic_card(EditorState()), "no curve"));
}

TEST(ConicCard, buttons_make_every_kind) {
    Editor editor;
    editor.run(NewCurve{.points = {{3, 0}, {3, 3}, {0, 3}}, .degree = 2});
    const auto press = [&](std::size_t index) {
        for (const CardBlock& block : conic_card(editor.state()).blocks)
            if (const auto* row = std::get_if<CardButtons>(&block)) {
                EXPECT_TRUE(editor.run(row->buttons.at(index).command)) << editor.state().message.text;
            }
        return active_conic(*editor.state().active_curve(), 0.5).value().arc.kind;
    };
    EXPECT_EQ(press(0), core::ConicKind::circle);
    EXPECT_EQ(press(1), core::ConicKind::ellipse);
    EXPECT_EQ(press(2), core::ConicKind::parabola);
    EXPECT_EQ(press(3), core::ConicKind::hyperbola);
}

TEST(ConicScene, marks_middle_and_shoulder) {
    const EditorState state = conic_state({1, 0.5, 1});
    const render::DrawList list = test::canvas_picture(state);
    EXPECT_TRUE(has_marker_at(list, screen(state, {1.5, 1.5})));
    EXPECT_TRUE(has_marker_at(list, screen(state, {2, 2})));
    for (const char* name : {"M", "X", "a"}) EXPECT_TRUE(test::has_text(list, name)) << name;
}

// The rest of the circle, opposite to the arc, is drawn and nothing of it when the view is off.
TEST(ConicScene, draws_the_conic_beyond_the_arc) {
    EditorState state = conic_state({1, half_root, 1});
    state.view.camera.center = {0, 0};
    const glm::dvec2 opposite = screen(state, {-3 * half_root, -3 * half_root});
    const auto lines = [&] { return test::all_of<render::Polyline>(test::canvas_picture(state)); };
    const auto near = [&](const std::vector<render::Polyline>& all) {
        std::vector<render::Polyline> wide;
        for (const render::Polyline& line : all)
            if (line.width_px == 2.0F) wide.push_back(line);
        return !wide.empty() && test::distance_to(wide, opposite) < 0.3;
    };
    EXPECT_TRUE(near(lines()));
    state.view.overlays.show(Overlay::conic, false);
    EXPECT_FALSE(near(lines()));
}

TEST(FarinScene, draws_a_square_on_every_leg) {
    EditorState state = conic_state({1, 3, 1});
    state.view.overlays.show(Overlay::conic, false);
    state.view.overlays.show(Overlay::farin_points, true);
    const render::DrawList list = test::canvas_picture(state);
    const auto squares = test::markers_of(list, MarkerShape::square, 4.5F);
    ASSERT_EQ(squares.size(), 2U);
    EXPECT_LT(glm::distance(glm::dvec2(squares[0].center), screen(state, {3, 2.25})), 0.01);
    EXPECT_LT(glm::distance(glm::dvec2(squares[1].center), screen(state, {2.25, 3})), 0.01);
    EXPECT_TRUE(test::has_text(list, "F_{0}"));
    EXPECT_TRUE(test::has_text(list, "F_{1}"));
}

TEST(FarinScene, is_no_more_work_for_many_points) {
    EditorState state = test::scene_state({.degree = 1,
                                           .knots =
                                               [] {
                                                   std::vector<double> knots{0};
                                                   for (int i = 0; i < 10000; ++i) knots.push_back(i);
                                                   knots.push_back(9999);
                                                   return knots;
                                               }(),
                                           .points = test::scattered_points(10000, {10.0, 6.0})});
    state.view.overlays.show(Overlay::farin_points, true);
    EXPECT_TRUE(test::markers_of(test::canvas_picture(state), MarkerShape::square, 4.5F).empty());
    state.view.camera.scale = 20000.0;
    state.view.camera.center = core::farin_point(*state.active_curve(), 77).point;
    EXPECT_FALSE(test::markers_of(test::canvas_picture(state), MarkerShape::square, 4.5F).empty());
}

TEST(FarinCard, tells_the_ratios) {
    const Card card = farin_card(conic_state({1, 0.5, 1}));
    EXPECT_TRUE(says(card, "F₀ | w₁ : w₀ = 1/2 : 1 | 1/3")) << card_text(card);
    EXPECT_TRUE(says(card, "F₁ | w₂ : w₁ = 1 : 1/2 | 2/3")) << card_text(card);
    EXPECT_TRUE(says(card, "the other Farin points stay"));
    EXPECT_TRUE(says(farin_card(test::scene_state(test::closed_cubic())), "around a closed curve"));
}

class HomogeneousScene : public testing::Test {
  protected:
    HomogeneousScene() { state.view.overlays.show(Overlay::homogeneous, true); }
    LiftedStage stage() const { return lifted_stage(state, inset_box(state, Overlay::homogeneous).value()); }

    EditorState state = circle_state();
};

TEST_F(HomogeneousScene, shows_points_lifted_and_as_shadows) {
    const render::DrawList list = test::canvas_picture(state);
    const LiftedStage seen = stage();
    EXPECT_EQ(seen.view.exponent, 1.0);
    const auto curve = state.active_curve();
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_TRUE(has_marker_at(list, seen.screen(curve->control_points()[i], curve->weights()[i]))) << i;
        EXPECT_TRUE(has_marker_at(list, seen.screen(curve->control_points()[i], 1.0))) << i;
    }
    EXPECT_TRUE(test::has_text(list, "w = 1"));
}

// Shadow, lifted point and origin are on one line on the screen, from wherever they are seen.
TEST_F(HomogeneousScene, keeps_lifted_points_on_their_rays) {
    for (const Orbit orbit : {Orbit{}, Orbit{1.2, 0.1, 1.0}, Orbit{-2.0, 1.1, 3.0}}) {
        state.view.orbit = orbit;
        const LiftedStage seen = stage();
        const glm::dvec2 origin = render::screen_from_space(seen.camera, {0, 0, 0});
        const glm::dvec2 a = seen.screen({1, 1}, 1.0) - origin;
        const glm::dvec2 b = seen.screen({1, 1}, 0.6) - origin;
        EXPECT_NEAR(a.x * b.y - a.y * b.x, 0.0, 1e-9);
        EXPECT_NEAR(glm::length(b) / glm::length(a), 0.6, 1e-12);
    }
}

TEST_F(HomogeneousScene, shows_all_of_it_in_its_box) {
    const render::PixelBox box = inset_box(state, Overlay::homogeneous).value();
    for (double yaw = -3.0; yaw < 3.2; yaw += 0.4)
        for (double pitch = -1.5; pitch < 1.6; pitch += 0.5) {
            state.view.orbit = {yaw, pitch, 1.0};
            const LiftedStage seen = stage();
            for (std::size_t i = 0; i < 9; ++i)
                EXPECT_TRUE(box.contains(
                    seen.screen(state.active_curve()->control_points()[i], state.active_curve()->weights()[i])));
            EXPECT_TRUE(box.contains(render::screen_from_space(seen.camera, {0, 0, 0})));
        }
}

TEST_F(HomogeneousScene, draws_no_lines_outside_of_its_box) {
    state.view.orbit.zoom = 8.0;
    const render::PixelBox box = inset_box(state, Overlay::homogeneous).value();
    for (const render::Polyline& line :
         test::lines_of(test::canvas_picture(state), theme_of(ThemeName::dark).level(2), 3.0F))
        for (const render::Pixel point : line.points) EXPECT_TRUE(box.contains(glm::dvec2(point)));
}

TEST_F(HomogeneousScene, survives_the_worst_curves) {
    const double far = 1e6;
    std::vector<core::CurveDefinition> worst;
    worst.push_back({.degree = 2,
                     .knots = {0, 0, 0, 1, 1, 1},
                     .points = {{far, far}, {far, far}, {far, far}},
                     .weights = {1e-300, 1e300, 1}});
    worst.push_back({.degree = 2,
                     .knots = {0, 0, 0, 1, 1, 1},
                     .points = {{-1.5e308, 0}, {1.5e308, 1}, {0, 1e308}},
                     .weights = {1e-3, 1e3, 1}});
    core::CurveDefinition high{.degree = 25, .knots = std::vector<double>(26, 0.0)};
    high.knots.insert(high.knots.end(), 26, 1.0);
    high.points = test::scattered_points(26, {10.0, 6.0});
    for (int i = 0; i < 26; ++i) high.weights.push_back(std::pow(10.0, i % 7 - 3));
    worst.push_back(high);
    core::CurveDefinition closed = test::closed_cubic();
    closed.weights = {1, 2, 1e3, 1, 0.5, 1e-3};
    worst.push_back(closed);
    for (const core::CurveDefinition& definition : worst) {
        SCOPED_TRACE(definition.points.front().x);
        EditorState shown = test::scene_state(definition);
        for (const Overlay view : {Overlay::homogeneous, Overlay::conic, Overlay::farin_points})
            shown.view.overlays.show(view, true);
        EXPECT_EQ(test::faults_of(test::canvas_picture(shown), shown.view.camera.size_px, 100.0),
                  std::vector<std::string>{});
        for (const auto& make : {farin_card, conic_card, homogeneous_card})
            EXPECT_EQ(card_text(make(shown)).find("nan"), std::string::npos);
    }
}

TEST(HomogeneousCard, tells_what_points_are_lifted_to) {
    const Card card = homogeneous_card(conic_state({1, 0.5, 1}));
    EXPECT_TRUE(says(card, "P₁ | 1/2 | (3/2, 3/2, 1/2)")) << card_text(card);
    EXPECT_TRUE(says(card, "parabola in space"));
    EXPECT_TRUE(says(homogeneous_card(conic_state({2, 2, 2})), "in a plane of its own beside w = 1"));
    EXPECT_TRUE(says(homogeneous_card(conic_state({1, 1, 1})), "lies in the plane w = 1"));
    EXPECT_TRUE(says(homogeneous_card(conic_state({1e-3, 1e3, 1})), "w to the power 0.16"));
}

}  // namespace
}  // namespace batten::editor
