#include "app/editor/pointer/weight_modes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/command_spec.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/weight_commands.h"
#include "app/editor/derived/lifted_stage.h"
#include "app/editor/pointer/hit_test.h"
#include "app/editor/scene/insets.h"
#include "tests/editor/canvas_fixture.h"

namespace batten::editor {
namespace {

using test::px;

/// The conic (-3,-2) (-3,2) (3,2) with the weights 1, 2, 1, with the views of weights.
class WeightModes : public testing::Test {
  protected:
    WeightModes() {
        editor.run(NewCurve{.points = {{-3, -2}, {-3, 2}, {1, 2}}, .degree = 2});
        editor.run(SetWeight{.index = 1, .weight = 2.0});
        editor.run(SetParameter{.u = 0.5});
        first_steps = editor.state().history.undo_count();
    }
    void show(Overlay overlay) {
        editor.run(Command(toggle_overlay_spec(overlay), toggle_overlay_spec(overlay).run.make()));
    }
    const EditorState& state() const { return editor.state(); }
    double weight(std::size_t i) const { return test::committed(editor).weights()[i]; }
    std::size_t steps() const { return state().history.undo_count() - first_steps; }
    LiftedStage stage() const { return lifted_stage(state(), inset_box(state(), Overlay::homogeneous).value()); }
    glm::dvec2 lifted(std::size_t i) const {
        return stage().screen(test::committed(editor).control_points()[i], weight(i));
    }

    Editor editor;
    std::size_t first_steps = 0;
    test::CanvasPointer pointer{editor, test::CanvasStep{}};
};

TEST_F(WeightModes, farin_points_are_hit_while_they_are_shown) {
    // F_0 divides the first leg 2 : 1, in (-3, 2/3).
    EXPECT_FALSE(std::holds_alternative<HoveredFarinPoint>(hit_canvas(state(), px(-3, 2.0 / 3.0))));
    show(Overlay::farin_points);
    EXPECT_EQ(hit_canvas(state(), px(-3, 2.0 / 3.0)), Hover{HoveredFarinPoint{0}});
    EXPECT_EQ(hit_canvas(state(), px(-3 + 4.0 / 3.0, 2)), Hover{HoveredFarinPoint{1}});
}

TEST_F(WeightModes, a_farin_point_is_dragged_along_its_leg_in_one_step) {
    show(Overlay::farin_points);
    // To the middle of the leg, with the pointer beside it.
    pointer.drag(px(-3, 2.0 / 3.0), px(-1, 0));
    EXPECT_DOUBLE_EQ(weight(0), 1.0);
    EXPECT_NEAR(weight(1), 1.0, 1e-12);
    EXPECT_NEAR(weight(2), 0.5, 1e-12);
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(state().history.undo_label(), "Move Farin point between P₀ and P₁");
    editor.run(Undo{});
    EXPECT_EQ(weight(1), 2.0);
}

TEST_F(WeightModes, control_keeps_a_farin_point_to_twelfths) {
    show(Overlay::farin_points);
    pointer.modifiers = test::ctrl;
    pointer.drag(px(-3, 2.0 / 3.0), px(-3, 1.05));
    EXPECT_NEAR(weight(1), 3.0, 1e-12) << "three quarters of the leg";
}

TEST_F(WeightModes, escape_restores_a_dragged_farin_point) {
    show(Overlay::farin_points);
    pointer.press(px(-3, 2.0 / 3.0));
    pointer.move(px(-3, 0));
    EXPECT_TRUE(state().preview.has_value());
    pointer.escape(px(-3, 0));
    EXPECT_FALSE(state().preview.has_value());
    EXPECT_EQ(steps(), 0U);
}

TEST_F(WeightModes, a_lifted_point_is_dragged_along_its_ray_in_one_step) {
    show(Overlay::homogeneous);
    const glm::dvec2 start = lifted(1);
    EXPECT_EQ(hit_canvas(state(), start), (Hover{HoveredLifted{1}}));
    const glm::dvec2 target = stage().screen({-3, 2}, 0.5);
    pointer.drag(start, target);
    EXPECT_NEAR(weight(1), 0.5, 1e-9);
    EXPECT_EQ(weight(0), 1.0);
    EXPECT_EQ(steps(), 1U);
    EXPECT_EQ(state().selection.points, std::vector<std::size_t>{1});
}

TEST_F(WeightModes, a_lifted_point_stays_above_the_origin) {
    show(Overlay::homogeneous);
    const glm::dvec2 start = lifted(1);
    const glm::dvec2 origin = render::screen_from_space(stage().camera, {0, 0, 0});
    pointer.drag(start, origin + (origin - start));
    EXPECT_EQ(weight(1), 1e-6);
}

TEST_F(WeightModes, a_lifted_point_is_caught_by_the_plane) {
    show(Overlay::homogeneous);
    pointer.drag(lifted(1), stage().screen({-3, 2}, 1.0) + glm::dvec2(1.0, 1.0));
    EXPECT_EQ(weight(1), 1.0);
}

TEST_F(WeightModes, dragging_beside_the_points_turns_the_view_without_a_step) {
    show(Overlay::homogeneous);
    const render::PixelBox box = inset_box(state(), Overlay::homogeneous).value();
    const Orbit before = state().view.orbit;
    const glm::dvec2 corner = box.lower_px + glm::dvec2(20.0, 40.0);
    EXPECT_EQ(hit_canvas(state(), corner), (Hover{HoveredLifted{}}));
    pointer.drag(corner, corner + glm::dvec2(50.0, 20.0));
    EXPECT_NEAR(state().view.orbit.yaw, before.yaw - 0.5, 1e-12);
    EXPECT_NEAR(state().view.orbit.pitch, before.pitch + 0.2, 1e-12);
    EXPECT_EQ(steps(), 0U);
    const double scale = state().view.camera.scale;
    pointer.send(PointerAction::wheel, corner, 2.0);
    EXPECT_GT(state().view.orbit.zoom, 1.2);
    EXPECT_EQ(state().view.camera.scale, scale);
}

TEST_F(WeightModes, the_orbit_is_set_by_a_command) {
    EXPECT_TRUE(editor.run(SetOrbit{.yaw = 450.0, .pitch = 90.0, .zoom = 1e9}));
    EXPECT_NEAR(state().view.orbit.yaw, 0.5 * M_PI, 1e-12);
    EXPECT_NEAR(state().view.orbit.pitch, 0.5 * M_PI, 1e-12);
    EXPECT_EQ(state().view.orbit.zoom, orbit_zooms.upper);
}

TEST_F(WeightModes, weights_of_circle_and_parabola_are_caught_while_the_conic_is_shown) {
    const double circle = std::sqrt(0.5);
    EXPECT_EQ(caught_weight(state(), 1, 1.01), 1.01);
    show(Overlay::conic);
    EXPECT_EQ(caught_weight(state(), 1, 1.01), 1.0);
    EXPECT_EQ(caught_weight(state(), 1, 0.98), 1.0);
    EXPECT_EQ(caught_weight(state(), 1, 1.1), 1.1);
    EXPECT_DOUBLE_EQ(caught_weight(state(), 1, 0.72), circle);
    EXPECT_EQ(caught_weight(state(), 0, 1.01), 1.01) << "only the corner decides the kind";
}

}  // namespace
}  // namespace batten::editor
