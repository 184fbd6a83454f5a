#include "render/tikz_painter.h"

#include <gtest/gtest.h>

#include "render/figure_file.h"
#include "render/tex_text.h"
#include "tests/render/plain_colors.h"

namespace batten::render {
namespace {

std::string tikz_of(const DrawCommand& command) {
    DrawList list;
    list.commands.push_back(command);
    return tikz_text(page_of(list, {100.0, 80.0}, std::nullopt));
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(TexText, sets_letters_and_numbers_as_formulas) {
    EXPECT_EQ(tex_text("P_{3}"), "$P_{3}$");
    EXPECT_EQ(tex_text("P_{3}^{1}"), "$P_{3}^{1}$");
    EXPECT_EQ(tex_text("N_{i,3}(u)"), "$N_{i,3}(u)$");
    EXPECT_EQ(tex_text("C(0.4)"), "$C(0.4)$");
    EXPECT_EQ(tex_text("f(u_{3}, u, u)"), "$f(u_{3},u,u)$");
    EXPECT_EQ(tex_text("f(0,5)"), "$f(0{,}5)$");
    EXPECT_EQ(tex_text("ξ−1"), "$\\xi -1$");
    EXPECT_EQ(tex_text("×2 C^{1}"), "$\\times 2$ $C^{1}$");
}

TEST(TexText, sets_small_fractions_as_such) {
    EXPECT_EQ(tex_text("1/6"), "$\\frac{1}{6}$");
    EXPECT_EQ(tex_text("−4/3"), "$-\\frac{4}{3}$");
    EXPECT_EQ(tex_text("7/15 P_{2}"), "$\\frac{7}{15}$ $P_{2}$");
    EXPECT_EQ(tex_text("0.1/6"), "0.1$/6$") << "no fraction of whole numbers";
    EXPECT_EQ(tex_text("1/6.5"), "1$/6.5$");
    EXPECT_EQ(tex_text("1/2/3"), "1$/2/3$");
}

TEST(TexText, leaves_words_as_text) {
    EXPECT_EQ(tex_text("de Boor, level 2"), "de Boor, level 2");
    EXPECT_EQ(tex_text("Bézier"), "Bézier");
    EXPECT_EQ(tex_text("w 2.5"), "$w$ 2.5");
}

TEST(TexText, escapes_what_means_something_to_TeX) {
    EXPECT_EQ(tex_text("50% & $3 #1 {x} \\end ~"),
              "50\\% \\& \\symbol{36}3 \\#1 $\\{x\\}$ \\textbackslash{}end \\textasciitilde{}");
    EXPECT_EQ(tex_text("a_b^c"), "$a$\\_$b$\\textasciicircum{}$c$");
    EXPECT_EQ(tex_text("\"a\" < b"), "''$a$'' $<$ $b$");
    EXPECT_EQ(tex_text("Кривая 2"), "\\battenletters{Кривая} 2");
    EXPECT_EQ(tex_text("Ø_{max %}"), "Ø$_{\\mathrm{max}\\mathrm{\\%}}$");
}

TEST(TexText, knows_signs_that_a_stock_LaTeX_lacks) {
    EXPECT_EQ(tex_text("⅓ ⅔"), "$\\frac{1}{3}$ $\\frac{2}{3}$");
    EXPECT_EQ(tex_text("x₁₂"), "$x_{12}$");
    EXPECT_EQ(tex_text("C¹ 10⁻¹²"), "$C^{1}$ 10$^{-12}$");
    EXPECT_EQ(tex_text("P_{3}²"), "$P_{3}{}^{2}$") << "no double script";
    EXPECT_EQ(tex_text("x²′"), "$x^{2}{}'$");
    EXPECT_EQ(tex_text("ℝ ∫ η"), "$\\mathbf{R}$ $\\int $ $\\eta $");
    EXPECT_TRUE(letters_without_tex("⅔ ₁ ℝ ∫ ½ é « § ⇒ ψ C¹").empty());
    EXPECT_EQ(letters_without_tex("Я и 漢 a"), (std::vector<std::string>{"Я", "и", "漢"}));
}

TEST(TexProse, is_text_but_for_what_stands_between_dollar_signs) {
    EXPECT_EQ(tex_prose("A point on a curve, u = 1/2 (b)"), "A point on a curve, u = 1/2 (b)");
    EXPECT_EQ(tex_prose("knots-t3"), "knots-t3");
    EXPECT_EQ(tex_prose("<b> & 50%"), "$<$b$>$ \\& 50\\%");
    EXPECT_EQ(tex_prose("The point $P_3$ at $u=\\frac13$"), "The point $P_3$ at $u=\\frac13$");
    EXPECT_EQ(tex_prose("from $5 to $6"), "from \\symbol{36}5 to \\symbol{36}6") << "prices";
    EXPECT_EQ(tex_prose("$x$5"), "\\symbol{36}x\\symbol{36}5");
    EXPECT_EQ(tex_prose("${$ and $a}$ and $50%$"),
              "\\symbol{36}$\\{$\\symbol{36} and \\symbol{36}a$\\}$\\symbol{36} and \\symbol{36}50\\%\\symbol{36}")
        << "no formulas";
}

TEST(TikzPainter, sets_what_a_user_wrote_as_prose) {
    DrawList list;
    list.add(Label{.position = {50, 40}, .text = "A curve $C(u)$", .color = red});
    Figure figure = page_of(list, {100.0, 80.0}, std::nullopt);
    figure.parts.front().is_prose = true;
    EXPECT_TRUE(has(tikz_text(figure), "{A curve $C(u)$};"));
}

TEST(TikzPainter, draws_in_pixels_from_above) {
    const std::string text = tikz_of(
        Polyline{.points = {{10, 20}, {30, 25.25}}, .color = red, .width_px = 2.0F, .dash_px = 4.0F, .gap_px = 2.0F});
    EXPECT_TRUE(has(text, "\\begin{tikzpicture}[x=0.75bp,y=-0.75bp]\n\\definecolor{batten0}{RGB}{255,0,0}\n")) << text;
    EXPECT_TRUE(has(text,
                    "\\draw[draw=batten0,line width=1.5bp,line join=round,dash pattern=on 3bp off 1.5bp] "
                    "(10,20)--(30,25.25);"))
        << text;
    EXPECT_TRUE(has(text, "\\clip (0,0) rectangle (100,80);")) << text;
}

TEST(TikzPainter, fills_and_marks) {
    EXPECT_TRUE(has(tikz_of(Fill{{{10, 10}, {20, 10}, {20, 30}}, {0, 0, 255, 51}}),
                    "\\fill[fill=batten0,fill opacity=0.2] (10,10)--(20,10)--(20,30)--cycle;"));
    EXPECT_TRUE(has(tikz_of(Marker{.center = {50, 40}, .radius_px = 6, .fill = red, .outline = {0, 0, 0, 0}}),
                    "\\path[fill=batten0,] (50,40) circle[radius=6];"));
    EXPECT_TRUE(has(tikz_of(Marker{.center = {50, 40},
                                   .shape = MarkerShape::diamond,
                                   .radius_px = 6,
                                   .fill = {0, 0, 0, 0},
                                   .outline = red,
                                   .outline_px = 2}),
                    "\\path[draw=batten0,line width=1.5bp] (44,40)--(50,34)--(56,40)--(50,46)--cycle;"));
}

TEST(TikzPainter, sets_labels_on_their_line) {
    const std::string text = tikz_of(Label{.position = {50, 40},
                                           .text = "P_{3}",
                                           .color = red,
                                           .size_px = 20.0F,
                                           .anchor = Anchor::right,
                                           .font = LabelFont::bold});
    // 20 pixels are 15 of 1/72 of an inch; the letters stand 0.36 of 20 below.
    EXPECT_TRUE(has(text,
                    "\\node[anchor=base east,inner sep=0pt,text=batten0,scale=1.5] at (50,47.2) "
                    "{{\\bfseries\\boldmath $P_{3}$}};"))
        << text;
}

TEST(TikzPainter, goes_on_with_labels_where_the_fonts_of_the_paper_end) {
    const auto text_with = [](Anchor anchor) {
        DrawList list;
        list.add(Label{.position = {50, 40}, .text = "P_{3}", .color = red, .anchor = anchor});
        list.add(Label{.position = {80, 40}, .text = "w 2", .color = red, .anchor = anchor, .gap_px = 4.0F});
        list.add(Label{.position = {10, 10}, .text = "Q", .color = red});
        return tikz_text(page_of(list, {100.0, 80.0}, std::nullopt));
    };
    const std::string right = text_with(Anchor::left);
    EXPECT_TRUE(has(right, " (battenword) at (50,44.68) {$P_{3}$};")) << right;
    EXPECT_TRUE(has(right, " at ([xshift=3bp]battenword.base east) {$w$ 2};")) << right;
    EXPECT_TRUE(has(right, "] at (10,14.68) {$Q$};")) << right;
    EXPECT_TRUE(has(text_with(Anchor::right), " at ([xshift=-3bp]battenword.base west) {$w$ 2};"));
    // What it went on has been taken away.
    EXPECT_FALSE(has(tikz_of(Label{.position = {}, .text = "w", .color = red, .gap_px = 4.0F}), "battenword"));
}

TEST(TikzPainter, defines_what_a_stock_LaTeX_lacks) {
    DrawList list;
    list.add(Label{.position = {}, .text = "$\\mathbb{R}$, $a \\text{ if } b \\implies c$", .color = red});
    Figure figure = page_of(list, {100.0, 80.0}, std::nullopt);
    figure.parts.front().is_prose = true;
    const std::string text = tikz_text(figure);
    EXPECT_TRUE(has(text, "\\providecommand\\mathbb[1]{\\mathbf{#1}}\n")) << text;
    EXPECT_TRUE(has(text, "\\providecommand\\text[1]{\\mbox{#1}}\n"));
    EXPECT_TRUE(has(text, "\\providecommand\\implies{\\Longrightarrow}\n"));
    EXPECT_FALSE(has(text, "\\providecommand\\bm"));
    list = {};
    list.add(Label{.position = {}, .text = "$\\textbf{R}$ \\text", .color = red});
    figure = page_of(list, {100.0, 80.0}, std::nullopt);
    figure.parts.front().is_prose = true;
    EXPECT_FALSE(has(tikz_text(figure), "\\providecommand")) << tikz_text(figure);
}

TEST(TikzPainter, paints_ink_row_by_row) {
    auto map = std::make_shared<CoverageMap>(glm::ivec2(100, 80));
    map->stroke({10.0, 40.5}, {90.0, 40.5}, {.width_px = 3.0});
    const std::string text = tikz_of(Ink{map, red});
    EXPECT_TRUE(has(text, ",40)rectangle(")) << text;
    EXPECT_FALSE(has(text, ",45)rectangle(")) << text;
}

TEST(TikzPainter, tells_what_it_leaves_out) {
    Figure figure = page_of({}, {100.0, 80.0}, std::nullopt);
    auto image = std::make_shared<Image>(Image{1, 1, {255, 0, 0, 255}});
    figure.parts.front().list.add(ImageQuad{image, {0, 0}, {10, 0}, {0, 10}, 1.0});
    figure.parts.front().list.add(Label{.position = {}, .text = "Яa Я", .color = red});
    figure.unplaced = {"P_{1}"};
    const FigureLosses losses = figure_losses(figure, FigureFormat::tikz);
    EXPECT_TRUE(losses.has_images);
    EXPECT_EQ(losses.letters, std::vector<std::string>{"Я"});
    EXPECT_EQ(losses.labels, std::vector<std::string>{"P_{1}"});
    EXPECT_FALSE(figure_losses(figure, FigureFormat::svg).has_images);
    EXPECT_TRUE(figure_losses(figure, FigureFormat::pdf).letters.empty());
}

TEST(TikzPainter, defines_what_is_for_other_letters_only_where_there_are_some) {
    EXPECT_TRUE(
        has(tikz_of(Label{.position = {}, .text = "Я", .color = red}), "\\providecommand\\battenletters[1]{?}"));
    EXPECT_FALSE(has(tikz_of(Label{.position = {}, .text = "R", .color = red}), "battenletters"));
}

}  // namespace
}  // namespace batten::render
