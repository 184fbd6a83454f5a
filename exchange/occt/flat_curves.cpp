#include "exchange/occt/flat_curves.h"

#include <BRep_Tool.hxx>
#include <GeomConvert.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BezierCurve.hxx>
#include <Geom_Conic.hxx>
#include <Geom_Line.hxx>
#include <Geom_TrimmedCurve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <gp_Mat.hxx>
#include <limits>

#include "core/curve/approximation.h"
#include "core/curve/control_box.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "core/refine/clamping.h"
#include "core/refine/periodic.h"
#include "core/refine/split.h"

namespace batten::exchange::occt {

namespace {

constexpr double unit_of_rounding = std::numeric_limits<double>::epsilon();

// Parts of the size of a curve, or of its domain.
constexpr double flatness = 1e-9;
constexpr double same_parameter = 1e-12;
constexpr double rounded_parameter = 1e-6;
constexpr double closing_tolerance = 1e-12;

FlatCurve no_curve(LeftOut why, std::string reason = {}) {
    FlatCurve result;
    result.why = why;
    result.reason = std::move(reason);
    return result;
}

SpatialCurve spatial_curve(const Geom_BSplineCurve& spline) {
    SpatialCurve curve{.shape = {.degree = spline.Degree()}};
    for (int k = 1; k <= spline.NbKnots(); ++k)
        curve.shape.knots.insert(curve.shape.knots.end(), static_cast<std::size_t>(spline.Multiplicity(k)),
                                 spline.Knot(k));
    for (int i = 1; i <= spline.NbPoles(); ++i) {
        curve.points.push_back(spline.Pole(i).XYZ());
        if (spline.IsRational()) curve.shape.weights.push_back(spline.Weight(i));
    }
    return curve;
}

// A point where it is placed, and how far the rounding of its coordinates takes it from there.
struct PlacedPoint {
    gp_XYZ point;
    double rounding = 0.0;
};

// All in numbers of more digits than the coordinates have, which are rounded once.
PlacedPoint placed(const gp_XYZ& point, const std::vector<gp_GTrsf>& placements) {
    std::array<long double, 3> at{point.X(), point.Y(), point.Z()};
    for (const gp_GTrsf& placement : placements) {
        std::array<long double, 3> next{};
        for (int row = 1; row <= 3; ++row) {
            long double& sum = next[static_cast<std::size_t>(row) - 1];
            sum = placement.Value(row, 4);
            for (int column = 1; column <= 3; ++column)
                sum +=
                    static_cast<long double>(placement.Value(row, column)) * at[static_cast<std::size_t>(column) - 1];
        }
        at = next;
    }
    const gp_XYZ rounded(static_cast<double>(at[0]), static_cast<double>(at[1]), static_cast<double>(at[2]));
    return {rounded, static_cast<double>(std::hypot(at[0] - rounded.X(), at[1] - rounded.Y(), at[2] - rounded.Z()))};
}

gp_Mat matrix_of(const gp_GTrsf& placement) {
    gp_Mat matrix;
    for (int row = 1; row <= 3; ++row)
        for (int column = 1; column <= 3; ++column) matrix.SetValue(row, column, placement.Value(row, column));
    return matrix;
}

// By how much lengths grow there, at most: the root of the largest sums along a row and along a column bounds the norm
// of a matrix. Source: Golub, Van Loan, Matrix Computations, 2.3.3.
double growth(const std::vector<gp_GTrsf>& placements) {
    gp_Mat product;
    product.SetIdentity();
    for (const gp_GTrsf& placement : placements) product = matrix_of(placement) * product;
    const auto sum = [](const gp_XYZ& line) { return std::abs(line.X()) + std::abs(line.Y()) + std::abs(line.Z()); };
    double rows = 0.0;
    double columns = 0.0;
    for (int i = 1; i <= 3; ++i) {
        rows = std::max(rows, sum(product.Row(i)));
        columns = std::max(columns, sum(product.Column(i)));
    }
    return std::sqrt(rows) * std::sqrt(columns);
}

// The points in the plane, and in `result` their height, how far they are from one height, and how they are rounded.
std::optional<core::CurveDefinition> flattened(const SpatialCurve& curve, FlatCurve& result) {
    core::CurveDefinition definition = curve.shape;
    definition.tears = core::Tears::allow;
    double lower = std::numeric_limits<double>::infinity();
    double upper = -lower;
    double size = 0.0;
    double rounding = 0.0;
    std::optional<gp_XYZ> first;
    for (const gp_XYZ& point : curve.points) {
        const PlacedPoint at = placed(point, curve.placements);
        if (!first) first = at.point;
        lower = std::min(lower, at.point.Z());
        upper = std::max(upper, at.point.Z());
        size = std::max(size, (at.point - *first).Modulus());
        rounding = std::max(rounding, at.rounding);
        definition.points.emplace_back(at.point.X(), at.point.Y());
    }
    if (!(upper - lower <= flatness * size)) return std::nullopt;
    result.height = lower + 0.5 * (upper - lower);
    result.error = upper - lower + rounding;
    if (curve.error == 0.0) return definition;
    const double larger = growth(curve.placements);
    result.error += curve.error * larger;
    result.contradiction = curve.contradiction * larger;
    return definition;
}

core::Result<core::Curve> of_its_kind(core::CurveDefinition definition) {
    core::Result<core::Curve> curve = core::Curve::make(definition);
    if (!curve) return curve;
    definition.kind = core::classify(curve->knots());
    return core::Curve::make(std::move(definition));
}

// What OpenCASCADE computes from lengths and angles.
double rounding_at(const gp_XYZ& point) {
    constexpr double operations = 4.0;
    return operations * unit_of_rounding * point.Modulus();
}

double rounding_along(const SpatialCurve& curve) {
    double largest = 0.0;
    for (const gp_XYZ& point : curve.points) largest = std::max(largest, rounding_at(point));
    return largest;
}

double rounding_along(const core::Curve& curve) {
    constexpr double operations = 4.0;
    double largest = 0.0;
    for (const core::Point point : curve.control_points())
        largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    return operations * unit_of_rounding * largest;
}

// Where a curve is cut, its points become means of means.
core::Result<core::Curve> cut_between(const core::Curve& curve, double first, double last, double& error) {
    auto part = core::sub_curve(curve, first, last);
    if (part) error += (curve.degree() + 1) * rounding_along(curve);
    return part;
}

// The part that an edge has of its curve; all of it where its parameters are rounded ones of the ends.
core::Result<core::Curve> part_of_edge(const core::Curve& curve, double first, double last, double& error) {
    const core::Interval domain = curve.domain();
    const core::Interval part{std::max(first, domain.lower), std::min(last, domain.upper)};
    const double small = same_parameter * std::max(domain.upper - domain.lower, std::abs(domain.upper));
    if (part.lower - domain.lower > small || domain.upper - part.upper > small)
        return cut_between(curve, part.lower, part.upper, error);
    constexpr double beyond_chord = 2.0;
    error += beyond_chord * (core::distance(core::point_at(curve, domain.lower), core::point_at(curve, part.lower)) +
                             core::distance(core::point_at(curve, part.upper), core::point_at(curve, domain.upper)));
    return curve;
}

core::Result<core::Curve> opened(const Geom_BSplineCurve& spline) {
    const auto copy = Handle(Geom_BSplineCurve)::DownCast(spline.Copy());
    copy->SetNotPeriodic();
    FlatCurve result;
    return of_its_kind(*flattened(spatial_curve(*copy), result))
        .and_then(core::clamp_ends)
        .and_then([](const core::Curve& curve) { return of_its_kind(curve.definition()); });
}

// A periodic curve with a seam at which only its ends meet is better known as clamped, as files have it.
std::optional<core::Approximation> closed_smoothly(const core::Curve& curve) {
    const core::Box box = core::control_box(curve);
    const double size = std::max(box.upper.x - box.lower.x, box.upper.y - box.lower.y);
    const auto closed = core::to_periodic(curve, closing_tolerance * size);
    return closed ? std::optional(*closed) : std::nullopt;
}

FlatCurve flat_spline(const Geom_BSplineCurve& spline, double first, double last) {
    FlatCurve result;
    const SpatialCurve spatial = spatial_curve(spline);
    const auto definition = flattened(spatial, result);
    if (!definition) return no_curve(LeftOut::in_another_plane);
    const bool is_smooth_at_seam = spline.IsPeriodic() && spline.Multiplicity(1) < spline.Degree();
    const auto curve = spline.IsPeriodic() ? opened(spline) : of_its_kind(*definition);
    if (!curve) return no_curve(LeftOut::not_computable, core::describe(curve.error()));
    const auto part = part_of_edge(*curve, first, last, result.error);
    if (!part) return no_curve(LeftOut::not_computable, core::describe(part.error()));
    result.curve = *part;
    if (spline.IsPeriodic()) result.error += rounding_along(spatial);
    if (!is_smooth_at_seam || result.curve != *curve) return result;
    if (const auto closed = closed_smoothly(*curve)) {
        result.curve = closed->curve;
        result.error += closed->error;
    }
    return result;
}

FlatCurve flat_line(const Geom_Line& line, double first, double last) {
    const gp_Pnt a = line.Value(first);
    const gp_Pnt b = line.Value(last);
    FlatCurve result;
    const auto definition =
        flattened({.shape = {.degree = 1, .knots = {0.0, 0.0, 1.0, 1.0}}, .points = {a.XYZ(), b.XYZ()}}, result);
    if (!definition) return no_curve(LeftOut::in_another_plane);
    const auto curve = of_its_kind(*definition);
    if (!curve) return no_curve(LeftOut::not_computable, core::describe(curve.error()));
    result.curve = *curve;
    result.error += rounding_at(a.XYZ()) + rounding_at(b.XYZ());
    return result;
}

FlatCurve flat_geometry(Handle(Geom_Curve) curve, double first, double last) {
    while (const auto trimmed = Handle(Geom_TrimmedCurve)::DownCast(curve)) curve = trimmed->BasisCurve();
    if (Precision::IsInfinite(first) || Precision::IsInfinite(last)) return no_curve(LeftOut::unbounded);
    if (const auto spline = Handle(Geom_BSplineCurve)::DownCast(curve)) return flat_spline(*spline, first, last);
    if (const auto line = Handle(Geom_Line)::DownCast(curve)) return flat_line(*line, first, last);
    if (!curve->IsKind(STANDARD_TYPE(Geom_Conic)) && !curve->IsKind(STANDARD_TYPE(Geom_BezierCurve)))
        return no_curve(LeftOut::of_another_kind);
    const Handle(Geom_Curve) part = new Geom_TrimmedCurve(curve, first, last);
    const Handle(Geom_BSplineCurve) spline = GeomConvert::CurveToBSplineCurve(part);
    FlatCurve result = flat_spline(*spline, spline->FirstParameter(), spline->LastParameter());
    if (result.curve) result.error = std::max(result.error, rounding_along(spatial_curve(*spline)));
    return result;
}

core::Result<core::Curve> stated_part(const core::Curve& curve, core::Interval stated, FlatCurve& result) {
    const core::Interval domain = curve.domain();
    const core::Interval part{std::max(domain.lower, stated.lower), std::min(domain.upper, stated.upper)};
    if (!(part.lower < part.upper)) {
        result.part = PartInDomain::none;
        result.error = std::numeric_limits<double>::infinity();
        return curve;
    }
    const double rounding = rounded_parameter * (domain.upper - domain.lower);
    if (part.lower - stated.lower > rounding || stated.upper - part.upper > rounding) result.part = PartInDomain::some;
    return part == domain ? core::Result<core::Curve>(curve) : cut_between(curve, part.lower, part.upper, result.error);
}

}  // namespace

FlatCurve flat_curve(const TopoDS_Edge& edge, double parameter_factor) {
    try {
        double first = 0.0;
        double last = 0.0;
        TopLoc_Location location;
        BRep_Tool::Curve(edge, location, first, last);
        const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
        if (curve.IsNull()) return no_curve(LeftOut::of_another_kind);
        FlatCurve result = flat_geometry(curve, parameter_factor * first, parameter_factor * last);
        if (result.curve && !location.IsIdentity()) result.error += rounding_along(*result.curve);
        return result;
    } catch (const Standard_Failure&) {
        return no_curve(LeftOut::not_computable);
    }
}

FlatCurve flat_curve(const StatedCurve& stated, const gp_GTrsf& location) {
    if (!stated) return no_curve(LeftOut::not_computable, stated.error());
    SpatialCurve spatial = *stated;
    spatial.placements.push_back(location);
    FlatCurve result;
    const auto definition = flattened(spatial, result);
    if (!definition) return no_curve(LeftOut::in_another_plane);
    auto curve = of_its_kind(*definition);
    if (curve && spatial.part) curve = stated_part(*curve, *spatial.part, result);
    if (!curve) return no_curve(LeftOut::not_computable, core::describe(curve.error()));
    result.curve = *curve;
    return result;
}

}  // namespace batten::exchange::occt
