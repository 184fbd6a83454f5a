#include "core/base/version.h"
#include "core/evaluate/basis.h"
#include "core/evaluate/bezier_pieces.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/hodograph.h"
#include "core/make/interpolate.h"
#include "core/measure/arc_length.h"
#include "core/measure/nearest.h"
#include "core/refine/degree.h"
#include "core/refine/knot_insertion.h"
#include "core/refine/knot_removal.h"
#include "core/refine/split.h"
#include "spline_library.h"

namespace batten::bench {

namespace {

SplineLibrary::Answer<CurveDefinition> definition_of(const core::Result<Curve>& curve) {
    if (!curve) return {};
    return curve->definition();
}

class Batten : public SplineLibrary {
  public:
    std::string name() const override { return std::string("Batten ") + core::version_text; }

    Answer<std::vector<Point>> derivatives(const Curve& curve, double u, int order) const override {
        const core::Jet jet = core::derivatives_at(curve, u, order);
        std::vector<Point> points{jet.point};
        for (const core::Vector& derivative : jet.derivatives) points.push_back(core::tip_of(derivative));
        return points;
    }

    Answer<Rows> basis(const core::KnotVector& knots, double u, int order) const override {
        const auto derivatives = core::basis_functions(knots, u, order).derivatives;
        return Rows(derivatives.begin(), derivatives.end());
    }

    Answer<CurveDefinition> insert(const Curve& curve, std::span<const double> knots) const override {
        core::Result<Curve> result = curve;
        for (const double u : knots)
            result = result.and_then([u](const Curve& before) { return core::insert_knot(before, u); });
        return definition_of(result);
    }

    Answer<CurveDefinition> remove(const Curve& curve, std::span<const double> knots, double tolerance) const override {
        core::Result<Curve> result = curve;
        for (const double u : knots)
            result = result.and_then([&](const Curve& before) {
                return core::remove_knot(before, u, 1, tolerance).map([](const core::KnotRemoval& removal) {
                    return removal.curve;
                });
            });
        if (!result || result->knots().size() + knots.size() != curve.knots().size()) return {};
        return definition_of(result);
    }

    Answer<CurveDefinition> elevate(const Curve& curve, int by) const override {
        return definition_of(core::elevate_degree(curve, by));
    }

    Answer<std::vector<CurveDefinition>> split(const Curve& curve, double u) const override {
        const auto parts = core::split(curve, u);
        if (!parts) return {};
        return std::vector{(*parts)[0].definition(), (*parts)[1].definition()};
    }

    Answer<std::vector<CurveDefinition>> bezier_pieces(const Curve& curve) const override {
        std::vector<CurveDefinition> pieces;
        for (const core::BezierPiece& piece : core::bezier_pieces(curve)) {
            CurveDefinition definition{.degree = curve.degree()};
            for (const core::HomogeneousPoint& point : piece.points) {
                definition.points.push_back(core::project(point));
                definition.weights.push_back(point.z);
            }
            pieces.push_back(std::move(definition));
        }
        return pieces;
    }

    Answer<CurveDefinition> hodograph(const Curve& curve) const override {
        const auto result = core::hodograph(curve);
        if (!result) return {};
        CurveDefinition definition = result->definition();
        if (curve.degree() > 1) return definition;
        // The derivative of a polygon comes in degree 1, every vector twice.
        CurveDefinition steps{.degree = 0};
        for (std::size_t i = 0; i < definition.points.size(); i += 2) steps.points.push_back(definition.points[i]);
        return steps;
    }

    Answer<double> arc_length(const Curve& curve) const override { return core::arc_length(curve).value; }

    Answer<double> curvature(const Curve& curve, double u) const override { return core::curvature_at(curve, u); }

    Answer<Point> closest_point(const Curve& curve, Point query) const override {
        return core::nearest_point(curve, query).point;
    }

    Answer<CurveDefinition> interpolate(const InterpolationTask& task) const override {
        const auto result = core::interpolate(task.through, {.degree = task.degree, .parameters = task.parameters});
        if (!result) return {};
        return result->curve.definition();
    }
};

}  // namespace

std::unique_ptr<SplineLibrary> make_batten() {
    return std::make_unique<Batten>();
}

}  // namespace batten::bench
