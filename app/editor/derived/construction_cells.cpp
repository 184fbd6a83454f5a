#include "app/editor/derived/construction_cells.h"

#include <algorithm>

namespace batten::editor {

std::size_t shown_level(const View& view, int degree) {
    return static_cast<std::size_t>(std::clamp(view.level.value_or(degree), 0, degree));
}

bool is_lit_cell(const EditorState& state, const core::DeBoorTriangle& triangle, core::CellPlace place) {
    if (const auto* point = std::get_if<HoveredPoint>(&state.hover)) {
        const std::size_t n = state.active_curve()->control_points().size();
        return place.level == 0 && triangle.levels[0][place.index].index % n == point->index;
    }
    if (std::holds_alternative<HoveredParameter>(state.hover)) return place.level + 1 == triangle.levels.size();
    return hovered_cell(state, triangle) == place;
}

std::optional<core::CellPlace> hovered_cell(const EditorState& state, const core::DeBoorTriangle& triangle) {
    const auto* cell = std::get_if<HoveredCell>(&state.hover);
    const auto& levels = triangle.levels;
    if (cell == nullptr || cell->level >= levels.size() || cell->index >= levels[cell->level].size())
        return std::nullopt;
    return core::CellPlace{cell->level, cell->index};
}

std::vector<core::CellPlace> marked_cells(const View& view, const core::DeBoorTriangle& triangle) {
    const std::size_t degree = triangle.levels.size() - 1;
    const std::size_t last = std::min(shown_level(view, static_cast<int>(degree)), degree - 1);
    std::vector<core::CellPlace> cells;
    for (std::size_t r = 1; r <= last; ++r)
        for (std::size_t j = 0; j < triangle.levels[r].size(); ++j)
            if (core::origin_of(triangle, {r, j}) == core::CellPlace{r, j}) cells.push_back({r, j});
    return cells;
}

}  // namespace batten::editor
