#include "app/editor/pointer/grid_step.h"

#include <cmath>

namespace batten::editor {

namespace {

constexpr double least_major_px = 80.0;

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
    Step step{1, static_cast<int>(std::floor(std::log10(least_major_px / scale))) - 1};
    while (step.value() * scale < least_major_px) step = next(step);
    return step;
}

}  // namespace

double major_grid_step(double scale) {
    return major_step(scale).value();
}

double minor_grid_step(double scale) {
    const Step major = major_step(scale);
    switch (major.digit) {
        case 1:
            return Step{2, major.exponent - 1}.value();
        case 2:
            return Step{5, major.exponent - 1}.value();
        default:
            return Step{1, major.exponent}.value();
    }
}

}  // namespace batten::editor
