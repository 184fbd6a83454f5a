#include "app/editor/commands/knot_commands.h"

#include <gtest/gtest.h>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/degree_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "core/curve/knot_analysis.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

class KnotCommands : public ::testing::Test {
  protected:
    const EditorState& state() const { return editor_.state(); }
    bool run(const Command& command) { return editor_.run(command); }
    bool type(const std::string& text) { return run_typed(editor_, text); }

    Editor editor_;
};

TEST_F(KnotCommands, insert_and_select_a_knot_and_keep_the_shape) {
    open_text(editor_, bezier_text);
    EXPECT_TRUE(run(InsertKnot{.u = 0.5}));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 1, 1, 1, 1}));
    EXPECT_EQ(points(editor_), (std::vector<core::Point>{{0, 0}, {0.5, 1}, {2, 2}, {3.5, 1}, {4, 0}}));
    EXPECT_EQ(state().selection.knot, 4U);
    EXPECT_EQ(state().history.undo_label(), "Insert knot 0.5");
    EXPECT_TRUE(type("raise-knot"));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.5, 0.5, 1, 1, 1, 1}));
    EXPECT_EQ(state().selection.knot, 5U);
    EXPECT_TRUE(type("raise-knot"));
    // de Casteljau at 1/2: the curve itself is a control point now.
    EXPECT_EQ(points(editor_)[3], (core::Point{2, 1.5}));
    EXPECT_FALSE(type("raise-knot"));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_EQ(knots(editor_).size(), 11U);
}

TEST_F(KnotCommands, insert_at_the_parameter_or_at_all_midpoints) {
    open_text(editor_, sample_text);
    run(SetParameter{.u = 0.3});
    type("insert-knot");
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.2, 0.3, 0.5, 0.75, 1, 1, 1, 1}));
    run(Undo{});
    EXPECT_TRUE(run(InsertMidpoints{}));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.1, 0.2, 0.35, 0.5, 0.625, 0.75, 0.875, 1, 1, 1, 1}));
    EXPECT_EQ(state().history.undo_label(), "Insert knots at all midpoints");
    EXPECT_FALSE(run(InsertKnot{.u = 1.5}));
    EXPECT_EQ(state().message.text, "the parameter 1.5 is outside the domain; it must be from 0 to 1");
}

TEST_F(KnotCommands, messages_name_what_matters) {
    open_text(editor_, sample_text);  // 0, 0, 0, 0, 0.2, 0.5, 0.75, 1, 1, 1, 1
    const auto begins = [this](const std::string& text) { return state().message.text.rfind(text, 0) == 0; };
    run(InsertKnot{.u = 0.5});
    EXPECT_EQ(state().message.text, "Inserted knot 0.5: multiplicity 2, C¹ there; the curve is unchanged");
    run(RaiseKnot{.index = 4});
    EXPECT_EQ(state().message.text, "Raised knot 0.2: multiplicity 2, C¹ there; the curve is unchanged");
    run(SetKnot{.index = 8, .u = 0.5});
    EXPECT_TRUE(begins("Set knot 0.75 to 0.5: multiplicity 3, C⁰ there; the curve moved by at most "));
    run(DeleteKnot{.index = 8});
    EXPECT_TRUE(begins("Deleted knot 0.5 and P₅; ")) << state().message.text;
    run(MoveKnot{.index = 6, .u = 0.1, .mode = core::KnotMove::push});
    EXPECT_TRUE(begins("Moved knot 0.5 to 0.")) << state().message.text;
    run(InsertMidpoints{});
    EXPECT_TRUE(begins("Inserted 4 knots, one in the middle of every span; the curve is unchanged"))
        << state().message.text;
}

TEST_F(KnotCommands, typed_uniform_knots_are_called_so_and_stay_so_in_another_degree) {
    open_text(editor_, sample_text);
    const auto begins = [this](const std::string& text) { return state().message.text.rfind(text, 0) == 0; };
    run(SetKnots{.knots = {0, 0, 0, 0, 1, 2, 3, 4, 4, 4, 4}});
    EXPECT_TRUE(begins("Typed knot vector: clamped uniform; ")) << state().message.text;
    run(SetDegree{.degree = 2});
    EXPECT_TRUE(begins("Set degree from 3 to 2 with the same control points over clamped uniform knots; "))
        << state().message.text;
}

TEST_F(KnotCommands, knots_that_are_uniform_are_never_called_custom) {
    open_text(editor_, sample_text);
    run(SetKnots{.knots = {0, 0, 0, 0, 2, 4, 6, 8, 8, 8, 8}});
    run(SetKind{.kind = core::KnotKind::clamped_uniform});
    run(SetKind{.kind = core::KnotKind::custom});
    EXPECT_EQ(state().message.text, "Kept the values of the knots, which stay clamped uniform; the curve is unchanged");
}

TEST_F(KnotCommands, a_knot_that_goes_less_far_than_asked_says_so) {
    open_text(editor_, sample_text);
    run(MoveKnot{.index = 4, .u = 0.6, .mode = core::KnotMove::stop});
    EXPECT_NE(state().message.text.find(
                  " instead of 0.6, up to its neighbor, which it joins where 'snap' is chosen: multiplicity 1"),
              std::string::npos)
        << state().message.text;
}

TEST_F(KnotCommands, a_knot_that_joins_a_neighbor_before_what_was_asked_says_so) {
    open_text(editor_, sample_text);
    const auto begins = [this](const std::string& text) { return state().message.text.rfind(text, 0) == 0; };
    run(MoveKnot{.index = 4, .u = 9.0, .mode = core::KnotMove::snap});
    EXPECT_TRUE(begins("Moved knot 0.2 to 0.5 instead of 9, onto its neighbor: multiplicity 2, C¹ there; "))
        << state().message.text;
    run(Undo{});
    run(MoveKnot{.index = 4, .u = 0.49, .mode = core::KnotMove::snap, .snap_distance = 0.02});
    EXPECT_TRUE(begins("Moved knot 0.2 to 0.5: multiplicity 2, C¹ there; ")) << state().message.text;
}

TEST_F(KnotCommands, a_typed_knot_out_of_order_is_told_its_neighbors) {
    open_text(editor_, sample_text);
    EXPECT_FALSE(run(SetKnot{.index = 4, .u = 0.6}));
    EXPECT_EQ(state().message.text,
              "knot number 4 cannot be 0.6, above knot number 5, which is 0.5; it must be above 0 and at most 0.5");
    EXPECT_FALSE(run(SetKnot{.index = 5, .u = 0.1}));
    EXPECT_EQ(state().message.text,
              "knot number 5 cannot be 0.1, below knot number 4, which is 0.2; it must be from 0.2 to 0.75");
    EXPECT_FALSE(run(SetKnot{.index = 0, .u = 0.3}));
    EXPECT_EQ(state().message.text,
              "knot number 0 cannot be 0.3, above knot number 4, which is 0.2; it must be at most 0.2");
    EXPECT_FALSE(run(SetKnot{.index = 10, .u = 0.3}));
    EXPECT_EQ(state().message.text,
              "knot number 10 cannot be 0.3, below knot number 6, which is 0.75; it must be at least 0.75");
}

TEST_F(KnotCommands, what_a_typed_knot_may_be_is_true_also_beside_full_stacks) {
    open_text(editor_, sample_text);  // 0, 0, 0, 0, 0.2, 0.5, 0.75, 1, 1, 1, 1
    EXPECT_FALSE(run(SetKnot{.index = 4, .u = -1.0}));
    EXPECT_EQ(state().message.text,
              "knot number 4 cannot be -1, below knot number 3, which is 0; it must be above 0 and at most 0.5");
    EXPECT_FALSE(run(SetKnot{.index = 4, .u = 0.0}));
    EXPECT_EQ(state().message.text,
              "knot number 4 cannot be 0, which occurs 4 times already; it must be above 0 and at most 0.5");
    EXPECT_FALSE(run(SetKnot{.index = 6, .u = 2.0}));
    EXPECT_EQ(state().message.text,
              "knot number 6 cannot be 2, above knot number 7, which is 1; it must be at least 0.5 and below 1");
}

TEST_F(KnotCommands, move_a_knot_and_keep_it_selected) {
    open_text(editor_, sample_text);
    run(SelectKnot{.index = 4});
    EXPECT_TRUE(run(MoveKnot{.index = 4, .u = 0.4, .mode = core::KnotMove::stop}));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.4, 0.5, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(state().history.undo_label(), "Move knot 0.2 to 0.4");
    EXPECT_EQ(state().message.text.rfind(
                  "Moved knot 0.2 to 0.4: multiplicity 1, C² there; the curve moved by at most 1.6", 0),
              0U)
        << state().message.text;
    EXPECT_TRUE(run(MoveKnot{.index = 4, .u = 0.6, .mode = core::KnotMove::stop}));
    EXPECT_EQ(knots(editor_)[4], 0.495);
    EXPECT_EQ(state().message.text.rfind("Moved knot 0.4 to 0.495 instead of 0.6, up to its neighbor", 0), 0U)
        << state().message.text;
    EXPECT_FALSE(run(MoveKnot{.index = 4, .u = 0.6, .mode = core::KnotMove::stop, .snap_distance = 0.1}));
    EXPECT_EQ(state().message.text, "a knot in the mode 'stop' takes no snap distance; 'snap' does");
    EXPECT_TRUE(run(MoveKnot{.index = 4, .u = 0.6, .mode = core::KnotMove::snap}));
    EXPECT_EQ(knots(editor_)[4], 0.5);
    EXPECT_EQ(knots(editor_)[5], 0.5);
    // Pulled out of the stack to the right: it is the other one that goes.
    EXPECT_TRUE(run(MoveKnot{.index = 4, .u = 0.6, .mode = core::KnotMove::stop}));
    EXPECT_EQ(knots(editor_)[4], 0.5);
    EXPECT_EQ(knots(editor_)[5], 0.6);
    EXPECT_EQ(state().selection.knot, 5U);
}

TEST_F(KnotCommands, push_and_snap_as_asked_for) {
    open_text(editor_, sample_text);
    EXPECT_TRUE(run(MoveKnot{.index = 4, .u = 0.6, .mode = core::KnotMove::push}));
    EXPECT_EQ(knots(editor_)[4], 0.6);
    EXPECT_GE(knots(editor_)[5], 0.6);
    EXPECT_LT(knots(editor_)[5], 0.62);
    EXPECT_EQ(knots(editor_)[6], 0.75);
    run(Undo{});
    EXPECT_TRUE(run(MoveKnot{.index = 4, .u = 0.48, .mode = core::KnotMove::snap, .snap_distance = 0.05}));
    EXPECT_EQ(knots(editor_)[4], 0.5);
    EXPECT_FALSE(type("move-knot 4 0.48 jump"));
    EXPECT_EQ(state().message.text, "mode is 'jump'; it must be stop, push or snap");
    EXPECT_FALSE(run(MoveKnot{.index = 4, .u = 0.48, .mode = core::KnotMove::snap, .snap_distance = -1.0}));
    EXPECT_FALSE(type("move-knot 11 0.48"));
    EXPECT_EQ(state().message.text, "there is no knot 11; the last one is 10");
    EXPECT_FALSE(type("move-knot 1.5 0.48"));
    EXPECT_EQ(state().message.text, "index is 1.5; a whole number from 0 is needed");
}

TEST_F(KnotCommands, set_and_delete_a_knot) {
    open_text(editor_, sample_text);
    EXPECT_TRUE(run(SetKnot{.index = 5, .u = 0.6}));
    EXPECT_EQ(knots(editor_)[5], 0.6);
    EXPECT_EQ(state().history.undo_label(), "Set knot 0.5 to 0.6");
    EXPECT_EQ(state().selection.knot, 5U);
    EXPECT_FALSE(run(SetKnot{.index = 5, .u = 0.8}));
    EXPECT_TRUE(state().message.is_error);
    EXPECT_FALSE(run(SetKnot{.index = 11, .u = 2.0}));
    EXPECT_EQ(state().message.text, "there is no knot 11; the last one is 10");
    EXPECT_TRUE(type("delete-knot"));
    EXPECT_EQ(knots(editor_), (std::vector<double>{0, 0, 0, 0, 0.2, 0.75, 1, 1, 1, 1}));
    EXPECT_EQ(points(editor_).size(), 6U);
    EXPECT_EQ(state().selection.knot, std::nullopt);
    EXPECT_EQ(state().history.undo_label(), "Delete knot 0.6");
}

TEST_F(KnotCommands, type_a_vector_or_choose_its_kind) {
    open_text(editor_, sample_text);
    const std::vector<double> typed{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    EXPECT_TRUE(run(SetKnots{.knots = typed}));
    EXPECT_EQ(knots(editor_), typed);
    EXPECT_FALSE(run(SetKnots{.knots = {0, 1, 2}}));
    EXPECT_EQ(knots(editor_), typed);
    EXPECT_TRUE(run(SetKind{.kind = core::KnotKind::clamped_uniform}));
    EXPECT_EQ(curve(editor_).knots().kind(), core::KnotKind::clamped_uniform);
    EXPECT_EQ(knots(editor_), (std::vector<double>{3, 3, 3, 3, 4, 5, 6, 7, 7, 7, 7}));
    EXPECT_EQ(state().history.undo_label(), "Make knots clamped uniform");
    EXPECT_FALSE(run(SetKind{.kind = core::KnotKind::bezier}));
    EXPECT_FALSE(type("set-kind wild"));
    EXPECT_EQ(state().message.text,
              "kind is 'wild'; it must be uniform, clamped-uniform, bezier, piecewise-bezier, periodic or custom");
}

TEST_F(KnotCommands, close_and_open_the_curve) {
    open_text(editor_, bezier_text);
    EXPECT_TRUE(run(ToggleClosed{}));
    EXPECT_TRUE(curve(editor_).is_periodic());
    EXPECT_EQ(state().history.undo_label(), "Close curve");
    EXPECT_EQ(points(editor_).size(), 4U);
    EXPECT_TRUE(run(ToggleClosed{}));
    EXPECT_FALSE(curve(editor_).is_periodic());
    EXPECT_EQ(state().history.undo_label(), "Open curve");
}

TEST_F(KnotCommands, change_the_degree_with_and_without_the_shape) {
    open_text(editor_, bezier_text);
    EXPECT_TRUE(type("elevate"));
    EXPECT_EQ(state().history.undo_label(), "Raise degree to 4");
    EXPECT_EQ(state().message.text, "Raised degree from 3 to 4; the curve is unchanged");
    // (i/4) P_{i-1} + (1 - i/4) P_i
    const std::vector<core::Point> raised{{0, 0}, {0.75, 1.5}, {2, 2}, {3.25, 1.5}, {4, 0}};
    for (std::size_t i = 0; i < raised.size(); ++i) {
        EXPECT_NEAR(points(editor_)[i].x, raised[i].x, 1e-14) << i;
        EXPECT_NEAR(points(editor_)[i].y, raised[i].y, 1e-14) << i;
    }
    EXPECT_TRUE(type("reduce"));
    EXPECT_EQ(state().history.undo_label(), "Lower degree to 3");
    EXPECT_EQ(curve(editor_).degree(), 3);
    EXPECT_TRUE(run(SetDegree{.degree = 1}));
    EXPECT_EQ(curve(editor_).degree(), 1);
    EXPECT_EQ(points(editor_).size(), 4U);
    EXPECT_FALSE(type("reduce"));
    EXPECT_EQ(state().message.text, "the degree is 1, the lowest allowed");
    EXPECT_FALSE(run(SetDegree{.degree = 26}));
    EXPECT_FALSE(type("set-degree 2.5"));
}

}  // namespace
}  // namespace batten::editor
