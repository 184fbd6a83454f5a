#include "exchange/occt/iges_curves.h"

#include <IGESGeom_BSplineCurve.hxx>
#include <IGESGeom_ConicArc.hxx>
#include <IGESGeom_SplineCurve.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exchange/cad/conic_equation.h"

namespace batten::exchange::occt {

namespace {

SpatialCurve b_spline(const IGESGeom_BSplineCurve& entity) {
    SpatialCurve curve{.shape = {.degree = entity.Degree()}};
    for (int i = 0; i < entity.NbKnots(); ++i) curve.shape.knots.push_back(entity.Knot(i - entity.Degree()));
    for (int i = 0; i <= entity.UpperIndex(); ++i) {
        curve.points.push_back(entity.Pole(i).XYZ());
        curve.shape.weights.push_back(entity.Weight(i));
    }
    curve.part = {entity.UMin(), entity.UMax()};
    return curve;
}

ConicName name_of_form(int form) {
    switch (form) {
        case 1:
            return ConicName::ellipse;
        case 2:
            return ConicName::hyperbola;
        case 3:
            return ConicName::parabola;
        default:
            return ConicName::none;
    }
}

StatedCurve conic(const IGESGeom_ConicArc& entity) {
    ConicEquation equation;
    entity.Equation(equation.a, equation.b, equation.c, equation.d, equation.e, equation.f);
    const gp_Pnt2d start = entity.StartPoint();
    const gp_Pnt2d end = entity.EndPoint();
    const auto arc =
        arc_of_equation(equation, name_of_form(entity.FormNumber()), {start.X(), start.Y()}, {end.X(), end.Y()});
    if (!arc) return tl::unexpected(arc.error());
    SpatialCurve curve{.shape = arc->curve.definition(), .error = arc->error, .contradiction = arc->error};
    for (const core::Point point : std::exchange(curve.shape.points, {}))
        curve.points.emplace_back(point.x, point.y, entity.ZPlane());
    return curve;
}

// A polynomial a + b s + c s^2 + d s^3 of the way s from the beginning of a piece.
struct Cubic {
    gp_XYZ a;
    gp_XYZ b;
    gp_XYZ c;
    gp_XYZ d;
};

Cubic cubic_of(const IGESGeom_SplineCurve& entity, int piece) {
    std::array<std::array<double, 4>, 3> terms{};
    entity.XCoordPolynomial(piece, terms[0][0], terms[0][1], terms[0][2], terms[0][3]);
    entity.YCoordPolynomial(piece, terms[1][0], terms[1][1], terms[1][2], terms[1][3]);
    entity.ZCoordPolynomial(piece, terms[2][0], terms[2][1], terms[2][2], terms[2][3]);
    const auto term = [&](std::size_t i) { return gp_XYZ(terms[0][i], terms[1][i], terms[2][i]); };
    return {term(0), term(1), term(2), term(3)};
}

// In Bézier pieces. Where one does not begin at the end of the one before it, that end is moved there.
SpatialCurve power_spline(const IGESGeom_SplineCurve& entity) {
    constexpr std::size_t degree = 3;
    constexpr double roundings = 4.0 * std::numeric_limits<double>::epsilon();
    SpatialCurve curve{.shape = {.degree = degree}};
    curve.shape.knots.push_back(entity.BreakPoint(1));
    for (int piece = 1; piece <= entity.NbSegments(); ++piece) {
        const double begin = entity.BreakPoint(piece);
        const double length = entity.BreakPoint(piece + 1) - begin;
        if (length == 0.0) continue;
        const auto [a, b, c, d] = cubic_of(entity, piece);
        const gp_XYZ first = length * b;
        const gp_XYZ second = length * length * c;
        const gp_XYZ third = length * length * length * d;
        const double terms = a.Modulus() + first.Modulus() + second.Modulus() + third.Modulus();
        const double gap = curve.points.empty() ? 0.0 : (curve.points.back() - a).Modulus();
        curve.error = std::max(curve.error, gap + roundings * terms);
        curve.contradiction = std::max(curve.contradiction, gap);
        if (!curve.points.empty()) curve.points.pop_back();
        curve.points.insert(curve.points.end(),
                            {a, a + first / 3.0, a + 2.0 / 3.0 * first + second / 3.0, a + first + second + third});
        curve.shape.knots.insert(curve.shape.knots.end(), degree, begin);
    }
    curve.shape.knots.insert(curve.shape.knots.end(), degree + 1, entity.BreakPoint(entity.NbSegments() + 1));
    return curve;
}

gp_GTrsf scaling(double factor) {
    gp_GTrsf scaled;
    for (int i = 1; i <= 3; ++i) scaled.SetValue(i, i, factor);
    return scaled;
}

StatedCurve placed(StatedCurve curve, const std::vector<gp_GTrsf>& placements) {
    if (curve) curve->placements = placements;
    return curve;
}

}  // namespace

std::optional<StatedCurve> iges_curve(const Handle(IGESData_IGESEntity) & entity, double unit) {
    const std::vector<gp_GTrsf> own{entity->Location(), scaling(unit)};
    if (const auto spline = Handle(IGESGeom_BSplineCurve)::DownCast(entity)) return placed(b_spline(*spline), own);
    if (const auto arc = Handle(IGESGeom_ConicArc)::DownCast(entity)) return placed(conic(*arc), own);
    // The edges of these OpenCASCADE moves as a whole.
    if (const auto spline = Handle(IGESGeom_SplineCurve)::DownCast(entity))
        return placed(power_spline(*spline), {scaling(unit)});
    return std::nullopt;
}

}  // namespace batten::exchange::occt
