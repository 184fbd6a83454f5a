#include "app/editor/commands/form_commands.h"

#include <gtest/gtest.h>

#include <cmath>

#include "app/editor/commands/making_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "tests/editor/finding_fixture.h"

namespace batten::editor {
namespace {

constexpr const char* uniform_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "coons", "degree": 3, "knots": [-3,-2,-1,0,1,2,3,4,5], "kind": "uniform",
    "points": [[0,0],[6,18],[24,18],[30,-6],[42,12]] } ] })";

class FormCommands : public FindingFixture {};

TEST_F(FormCommands, closing_is_told_by_the_data) {
    open_text(editor_, sample_text);
    find(FindClosing{});
    EXPECT_EQ(rows()[0].label, "open");
    EXPECT_NEAR(number(0, "gap"), std::hypot(12.2, 5.0), 1e-14);
    EXPECT_EQ(state().message.text, "wave is open; its ends are 13.1848397790796 apart");
    editor_.run(ActivateCurve{.index = 1});
    find(FindClosing{});
    EXPECT_EQ(rows()[0].label, "periodic");
    EXPECT_EQ(number(0, "continuity"), 1.0);
}

TEST_F(FormCommands, blossom_of_a_bezier_curve_names_its_points) {
    open_text(editor_, bezier_text);
    find(FindBlossom{.arguments = {0.0, 1.0, 0.0}, .u = 0.5});
    EXPECT_EQ(rows()[0].point, core::Point(1.0, 2.0));
    find(FindBlossom{.arguments = {1.0, 0.0, 1.0}, .u = 0.5});
    EXPECT_EQ(rows()[0].point, core::Point(3.0, 2.0));
    EXPECT_FALSE(run_typed(editor_, "blossom 0,1"));
    EXPECT_EQ(state().message.text, "a blossom of degree 3 has 3 arguments; found 2");
}

TEST_F(FormCommands, matrix_form_has_the_coefficients) {
    open_text(editor_, uniform_text);
    find(FindMatrixForm{});
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_EQ(number(0, "a0 x"), 8.0);
    EXPECT_EQ(number(0, "a1 y"), 9.0);
    EXPECT_EQ(number(0, "a3 x"), -4.0);
    EXPECT_EQ(state().message.text, "coons has 2 segments in matrix form");
}

TEST_F(FormCommands, ferguson_form_and_anticentroids) {
    open_text(editor_, uniform_text);
    find(FindFergusonForm{});
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_EQ(number(0, "end tangent y"), -12.0);
    find(FindAnticentroids{});
    ASSERT_EQ(rows().size(), 3U);
    EXPECT_EQ(rows()[0].label, "triangle at P₁");
    EXPECT_EQ(rows()[0].point, (core::Point{8, 15}));
    EXPECT_EQ(number(0, "second derivative y"), -18.0);
    // The next edit wipes the numbers; the views stay.
    EXPECT_TRUE(editor_.state().view.overlays.is_shown(Overlay::ferguson));
    EXPECT_TRUE(editor_.state().view.overlays.is_shown(Overlay::anticentroids));
    EXPECT_FALSE(editor_.state().view.overlays.is_shown(Overlay::cubic_matrix));
}

TEST_F(FormCommands, conic_form_has_type_and_equation) {
    run_typed(editor_, "circle 0 0 2");
    find(FindConicForm{});
    ASSERT_EQ(rows().size(), 4U);
    EXPECT_EQ(rows()[0].label, "ellipse");
    EXPECT_NEAR(number(0, "w"), std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(number(0, "w/(1+w)"), std::sqrt(2.0) - 1.0, 1e-15);
    EXPECT_NEAR(number(0, "C"), 1.0, 1e-15);
}

TEST_F(FormCommands, conic_form_is_refused_for_other_degrees) {
    open_text(editor_, bezier_text);
    EXPECT_EQ(refused(FindConicForm{}), "the degree is 3; this is for degree 2 only");
}

TEST_F(FormCommands, blossom_labels_and_greville_points) {
    open_text(editor_, bezier_text);
    find(FindBlossomLabels{.u = 0.5});
    ASSERT_EQ(rows().size(), 4U + 3U + 2U + 1U);
    EXPECT_EQ(rows()[1].label, "P₁");
    EXPECT_EQ(rows()[1].note, "u2 u3 u4 = 0 0 1");
    EXPECT_EQ(rows()[4].note, "u2 u3 t = 0 0 t");
    EXPECT_EQ(rows()[9].note, "t t t = t t t");
    EXPECT_EQ(rows()[9].point, (core::Point{2, 1.5}));
    find(FindGrevillePoints{});
    ASSERT_EQ(rows().size(), 4U);
    EXPECT_NEAR(number(1, "abscissa"), 1.0 / 3.0, 1e-16);
}

TEST_F(FormCommands, a_greville_point_outside_the_domain_says_so) {
    open_text(editor_, uniform_text);
    find(FindGrevillePoints{});
    EXPECT_EQ(number(0, "abscissa"), -1.0);
    EXPECT_EQ(rows()[0].note, "outside the domain from 0 to 2; the curve does not go so far");
    EXPECT_FALSE(rows()[0].parameter);
    EXPECT_EQ(rows()[1].note, "");
}

TEST_F(FormCommands, collinear_runs_are_found) {
    editor_.run(AddPolyline{.points = {{0, 0}, {1, 0}, {2, 0}, {2, 2}}, .closed = false});
    find(FindCollinearRuns{});
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_EQ(rows()[0].label, "P₀ to P₂");
    EXPECT_EQ(number(0, "to"), 2.0);
    EXPECT_EQ(number(1, "from"), 2.0);
}

}  // namespace
}  // namespace batten::editor
