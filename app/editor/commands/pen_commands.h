/// Commands that choose what the pen makes of the points that are clicked.
#pragma once

#include "app/editor/command.h"
#include "app/editor/state/pen_mode.h"

namespace batten::editor {

/// Takes the pen in one of its modes.
template <PenMode mode>
struct UsePen {
    static const CommandSpec& spec();
};

template <>
const CommandSpec& UsePen<PenMode::control_points>::spec();
template <>
const CommandSpec& UsePen<PenMode::through_c2>::spec();
template <>
const CommandSpec& UsePen<PenMode::through_local>::spec();
template <>
const CommandSpec& UsePen<PenMode::through_fair>::spec();
template <>
const CommandSpec& UsePen<PenMode::bezier>::spec();

struct SetPenMode {
    PenMode mode;
    static const CommandSpec& spec();
};

/// The command that takes the pen in `mode`.
const CommandSpec& use_pen_spec(PenMode mode);

}  // namespace batten::editor
