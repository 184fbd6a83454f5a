#include "app/editor/session.h"

#include <gtest/gtest.h>

#include "app/editor/command_reader.h"
#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/degree_commands.h"
#include "app/editor/commands/document_commands.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/fitting_commands.h"
#include "app/editor/commands/help_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/commands/point_commands.h"
#include "app/editor/commands/selection_commands.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

TEST(Session, writes_a_command_as_a_line_of_json) {
    EXPECT_EQ(format_command(InsertKnot{.u = 0.5}), R"(["insert-knot",0.5])");
    EXPECT_EQ(format_command(MovePoints{.points = {1, 2}, .offset = {-0.25, 3.0}}), R"(["move-points",[1,2],-0.25,3])");
    EXPECT_EQ(format_command(RenameCurve{.index = 0, .name = "a \"b\"\n"}), R"(["rename-curve",0,"a \"b\"\n"])");
    EXPECT_EQ(format_command(Undo{}), R"(["undo"])");
    EXPECT_EQ(format_command(SelectKnot{.index = std::nullopt}), R"(["select-knot",null])");
    EXPECT_EQ(format_command(SetCurveLocked{.index = 0, .locked = true}), R"(["set-curve-locked",0,true])");
    EXPECT_EQ(format_command(SetKind{.kind = core::KnotKind::clamped_uniform}), R"(["set-kind","clamped-uniform"])");
    EXPECT_EQ(format_command(SetCurveColor{.index = 0, .color = core::DocumentColor{76, 127, 224}}),
              R"(["set-curve-color",0,"#4c7fe0"])");
}

// The state in which lines are read; all of them are complete.
class SessionLines : public ::testing::Test {
  protected:
    SessionLines() { open_text(editor_, sample_text); }

    Outcome<Command> read(const std::string& line) const { return parse_command(line, editor_.state()); }
    Outcome<Command> typed(const std::string& text) const { return parse_typed_command(text, editor_.state()); }
    // The line of what was typed.
    std::string line_of(const std::string& text) const {
        const Outcome<Command> command = typed(text);
        return command ? format_command(*command) : command.error();
    }

    Editor editor_;
};

TEST_F(SessionLines, are_read_back_as_they_were_written) {
    for (const Command& command : std::vector<Command>{
             SetPoint{.index = 1, .position = {0.1, 1e300}}, SetPoint{.index = 1, .position = {-0.0, 5e-324}},
             SetParameter{.u = 1.0 / 3.0}, RenameCurve{.index = 0, .name = "0.5"},
             RenameCurve{.index = 0, .name = "Bézier"}, SetKnots{.knots = {0.7, -1.0}}, SelectPoints{.points = {}},
             SelectKnot{.index = std::nullopt}, Reduce{.by = 1, .tolerance = std::nullopt},
             Reduce{.by = 1, .tolerance = 1e-3},
             InterpolateTangents{.start = core::Vector(1, -2),
             .end = std::nullopt,
             .points = {{0, 0}, {1, 1}, {2, 0}},
             .degree = 3,
             .parametrization = core::Parametrization::chordal}}) {
        const Outcome<Command> again = read(format_command(command));
        ASSERT_TRUE(again) << format_command(command) << ": " << again.error();
        EXPECT_EQ(arguments_of(*again), arguments_of(command)) << format_command(command);
    }
}

TEST_F(SessionLines, say_what_is_wrong_with_them) {
    for (const char* line : {"", "undo", "{}", "[]", "[1]", "[\"undo\"", "[\"undo\",[\"b\"]]", "[\"undo\",{}]",
                             "[\"insert-knot\",\"x\"]", "[\"no-such-command\"]"}) {
        const Outcome<Command> command = read(line);
        ASSERT_FALSE(command) << line;
        EXPECT_FALSE(command.error().empty()) << line;
    }
}

TEST_F(SessionLines, are_made_of_what_a_person_types) {
    EXPECT_EQ(line_of("insert-knot 0.5"), R"(["insert-knot",0.5])");
    EXPECT_EQ(line_of("  move-points 1,2,3  -1 +2e-3 "), R"(["move-points",[1,2,3],-1,0.002])");
    EXPECT_EQ(line_of("rename-curve 0 \"upper deck 2\""), R"(["rename-curve",0,"upper deck 2"])");
    EXPECT_EQ(line_of("rename-curve 0 \"2\""), R"(["rename-curve",0,"2"])");
    EXPECT_EQ(line_of("rename-curve 0 2"), R"(["rename-curve",0,"2"])");
    EXPECT_EQ(line_of("set-kind bezier"), R"(["set-kind","bezier"])");
    EXPECT_EQ(line_of("select-points 4,"), R"(["select-points",[4]])");
    EXPECT_EQ(line_of("rename-curve 0 1,x"), R"(["rename-curve",0,"1,x"])");
    EXPECT_EQ(line_of("set-curve-locked 0 yes"), R"(["set-curve-locked",0,true])");
}

TEST_F(SessionLines, are_not_made_of_what_cannot_be_a_command) {
    EXPECT_FALSE(typed(""));
    EXPECT_FALSE(typed("   "));
    EXPECT_FALSE(typed("rename-curve 0 \"open"));
    for (const char* number : {"inf", "nan", "1,x", "0x10", "1e999"})
        EXPECT_FALSE(typed("insert-knot " + std::string(number))) << number;
}

TEST(Session, logs_the_values_of_suggestions) {
    Editor editor;
    open_text(editor, bezier_text);
    const std::size_t start = editor.log().size();
    editor.run(SetParameter{.u = 0.25});
    run_typed(editor, "insert-knot");
    editor.run(SelectPoints{.points = {1}});
    run_typed(editor, "nudge-right-far");
    editor.change(SetHover{HoveredPoint{1}});
    editor.run(ToggleKeySheet{});
    editor.run(CloseDialog{});
    editor.run(InsertKnot{.u = 7.0});
    const std::vector<Command> log(editor.log().begin() + static_cast<std::ptrdiff_t>(start), editor.log().end());
    ASSERT_EQ(log.size(), 4U);
    EXPECT_EQ(format_command(log[0]), R"(["set-parameter",0.25])");
    EXPECT_EQ(format_command(log[1]), R"(["insert-knot",0.25])");
    EXPECT_EQ(format_command(log[2]), R"(["select-points",[1]])");
    ASSERT_TRUE(log[3].as<NudgeRightFar>());
    EXPECT_GT(log[3].as<NudgeRightFar>()->distance, 0.0);
}

}  // namespace
}  // namespace batten::editor
