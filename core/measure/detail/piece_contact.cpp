#include "core/measure/detail/piece_contact.h"

#include <algorithm>
#include <cmath>

namespace batten::core {

namespace {

constexpr int most_contact_steps = 30;
constexpr int most_secant_steps = 80;
constexpr int samples = 64;

// Newton's iteration may leave a piece by this much on its way, but not farther, where weights may vanish.
constexpr Interval neighborhood{-0.125, 1.125};

constexpr double smallest_contact_step = 0.5 * std::numeric_limits<double>::epsilon();

double unit(double share) {
    return std::clamp(share, 0.0, 1.0);
}

double distance(const PieceMotion& a, const PieceMotion& b, ShareContact at) {
    return distance(a.at(at.first).position, b.at(at.second).position);
}

}  // namespace

std::optional<ShareContact> crossing_near(const PieceMotion& a, const PieceMotion& b, ShareContact start,
                                          double tolerance) {
    ShareContact at = start;
    for (int i = 0; i < most_contact_steps; ++i) {
        const Motion on_a = a.at(at.first);
        const Motion on_b = b.at(at.second);
        const Vector apart = on_b.position - on_a.position;
        const double determinant = cross(on_a.velocity, on_b.velocity);
        const double step_a = cross(apart, on_b.velocity) / determinant;
        const double step_b = cross(apart, on_a.velocity) / determinant;
        if (!std::isfinite(step_a) || !std::isfinite(step_b)) return std::nullopt;
        at.first = neighborhood.clamp(at.first + step_a);
        at.second = neighborhood.clamp(at.second + step_b);
        if (std::max(std::abs(step_a), std::abs(step_b)) <= smallest_contact_step) break;
    }
    at = {unit(at.first), unit(at.second)};
    if (!(distance(a, b, at) <= tolerance)) return std::nullopt;
    return at;
}

double foot_near(const PieceMotion& b, Point point, double start) {
    // As long as the distance is small against the radius of curvature this converges quickly.
    double s = unit(start);
    for (int i = 0; i < most_contact_steps; ++i) {
        const Motion motion = b.at(s);
        const double next =
            unit(s + dot(point - motion.position, motion.velocity) / dot(motion.velocity, motion.velocity));
        if (!std::isfinite(next) || std::abs(next - s) <= smallest_contact_step) break;
        s = next;
    }
    return s;
}

double foot(const PieceMotion& b, Point point) {
    double best = 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= samples; ++k) {
        const double s = static_cast<double>(k) / samples;
        const double away = distance(b.at(s).position, point);
        if (away < least) {
            least = away;
            best = s;
        }
    }
    return foot_near(b, point, best);
}

std::optional<ShareContact> touching_near(const PieceMotion& a, const PieceMotion& b, ShareContact start,
                                          Interval range, double tolerance) {
    double s = start.second;
    const auto turn = [&](double t) {
        const Motion motion = a.at(t);
        s = foot_near(b, motion.position, s);
        return cross(motion.velocity, b.at(s).velocity);
    };
    // The tangents turn past each other: a change of sign, enclosed by the method of false position (Illinois).
    double t = start.first;
    Interval bracket = range;
    double lower = turn(bracket.lower);
    double upper = turn(bracket.upper);
    for (int i = 0; i < most_secant_steps && lower * upper < 0.0; ++i) {
        t = bracket.lower - lower * bracket.length() / (upper - lower);
        if (!(bracket.lower < t && t < bracket.upper)) break;
        const double value = turn(t);
        if (value == 0.0) break;
        if ((value < 0.0) == (lower < 0.0)) {
            bracket.lower = t;
            lower = value;
            upper *= 0.5;
        } else {
            bracket.upper = t;
            upper = value;
            lower *= 0.5;
        }
    }
    // At an end of the piece the tangents may meet without turning past each other.
    std::optional<ShareContact> best;
    double least_turn = std::numeric_limits<double>::infinity();
    for (const double candidate : {t, range.lower, range.upper, start.first}) {
        const double turned = std::abs(turn(candidate));
        if (turned >= least_turn || !(distance(a, b, {candidate, s}) <= tolerance)) continue;
        least_turn = turned;
        best = {candidate, s};
    }
    if (best) return best;
    // At a corner or cusp of one of them nothing turns; the points are the same all the same.
    if (const auto crossing = crossing_near(a, b, start, tolerance)) return crossing;
    ShareContact nearest = start;
    for (int i = 0; i < most_contact_steps; ++i) {
        nearest.second = foot_near(b, a.at(nearest.first).position, nearest.second);
        nearest.first = foot_near(a, b.at(nearest.second).position, nearest.first);
    }
    if (distance(a, b, nearest) <= tolerance) return nearest;
    return std::nullopt;
}

}  // namespace batten::core
