#include "core/refine/reverse.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/double_double.h"

namespace batten::core {

namespace {

// a + b - u with one rounding.
double reflection(double u, Interval domain) {
    const DoubleDouble ends = exact_sum(domain.lower, domain.upper);
    const DoubleDouble difference = exact_sum(ends.high, -u);
    return difference.high + (ends.low + difference.low);
}

// More digits are not typed, and would turn values that are exact in another way into others.
constexpr int most_typed_digits = 12;

// The number of so many digits within `tolerance` of `value` that takes the fewest, else `value`.
double plainest_near(double value, double tolerance) {
    std::array<char, 32> text{};
    for (int digits = 1; digits <= most_typed_digits; ++digits) {
        char* const end =
            std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1).ptr;
        double plain = value;
        std::from_chars(text.data(), end, plain);
        if (std::abs(plain - value) <= tolerance) return plain;
    }
    return value;
}

// How far `value` may be moved: less than what rounds away at the domain's larger end, and than what would show in the
// spans beside it.
double freedom(std::span<const double> ascending, double value, Interval domain) {
    const double size = std::max(std::abs(domain.lower), std::abs(domain.upper));
    double freedom = 0.5 * (size - std::nextafter(size, 0.0));
    constexpr double share_of_span = 16 * std::numeric_limits<double>::epsilon();
    const auto [first, last] = std::equal_range(ascending.begin(), ascending.end(), value);
    if (first != ascending.begin()) freedom = std::min(freedom, share_of_span * (value - *(first - 1)));
    if (last != ascending.end()) freedom = std::min(freedom, share_of_span * (*last - value));
    return freedom;
}

// The knots from the last to the first, reflected. Equal ones stay equal, and the ends of the domain are exchanged.
std::vector<double> reflected(std::span<const double> knots, Interval domain) {
    std::vector<double> exact;
    for (std::size_t i = knots.size(); i-- > 0;) exact.push_back(reflection(knots[i], domain));
    std::vector<double> result;
    for (const double value : exact) {
        const bool is_end = value == domain.lower || value == domain.upper;
        result.push_back(is_end ? value : plainest_near(value, freedom(exact, value, domain)));
    }
    return result;
}

std::optional<std::size_t> first_coincidence(std::span<const double> before, std::span<const double> after) {
    for (std::size_t i = 1; i < after.size(); ++i)
        if (!(after[i - 1] < after[i]) && before[before.size() - 1 - i] != before[before.size() - i]) return i;
    return std::nullopt;
}

bool is_equally_spaced(KnotKind kind) {
    return kind == KnotKind::uniform || kind == KnotKind::clamped_uniform || kind == KnotKind::periodic;
}

template <class T>
std::vector<T> points_backwards(const Curve& curve, std::span<const T> values) {
    std::vector<T> result(values.rbegin(), values.rend());
    // Unrolled, the period's first point is p places before its first knot, so the last one becomes point p - 1.
    if (curve.is_periodic()) {
        const auto n = static_cast<std::ptrdiff_t>(values.size());
        std::rotate(result.begin(), result.end() - curve.degree() % n, result.end());
    }
    return result;
}

}  // namespace

Result<Curve> reverse(const Curve& curve) {
    CurveDefinition definition = curve.definition();
    if (!is_equally_spaced(definition.kind)) {
        definition.knots = reflected(definition.knots, curve.domain());
        if (const auto index = first_coincidence(curve.knots().stored(), definition.knots))
            return refuse_computed(
                {.code = CurveErrorCode::knots_coincide, .index = *index, .value = definition.knots[*index]});
    }
    definition.points = points_backwards(curve, curve.control_points());
    definition.weights = points_backwards(curve, curve.weights());
    return Curve::make(std::move(definition));
}

}  // namespace batten::core
