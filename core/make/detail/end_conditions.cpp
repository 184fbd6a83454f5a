#include "core/make/detail/end_conditions.h"

namespace batten::core {

namespace {

// From C'(u_p) = p (P_1 - P_0) / (u_{p+1} - u_1), and likewise at the end.
void add_tangents(EndPoints& ends, const EndTangents& tangents, const KnotVector& knots) {
    const auto p = static_cast<std::size_t>(knots.degree());
    const auto degree = static_cast<double>(p);
    const KnownPoint first = ends.known.front();
    const KnownPoint last = ends.known.back();
    const std::size_t n = last.index;
    if (tangents.start) ends.known.push_back({1, first.point + (knots[p + 1] - knots[1]) / degree * *tangents.start});
    if (tangents.end) ends.known.push_back({n - 1, last.point - (knots[n + p] - knots[n]) / degree * *tangents.end});
}

// Where the second derivative is zero two legs of the hodograph are equal: (P_1 - P_0) / (u_{p+1} - u_1) =
// (P_2 - P_1) / (u_{p+2} - u_2), and likewise at the end.
void add_natural_ends(EndPoints& ends, const KnotVector& knots) {
    const auto p = static_cast<std::size_t>(knots.degree());
    const KnownPoint first = ends.known.front();
    const KnownPoint last = ends.known.back();
    const std::size_t n = last.index;
    if (n == 3) {
        // Both inner points depend on each other; such a cubic is a straight line.
        const Vector third = (last.point - first.point) / 3.0;
        ends.known.push_back({1, first.point + third});
        ends.known.push_back({2, last.point - third});
        return;
    }
    const double at_start = knots[p + 1] - knots[1];
    const double after_start = knots[p + 2] - knots[2];
    const double at_end = knots[n + p] - knots[n];
    const double before_end = knots[n + p - 1] - knots[n - 1];
    ends.bound = {{1, first.point, 2, at_start / (at_start + after_start)},
                  {n - 1, last.point, n - 2, at_end / (at_end + before_end)}};
}

}  // namespace

EndNeeds needs_of(const Ends& ends) {
    if (std::holds_alternative<NaturalEnds>(ends)) return {1, 1, 3};
    const auto* tangents = std::get_if<EndTangents>(&ends);
    if (tangents == nullptr || (!tangents->start && !tangents->end)) return {};
    return {tangents->start ? 1U : 0U, tangents->end ? 1U : 0U, 2};
}

Result<void> check_degree_of_ends(const Ends& ends, int degree) {
    const int least = needs_of(ends).least_degree;
    if (degree >= least) return {};
    return refuse({.code = CurveErrorCode::degree_too_low,
                   .value = static_cast<double>(degree),
                   .lower = static_cast<double>(least)});
}

Result<void> check_tangents(const Ends& ends) {
    const auto* tangents = std::get_if<EndTangents>(&ends);
    if (tangents == nullptr ||
        (is_finite(tangents->start.value_or(Vector{})) && is_finite(tangents->end.value_or(Vector{}))))
        return {};
    return refuse({.code = CurveErrorCode::vector_not_finite});
}

EndPoints end_points(Point first, Point last, const Ends& ends, const KnotVector& knots) {
    EndPoints result{.known = {{0, first}, {knots.control_point_count() - 1, last}}};
    if (const auto* tangents = std::get_if<EndTangents>(&ends)) add_tangents(result, *tangents, knots);
    if (std::holds_alternative<NaturalEnds>(ends)) add_natural_ends(result, knots);
    return result;
}

}  // namespace batten::core
