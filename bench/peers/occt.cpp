#include <BSplCLib.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2dAPI_ProjectPointOnCurve.hxx>
#include <Geom2dAdaptor_Curve.hxx>
#include <Geom2dConvert_BSplineCurveToBezierCurve.hxx>
#include <Geom2dLProp_CLProps2d.hxx>
#include <Geom2d_BezierCurve.hxx>
#include <Standard_Failure.hxx>
#include <Standard_Version.hxx>
#include <math_Matrix.hxx>
#include <type_traits>

#include "occt_curve.h"
#include "spline_library.h"

namespace batten::bench {

namespace {

// The tightest tolerance with which OpenCASCADE still answers all the cases.
constexpr double length_tolerance = 1e-13;
using Spline = OcctCurve;

CurveDefinition definition_of(const Spline& spline) {
    CurveDefinition definition{.degree = spline->Degree()};
    for (const double u : spline->KnotSequence()) definition.knots.push_back(u);
    for (int i = 1; i <= spline->NbPoles(); ++i) {
        definition.points.emplace_back(spline->Pole(i).X(), spline->Pole(i).Y());
        definition.weights.push_back(spline->Weight(i));
    }
    return definition;
}

// What `operation` answers, or nothing when OpenCASCADE throws.
template <class Operation>
auto attempt(Operation operation) -> std::optional<std::decay_t<decltype(operation())>> {
    try {
        return operation();
    } catch (const Standard_Failure&) {
        return {};
    }
}

class Occt : public SplineLibrary {
  public:
    std::string name() const override { return "OpenCASCADE " OCC_VERSION_COMPLETE; }

    Answer<std::vector<Point>> derivatives(const Curve& curve, double u, int order) const override {
        return attempt([&] {
            const Spline spline = occt_curve(curve);
            gp_Pnt2d point;
            gp_Pnt2d again;
            gp_Vec2d d1;
            gp_Vec2d d2;
            gp_Vec2d d3;
            // From the highest order to the lowest, because the function for the point alone gives it best.
            if (order >= 3) spline->D3(u, again, d1, d2, d3);
            if (order >= 2) spline->D2(u, again, d1, d2);
            if (order >= 1) spline->D1(u, again, d1);
            spline->D0(u, point);
            const std::vector<Point> all{{point.X(), point.Y()}, {d1.X(), d1.Y()}, {d2.X(), d2.Y()}, {d3.X(), d3.Y()}};
            return std::vector<Point>(all.begin(), all.begin() + order + 1);
        });
    }

    // At knots inside the domain OpenCASCADE chooses the functions on the left, which answers another question.
    Answer<Rows> basis(const core::KnotVector& knots, double u, int order) const override {
        const auto result = attempt([&]() -> Answer<Rows> {
            const int p = knots.degree();
            math_Matrix matrix(1, order + 1, 1, p + 1);
            int first = 0;
            BSplCLib::EvalBsplineBasis(order, p + 1, occt_array<TColStd_Array1OfReal>(knots.values()), u, first,
                                       matrix);
            if (first != static_cast<int>(knots.span_at(u)) - p + 1) return {};
            Rows rows(static_cast<std::size_t>(order) + 1);
            for (int r = 0; r <= order; ++r)
                for (int j = 0; j <= p; ++j) rows[static_cast<std::size_t>(r)].push_back(matrix(r + 1, j + 1));
            return rows;
        });
        return result.value_or(std::nullopt);
    }

    Answer<CurveDefinition> insert(const Curve& curve, std::span<const double> knots) const override {
        return attempt([&] {
            const Spline spline = occt_curve(curve);
            for (const double u : knots) spline->InsertKnots(one(u), one(1), 0.0, true);
            return definition_of(spline);
        });
    }

    Answer<CurveDefinition> remove(const Curve& curve, std::span<const double> knots, double tolerance) const override {
        const auto result = attempt([&]() -> Answer<CurveDefinition> {
            const Spline spline = occt_curve(curve);
            for (const double u : knots)
                for (int i = 1; i <= spline->NbKnots(); ++i)
                    if (spline->Knot(i) == u) {
                        if (!spline->RemoveKnot(i, spline->Multiplicity(i) - 1, tolerance)) return {};
                        break;
                    }
            return definition_of(spline);
        });
        return result.value_or(std::nullopt);
    }

    Answer<CurveDefinition> elevate(const Curve& curve, int by) const override {
        return attempt([&] {
            const Spline spline = occt_curve(curve);
            spline->IncreaseDegree(curve.degree() + by);
            return definition_of(spline);
        });
    }

    Answer<std::vector<CurveDefinition>> split(const Curve& curve, double u) const override {
        return attempt([&] {
            const Spline left = occt_curve(curve);
            const Spline right = occt_curve(curve);
            left->Segment(curve.domain().lower, u, 0.0);
            right->Segment(u, curve.domain().upper, 0.0);
            return std::vector{definition_of(left), definition_of(right)};
        });
    }

    Answer<std::vector<CurveDefinition>> bezier_pieces(const Curve& curve) const override {
        return attempt([&] {
            Geom2dConvert_BSplineCurveToBezierCurve conversion(occt_curve(curve), curve.domain().lower,
                                                               curve.domain().upper, 0.0);
            std::vector<CurveDefinition> pieces;
            for (int k = 1; k <= conversion.NbArcs(); ++k) {
                const Handle(Geom2d_BezierCurve) arc = conversion.Arc(k);
                CurveDefinition piece{.degree = arc->Degree()};
                for (int i = 1; i <= arc->NbPoles(); ++i) {
                    piece.points.emplace_back(arc->Pole(i).X(), arc->Pole(i).Y());
                    piece.weights.push_back(arc->Weight(i));
                }
                pieces.push_back(std::move(piece));
            }
            return pieces;
        });
    }

    Answer<double> curvature(const Curve& curve, double u) const override {
        return attempt([&] { return Geom2dLProp_CLProps2d(occt_curve(curve), u, 2, 1e-300).Curvature(); });
    }

    Answer<double> arc_length(const Curve& curve) const override {
        return attempt(
            [&] { return GCPnts_AbscissaPoint::Length(Geom2dAdaptor_Curve(occt_curve(curve)), length_tolerance); });
    }

    // OpenCASCADE finds the feet of perpendiculars; the ends are compared here.
    Answer<Point> closest_point(const Curve& curve, Point query) const override {
        return attempt([&] {
            const Spline spline = occt_curve(curve);
            const gp_Pnt2d from(query.x, query.y);
            gp_Pnt2d nearest = spline->Value(curve.domain().lower);
            const gp_Pnt2d end = spline->Value(curve.domain().upper);
            if (end.Distance(from) < nearest.Distance(from)) nearest = end;
            const Geom2dAPI_ProjectPointOnCurve projection(from, spline, curve.domain().lower, curve.domain().upper);
            for (int i = 1; i <= projection.NbPoints(); ++i)
                if (projection.Point(i).Distance(from) < nearest.Distance(from)) nearest = projection.Point(i);
            return Point(nearest.X(), nearest.Y());
        });
    }

    Answer<CurveDefinition> interpolate(const InterpolationTask& task) const override {
        const auto result = attempt([&]() -> Answer<CurveDefinition> {
            auto poles = occt_array(task.through);
            int problem = 0;
            BSplCLib::Interpolate(task.degree, occt_array<TColStd_Array1OfReal>(task.knots),
                                  occt_array<TColStd_Array1OfReal>(task.parameters),
                                  occt_array<TColStd_Array1OfInteger>(std::vector<int>(task.through.size(), 0)), poles,
                                  problem);
            if (problem != 0) return {};
            CurveDefinition definition{.degree = task.degree, .knots = task.knots};
            for (const gp_Pnt2d& pole : poles) definition.points.emplace_back(pole.X(), pole.Y());
            return definition;
        });
        return result.value_or(std::nullopt);
    }

  private:
    static TColStd_Array1OfReal one(double value) {
        TColStd_Array1OfReal array(1, 1);
        array(1) = value;
        return array;
    }

    static TColStd_Array1OfInteger one(int value) {
        TColStd_Array1OfInteger array(1, 1);
        array(1) = value;
        return array;
    }
};

}  // namespace

std::unique_ptr<SplineLibrary> make_occt() {
    return std::make_unique<Occt>();
}

}  // namespace batten::bench
