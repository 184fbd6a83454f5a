#include "core/measure/detail/contact_piece.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace batten::core {

namespace {

constexpr double pi = std::numbers::pi;

// Rounding of angles.
constexpr double slack = 1e-12;

// The tangents of a rational piece are positive sums of its legs.
std::optional<DirectionCone> cone_of(std::span<const Point> a, std::span<const Point> b = {}) {
    std::optional<Vector> reference;
    double least = 0.0;
    double greatest = 0.0;
    for (const auto& points : {a, b})
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Vector leg = points[i + 1] - points[i];
            if (leg == Vector{}) continue;
            if (!reference) reference = leg;
            const double angle = angle_between(*reference, leg);
            least = std::min(least, angle);
            greatest = std::max(greatest, angle);
        }
    if (!reference || !(greatest - least < pi - slack)) return std::nullopt;
    return DirectionCone{std::atan2(reference->y, reference->x) + 0.5 * (least + greatest), 0.5 * (greatest - least)};
}

// How far apart the projections of both pieces on `axis` are.
double gap_along(const ContactPiece& a, const ContactPiece& b, Vector axis) {
    const auto extent = [&](const ContactPiece& piece) {
        Interval interval{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
        for (const Point& point : piece.shadow) {
            const double height = dot(axis, vector_to(point));
            interval = {std::min(interval.lower, height), std::max(interval.upper, height)};
        }
        return interval;
    };
    const Interval of_a = extent(a);
    const Interval of_b = extent(b);
    return std::max(of_a.lower - of_b.upper, of_b.lower - of_a.upper);
}

std::optional<Vector> normal_of_chord(const ContactPiece& piece) {
    const Vector chord = piece.shadow.back() - piece.shadow.front();
    const double size = length(chord);
    if (!(size > 0.0)) return std::nullopt;
    return turned_left(chord) / size;
}

}  // namespace

ContactPiece::ContactPiece(std::size_t span_index, Interval share_interval,
                           std::vector<HomogeneousPoint> control_points)
    : span(span_index), shares(share_interval), points(std::move(control_points)) {
    assert(!points.empty());
    shadow.reserve(points.size());
    for (const HomogeneousPoint& point : points) shadow.push_back(project(point));
    for (const Point& point : shadow) box.include(point);
    directions = cone_of(shadow);
}

std::pair<ContactPiece, ContactPiece> halves(const ContactPiece& piece) {
    const std::size_t p = piece.points.size() - 1;
    std::vector<HomogeneousPoint> left;
    std::vector<HomogeneousPoint> right = piece.points;
    left.reserve(p + 1);
    for (std::size_t level = 0; level <= p; ++level) {
        left.push_back(right.front());
        for (std::size_t i = 0; i + level < p; ++i) right[i] = 0.5 * (right[i] + right[i + 1]);
    }
    const double half = piece.shares.lower + 0.5 * piece.shares.length();
    return {ContactPiece(piece.span, {piece.shares.lower, half}, std::move(left)),
            ContactPiece(piece.span, {half, piece.shares.upper}, std::move(right))};
}

bool are_apart(const ContactPiece& a, const ContactPiece& b, double distance) {
    const double x = std::max(a.box.lower.x - b.box.upper.x, b.box.lower.x - a.box.upper.x);
    const double y = std::max(a.box.lower.y - b.box.upper.y, b.box.lower.y - a.box.upper.y);
    if (std::max(x, y) > distance) return true;
    for (const ContactPiece* piece : {&a, &b})
        if (const auto normal = normal_of_chord(*piece); normal && gap_along(a, b, *normal) > distance) return true;
    return false;
}

bool are_transversal(const ContactPiece& a, const ContactPiece& b) {
    if (!a.directions || !b.directions) return false;
    const double between = std::abs(std::remainder(a.directions->middle - b.directions->middle, pi));
    return between > a.directions->half_width + b.directions->half_width + slack;
}

bool continue_each_other(const ContactPiece& a, const ContactPiece& b) {
    return cone_of(a.shadow, b.shadow).has_value();
}

}  // namespace batten::core
