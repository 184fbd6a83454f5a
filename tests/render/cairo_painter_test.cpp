#include "render/cairo_painter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace batten::render {
namespace {

constexpr Color white{255, 255, 255, 255};
constexpr Color red{255, 0, 0, 255};

std::string svg_of(const DrawCommand& command) {
    DrawList list;
    list.commands.push_back(command);
    const auto text = svg_text(list, {100.0, 80.0}, white);
    EXPECT_TRUE(text);
    // The numbers that Cairo gives its surfaces differ from call to call.
    return std::regex_replace(text.value_or(""), std::regex("id=\"surface[0-9]+\""), "id=\"surface\"");
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

TEST(CairoPainter, begins_with_a_ground_of_the_size) {
    const auto text = svg_text({}, {100.0, 80.0}, {1, 2, 3, 255});
    ASSERT_TRUE(text);
    EXPECT_NE(text->find("width=\"100"), std::string::npos);
    EXPECT_NE(text->find("height=\"80"), std::string::npos);
    EXPECT_NE(text->find("</svg>"), std::string::npos);
    EXPECT_EQ(count(*text, "<path") + count(*text, "<rect"), 1U);
}

TEST(CairoPainter, draws_lines_through_their_points) {
    const std::string svg = svg_of(Polyline{.points = {{10, 20}, {30, 25}, {50, 60}}, .color = red, .width_px = 3.0F});
    EXPECT_EQ(last_path(svg), (std::vector<double>{10, 20, 30, 25, 50, 60}));
    EXPECT_TRUE(has(svg, "stroke-width", "3")) << svg;
    EXPECT_TRUE(has(svg, "stroke-linecap", "round")) << svg;
    EXPECT_EQ(svg.find("dasharray"), std::string::npos);
}

TEST(CairoPainter, dashes_and_closes_lines) {
    const std::string svg = svg_of(Polyline{
        .points = {{10, 20}, {30, 20}, {30, 40}}, .color = red, .dash_px = 5.0F, .gap_px = 2.0F, .is_closed = true});
    EXPECT_TRUE(has(svg, "stroke-dasharray", "5[ ,]+2")) << svg;
    EXPECT_TRUE(std::regex_search(svg, std::regex("30 40 Z"))) << svg;
    EXPECT_TRUE(has(svg, "stroke-linecap", "butt")) << svg;
}

TEST(CairoPainter, fills_with_opacity) {
    const std::string svg = svg_of(Fill{{{10, 10}, {20, 10}, {20, 30}}, {0, 0, 255, 51}});
    EXPECT_TRUE(has(svg, "fill-opacity", "0.2")) << svg;
    const std::vector<double> numbers = last_path(svg);
    ASSERT_GE(numbers.size(), 6U);
    EXPECT_EQ(std::vector<double>(numbers.begin(), numbers.begin() + 6), (std::vector<double>{10, 10, 20, 10, 20, 30}));
}

TEST(CairoPainter, leaves_out_what_cannot_be_seen) {
    const std::string bare = svg_of(Fill{{{10, 10}, {20, 10}}, red});
    EXPECT_EQ(bare, svg_of(Polyline{.points = {}, .color = red}));
    EXPECT_EQ(bare, svg_of(Marker{.center = {5, 5}, .fill = {0, 0, 0, 0}, .outline = {0, 0, 0, 0}}));
}

TEST(CairoPainter, draws_marks_by_their_shape) {
    std::vector<double> diamond = last_path(
        svg_of(Marker{.center = {50, 40}, .shape = MarkerShape::diamond, .radius_px = 6, .fill = red, .outline = {}}));
    ASSERT_GE(diamond.size(), 8U);
    diamond.resize(8);
    EXPECT_EQ(diamond, (std::vector<double>{44, 40, 50, 34, 56, 40, 50, 46}));
    const std::vector<double> disc =
        last_path(svg_of(Marker{.center = {50, 40}, .radius_px = 10, .fill = red, .outline = {}}));
    ASSERT_GE(disc.size(), 8U);
    EXPECT_EQ(disc[0], 60.0);
    EXPECT_EQ(disc[1], 40.0);
    for (const double number : disc) EXPECT_TRUE(30.0 <= number && number <= 60.0) << number;
}

TEST(CairoPainter, sets_labels_with_scripts_where_they_belong) {
    Label label{.position = {50, 40}, .text = "P", .color = red, .size_px = 20.0F};
    const auto uses = [&](const std::string& text, Anchor anchor) {
        label.text = text;
        label.anchor = anchor;
        const std::string svg = svg_of(label);
        static const std::regex use("<use [^>]*x=\"([0-9.]+)\" y=\"([0-9.]+)\"");
        std::vector<glm::dvec2> places;
        for (std::sregex_iterator it(svg.begin(), svg.end(), use), end; it != end; ++it)
            places.emplace_back(std::stod((*it)[1]), std::stod((*it)[2]));
        return places;
    };
    const auto plain = uses("P", Anchor::left);
    ASSERT_EQ(plain.size(), 1U);
    EXPECT_NEAR(plain[0].x, 50.0, 1e-3);
    const auto scripts = uses("P_{3}^{1}", Anchor::left);
    ASSERT_EQ(scripts.size(), 3U);
    EXPECT_NEAR(scripts[1].x, scripts[2].x, 0.01) << "stacked";
    EXPECT_GT(scripts[1].x, scripts[0].x + 5.0);
    EXPECT_GT(scripts[1].y, scripts[2].y + 8.0) << "the subscript is lower by twice 0.3 of 20";
    const double width = 2.0 * (plain[0].x - uses("P", Anchor::center)[0].x);
    EXPECT_NEAR(uses("P", Anchor::right)[0].x, 50.0 - width, 0.01) << "Cairo rounds to 1/256";
}

TEST(CairoPainter, paints_ink_as_a_picture) {
    auto map = std::make_shared<CoverageMap>(glm::ivec2(100, 80));
    map->stroke({10.0, 10.0}, {90.0, 70.0}, {.width_px = 4.0});
    EXPECT_NE(svg_of(Ink{map, red}).find("<image"), std::string::npos);
}

TEST(CairoPainter, fills_regions_by_their_rule) {
    const auto loops = std::make_shared<RegionLoops>();
    loops->loops = {{{10, 10}, {50, 10}, {50, 50}}, {{20, 15}, {40, 15}, {40, 30}}};
    const auto map = std::make_shared<CoverageMap>(region_coverage(*loops, {100, 80}));
    std::string svg = svg_of(Region{loops, map, red});
    // Where a loop ends, versions of Cairo name its first point again or do not.
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
