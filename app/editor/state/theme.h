/// The colors of the dark and the light theme.
#pragma once

#include <array>

#include "core/base/names.h"
#include "render/color.h"

namespace batten::editor {

enum class ThemeName { dark, light };

/// One color for each thing that is drawn. Against its grounds (canvas, panel, field) a line or a mark has a contrast
/// of at least 3:1, a text 4.5:1, in the measure of WCAG 2; only borders, the grid, and what is not available have
/// less.
struct Theme {
    render::Color canvas, panel, field, line, text, dim, accent, curve, polygon, grid_minor, grid_major, parameter,
        error, comb;
    std::array<render::Color, 3> levels;   ///< construction levels 1, 2, 3, then cycling
    std::array<render::Color, 8> palette;  ///< control point and basis function i, cycling

    render::Color level(std::size_t r) const { return levels[(r + levels.size() - 1) % levels.size()]; }
    render::Color point(std::size_t i) const { return palette[i % palette.size()]; }

    /// The color of a point for texts: nearer to that of texts.
    render::Color point_text(std::size_t i) const;

    /// The colors, on the panel and on the canvas, of graphs that do not act and of the teeth of the comb.
    render::Color resting_point(std::size_t i) const;
    render::Color resting_comb() const;

    bool operator==(const Theme&) const = default;
};

/// The colors of `name`.
Theme theme_of(ThemeName name);

/// The same for a projector, which washes colors out: a text has a contrast of at least 7:1, a line 4.5:1.
Theme high_contrast(ThemeName name);

/// The contrast of two opaque colors, from 1 to 21, as WCAG 2.1 has it.
double contrast(render::Color a, render::Color b);

/// `color`, or what is nearest to it on the way to the color of texts and has a contrast of 3:1 with the canvas.
render::Color seen_on_canvas(render::Color color, const Theme& theme);

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::ThemeName> {
    using enum editor::ThemeName;
    static constexpr std::array table{Named{dark, "dark", "dark"}, Named{light, "light", "light"}};
};

}  // namespace batten::core
