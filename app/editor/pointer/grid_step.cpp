#include "app/editor/pointer/grid_step.h"

#include <cmath>

#include "app/editor/state/state.h"
#include "app/editor/words/length.h"

namespace batten::editor {

namespace {

constexpr double least_major_px = 80.0;
constexpr double least_inch_major = 1.0 / 128.0;

// digit * 10^exponent, rounded once: dividing by a power of ten is exact where multiplying by its inverse is not.
struct Step {
    int digit = 1;
    int exponent = 0;

    double value() const { return exponent < 0 ? digit / std::pow(10.0, -exponent) : digit * std::pow(10.0, exponent); }
};

Step next(Step step) {
    switch (step.digit) {
        case 1:
            return {2, step.exponent};
        case 2:
            return {5, step.exponent};
        default:
            return {1, step.exponent + 1};
    }
}

Step major_step(double scale) {
    // Begun a decade too low, so that the rounding of the logarithm does not matter.
    const double decade = std::floor(std::log10(least_major_px / scale));
    if (!std::isfinite(decade)) return {1, 0};  // nothing is drawn at such a scale
    Step step{1, static_cast<int>(decade) - 1};
    while (step.value() * scale < least_major_px) step = next(step);
    return step;
}

// A quarter or a fifth.
Step minor_step(double scale) {
    const Step major = major_step(scale);
    switch (major.digit) {
        case 1:
            return {2, major.exponent - 1};
        case 2:
            return {5, major.exponent - 1};
        default:
            return {1, major.exponent};
    }
}

// A half or a fifth.
Step part_of(Step step) {
    switch (step.digit) {
        case 1:
            return {5, step.exponent - 1};
        default:
            return {1, step.exponent};
    }
}

}  // namespace

double major_grid_step(double scale) {
    return major_step(scale).value();
}

double minor_grid_step(double scale) {
    return minor_step(scale).value();
}

GridSteps decimal_grid_steps(double scale) {
    return {major_grid_step(scale), minor_grid_step(scale), part_of(minor_step(scale)).value()};
}

GridSteps inch_grid_steps(double scale) {
    if (scale < least_major_px || scale * least_inch_major >= 2.0 * least_major_px) return decimal_grid_steps(scale);
    double major = 1.0;
    while (0.5 * major * scale >= least_major_px) major *= 0.5;
    return {major, major / 4.0, major / 8.0};
}

GridSteps unit_grid_steps(const EditorState& state) {
    const Units& units = state.shown().units;
    const double scale = world_per_length(units) * state.view.camera.scale / state.view.interface_scale;
    const bool has_inches = units && units->unit == core::LengthUnit::inch;
    return has_inches ? inch_grid_steps(scale) : decimal_grid_steps(scale);
}

GridSteps canvas_grid_steps(const EditorState& state) {
    const double world = world_per_length(state.shown().units);
    const GridSteps steps = unit_grid_steps(state);
    return {steps.major * world, steps.minor * world, steps.fine * world};
}

}  // namespace batten::editor
