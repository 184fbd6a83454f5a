#include "app/editor/scene/multiples.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace batten::editor {

Multiples multiples(double lower, double upper, double step) {
    const double resolution = std::numeric_limits<double>::epsilon() * std::max(std::abs(lower), std::abs(upper));
    if (!(step >= 8.0 * resolution)) return {step, 0.0, 0};
    const double first = std::ceil(lower / step);
    const double count = std::floor(upper / step) - first + 1.0;
    return {step, first, static_cast<int>(std::clamp(count, 0.0, 10000.0))};
}

double round_number_from(double least) {
    double number = 1.0;
    for (int k = 0; number < least && k < 60; ++k) number *= k % 3 == 1 ? 2.5 : 2.0;
    return number;
}

}  // namespace batten::editor
