#include "sisl_curve.h"
#include "spline_library.h"

extern "C" {
// Not in sisl.h, which offers them only inside the library.
void s1220(double* et, int ik, int in, int* ileft, double ax, int ider, double ebder[], int* jstat);
void s1891(double etau[], double epoint[], int idim, int inbpnt, int iright, int eder[], int iopen, double et[],
           double* ebcoef[], int* in, int ik, int inlr, int inrc, int* jstat);
}

#include <cmath>
#include <cstdlib>

namespace batten::bench {

namespace {

// The tightest resolutions with which SISL still answers all the cases.
constexpr double length_tolerance = 1e-12;
constexpr double closest_tolerance = 1e-10;  // of the size of the curve

using Handle = SislCurve;

// What some operations need, which SISL's other operations do.
Handle clamped_handle_of(const Curve& curve) {
    SISLCurve* clamped = nullptr;
    int status = 0;
    s1712(sisl_curve(curve).get(), curve.domain().lower, curve.domain().upper, &clamped, &status);
    return Handle(clamped);
}

SplineLibrary::Answer<CurveDefinition> definition_of(const Handle& curve, int status) {
    if (status < 0 || !curve) return {};
    CurveDefinition definition{.degree = curve->ik - 1};
    const bool is_rational = curve->ikind == 2 || curve->ikind == 4;
    definition.knots.assign(curve->et, curve->et + curve->in + curve->ik);
    for (int i = 0; i < curve->in; ++i) {
        definition.points.emplace_back(curve->ecoef[2 * i], curve->ecoef[2 * i + 1]);
        definition.weights.push_back(is_rational ? curve->rcoef[3 * i + 2] : 1.0);
    }
    return definition;
}

class Sisl : public SplineLibrary {
  public:
    std::string name() const override { return "SISL " SISL_VERSION; }

    Answer<std::vector<Point>> derivatives(const Curve& curve, double u, int order) const override {
        const Handle handle = sisl_curve(curve);
        std::vector<double> values(2 * (static_cast<std::size_t>(order) + 1));
        int left = 0;
        int status = 0;
        const bool is_end = u == curve.domain().upper;
        (is_end ? s1227 : s1221)(handle.get(), order, u, &left, values.data(), &status);
        if (status < 0) return {};
        std::vector<Point> result;
        for (std::size_t r = 0; r < values.size(); r += 2) result.emplace_back(values[r], values[r + 1]);
        return result;
    }

    Answer<Rows> basis(const core::KnotVector& knots, double u, int order) const override {
        std::vector<double> copy(knots.values().begin(), knots.values().end());
        const auto p = static_cast<std::size_t>(knots.degree());
        const auto count = static_cast<std::size_t>(order) + 1;
        std::vector<double> values((p + 1) * count);
        int left = 0;
        int status = 0;
        s1220(copy.data(), knots.degree() + 1, static_cast<int>(knots.control_point_count()), &left, u, order,
              values.data(), &status);
        if (status < 0) return {};
        Rows rows(count, std::vector<double>(p + 1));
        for (std::size_t j = 0; j <= p; ++j)
            for (std::size_t r = 0; r < count; ++r) rows[r][j] = values[j * count + r];
        return rows;
    }

    Answer<CurveDefinition> insert(const Curve& curve, std::span<const double> knots) const override {
        std::vector<double> values(knots.begin(), knots.end());
        std::sort(values.begin(), values.end());
        SISLCurve* result = nullptr;
        int status = 0;
        s1018(sisl_curve(curve).get(), values.data(), static_cast<int>(values.size()), &result, &status);
        return definition_of(Handle(result), status);
    }

    Answer<CurveDefinition> elevate(const Curve& curve, int by) const override {
        SISLCurve* result = nullptr;
        int status = 0;
        s1750(sisl_curve(curve).get(), curve.degree() + 1 + by, &result, &status);
        return definition_of(Handle(result), status);
    }

    Answer<std::vector<CurveDefinition>> split(const Curve& curve, double u) const override {
        SISLCurve* left = nullptr;
        SISLCurve* right = nullptr;
        int status = 0;
        s1710(sisl_curve(curve).get(), u, &left, &right, &status);
        const auto first = definition_of(Handle(left), status);
        const auto second = definition_of(Handle(right), status);
        if (!first || !second) return {};
        return std::vector{*first, *second};
    }

    Answer<std::vector<CurveDefinition>> bezier_pieces(const Curve& curve) const override {
        SISLCurve* result = nullptr;
        int status = 0;
        s1730(clamped_handle_of(curve).get(), &result, &status);
        const auto all = definition_of(Handle(result), status);
        if (!all) return {};
        // One piece after the other, each with all its control points.
        const auto count = static_cast<std::ptrdiff_t>(curve.degree()) + 1;
        std::vector<CurveDefinition> pieces;
        for (auto i = 0 * count; i + count <= static_cast<std::ptrdiff_t>(all->points.size()); i += count)
            pieces.push_back({.degree = curve.degree(),
                              .points = {all->points.begin() + i, all->points.begin() + i + count},
                              .weights = {all->weights.begin() + i, all->weights.begin() + i + count}});
        return pieces;
    }

    Answer<CurveDefinition> hodograph(const Curve& curve) const override {
        SISLCurve* result = nullptr;
        int status = 0;
        s1720(sisl_curve(curve).get(), 1, &result, &status);
        return definition_of(Handle(result), status);
    }

    Answer<double> curvature(const Curve& curve, double u) const override {
        double value = 0.0;
        int status = 0;
        s2550(sisl_curve(curve).get(), &u, 1, &value, &status);
        if (status < 0) return {};
        return value;
    }

    Answer<double> arc_length(const Curve& curve) const override {
        double length = 0.0;
        int status = 0;
        s1240(clamped_handle_of(curve).get(), length_tolerance, &length, &status);
        if (status < 0) return {};
        return length;
    }

    Answer<Point> closest_point(const Curve& curve, Point query) const override {
        double size = 0.0;
        for (const Point& point : curve.control_points()) size = std::max({size, std::abs(point.x), std::abs(point.y)});
        double* parameters = nullptr;
        SISLIntcurve** runs = nullptr;
        int count = 0;
        int run_count = 0;
        int status = 0;
        s1953(clamped_handle_of(curve).get(), &query.x, 2, 0.0, closest_tolerance * size, &count, &parameters,
              &run_count, &runs, &status);
        const SislNumbers owner(parameters);
        if (run_count > 0) freeIntcrvlist(runs, run_count);
        if (status < 0) return {};
        Answer<Point> nearest;
        const auto distance = [&](Point p) { return std::hypot(p.x - query.x, p.y - query.y); };
        for (int i = 0; i < count; ++i) {
            const auto at = derivatives(curve, parameters[i], 0);
            if (at && (!nearest || distance((*at)[0]) < distance(*nearest))) nearest = (*at)[0];
        }
        return nearest;
    }

    // The equations of the interpolation, which the functions of sisl.h set up over knots of their own choice.
    Answer<CurveDefinition> interpolate(const InterpolationTask& task) const override {
        auto parameters = task.parameters;
        auto knots = task.knots;
        std::vector<double> points;
        for (const Point& point : task.through) points.insert(points.end(), {point.x, point.y});
        std::vector<int> orders(task.through.size(), 0);
        double* coefficients = nullptr;
        int count = 0;
        int status = 0;
        s1891(parameters.data(), points.data(), 2, static_cast<int>(task.through.size()), 1, orders.data(), 1,
              knots.data(), &coefficients, &count, task.degree + 1, 0, 0, &status);
        const SislNumbers owner(coefficients);
        if (status < 0 || coefficients == nullptr) return {};
        CurveDefinition definition{.degree = task.degree, .knots = task.knots};
        for (int i = 0; i < count; ++i) definition.points.emplace_back(coefficients[2 * i], coefficients[2 * i + 1]);
        return definition;
    }
};

}  // namespace

std::unique_ptr<SplineLibrary> make_sisl() {
    return std::make_unique<Sisl>();
}

}  // namespace batten::bench
