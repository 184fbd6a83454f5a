#include "tests/core/golden.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/basis.h"
#include "core/evaluate/bezier_pieces.h"
#include "core/evaluate/de_boor.h"
#include "core/evaluate/end_derivatives.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/evaluator.h"
#include "core/evaluate/hodograph.h"
#include "core/evaluate/samples.h"
#include "core/make/interpolate.h"
#include "core/measure/conic_form.h"
#include "core/refine/bezier_form.h"
#include "core/refine/knot_insertion.h"
#include "core/refine/knot_refinement.h"
#include "core/refine/split.h"

namespace batten::core::golden {

namespace {

using nlohmann::json;
using Table = std::vector<std::vector<double>>;

constexpr double hard_cases_factor = 1e3;

double allowed_for_derivative(std::size_t r) {
    if (r == 0) return 1e-14;
    return r == 1 ? 1e-12 : 1e-10;
}

void add_for(Tally& tally, const Curve& curve, const std::string& quantity, double error, double allowed,
             const std::string& name) {
    if (is_hard(curve))
        tally.add(quantity + " of hard cases", error, hard_cases_factor * allowed, name);
    else
        tally.add(quantity, error, allowed, name);
}

double largest(const std::vector<double>& values) {
    double result = 0.0;
    for (const double value : values) result = std::max(result, std::abs(value));
    return result;
}

void compare_curves(Tally& tally, const Curve& found, const Curve& expected, double scale, const std::string& name) {
    EXPECT_TRUE(std::ranges::equal(found.knots().values(), expected.knots().values())) << name;
    const double most = largest({expected.weights().begin(), expected.weights().end()});
    add_for(tally, expected, "points",
            relative(largest_difference(found.control_points(), expected.control_points()), scale), 1e-14, name);
    add_for(tally, expected, "weights", relative(largest_difference(found.weights(), expected.weights()), most), 1e-14,
            name);
}

// For each order the largest derivative in the case, which errors of that order are measured by.
std::vector<double> derivative_scales(const json& at) {
    std::vector<double> scales;
    for (const json& place : at) {
        const auto derivatives = points_of(place.at("derivatives"));
        scales.resize(std::max(scales.size(), derivatives.size()));
        for (std::size_t r = 0; r < derivatives.size(); ++r)
            scales[r] = std::max(scales[r], largest_coordinate(std::span(derivatives).subspan(r, 1)));
    }
    return scales;
}

// Of the point and of each derivative, in units of its scale.
std::vector<double> errors_of(const Jet& jet, const std::vector<Point>& expected, const std::vector<double>& scales) {
    std::vector<Point> found{jet.point};
    for (const Vector& derivative : jet.derivatives) found.push_back(tip_of(derivative));
    std::vector<double> errors;
    for (std::size_t r = 0; r < expected.size(); ++r)
        errors.push_back(
            relative(largest_difference(std::span(found).subspan(r, 1), std::span(expected).subspan(r, 1)), scales[r]));
    return errors;
}

}  // namespace

TEST(Golden, evaluate) {
    Tally tally("evaluate.json");
    for (const json& item : cases("evaluate.json")) {
        tally.count_case();
        const std::string name = item.at("name");
        const Curve curve = curve_of(item);
        auto scales = derivative_scales(item.at("at"));
        scales[0] = largest_coordinate(curve.control_points());
        const Evaluator prepared(curve);
        for (const json& place : item.at("at")) {
            const double u = place.at("u");
            const auto expected = points_of(place.at("derivatives"));
            const Jet jet = derivatives_at(curve, u, static_cast<int>(expected.size()) - 1);
            EXPECT_EQ(point_at(curve, u), jet.point);
            const auto error_of_point = errors_of({prepared.point_at(u), {}}, {expected[0]}, scales);
            tally.add("points alone, prepared", error_of_point[0], 1e-15, name);
            // A lone one, and one of many, which come from the polynomial of the span.
            for (const std::size_t count : {1U, 20U}) {
                std::vector<Point> samples(count);
                sample(curve, std::vector(count, u), samples);
                tally.add("samples", errors_of({samples.front(), {}}, {expected[0]}, scales)[0], 1e-15, name);
            }
            const auto errors = errors_of(jet, expected, scales);
            const auto prepared_errors =
                errors_of(prepared.derivatives_at(u, static_cast<int>(expected.size()) - 1), expected, scales);
            for (std::size_t r = 0; r < expected.size(); ++r) {
                const std::string quantity = r == 0 ? "points" : "derivative " + std::to_string(r);
                add_for(tally, curve, quantity, errors[r], allowed_for_derivative(r), name);
                add_for(tally, curve, quantity + ", prepared", prepared_errors[r], allowed_for_derivative(r), name);
            }
        }
    }
}

TEST(Golden, basis) {
    Tally tally("basis.json");
    for (const json& item : cases("basis.json")) {
        tally.count_case();
        const std::string name = item.at("name");
        const int degree = item.at("degree");
        const auto knots = KnotVector::make(degree, item.at("knots")).value();
        std::vector<double> scales(static_cast<std::size_t>(degree) + 1);
        for (const json& place : item.at("at"))
            for (std::size_t r = 0; r < scales.size(); ++r)
                scales[r] = std::max(scales[r], largest(place.at("derivatives").at(r).get<std::vector<double>>()));
        for (const json& place : item.at("at")) {
            const auto expected = place.at("derivatives").get<Table>();
            const BasisValues found = basis_functions(knots, place.at("u"), degree);
            EXPECT_EQ(found.span, place.at("span").get<std::size_t>());
            ASSERT_EQ(found.derivatives.size(), expected.size());
            for (std::size_t r = 0; r < expected.size(); ++r) {
                const double error = largest_difference(found.derivatives[r], expected[r]);
                const std::string quantity = r == 0 ? "values" : "derivative " + std::to_string(r);
                tally.add(quantity, relative(error, scales[r]), allowed_for_derivative(r), name);
            }
        }
    }
}

TEST(Golden, de_boor) {
    Tally tally("de_boor.json");
    for (const json& item : cases("de_boor.json")) {
        tally.count_case();
        const std::string name = item.at("name");
        const Curve curve = curve_of(item);
        const double scale = largest_coordinate(curve.control_points());
        const double most = largest({curve.weights().begin(), curve.weights().end()});
        const DeBoorTriangle triangle = de_boor_triangle(curve, item.at("u"));
        ASSERT_EQ(triangle.levels.size(), item.at("levels").size());
        for (std::size_t r = 0; r < triangle.levels.size(); ++r) {
            std::vector<Point> points;
            std::vector<double> weights;
            std::vector<double> alphas;
            for (const DeBoorCell& cell : triangle.levels[r]) {
                points.push_back(cell.point);
                weights.push_back(cell.weight);
                alphas.push_back(cell.alpha);
            }
            const double error = largest_difference(points, points_of(item.at("levels").at(r)));
            tally.add("points", relative(error, scale), 1e-14, name);
            const auto expected_weights = item.at("level_weights").at(r).get<std::vector<double>>();
            tally.add("weights", relative(largest_difference(weights, expected_weights), most), 1e-14, name);
            if (r == 0) continue;
            const auto expected_alphas = item.at("alphas").at(r - 1).get<std::vector<double>>();
            tally.add("alphas", largest_difference(alphas, expected_alphas), 1e-14, name);
        }
    }
}

TEST(Golden, knot_insertion) {
    Tally tally("knot_insertion.json");
    for (const json& item : cases("knot_insertion.json")) {
        tally.count_case();
        const Curve original = curve_of(item);
        Curve curve = original;
        for (const double u : item.at("insert").get<std::vector<double>>()) curve = insert_knot(curve, u).value();
        compare_curves(tally, curve, curve_of(item.at("result")), largest_coordinate(original.control_points()),
                       item.at("name"));
    }
}

TEST(Golden, knot_insertion_by_refinement) {
    Tally tally("knot_insertion.json");
    for (const json& item : cases("knot_insertion.json")) {
        tally.count_case();
        const Curve original = curve_of(item);
        const Curve refined = refine_knots(original, item.at("insert").get<std::vector<double>>()).value();
        compare_curves(tally, refined, curve_of(item.at("result")), largest_coordinate(original.control_points()),
                       item.at("name"));
    }
}

TEST(Golden, split) {
    Tally tally("split.json");
    for (const json& item : cases("split.json")) {
        tally.count_case();
        const Curve curve = curve_of(item);
        const double scale = largest_coordinate(curve.control_points());
        const auto parts = split(curve, item.at("u")).value();
        ASSERT_EQ(parts.size(), 2U);
        compare_curves(tally, parts[0], curve_of(item.at("left")), scale, item.at("name"));
        compare_curves(tally, parts[1], curve_of(item.at("right")), scale, item.at("name"));
    }
}

TEST(Golden, bezier_decomposition_into_curves) {
    Tally tally("bezier_decomposition.json");
    for (const json& item : cases("bezier_decomposition.json")) {
        tally.count_case();
        const std::string name = item.at("name");
        const Curve curve = curve_of(item);
        const double scale = largest_coordinate(curve.control_points());
        const double most = largest({curve.weights().begin(), curve.weights().end()});
        const auto pieces = bezier_curves(curve).value();
        ASSERT_EQ(pieces.size(), item.at("segments").size()) << name;
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            const json& segment = item.at("segments").at(k);
            const double error = largest_difference(pieces[k].control_points(), points_of(segment.at("points")));
            add_for(tally, curve, "points", relative(error, scale), 1e-14, name);
            const auto expected_weights = segment.at("weights").get<std::vector<double>>();
            add_for(tally, curve, "weights", relative(largest_difference(pieces[k].weights(), expected_weights), most),
                    1e-14, name);
        }
    }
}

TEST(Golden, bezier_decomposition) {
    Tally tally("bezier_decomposition.json");
    for (const json& item : cases("bezier_decomposition.json")) {
        tally.count_case();
        const std::string name = item.at("name");
        const Curve curve = curve_of(item);
        const double scale = largest_coordinate(curve.control_points());
        const double most = largest({curve.weights().begin(), curve.weights().end()});
        const auto pieces = bezier_pieces(curve);
        ASSERT_EQ(pieces.size(), item.at("segments").size()) << name;
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            const json& segment = item.at("segments").at(k);
            EXPECT_EQ(pieces[k].interval, (Interval{segment.at("from"), segment.at("to")})) << name;
            std::vector<Point> points;
            std::vector<double> weights;
            for (const HomogeneousPoint& point : pieces[k].points) {
                points.push_back(project(point));
                weights.push_back(point.z);
            }
            const double error = largest_difference(points, points_of(segment.at("points")));
            add_for(tally, curve, "points", relative(error, scale), 1e-14, name);
            const auto expected_weights = segment.at("weights").get<std::vector<double>>();
            add_for(tally, curve, "weights", relative(largest_difference(weights, expected_weights), most), 1e-14,
                    name);
        }
    }
}

TEST(Golden, curvature) {
    Tally tally("curvature.json");
    for (const json& item : cases("curvature.json")) {
        tally.count_case();
        const Curve curve = curve_of(item);
        double scale = 0.0;
        for (const json& place : item.at("at")) scale = std::max(scale, std::abs(place.at("curvature").get<double>()));
        for (const json& place : item.at("at")) {
            const auto found = curvature_at(curve, place.at("u"));
            ASSERT_TRUE(found.has_value()) << item.at("name");
            const double error = std::abs(*found - place.at("curvature").get<double>());
            add_for(tally, curve, "curvature", relative(error, scale), 1e-10, item.at("name"));
        }
    }
}

TEST(Golden, hodograph) {
    Tally tally("hodograph.json");
    for (const json& item : cases("hodograph.json")) {
        tally.count_case();
        const std::string name = item.at("name");
        const Curve curve = curve_of(item);
        const Curve found = hodograph(curve).value();
        const json& result = item.at("result");
        auto expected = points_of(result.at("points"));
        if (result.at("degree") == 0) {
            // A step of degree 0 has one point, of degree 1 the same twice.
            std::vector<Point> twice;
            for (const Point& point : expected) twice.insert(twice.end(), 2, point);
            expected = twice;
            EXPECT_EQ(found.degree(), 1) << name;
        } else {
            EXPECT_TRUE(std::ranges::equal(found.knots().values(), result.at("knots").get<std::vector<double>>()))
                << name;
        }
        const double error = largest_difference(found.control_points(), expected);
        add_for(tally, found, "points", relative(error, largest_coordinate(expected)), allowed_for_derivative(1), name);
        if (!is_clamped(curve.knots())) continue;
        // A clamped curve begins and ends with the derivatives that are the ends of its hodograph.
        const std::vector<Point> ends{tip_of(end_derivatives(curve, CurveEnd::start)->first),
                                      tip_of(end_derivatives(curve, CurveEnd::end)->first)};
        const double error_of_ends = largest_difference(ends, std::vector{expected.front(), expected.back()});
        add_for(tally, found, "ends", relative(error_of_ends, largest_coordinate(expected)), allowed_for_derivative(1),
                name);
    }
}

TEST(Golden, conics) {
    Tally tally("conics.json");
    for (const json& item : cases("conics.json")) {
        tally.count_case();
        const std::string name = item.at("name");
        const Curve curve = curve_of(item);
        const auto k = item.at("implicit").get<std::vector<double>>();
        const ImplicitConic expected{.a = k[0], .b = k[1], .c = k[2], .d = k[3], .e = k[4], .f = k[5]};
        const double size = largest_coordinate(curve.control_points());
        const double scale =
            largest({k[0] * size * size, k[1] * size * size, k[2] * size * size, k[3] * size, k[4] * size, k[5]});
        for (int i = 0; i <= 500; ++i) {
            const Point point = point_at(curve, curve.domain().lower + curve.domain().length() * i / 500);
            tally.add("the equation along the curve", relative(std::abs(expected.value_at(point)), scale), 1e-14, name);
        }
        for (const BezierPiece& piece : bezier_pieces(curve)) {
            const ImplicitConic found = conic_form(piece).value().equation.seen_from({0, 0});
            const std::vector<double> members{found.a, found.b, found.c, found.d, found.e, found.f};
            double error = 0.0;
            for (std::size_t i = 0; i < 6; ++i) {
                const double unit = i < 3 ? 1.0 : i < 5 ? size : size * size;
                error = std::max(error, std::abs(members[i] - k[i]) / unit);
            }
            tally.add("the equation found", error, 1e-14, name);
        }
    }
}

TEST(Golden, interpolation) {
    Tally tally("interpolation.json");
    for (const json& item : cases("interpolation.json")) {
        tally.count_case();
        const std::string name = item.at("name");
        const auto through = points_of(item.at("through"));
        const json& result = item.at("result");
        const Curve expected = curve_of(result);
        const bool is_chordal = item.at("parametrization") == "chord-length";
        const auto way = is_chordal ? Parametrization::chordal : Parametrization::centripetal;
        const Interpolation found = interpolate(through, {item.at("degree"), way, FreeEnds{}, {}}).value();
        const auto parameters = result.at("parameters").get<std::vector<double>>();
        tally.add("parameters", largest_difference(found.parameters, parameters), 1e-15, name);
        tally.add("knots", largest_difference(found.curve.knots().values(), expected.knots().values()), 1e-15, name);
        const double error = largest_difference(found.curve.control_points(), expected.control_points());
        tally.add("points", relative(error, largest_coordinate(expected.control_points())), 1e-11, name);
    }
}

TEST(Golden, knot_analysis) {
    Tally tally("knot_analysis.json");
    for (const json& item : cases("knot_analysis.json")) {
        tally.count_case();
        const std::string name = item.at("name");
        const auto knots = KnotVector::make(item.at("degree"), item.at("knots")).value();
        EXPECT_EQ(knots.control_point_count(), item.at("control_points").get<std::size_t>()) << name;
        EXPECT_EQ(segment_count(knots), item.at("segments").get<std::size_t>()) << name;
        EXPECT_EQ(is_clamped(knots), item.at("clamped").get<bool>()) << name;
        EXPECT_EQ(is_uniform(knots), item.at("uniform").get<bool>()) << name;
        const json& continuity = item.at("continuity");
        EXPECT_EQ(least_continuity(knots), continuity.is_null() ? std::nullopt : std::optional(continuity.get<int>()))
            << name;
        auto interior = distinct_knots(knots);
        std::erase_if(interior, [](const DistinctKnot& knot) { return !knot.is_interior; });
        const json& multiplicities = item.at("multiplicities");
        ASSERT_EQ(interior.size(), multiplicities.size()) << name;
        for (std::size_t k = 0; k < interior.size(); ++k) {
            EXPECT_EQ(interior[k].value, multiplicities.at(k).at("knot").get<double>()) << name;
            EXPECT_EQ(interior[k].multiplicity, multiplicities.at(k).at("multiplicity").get<int>()) << name;
            EXPECT_EQ(interior[k].continuity, multiplicities.at(k).at("continuity").get<int>()) << name;
        }
        tally.add("the answers, which are exact", testing::Test::HasFailure() ? 1.0 : 0.0, 0.0, name);
    }
}

}  // namespace batten::core::golden
