#include "exchange/svg/arc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace batten::exchange {

namespace {

using core::DoubleDouble;
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

struct PreciseVector {
    DoubleDouble x{};
    DoubleDouble y{};

    Vector rounded() const { return {x.rounded(), y.rounded()}; }
};

// The series of sine and cosine, about the nearest quarter of a turn.
PreciseVector precise_direction(DoubleDouble degrees) {
    constexpr double full_turn = 360.0;
    constexpr double quarter_turn = 90.0;
    constexpr double negligible = 1e-34;
    const DoubleDouble pi(std::numbers::pi, 1.2246467991473532e-16);
    const DoubleDouble turn = core::exact_sum(std::fmod(degrees.high, full_turn), std::fmod(degrees.low, full_turn));
    const double quarters = std::round(turn.high / quarter_turn);
    const DoubleDouble angle = (turn - quarters * quarter_turn) * pi / (2.0 * quarter_turn);
    PreciseVector direction{1.0, 0.0};
    DoubleDouble term = 1.0;
    for (int n = 1; std::abs(term.high) > negligible; ++n) {
        term = term * angle / static_cast<double>(n);
        DoubleDouble& sum = n % 2 == 0 ? direction.x : direction.y;
        sum = n % 4 < 2 ? sum + term : sum - term;
    }
    for (int left = (static_cast<int>(quarters) + 8) % 4; left > 0; --left) direction = {-direction.y, direction.x};
    return direction;
}

DoubleDouble magnitude(DoubleDouble number) {
    return number.high < 0.0 ? -number : number;
}

// Of an ellipse.
struct Radii {
    DoubleDouble first{};
    DoubleDouble second{};
    PreciseVector direction{};  // of the first one; that of a circle is any
};

Radii radii_of(const EndpointArc& arc) {
    const DoubleDouble first = magnitude(arc.first_radius);
    const DoubleDouble second = magnitude(arc.second_radius);
    const bool is_circle = first.high == second.high && first.low == second.low;
    return {first, second, is_circle ? PreciseVector{1.0, 0.0} : precise_direction(arc.rotation)};
}

// From the middle of the ends to the second one, where the ellipse is the unit circle.
PreciseVector half_chord_of(const EndpointArc& arc, const Radii& radii) {
    const DoubleDouble x = core::exact_sum(0.5 * arc.to.x, -0.5 * arc.from.x) + 0.5 * arc.rest.x;
    const DoubleDouble y = core::exact_sum(0.5 * arc.to.y, -0.5 * arc.from.y) + 0.5 * arc.rest.y;
    const PreciseVector& along = radii.direction;
    return {(x * along.x + y * along.y) / radii.first, (y * along.x - x * along.y) / radii.second};
}

// How far the center is from the middle of the ends there. Where the arc is nearly half of its ellipse this is the root
// of what the rounding of doubles would leave no digit of; a radius that is too small grows to reach it.
double center_distance(const PreciseVector& half_chord, double d) {
    if (d >= 2.0) return 0.0;
    return std::sqrt(
        std::max(0.0, (DoubleDouble(1.0) - half_chord.x * half_chord.x - half_chord.y * half_chord.y).rounded()));
}

}  // namespace

std::vector<ConicPiece> conic_pieces(const EndpointArc& arc) {
    const Radii radii = radii_of(arc);
    const double rx = radii.first.rounded();
    const double ry = radii.second.rounded();
    if (!(rx > 0.0 && ry > 0.0) || !std::isfinite(rx) || !std::isfinite(ry) || arc.from == arc.to) return {};
    const PreciseVector half_chord = half_chord_of(arc, radii);
    const double d = core::robust_length(half_chord.rounded());
    if (!(d > 0.0) || !std::isfinite(d)) return {};
    const double growth = std::max(1.0, d);
    const Vector direction = radii.direction.rounded();
    const UnitFrame frame{(rx * growth) * direction, (ry * growth) * core::turned_left(direction),
                          core::middle(arc.from, arc.to)};

    const double smaller = std::atan2(std::min(d, 1.0), center_distance(half_chord, d));
    const Vector along = half_chord.rounded() / d;
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
