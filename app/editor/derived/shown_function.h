/// Which basis function the teaching views are about.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

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

/// What basis functions of the curve's degree are called: "B" where the curve is a Bézier curve, else "N".
const char* basis_letter(const EditorState& state, const core::KnotVector& knots);

/// "N_{0,3}" or "B_{0,3}", of the curve's degree.
std::string function_name(const EditorState& state, const core::KnotVector& knots, std::size_t i);

/// The function of the recurrence that is pointed at, else the shown function itself: N_{i,k}.
std::optional<HoveredBasisCell> shown_basis_cell(const EditorState& state);

}  // namespace batten::editor
