#include <gtest/gtest.h>

#include "app/editor/lesson/check.h"
#include "app/editor/lesson/check_json.h"
#include "core/make/conics.h"
#include "core/make/shapes.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

core::Curve curve_of(int degree, std::vector<double> knots, std::vector<core::Point> points,
                     std::vector<double> weights = {}) {
    if (weights.empty()) weights.assign(points.size(), 1.0);
    return core::Curve::make(core::KnotVector::make(degree, std::move(knots)).value(), std::move(points),
                             std::move(weights))
        .value();
}

EditorState state_of(std::vector<core::Curve> curves) {
    core::Document document;
    for (core::Curve& curve : curves)
        document.curves.emplace_back().curve = std::make_shared<const core::Curve>(std::move(curve));
    EditorState state;
    state.history = History(std::move(document));
    return state;
}

const core::Curve cubic =
    curve_of(3, {0, 0, 0, 0, 0.5, 0.5, 1, 1, 1, 1}, {{0, 0}, {1, 2}, {2, 2}, {4, 1}, {5, 0}, {6, 3}});

void expect(const LessonCheck& check, const EditorState& state, bool holds, const std::string& sentence) {
    const CheckResult result = result_of(check, state);
    EXPECT_EQ(result.holds, holds) << name_of(check);
    EXPECT_EQ(result.sentence, sentence);
}

TEST(LessonCheck, tells_numbers_of_the_curve) {
    const EditorState state = state_of({cubic});
    expect(DegreeIs{3}, state, true, "the degree is 3");
    expect(DegreeIs{2}, state, false, "the degree is 3, not yet 2");
    expect(PointCountIs{6}, state, true, "there are 6 control points");
    expect(PointCountIs{7}, state, false, "there are 6 control points, not yet 7");
    expect(SegmentCountIs{2}, state, true, "the number of segments is 2");
    expect(CurveCountIs{2}, state, false, "the number of curves is 1, not yet 2");
}

TEST(LessonCheck, tells_multiplicities_and_continuity) {
    const EditorState state = state_of({cubic});
    expect(MultiplicityIs{0.5, 2}, state, true, "the multiplicity of 1/2 is 2");
    expect(MultiplicityIs{0.5, 3}, state, false, "the multiplicity of 1/2 is 2, not yet 3");
    expect(MultiplicityIs{0.25, 1}, state, false, "the multiplicity of 1/4 is 0, not yet 1");
    expect(ContinuityIs{0.5, 1}, state, true, "the curve is C¹ at 1/2 by its knots");
    expect(ContinuityIs{0.5, 0}, state, false, "the curve is C¹ at 1/2 by its knots, not yet C⁰");
    expect(NoInteriorKnot{}, state, false, "there still is one interior knot");
    expect(KindIs{core::KnotKind::bezier}, state, false, "the knots are custom, not yet Bézier");
}

TEST(LessonCheck, tells_where_the_curve_passes) {
    const EditorState state = state_of({cubic});
    expect(PassesThrough{.point = 5}, state, true, "the curve passes through P₅");
    EXPECT_FALSE(result_of(PassesThrough{.point = 1}, state).holds);
    EXPECT_TRUE(result_of(PassesThrough{.at = {0, 0}}, state).holds);
    expect(PassesThrough{.at = {-3, -4}}, state, false, "the curve passes (−3, −4) at a distance of 5");
    expect(PassesThrough{.point = 6}, state, false, "there is no control point P₆");
}

TEST(LessonCheck, tells_circles_and_conics) {
    const double w = std::sqrt(0.5);
    const auto arc = [&](double weight) {
        return state_of({curve_of(2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1, 1}, {0, 1}}, {1, weight, 1})});
    };
    expect(IsCircle{}, arc(w), true, "the curve lies on a circle");
    EXPECT_FALSE(result_of(IsCircle{}, arc(w + 1e-4)).holds);
    EXPECT_TRUE(result_of(ConicIs{core::ConicType::ellipse}, arc(w)).holds);
    EXPECT_TRUE(result_of(ConicIs{core::ConicType::parabola}, arc(1.0)).holds);
    EXPECT_TRUE(result_of(ConicIs{core::ConicType::hyperbola}, arc(2.0)).holds);
    expect(ConicIs{core::ConicType::ellipse}, arc(2.0), false, "the conic is of the kind hyperbola, not yet ellipse");
    EXPECT_FALSE(result_of(ConicIs{}, state_of({cubic})).holds);
    expect(IsCircle{}, state_of({curve_of(1, {0, 0, 1, 1}, {{0, 0}, {1, 1}})}), false, "the curve is straight");
    EXPECT_TRUE(result_of(IsRational{true}, arc(2.0)).holds);
    EXPECT_FALSE(result_of(IsRational{true}, state_of({cubic})).holds);
    expect(WeightIs{.point = 1, .is = 2.0}, arc(2.0), true, "the weight of P₁ is 2");
    expect(WeightIs{.point = 1, .is = 3.0}, arc(2.0), false, "the weight of P₁ is 2, not yet 3");
}

TEST(LessonCheck, tells_how_curves_join) {
    const auto line = [](core::Point a, core::Point b) { return curve_of(1, {0, 0, 1, 1}, {a, b}); };
    const auto pair = [&](core::Point far) { return state_of({line({0, 0}, {1, 1}), line(far, {1, 1})}); };
    const auto holds = [](const EditorState& state, JointOrder order) {
        return result_of(CurvesJoin{.order = order}, state).holds;
    };
    EXPECT_TRUE(holds(pair({2, 2}), JointOrder::C1)) << "the second runs the other way";
    EXPECT_TRUE(holds(pair({3, 3}), JointOrder::G1));
    EXPECT_FALSE(holds(pair({3, 3}), JointOrder::C1));
    EXPECT_TRUE(holds(pair({2, 1}), JointOrder::C0));
    EXPECT_FALSE(holds(pair({2, 1}), JointOrder::G1));
    EXPECT_FALSE(holds(pair({0, 0}), JointOrder::G1)) << "both come from the same side";
    expect(CurvesJoin{}, state_of({line({0, 0}, {1, 1}), line({1, 2}, {5, 5})}), false, "the ends are 1 apart");
    // 1/3 and the root of 2, each in as many digits as one reads.
    expect(CurvesJoin{}, state_of({line({0, 0}, {1, 1}), line({1, 4.0 / 3.0}, {5, 5})}), false,
           "the ends are 1/3 apart");
    expect(CurvesJoin{}, state_of({line({-6, -2}, {-1, 1}), line({0, 0}, {6, 2})}), false, "the ends are 1.414 apart");
    expect(CurvesJoin{.order = JointOrder::C1}, pair({3, 3}), false, "the curves meet with G²; it shall be C¹");
    expect(CurvesJoin{.order = JointOrder::C2}, pair({2, 2}), true, "the curves meet with C²");
    expect(CurvesJoin{.second = 2}, pair({2, 2}), false, "there are not two curves");
    // Half circles of one radius, the second of which bends the other way: G1, not G2.
    const auto arc = [](core::Point a, core::Point b, core::Point c, core::Point d) {
        return curve_of(3, {0, 0, 0, 0, 1, 1, 1, 1}, {a, b, c, d});
    };
    const EditorState wave = state_of({arc({-2, 0}, {-2, 1}, {0, 1}, {0, 0}), arc({0, 0}, {0, -1}, {2, -1}, {2, 0})});
    EXPECT_TRUE(holds(wave, JointOrder::C1));
    EXPECT_FALSE(holds(wave, JointOrder::G2));
    const EditorState even = state_of({arc({-2, 0}, {-2, 1}, {-1, 2}, {0, 2}), arc({0, 2}, {1, 2}, {2, 1}, {2, 0})});
    EXPECT_TRUE(holds(even, JointOrder::G2)) << "a mirrored arc with equal curvature";
    EXPECT_TRUE(holds(even, JointOrder::C2));
}

TEST(LessonCheck, tells_places_and_lines) {
    const EditorState state = state_of({cubic});
    expect(PointIsAt{.point = 1, .at = {1, 2}}, state, true, "P₁ is at (1, 2)");
    expect(PointIsAt{.point = 1, .at = {1, 3}}, state, false, "P₁ is at (1, 2), not yet at (1, 3)");
    expect(PointsAreCollinear{.points = {0, 4, 2}}, state, false, "a point is 2 off the line");
    expect(PointsAreCollinear{.points = {0, 1, 3}}, state, false, "a point is 1.698 off the line");
    EXPECT_TRUE(result_of(PointsAreCollinear{.points = {1, 2, 1}}, state).holds);
    expect(IsClosed{}, state, false, "the curve is still open");
    expect(ParameterIs{.is = 0.0}, state, true, "u is 0");
    expect(OverlayIsShown{Overlay::support}, state, false, "the view 'support' is not shown yet");
}

TEST(LessonCheck, tells_smoothness_of_the_shape) {
    const double w = std::sqrt(0.5);
    // Three quarters of a circle: equal spans, then the last one twice as long, which halves C' behind 2.
    const auto arcs = [&](double end) {
        return state_of(
            {curve_of(2, {0, 0, 0, 1, 1, 2, 2, end, end, end},
                      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}}, {1, w, 1, w, 1, w, 1})});
    };
    expect(SmoothnessIs{.knot = 1, .order = JointOrder::C1}, arcs(3.0), true,
           "C⁰ by its knots, C¹ and G² by its shape");
    expect(SmoothnessIs{.knot = 1, .order = JointOrder::C2}, arcs(3.0), false,
           "C⁰ by its knots, C¹ and G² by its shape; it shall be C²");
    EXPECT_TRUE(result_of(SmoothnessIs{.knot = 2, .order = JointOrder::G2}, arcs(4.0)).holds);
    expect(SmoothnessIs{.knot = 2, .order = JointOrder::C1}, arcs(4.0), false,
           "C⁰ by its knots, G² by its shape; it shall be C¹");
    expect(SmoothnessIs{.knot = 0, .order = JointOrder::C0}, arcs(4.0), false, "0 is no inner knot");
    expect(SmoothnessIs{.knot = 1.5, .order = JointOrder::C0}, arcs(4.0), false, "3/2 is no inner knot");
    const EditorState corner = state_of({curve_of(1, {0, 0, 1, 2, 2}, {{0, 0}, {1, 0}, {1.99, 0.01}})});
    expect(SmoothnessIs{.knot = 1, .order = JointOrder::C0}, corner, true, "C⁰ by its knots, a corner by its shape");
    EXPECT_FALSE(result_of(SmoothnessIs{.knot = 1, .order = JointOrder::G1}, corner).holds);
    EXPECT_TRUE(result_of(SmoothnessIs{1, JointOrder::G1, 0.02}, corner).holds) << "it turns by about 0.01";
}

TEST(LessonCheck, tells_clamped_ends) {
    const EditorState half =
        state_of({curve_of(3, {0, 0, 0, 0, 1, 2, 3, 4, 5}, {{0, 0}, {1, 2}, {3, 2}, {4, 0}, {6, 1}})});
    expect(IsClamped{}, state_of({cubic}), true, "the curve is clamped at both ends");
    expect(IsClamped{}, half, false, "the curve is not clamped yet");
    expect(IsClamped{core::CurveEnd::start}, half, true, "the curve is clamped at its start");
    expect(IsClamped{core::CurveEnd::end}, half, false, "the curve is not clamped yet at its end");
}

TEST(LessonCheck, counts_crossings_of_the_shown_line) {
    EditorState state = state_of({curve_of(2, {0, 0, 0, 1, 1, 1}, {{0, 0}, {2, 4}, {4, 0}})});
    const auto put = [&](double height) { state.view.shape.line = ProbeLine{{0, height}, {4, height}}; };
    put(1.0);
    expect(CrossingsAre{2, 2}, state, false, "there is no line to be crossed");
    state.view.overlays.show(Overlay::variation, true);
    expect(CrossingsAre{2, 2}, state, true, "crossings of the line: 2 with the polygon, 2 with the curve");
    put(3.0);  // the parabola's highest point is at 2
    expect(CrossingsAre{2, 0}, state, true, "crossings of the line: 2 with the polygon, 0 with the curve");
    EXPECT_FALSE(result_of(CrossingsAre{.curve = 2}, state).holds);
    EXPECT_FALSE(result_of(CrossingsAre{.polygon = 0}, state).holds);
    EXPECT_TRUE(result_of(CrossingsAre{.polygon = 2}, state).holds);
}

TEST(LessonCheck, tells_what_is_convex) {
    const auto bezier = [](std::vector<core::Point> points) {
        return state_of({curve_of(3, {0, 0, 0, 0, 1, 1, 1, 1}, std::move(points))});
    };
    const EditorState arch = bezier({{0, 0}, {1, 2}, {3, 2}, {4, 0}});
    expect(IsConvex{ConvexShape::polygon}, arch, true, "the polygon is convex");
    expect(IsConvex{ConvexShape::curve}, arch, true, "the curve is convex");
    const EditorState wave = bezier({{0, 0}, {1, 2}, {3, -2}, {4, 0}});
    expect(IsConvex{ConvexShape::polygon}, wave, false, "the polygon is not convex yet");
    expect(IsConvex{ConvexShape::curve}, wave, false, "the curve is not convex yet");
    // The dent of the polygon is cut off by the curve: of degree 4, all of whose second differences point downward.
    const EditorState dented =
        state_of({curve_of(4, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1}, {{0, 0}, {1, 4}, {2, 3.9}, {3, 4}, {4, 0}})});
    EXPECT_FALSE(result_of(IsConvex{ConvexShape::polygon}, dented).holds);
    EXPECT_TRUE(result_of(IsConvex{ConvexShape::curve}, dented).holds);
    EXPECT_TRUE(result_of(IsConvex{ConvexShape::curve}, state_of({core::circle({1e6, 0}, 2.0).value()})).holds);
}

TEST(LessonCheck, asks_for_a_curve) {
    expect(DegreeIs{3}, state_of({}), false, "there is no curve");
}

TEST(LessonCheck, is_written_and_read_back) {
    for (const LessonCheck& check : std::vector<LessonCheck>{DegreeIs{3},
                                                             PointCountIs{4},
                                                             SegmentCountIs{2},
                                                             CurveCountIs{1},
                                                             MultiplicityIs{0.5, 3},
                                                             ContinuityIs{0.25, 0},
                                                             NoInteriorKnot{},
                                                             KindIs{core::KnotKind::bezier},
                                                             PassesThrough{.point = 3},
                                                             PassesThrough{.at = {1, 2.5}},
                                                             IsCircle{},
                                                             ConicIs{core::ConicType::hyperbola},
                                                             IsClosed{},
                                                             IsRational{false},
                                                             WeightIs{1, 0.5, 1e-3},
                                                             PointIsAt{2, {3, 4}, 0.1},
                                                             ParameterIs{0.4, 0.01},
                                                             OverlayIsShown{Overlay::grid},
                                                             CurvesJoin{0, 1, JointOrder::G1, 1e-4},
                                                             PointsAreCollinear{{0, 1, 2}, 0.01},
                                                             SmoothnessIs{0.25, JointOrder::C2, 1e-3},
                                                             IsClamped{},
                                                             IsClamped{core::CurveEnd::end},
                                                             CrossingsAre{2, 0},
                                                             CrossingsAre{.curve = 3},
                                                             IsConvex{ConvexShape::curve}}) {
        const LessonJson json = json_of(check);
        const Outcome<LessonCheck> read = read_check(json, "/checks/0");
        ASSERT_TRUE(read) << json.dump() << read.error();
        EXPECT_EQ(json_of(*read), json);
        EXPECT_EQ(read->index(), check.index());
    }
    EXPECT_EQ(json_of(MultiplicityIs{0.5, 3}).dump(), R"({"check":"multiplicity","knot":0.5,"is":3})");
}

TEST(LessonCheck, is_refused_with_its_place) {
    const auto refusal = [](const char* text) { return read_check(LessonJson::parse(text), "/checks/2").error(); };
    EXPECT_EQ(refusal(R"({"check": "multiplicity", "knot": 0.5})"), "/checks/2: the member \"is\" is missing");
    EXPECT_EQ(refusal(R"({"check": "degree", "is": 2.5})"), "/checks/2/is: this must be a whole number");
    EXPECT_EQ(refusal(R"({"check": "degree", "is": 2, "knot": 1})"), "/checks/2/knot: this member is not known");
    EXPECT_EQ(refusal(R"({"check": "conic", "is": "oval"})"),
              "/checks/2/is: this must be ellipse, parabola or hyperbola");
    EXPECT_NE(refusal(R"({"check": "magic"})").find("/checks/2/check: this must be degree, "), std::string::npos);
}

}  // namespace
}  // namespace batten::editor
