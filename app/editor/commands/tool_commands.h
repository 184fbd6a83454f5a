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

/// One command for each shape, which takes the shape tool to draw it.
const CommandSpec& draw_shape_spec(ShapeKind kind);

template <ShapeKind kind>
struct DrawShape {
    static const CommandSpec& spec() { return draw_shape_spec(kind); }
};

/// How many sides the shape tool's polygons have.
struct SetPolygonSides {
    std::size_t sides;
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
template <>
const CommandSpec& TakeTool<Tool::shape>::spec();
template <>
const CommandSpec& TakeTool<Tool::pencil>::spec();
template <>
const CommandSpec& TakeTool<Tool::joint>::spec();
template <>
const CommandSpec& TakeTool<Tool::brush>::spec();
template <>
const CommandSpec& TakeTool<Tool::transform>::spec();

/// The description of the command that takes `tool`.
const CommandSpec& take_tool_spec(Tool tool);

}  // namespace batten::editor
