#include "exchange/occt/geom_curves.h"

#include <Standard_Failure.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/sentence.h"
#include "core/curve/control_box.h"
#include "core/curve/knot_analysis.h"
#include "core/refine/clamping.h"
#include "core/refine/periodic.h"
#include "core/refine/reparametrize.h"

namespace batten::exchange::occt {

namespace {

constexpr double pixels_in_an_inch = 96.0;

// Domains below a thousandth of this length lose parts or are refused when OpenCASCADE reads them.
constexpr double shortest_domain = 1e-6;

// How much of the world is one unit of the file.
struct FileUnit {
    bool is_inch = false;
    double world = 1.0;
};

FileUnit file_unit(const core::Document& document) {
    if (!document.units) return {};
    switch (document.units->unit) {
        case core::LengthUnit::mm:
            return {false, document.units->scale};
        case core::LengthUnit::inch:
            return {true, document.units->scale};
        case core::LengthUnit::px:
            break;
    }
    return {true, document.units->scale * pixels_in_an_inch};
}

Handle(Geom_BSplineCurve) spline_of(const core::Curve& curve, double world) {
    const std::vector<core::DistinctKnot> distinct = core::distinct_knots(curve.knots());
    TColStd_Array1OfReal knots(1, static_cast<int>(distinct.size()));
    TColStd_Array1OfInteger multiplicities(1, knots.Length());
    for (int k = 1; k <= knots.Length(); ++k) {
        knots(k) = distinct[static_cast<std::size_t>(k) - 1].value;
        multiplicities(k) = distinct[static_cast<std::size_t>(k) - 1].multiplicity;
    }
    TColgp_Array1OfPnt poles(1, static_cast<int>(curve.control_points().size()));
    TColStd_Array1OfReal weights(1, poles.Length());
    for (int i = 1; i <= poles.Length(); ++i) {
        const core::Point point = curve.control_points()[static_cast<std::size_t>(i) - 1];
        poles(i) = gp_Pnt(point.x / world, point.y / world, 0.0);
        weights(i) = curve.weights()[static_cast<std::size_t>(i) - 1];
    }
    if (!curve.is_rational()) return new Geom_BSplineCurve(poles, knots, multiplicities, curve.degree());
    return new Geom_BSplineCurve(poles, weights, knots, multiplicities, curve.degree());
}

// How far the points are from where the file has them.
double unit_error(const core::Curve& curve, double world) {
    const auto lost = [world](double coordinate) { return std::fma(coordinate / world, world, -coordinate); };
    double error = 0.0;
    for (const core::Point& point : curve.control_points())
        error = std::max(error, std::hypot(lost(point.x), lost(point.y)));
    return error;
}

// OpenCASCADE takes weights for equal whose quotients are 1 within one unit in the last place.
double weight_error(const core::Curve& curve, const Geom_BSplineCurve& spline) {
    const bool is_rational = spline.IsRational();
    if (curve.is_rational() == is_rational) return 0.0;
    const core::Box box = core::control_box(curve);
    const double size = core::distance(box.lower, box.upper);
    return static_cast<double>(curve.control_points().size()) * std::numeric_limits<double>::epsilon() * size;
}

class GeomWriter {
  public:
    explicit GeomWriter(const core::Document& document) : unit_(file_unit(document)) {
        result_.is_in_inches = unit_.is_inch;
        if (!document.units)
            result_.report.left_out.emplace_back("The document has no unit; its numbers are written as millimeters");
    }

    void add(const core::DocumentCurve& entry) {
        const core::Curve& curve = *entry.curve;
        const core::Place name("name", entry.name);
        if (curve.is_torn()) return say("Curve '{name}' is left out: it comes apart at a knot", name);
        if (curve.is_periodic()) say("Curve '{name}' is written with ends that meet, not as a periodic one", name);
        const core::KnotVector& knots = curve.knots();
        const bool is_clamped =
            core::is_clamped_at(knots, core::CurveEnd::start) && core::is_clamped_at(knots, core::CurveEnd::end);
        if (!is_clamped && !curve.is_periodic()) say("Curve '{name}' is written with clamped ends", name);
        const bool is_short = curve.domain().upper - curve.domain().lower < shortest_domain;
        if (is_short)
            say("Curve '{name}' is written over the parameters from 0 to 1, since its own are too near each other",
                name);
        const auto clamped = is_clamped ? core::Result<core::Curve>(curve) : core::to_clamped(curve);
        const auto written_curve = clamped.and_then([&](const core::Curve& c) {
            return is_short ? core::reparametrize(c, {0.0, 1.0}) : core::Result<core::Curve>(c);
        });
        if (!written_curve) return refuse(name);
        try {
            const NamedSpline written{entry.name, spline_of(*written_curve, unit_.world)};
            const double error =
                unit_error(*written_curve, unit_.world) + weight_error(*written_curve, *written.spline);
            result_.report.largest_error = std::max(result_.report.largest_error, error);
            result_.curves.push_back(written);
        } catch (const Standard_Failure&) {
            refuse(name);
        }
    }

    core::FileResult<GeomCurves> take() {
        if (!result_.curves.empty()) return std::move(result_);
        return tl::unexpected(core::FileError{
            .where = {}, .what = "no visible curve can be written: there must be one that does not come apart"});
    }

  private:
    void say(const char* pattern, const core::Place& name) {
        result_.report.left_out.push_back(core::sentence(pattern, {name}));
    }

    void refuse(const core::Place& name) {
        say("Curve '{name}' is left out: OpenCASCADE takes no knots as near each other as some of its knots", name);
    }

    FileUnit unit_;
    GeomCurves result_;
};

}  // namespace

core::FileResult<GeomCurves> geom_curves(const core::Document& document) {
    GeomWriter written(document);
    for (const core::DocumentCurve& entry : document.curves)
        if (entry.visible) written.add(entry);
    return written.take();
}

}  // namespace batten::exchange::occt
