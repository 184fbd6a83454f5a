#include "app/editor/command_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "app/editor/command_table.h"
#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/degree_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/fitting_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/making_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "core/base/number_text.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

using Numbers = std::vector<double>;

class CommandReader : public ::testing::Test {
  protected:
    CommandReader() { open_text(editor_, sample_text); }

    template <class C>
    C read(const std::vector<Argument>& given) const {
        const Outcome<Command> command = read_command(C::spec(), editor_.state(), given);
        EXPECT_TRUE(command) << command.error();
        return *command->as<C>();
    }
    template <class C>
    Refusal refusal(const std::vector<Argument>& given) const {
        const Outcome<Command> command = read_command(C::spec(), editor_.state(), given);
        return command ? "accepted" : command.error();
    }

    Editor editor_;
};

TEST_F(CommandReader, takes_suggestions_for_what_is_left_out) {
    editor_.run(SetParameter{.u = 0.3});
    EXPECT_EQ(read<InsertKnot>({}).u, 0.3);
    editor_.run(SelectPoints{.points = {4, 2}});
    EXPECT_EQ(read<DeletePoints>({}).points, (std::vector<std::size_t>{2, 4}));
    EXPECT_EQ(read<DeleteCurve>({}).index, 0U);
    const auto move = read<MoveKnot>({4.0, 0.3});
    EXPECT_EQ(move.mode, core::KnotMove::snap);
    EXPECT_EQ(move.snap_distance, std::nullopt);
    EXPECT_EQ(read<Reduce>({}).tolerance, std::nullopt);
}

TEST_F(CommandReader, can_leave_out_one_in_front) {
    editor_.run(SelectKnot{.index = 5});
    const auto set = read<SetKnot>({0.6});
    EXPECT_EQ(set.index, 5U);
    EXPECT_EQ(set.u, 0.6);
    EXPECT_EQ(read<SetKnot>({4.0, 0.3}).index, 4U);
}

TEST_F(CommandReader, takes_a_number_for_a_list_or_a_text) {
    EXPECT_EQ(read<SelectPoints>({2.0}).points, std::vector<std::size_t>{2});
    EXPECT_EQ(read<RenameCurve>({0.0, 2024.0}).name, "2024");
}

TEST_F(CommandReader, takes_a_word_for_what_the_field_is) {
    EXPECT_EQ(read<RenameCurve>({Word{"0"}, Word{"1,2"}}).name, "1,2");
    EXPECT_EQ(read<SelectPoints>({Word{"1,2"}}).points, (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(read<SelectPoints>({Word{"4,"}}).points, std::vector<std::size_t>{4});
    EXPECT_TRUE(read<AddPolyline>({Word{"0,0,1,1,2,0"}, Word{"yes"}}).closed);
    EXPECT_EQ(read<AddPolyline>({Word{"0,0,1,1,2,0"}, Word{"no"}}).points,
              (std::vector<core::Point>{{0, 0}, {1, 1}, {2, 0}}));
}

TEST_F(CommandReader, computes_words_that_are_formulas) {
    EXPECT_EQ(read<InsertKnot>({Word{"1/3"}}).u, 1.0 / 3.0);
    EXPECT_EQ(read<InsertKnot>({Word{"0,5"}}).u, 0.5);
    EXPECT_EQ(read<SetPoint>({Word{"2*3"}, Word{"sqrt(2)/2"}, Word{"-1,5"}}).position,
              core::Point(std::sqrt(2) / 2, -1.5));
    EXPECT_EQ(read<SetPoint>({Word{"6"}, Word{"sin(30 deg)"}, Word{"180deg"}}).position,
              core::Point(0.5, std::acos(-1)));
    EXPECT_EQ(read<AddArc>({Word{"0"}, Word{"0"}, Word{"1"}, Word{"pi/2 rad"}, Word{"45 deg"}}).sweep, 45.0);
    EXPECT_EQ(read<AddArc>({Word{"0"}, Word{"0"}, Word{"1"}, Word{"pi/2 rad"}, Word{"45 deg"}}).start, 90.0);
    EXPECT_EQ(read<SetKnots>({Word{"0 0 0 0 1/4 1/2 3/4 1 1 1 1"}}).knots.at(4), 0.25);
    EXPECT_EQ(read<SetKnots>({Word{"0,0,0,0,1/4,1/2,3/4,1,1,1,1"}}).knots.at(6), 0.75);
}

TEST_F(CommandReader, takes_the_two_numbers_of_a_point_as_one_word) {
    const auto texts = [](const CommandSpec& spec, std::size_t given, const std::string& word) {
        std::vector<std::string> found;
        for (const Argument& argument : arguments_of_word(spec, given, word))
            found.push_back(std::get<Word>(argument).text);
        return found;
    };
    using Texts = std::vector<std::string>;
    EXPECT_EQ(texts(AddCircle::spec(), 0, "0,0"), (Texts{"0", "0"}));
    EXPECT_EQ(texts(AddCircle::spec(), 0, "-1.5,(2,5)"), (Texts{"-1.5", "(2,5)"}));
    EXPECT_EQ(texts(AddCircle::spec(), 0, "1,5;2,5"), (Texts{"1,5", "2,5"}));
    EXPECT_EQ(texts(AddCircle::spec(), 1, "0,5"), Texts{"0,5"});
    EXPECT_EQ(texts(AddCircle::spec(), 2, "0,5"), Texts{"0,5"});
    EXPECT_EQ(texts(AddCircle::spec(), 0, "5"), Texts{"5"});
    EXPECT_EQ(texts(SetPoint::spec(), 1, "3,4"), (Texts{"3", "4"}));
    EXPECT_EQ(texts(AddPolyline::spec(), 0, "0,0,1,1"), Texts{"0,0,1,1"});
}

TEST_F(CommandReader, says_what_is_wrong_with_a_formula) {
    EXPECT_EQ(refusal<InsertKnot>({Word{"1/0"}}), "u is 1/0; a division by zero has no value");
    EXPECT_EQ(refusal<SetPoint>({Word{"0"}, Word{"0"}, Word{"2*(1"}}), "y is 2*(1; a closing parenthesis is missing");
    EXPECT_EQ(refusal<SetKnots>({Word{"0,1/0"}}), "knots is 0,1/0; entry 1: a division by zero has no value");
    EXPECT_EQ(refusal<SetPoint>({Word{"7/2"}, Word{"0"}, Word{"0"}}), "index is 3.5; a whole number from 0 is needed");
    EXPECT_EQ(refusal<InsertKnot>({Word{"middle"}}), "u is the text 'middle'; a number is needed, where in the domain");
}

TEST_F(CommandReader, takes_nothing_or_none_for_what_may_be_absent) {
    EXPECT_EQ(read<SelectKnot>({std::monostate{}}).index, std::nullopt);
    EXPECT_EQ(read<SelectKnot>({Word{"none"}}).index, std::nullopt);
    EXPECT_EQ(read<SelectKnot>({3.0}).index, 3U);
    EXPECT_EQ(read<SetCurveColor>({0.0, Word{"none"}}).color, std::nullopt);
    EXPECT_EQ(read<SetLevel>({Word{"none"}}).level, std::nullopt);
    EXPECT_EQ(refusal<SelectPoints>({std::monostate{}}),
              "points is nothing; a list of numbers is needed, which control points, counted from 0");
}

TEST_F(CommandReader, takes_what_stood_for_absent_in_older_logs) {
    EXPECT_EQ(read<SelectKnot>({-1.0}).index, std::nullopt);
    EXPECT_EQ(read<SetLevel>({-1.0}).level, std::nullopt);
    EXPECT_EQ(read<Reduce>({1.0, 0.0}).tolerance, std::nullopt);
    EXPECT_EQ(read<SetCurveVisible>({0.0, 0.0}).visible, false);
    const auto tangents = read<InterpolateTangents>({Numbers{0, 5}, Numbers{0, 0}, Numbers{0, 0, 1, 1, 2, 0}});
    EXPECT_EQ(tangents.start, core::Vector(0, 5));
    EXPECT_EQ(tangents.end, std::nullopt);
}

TEST_F(CommandReader, says_what_is_missing) {
    EXPECT_EQ(refusal<SetDegree>({}), "p is missing: the new degree, 1 to 25");
    EXPECT_EQ(refusal<DeleteKnot>({}),
              "index is missing: the number of a knot, counted from 0; nothing of that kind is selected");
}

TEST_F(CommandReader, says_what_is_too_much) {
    EXPECT_EQ(refusal<InsertKnot>({0.1, 0.2}), "insert-knot takes one argument; found 2");
    EXPECT_EQ(refusal<SetKnot>({1.0, 0.2, 3.0}), "set-knot takes 2 arguments; found 3");
    editor_.run(SetParameter{.u = 0.4});
    editor_.run(InsertKnot{.u = 0.4});
    EXPECT_EQ(refusal<Undo>({0.1}), "undo takes no arguments; found 1");
}

TEST_F(CommandReader, says_what_is_of_another_kind) {
    EXPECT_EQ(refusal<SetDegree>({"four"}), "p is the text 'four'; a whole number is needed, the new degree, 1 to 25");
    EXPECT_EQ(refusal<SetParameter>({Numbers{1, 2}}),
              "u is a list of 2 numbers; a number is needed, where in the domain");
    EXPECT_EQ(refusal<SetKind>({"round"}),
              "kind is 'round'; it must be uniform, clamped-uniform, bezier, piecewise-bezier, periodic or custom");
    EXPECT_EQ(refusal<SetCurveVisible>({0.0, "maybe"}),
              "visible is the text 'maybe'; yes or no is needed, yes to show it, no to hide it");
    EXPECT_EQ(refusal<SetCurveColor>({0.0, "red"}), "color is 'red'; a color is written #4c7fe0");
    EXPECT_EQ(refusal<Interpolate>({Numbers{0, 0, 1}}), "coordinates has 3 numbers; x and y of each point are needed");
}

TEST_F(CommandReader, says_what_is_not_finite) {
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(refusal<InsertKnot>({infinity}), "u is not finite; a number is needed, where in the domain");
    EXPECT_EQ(refusal<SetKnots>({Numbers{0, std::nan("")}}),
              "knots is not finite; a list of numbers is needed, all knots in order, or one period of a closed curve");
    EXPECT_EQ(refusal<SetPoint>({0.0, 0.0, -infinity}).substr(0, 16), "x is not finite;");
}

TEST_F(CommandReader, says_what_is_out_of_range) {
    EXPECT_EQ(refusal<SetPoint>({7.0, 0.0, 0.0}), "there is no control point 7; the last one is 6");
    EXPECT_EQ(refusal<AddPoint>({8.0, 0.0, 0.0}), "there is no control point 8; the last one is 7");
    EXPECT_EQ(refusal<DeletePoints>({Numbers{1, 9}}), "there is no control point 9; the last one is 6");
    EXPECT_EQ(refusal<DeleteKnot>({11.0}), "there is no knot 11; the last one is 10");
    EXPECT_EQ(refusal<ActivateCurve>({3.0}), "there is no curve 3; the last one is 2");
    for (const double degree : {-1.0, 0.0, 99.0})
        EXPECT_EQ(refusal<SetDegree>({degree}), "p is " + core::shortest_text(degree) + "; it must be from 1 to 25");
    EXPECT_EQ(refusal<SetDegree>({2.5}), "p is 2.5; a whole number from 1 to 25 is needed");
    EXPECT_EQ(refusal<DeleteKnot>({0.5}), "index is 0.5; a whole number from 0 is needed");
    EXPECT_EQ(refusal<DeleteKnot>({-2.0}), "index is -2; a whole number from 0 is needed");
    EXPECT_EQ(refusal<DeleteKnot>({1e18}), "index is 1e+18; a whole number from 0 is needed");
    EXPECT_EQ(refusal<AddPolygon>({0.0, 0.0, 1.0, 2.0}), "sides is 2; it must be from 3 to 1000");
    EXPECT_EQ(refusal<AddPolygon>({0.0, 0.0, 1.0, 1e6}), "sides is 1000000; it must be from 3 to 1000");
}

TEST_F(CommandReader, says_first_why_the_command_cannot_be_run_at_all) {
    Editor empty;
    const Outcome<Command> command = read_command(InsertKnot::spec(), empty.state(), {"four"});
    ASSERT_FALSE(command);
    EXPECT_EQ(command.error(), "there is no curve; draw one or open a file");
}

// Every command with the fields that suggest themselves comes back from its own arguments, in another state too.
TEST_F(CommandReader, reads_back_the_arguments_of_a_command) {
    editor_.run(SelectPoints{.points = {4, 2}});
    editor_.run(SelectKnot{.index = 5});
    int read_back = 0;
    for (const CommandSpec& spec : command_table()) {
        const Outcome<Command> command = read_command(spec, editor_.state());
        if (!command) continue;
        Editor other;
        open_text(other, sample_text);
        if (spec.refusal != nullptr && spec.refusal(other.state())) continue;
        const std::vector<Argument> arguments = arguments_of(*command);
        const Outcome<Command> again = read_command(spec, other.state(), arguments);
        ASSERT_TRUE(again) << spec.name << ": " << again.error();
        EXPECT_EQ(arguments_of(*again), arguments) << spec.name;
        ++read_back;
    }
    EXPECT_GT(read_back, 100);
}

}  // namespace
}  // namespace batten::editor
