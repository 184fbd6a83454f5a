#include "exchange/cad/cad_curves.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/measure/deviation.h"
#include "core/refine/clamping.h"
#include "core/refine/periodic.h"
#include "core/refine/reparametrize.h"
#include "exchange/refusal.h"
#include "exchange/written_curves.h"

namespace batten::exchange {

namespace {

using core::PluralPattern;

constexpr PluralPattern torn{"'{place}' was left out, since it comes apart at a knot",
                             "{count} curves were left out, since they come apart at a knot, the first one '{place}'"};
constexpr PluralPattern clamped_ends{"'{place}' was written with clamped ends",
                                     "{count} curves were written with clamped ends, the first one '{place}'"};
constexpr PluralPattern over_unit_interval{
    "'{place}' was written over the parameters from 0 to 1, since its own are too near each other",
    "{count} curves were written over the parameters from 0 to 1, since their own are too near each other, the first "
    "one '{place}'"};
constexpr PluralPattern near_knots{
    "'{place}' was left out, since its knots are too near each other for OpenCASCADE",
    "{count} curves were left out, since their knots are too near each other for OpenCASCADE, the first one '{place}'"};
constexpr PluralPattern tiny_weights{
    "'{place}' was left out, since its weights are too small for OpenCASCADE",
    "{count} curves were left out, since their weights are too small for OpenCASCADE, the first one '{place}'"};
constexpr PluralPattern not_clampable{
    "'{place}' was left out, since it cannot be written with clamped ends",
    "{count} curves were left out, since they cannot be written with clamped ends, the first one '{place}'"};

constexpr double pixels_in_an_inch = 96.0;

// Domains below a thousandth of this length lose parts or are refused when OpenCASCADE reads them.
constexpr double shortest_domain = 1e-6;

void set_unit(CadCurves& result, const core::Document& document) {
    if (!document.units) return result.notes.add("the document has no unit; its numbers were written as millimeters");
    result.unit = document.units->unit;
    result.world = document.units->scale;
    if (result.unit != core::LengthUnit::px) return;
    result.unit = core::LengthUnit::inch;
    result.world *= pixels_in_an_inch;
    result.notes.add("the lengths, which are pixels, were written in inches, 96 pixels each");
}

bool is_clamped(const core::Curve& curve) {
    return !curve.is_periodic() && core::is_clamped_at(curve.knots(), core::CurveEnd::start) &&
           core::is_clamped_at(curve.knots(), core::CurveEnd::end);
}

// The curve with every coordinate multiplied or divided; and how far that is off by rounding, before it.
struct Scaled {
    core::Result<core::Curve> curve;
    double error = 0.0;
};

Scaled in_units(const core::Curve& curve, double world) {
    if (world == 1.0) return {curve};
    core::CurveDefinition definition = curve.definition();
    double error = 0.0;
    const auto lost = [world](double coordinate) { return std::fma(coordinate / world, world, -coordinate); };
    for (core::Point& point : definition.points) {
        error = std::max(error, std::hypot(lost(point.x), lost(point.y)));
        point = {point.x / world, point.y / world};
    }
    return {core::Curve::make(std::move(definition)), error};
}

// Weights that draw the same, since all are multiplied by one power of two: programs that read IGES through OpenCASCADE
// refuse those below 1e-9, and take such as differ from the first by less than 1e-10 for equal.
core::Result<core::Curve> with_larger_weights(const core::Curve& curve) {
    constexpr int least_weight = -29;  // as exponents of two
    constexpr int least_difference = -33;
    constexpr int largest_weight = 1000;
    const std::span<const double> weights = curve.weights();
    const auto [least, largest] = std::ranges::minmax(weights);
    int steps = std::max(0, least_weight - std::ilogb(least));
    for (const double weight : weights)
        if (weight != weights.front()) steps = std::max(steps, least_difference - std::ilogb(weight - weights.front()));
    if (!curve.is_rational() || steps == 0 || std::ilogb(largest) + steps > largest_weight) return curve;
    core::CurveDefinition definition = curve.definition();
    for (double& weight : definition.weights) weight = std::ldexp(weight, steps);
    return core::Curve::make(std::move(definition));
}

// By the conditions of Geom_BSplineCurve: a distinct knot is beyond the double next to the one before it, and the
// weights of a rational curve are above the least normal double. None: OpenCASCADE takes the curve.
const PluralPattern* refusal_by_occt(const core::Curve& curve) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto are_near = [](double knot, double next) {
        return next > knot && next - knot <= std::nextafter(std::abs(knot), infinity) - std::abs(knot);
    };
    const std::span<const double> knots = curve.knots().values();
    if (std::ranges::adjacent_find(knots, are_near) != knots.end()) return &near_knots;
    const bool is_tiny = std::ranges::min(curve.weights()) <= std::numeric_limits<double>::min();
    return curve.is_rational() && is_tiny ? &tiny_weights : nullptr;
}

class CadWriter {
  public:
    CadWriter(const core::Document& document, CadWeights weights) : weights_(weights) { set_unit(result_, document); }

    void add(const core::DocumentCurve& entry) {
        const core::Curve& curve = *entry.curve;
        const auto name = [&] { return entry.name; };
        if (curve.is_torn()) return result_.notes.add(torn, name);
        const bool was_clamped = is_clamped(curve);
        const bool is_short = curve.domain().upper - curve.domain().lower < shortest_domain;
        const auto clamped = was_clamped ? core::Result<core::Curve>(curve) : core::to_clamped(curve);
        const auto placed = clamped.and_then([&](const core::Curve& c) {
            return is_short ? core::reparametrize(c, {0.0, 1.0}) : core::Result<core::Curve>(c);
        });
        if (!placed) return result_.notes.add(not_clampable, name);
        if (!was_clamped && !curve.is_periodic()) result_.notes.add(clamped_ends, name);
        if (is_short) result_.notes.add(over_unit_interval, name);
        const bool is_other = !was_clamped || is_short;
        Scaled scaled = in_units(*placed, result_.world);
        if (weights_ == CadWeights::larger) scaled.curve = scaled.curve.and_then(with_larger_weights);
        if (!scaled.curve) return result_.notes.add(not_clampable, name);
        if (const PluralPattern* refusal = refusal_by_occt(*scaled.curve)) return result_.notes.add(*refusal, name);
        const double error =
            scaled.error + (is_other ? core::largest_deviation(*placed, curve) + unrolling_error(curve) : 0.0);
        result_.curves.push_back({entry.name, *std::move(scaled.curve), error});
    }

    core::FileResult<CadCurves> take() {
        if (!result_.curves.empty()) return std::move(result_);
        return refused_file(result_.notes.sentences().back());
    }

    CadCurves& result() { return result_; }

  private:
    CadWeights weights_;
    CadCurves result_;
};

}  // namespace

core::FileResult<CadCurves> cad_curves(const core::Document& document, CadWeights weights) {
    const auto entries = visible_curves(document);
    if (!entries) return tl::unexpected(entries.error());
    CadWriter writer(document, weights);
    note_losses(writer.result().notes, document, {.units = true});
    for (const core::DocumentCurve* entry : *entries) writer.add(*entry);
    return writer.take();
}

double copy_error(const CadCurves& curves, const CadCurve& written, const core::Curve& copy) {
    return curves.world * core::largest_deviation(written.curve, copy);
}

}  // namespace batten::exchange
