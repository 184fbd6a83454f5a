/// Where the cells of a triangle stand: in columns by level, each halfway between the two that it is made of.
#pragma once

#include <cstddef>

#include "core/base/geometry.h"
#include "render/pixel_box.h"

namespace batten::editor {

/// The cells of one picture, in its pixels.
struct CellGrid {
    glm::dvec2 origin{};
    glm::dvec2 cell{};   ///< size of a cell
    glm::dvec2 pitch{};  ///< from level to level and from cell to cell

    render::PixelBox box(std::size_t level, std::size_t index) const;

    /// Where lines end and begin: the middles of a cell's sides.
    glm::dvec2 left(std::size_t level, std::size_t index) const;
    glm::dvec2 right(std::size_t level, std::size_t index) const;
};

/// What the cells are like, in design pixels.
struct CellShape {
    core::Interval widths;
    double height = 0.0;
    double row_pitch = 0.0;
    double column_share = 1.0;  ///< how much of a column's pitch its cells take
    double margin = 2.0;        ///< around all of them, for their outlines

    double least_width_of_all(std::size_t degree) const;
    double height_of_all(std::size_t degree) const;

    /// The cells as wide as `width_px` allows, whole pixels, in a picture of `scale` pixels for a design pixel.
    CellGrid placed(std::size_t degree, double width_px, double scale) const;
};

}  // namespace batten::editor
