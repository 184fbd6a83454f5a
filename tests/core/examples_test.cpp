// Every file of assets/examples opens, is as the editor writes it, and holds the facts that the lecture notes print.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "core/curve/knot_analysis.h"
#include "core/document/native_file.h"
#include "core/edit/point_edit.h"
#include "core/evaluate/bezier_pieces.h"
#include "core/evaluate/de_boor.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/conic_form.h"
#include "core/measure/deviation.h"
#include "core/refine/knot_insertion.h"
#include "tests/core/golden.h"

namespace batten::core {
namespace {

namespace fs = std::filesystem;

using Knots = std::vector<double>;

Document example(const std::string& name) {
    auto document = load_document(fs::path(BATTEN_EXAMPLES) / (name + ".json"));
    if (!document) throw std::runtime_error(name + ": " + document.error().sentence());
    return *document;
}

Curve curve_in(const std::string& name) {
    return *example(name).curves.at(0).curve;
}

std::vector<Knots> alphas(const std::string& name) {
    const Document document = example(name);
    const DeBoorTriangle triangle = de_boor_triangle(*document.curves.at(0).curve, document.view.parameter.value());
    std::vector<Knots> result;
    for (std::size_t r = 1; r < triangle.levels.size(); ++r) {
        result.emplace_back();
        for (const DeBoorCell& cell : triangle.levels[r]) result.back().push_back(cell.alpha);
    }
    return result;
}

void expect_near(const std::vector<Knots>& found, const std::vector<Knots>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t r = 0; r < found.size(); ++r) {
        ASSERT_EQ(found[r].size(), expected[r].size());
        for (std::size_t j = 0; j < found[r].size(); ++j) EXPECT_NEAR(found[r][j], expected[r][j], 1e-15);
    }
}

void expect_knots(const std::string& name, const Knots& knots) {
    EXPECT_EQ(curve_in(name).definition().knots, knots) << name;
}

TEST(Examples, every_file_opens_and_is_as_the_editor_writes_it) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(BATTEN_EXAMPLES)) {
        if (entry.path().extension() != ".json") continue;
        names.insert(entry.path().stem().string());
        const auto document = load_document(entry.path());
        ASSERT_TRUE(document.has_value()) << entry.path() << ": " << document.error().sentence();
        EXPECT_FALSE(document->title.empty()) << entry.path();
        EXPECT_FALSE(document->description.empty()) << entry.path();
        ASSERT_EQ(document->curves.size(), entry.path().stem() == "coons-joined" ? 2U : 1U) << entry.path();
        ASSERT_TRUE(document->view.parameter.has_value()) << entry.path();
        EXPECT_TRUE(document->curves[0].curve->domain().contains(*document->view.parameter)) << entry.path();
        EXPECT_TRUE(document->unknown_members.empty()) << document->unknown_members;
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
        EXPECT_EQ(format_document(*document), text) << entry.path();
    }
    EXPECT_EQ(names,
              (std::set<std::string>{"wave", "cubic-de-boor", "quadratic-double-knot", "cubic-at-4-5", "knot-insertion",
                                     "bezier-cubic", "coons-open", "coons-closed", "coons-joined", "circle-nurbs",
                                     "conic-weight", "knots-t1", "knots-t2", "knots-t3", "knots-t4"}));
}

TEST(Examples, agree_with_the_reference_results) {
    const std::map<std::string, std::string> example_of{
        {"deboor-cimat", "cubic-de-boor"}, {"kma-bspline", "quadratic-double-knot"},
        {"kma-deboor", "cubic-at-4-5"},    {"kma-knot-insertion", "knot-insertion"},
        {"bezier-cubic", "bezier-cubic"},  {"coons", "coons-open"},
        {"circle-9", "circle-nurbs"}};
    std::size_t compared = 0;
    for (const auto& members : golden::cases("de_boor.json")) {
        const auto name = example_of.find(members.at("name").get<std::string>());
        if (name == example_of.end()) continue;
        const CurveDefinition found = curve_in(name->second).definition();
        const CurveDefinition expected = golden::curve_of(members).definition();
        EXPECT_EQ(found.degree, expected.degree) << name->second;
        EXPECT_EQ(found.knots, expected.knots) << name->second;
        EXPECT_EQ(found.points, expected.points) << name->second;
        EXPECT_EQ(found.weights, expected.weights) << name->second;
        EXPECT_EQ(example(name->second).view.parameter, members.at("u").get<double>()) << name->second;
        ++compared;
    }
    EXPECT_EQ(compared, example_of.size());
}

TEST(Examples, de_boor_shows_the_printed_alphas) {
    for (const char* name : {"cubic-de-boor", "wave"})
        expect_near(alphas(name), {{0.8, 0.8 / 1.5, 0.2}, {0.8, 0.3}, {0.6}});
    expect_near(alphas("cubic-at-4-5"), {{0.8, 0.7, 0.4}, {0.7, 0.4}, {0.4}});
    expect_near(alphas("bezier-cubic"), {{0.5, 0.5, 0.5}, {0.5, 0.5}, {0.5}});
}

TEST(Examples, knot_insertion_shows_the_printed_alphas) {
    expect_near({alphas("knot-insertion")[0]}, {{5.0 / 6.0, 0.5, 1.0 / 6.0}});
    const Curve curve = curve_in("knot-insertion");
    const Curve refined = insert_knot(curve, 0.5).value();
    EXPECT_LT(largest_deviation(curve, refined), 12.0 * 1e-14);
    // Q_4 = (P_3 + P_4) / 2 is the point of the middle α.
    EXPECT_LT(distance(refined.control_points()[4], Point(5.5, 0)), 1e-14);
}

bool says(const std::string& name, const std::string& words) {
    return example(name).description.find(words) != std::string::npos;
}

TEST(Examples, knot_insertion_says_how_many_points_become_how_many) {
    const Curve curve = curve_in("knot-insertion");
    const Curve refined = insert_knot(curve, 0.5).value();
    const auto count_not_in = [](std::span<const Point> points, std::span<const Point> others) {
        return std::count_if(points.begin(), points.end(), [others](Point point) {
            return std::none_of(others.begin(), others.end(),
                                [point](Point other) { return distance(point, other) < 1e-13; });
        });
    };
    EXPECT_EQ(count_not_in(curve.control_points(), refined.control_points()), 2);
    EXPECT_EQ(count_not_in(refined.control_points(), curve.control_points()), 3);
    EXPECT_TRUE(says("knot-insertion", "two control points become three with α = 5/6, 1/2 and 1/6"));
}

// The conic of a triangle with the weight w is an ellipse for w < 1, a parabola for w = 1, else a hyperbola.
TEST(Examples, conic_says_which_weight_draws_what) {
    const std::map<double, ConicType> types{{std::sqrt(0.5), ConicType::ellipse}, {0.2, ConicType::ellipse},
                                            {0.99, ConicType::ellipse},           {1.0, ConicType::parabola},
                                            {1.01, ConicType::hyperbola},         {5.0, ConicType::hyperbola}};
    for (const auto& [weight, type] : types) {
        const Curve curve = set_weight(curve_in("conic-weight"), 1, weight).value();
        EXPECT_EQ(conic_form(bezier_pieces(curve)[0]).value().type, type) << weight;
    }
    EXPECT_TRUE(says("conic-weight",
                     "√½ draws a circular arc, other weights below 1 an ellipse, 1 a parabola, more than 1 a "
                     "hyperbola"));
}

TEST(Examples, uniform_cubic_begins_in_its_first_point_as_it_says) {
    CurveDefinition definition = curve_in("coons-open").definition();
    EXPECT_TRUE(says("coons-open", "drag the knots −1 and −2 onto 0, and it begins in P₀"));
    definition.knots = {-3, 0, 0, 0, 1, 2, 3, 4};
    definition.kind = KnotKind::custom;
    EXPECT_LT(distance(point_at(Curve::make(definition).value(), 0.0), definition.points[0]), 1e-15);
}

TEST(Examples, knot_vectors_say_their_segments_corners_and_continuity) {
    EXPECT_EQ(segment_count(curve_in("knots-t1").knots()), 6U);
    EXPECT_TRUE(says("knots-t1", "the six segments") && says("knots-t1", "C³"));
    const Curve corner = curve_in("knots-t3");
    EXPECT_EQ(point_at(corner, 4.0), corner.control_points()[5]);
    EXPECT_GT(
        std::abs(cross(derivatives_at(corner, 4.0, 1, Side::left)[1], derivatives_at(corner, 4.0, 1, Side::right)[1])),
        1.0);
    EXPECT_TRUE(says("knots-t3", "through the control point P₅ with a corner"));
    const KnotVector knots = curve_in("knots-t4").knots();
    const std::map<double, int> continuity{{1.0, 2}, {2.0, 0}, {3.0, 2}, {4.0, 1}};
    for (const auto& [u, order] : continuity) EXPECT_EQ(knots.degree() - knots.multiplicity(u), order) << u;
    EXPECT_TRUE(says("knots-t4", "C⁰ at 2, C¹ at 4, C² at 1 and 3"));
}

TEST(Examples, knots_are_the_printed_ones) {
    expect_knots("cubic-de-boor", {0, 0, 0, 0, .25, .5, .75, 1, 1, 1, 1});
    expect_knots("wave", {0, 0, 0, 0, .25, .5, .75, 1, 1, 1, 1});
    expect_knots("cubic-at-4-5", {0, 0, 0, 0, 1.0 / 3.0, 2.0 / 3.0, 1, 1, 1, 1});
    expect_knots("knot-insertion", {0, 0, 0, 0, .2, .4, .6, .8, 1, 1, 1, 1});
    expect_knots("knots-t1", {0, 0, 0, 0, 0, 1, 2, 3, 4, 5, 6, 6, 6, 6, 6});
    expect_knots("knots-t2", {0, 0, 0, 0, 1, 3, 4, 7, 7, 7, 7});
    expect_knots("knots-t3", {0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5});
    expect_knots("knots-t4", {0, 0, 0, 0, 1, 2, 2, 2, 3, 4, 4, 5, 5, 5, 5});
}

TEST(Examples, kinds_and_continuity_are_what_the_notes_say) {
    const std::map<std::string, std::pair<KnotKind, std::optional<int>>> facts{
        {"wave", {KnotKind::clamped_uniform, 2}},
        {"cubic-de-boor", {KnotKind::clamped_uniform, 2}},
        {"quadratic-double-knot", {KnotKind::custom, 0}},
        {"cubic-at-4-5", {KnotKind::clamped_uniform, 2}},
        {"knot-insertion", {KnotKind::clamped_uniform, 2}},
        {"bezier-cubic", {KnotKind::bezier, std::nullopt}},
        {"coons-open", {KnotKind::uniform, std::nullopt}},
        {"coons-closed", {KnotKind::periodic, 2}},
        {"circle-nurbs", {KnotKind::piecewise_bezier, 0}},
        {"conic-weight", {KnotKind::bezier, std::nullopt}},
        {"knots-t1", {KnotKind::clamped_uniform, 3}},
        {"knots-t2", {KnotKind::custom, 2}},
        {"knots-t3", {KnotKind::custom, 0}},
        {"knots-t4", {KnotKind::custom, 0}}};
    for (const auto& [name, fact] : facts) {
        const Curve curve = curve_in(name);
        EXPECT_EQ(curve.knots().kind(), fact.first) << name;
        EXPECT_EQ(least_continuity(curve.knots()), fact.second) << name;
    }
}

TEST(Examples, double_knot_draws_through_its_point_with_a_corner) {
    const Curve curve = curve_in("quadratic-double-knot");
    EXPECT_EQ(point_at(curve, 2.0), Point(5, -1));
    const Vector before = derivatives_at(curve, 2.0, 1, Side::left)[1];
    const Vector after = derivatives_at(curve, 2.0, 1, Side::right)[1];
    EXPECT_GT(std::abs(cross(before, after)), 1.0);
}

TEST(Examples, circle_is_round) {
    const Curve curve = curve_in("circle-nurbs");
    for (int k = 0; k <= 1000; ++k) EXPECT_NEAR(distance(point_at(curve, k / 1000.0), {}), 1.0, 1e-15);
}

TEST(Examples, conic_is_an_arc_with_the_weight_it_has) {
    const Curve curve = curve_in("conic-weight");
    for (int k = 0; k <= 1000; ++k) EXPECT_NEAR(distance(point_at(curve, k / 1000.0), {}), 3.0, 3e-15);
}

TEST(Examples, two_cubics_join_with_c1_and_not_with_c2) {
    const Document document = example("coons-joined");
    const Curve& left = *document.curves[0].curve;
    const Curve& right = *document.curves[1].curve;
    const auto before = derivatives_at(left, left.domain().upper, 2, Side::left);
    const auto after = derivatives_at(right, right.domain().lower, 2, Side::right);
    EXPECT_LT(distance(before.point, after.point), 1e-15);
    EXPECT_LT(length(before[1] - after[1]), 1e-15);
    EXPECT_GT(length(before[2] - after[2]), 1.0);
    EXPECT_TRUE(says("coons-joined", "They join with C¹"));
}

TEST(Examples, closed_curve_closes_smoothly_and_the_open_one_does_not_close) {
    const Curve closed = curve_in("coons-closed");
    EXPECT_TRUE(closed.is_periodic());
    const auto begin = derivatives_at(closed, closed.domain().lower, 2, Side::right);
    const auto end = derivatives_at(closed, closed.domain().upper, 2, Side::left);
    EXPECT_LT(distance(begin.point, end.point), 1e-13);
    for (std::size_t r = 1; r <= 2; ++r) EXPECT_LT(length(begin[r] - end[r]), 1e-13);
    const Curve open = curve_in("coons-open");
    EXPECT_FALSE(open.is_periodic());
    EXPECT_LT(distance(point_at(open, 0.0), Point(8.0 / 6.0, 15.0 / 6.0)), 1e-15);
    EXPECT_LT(distance(point_at(open, 1.0), Point(22.0 / 6.0, 14.0 / 6.0)), 1e-15);
}

TEST(Examples, sample_has_the_points_of_the_picture) {
    const Curve curve = curve_in("wave");
    const std::vector<Point> points{{-6, -2.2},  {-4.6, 2.6}, {-1.6, 3.6}, {-0.4, -2.6},
                                    {2.6, -3.2}, {3.4, 2.2},  {6.2, 2.8}};
    EXPECT_TRUE(std::ranges::equal(curve.control_points(), points));
    EXPECT_TRUE(std::ranges::equal(curve.weights(), Knots{1, 1, 1, 1, 1, 2, 1}));
}

}  // namespace
}  // namespace batten::core
