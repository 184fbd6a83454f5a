#include "core/shape/detail/offset_parts.h"

#include <cmath>
#include <numbers>

#include "core/curve/control_box.h"
#include "core/edit/offset.h"
#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "core/refine/split.h"
#include "core/shape/detail/offset_fit.h"

namespace batten::core {

namespace {

// Of the tolerance: how far the parts on which the crossings are found may be from the true offset.
constexpr double raw_share = 0.1;

// Ends of parts that are nearer than this share of the tolerance are one.
constexpr double meeting_share = 1e-3;

constexpr double farthest_mitre = 4.0;
constexpr double degrees = 180.0 / std::numbers::pi;

class PartBuilder {
  public:
    PartBuilder(const OffsetSource& source, std::size_t number, const OffsetRequest& request)
        : source_(source), number_(number), request_(request) {}

    Result<std::vector<OffsetPart>> build() {
        for (const Interval& stretch : source_.stretches()) {
            if (!parts_.empty())
                if (auto check = go_around(stretch.lower, stretch.lower); !check) return refuse(check.error());
            if (auto check = add_stretch(stretch); !check) return refuse(check.error());
        }
        const Interval domain = source_.curve().domain();
        if (source_.is_closed() && !source_.is_smoothly_closed())
            if (auto check = go_around(domain.upper, domain.lower); !check) return refuse(check.error());
        if (source_.is_closed()) close();
        return std::move(parts_);
    }

  private:
    Result<void> add_stretch(Interval stretch) {
        const auto part = sub_curve(source_.curve(), stretch.lower, stretch.upper);
        if (!part) return refuse(part.error());
        if (auto exact = exact_offset(*part, source_.distance())) {
            add(*exact, OffsetPartKind::exact);
            return {};
        }
        auto raw = raw_offset(source_, stretch, raw_share * request_.tolerance);
        if (!raw) return refuse(raw.error());
        add(*std::move(raw), OffsetPartKind::raw);
        return {};
    }

    void add(Curve curve, OffsetPartKind kind) {
        if (!parts_.empty()) curve = begun_at(curve, end_of_parts());
        parts_.push_back({std::move(curve), kind, number_, false, {}});
    }

    Point end_of_parts() const { return parts_.back().curve.control_points().back(); }

    bool are_one(Point a, Point b) const { return distance(a, b) <= meeting_share * request_.tolerance; }

    // The curve beginning exactly where another one ends, if it does so nearly.
    Curve begun_at(const Curve& curve, Point start) const {
        if (!are_one(curve.control_points().front(), start)) return curve;
        CurveDefinition definition = curve.definition();
        definition.points.front() = start;
        return Curve::make(std::move(definition)).value_or(curve);
    }

    // Where the ends of a closed one meet.
    void close() {
        const Point start = parts_.front().curve.control_points().front();
        if (!are_one(start, end_of_parts())) return;
        CurveDefinition definition = parts_.back().curve.definition();
        definition.points.back() = start;
        if (auto curve = Curve::make(std::move(definition))) parts_.back().curve = *std::move(curve);
    }

    // On the inner side of a corner the offsets cross; what goes beyond is cut away.
    Result<void> go_around(double before, double after) {
        const auto from = source_.at(before, Side::left);
        const auto to = source_.at(after, Side::right);
        if (!from || !to) return refuse(from ? to.error() : from.error());
        if (are_one(from->point, to->point)) return {};
        double turn = angle_between(from->tangent, to->tangent);
        constexpr double turning_back = std::numbers::pi - 1e-6;
        if (std::abs(turn) > turning_back) turn = turn_at_cusp(before, after);
        if (turn > 0.0 && turn < turning_back) return {};
        const Point corner = from->point - source_.distance() * turned_left(from->tangent);
        return add_corner(corner, *from, *to, turn > 0.0 ? -turn : turn);
    }

    // By the half turn to the side to which the tangents beside the cusp turn; where these go straight back, too, to
    // the right.
    double turn_at_cusp(double before, double after) const {
        constexpr double beside = 1e-3;
        const Interval domain = source_.curve().domain();
        const double step = beside * domain.length();
        const auto from = source_.at(std::max(before - step, domain.lower), Side::left);
        const auto to = source_.at(std::min(after + step, domain.upper), Side::right);
        const double turn = from && to ? angle_between(from->tangent, to->tangent) : 0.0;
        const bool is_left = turn > 0.0 && turn < std::numbers::pi - 1e-9;
        return is_left ? 0.5 * std::numbers::pi : -std::numbers::pi;
    }

    Result<void> add_corner(Point corner, const OffsetPlace& from, const OffsetPlace& to, double turn) {
        const double d = source_.distance();
        if (request_.corners == OffsetCorners::round) {
            const Vector start = from.point - corner;
            return circular_arc(corner, d, {std::atan2(start.y, start.x) * degrees, turn * degrees})
                .map([&](Curve arc) { add(std::move(arc), OffsetPartKind::exact); });
        }
        const Vector first = turned_left(from.tangent);
        const Vector second = turned_left(to.tangent);
        const double lean = 1.0 + dot(first, second);
        // |tip - corner| / d is the root of 2 / lean.
        const bool has_tip = request_.corners == OffsetCorners::mitre && 2.0 <= farthest_mitre * farthest_mitre * lean;
        std::vector<Point> points{end_of_parts()};
        if (has_tip) points.push_back(corner + d / lean * (first + second));
        points.push_back(to.point);
        return polyline(points).map([&](Curve around) {
            add(std::move(around), OffsetPartKind::exact);
            parts_.back().is_cut_off = !has_tip;
            parts_.back().center = corner;
        });
    }

    const OffsetSource& source_;
    std::size_t number_;
    const OffsetRequest& request_;
    std::vector<OffsetPart> parts_{};
};

}  // namespace

Result<std::vector<OffsetPart>> offset_parts(const OffsetSource& source, std::size_t number,
                                             const OffsetRequest& request) {
    return PartBuilder(source, number, request).build();
}

Result<OffsetPart> offset_cap(const OffsetSource& source, std::size_t number, const std::vector<OffsetPart>& parts,
                              Point to, OffsetCaps caps) {
    const Point center = source.curve().control_points().back();
    const Point from = parts.back().curve.control_points().back();
    const bool is_round = caps == OffsetCaps::round;
    const Vector start = from - center;
    Result<Curve> cap = is_round
                            ? circular_arc(center, source.distance(), {std::atan2(start.y, start.x) * degrees, -180.0})
                            : line(from, to);
    if (!cap) return refuse(cap.error());
    CurveDefinition definition = cap->definition();
    definition.points.front() = from;
    definition.points.back() = to;
    return Curve::make(std::move(definition)).map([&](Curve curve) {
        return OffsetPart{std::move(curve), OffsetPartKind::cap, number, !is_round, center};
    });
}

}  // namespace batten::core
