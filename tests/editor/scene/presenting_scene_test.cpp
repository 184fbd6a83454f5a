/// Pictures for a projector: everything at least half as large again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

/// The sample with every view, in a canvas of one size or half as large again.
EditorState shown(double scale) {
    EditorState state = test::sample_state();
    for (std::size_t i = 0; i < overlay_count; ++i) state.view.overlays.show(static_cast<Overlay>(i), true);
    state.view.interface_scale = scale;
    state.view.camera.size_px *= scale;
    state.view.camera.scale *= scale;
    return state;
}

/// How thick and how large everything is, ascending and without repeats.
std::vector<double> sizes_of(const render::DrawList& list) {
    std::vector<double> sizes;
    const auto add = [&](float size) { sizes.push_back(std::round(1000.0 * size) / 1000.0); };
    for (const auto& line : test::all_of<render::Polyline>(list)) add(line.width_px);
    for (const auto& marker : test::all_of<render::Marker>(list)) {
        add(marker.radius_px);
        add(marker.outline_px);
    }
    for (const auto& label : test::all_of<render::Label>(list)) add(label.size_px);
    std::ranges::sort(sizes);
    sizes.erase(std::ranges::unique(sizes).begin(), sizes.end());
    return sizes;
}

void expect_half_as_large_again(const render::DrawList& usual, const render::DrawList& presented) {
    const std::vector<double> before = sizes_of(usual);
    const std::vector<double> sizes = sizes_of(presented);
    ASSERT_EQ(sizes.size(), before.size());
    ASSERT_GE(sizes.size(), 8U);
    for (std::size_t i = 0; i < sizes.size(); ++i) EXPECT_NEAR(sizes[i], 1.5 * before[i], 2e-3) << i;
}

TEST(PresentingScene, lines_marks_and_texts_of_the_canvas_are_half_as_large_again) {
    EXPECT_EQ(presenting_scale, 1.5);
    expect_half_as_large_again(test::canvas_picture(shown(1.0)), test::canvas_picture(shown(presenting_scale)));
}

TEST(PresentingScene, lines_marks_and_texts_of_the_plot_are_half_as_large_again) {
    expect_half_as_large_again(test::plot_picture(shown(1.0), PlotIdle{}, {900, 300}),
                               test::plot_picture(shown(presenting_scale), PlotIdle{}, {1350, 450}));
}

TEST(PresentingScene, is_drawn_in_colors_of_high_contrast) {
    const Theme theme = high_contrast(ThemeName::dark);
    EditorState state = shown(presenting_scale);
    state.view.is_presenting = true;
    const auto lines = test::all_of<render::Polyline>(test::canvas_picture(state));
    const auto has = [&](render::Color color) {
        return std::ranges::any_of(lines, [&](const render::Polyline& line) { return line.color == color; });
    };
    EXPECT_TRUE(has(theme.curve));
    EXPECT_TRUE(has(theme.polygon));
    EXPECT_FALSE(has(theme_of(ThemeName::dark).curve));
    EXPECT_FALSE(has(theme_of(ThemeName::dark).polygon));
}

}  // namespace
}  // namespace batten::editor
