/// The triangle of a construction as a picture in a card.
#pragma once

#include <functional>

#include "app/editor/cards/card.h"
#include "app/editor/words/cell_names.h"

namespace batten::editor {

/// What stands in a cell, and on level >= 1 below it; empty for nothing.
struct CellTexts {
    std::function<std::string(const NamedTriangle& named, core::CellPlace place)> inside;
    std::function<std::string(const NamedTriangle& named, core::CellPlace place)> below;
    double least_width = 44.0;   ///< of a cell, in design pixels
    double column_share = 0.72;  ///< how much of a column's pitch its cells take
};

/// Cells in columns by level, joined by lines the stronger the larger the share; in the colors that the points have on
/// the canvas. A cell is lit with its point and lights it; levels that are not drawn there are faded. Places are "cell
/// r j". There must be an active curve, and `state` must outlive the picture.
/// Of a degree above 8 a sentence stands for it.
CardBlock triangle_picture(const EditorState& state, CellTexts texts);

}  // namespace batten::editor
