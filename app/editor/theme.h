/// The colors of the dark and the light theme.
#pragma once

#include <array>

#include "core/base/names.h"
#include "render/color.h"

namespace batten::editor {

enum class ThemeName { dark, light };

/// One color for each thing that is drawn.
struct Theme {
    render::Color canvas, panel, field, line, text, dim, accent, curve, polygon, grid_minor, grid_major, parameter,
        error;
    std::array<render::Color, 3> levels;   ///< construction levels 1, 2, 3, then cycling
    std::array<render::Color, 8> palette;  ///< control point and basis function i, cycling

    render::Color level(std::size_t r) const { return levels[(r + levels.size() - 1) % levels.size()]; }
    render::Color point(std::size_t i) const { return palette[i % palette.size()]; }
};

/// The colors of `name`.
Theme theme_of(ThemeName name);

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::ThemeName> {
    using enum editor::ThemeName;
    static constexpr std::array table{Named{dark, "dark", "dark"}, Named{light, "light", "light"}};
};

}  // namespace batten::core
