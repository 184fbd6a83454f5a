#include "app/editor/state/followed_marks.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

// Control point i of a reversed period is the old p - 1 - i.
bool has_points_backwards(const core::Curve& old, const core::Curve& now) {
    const auto a = old.control_points();
    const auto b = now.control_points();
    if (!now.is_periodic()) return std::equal(a.begin(), a.end(), b.rbegin(), b.rend());
    const auto first = b.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(now.degree()) % b.size());
    return a.size() == b.size() && std::equal(std::make_reverse_iterator(first), b.rend(), a.begin()) &&
           std::equal(b.rbegin(), std::make_reverse_iterator(first), a.begin() + (first - b.begin()));
}

// Whether a closed curve, or a part of it, begins elsewhere now and goes on over the seam, with the same parameters but
// for a period.
bool has_moved_seam(const core::Curve& old, const core::Curve& now) {
    constexpr double rounding = 1e-12;
    const core::Interval before = old.domain();
    const core::Interval after = now.domain();
    return before.lower < after.lower && after.lower < before.upper && before.upper < after.upper &&
           after.length() <= (1.0 + rounding) * before.length() &&
           !std::ranges::equal(old.control_points(), now.control_points());
}

// The knot that is `wanted` but for rounding; `otherwise` where there is none.
double knot_like(std::span<const double> knots, double wanted, double otherwise) {
    constexpr double rounding = 1e-9;
    const double nearest = *std::ranges::min_element(knots, {}, [&](double knot) { return std::abs(knot - wanted); });
    return std::abs(nearest - wanted) <= rounding * (knots.back() - knots.front()) ? nearest : otherwise;
}

// Where the knot u of `old` is in `now`: the same one by its number where there are as many, else by its value.
double moved_knot(const core::Curve& old, const core::Curve& now, double u) {
    const auto before = old.knots().stored();
    const auto after = now.knots().stored();
    if (has_moved_seam(old, now)) {
        if (u >= now.domain().lower) return u;
        return knot_like(after, u + old.domain().length(), u);
    }
    if (old.degree() != now.degree() || before.size() != after.size() || old.is_periodic() != now.is_periodic())
        return u;
    const auto [first, end] = std::equal_range(before.begin(), before.end(), u);
    if (first == end) return u;
    auto index = static_cast<std::size_t>((first - before.begin()) + (end - first) / 2);
    if (is_reversed(old, now)) index = before.size() - 1 - index;
    const bool is_seam = now.is_periodic() && after[index] == now.domain().upper;
    return is_seam ? now.domain().lower : after[index];
}

// The knot of `now` that u of `joined` became, where that curve is the part `added`, run through as before or not.
std::optional<double> joined_knot(const core::Curve& joined, const core::Curve& now, core::Interval added, double u,
                                  bool is_reversed) {
    constexpr double rounding = 1e-9;
    const core::Interval domain = joined.domain();
    const double share = (is_reversed ? domain.upper - u : u - domain.lower) / domain.length();
    const double wanted = added.lower + share * added.length();
    const auto knots = now.knots().stored();
    const auto above = std::ranges::lower_bound(knots, wanted - rounding * added.length());
    if (above == knots.end() || *above > wanted + rounding * added.length()) return std::nullopt;
    return *above;
}

}  // namespace

bool is_reversed(const core::Curve& old, const core::Curve& now) {
    return old.degree() == now.degree() && old.is_periodic() == now.is_periodic() &&
           old.knots().stored().size() == now.knots().stored().size() && has_points_backwards(old, now) &&
           !std::ranges::equal(old.control_points(), now.control_points());
}

void follow_knots(const core::Curve& old, core::DocumentCurve& entry) {
    auto& marks = entry.joints.knots;
    for (core::KnotMark& mark : marks) mark.u = moved_knot(old, *entry.curve, mark.u);
    std::ranges::sort(marks, [](const core::KnotMark& a, const core::KnotMark& b) {
        return std::pair(a.u, a.mark) < std::pair(b.u, b.mark);
    });
    const auto is_same_knot = [](const core::KnotMark& a, const core::KnotMark& b) { return a.u == b.u; };
    marks.erase(std::unique(marks.begin(), marks.end(), is_same_knot), marks.end());
}

void follow_ends(const core::Curve& old, core::DocumentCurve& entry) {
    if (!is_reversed(old, *entry.curve)) return;
    for (core::EndMark& mark : entry.joints.ends)
        mark.end = mark.end == core::CurveEnd::start ? core::CurveEnd::end : core::CurveEnd::start;
    std::ranges::reverse(entry.joints.ends);
}

bool is_at_old_place(const core::Curve& old, core::CurveEnd old_end, const core::Curve& now, core::CurveEnd end) {
    constexpr double rounding = 1e-9;
    const core::Point before = core::point_at(old, core::parameter_of(old.domain(), old_end));
    const core::Point after = core::point_at(now, core::parameter_of(now.domain(), end));
    return core::distance(before, after) <= rounding * core::robust_length(core::control_box(old).size());
}

core::Interval added_part(const core::Curve& old, const core::Curve& now) {
    const core::Interval before = old.domain();
    const core::Interval after = now.domain();
    if (after.lower == before.lower && after.upper > before.upper) return {before.upper, after.upper};
    if (after.upper == before.upper && after.lower < before.lower) return {after.lower, before.lower};
    return {};
}

std::optional<std::vector<core::KnotMark>> joined_marks(const core::DocumentCurve& joined, const core::Curve& now,
                                                        core::Interval added) {
    for (const bool is_reversed : {false, true}) {
        std::vector<core::KnotMark> marks;
        const core::Interval domain = joined.curve->domain();
        bool has_all = true;
        for (const double u : joined.curve->knots().stored())
            has_all = has_all && (!domain.contains(u) || joined_knot(*joined.curve, now, added, u, is_reversed));
        if (!has_all) continue;
        for (const core::KnotMark& mark : joined.joints.knots)
            marks.push_back(
                {*joined_knot(*joined.curve, now, added, mark.u, is_reversed), mark.mark, mark.unknown_members});
        return marks;
    }
    return std::nullopt;
}

}  // namespace batten::editor
