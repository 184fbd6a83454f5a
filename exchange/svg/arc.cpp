#include "exchange/svg/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace batten::exchange {

namespace {

using core::Point;
using core::Vector;

// The plane in which the ellipse is the unit circle and the middle of the chord is 0.
struct UnitFrame {
    Vector first{};
    Vector second{};
    Point middle{};

    Point of(Vector v) const { return middle + v.x * first + v.y * second; }
};

// The arc in that plane: from -sin h along `along` to sin h, with its apex in the direction `apex`, where h is half of
// its angle.
struct UnitArc {
    Vector along{};
    Vector apex{};
    double half = 0.0;

    // `reach` times away from the center at the angle `a` from the apex, where `reach` - 1 is `excess`. Seen from the
    // chord, so that the center may be as far away as it likes.
    Vector at(double a, double excess) const {
        const double height = 2.0 * std::sin((half + a) / 2.0) * std::sin((half - a) / 2.0) + excess * std::cos(a);
        return height * apex + ((1.0 + excess) * std::sin(a)) * along;
    }
};

Vector first_direction(double degrees) {
    const double turn = std::fmod(degrees, 360.0);
    const double quarters = turn / 90.0;
    if (quarters == std::round(quarters)) {
        const int quarter = (static_cast<int>(quarters) + 4) % 4;
        return quarter == 0 ? Vector(1, 0) : quarter == 1 ? Vector(0, 1) : quarter == 2 ? Vector(-1, 0) : Vector(0, -1);
    }
    const double angle = turn * (std::numbers::pi / 180.0);
    return {std::cos(angle), std::sin(angle)};
}

}  // namespace

std::vector<ConicPiece> conic_pieces(const EndpointArc& arc) {
    const double rx = std::abs(arc.first_radius);
    const double ry = std::abs(arc.second_radius);
    if (!(rx > 0.0 && ry > 0.0) || !std::isfinite(rx) || !std::isfinite(ry) || arc.from == arc.to) return {};
    const Vector direction = first_direction(arc.rotation);
    const Point middle = core::middle(arc.from, arc.to);
    const Vector to_end = arc.to - middle;
    const Vector half_chord{core::dot(to_end, direction) / rx, core::cross(direction, to_end) / ry};
    const double d = core::robust_length(half_chord);
    if (!(d > 0.0) || !std::isfinite(d)) return {};
    const double growth = std::max(1.0, d);
    const UnitFrame frame{(rx * growth) * direction, (ry * growth) * core::turned_left(direction), middle};

    const double sine = std::min(d, 1.0);
    const double smaller = std::atan2(sine, std::sqrt((1.0 - sine) * (1.0 + sine)));
    const Vector along = half_chord / d;
    const Vector left = core::turned_left(along);
    const UnitArc unit{along, arc.is_positive ? -left : left, arc.is_large ? std::numbers::pi - smaller : smaller};

    // A little more than a quarter by rounding is a quarter.
    constexpr double quarter = std::numbers::pi / 2.0 * (1.0 + 1e-12);
    const int count = static_cast<int>(std::ceil(2.0 * unit.half / quarter));
    const double half_piece = unit.half / count;
    const double weight = std::cos(half_piece);
    const double excess = 2.0 * std::pow(std::sin(half_piece / 2.0), 2) / weight;
    std::vector<ConicPiece> pieces;
    for (int k = 0; k < count; ++k) {
        const double corner = (2 * k + 1 - count) * half_piece;
        const double end = (2 * k + 2 - count) * half_piece;
        pieces.push_back(
            {.corner = frame.of(unit.at(corner, excess)), .weight = weight, .end = frame.of(unit.at(end, 0.0))});
    }
    pieces.back().end = arc.to;
    return pieces;
}

}  // namespace batten::exchange
