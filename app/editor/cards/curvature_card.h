/// The cards about how the curve bends.
#pragma once

#include "app/editor/cards/card.h"

namespace batten::editor {

/// Curvature, radius and center at the parameter, with the numbers put into the formula.
Card osculating_circle_card(const EditorState& state);

/// Velocity, unit tangent and unit normal at the parameter.
Card tangent_normal_card(const EditorState& state);

/// How many inflections and extremes there are, and the first of them; a click takes the parameter there.
Card curvature_marks_card(const EditorState& state);

}  // namespace batten::editor
