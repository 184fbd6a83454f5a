#include <gtest/gtest.h>

#include <cmath>

#include "sample_editor.h"

namespace batten::editor {
namespace {

constexpr const char* uniform_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "coons", "degree": 3, "knots": [-3,-2,-1,0,1,2,3,4,5], "kind": "uniform",
    "points": [[0,0],[6,18],[24,18],[30,-6],[42,12]] } ] })";

class FormCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    const std::vector<Finding>& rows() const { return state().findings->rows; }
    // The findings of a command that is expected to succeed.
    void find(const std::string& name, std::vector<Argument> arguments = {}) {
        ASSERT_TRUE(editor_.run({name, std::move(arguments)})) << state().message.text;
        ASSERT_TRUE(state().findings.has_value());
    }
    double number(std::size_t row, const std::string& name) const {
        for (const FoundNumber& found : rows()[row].numbers)
            if (found.name == name) return found.value;
        ADD_FAILURE() << "no number " << name;
        return 0.0;
    }

    Editor editor_;
};

TEST_F(FormCommands, closing_is_told_by_the_data) {
    open_text(editor_, sample_text);
    find("closing");
    EXPECT_EQ(rows()[0].label, "open");
    EXPECT_NEAR(number(0, "gap"), std::hypot(12.2, 5.0), 1e-14);
    EXPECT_EQ(state().message.text, "wave is open; its ends are 13.18 apart");
    editor_.run({"activate-curve", {1.0}});
    find("closing");
    EXPECT_EQ(rows()[0].label, "periodic");
    EXPECT_EQ(number(0, "continuity"), 1.0);
}

TEST_F(FormCommands, blossom_of_a_bezier_curve_names_its_points) {
    open_text(editor_, bezier_text);
    find("blossom", {std::vector<double>{0.0, 1.0, 0.0}});
    EXPECT_EQ(rows()[0].point, core::Point(1.0, 2.0));
    find("blossom", {std::vector<double>{1.0, 0.0, 1.0}});
    EXPECT_EQ(rows()[0].point, core::Point(3.0, 2.0));
    EXPECT_FALSE(editor_.run({"blossom", {std::vector<double>{0.0, 1.0}}}));
    EXPECT_EQ(state().message.text, "a blossom of degree 3 has as many arguments; 2 were given");
}

TEST_F(FormCommands, matrix_form_has_the_coefficients) {
    open_text(editor_, uniform_text);
    find("cubic-matrix");
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_EQ(number(0, "a0 x"), 8.0);
    EXPECT_EQ(number(0, "a1 y"), 9.0);
    EXPECT_EQ(number(0, "a3 x"), -4.0);
    EXPECT_EQ(state().message.text, "coons has 2 segments in matrix form");
}

TEST_F(FormCommands, ferguson_form_and_anticentroids) {
    open_text(editor_, uniform_text);
    find("ferguson");
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_EQ(number(0, "end tangent y"), -12.0);
    find("anticentroids");
    ASSERT_EQ(rows().size(), 3U);
    EXPECT_EQ(rows()[0].label, "triangle at P₁");
    EXPECT_EQ(rows()[0].point, (core::Point{8, 15}));
    EXPECT_EQ(number(0, "second derivative y"), -18.0);
}

TEST_F(FormCommands, conic_form_has_type_and_equation) {
    editor_.run({"circle", {0.0, 0.0, 2.0}});
    find("conic-form");
    ASSERT_EQ(rows().size(), 4U);
    EXPECT_EQ(rows()[0].label, "ellipse");
    EXPECT_NEAR(number(0, "w"), std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(number(0, "w/(1+w)"), std::sqrt(2.0) - 1.0, 1e-15);
    EXPECT_NEAR(number(0, "C"), 1.0, 1e-15);
}

TEST_F(FormCommands, conic_form_is_refused_for_other_degrees) {
    open_text(editor_, bezier_text);
    EXPECT_FALSE(editor_.run({"conic-form", {}}));
    EXPECT_EQ(state().message.text, "the degree is 3; this is for degree 2 only");
}

TEST_F(FormCommands, blossom_labels_and_greville_points) {
    open_text(editor_, bezier_text);
    find("blossom-labels", {0.5});
    ASSERT_EQ(rows().size(), 4U + 3U + 2U + 1U);
    EXPECT_EQ(rows()[1].label, "P₁");
    EXPECT_EQ(rows()[1].note, "u2 u3 u4 = 0 0 1");
    EXPECT_EQ(rows()[4].note, "u2 u3 t = 0 0 t");
    EXPECT_EQ(rows()[9].note, "t t t = t t t");
    EXPECT_EQ(rows()[9].point, (core::Point{2, 1.5}));
    find("greville-points");
    ASSERT_EQ(rows().size(), 4U);
    EXPECT_NEAR(number(1, "abscissa"), 1.0 / 3.0, 1e-16);
}

TEST_F(FormCommands, collinear_runs_are_found) {
    editor_.run({"polyline", {std::vector<double>{0, 0, 1, 0, 2, 0, 2, 2}, 0.0}});
    find("collinear-runs");
    ASSERT_EQ(rows().size(), 2U);
    EXPECT_EQ(rows()[0].label, "P₀ to P₂");
    EXPECT_EQ(number(0, "to"), 2.0);
    EXPECT_EQ(number(1, "from"), 2.0);
}

}  // namespace
}  // namespace batten::editor
