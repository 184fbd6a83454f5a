/// Sentences about uniform cubics: what a curve lacks for being one, and what equal and collinear vertices do.
#pragma once

#include <array>
#include <string>

#include "app/editor/derived/shown_cubic.h"
#include "core/edit/end_vertices.h"
#include "core/measure/cubic_joint.h"

namespace batten::editor {

/// "The curve 'wave' has degree 2; a uniform cubic has degree 3 and equally spaced knots."
std::string lack_sentence(const EditorState& state, CubicLack lack);

/// What the three neighboring vertices of `joint` make of it; `names` are theirs, in order.
std::string joint_sentence(const core::Anticentroid& joint, const std::array<std::string, 3>& names);

/// What an end vertex does, {} being the polygon as it is: "It begins in {first}, with no speed, and is straight over
/// the first span." `names` are those of the two outer vertices from the end inward.
std::string end_sentence(core::CurveEnd end, std::optional<core::EndVertex> vertex,
                         const std::array<std::string, 2>& names);

/// How two uniform cubics join: "They join with C² ..."
std::string meeting_sentence(const core::CubicMeeting& meeting);

}  // namespace batten::editor
