#include <gtest/gtest.h>

#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/closing.h"
#include "sample_editor.h"

namespace batten::editor {
namespace {

constexpr const char* uniform_text = R"({ "format": "batten", "version": 1, "curves": [
  { "name": "coons", "degree": 3, "knots": [-3,-2,-1,0,1,2,3,4,5], "kind": "uniform",
    "points": [[0,0],[6,18],[24,18],[30,-6],[42,12]] } ] })";

class ClosingCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    bool run(const std::string& name, std::vector<Argument> arguments = {}) {
        return editor_.run({name, std::move(arguments)});
    }
    core::Closing closing() const { return core::closing_of(curve(editor_)).closing; }

    Editor editor_;
};

TEST_F(ClosingCommands, convert_between_the_three_kinds) {
    open_text(editor_, sample_text);
    run("activate-curve", {1.0});
    EXPECT_TRUE(run("to-clamped")) << state().message.text;
    EXPECT_EQ(closing(), core::Closing::ends_meet);
    EXPECT_EQ(points(editor_).size(), 7U);
    EXPECT_TRUE(run("to-periodic")) << state().message.text;
    EXPECT_EQ(closing(), core::Closing::periodic);
    EXPECT_EQ(points(editor_).size(), 5U);
    EXPECT_TRUE(run("to-wrapped")) << state().message.text;
    EXPECT_EQ(closing(), core::Closing::wrapped);
    EXPECT_EQ(points(editor_).size(), 7U);
    EXPECT_TRUE(run("to-periodic"));
    EXPECT_EQ(points(editor_).size(), 5U);
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 1, 2, 3, 4, 5}));
}

TEST_F(ClosingCommands, refuse_a_curve_whose_ends_are_apart) {
    open_text(editor_, bezier_text);
    EXPECT_FALSE(run("to-periodic", {0.5}));
    EXPECT_EQ(state().message.text, "the ends of the curve are 4 apart; at most 0.5 counts as meeting");
    EXPECT_FALSE(run("to-periodic", {0.0}));
    EXPECT_EQ(state().message.text, "the tolerance is 0; it must be above 0 and finite");
    EXPECT_FALSE(run("move-seam", {0.5}));
}

TEST_F(ClosingCommands, move_the_seam_to_the_parameter) {
    open_text(editor_, sample_text);
    run("activate-curve", {1.0});
    run("set-parameter", {2.0});
    const core::Point there = core::point_at(curve(editor_), 2.0);
    EXPECT_TRUE(run("move-seam"));
    EXPECT_EQ(knots(editor_), (std::vector<double>{2, 3, 4, 5, 6, 7}));
    EXPECT_EQ(core::point_at(curve(editor_), 2.0), there);
    EXPECT_EQ(state().history.undo_label(), "Move seam to 2");
}

TEST_F(ClosingCommands, add_end_vertices) {
    open_text(editor_, uniform_text);
    EXPECT_TRUE(run("phantom-end"));
    EXPECT_EQ(points(editor_).front(), (core::Point{-6, -18}));
    EXPECT_EQ(points(editor_).back(), (core::Point{54, 30}));
    EXPECT_EQ(state().history.undo_label(), "Add phantom end vertices");
    run("undo");
    EXPECT_TRUE(run("triple-end", {"start"}));
    EXPECT_EQ(points(editor_).size(), 7U);
    EXPECT_EQ(core::point_at(curve(editor_), curve(editor_).domain().lower), (core::Point{0, 0}));
    run("undo");
    EXPECT_TRUE(run("double-end", {"end"}));
    EXPECT_EQ(points(editor_).size(), 6U);
    EXPECT_FALSE(run("double-end", {"middle"}));
    EXPECT_EQ(state().message.text, "end is 'middle'; it must be start, end or both");
}

TEST_F(ClosingCommands, refuse_end_vertices_of_other_curves) {
    open_text(editor_, bezier_text);
    EXPECT_FALSE(run("double-end"));
    EXPECT_EQ(state().message.text,
              "the curve is not a uniform cubic; it must have degree 3 and equally spaced knots, without clamped ends");
}

TEST_F(ClosingCommands, straighten_between_points) {
    open_text(editor_, bezier_text);
    EXPECT_FALSE(run("straighten"));
    run("select-points", {std::vector<double>{0, 3}});
    EXPECT_TRUE(run("straighten"));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {1, 0}, {3, 0}, {4, 0}}));
    EXPECT_EQ(state().history.undo_label(), "Straighten from P₀ to P₃");
    EXPECT_FALSE(run("straighten", {0.0, 9.0}));
    EXPECT_EQ(state().message.text, "there is no control point 9; the last one is 3");
}

}  // namespace
}  // namespace batten::editor
