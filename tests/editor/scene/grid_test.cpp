#include "app/editor/scene/grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/editor/scene/grid_number.h"
#include "app/editor/scene/text_size.h"
#include "tests/editor/scene_sample.h"

namespace batten::editor {
namespace {

struct Grid {
    std::vector<render::Polyline> lines;
    std::vector<render::PixelBox> numbers;
    std::vector<std::string> texts;
};

Grid grid_of(const EditorState& state) {
    render::DrawList list;
    SceneCache cache;
    CanvasFrame frame(state, cache, list);
    draw_grid(frame);
    Grid grid;
    grid.lines = test::all_of<render::Polyline>(list);
    grid.numbers = draw_grid_numbers(frame, std::nullopt);
    grid.texts = test::texts_of(list);
    return grid;
}

EditorState state_at(double scale, glm::dvec2 center) {
    EditorState state;
    state.view.camera = {center, scale, {1048.0, 566.0}};
    return state;
}

TEST(Grid, numbers_have_the_digits_of_the_step) {
    EXPECT_EQ(grid_number_text(0.0, 0.1), "0");
    EXPECT_EQ(grid_number_text(3.0, 1.0), "3");
    EXPECT_EQ(grid_number_text(0.30000000000000004, 0.1), "0.3");
    EXPECT_EQ(grid_number_text(1000.0, 1.0), "1000");
    EXPECT_EQ(grid_number_text(123456.74, 0.01), "123456.74");
    EXPECT_EQ(grid_number_text(3.0000000001, 1e-10), "3.0000000001");
    EXPECT_EQ(grid_number_text(2e-9, 1e-9), "2e−9");
    EXPECT_EQ(grid_number_text(-0.5, 0.1), "−0.5");
}

TEST(Grid, numbers_count_in_the_unit_of_the_document) {
    // A tenth of the world is a millimeter: at 1000 px a unit of the world a millimeter is 100 px, and x = 0.3 is 3 mm.
    EditorState state = state_at(1000.0, {0.3, 0.0});
    core::Document document = state.history.present();
    document.units = core::DocumentUnits{.unit = core::LengthUnit::mm, .scale = 0.1};
    state.history = History(document);
    const Grid grid = grid_of(state);
    const auto found = std::find(grid.texts.begin(), grid.texts.end(), "3");
    ASSERT_NE(found, grid.texts.end());
    const render::PixelBox box = grid.numbers[static_cast<std::size_t>(found - grid.texts.begin())];
    EXPECT_NEAR(0.5 * (box.lower_px.x + box.upper_px.x), 524.0, 1e-9);
    EXPECT_EQ(std::find(grid.texts.begin(), grid.texts.end(), "0.3"), grid.texts.end());
}

TEST(Grid, lines_are_where_the_multiples_are) {
    const EditorState state = state_at(100.0, {0.0, 0.0});
    const Grid grid = grid_of(state);
    int vertical_at_origin = 0;
    for (const render::Polyline& line : grid.lines) {
        const bool is_vertical = line.points.front().x == line.points.back().x;
        if (!is_vertical) continue;
        const double world = render::world_from_screen(state.view.camera, line.points.front()).x;
        EXPECT_NEAR(world / 0.2, std::round(world / 0.2), 1e-4) << world;
        vertical_at_origin += std::abs(world) < 1e-6 ? 1 : 0;
    }
    EXPECT_EQ(vertical_at_origin, 1) << "a major line is not drawn as a minor one, too";
}

TEST(Grid, numbers_never_pile_up_over_all_scales) {
    for (double exponent = -9.0; exponent <= 15.0; exponent += 0.13)
        for (const glm::dvec2 center : {glm::dvec2(0.0), {3.4, -2.2}, {123456.789, 1e9}, {-1e12, 7e-7}}) {
            const Grid grid = grid_of(state_at(std::pow(10.0, exponent), center));
            for (std::size_t i = 0; i < grid.numbers.size(); ++i)
                for (std::size_t j = i + 1; j < grid.numbers.size(); ++j)
                    EXPECT_FALSE(grid.numbers[i].overlaps(grid.numbers[j]))
                        << grid.texts[i] << " / " << grid.texts[j] << " at 1e" << exponent;
            EXPECT_LT(grid.lines.size(), 130U);
        }
}

TEST(Grid, neighboring_numbers_differ_over_twelve_decades) {
    for (double exponent = -4.0; exponent <= 8.0; exponent += 0.21) {
        const Grid grid = grid_of(state_at(std::pow(10.0, exponent), {3.4, -2.2}));
        EXPECT_GE(grid.texts.size(), 4U);
        for (std::size_t i = 0; i + 1 < grid.texts.size(); ++i)
            EXPECT_NE(grid.texts[i], grid.texts[i + 1]) << "at 1e" << exponent;
    }
}

TEST(Grid, numbers_keep_clear_of_what_is_covered) {
    const render::PixelBox covered{{0.0, 400.0}, {300.0, 566.0}};
    const EditorState state = state_at(66.0, {0.0, 0.0});
    render::DrawList list;
    SceneCache cache;
    CanvasFrame frame(state, cache, list);
    const auto numbers = draw_grid_numbers(frame, covered);
    EXPECT_FALSE(numbers.empty());
    for (const render::PixelBox& box : numbers) EXPECT_FALSE(box.overlaps(covered));
}

}  // namespace
}  // namespace batten::editor
