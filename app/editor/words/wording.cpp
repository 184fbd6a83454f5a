#include "app/editor/words/wording.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "app/editor/words/formula.h"
#include "app/editor/words/number_column.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "core/measure/bounds.h"

namespace batten::editor {

namespace {

// What storing a coordinate and computing with it a little may change, as a part of it.
constexpr double coordinate_rounding = 4.0 * std::numeric_limits<double>::epsilon();

// 0 for an empty box.
double tolerance_in(const core::Box& box, double relative) {
    if (box.is_empty()) return 0.0;
    return std::max(relative * std::max(box.size().x, box.size().y), coordinate_rounding * largest_coordinate(box));
}

std::string deviation_sentence(const std::string& done, const Distances& distances) {
    const std::string deviation = length_words(distances.units, *distances.deviation);
    if (distances.is_rounding)
        return core::sentence("{done}; the curve is unchanged but for rounding, at most {deviation}",
                              {{"done", done}, {"deviation", deviation}});
    if (distances.of_shapes)
        return core::sentence(
            "{done}; the curve moved by at most {deviation} at equal parameters, its shape by at most {shape}",
            {{"done", done}, {"deviation", deviation}, {"shape", length_words(distances.units, *distances.of_shapes)}});
    return core::sentence("{done}; the curve moved by at most {deviation}", {{"done", done}, {"deviation", deviation}});
}

}  // namespace

std::string done_sentence(const std::string& done, ShapeEffect effect, const Distances& distances) {
    const auto& [deviation, of_shapes, error, is_rounding, units] = distances;
    if (!std::isfinite(deviation.value_or(0.0)) || !std::isfinite(error.value_or(0.0)))
        return core::sentence(
            "{done}; how far the curve moved cannot be computed: its points, weights or knots are too far apart, too "
            "large or too small",
            {{"done", done}});
    const bool is_unchanged = deviation ? *deviation == 0.0 : effect == ShapeEffect::keeps && !error;
    if (is_unchanged) return core::sentence("{done}; the curve is unchanged", {{"done", done}});
    if (deviation) return deviation_sentence(done, distances);
    if (!error) return done;
    const core::Place most("error", length_words(units, *error));
    if (effect == ShapeEffect::keeps)
        return core::sentence("{done}; the shape is kept up to rounding of far control points, error at most {error}",
                              {{"done", done}, most});
    return core::sentence("{done}; error at most {error}", {{"done", done}, most});
}

std::string nothing_changed_sentence() {
    return "Nothing had to be changed";
}

StepTexts texts_of_deleted_knot(const core::Curve& before, std::size_t index, const core::Curve& after) {
    const core::Place knot("knot", core::shortest_text(before.knots().stored()[index]));
    const auto old = before.control_points();
    const auto gone = std::mismatch(old.begin(), old.end() - 1, after.control_points().begin()).first - old.begin();
    return {core::sentence("Delete knot {knot}", {knot}),
            core::sentence("Deleted knot {knot} and {point}",
                           {knot, {"point", point_text(static_cast<std::size_t>(gone))}})};
}

double largest_coordinate(const core::Box& box) {
    if (box.is_empty()) return 0.0;
    return std::max({std::abs(box.lower.x), std::abs(box.lower.y), std::abs(box.upper.x), std::abs(box.upper.y)});
}

std::vector<double> without_rounding(std::span<const double> values) {
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    std::vector<double> kept(values.begin(), values.end());
    for (double& value : kept)
        if (std::isfinite(largest) && std::abs(value) <= rounding_error * largest) value = 0.0;
    return kept;
}

core::Vector without_rounding(core::Vector vector) {
    const std::vector<double> kept = without_rounding(std::array{vector.x, vector.y});
    return {kept[0], kept[1]};
}

double coordinate_error(const core::Curve& curve) {
    return coordinate_error(core::tight_box(curve));
}

double coordinate_error(const core::Box& box) {
    return rounding_error * largest_coordinate(box);
}

double shape_tolerance(const core::Curve& curve, double relative) {
    return tolerance_in(core::tight_box(curve), relative);
}

bool is_within_tolerance(const core::Curve& curve, double deviation, double relative) {
    // The box of the control points allows no less, and is found at once.
    return deviation <= tolerance_in(core::control_box(curve), relative) &&
           deviation <= shape_tolerance(curve, relative);
}

std::string clamped_sentence(const core::KnotVector& knots, double asked, double taken) {
    return core::sentence(knots.is_periodic()
                              ? "u = {asked} is outside the domain from {lower} to {upper}; a closed curve has {taken} "
                                "there"
                              : "u = {asked} is outside the domain from {lower} to {upper}; its end {taken} is taken",
                          {{"asked", core::shortest_text(asked)},
                           {"lower", core::shortest_text(knots.domain().lower)},
                           {"upper", core::shortest_text(knots.domain().upper)},
                           {"taken", core::shortest_text(taken)}});
}

std::string place_words(const Units& units, core::Point place, double error) {
    const auto words = [&](double value) {
        return message_text(in_units(units, std::abs(value) <= error ? 0.0 : value));
    };
    return with_unit(units, core::sentence("({x}, {y})", {{"x", words(place.x)}, {"y", words(place.y)}}));
}

std::string bound_words(const Units& units, double world, int digits) {
    return with_unit(units, bound_text(in_units(units, world), digits));
}

std::string place_text(const Units& units, double size, core::Point place) {
    return with_unit(units, place_text(in_units(units, size), in_units(units, place)));
}

std::string curves_text(const core::Document& document, const std::vector<std::size_t>& curves) {
    if (curves.size() == 1 && curves.front() < document.curves.size())
        return core::sentence("'{name}'", {{"name", document.curves[curves.front()].name}});
    return core::sentence({.one = "one curve", .many = "{count} curves", .none = "no curves"}, curves.size());
}

std::string knot_words(const core::Curve& curve, double u) {
    const core::KnotVector& knots = curve.knots();
    const int multiplicity = knots.multiplicity(u);
    const core::Place times("multiplicity", multiplicity);
    const core::Interval domain = curve.domain();
    if (!domain.contains(u)) return core::sentence("multiplicity {multiplicity}, outside the domain", {times});
    const bool is_inside = curve.is_periodic() || (domain.lower < u && u < domain.upper);
    if (!is_inside && multiplicity > curve.degree())
        return core::sentence("multiplicity {multiplicity}, a clamped end", {times});
    if (!is_inside) return core::sentence("multiplicity {multiplicity}, an end of the domain", {times});
    if (multiplicity > curve.degree()) return core::sentence("multiplicity {multiplicity}, a gap there", {times});
    return core::sentence("multiplicity {multiplicity}, {continuity} there",
                          {times, {"continuity", plain_text(continuity_text(curve.degree() - multiplicity))}});
}

}  // namespace batten::editor
