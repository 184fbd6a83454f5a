/// Commands that cut curves where they cross, and extend them until they meet.
#pragma once

#include <string>

#include "app/editor/command.h"
#include "app/editor/command_spec.h"
#include "core/curve/curve_end.h"
#include "core/refine/trim.h"

namespace batten::editor {

/// Removes the part of the active curve between its crossings around a place.
struct Trim {
    double u;
    static const CommandSpec& spec();
};

/// Makes the active curve longer until it meets another one.
struct ExtendTo {
    std::string other;
    core::CurveEnd end;
    core::Onward onward;
    static const CommandSpec& spec();
};

enum class SplitScope { active, all };

/// Splits the active curve, or all, where curves cross.
struct SplitAtCrossings {
    SplitScope scope;
    static const CommandSpec& spec();
};

/// The part of the curve `index` of the committed document that trimming around `u` takes away, or why there is none.
Outcome<core::Interval> trimmed_part(const EditorState& state, std::size_t index, double u);

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::SplitScope> {
    using enum editor::SplitScope;
    static constexpr std::array table{Named{active, "active", "the active curve"}, Named{all, "all", "all curves"}};
};

}  // namespace batten::core
