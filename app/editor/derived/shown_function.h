/// Which basis function the teaching views are about.
#pragma once

#include <cstddef>
#include <optional>

#include "app/editor/state/state.h"

namespace batten::editor {

/// One function of the shown active curve.
struct ShownFunction {
    std::size_t index = 0;   ///< of its control point
    std::size_t number = 0;  ///< i of N_{i,p} by the knots of values(); another one only where the curve is periodic
};

/// That of the selected control point, the first of several; else the one that is largest at the parameter. None
/// without a curve. Cost O(p^2).
std::optional<ShownFunction> shown_function(const EditorState& state);

/// The function of the recurrence that is pointed at, else the shown function itself: N_{i,k}.
std::optional<HoveredBasisCell> shown_basis_cell(const EditorState& state);

}  // namespace batten::editor
