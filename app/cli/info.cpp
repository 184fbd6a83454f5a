#include <fmt/core.h>

#include <cmath>
#include <optional>
#include <ostream>

#include "app/cli/input.h"
#include "app/cli/json_output.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/knot_analysis.h"
#include "core/measure/arc_length.h"
#include "core/measure/bounds.h"

namespace batten::cli {

namespace {

constexpr const char* not_known = "not known: the weights or points are too far apart";

// The distinct knots of the closed domain; the others move the ends of the curve but part nothing.
template <class Use>
void visit_knots_of_domain(const core::Curve& curve, Use use) {
    core::visit_distinct_knots(curve.knots(), [&](const core::DistinctKnot& knot) {
        if (knot.in_domain) use(knot);
    });
}

Json json_of_knot(const core::DistinctKnot& knot) {
    Json result{{"value", knot.value}, {"multiplicity", knot.multiplicity}};
    if (knot.is_interior) result["continuity"] = knot.continuity;
    return result;
}

// None where the curve is beyond doubles.
std::optional<core::Box> bounds_of(const core::Curve& curve) {
    const core::Box box = core::tight_box(curve);
    return core::is_finite(box.lower) && core::is_finite(box.upper) ? std::optional(box) : std::nullopt;
}

Json json_of_box(const core::Box& box) {
    return Json::array({json_of(box.lower), json_of(box.upper)});
}

// None where it cannot be computed.
std::optional<double> length_of(const core::Curve& curve) {
    const core::Integral length = core::arc_length(curve);
    return core::is_sharp(length) ? std::optional(length.value) : std::nullopt;
}

// All but the knots, of which there may be millions.
Json head_of_curve(const core::DocumentCurve& entry) {
    const core::Curve& curve = *entry.curve;
    const std::optional<core::Box> bounds = bounds_of(curve);
    const std::optional<double> length = length_of(curve);
    return {{"name", entry.name},
            {"degree", curve.degree()},
            {"kind", core::title_of(core::kind_by_values(curve.knots()))},
            {"periodic", curve.is_periodic()},
            {"rational", curve.is_rational()},
            {"clamped", core::is_clamped(curve.knots())},
            {"uniform", core::is_uniform(curve.knots())},
            {"points", curve.control_points().size()},
            {"segments", core::segment_count(curve.knots())},
            {"domain", Json::array({curve.domain().lower, curve.domain().upper})},
            {"length", length ? Json(*length) : Json(nullptr)},
            {"bounds", bounds ? json_of_box(*bounds) : Json(nullptr)}};
}

void print_json(std::ostream& out, const std::filesystem::path& file, const core::Document& document) {
    ListPrinter curves(out, Json::object({{"file", file.string()}}), "curves");
    for (const core::DocumentCurve& entry : document.curves) {
        ListPrinter knots(out, head_of_curve(entry), "knots", curves.begin_item());
        visit_knots_of_domain(*entry.curve, [&](const core::DistinctKnot& knot) { knots.add(json_of_knot(knot)); });
        knots.end();
    }
    curves.end();
    out << '\n';
}

std::string text_of(const core::DistinctKnot& knot) {
    const std::string value = core::shortest_text(knot.value);
    if (!knot.is_interior) return fmt::format("{}\tmultiplicity {}", value, knot.multiplicity);
    if (knot.continuity < 0) return fmt::format("{}\tmultiplicity {}\tjump", value, knot.multiplicity);
    return fmt::format("{}\tmultiplicity {}\tC^{}", value, knot.multiplicity, knot.continuity);
}

std::string length_text(const core::Curve& curve) {
    if (const auto length = length_of(curve)) return core::shortest_text(*length);
    return std::isfinite(core::arc_length(curve).value) ? not_known : "too large for a double";
}

std::string bounds_text(const core::Curve& curve) {
    const std::optional<core::Box> bounds = bounds_of(curve);
    return bounds ? core::sentence("{lower} to {upper}",
                                   {{"lower", point_text(bounds->lower)}, {"upper", point_text(bounds->upper)}})
                  : not_known;
}

void print_curve(std::ostream& out, const core::DocumentCurve& entry) {
    const core::Curve& curve = *entry.curve;
    out << entry.name << '\n'
        << "  kind      " << core::title_of(core::kind_by_values(curve.knots()))
        << (curve.is_rational() ? ", rational" : "") << '\n'
        << "  degree    " << curve.degree() << '\n'
        << "  points    " << curve.control_points().size() << '\n'
        << "  segments  " << core::segment_count(curve.knots()) << '\n'
        << "  domain    " << core::shortest_text(curve.domain().lower) << " to "
        << core::shortest_text(curve.domain().upper) << '\n'
        << "  length    " << length_text(curve) << '\n'
        << "  bounds    " << bounds_text(curve) << '\n'
        << "  knots\n";
    visit_knots_of_domain(curve, [&](const core::DistinctKnot& knot) { out << "    " << text_of(knot) << '\n'; });
}

}  // namespace

ExitStatus info(const InfoOptions& options, Output output) {
    const std::optional<core::Document> document = load(output, options.file);
    if (!document) return ExitStatus::wrong_input;
    if (options.as_json)
        print_json(output.results, options.file, *document);
    else
        for (const core::DocumentCurve& entry : document->curves) print_curve(output.results, entry);
    return ExitStatus::done;
}

}  // namespace batten::cli
