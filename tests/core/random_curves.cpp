#include "tests/core/random_curves.h"

namespace batten::core {

double RandomCurves::number(double lower, double upper) {
    // Computed here, because the distributions of <random> differ between standard libraries.
    return lower + (upper - lower) * (static_cast<double>(engine_()) / 4294967296.0);
}

int RandomCurves::whole(int lower, int upper) {
    return lower + static_cast<int>(engine_() % static_cast<std::uint32_t>(upper - lower + 1));
}

double RandomCurves::parameter(const Curve& curve) {
    const Interval domain = curve.domain();
    if (whole(0, 3) > 0) return number(domain.lower, domain.upper);
    const auto knots = curve.knots().values();
    return domain.clamp(knots[static_cast<std::size_t>(whole(0, static_cast<int>(knots.size()) - 1))]);
}

// Ascending knots in runs of at most `degree` equal ones.
std::vector<double> RandomCurves::knots(std::size_t count, int degree) {
    std::vector<double> knots;
    double u = number(-3.0, 3.0);
    while (knots.size() < count) {
        const int run = whole(0, 2) > 0 ? 1 : whole(1, degree);
        for (int k = 0; k < run && knots.size() < count; ++k) knots.push_back(u);
        u += number(0.05, 1.5);
    }
    return knots;
}

Curve RandomCurves::over(int degree, std::vector<double> knots, std::size_t point_count, bool periodic) {
    CurveDefinition definition{.degree = degree, .knots = std::move(knots), .periodic = periodic};
    const bool is_rational = whole(0, 2) > 0;
    for (std::size_t i = 0; i < point_count; ++i) {
        const double x = number(-8.0, 8.0);
        definition.points.emplace_back(x, number(-8.0, 8.0));
        definition.weights.push_back(is_rational ? number(0.2, 5.0) : 1.0);
    }
    return Curve::make(std::move(definition)).value();
}

Curve RandomCurves::open_curve() {
    const int degree = whole(1, 7);
    const auto p = static_cast<std::size_t>(degree);
    const std::size_t point_count = p + 1 + static_cast<std::size_t>(whole(0, 7));
    auto values = knots(point_count + p + 1, degree);
    if (whole(0, 2) > 0) {
        const auto interior = static_cast<std::ptrdiff_t>(p) + 1;
        std::fill(values.begin(), values.begin() + interior, values[0] - 0.5);
        std::fill(values.end() - interior, values.end(), values.back() + 0.5);
    } else if (values[p] == values[point_count]) {
        // A run of p knots fills a domain of fewer spans.
        for (std::size_t i = point_count; i < values.size(); ++i) values[i] += 1.0;
    }
    return over(degree, std::move(values), point_count, false);
}

Curve RandomCurves::periodic_curve() {
    const int degree = whole(1, 7);
    const auto n = static_cast<std::size_t>(whole(2, 8));
    // The seam is named at both ends: its last knot ends the period, and what is equal to it counts with the first run.
    auto values = knots(n, degree);
    const double end = values.back() + number(0.05, 1.5);
    const auto first_run = static_cast<int>(std::count(values.begin(), values.end(), values.front()));
    const auto last_run = static_cast<int>(std::count(values.begin(), values.end(), values.back()));
    if (whole(0, 3) == 0 && values.front() != values.back() && first_run + last_run <= degree)
        for (std::size_t k = 0; k < static_cast<std::size_t>(last_run); ++k) values[n - 1 - k] = end;
    values.push_back(end);
    return over(degree, std::move(values), n, true);
}

}  // namespace batten::core
