/// Commands that choose what a press on the canvas does.
#pragma once

#include "app/editor/command.h"
#include "app/editor/state/view.h"

namespace batten::editor {

/// One command for each tool, for its shortcut and its button.
template <Tool tool>
struct TakeTool {
    static const CommandSpec& spec();
};

struct SetTool {
    Tool tool;
    static const CommandSpec& spec();
};

template <>
const CommandSpec& TakeTool<Tool::select>::spec();
template <>
const CommandSpec& TakeTool<Tool::add_point>::spec();
template <>
const CommandSpec& TakeTool<Tool::insert_knot>::spec();
template <>
const CommandSpec& TakeTool<Tool::weight>::spec();
template <>
const CommandSpec& TakeTool<Tool::draw_curve>::spec();
template <>
const CommandSpec& TakeTool<Tool::parameter>::spec();

/// The description of the command that takes `tool`.
const CommandSpec& take_tool_spec(Tool tool);

}  // namespace batten::editor
