#include "app/editor/session.h"

#include <gtest/gtest.h>

#include "sample_editor.h"

namespace batten::editor {
namespace {

TEST(Session, writes_a_command_as_a_line_of_json) {
    EXPECT_EQ(format_command({"insert-knot", {0.5}}), R"(["insert-knot",0.5])");
    EXPECT_EQ(format_command({"move-points", {std::vector<double>{1, 2}, -0.25, 3.0}}),
              R"(["move-points",[1,2],-0.25,3])");
    EXPECT_EQ(format_command({"rename-curve", {0.0, "a \"b\"\n"}}), R"(["rename-curve",0,"a \"b\"\n"])");
    EXPECT_EQ(format_command({"undo", {}}), R"(["undo"])");
}

TEST(Session, reads_back_what_it_wrote) {
    const std::vector<Command> commands{{"a", {0.1, 1e300, -0.0, 5e-324, 1.0 / 3.0}},
                                        {"b", {"text", "0.5", "", "Bézier"}},
                                        {"c", {std::vector<double>{}, std::vector<double>{0.7, -1.0}}}};
    for (const Command& command : commands) {
        const Outcome<Command> read = parse_command(format_command(command));
        ASSERT_TRUE(read) << read.error();
        EXPECT_EQ(*read, command);
    }
}

TEST(Session, says_what_is_wrong_with_a_line) {
    for (const char* line :
         {"", "undo", "{}", "[]", "[1]", "[\"undo\"", "[\"a\",[\"b\"]]", "[\"a\",{}]"}) {
        const Outcome<Command> read = parse_command(line);
        ASSERT_FALSE(read) << line;
        EXPECT_FALSE(read.error().empty()) << line;
    }
}

TEST(Session, reads_what_a_person_types) {
    EXPECT_EQ(*parse_typed_command("insert-knot 0.5"), (Command{"insert-knot", {0.5}}));
    EXPECT_EQ(*parse_typed_command("  move-points 1,2,3  -1 +2e-3 "),
              (Command{"move-points", {std::vector<double>{1, 2, 3}, -1.0, 2e-3}}));
    EXPECT_EQ(*parse_typed_command("rename-curve 0 \"upper deck 2\""),
              (Command{"rename-curve", {0.0, "upper deck 2"}}));
    EXPECT_EQ(*parse_typed_command("rename-curve 0 \"2\""), (Command{"rename-curve", {0.0, "2"}}));
    EXPECT_EQ(*parse_typed_command("set-kind bezier"), (Command{"set-kind", {"bezier"}}));
    EXPECT_EQ(*parse_typed_command("select-points 4,"), (Command{"select-points", {std::vector<double>{4}}}));
    EXPECT_EQ(*parse_typed_command("a inf nan 1,x"), (Command{"a", {"inf", "nan", "1,x"}}));
}

TEST(Session, refuses_what_cannot_be_a_command) {
    EXPECT_FALSE(parse_typed_command(""));
    EXPECT_FALSE(parse_typed_command("   "));
    EXPECT_FALSE(parse_typed_command("rename-curve 0 \"open"));
}

TEST(Session, logs_the_values_of_suggestions) {
    Editor editor;
    open_text(editor, bezier_text);
    const std::size_t start = editor.log().size();
    editor.run({"set-parameter", {0.25}});
    editor.run({"insert-knot", {}});
    editor.run({"select-points", {1.0}});
    editor.run({"nudge-right-far", {}});
    editor.run({"hover", {"point", 1.0}});
    editor.run({"insert-knot", {7.0}});
    const std::vector<Command> log(editor.log().begin() + static_cast<std::ptrdiff_t>(start), editor.log().end());
    const double step = std::get<double>(log[3].arguments[0]);
    EXPECT_GT(step, 0.0);
    EXPECT_EQ(log, (std::vector<Command>{{"set-parameter", {0.25}},
                                         {"insert-knot", {0.25}},
                                         {"select-points", {std::vector<double>{1.0}}},
                                         {"nudge-right-far", {step}}}));
}

}  // namespace
}  // namespace batten::editor
