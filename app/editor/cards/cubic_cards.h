/// The cards of the chapter on uniform cubics.
#pragma once

#include "app/editor/cards/card.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// The fifteen equations and the sum that make the four pieces of the basis function, with their numbers.
Card cubic_conditions_card(const EditorState& state);

/// The matrix, and the coefficients of the segment at u that come of it.
Card cubic_matrix_card(const EditorState& state);

/// The construction of one joint, its tangent and its second derivative.
Card anticentroids_card(const EditorState& state);

/// Ends and end tangents of the segment at u.
Card ferguson_card(const EditorState& state);

/// What double, triple, phantom and collinear vertices do.
Card end_vertices_card(const EditorState& state);

/// Where the active curve and another uniform cubic join.
Card joined_cubics_card(const EditorState& state);

}  // namespace batten::editor
