#include "exchange/written_curves.h"

#include <algorithm>
#include <cmath>

#include "core/base/double_double.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "exchange/refusal.h"

namespace batten::exchange {

namespace {

constexpr core::PluralPattern hidden{"one curve was left out, since it is hidden",
                                     "{count} curves were left out, since they are hidden"};
constexpr core::PluralPattern opened_periods{
    "'{place}' is periodic and was written as an open curve whose ends meet",
    "{count} curves are periodic and were written as open ones whose ends meet, the first one '{place}'"};
constexpr core::PluralPattern pictures{"one picture was left out; only curves are written",
                                       "{count} pictures were left out; only curves are written"};
constexpr core::PluralPattern without_place{"the format has no place for {reason} of the document",
                                            "the format has no place for {reason} of the document"};

// But for those of the view, which nobody expects in another format.
bool has_unknown_members(const core::Document& document) {
    return !document.unknown_members.empty() || (document.units && !document.units->unknown_members.empty());
}

bool has_unknown_members(const core::DocumentCurve& entry) {
    return !entry.unknown_members.empty() || !entry.unknown_fit_members.empty();
}

std::vector<std::string> parts_without_place(const core::Document& document, const FormatPlaces& places) {
    const auto has_any = [&](auto has) {
        return std::ranges::any_of(document.curves,
                                   [&](const core::DocumentCurve& entry) { return entry.visible && has(entry); });
    };
    using Entry = core::DocumentCurve;
    std::vector<std::string> parts;
    if (!document.title.empty()) parts.emplace_back("the title");
    if (!document.description.empty()) parts.emplace_back("the description");
    if (!places.colors && has_any([](const Entry& entry) { return entry.color.has_value(); }))
        parts.emplace_back("colors");
    if (has_any([](const Entry& entry) { return !entry.group.empty(); })) parts.emplace_back("groups");
    if (!places.locks && has_any([](const Entry& entry) { return entry.locked; })) parts.emplace_back("locks");
    if (has_any([](const Entry& entry) { return !entry.pinned.empty(); })) parts.emplace_back("pinned points");
    if (has_any([](const Entry& entry) { return entry.fit != nullptr; })) parts.emplace_back("fit points");
    if (has_any([](const Entry& entry) { return entry.symmetry.has_value(); })) parts.emplace_back("symmetries");
    if (has_any([](const Entry& entry) { return !entry.joints.is_empty(); })) parts.emplace_back("kept joints");
    if (!document.guides.empty()) parts.emplace_back("guides");
    const auto is_of_unknown = [](const Entry& entry) { return has_unknown_members(entry); };
    if (has_unknown_members(document) || has_any(is_of_unknown)) parts.emplace_back("unknown members");
    return parts;
}

// How far knot `i` of an unrolled vector is from the one that the period makes of it without rounding.
double rounding_of_knot(const core::KnotVector& knots, std::size_t i) {
    const std::span<const double> period = knots.stored();
    const auto n = static_cast<std::ptrdiff_t>(period.size()) - 1;
    const std::ptrdiff_t from_seam = static_cast<std::ptrdiff_t>(i) - knots.degree();
    const std::ptrdiff_t turns = (from_seam - (from_seam < 0 ? n - 1 : 0)) / n;
    const core::DoubleDouble length = core::exact_sum(period.back(), -period.front());
    const core::DoubleDouble exact = core::DoubleDouble(period[static_cast<std::size_t>(from_seam - turns * n)]) +
                                     core::DoubleDouble(static_cast<double>(turns)) * length;
    return std::abs((exact - core::DoubleDouble(knots[i])).rounded());
}

}  // namespace

core::FileResult<std::vector<const core::DocumentCurve*>> visible_curves(const core::Document& document) {
    std::vector<const core::DocumentCurve*> curves;
    for (const core::DocumentCurve& entry : document.curves)
        if (entry.visible) curves.push_back(&entry);
    if (document.curves.empty()) return refused_file("there is no curve to write");
    if (curves.empty()) return refused_file("no curve is visible; show one of them to write it");
    return curves;
}

core::CurveDefinition full_definition(const core::Curve& curve) {
    core::CurveDefinition definition = curve.definition();
    const std::span<const double> knots = curve.knots().values();
    const std::size_t count = knots.size() - static_cast<std::size_t>(curve.degree()) - 1;
    const std::size_t n = definition.points.size();
    definition.knots.assign(knots.begin(), knots.end());
    definition.points.resize(count);
    definition.weights.assign(curve.weights().begin(), curve.weights().end());
    definition.weights.resize(count);
    for (std::size_t i = n; i < count; ++i) {
        definition.points[i] = definition.points[i - n];
        definition.weights[i] = definition.weights[i - n];
    }
    if (std::ranges::all_of(definition.weights, [](double w) { return w == 1.0; })) definition.weights.clear();
    if (definition.periodic) definition.kind = core::KnotKind::custom;
    definition.periodic = false;
    definition.tears = core::Tears::allow;
    return definition;
}

// The derivative by a knot is a mean of the differences (P(i+1) - P(i)) / (u(i+p+1) - u(i+1)) over whose knots it is,
// of homogeneous points about the middle of the curve. Source: Schumaker, Spline Functions, 4.8.
double unrolling_error(const core::Curve& curve) {
    if (!curve.is_periodic()) return 0.0;
    const core::CurveDefinition full = full_definition(curve);
    const core::Box box = core::control_box(curve);
    const core::Point middle = core::middle(box.lower, box.upper);
    const double radius = core::distance(middle, box.upper);
    const auto weight = [&](std::size_t i) { return full.weights.empty() ? 1.0 : full.weights[i]; };
    const auto slope = [&](std::size_t i, std::size_t p) {
        const core::Vector lifted =
            weight(i + 1) * (full.points[i + 1] - middle) - weight(i) * (full.points[i] - middle);
        const double change = core::length(lifted) + radius * std::abs(weight(i + 1) - weight(i));
        return change / (full.knots[i + p + 1] - full.knots[i + 1]);
    };
    const auto p = static_cast<std::size_t>(curve.degree());
    double sum = 0.0;
    for (std::size_t k = 1; k + 1 < full.knots.size(); ++k) {
        const double rounding = rounding_of_knot(curve.knots(), k);
        if (rounding == 0.0) continue;
        double steepest = 0.0;
        for (std::size_t i = k > p + 1 ? k - p - 1 : 0; i < std::min(k, full.points.size() - 1); ++i)
            steepest = std::max(steepest, slope(i, p));
        sum += rounding * steepest;
    }
    constexpr double higher_terms = 2.0;
    return higher_terms * sum / *std::ranges::min_element(curve.weights());
}

void note_losses(Notes& notes, const core::Document& document, const FormatPlaces& places) {
    const auto nowhere = [] { return std::string(); };
    for (const core::DocumentCurve& entry : document.curves) {
        const auto name = [&] { return entry.name; };
        if (!entry.visible) notes.add(hidden, name);
        if (entry.visible && entry.curve->is_periodic() && !places.periodic) notes.add(opened_periods, name);
    }
    for (std::size_t i = 0; i < document.pictures.size(); ++i) notes.add(pictures, nowhere);
    if (document.units && !places.units)
        notes.add("the unit of length was left out, since the format has none; the numbers stay as they are");
    const std::vector<std::string> parts = parts_without_place(document, places);
    if (!parts.empty()) notes.add(without_place, nowhere, {}, core::listed_as_alternatives(parts));
}

}  // namespace batten::exchange
