#include "app/editor/state/theme.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/editor/state/view.h"

namespace batten::editor {
namespace {

using render::rgb;

TEST(Theme, has_the_colors_of_the_look) {
    const Theme dark = theme_of(ThemeName::dark);
    EXPECT_EQ(dark.canvas, rgb(0x14161B));
    EXPECT_EQ(dark.field, rgb(0x22262F));
    EXPECT_EQ(dark.accent, rgb(0x5AA9FF));
    EXPECT_EQ(dark.parameter, rgb(0xFFD166));
    const Theme light = theme_of(ThemeName::light);
    EXPECT_EQ(light.canvas, rgb(0xFBFBFD));
    EXPECT_EQ(light.text, rgb(0x1B2130));
    EXPECT_EQ(light.grid_major, rgb(0xE3E7EE));
    EXPECT_EQ(light.curve, rgb(0x10131A));
}

double distance(render::Color a, render::Color b) {
    return std::hypot(a.red - b.red, a.green - b.green, a.blue - b.blue);
}

/// On which texts and lines stand: the surfaces, the active span of the plot, a selected row.
std::vector<render::Color> grounds_of(const Theme& theme) {
    return {theme.canvas, theme.panel, theme.field, render::blended(theme.accent, 0.07, theme.panel)};
}

TEST(Theme, contrast_is_that_of_known_pairs) {
    EXPECT_NEAR(contrast(rgb(0x000000), rgb(0xFFFFFF)), 21.0, 1e-12);
    EXPECT_NEAR(contrast(rgb(0x767676), rgb(0xFFFFFF)), 4.54, 0.005);
    EXPECT_NEAR(contrast(rgb(0xD9C93B), rgb(0xF1F3F7)), 1.53, 0.005);
}

TEST(Theme, colors_of_curves_are_seen_on_every_canvas) {
    for (const ThemeName name : {ThemeName::dark, ThemeName::light}) {
        const Theme theme = theme_of(name);
        for (const render::Color color : {rgb(0x000000), rgb(0xFFFFFF), rgb(0x14181F), rgb(0xFFFF00), rgb(0x000080)}) {
            EXPECT_GE(contrast(seen_on_canvas(color, theme), theme.canvas), 3.0);
            if (contrast(color, theme.canvas) >= 3.0) {
                EXPECT_EQ(seen_on_canvas(color, theme), color);
            }
        }
    }
    // Yellow stays yellow where it has to be darker.
    const render::Color yellow = seen_on_canvas(rgb(0xFFFF00), theme_of(ThemeName::light));
    EXPECT_GT(yellow.red, yellow.blue + 40);
    EXPECT_GT(yellow.green, yellow.blue + 40);
}

/// The themes with what their texts and their lines must have.
struct Goal {
    std::string name;
    Theme theme;
    double text;
    double line;
};

std::vector<Goal> goals() {
    std::vector<Goal> all;
    for (const ThemeName name : {ThemeName::dark, ThemeName::light}) {
        all.push_back({core::name_of(name), theme_of(name), 4.5, 3.0});
        all.push_back({std::string(core::name_of(name)) + ", high contrast", high_contrast(name), 7.0, 4.5});
    }
    return all;
}

TEST(Theme, texts_stand_out_from_every_ground) {
    for (const auto& [name, theme, goal, _] : goals()) {
        std::vector<render::Color> texts{theme.text, theme.dim, theme.accent, theme.parameter, theme.error};
        texts.insert(texts.end(), theme.levels.begin(), theme.levels.end());
        for (std::size_t i = 0; i < theme.palette.size(); ++i) texts.push_back(theme.point_text(i));
        for (std::size_t k = 0; k < texts.size(); ++k)
            for (const render::Color ground : grounds_of(theme))
                EXPECT_GE(contrast(texts[k], ground), goal) << name << ", text " << k;
        const render::Color selected_row = render::blended(theme.accent, 0.17, theme.panel);
        for (const render::Color text : {theme.text, theme.dim, theme.accent})
            EXPECT_GE(contrast(text, selected_row), goal) << name;
        EXPECT_GE(contrast(theme.canvas, theme.accent), goal) << "the words of a pressed button";
    }
}

TEST(Theme, lines_and_marks_stand_out_from_every_ground) {
    for (const auto& [name, theme, _, goal] : goals()) {
        for (std::size_t i = 0; i < theme.palette.size(); ++i) {
            for (const render::Color ground : grounds_of(theme))
                EXPECT_GE(contrast(theme.point(i), ground), goal) << name << ", point " << i;
            EXPECT_GE(contrast(theme.resting_point(i), theme.panel), goal) << name << ", point " << i;
        }
        for (const render::Color line : {theme.curve, theme.polygon, theme.comb, theme.resting_comb()})
            EXPECT_GE(contrast(line, theme.canvas), goal) << name;
    }
}

TEST(Theme, comb_has_a_color_of_its_own) {
    for (const auto& [name, theme, text_goal, line_goal] : goals()) {
        for (const render::Color level : theme.levels) EXPECT_NE(theme.comb, level);
        for (const render::Color point : theme.palette) EXPECT_NE(theme.comb, point);
        for (const render::Color other : {theme.curve, theme.accent, theme.parameter}) EXPECT_NE(theme.comb, other);
    }
}

TEST(Theme, points_and_levels_keep_apart_in_high_contrast) {
    for (const ThemeName name : {ThemeName::dark, ThemeName::light}) {
        const Theme usual = theme_of(name);
        const Theme theme = high_contrast(name);
        for (std::size_t i = 0; i < theme.palette.size(); ++i)
            for (std::size_t k = 0; k < i; ++k) {
                const double before = distance(usual.point(i), usual.point(k));
                EXPECT_GE(distance(theme.point(i), theme.point(k)), 0.5 * before) << i << ", " << k;
            }
        for (std::size_t r = 2; r <= theme.levels.size(); ++r)
            EXPECT_GE(distance(theme.level(r), theme.level(r - 1)), 60.0) << r;
        EXPECT_GT(contrast(theme.grid_minor, theme.canvas), 1.05) << "the grid is seen";
        EXPECT_GT(contrast(theme.grid_major, theme.grid_minor), 1.05);
    }
}

TEST(Theme, is_of_high_contrast_while_presenting) {
    View view;
    view.theme = ThemeName::light;
    EXPECT_EQ(shown_theme(view), theme_of(ThemeName::light));
    view.is_presenting = true;
    EXPECT_EQ(shown_theme(view), high_contrast(ThemeName::light));
    EXPECT_EQ(shown_theme(view).canvas, rgb(0xFFFFFF));
    view.theme = ThemeName::dark;
    EXPECT_EQ(shown_theme(view).canvas, rgb(0x000000));
}

TEST(Theme, cycles_levels_from_one_and_points_from_zero) {
    const Theme theme = theme_of(ThemeName::dark);
    EXPECT_EQ(theme.level(1), rgb(0x4FC3A1));
    EXPECT_EQ(theme.level(3), rgb(0xEF6F8E));
    EXPECT_EQ(theme.level(4), theme.level(1));
    EXPECT_EQ(theme.point(0), rgb(0xE69F00));
    EXPECT_EQ(theme.point(5), rgb(0xE8743B));
    EXPECT_EQ(theme.point(8), theme.point(0));
}

}  // namespace
}  // namespace batten::editor
