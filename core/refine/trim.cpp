#include "core/refine/trim.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "core/measure/intersect_curves.h"
#include "core/refine/extend.h"
#include "core/refine/join.h"
#include "core/refine/split.h"

namespace batten::core {

namespace {

// Cuts nearer than this part of the domain are one.
constexpr double same_cut = 1e-12;

// A contact nearer than this part of both curves is where the curve ends already.
constexpr double same_tip = 1e-12;

void add_contacts(std::vector<double>& cuts, const CurveContacts& found, bool with_second) {
    for (const CurveContact& contact : found.contacts) {
        cuts.push_back(contact.on_first.lower);
        cuts.push_back(contact.on_first.upper);
        if (!with_second) continue;
        cuts.push_back(contact.second_begin);
        cuts.push_back(contact.second_end);
    }
}

// The part of a closed curve from `begin` on to `end`, over the seam where that does not come after.
Result<Curve> part_of_ring(const Curve& curve, double begin, double end) {
    const Interval domain = curve.domain();
    if (curve.is_periodic() || begin < end) return sub_curve(curve, begin, end);
    auto before = sub_curve(curve, begin, domain.upper);
    if (!before || end == domain.lower) return before;
    auto behind = sub_curve(curve, domain.lower, end);
    if (!behind) return behind;
    return join(*before, *behind, JoinContinuity::c0, {CurveEnd::end, CurveEnd::start})
        .map([](const JoinedCurve& joined) { return joined.curve; });
}

double size_of_both(const Curve& curve, const Curve& other) {
    Box box = control_box(curve);
    const Box second = control_box(other);
    box.include(second.lower);
    box.include(second.upper);
    return robust_length(box.size());
}

struct Longer {
    Curve curve;
    bool is_longest;  // it cannot go further
};

Result<Longer> longer_by(const Curve& curve, CurveEnd end, Onward onward, double length) {
    auto longer = onward == Onward::straight ? extend_straight(curve, end, length) : extend_length(curve, end, length);
    if (longer) return Longer{*longer, false};
    const CurveError error = longer.error();
    if (error.code != CurveErrorCode::extension_too_far || !(error.upper > 0.0)) return refuse(error);
    return extend_length(curve, end, error.upper).map([](const Curve& longest) { return Longer{longest, true}; });
}

// Where the new part of `longer` meets the other curve first.
Result<std::optional<double>> first_contact(const Curve& curve, const Curve& longer, CurveEnd end, const Curve& other) {
    const double old = parameter_of(curve.domain(), end);
    const double tip = parameter_of(longer.domain(), end);
    const auto part = end == CurveEnd::end ? sub_curve(longer, old, tip) : sub_curve(longer, tip, old);
    if (!part) return refuse(part.error());
    std::optional<double> first;
    for (const CurveContact& contact : intersect_curves(*part, other).contacts)
        for (const double u : {contact.on_first.lower, contact.on_first.upper})
            if (u != old && (!first || std::abs(u - old) < std::abs(*first - old))) first = u;
    return first;
}

}  // namespace

std::vector<double> crossing_parameters(const Curve& curve, std::span<const Curve* const> others,
                                        const Progress& progress) {
    std::vector<double> cuts;
    add_contacts(cuts, self_intersections(curve, progress), true);
    for (const Curve* other : others) add_contacts(cuts, intersect_curves(curve, *other, progress), false);
    const Interval domain = curve.domain();
    const double near = same_cut * domain.length();
    const bool is_ring = is_closed(curve);
    const auto is_at_end = [&](double u) { return u - domain.lower <= near || domain.upper - u <= near; };
    if (is_ring)
        std::ranges::replace_if(cuts, is_at_end, domain.lower);
    else
        std::erase_if(cuts, is_at_end);
    std::ranges::sort(cuts);
    std::vector<double> result;
    for (const double u : cuts)
        if (result.empty() || u - result.back() > near) result.push_back(u);
    return result;
}

Result<Interval> part_around(const Curve& curve, double u, std::span<const double> cuts) {
    const bool is_ring = is_closed(curve);
    const std::size_t least = is_ring ? 2 : 1;
    if (cuts.size() < least) return refuse({.code = CurveErrorCode::nothing_crosses});
    const Interval domain = curve.domain();
    const auto next = std::ranges::upper_bound(cuts, u);
    if (!is_ring)
        return Interval{next == cuts.begin() ? domain.lower : *(next - 1), next == cuts.end() ? domain.upper : *next};
    if (next == cuts.begin() || next == cuts.end()) return Interval{cuts.back(), cuts.front() + domain.length()};
    return Interval{*(next - 1), *next};
}

Result<std::vector<Curve>> without_part(const Curve& curve, Interval part) {
    const Interval domain = curve.domain();
    if (is_closed(curve)) {
        const double begin = part.upper >= domain.upper ? part.upper - domain.length() : part.upper;
        return part_of_ring(curve, begin, part.lower).map([](const Curve& left) { return std::vector{left}; });
    }
    std::vector<Interval> kept;
    if (part.lower > domain.lower) kept.push_back({domain.lower, part.lower});
    if (part.upper < domain.upper) kept.push_back({part.upper, domain.upper});
    std::vector<Curve> parts;
    for (const Interval& range : kept) {
        auto left = sub_curve(curve, range.lower, range.upper);
        if (!left) return refuse(left.error());
        parts.push_back(*std::move(left));
    }
    return parts;
}

Result<std::vector<Curve>> split_at(const Curve& curve, std::span<const double> cuts) {
    const bool is_ring = is_closed(curve);
    std::vector<double> edges(cuts.begin(), cuts.end());
    if (!is_ring) {
        edges.insert(edges.begin(), curve.domain().lower);
        edges.push_back(curve.domain().upper);
    } else if (!cuts.empty()) {
        edges.insert(edges.begin(), cuts.back());
    }
    std::vector<Curve> parts;
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        auto part = is_ring ? part_of_ring(curve, edges[i], edges[i + 1]) : sub_curve(curve, edges[i], edges[i + 1]);
        if (!part) return refuse(part.error());
        parts.push_back(*std::move(part));
    }
    if (parts.empty()) parts.push_back(curve);
    return parts;
}

Result<Curve> extend_to(const Curve& curve, CurveEnd end, const Curve& other, Onward onward) {
    if (curve.is_periodic()) return refuse({.code = CurveErrorCode::curve_periodic});
    const double size = size_of_both(curve, other);
    const Point tip = point_at(curve, parameter_of(curve.domain(), end));
    for (const double share : {1.0 / 64, 1.0 / 8, 1.0, 4.0}) {
        const auto longer = longer_by(curve, end, onward, share * size);
        if (!longer) return refuse(longer.error());
        const auto contact = first_contact(curve, longer->curve, end, other);
        if (!contact) return refuse(contact.error());
        if (*contact) {
            if (robust_length(point_at(longer->curve, **contact) - tip) <= same_tip * size) return curve;
            return end == CurveEnd::end ? sub_curve(longer->curve, curve.domain().lower, **contact)
                                        : sub_curve(longer->curve, **contact, curve.domain().upper);
        }
        if (longer->is_longest) break;
    }
    return refuse({.code = CurveErrorCode::other_not_reached});
}

}  // namespace batten::core
