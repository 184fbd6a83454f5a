#include <gtest/gtest.h>

#include "core/curve/knot_analysis.h"
#include "sample_editor.h"

namespace batten::editor {
namespace {

class KnotCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    bool run(const std::string& name, std::vector<Argument> arguments = {}) {
        return editor_.run({name, std::move(arguments)});
    }

    Editor editor_;
};

TEST_F(KnotCommands, insert_and_select_a_knot_and_keep_the_shape) {
    open_text(editor_, bezier_text);
    EXPECT_TRUE(run("insert-knot", {0.5}));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 1, 1, 1, 1}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {0.5, 1}, {2, 2}, {3.5, 1}, {4, 0}}));
    EXPECT_EQ(state().selection.knot, 4U);
    EXPECT_EQ(state().history.undo_label(), "Insert knot 0.5");
    EXPECT_TRUE(run("raise-knot"));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 0.5, 1, 1, 1, 1}));
    EXPECT_EQ(state().selection.knot, 5U);
    EXPECT_TRUE(run("raise-knot"));
    // de Casteljau at 1/2: the curve itself is a control point now.
    EXPECT_EQ(points(editor_)[3], (core::Point{2, 1.5}));
    EXPECT_FALSE(run("raise-knot"));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_EQ(knots(editor_).size(), 11U);
}

TEST_F(KnotCommands, insert_at_the_parameter_or_at_all_midpoints) {
    open_text(editor_, sample_text);
    run("set-parameter", {0.3});
    run("insert-knot");
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.2, 0.3, 0.5, 0.75, 1, 1, 1, 1}));
    run("undo");
    EXPECT_TRUE(run("insert-midpoints"));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.1, 0.2, 0.35, 0.5, 0.625, 0.75, 0.875, 1, 1, 1, 1}));
    EXPECT_EQ(state().history.undo_label(), "Insert knots at all midpoints");
    EXPECT_FALSE(run("insert-knot", {1.5}));
    EXPECT_EQ(state().message.text, "the parameter 1.5 is outside the domain; it must be from 0 to 1");
}

TEST_F(KnotCommands, move_a_knot_and_keep_it_selected) {
    open_text(editor_, sample_text);
    run("select-knot", {4.0});
    EXPECT_TRUE(run("move-knot", {4.0, 0.4, "stop"}));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.4, 0.5, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(state().history.undo_label(), "Move knot 0.2");
    EXPECT_TRUE(run("move-knot", {4.0, 0.6, "stop"}));
    EXPECT_EQ(knots(editor_)[4], 0.5);
    EXPECT_EQ(knots(editor_)[5], 0.5);
    // Pulled out of the stack to the right: it is the other one that goes.
    EXPECT_TRUE(run("move-knot", {4.0, 0.6, "stop"}));
    EXPECT_EQ(knots(editor_)[4], 0.5);
    EXPECT_EQ(knots(editor_)[5], 0.6);
    EXPECT_EQ(state().selection.knot, 5U);
}

TEST_F(KnotCommands, push_and_snap_as_asked_for) {
    open_text(editor_, sample_text);
    EXPECT_TRUE(run("move-knot", {4.0, 0.6, "push"}));
    EXPECT_EQ(knots(editor_)[4], 0.6);
    EXPECT_GE(knots(editor_)[5], 0.6);
    EXPECT_LT(knots(editor_)[5], 0.62);
    EXPECT_EQ(knots(editor_)[6], 0.75);
    run("undo");
    EXPECT_TRUE(run("move-knot", {4.0, 0.48, "snap", 0.05}));
    EXPECT_EQ(knots(editor_)[4], 0.5);
    EXPECT_FALSE(run("move-knot", {4.0, 0.48, "jump"}));
    EXPECT_EQ(state().message.text, "mode is 'jump'; it must be stop, push or snap");
    EXPECT_FALSE(run("move-knot", {4.0, 0.48, "snap", -1.0}));
    EXPECT_FALSE(run("move-knot", {11.0, 0.48}));
    EXPECT_EQ(state().message.text, "there is no knot 11; the last one is 10");
    EXPECT_FALSE(run("move-knot", {1.5, 0.48}));
    EXPECT_EQ(state().message.text, "index is 1.5; a whole number from 0 is needed");
}

TEST_F(KnotCommands, set_and_delete_a_knot) {
    open_text(editor_, sample_text);
    EXPECT_TRUE(run("set-knot", {5.0, 0.6}));
    EXPECT_EQ(knots(editor_)[5], 0.6);
    EXPECT_EQ(state().history.undo_label(), "Set knot 0.5 to 0.6");
    EXPECT_EQ(state().selection.knot, 5U);
    EXPECT_FALSE(run("set-knot", {5.0, 0.8}));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_FALSE(run("set-knot", {11.0, 2.0}));
    EXPECT_EQ(state().message.text, "there is no knot 11; the last one is 10");
    EXPECT_TRUE(run("delete-knot"));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.2, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(points(editor_).size(), 6U);
    EXPECT_EQ(state().selection.knot, std::nullopt);
    EXPECT_EQ(state().history.undo_label(), "Delete knot 0.6");
}

TEST_F(KnotCommands, type_a_vector_or_choose_its_kind) {
    open_text(editor_, sample_text);
    const std::vector<double> typed{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    EXPECT_TRUE(run("set-knots", {typed}));
    EXPECT_EQ(knots(editor_), typed);
    EXPECT_FALSE(run("set-knots", {std::vector<double>{0, 1, 2}}));
    EXPECT_EQ(knots(editor_), typed);
    EXPECT_TRUE(run("set-kind", {"clamped-uniform"}));
    EXPECT_EQ(curve(editor_).knots().kind(), core::KnotKind::clamped_uniform);
    EXPECT_EQ(knots(editor_), (std::vector<double>{3, 3, 3, 3, 4, 5, 6, 7, 7, 7, 7}));
    EXPECT_EQ(state().history.undo_label(), "Make knots clamped uniform");
    EXPECT_FALSE(run("set-kind", {"bezier"}));
    EXPECT_FALSE(run("set-kind", {"wild"}));
    EXPECT_EQ(state().message.text,
              "kind is 'wild'; it must be uniform, clamped-uniform, bezier, piecewise-bezier, periodic or custom");
}

TEST_F(KnotCommands, close_and_open_the_curve) {
    open_text(editor_, bezier_text);
    EXPECT_TRUE(run("toggle-closed"));
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(state().history.undo_label(), "Close curve");
    EXPECT_EQ(points(editor_).size(), 4U);
    EXPECT_TRUE(run("toggle-closed"));
    EXPECT_FALSE(curve(editor_).is_periodic());
    EXPECT_EQ(state().history.undo_label(), "Open curve");
}

TEST_F(KnotCommands, change_the_degree_with_and_without_the_shape) {
    open_text(editor_, bezier_text);
    EXPECT_TRUE(run("elevate"));
    EXPECT_EQ(state().history.undo_label(), "Raise degree to 4");
    EXPECT_EQ(state().message.text, "Raised degree to 4: the curve is unchanged");
    // (i/4) P_{i-1} + (1 - i/4) P_i
    const std::vector<core::Point> raised{{0, 0}, {0.75, 1.5}, {2, 2}, {3.25, 1.5}, {4, 0}};
    for (std::size_t i = 0; i < raised.size(); ++i) {
        EXPECT_NEAR(points(editor_)[i].x, raised[i].x, 1e-14) << i;
        EXPECT_NEAR(points(editor_)[i].y, raised[i].y, 1e-14) << i;
    }
    EXPECT_TRUE(run("reduce"));
    EXPECT_EQ(state().history.undo_label(), "Lower degree to 3");
    EXPECT_EQ(curve(editor_).degree(), 3);
    EXPECT_TRUE(run("set-degree", {1.0}));
    EXPECT_EQ(curve(editor_).degree(), 1);
    EXPECT_EQ(points(editor_).size(), 4U);
    EXPECT_FALSE(run("reduce"));
    EXPECT_EQ(state().message.text, "the degree is 1, the lowest allowed");
    EXPECT_FALSE(run("set-degree", {26.0}));
    EXPECT_FALSE(run("set-degree", {2.5}));
}

}  // namespace
}  // namespace batten::editor
