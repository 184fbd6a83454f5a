#include "app/editor/pointer/highlight.h"

#include <gtest/gtest.h>

#include "tests/editor/pointer_driver.h"

namespace batten::editor {
namespace {

using Indices = std::vector<std::size_t>;
using Parts = std::vector<core::Interval>;

Highlight highlight_of(core::CurveDefinition definition, Hover hover) {
    EditorState state = test::state_with(std::move(definition));
    state.hover = hover;
    return highlight(state);
}

TEST(Highlight, of_an_inner_point_has_its_knots_and_support) {
    const Highlight lit = highlight_of(test::cubic(), HoveredPoint{3});
    EXPECT_EQ(lit.points, Indices{3});
    EXPECT_EQ(lit.basis, Indices{3});
    EXPECT_EQ(lit.knots, (Indices{3, 4, 5, 6, 7}));
    EXPECT_EQ(lit.parts, (Parts{{0.0, 1.0}}));
    EXPECT_FALSE(lit.shows_hull);
}

TEST(Highlight, of_points_near_the_ends_is_cut_at_the_clamped_knots) {
    EXPECT_EQ(highlight_of(test::cubic(), HoveredPoint{0}).knots, (Indices{0, 1, 2, 3, 4}));
    EXPECT_EQ(highlight_of(test::cubic(), HoveredPoint{0}).parts, (Parts{{0.0, 0.25}}));
    EXPECT_EQ(highlight_of(test::cubic(), HoveredPoint{1}).parts, (Parts{{0.0, 0.5}}));
    EXPECT_EQ(highlight_of(test::cubic(), HoveredPoint{6}).knots, (Indices{6, 7, 8, 9, 10}));
    EXPECT_EQ(highlight_of(test::cubic(), HoveredPoint{6}).parts, (Parts{{0.75, 1.0}}));
}

TEST(Highlight, of_ring_and_graph_is_that_of_the_point) {
    EXPECT_EQ(highlight_of(test::cubic(), HoveredWeightRing{1}).parts, (Parts{{0.0, 0.5}}));
    EXPECT_EQ(highlight_of(test::cubic(), HoveredBasis{1}).knots, (Indices{1, 2, 3, 4, 5}));
}

TEST(Highlight, of_a_function_of_the_recurrence_is_its_knots) {
    const Highlight lit = highlight_of(test::cubic(), HoveredBasisCell{3, 1});
    EXPECT_EQ(lit.knots, (Indices{3, 4, 5}));
    EXPECT_TRUE(lit.points.empty());
    EXPECT_EQ(highlight_of(test::cubic(), HoveredBasisCell{9, 0}).knots, (Indices{9, 10}));
    EXPECT_TRUE(highlight_of(test::cubic(), HoveredBasisCell{10, 0}).is_empty());
    EXPECT_EQ(highlight_of(test::cubic(), HoveredBasisCell{1, 3}).parts, (Parts{{0.0, 0.5}}));
    EXPECT_EQ(highlight_of(test::cubic(), HoveredBasisCell{1, 3}).points, Indices{1});
    // Unrolled the knots of the closed cubic begin with -3.
    EXPECT_EQ(highlight_of(test::closed_cubic(), HoveredBasisCell{3, 0}).knots, (Indices{0, 1, 6}));
}

TEST(Highlight, of_an_unclamped_point_is_cut_to_the_domain) {
    core::CurveDefinition uniform = test::cubic();
    uniform.knots = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    EXPECT_EQ(highlight_of(uniform, HoveredPoint{0}).parts, (Parts{{3.0, 4.0}}));
    EXPECT_EQ(highlight_of(uniform, HoveredPoint{0}).knots, (Indices{0, 1, 2, 3, 4}));
    EXPECT_EQ(highlight_of(uniform, HoveredPoint{5}).parts, (Parts{{5.0, 7.0}}));
}

TEST(Highlight, of_a_cell_has_the_points_it_combines_and_the_knots_of_its_ratio) {
    EditorState state = test::state_with(test::cubic());
    state.view.parameter = 0.4;
    state.hover = HoveredCell{1, 1};  // P_3^1 of P_2 and P_3, over [u_3, u_6]
    EXPECT_EQ(highlight(state).points, (Indices{2, 3}));
    EXPECT_EQ(highlight(state).knots, (Indices{3, 6}));
    EXPECT_TRUE(highlight(state).basis.empty());
    EXPECT_TRUE(highlight(state).parts.empty());
    state.hover = HoveredCell{2, 1};  // P_4^2, over [u_4, u_6]
    EXPECT_EQ(highlight(state).points, (Indices{2, 3, 4}));
    EXPECT_EQ(highlight(state).knots, (Indices{4, 6}));
    state.hover = HoveredCell{0, 3};
    EXPECT_EQ(highlight(state).points, Indices{4});
    EXPECT_TRUE(highlight(state).knots.empty());
}

TEST(Highlight, of_a_cell_goes_round_a_closed_curve) {
    EditorState state = test::state_with(test::closed_cubic());
    state.view.parameter = 0.5;       // the local points 0, 1, 2, 3 over u_{-2}..: unrolled knots -3, -2, ...
    state.hover = HoveredCell{1, 0};  // over [-2, 1]
    EXPECT_EQ(highlight(state).points, (Indices{0, 1}));
    EXPECT_EQ(highlight(state).knots, (Indices{1, 4}));
}

TEST(Highlight, of_a_simple_knot_has_two_spans_and_p_plus_two_points) {
    const Highlight lit = highlight_of(test::cubic(), HoveredKnot{5});
    EXPECT_EQ(lit.knots, Indices{5});
    EXPECT_EQ(lit.points, (Indices{1, 2, 3, 4, 5}));
    EXPECT_EQ(lit.basis, lit.points);
    EXPECT_EQ(lit.parts, (Parts{{0.25, 0.5}, {0.5, 0.75}}));
}

TEST(Highlight, of_a_stack_is_the_same_for_each_of_its_knots) {
    core::CurveDefinition definition = test::cubic();
    definition.knots = {0, 0, 0, 0, 0.25, 0.5, 0.5, 1, 1, 1, 1};
    for (const std::size_t k : {5U, 6U}) {
        const Highlight lit = highlight_of(definition, HoveredKnot{k});
        EXPECT_EQ(lit.knots, (Indices{5, 6}));
        EXPECT_EQ(lit.points, (Indices{1, 2, 3, 4, 5, 6}));
        EXPECT_EQ(lit.parts, (Parts{{0.25, 0.5}, {0.5, 1.0}}));
    }
}

TEST(Highlight, of_a_clamped_end_has_one_span) {
    for (const std::size_t k : {0U, 3U}) {
        const Highlight lit = highlight_of(test::cubic(), HoveredKnot{k});
        EXPECT_EQ(lit.knots, (Indices{0, 1, 2, 3}));
        EXPECT_EQ(lit.points, (Indices{0, 1, 2, 3}));
        EXPECT_EQ(lit.parts, (Parts{{0.0, 0.25}}));
    }
}

TEST(Highlight, of_a_knot_outside_the_domain_has_points_but_no_part) {
    core::CurveDefinition uniform = test::cubic();
    uniform.knots = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    const Highlight lit = highlight_of(uniform, HoveredKnot{1});
    EXPECT_EQ(lit.points, (Indices{0, 1}));
    EXPECT_TRUE(lit.parts.empty());
}

TEST(Highlight, of_a_span_has_its_points_and_their_hull) {
    const Highlight lit = highlight_of(test::cubic(), HoveredSpan{4});
    EXPECT_EQ(lit.points, (Indices{1, 2, 3, 4}));
    EXPECT_EQ(lit.parts, (Parts{{0.25, 0.5}}));
    EXPECT_TRUE(lit.knots.empty());
    EXPECT_TRUE(lit.shows_hull);
}

TEST(Highlight, of_a_periodic_point_runs_over_the_seam) {
    const Highlight first = highlight_of(test::closed_cubic(), HoveredPoint{0});
    EXPECT_EQ(first.points, Indices{0});
    EXPECT_EQ(first.knots, (Indices{0, 1, 3, 4, 5, 6}));
    EXPECT_EQ(first.parts, (Parts{{3.0, 6.0}, {0.0, 1.0}}));
    EXPECT_EQ(highlight_of(test::closed_cubic(), HoveredPoint{3}).parts, (Parts{{0.0, 4.0}}));
    EXPECT_EQ(highlight_of(test::closed_cubic(), HoveredPoint{5}).parts, (Parts{{2.0, 6.0}}));
}

TEST(Highlight, of_the_seam_has_the_spans_at_both_ends) {
    for (const std::size_t k : {0U, 6U}) {
        const Highlight lit = highlight_of(test::closed_cubic(), HoveredKnot{k});
        EXPECT_EQ(lit.knots, (Indices{0, 6}));
        EXPECT_EQ(lit.points, (Indices{0, 1, 2, 3, 5}));
        EXPECT_EQ(lit.parts, (Parts{{0.0, 1.0}, {5.0, 6.0}}));
    }
}

TEST(Highlight, of_periodic_knots_and_spans_wraps_the_points) {
    EXPECT_EQ(highlight_of(test::closed_cubic(), HoveredKnot{2}).points, (Indices{1, 2, 3, 4, 5}));
    EXPECT_EQ(highlight_of(test::closed_cubic(), HoveredKnot{5}).points, (Indices{0, 1, 2, 4, 5}));
    EXPECT_EQ(highlight_of(test::closed_cubic(), HoveredSpan{3}).points, (Indices{0, 1, 2, 3}));
    EXPECT_EQ(highlight_of(test::closed_cubic(), HoveredSpan{8}).points, (Indices{0, 1, 2, 5}));
}

TEST(Highlight, of_a_point_whose_support_covers_the_whole_period) {
    core::CurveDefinition definition = test::closed_cubic();
    definition.knots = {0, 1, 2};
    definition.points = {{0, 0}, {1, 1}};
    const Highlight lit = highlight_of(definition, HoveredPoint{0});
    EXPECT_EQ(lit.parts, (Parts{{0.0, 2.0}}));
    EXPECT_EQ(lit.knots, (Indices{0, 1, 2}));
    EXPECT_EQ(highlight_of(definition, HoveredKnot{1}).points, (Indices{0, 1}));
}

TEST(Highlight, is_empty_for_what_has_no_links_or_is_gone) {
    EXPECT_TRUE(highlight_of(test::cubic(), HoveredNothing{}).is_empty());
    EXPECT_TRUE(highlight_of(test::cubic(), HoveredParameter{}).is_empty());
    EXPECT_TRUE(highlight_of(test::cubic(), HoveredPoint{7}).is_empty());
    EXPECT_TRUE(highlight_of(test::cubic(), HoveredKnot{11}).is_empty());
    EXPECT_TRUE(highlight_of(test::cubic(), HoveredSpan{10}).is_empty());
    EXPECT_TRUE(highlight_of(test::cubic(), HoveredSpan{1}).is_empty());
    EXPECT_TRUE(highlight(EditorState()).is_empty());
}

}  // namespace
}  // namespace batten::editor
