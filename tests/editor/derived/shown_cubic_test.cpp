#include "app/editor/derived/shown_cubic.h"

#include <gtest/gtest.h>

#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

core::CurveDefinition coons() {
    return {.degree = 3,
            .knots = {-3, -2, -1, 0, 1, 2, 3, 4, 5},
            .points = {{0, 0}, {6, 18}, {24, 18}, {30, -6}, {42, 12}}};
}

core::CurveDefinition ring() {
    return {.degree = 3, .knots = {0, 2, 4, 6, 8}, .points = {{0, 0}, {12, 0}, {12, 12}, {0, 12}}, .periodic = true};
}

TEST(ShownCubic, tells_what_a_curve_lacks) {
    const EditorState empty;
    EXPECT_EQ(cubic_lack(empty), CubicLack::curve);
    EXPECT_EQ(cubic_lack(test::scene_state(coons())), std::nullopt);
    EXPECT_EQ(cubic_lack(test::scene_state(ring())), std::nullopt);
    EXPECT_EQ(cubic_lack(test::sample_state()), CubicLack::knots) << "degree 3, clamped, with a weight of 2";
    core::CurveDefinition changed = coons();
    changed.weights = {1, 1, 3, 1, 1};
    EXPECT_EQ(cubic_lack(test::scene_state(changed)), CubicLack::weights);
    changed.weights = {3, 3, 3, 3, 3};
    EXPECT_EQ(cubic_lack(test::scene_state(changed)), std::nullopt) << "equal weights are none";
    changed = ring();
    changed.knots = {0, 2, 4, 7, 8};
    EXPECT_EQ(cubic_lack(test::scene_state(changed)), CubicLack::knots);
    changed = coons();
    changed.degree = 2;
    changed.knots.pop_back();
    EXPECT_EQ(cubic_lack(test::scene_state(changed)), CubicLack::degree);
    EditorState hidden = test::scene_state(coons());
    core::Document document = hidden.history.present();
    document.curves[0].visible = false;
    hidden.preview = document;
    EXPECT_EQ(cubic_lack(hidden), CubicLack::curve);
}

TEST(ShownCubic, is_the_segment_at_the_parameter) {
    EditorState state = test::scene_state(coons());
    state.view.parameter = 1.25;
    const ShownCubic cubic = shown_cubic(state);
    EXPECT_EQ(cubic.segment, 1u);
    EXPECT_EQ(cubic.segment_count, 2u);
    EXPECT_EQ(cubic.t, 0.25);
    EXPECT_EQ(cubic.points, (std::array<std::size_t, 4>{1, 2, 3, 4}));
    EXPECT_EQ(cubic.start.index, 2u);
    EXPECT_EQ(cubic.start.anticentroid, core::Point(22, 14));
    EXPECT_EQ(cubic.end.index, 3u);
    EXPECT_EQ(cubic.end.anticentroid, core::Point(31, 1));
    state.view.parameter = 2.0;
    EXPECT_EQ(shown_cubic(state).t, 1.0) << "the end belongs to the last segment";
}

TEST(ShownCubic, counts_points_past_the_seam) {
    EditorState state = test::scene_state(ring());
    state.view.parameter = 7.0;
    const ShownCubic cubic = shown_cubic(state);
    EXPECT_EQ(cubic.segment, 3u);
    EXPECT_EQ(cubic.t, 0.5);
    EXPECT_EQ(cubic.points, (std::array<std::size_t, 4>{3, 0, 1, 2}));
    EXPECT_EQ(cubic.start.anticentroid, core::Point(2, 2));
    EXPECT_EQ(cubic.end.anticentroid, core::Point(10, 2));
}

TEST(ShownCubic, looks_at_what_the_user_points_at) {
    EditorState state = test::scene_state(coons());
    state.view.parameter = 0.25;
    EXPECT_EQ(shown_cubic(state).focus.index, 1u) << "4 of 6 parts at t = 0, more than the third point up to 1/2";
    state.view.parameter = 0.75;
    EXPECT_EQ(shown_cubic(state).focus.index, 2u);
    state.selection.points = {3};
    EXPECT_EQ(shown_cubic(state).focus.index, 3u);
    state.hover = HoveredPoint{1};
    EXPECT_EQ(shown_cubic(state).focus.index, 1u);
    state.hover = HoveredPoint{4};
    EXPECT_EQ(shown_cubic(state).focus.index, 3u) << "the last point has no joint";
    state.selection.points = {1, 3};
    EXPECT_EQ(shown_cubic(state).focus.index, 2u);
}

}  // namespace
}  // namespace batten::editor
