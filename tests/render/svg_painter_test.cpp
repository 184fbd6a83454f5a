#include "render/svg_painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "tests/render/plain_colors.h"

namespace batten::render {
namespace {

constexpr Color white{255, 255, 255, 255};

std::string svg_of(const DrawCommand& command) {
    DrawList list;
    list.commands.push_back(command);
    return svg_text(page_of(list, {100.0, 80.0}, white));
}

/// Whether something drawn has this property, as an attribute or in its style.
bool has(const std::string& svg, const std::string& name, const std::string& value) {
    return std::regex_search(svg, std::regex(name + "(=\"|:)" + value + "[;\"]"));
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// All numbers of the last path of the file.
std::vector<double> last_path(const std::string& svg) {
    static const std::regex path(" d=\"([^\"]*)\"");
    std::string data;
    for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) data = (*it)[1];
    static const std::regex number("-?[0-9.]+");
    std::vector<double> numbers;
    for (std::sregex_iterator it(data.begin(), data.end(), number), end; it != end; ++it)
        numbers.push_back(std::stod(it->str()));
    return numbers;
}

TEST(SvgPainter, begins_with_a_ground_of_the_size) {
    Figure figure = page_of({}, {100.0, 80.0}, Color{1, 2, 3, 255});
    figure.title = "a < b & \"c\"";
    const std::string text = svg_text(figure);
    EXPECT_NE(text.find("width=\"100\" height=\"80\" viewBox=\"0 0 100 80\""), std::string::npos) << text;
    EXPECT_NE(text.find("fill=\"#010203\""), std::string::npos) << text;
    EXPECT_NE(text.find("<title>a &lt; b &amp; &quot;c&quot;</title>"), std::string::npos) << text;
    EXPECT_EQ(count(text, "<rect"), 1U);
    EXPECT_EQ(count(svg_text(page_of({}, {100.0, 80.0}, std::nullopt)), "<rect"), 0U) << "transparent";
}

TEST(SvgPainter, cuts_parts_to_their_boxes) {
    Figure figure{.size_px = {100, 80}, .parts = {}};
    figure.parts.push_back({{}, {{0, 30.5}, {100, 80}}, std::nullopt});
    EXPECT_NE(svg_text(figure).find("<svg x=\"0\" y=\"30.5\" width=\"100\" height=\"49.5\">"), std::string::npos);
}

TEST(SvgPainter, leaves_out_points_that_cannot_be_told_apart) {
    std::vector<Pixel> points;
    for (int i = 0; i <= 1000; ++i) points.emplace_back(10.0F + 0.01F * static_cast<float>(i), 20.0F);
    const std::vector<double> numbers = last_path(svg_of(Polyline{.points = points, .color = red}));
    EXPECT_LT(numbers.size(), 2U * 202U);
    EXPECT_EQ(numbers.front(), 10.0);
    EXPECT_NEAR(numbers[numbers.size() - 2], 20.0, 1e-9) << "the end stays";
}

TEST(SvgPainter, draws_lines_through_their_points) {
    const std::string svg = svg_of(Polyline{.points = {{10, 20}, {30, 25}, {50, 60}}, .color = red, .width_px = 3.0F});
    EXPECT_EQ(last_path(svg), (std::vector<double>{10, 20, 30, 25, 50, 60}));
    EXPECT_TRUE(has(svg, "stroke-width", "3")) << svg;
    EXPECT_TRUE(has(svg, "stroke-linecap", "round")) << svg;
    EXPECT_EQ(svg.find("dasharray"), std::string::npos);
}

TEST(SvgPainter, dashes_and_closes_lines) {
    const std::string svg = svg_of(Polyline{
        .points = {{10, 20}, {30, 20}, {30, 40}}, .color = red, .dash_px = 5.0F, .gap_px = 2.0F, .is_closed = true});
    EXPECT_TRUE(has(svg, "stroke-dasharray", "5 2")) << svg;
    EXPECT_TRUE(std::regex_search(svg, std::regex("30 40Z"))) << svg;
    EXPECT_TRUE(has(svg, "stroke-linecap", "butt")) << svg;
}

TEST(SvgPainter, fills_with_opacity) {
    const std::string svg = svg_of(Fill{{{10, 10}, {20, 10}, {20, 30}}, {0, 0, 255, 51}});
    EXPECT_TRUE(has(svg, "fill-opacity", "0.2")) << svg;
    const std::vector<double> numbers = last_path(svg);
    ASSERT_GE(numbers.size(), 6U);
    EXPECT_EQ(std::vector<double>(numbers.begin(), numbers.begin() + 6), (std::vector<double>{10, 10, 20, 10, 20, 30}));
}

TEST(SvgPainter, leaves_out_what_cannot_be_seen) {
    const std::string bare = svg_of(Fill{{{10, 10}, {20, 10}}, red});
    EXPECT_EQ(bare, svg_of(Polyline{.points = {}, .color = red}));
    EXPECT_EQ(bare, svg_of(Marker{.center = {5, 5}, .fill = {0, 0, 0, 0}, .outline = {0, 0, 0, 0}}));
}

TEST(SvgPainter, draws_marks_by_their_shape) {
    EXPECT_EQ(last_path(svg_of(Marker{
                  .center = {50, 40}, .shape = MarkerShape::diamond, .radius_px = 6, .fill = red, .outline = {}})),
              (std::vector<double>{44, 40, 50, 34, 56, 40, 50, 46}));
    EXPECT_EQ(last_path(svg_of(Marker{
                  .center = {50, 40}, .shape = MarkerShape::square, .radius_px = 6, .fill = red, .outline = {}})),
              (std::vector<double>{44, 34, 56, 34, 56, 46, 44, 46}));
    const std::string disc =
        svg_of(Marker{.center = {50, 40}, .radius_px = 10, .fill = red, .outline = white, .outline_px = 2});
    EXPECT_NE(
        disc.find("<circle cx=\"50\" cy=\"40\" r=\"10\" fill=\"#ff0000\" stroke=\"#ffffff\" stroke-width=\"2\"/>"),
        std::string::npos)
        << disc;
}

TEST(SvgPainter, sets_labels_as_text_with_scripts) {
    Label label{.position = {50, 40}, .text = "P", .color = red, .size_px = 20.0F};
    EXPECT_NE(svg_of(label).find("<text x=\"50\" y=\"47.2\" font-size=\"20\" fill=\"#ff0000\">P</text>"),
              std::string::npos)
        << svg_of(label);
    label.anchor = Anchor::right;
    EXPECT_TRUE(has(svg_of(label), "text-anchor", "end"));
    label.anchor = Anchor::center;
    EXPECT_TRUE(has(svg_of(label), "text-anchor", "middle"));
    label.text = "C^{2}<1";
    // Up by 0.3 of 20, and down again.
    EXPECT_NE(svg_of(label).find(">C<tspan dy=\"-6\" font-size=\"14.8\">2</tspan><tspan dy=\"6\">&lt;1</tspan></text>"),
              std::string::npos)
        << svg_of(label);
}

TEST(SvgPainter, sets_scripts_above_one_another) {
    const Label label{.position = {50, 40}, .text = "P_{3}^{3}x", .color = red, .size_px = 20.0F};
    const std::string svg = svg_of(label);
    std::smatch found;
    ASSERT_TRUE(
        std::regex_search(svg, found, std::regex("<tspan dy=\"6\"[^>]*>3</tspan><tspan dx=\"-([0-9.]+)\" dy=\"-12\"")))
        << svg;
    EXPECT_NEAR(std::stod(found[1]), 0.62 * 0.74 * 20.0, 2.5) << "the width of a digit";
    EXPECT_NE(svg.find("<tspan dy=\"6\">x</tspan>"), std::string::npos) << svg;
}

TEST(SvgPainter, paints_ink_as_a_picture) {
    auto map = std::make_shared<CoverageMap>(glm::ivec2(100, 80));
    map->stroke({10.0, 10.0}, {90.0, 70.0}, {.width_px = 4.0});
    const std::string svg = svg_of(Ink{map, red});
    // Of what is touched alone, as a PNG: its first bytes are "\x89PNG\r\n".
    EXPECT_TRUE(std::regex_search(svg, std::regex("<image x=\"[78]\" y=\"[78]\" width=\"8[3-6]\" height=\"6[3-6]\" "
                                                  "xlink:href=\"data:image/png;base64,iVBORw0K")))
        << svg;
}

TEST(SvgPainter, fills_regions_by_their_rule) {
    const auto loops = std::make_shared<RegionLoops>();
    loops->loops = {{{10, 10}, {50, 10}, {50, 50}}, {{20, 15}, {40, 15}, {40, 30}}};
    const auto map = std::make_shared<CoverageMap>(region_coverage(*loops, {100, 80}));
    std::string svg = svg_of(Region{loops, map, red});
    const std::vector<double> path = last_path(svg);
    for (const std::vector<double>& loop : {std::vector<double>{10, 10, 50, 10, 50, 50}, {20, 15, 40, 15, 40, 30}})
        EXPECT_NE(std::search(path.begin(), path.end(), loop.begin(), loop.end()), path.end()) << svg;
    EXPECT_FALSE(has(svg, "fill-rule", "evenodd")) << svg;
    loops->rule = FillRule::even_odd;
    svg = svg_of(Region{loops, map, red});
    EXPECT_TRUE(has(svg, "fill-rule", "evenodd")) << svg;
}

}  // namespace
}  // namespace batten::render
