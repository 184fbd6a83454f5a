/// What commands share that act on the active curve and another one.
#pragma once

#include <optional>
#include <string>

#include "app/editor/command_spec.h"
#include "app/editor/state/state.h"
#include "core/curve/curve_end.h"

namespace batten::editor {

/// The index of the committed document's curve that `name` means, which must not be the active one.
Outcome<std::size_t> other_curve_named(const EditorState& state, const std::string& name);

/// The same, of a curve that is not locked.
Outcome<std::size_t> editable_other_curve(const EditorState& state, const std::string& name);

/// Which of the two curves has no ends, where that is the reason, else the reason.
Refusal refusal_of_ends(const Units& units, const core::DocumentCurve& active, const core::DocumentCurve& other,
                        const core::CurveError& error);

/// The ends asked for; of those left open the ones that are nearest to each other.
core::JoinedEnds chosen_ends(const core::Curve& active, const core::Curve& other, std::optional<core::CurveEnd> end,
                             std::optional<core::CurveEnd> other_end);

/// Refusal: no active curve, or no other one beside it.
std::optional<Refusal> no_second_curve(const EditorState& state);

/// The same, or the active curve is locked.
std::optional<Refusal> no_second_curve_to_edit(const EditorState& state);

}  // namespace batten::editor
