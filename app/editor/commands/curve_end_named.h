/// The ends of a curve as arguments.
#pragma once

#include "app/editor/command_table.h"
#include "core/curve/curve_end.h"

namespace batten::editor {

/// "start" or "end"; the refusal says so.
Outcome<core::CurveEnd> curve_end_named(const std::string& name);

/// Suggestions: "end"; "both".
std::optional<Argument> curve_end(const EditorState& state);
std::optional<Argument> both_ends(const EditorState& state);

/// The curve after `change` at "start", "end", or "both" one after the other; anything else is refused.
Outcome<core::Curve> change_ends(const core::Curve& curve, const std::string& ends,
                                 core::Result<core::Curve> (*change)(const core::Curve&, core::CurveEnd));

}  // namespace batten::editor
