#include "app/editor/scene/figure_title.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/editor/scene/text_size.h"
#include "render/prose.h"

namespace batten::editor {
namespace {

constexpr double any_height = 1e9;

double widest_line(const FigureTitle& title) {
    double width = 0.0;
    for (const std::string& line : title.lines)
        width = std::max(width, text_size(render::prose_label(line), title.size, render::LabelFont::bold).x);
    return width;
}

std::string joined(const FigureTitle& title, const char* between) {
    std::string text;
    for (const std::string& line : title.lines) text += (text.empty() ? "" : between) + line;
    return text;
}

TEST(FigureTitle, is_one_line_of_large_letters_where_there_is_room) {
    const FigureTitle title = *fitted_title("A wave", 800.0, any_height);
    EXPECT_EQ(title.lines, std::vector<std::string>{"A wave"});
    EXPECT_EQ(title.size, 18.0);
    EXPECT_EQ(title.height(), 44.0);
}

TEST(FigureTitle, is_broken_at_blanks_into_lines_that_can_be_read) {
    const std::string words =
        "A knot comes in and cuts the corners of the polygon while the curve stays what it was before, so that "
        "nothing but the number of its control points and of its pieces has changed after that step of the lecture";
    ASSERT_GE(words.size(), 200U);
    const FigureTitle title = *fitted_title(words, 400.0, 150.0);
    EXPECT_GE(title.size, 9.0);
    EXPECT_LE(title.lines.size(), 6U);
    EXPECT_LE(widest_line(title), 368.0);
    EXPECT_LE(static_cast<double>(title.lines.size()) * title.pitch(), 150.0);
    EXPECT_EQ(joined(title, " "), words);
}

TEST(FigureTitle, has_lines_of_about_the_same_length) {
    const FigureTitle title = *fitted_title("The de Boor algorithm in all its steps for a cubic", 300.0, any_height);
    ASSERT_EQ(title.lines.size(), 2U);
    EXPECT_EQ(title.lines.front(), "The de Boor algorithm in");
}

TEST(FigureTitle, keeps_line_breaks) {
    EXPECT_EQ(fitted_title("two\nlines", 800.0, any_height)->lines, (std::vector<std::string>{"two", "lines"}));
    EXPECT_EQ(fitted_title("\r\n two\r\n\n\tlines\n", 800.0, any_height)->lines,
              (std::vector<std::string>{"two", "lines"}));
    EXPECT_TRUE(fitted_title(" \n", 800.0, any_height)->lines.empty());
    EXPECT_EQ(fitted_title(" ", 800.0, any_height)->height(), 0.0);
}

TEST(FigureTitle, breaks_no_formula) {
    const FigureTitle title = *fitted_title("The sum $N_0 + N_1 + N_2$ of three basis functions", 240.0, any_height);
    EXPECT_GT(title.lines.size(), 1U);
    for (const std::string& line : title.lines) EXPECT_EQ(std::ranges::count(line, '$') % 2, 0) << line;
    EXPECT_FALSE(fitted_title("$" + std::string(300, 'x') + "$", 300.0, any_height));
}

TEST(FigureTitle, breaks_words_only_where_they_are_longer_than_a_line) {
    const FigureTitle title = *fitted_title(std::string(100, 'x'), 300.0, any_height);
    EXPECT_EQ(joined(title, ""), std::string(100, 'x'));
    EXPECT_LE(widest_line(title), 268.0);
    std::string accents;
    for (int i = 0; i < 60; ++i) accents += "é";
    const FigureTitle accented = *fitted_title(accents, 300.0, any_height);
    for (const std::string& line : accented.lines) EXPECT_EQ(line.size() % 2, 0U) << "whole signs";
}

TEST(FigureTitle, is_none_without_room) {
    EXPECT_FALSE(fitted_title("a", 1.0, 1.0));
    EXPECT_FALSE(fitted_title("a", 800.0, 5.0));
    EXPECT_FALSE(fitted_title(std::string(100'000, 'x'), 800.0, any_height));
    std::string words;
    for (int i = 0; i < 100'000; ++i) words += "word ";
    EXPECT_FALSE(fitted_title(words, 800.0, any_height));
}

}  // namespace
}  // namespace batten::editor
