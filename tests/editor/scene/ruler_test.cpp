#include "app/editor/scene/ruler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/editor/pointer/grid_step.h"
#include "app/editor/scene/grid_number.h"
#include "app/editor/scene/text_size.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

using core::LengthUnit;

/// 1000 x 600 pixels, at `scale` pixels a unit of the world, with the middle at `center`.
EditorState ruled_state(double scale, core::Point center = {0, 0}, const Units& units = std::nullopt) {
    EditorState state = test::sample_state();
    core::Document document = state.history.present();
    document.units = units;
    state.history = History(document);
    state.view.camera = {.center = center, .scale = scale, .size_px = {1000.0, 600.0}};
    state.view.overlays.show(Overlay::rulers, true);
    return state;
}

const RulerTick& tick_of(const std::vector<RulerTick>& ticks, const std::string& label) {
    for (const RulerTick& tick : ticks)
        if (tick.label == label) return tick;
    ADD_FAILURE() << label;
    return ticks.front();
}

TEST(Ruler, has_round_numbers_where_they_are) {
    // 100 px a unit: the picture shows x from -5 to 5, and y from -3 at its foot to 3 at its top.
    const EditorState state = ruled_state(100.0);
    const auto x = ruler_ticks(state, RulerAxis::x);
    EXPECT_DOUBLE_EQ(tick_of(x, "0").place_px, 500.0);
    EXPECT_DOUBLE_EQ(tick_of(x, "3").place_px, 800.0);
    EXPECT_DOUBLE_EQ(tick_of(x, "−4").place_px, 100.0);
    const auto y = ruler_ticks(state, RulerAxis::y);
    EXPECT_DOUBLE_EQ(tick_of(y, "0").place_px, 300.0);
    EXPECT_DOUBLE_EQ(tick_of(y, "2").place_px, 100.0);
    EXPECT_DOUBLE_EQ(tick_of(y, "−1").place_px, 400.0);
}

TEST(Ruler, counts_in_the_unit_of_the_document) {
    // 2 of the world are a millimeter, so a millimeter is 100 px, and the middle is at 10 mm.
    const EditorState state = ruled_state(50.0, {20, 0}, core::DocumentUnits{.unit = LengthUnit::mm, .scale = 2.0});
    const auto x = ruler_ticks(state, RulerAxis::x);
    EXPECT_DOUBLE_EQ(tick_of(x, "10").place_px, 500.0);
    EXPECT_DOUBLE_EQ(tick_of(x, "11").place_px, 600.0);
    EXPECT_EQ(ruler_corner(state), "mm");
    EXPECT_EQ(ruler_corner(ruled_state(50.0)), "");
}

TEST(Ruler, divides_inches_by_halves) {
    const Units inches = core::DocumentUnits{.unit = LengthUnit::inch, .scale = 96.0};
    // At 4 px a pixel an inch has 384 px; a quarter is 96 px.
    const auto x = ruler_ticks(ruled_state(4.0, {0, 0}, inches), RulerAxis::x);
    EXPECT_DOUBLE_EQ(tick_of(x, "1/4").place_px, 596.0);
    EXPECT_DOUBLE_EQ(tick_of(x, "−1/2").place_px, 308.0);
    EXPECT_DOUBLE_EQ(tick_of(x, "1").place_px, 884.0);
    EXPECT_DOUBLE_EQ(tick_of(x, "−1 1/4").place_px, 20.0);
    EXPECT_EQ(canvas_grid_steps(ruled_state(4.0, {0, 0}, inches)), (GridSteps{24.0, 6.0, 3.0}));
    EXPECT_EQ(inch_grid_steps(10.0), decimal_grid_steps(10.0));
    EXPECT_EQ(inch_grid_steps(80.0), (GridSteps{1.0, 0.25, 0.125}));
    EXPECT_EQ(inch_grid_steps(1280.0), (GridSteps{0.0625, 0.015625, 0.0078125}));
    EXPECT_EQ(grid_number_text(-2.75, 0.25, inches), "−2 3/4");
    EXPECT_EQ(grid_number_text(0.0078125, 0.0078125, inches), "1/128");
}

TEST(Ruler, has_steps_that_are_parts_of_each_other) {
    for (double scale = 1e-6; scale < 1e9; scale *= 1.37) {
        const GridSteps steps = decimal_grid_steps(scale);
        EXPECT_NEAR(std::fmod(steps.major / steps.minor + 0.5, 1.0), 0.5, 1e-9);
        EXPECT_NEAR(std::fmod(steps.minor / steps.fine + 0.5, 1.0), 0.5, 1e-9);
        EXPECT_GT(steps.fine * scale, 3.0);
    }
}

TEST(Ruler, has_no_labels_that_touch_and_few_ticks) {
    const Units none;
    const Units inches = core::DocumentUnits{.unit = LengthUnit::inch, .scale = 96.0};
    for (const Units& units : {none, inches})
        for (double scale = 1e-7; scale < 1e12; scale *= 2.7)
            for (const double center : {0.0, 1.5, -1e6, 1.23456789e9}) {
                const EditorState state = ruled_state(scale, {center, -center}, units);
                for (const RulerAxis axis : {RulerAxis::x, RulerAxis::y}) {
                    const auto ticks = ruler_ticks(state, axis);
                    ASSERT_LE(ticks.size(), 500U) << scale;
                    double end = -1e300;
                    const RulerTick* before = nullptr;
                    for (const RulerTick& tick : ticks) {
                        ASSERT_TRUE(std::isfinite(tick.place_px));
                        if (tick.label.empty()) continue;
                        const double width = text_size(tick.label, 10.5, render::LabelFont::number).x;
                        // The left ruler's labels read upward from their ticks.
                        if (axis == RulerAxis::x) {
                            ASSERT_GE(tick.place_px, end) << scale << " " << center << " " << tick.label;
                            end = tick.place_px + width;
                        } else if (before != nullptr) {
                            ASSERT_GE(std::abs(tick.place_px - before->place_px), width) << scale << " " << center;
                        }
                        ASSERT_TRUE(before == nullptr || before->label != tick.label) << tick.label;
                        before = &tick;
                    }
                }
            }
}

std::vector<std::string> labels_of(const std::vector<RulerTick>& ticks) {
    std::vector<std::string> labels;
    for (const RulerTick& tick : ticks)
        if (!tick.label.empty()) labels.push_back(tick.label);
    return labels;
}

std::size_t letter_count(const std::string& text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

/// The places of labels of a ruler, which must be whole and equally far apart.
void expect_even(const std::vector<RulerTick>& ticks, const std::string& where) {
    std::vector<double> places;
    for (const RulerTick& tick : ticks)
        if (!tick.label.empty()) places.push_back(tick.place_px);
    for (std::size_t k = 2; k < places.size(); ++k)
        ASSERT_NEAR(places[k] - places[k - 1], places[1] - places[0], 0.01) << where;
}

TEST(Ruler, has_three_labels_at_any_size_and_zoom) {
    const Units none;
    const Units tenths = core::DocumentUnits{.unit = LengthUnit::mm, .scale = 0.1};
    const Units inches = core::DocumentUnits{.unit = LengthUnit::inch, .scale = 25.4};
    const Units wide_inches = core::DocumentUnits{.unit = LengthUnit::inch, .scale = 1.0};
    for (const Units& units : {none, tenths, inches, wide_inches})
        for (double scale = 1e-6; scale < 1e6; scale *= 1.13)
            for (const double px : {300.0, 366.0, 500.0, 1000.0})
                for (const double center : {0.0, 0.37, -37.25}) {
                    EditorState state = ruled_state(scale, {center, center}, units);
                    state.view.camera.size_px = {px, px};
                    for (const RulerAxis axis : {RulerAxis::x, RulerAxis::y}) {
                        const auto ticks = ruler_ticks(state, axis);
                        const auto labels = labels_of(ticks);
                        std::size_t longest = 0;
                        for (const std::string& label : labels) longest = std::max(longest, letter_count(label));
                        const std::string where = std::to_string(scale) + " at " + std::to_string(px) + ", " +
                                                  std::to_string(center) + " " + ruler_corner(state);
                        const std::size_t least = longest <= 6 || px >= 500.0 ? 3 : px > 300.0 ? 2 : 1;
                        EXPECT_GE(labels.size(), least) << where;
                        expect_even(ticks, where);
                    }
                }
}

TEST(Ruler, inches_are_fractions_down_to_the_128th_and_decimal_beyond) {
    const Units inches = core::DocumentUnits{.unit = LengthUnit::inch, .scale = 1.0};
    // A 128th is 80 px wide here, and no grid line is nearer to another one.
    EXPECT_EQ(inch_grid_steps(80.0 * 128.0).major, 1.0 / 128.0);
    EXPECT_EQ(inch_grid_steps(80.0 * 256.0), decimal_grid_steps(80.0 * 256.0));
    EXPECT_EQ(grid_number_text(3.0 / 128.0, 1.0 / 128.0, inches), "3/128");
    EXPECT_EQ(grid_number_text(0.005, 0.005, inches), "0.005");
    EXPECT_EQ(grid_number_text(0.01, 0.0025, inches), "0.01");
    EXPECT_EQ(grid_number_text(0.0075, 0.0025, inches), "0.0075");
    const auto labels = labels_of(ruler_ticks(ruled_state(80.0 * 512.0, {0, 0}, inches), RulerAxis::x));
    EXPECT_NE(std::ranges::find(labels, "0.004"), labels.end());
    for (const std::string& label : labels) EXPECT_EQ(label.find('/'), std::string::npos) << label;
}

TEST(Ruler, a_low_one_has_finer_labels) {
    // A canvas of 366 px with 193 px for a major step: 2 would be written once.
    EditorState state = ruled_state(193.0 / 2.0, {0, 0.3});
    state.view.camera.size_px = {888.0, 366.0};
    EXPECT_EQ(labels_of(ruler_ticks(state, RulerAxis::y)), (std::vector<std::string>{"−1", "0", "1", "2"}));
}

TEST(Ruler, is_before_the_edges_of_the_canvas) {
    EditorState state = ruled_state(100.0);
    EXPECT_EQ(ruler_at(state, {300.0, -5.0}), RulerAxis::x);
    EXPECT_EQ(ruler_at(state, {-5.0, 300.0}), RulerAxis::y);
    EXPECT_EQ(ruler_at(state, {5.0, 300.0}), std::nullopt);
    EXPECT_TRUE(is_in_ruler_corner(state, {-5.0, -5.0}));
    EXPECT_FALSE(is_in_ruler_corner(state, {5.0, -5.0}));
    state.view.overlays.show(Overlay::rulers, false);
    EXPECT_EQ(ruler_at(state, {300.0, -5.0}), std::nullopt);
}

}  // namespace
}  // namespace batten::editor
