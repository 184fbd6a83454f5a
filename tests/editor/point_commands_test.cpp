#include <gtest/gtest.h>

#include "sample_editor.h"

namespace batten::editor {
namespace {

class PointCommands : public ::testing::Test {
  protected:
    PointCommands() { open_text(editor_, bezier_text); }

    const EditorState& state() const { return editor_.state(); }
    bool run(const std::string& name, std::vector<Argument> arguments = {}) {
        return editor_.run({name, std::move(arguments)});
    }

    Editor editor_;
};

TEST_F(PointCommands, move_set_and_weigh_points) {
    EXPECT_TRUE(run("move-points", {1.0, 0.25, -0.5}));
    EXPECT_EQ(points(editor_)[1], (core::Point{1.25, 1.5}));
    EXPECT_EQ(state().history.undo_label(), "Move P₁");
    EXPECT_TRUE(run("set-point", {3.0, 5.0, -1.0}));
    EXPECT_EQ(points(editor_)[3], (core::Point{5, -1}));
    EXPECT_EQ(state().history.undo_label(), "Move P₃");
    EXPECT_TRUE(run("set-weight", {2.0, 0.01}));
    EXPECT_EQ(curve(editor_).weights()[2], 0.01);
    EXPECT_EQ(state().history.undo_label(), "Set weight of P₂");
    EXPECT_FALSE(run("set-point", {4.0, 0.0, 0.0}));
    EXPECT_EQ(state().message.text, "there is no control point 4; the last one is 3");
    EXPECT_FALSE(run("move-points", {std::vector<double>{0, 9}, 1.0, 1.0}));
    EXPECT_EQ(points(editor_)[0], (core::Point{0, 0}));
}

TEST_F(PointCommands, add_and_select_a_point) {
    EXPECT_TRUE(run("add-point", {2.0, 2.0, 5.0}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {1, 2}, {2, 5}, {3, 2}, {4, 0}}));
    EXPECT_EQ(state().selection.points, std::vector<std::size_t>{2});
    EXPECT_EQ(state().history.undo_label(), "Add P₂");
    EXPECT_TRUE(run("add-point", {5.0, 6.0, 0.0}));
    EXPECT_EQ(points(editor_).back(), (core::Point{6, 0}));
    EXPECT_FALSE(run("add-point", {9.0, 6.0, 0.0}));
    EXPECT_EQ(state().selection.points, std::vector<std::size_t>{5});
}

TEST_F(PointCommands, delete_points) {
    run("add-point", {2.0, 2.0, 5.0});
    run("add-point", {2.0, 1.5, 5.0});
    run("select-points", {std::vector<double>{2, 1}});
    EXPECT_TRUE(run("delete-points"));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {2, 5}, {3, 2}, {4, 0}}));
    EXPECT_EQ(state().selection, Selection{});
    EXPECT_EQ(state().history.undo_label(), "Delete 2 points");
    EXPECT_FALSE(run("delete-points"));
    EXPECT_FALSE(run("delete-points", {std::vector<double>{0, 1, 2}}));
    EXPECT_EQ(points(editor_).size(), 4U);
}

TEST_F(PointCommands, delete_what_is_selected_points_first) {
    EXPECT_FALSE(run("delete"));
    EXPECT_EQ(state().message, (Message{"nothing is selected", true}));
    run("insert-knot", {0.5});
    run("insert-knot", {0.25});
    ASSERT_EQ(state().selection.knot, 4U);
    EXPECT_TRUE(run("delete"));
    EXPECT_EQ(state().history.undo_label(), "Delete knot 0.25");
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 1, 1, 1, 1}));
    run("select-points", {1.0});
    EXPECT_TRUE(run("delete"));
    EXPECT_EQ(state().history.undo_label(), "Delete P₁");
    EXPECT_EQ(points(editor_).size(), 4U);
}

TEST_F(PointCommands, nudge_by_the_grid) {
    EXPECT_FALSE(run("nudge-left"));
    EXPECT_EQ(state().message, (Message{"no control point is selected", true}));
    run("select-points", {std::vector<double>{0, 3}});
    run("zoom-camera", {64.0 / state().view.camera.scale, 0.0, 0.0});
    ASSERT_NEAR(state().view.camera.scale, 64.0, 1e-12);
    // At 64 pixels to the unit the minor lines are half a unit apart.
    EXPECT_TRUE(run("nudge-right-far"));
    EXPECT_EQ(points(editor_)[0], (core::Point{0.5, 0}));
    EXPECT_EQ(points(editor_)[1], (core::Point{1, 2}));
    EXPECT_EQ(points(editor_)[3], (core::Point{4.5, 0}));
    EXPECT_TRUE(run("nudge-up"));
    EXPECT_EQ(points(editor_)[0], (core::Point{0.5, 0.05}));
    EXPECT_TRUE(run("nudge-down-far"));
    EXPECT_NEAR(points(editor_)[0].y, -0.45, 1e-15);
    EXPECT_TRUE(run("nudge-left"));
    EXPECT_NEAR(points(editor_)[0].x, 0.45, 1e-15);
    EXPECT_EQ(state().history.undo_label(), "Nudge 2 points");
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{0, 3}));
    EXPECT_TRUE(run("nudge", {1.0, 2.0}));
    EXPECT_NEAR(points(editor_)[3].x, 5.45, 1e-14);
}

TEST_F(PointCommands, nudge_by_design_pixels) {
    run("select-points", {0.0});
    run("zoom-camera", {128.0 / state().view.camera.scale, 0.0, 0.0});
    run("set-interface-scale", {2.0});
    EXPECT_TRUE(run("nudge-right-far"));
    EXPECT_EQ(points(editor_)[0], (core::Point{0.5, 0}));
}

TEST_F(PointCommands, select_points_in_order_and_once) {
    EXPECT_TRUE(run("select-points", {std::vector<double>{3, 1, 3}}));
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{1, 3}));
    EXPECT_TRUE(state().selection.contains_point(3));
    EXPECT_FALSE(state().selection.contains_point(2));
    EXPECT_FALSE(run("select-points", {std::vector<double>{1, 4}}));
    EXPECT_EQ(state().message.text, "there is no control point 4; the last one is 3");
    EXPECT_FALSE(run("select-points", {-1.0}));
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{1, 3}));
    EXPECT_TRUE(run("select-knot", {2.0}));
    EXPECT_EQ(state().selection, (Selection{{}, 2}));
    EXPECT_FALSE(run("select-knot", {8.0}));
    EXPECT_TRUE(run("select-knot", {-1.0}));
    EXPECT_EQ(state().selection, Selection{});
    EXPECT_TRUE(run("select-all"));
    EXPECT_EQ(state().selection.points, (std::vector<std::size_t>{0, 1, 2, 3}));
    EXPECT_TRUE(run("select-points", {std::vector<double>{}}));
    EXPECT_EQ(state().selection, Selection{});
}

}  // namespace
}  // namespace batten::editor
