#include "core/measure/nearest.h"

#include <cassert>
#include <cmath>
#include <optional>

#include "core/base/detail/unit_interval.h"
#include "core/base/double_double.h"
#include "core/curve/control_box.h"
#include "core/evaluate/detail/precise_jet.h"
#include "core/evaluate/detail/subdivide.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/detail/piece_forms.h"

namespace batten::core {

namespace {

// Distances closer than this part of the size are equal.
constexpr double equal_share = 1e-14;

// A part of this share of a span has nothing to be told apart in it.
constexpr double shortest_part = 0x1p-40;

constexpr int most_nearest_steps = 60;

// Of the domain: what Newton's iteration in other coordinates may leave.
constexpr double last_step = 1e-12;

// Of the product of distance and speed.
constexpr double slope_rounding = 2.0 * std::numeric_limits<double>::epsilon();

constexpr double infinity = std::numeric_limits<double>::infinity();

double farthest_corner(const Box& box, Point query) {
    return std::hypot(std::max(std::abs(box.lower.x - query.x), std::abs(box.upper.x - query.x)),
                      std::max(std::abs(box.lower.y - query.y), std::abs(box.upper.y - query.y)));
}

// A part of a span, seen from the query: its homogeneous Bézier points.
struct NearPart {
    Interval range{0.0, 1.0};  ///< of the span
    std::size_t p = 0;
    bool is_rational = false;
    LocalPoints<HomogeneousPoint> points;

    std::span<const HomogeneousPoint> all() const { return std::span(points).first(p + 1); }
    double distance_at_start() const { return length(vector_to(project(points[0]))); }
    double distance_at_end() const { return length(vector_to(project(points[p]))); }
};

std::pair<NearPart, NearPart> halves(const NearPart& part) {
    std::pair<NearPart, NearPart> result{part, part};
    auto& [left, right] = result;
    left.range.upper = right.range.lower = middle(part.range);
    for (std::size_t level = 1; level <= part.p; ++level) {
        for (std::size_t i = 0; i + level <= part.p; ++i)
            right.points[i] = 0.5 * (right.points[i] + right.points[i + 1]);
        left.points[level] = right.points[0];
    }
    return result;
}

// Half the squared distance: its slope, and how that changes.
struct Bend {
    double distance = 0.0;
    double speed = 0.0;
    double slope = 0.0;
    double bend = 0.0;

    // Of a point seen from the query.
    Bend(Vector point, Vector velocity, Vector change)
        : distance(length(point)),
          speed(length(velocity)),
          slope(dot(point, velocity)),
          bend(dot(velocity, velocity) + dot(point, change)) {}
};

// Where a point is seen from another place, its velocity and how that changes.
struct PlaneJet {
    Vector point;
    Vector velocity;
    Vector change;

    PlaneJet(const HomogeneousPoint& here, const HomogeneousPoint& first, const HomogeneousPoint& second)
        : point(plane_part(here) / here.z),
          velocity((plane_part(first) - first.z * point) / here.z),
          change((plane_part(second) - 2.0 * first.z * velocity - second.z * point) / here.z) {}
};

template <class P>
struct PieceJet {
    P point;
    P first;
    P second;
};

// The last two steps of de Casteljau's triangle are differences, too. `points` are used up.
template <class P>
PieceJet<P> jet_at(LocalPoints<P>& points, std::size_t p, double t) {
    const Ratio ratio{1.0 - t, t};
    const auto degree = static_cast<double>(p);
    P second = 0.0 * points[0];
    for (std::size_t left = p; left > 1; --left) {
        if (left == 2) second = degree * (degree - 1.0) * ((points[2] - points[1]) - (points[1] - points[0]));
        for (std::size_t i = 0; i < left; ++i) points[i] = blend(points[i], points[i + 1], ratio);
    }
    return {blend(points[0], points[1], ratio), degree * (points[1] - points[0]), second};
}

Bend bend_at(const NearPart& part, double t) {
    if (!part.is_rational) {
        LocalPoints<Vector> points;
        for (std::size_t i = 0; i <= part.p; ++i) points[i] = plane_part(part.points[i]);
        const auto jet = jet_at(points, part.p, t);
        return {jet.point, jet.first, jet.second};
    }
    LocalPoints<HomogeneousPoint> points;
    std::copy_n(part.points.begin(), part.p + 1, points.begin());
    const auto [here, first, second] = jet_at(points, part.p, t);
    const PlaneJet jet(here, first, second);
    return {jet.point, jet.velocity, jet.change};
}

// At a point of the curve as it was rounded.
Bend bend_beside(const Curve& curve, const Location& place, Point point, Point query) {
    const auto& [u, at] = place;
    auto points = local_shadow_points(curve, at, point);
    std::array<HomogeneousPoint, 3> jet{};
    for (std::size_t k = 0; k <= std::min<std::size_t>(2, at.p); ++k) {
        if (k > 0) differentiate_level(points, at, k);
        jet[k] = de_boor(points, at, u, k);
    }
    // The curve is not there, but a little beside it.
    const PlaneJet beside(jet[0], jet[1], jet[2]);
    Bend bend(point - query, beside.velocity, beside.change);
    bend.slope += dot(beside.point, beside.velocity);
    return bend;
}

// (A - w Q) . (A' w - A w') / w^3, which is (C - Q) . C'.
double precise_slope(const Curve& curve, const Location& place, Point query) {
    const auto [here, first, second] = precise_jet(curve, place.at, place.u, query);
    const DoubleDouble across = first.x * here.w - here.x * first.w;
    const DoubleDouble up = first.y * here.w - here.y * first.w;
    const double weight = here.w.rounded();
    return (here.x * across + here.y * up).rounded() / weight / weight / weight;
}

}  // namespace

class NearestSearch {
  public:
    NearestSearch(const NearestFinder& finder, Point query, std::size_t& looks)
        : finder_(finder),
          query_(query),
          tolerance_(equal_share * farthest_corner(finder.box_, query)),
          looks_(looks) {}

    // The parameter, and the side of it that is meant where the curve is torn.
    std::pair<double, Side> run() {
        if (tolerance_ >= length(finder_.box_.size())) return {finder_.curve_.domain().lower, Side::right};
        finder_.chords_.visit_near(
            query_,
            [&](double squared, double width, std::size_t first) {
                ++looks_;
                const double radius = radius_for(finder_.spans_[first].lower);
                return radius <= 0.0 || squared > (radius + width) * (radius + width);
            },
            [&](std::size_t i) { search_span(i); });
        const Candidate& found = best_ ? *best_ : reached_;
        return {found.u, found.side};
    }

  private:
    struct Candidate {
        double u = 0.0;
        double distance = std::numeric_limits<double>::infinity();
        Side side = Side::right;
    };

    // What is to be beaten: on the left of the best an equal distance counts, on the right of it only a smaller one.
    double radius_for(double lower) const {
        const double equal = reached_.distance + tolerance_;
        return best_ && best_->u <= lower && best_->distance <= equal ? best_->distance - tolerance_ : equal;
    }

    void search_span(std::size_t i) {
        span_ = i;
        NearPart whole;
        whole.p = finder_.degree();
        whole.is_rational = finder_.curve_.is_rational();
        for (std::size_t j = 0; j <= whole.p; ++j) {
            const HomogeneousPoint& given = finder_.points_[i * (whole.p + 1) + j];
            whole.points[j] = {given.x - given.z * query_.x, given.y - given.z * query_.y, given.z};
        }
        reach({finder_.spans_[i].lower, whole.distance_at_start()});
        reach({finder_.spans_[i].upper, whole.distance_at_end(), Side::left});
        search(whole);
    }

    void search(const NearPart& part) {
        ++looks_;
        const SquaredDistance form(part.all(), part.is_rational, finder_.binomials_);
        const Candidate start{parameter_at(part.range.lower), part.distance_at_start()};
        if (form.is_nowhere_nearer(radius_for(start.u))) return;
        if (form.is_nowhere_nearer(reached_.distance - tolerance_) &&
            form.is_nowhere_farther(reached_.distance + tolerance_))
            return offer(start);
        const auto slope = form.slope(finder_.binomials_);
        if (slope.changes > 1 && part.range.length() > shortest_part) {
            const auto [left, right] = halves(part);
            reach({parameter_at(right.range.lower), right.distance_at_start()});
            search(left);
            return search(right);
        }
        if (slope.first_sign >= 0) offer(start);
        if (slope.first_sign < 0 && slope.changes > 0) offer_minimum(part, slope.change);
        if (slope.last_sign < 0 && is_end(part.range))
            offer({parameter_at(part.range.upper), part.distance_at_end(), Side::left});
    }

    double parameter_at(double t) const { return from_unit(finder_.spans_[span_], t); }

    // Where no other part begins that would offer this end as its beginning.
    bool is_end(Interval range) const {
        if (range.upper < 1.0) return false;
        const std::size_t p = finder_.degree();
        const std::size_t next = (span_ + 1) * (p + 1);
        return next == finder_.points_.size() || finder_.points_[next] != finder_.points_[next - 1];
    }

    void reach(const Candidate& point) {
        if (point.distance < reached_.distance) reached_ = point;
    }

    void offer(const Candidate& minimum) {
        reach(minimum);
        const bool is_nearer = !best_ || minimum.distance < best_->distance - tolerance_;
        const bool is_equal_before =
            best_ && minimum.u < best_->u && minimum.distance <= reached_.distance + tolerance_;
        if (is_nearer || is_equal_before) best_ = minimum;
    }

    // The only minimum in the part, at about `t`. Its distance is that at the parameter which a double can be.
    void offer_minimum(const NearPart& part, double t) {
        const double share = from_unit(part.range, minimum_in(part, t));
        const double u = parameter_at(share);
        const double rounded = to_unit(part.range, to_unit(finder_.spans_[span_], u));
        offer({u, bend_at(part, rounded).distance, share == 1.0 ? Side::left : Side::right});
    }

    // Newton's iteration in a bracket that shrinks.
    static double minimum_in(const NearPart& part, double t) {
        Interval bracket{0.0, 1.0};
        for (int i = 0; i < most_nearest_steps; ++i) {
            const Bend at = bend_at(part, t);
            if (at.slope == 0.0) return t;
            (at.slope < 0.0 ? bracket.lower : bracket.upper) = t;
            double next = t - at.slope / at.bend;
            if (!(at.bend > 0.0 && bracket.lower <= next && next <= bracket.upper)) next = middle(bracket);
            const bool is_done = std::abs(next - t) <= std::numeric_limits<double>::epsilon() * next;
            t = next;
            if (is_done) return t;
        }
        return t;
    }

    const NearestFinder& finder_;
    Point query_;
    double tolerance_;
    std::size_t& looks_;
    std::optional<Candidate> best_;
    Candidate reached_;  ///< the nearest point seen, a minimum or not
    std::size_t span_ = 0;
};

NearestFinder::NearestFinder(const Curve& curve)
    : curve_(curve),
      origin_(middle_of(curve)),
      scale_(form_scale(curve)),
      binomials_(degree()),
      chords_(chords_of_spans()) {}

std::vector<Chord> NearestFinder::chords_of_spans() {
    std::vector<Chord> chords;
    std::vector<Point> places;
    for (const BezierPiece& piece : bezier_pieces(core::seen_from(curve_, origin_))) {
        spans_.push_back(piece.interval);
        places.clear();
        for (const HomogeneousPoint& point : piece.points) {
            places.push_back(tip_of(scale_ * vector_to(project(point))));
            points_.push_back(lift(places.back(), curve_.is_rational() ? point.z : 1.0));
            box_.include(places.back());
        }
        chords.push_back(chord_of(places));
    }
    return chords;
}

// One more step, with what is right to the last digit and with what the rounding of the point left of it.
CurveSample NearestFinder::polished(CurveSample found, Side side, Point query) const {
    const Location place = located(curve_.knots(), found.u, side);
    const Bend bend = bend_beside(curve_, place, found.point, query);
    double step = -bend.slope / bend.bend;
    const Interval domain = curve_.domain();
    if (!(bend.bend > 0.0 && std::abs(step) <= last_step * domain.length())) return found;
    // Midway between two doubles rounding may lead to the wrong one.
    const double half_unit = 0.5 * (std::nextafter(std::abs(found.u), infinity) - std::abs(found.u));
    const double rounding_of_step = slope_rounding * bend.distance * bend.speed / bend.bend;
    if (std::abs(std::abs(step) - half_unit) <= rounding_of_step)
        step = -precise_slope(curve_, place, query) / bend.bend;
    if (std::abs(step) < half_unit) return found;
    if (!domain.contains(found.u + step)) return found;
    const CurveSample next{found.u + step, point_at(curve_, found.u + step, side)};
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * bend.distance;
    return distance(next.point, query) <= bend.distance + rounding ? next : found;
}

CurveSample NearestFinder::nearest(Point query, std::size_t* looks) const {
    assert(is_finite(query));
    std::size_t counted = 0;
    const Point seen = tip_of(scale_ * (query - origin_));
    const auto [u, side] = NearestSearch(*this, seen, counted).run();
    if (looks != nullptr) *looks += counted;
    return polished({u, point_at(curve_, u, side)}, side, query);
}

CurveSample nearest_point(const Curve& curve, Point query) {
    return NearestFinder(curve).nearest(query);
}

}  // namespace batten::core
