// Texts that are wrong, damaged or meant to do harm, for every reader of the editor.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "app/editor/fields/expression.h"
#include "app/editor/lesson/lesson_file.h"
#include "app/editor/session.h"
#include "app/editor/state/settings.h"
#include "app/editor/typed_command.h"
#include "tests/editor/sample_editor.h"

namespace batten::editor {
namespace {

std::string repeated(std::size_t count, const std::string& text) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

std::string many_members() {
    std::string text = "{";
    for (int i = 0; i < 200'000; ++i) text += "\"m" + std::to_string(i) + "\":1,";
    return text + "\"m\":1}";
}

std::string nested(std::size_t depth) {
    return repeated(depth, "[") + repeated(depth, "]");
}

std::map<std::string, std::string> bad_texts() {
    constexpr std::size_t deep = 100'000;
    return {{"nothing", ""},
            {"a bracket", "["},
            {"lists in lists", repeated(deep, "[")},
            {"lists in lists, closed", nested(deep)},
            {"lists in a line", "[\"insert-knot\"," + nested(deep) + "]"},
            {"lists in settings", "{\"theme\":" + nested(deep) + "}"},
            {"lists in a lesson",
             R"({"format":"batten-lesson","version":1,"title":"T","text":"t","steps":)" + nested(deep) + "}"},
            {"objects in a lesson", R"({"format":"batten-lesson","version":1,"document":)" + repeated(deep, "{\"a\":") +
                                        "1" + repeated(deep, "}") + "}"},
            {"members without end", many_members()},
            {"a doubled member", R"({"format":"batten-lesson","format":"batten-lesson","version":1})"},
            {"digits without end", "[\"insert-knot\"," + std::string(1'000'000, '9') + "]"},
            {"a number beyond doubles", "[\"insert-knot\",1e309]"},
            {"not a number", "[\"insert-knot\",NaN]"},
            {"half a surrogate pair", R"(["rename-curve",0,"\ud800"])"},
            {"not UTF-8", "[\"rename-curve\",0,\"\xff\"]"},
            {"UTF-16", std::string("\xff\xfe[\0]\0", 6)},
            {"zero bytes", std::string(1000, '\0')},
            {"parentheses without end", repeated(deep, "(") + "1" + repeated(deep, ")")},
            {"signs without end", repeated(deep, "-") + "1"},
            {"powers without end", repeated(deep, "2^") + "2"},
            {"functions without end", repeated(deep, "sqrt(")}};
}

TEST(BadTexts, are_no_lessons) {
    for (const auto& [name, text] : bad_texts()) {
        const Outcome<Lesson> lesson = parse_lesson(text, "lesson");
        ASSERT_FALSE(lesson) << name;
        EXPECT_FALSE(lesson.error().empty()) << name;
        EXPECT_LT(lesson.error().size(), 300U) << name;
    }
}

TEST(BadTexts, leave_all_settings_as_they_begin) {
    for (const auto& [name, text] : bad_texts()) EXPECT_EQ(parse_settings(text), Settings{}) << name;
}

TEST(BadTexts, are_no_lines_of_sessions) {
    const Editor editor(core::parse_document(sample_text).value());
    for (const auto& [name, text] : bad_texts()) {
        const Outcome<Command> command = parse_command(text, editor.state());
        ASSERT_FALSE(command) << name;
        EXPECT_FALSE(command.error().empty()) << name;
        EXPECT_LT(command.error().size(), 300U) << name;
    }
}

TEST(BadTexts, are_nothing_that_can_be_typed) {
    const Editor editor(core::parse_document(sample_text).value());
    for (const auto& [name, text] : bad_texts()) {
        const Outcome<Command> command = parse_typed_command("insert-knot " + text, editor.state());
        EXPECT_TRUE(command || !command.error().empty()) << name;
        const auto number = parse_expression(text);
        EXPECT_TRUE(!number || std::isfinite(*number)) << name;
    }
}

}  // namespace
}  // namespace batten::editor
