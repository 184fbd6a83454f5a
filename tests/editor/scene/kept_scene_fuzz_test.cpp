/// Pictures of dense curves in random sessions, beside pictures with nothing kept.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "app/editor/commands/point_commands.h"
#include "app/editor/editor.h"
#include "app/editor/scene/canvas_scene.h"
#include "core/curve/knot_kinds.h"
#include "tests/editor/random_session.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

core::DocumentCurve scattered(std::size_t count, double width) {
    std::vector<core::Point> points = test::scattered_points(count, {width, 7.0});
    const auto knots = core::make_knots(core::KnotKind::clamped_uniform, 3, count).value();
    core::DocumentCurve item;
    item.name = std::to_string(count);
    item.curve = std::make_shared<const core::Curve>(core::Curve::make(knots, std::move(points), {}).value());
    return item;
}

// Two curves, whose lines are inked in a small picture.
core::Document dense_document() {
    core::Document document;
    document.curves = {scattered(700, 12.0), scattered(500, 8.0)};
    document.curves.back().color = core::DocumentColor{200, 40, 40};
    return document;
}

// All ink of the picture, one over the other.
std::vector<glm::vec3> composed(const render::DrawList& list, glm::ivec2 size) {
    std::vector<glm::vec3> pixels(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (const render::Ink& ink : test::all_of<render::Ink>(list)) {
        const glm::vec3 color(ink.color.red, ink.color.green, ink.color.blue);
        const auto values = ink.map->values();
        EXPECT_EQ(values.size(), pixels.size());
        for (std::size_t i = 0; i < std::min(values.size(), pixels.size()); ++i)
            pixels[i] = glm::mix(pixels[i], color, static_cast<float>(values[i]) / 255.0F);
    }
    return pixels;
}

// How many pixels differ by more than the rounding of a few layers.
std::size_t difference(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const glm::vec3 apart = glm::abs(a[i] - b[i]);
        if (std::max({apart.x, apart.y, apart.z}) > 10.0F) ++count;
    }
    return count;
}

// Random requests, between which a point is dragged and the view is moved.
Request next_request(RandomSession& session, const EditorState& state, int step) {
    const auto curve = state.active_curve();
    if (step % 4 == 1 && curve != nullptr)
        return CommandRequest{
            MovePoints{.points = {static_cast<std::size_t>(step / 12)}, .offset = {0.1 * (step % 5), 0.1}},
            step % 12 == 1 ? Phase::commit : Phase::preview};
    if (step % 4 == 3) return ViewChange(PanCamera{{3.0 * (step % 7), -4.0}});
    return session.next(state);
}

TEST(KeptSceneFuzz, random_sessions_look_as_with_nothing_kept) {
    std::size_t inks = 0;
    for (unsigned seed = 1; seed <= 2; ++seed) {
        Editor editor(dense_document());
        editor.change(ResizeCanvas{{500.0, 300.0}});
        SceneCache cache;
        RandomSession session(seed);
        for (int step = 0; step < 16; ++step) {
            editor.perform(next_request(session, editor.state(), step));
            SCOPED_TRACE(::testing::Message() << "seed " << seed << ", step " << step);
            const auto kept = canvas_scene(editor.state(), CanvasIdle{}, cache);
            const auto anew = test::canvas_picture(editor.state());
            const glm::ivec2 size(glm::ceil(editor.state().view.camera.size_px));
            EXPECT_EQ(difference(composed(kept, size), composed(anew, size)), 0U);
            EXPECT_EQ(test::all_of<render::Polyline>(kept).size(), test::all_of<render::Polyline>(anew).size());
            EXPECT_EQ(test::all_of<render::Marker>(kept).size(), test::all_of<render::Marker>(anew).size());
            EXPECT_EQ(test::texts_of(kept), test::texts_of(anew));
            inks += test::all_of<render::Ink>(kept).size();
        }
    }
    EXPECT_GT(inks, 50U) << "the pictures are dense";
}

}  // namespace
}  // namespace batten::editor
