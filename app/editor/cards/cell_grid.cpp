#include "app/editor/cards/cell_grid.h"

#include <cmath>

namespace batten::editor {

namespace {

/// How many widths of a cell all columns take.
double widths_across(std::size_t degree, double column_share) {
    return 1.0 + static_cast<double>(degree) / column_share;
}

}  // namespace

render::PixelBox CellGrid::box(std::size_t level, std::size_t index) const {
    const auto r = static_cast<double>(level);
    const glm::dvec2 corner = origin + pitch * glm::dvec2(r, static_cast<double>(index) + 0.5 * r);
    return {corner, corner + cell};
}

glm::dvec2 CellGrid::left(std::size_t level, std::size_t index) const {
    return box(level, index).lower_px + glm::dvec2(0.0, 0.5 * cell.y);
}

glm::dvec2 CellGrid::right(std::size_t level, std::size_t index) const {
    return box(level, index).upper_px - glm::dvec2(0.0, 0.5 * cell.y);
}

double CellShape::least_width_of_all(std::size_t degree) const {
    return widths_across(degree, column_share) * widths.lower + 2.0 * margin;
}

double CellShape::height_of_all(std::size_t degree) const {
    return static_cast<double>(degree) * row_pitch + height + 2.0 * margin;
}

CellGrid CellShape::placed(std::size_t degree, double width_px, double scale) const {
    const double room = (width_px - 2.0 * margin * scale) / widths_across(degree, column_share);
    const double width = std::floor(core::Interval{widths.lower * scale, widths.upper * scale}.clamp(room));
    return {.origin = glm::dvec2(margin * scale),
            .cell = {width, height * scale},
            .pitch = {width / column_share, row_pitch * scale}};
}

}  // namespace batten::editor
