/// What commands that measure the active curve share.
#pragma once

#include "app/editor/command_spec.h"
#include "app/editor/state/findings.h"
#include "app/editor/state/state.h"
#include "core/base/sentence.h"

namespace batten::editor {

/// The name of the committed active curve as the place {name}; there must be one.
core::Place active_name(const EditorState& state);

/// Two numbers for a vector, "tangent x", "tangent y", or a point, whose coordinates may be off by `error`.
void add_numbers(Finding& finding, const char* name, core::Vector vector, int power = 1);
void add_numbers(Finding& finding, const char* name, core::Point point, double error);

/// "from" and "to", unless the interval is a single parameter.
void add_interval(Finding& finding, core::Interval where);

/// Shows `rows` under `title` with a sentence about them; refused where a number of theirs is not finite.
Outcome<void> show_rows(EditorState& state, const char* title, std::string summary, std::vector<Finding> rows);

/// The same; the sentence speaks of as many things as there are rows, of the curve as {name}.
Outcome<void> show_counted_rows(EditorState& state, const char* title, const core::PluralPattern& summary,
                                std::vector<Finding> rows);

}  // namespace batten::editor
