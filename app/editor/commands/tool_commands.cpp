#include "app/editor/commands/tool_commands.h"

#include <array>
#include <utility>

#include "app/editor/commands/groups.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/state/state.h"

namespace batten::editor {

namespace {

template <Tool tool>
Outcome<void> take(EditorState& state, const TakeTool<tool>&) {
    take_tool(state, tool);
    return {};
}

template <Tool tool>
bool is_taken(const EditorState& state) {
    return state.tool == tool;
}

template <Tool tool>
CommandSpec taking(const char* name, const char* title, const char* explanation, Key key) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .synonyms = "tool",
            .group = CommandGroup::edit,
            .submenu = "Tools",
            .offered = {.scripts = false, .key_sheet = false},
            .shortcut = {key, {}},
            .is_checked = is_taken<tool>,
            .run = body_of<take<tool>>};
}

Outcome<void> set_tool(EditorState& state, const SetTool& command) {
    take_tool(state, command.tool);
    return {};
}

Tool current_tool(const EditorState& state) {
    return state.tool;
}

constexpr const char* drawing_menu = "Draw on the canvas";
constexpr double most_polygon_sides = 1000.0;

/// What is said of a shape where it is chosen.
struct ShapeText {
    ShapeKind kind;
    const char* command;
    const char* title;
    const char* explanation;
};

constexpr std::array<ShapeText, shape_kind_count> shape_texts = [] {
    using enum ShapeKind;
    return std::array<ShapeText, shape_kind_count>{{
        {line, "draw-line", "Line", "Draws a line from end to end."},
        {rectangle, "draw-rectangle", "Rectangle", "Draws a rectangle from corner to corner."},
        {polygon, "draw-polygon", "Regular polygon", "Draws a regular polygon from its center to a corner."},
        {circle, "draw-circle", "Circle", "Draws a circle from its center."},
        {circle_through_points, "draw-circle-3", "Circle through three points",
         "Draws the circle through three places."},
        {arc, "draw-arc", "Arc by its center", "Draws an arc by its center, its start and its end."},
        {arc_through_points, "draw-arc-3", "Arc through three points",
         "Draws an arc by its start, its end and a place between."},
        {ellipse, "draw-ellipse", "Ellipse", "Draws an ellipse by its center, the end of an axis and its width."},
        {conic, "draw-conic", "Conic", "Draws a conic by its ends, the corner of its tangents and its height."},
    }};
}();

template <ShapeKind kind>
Outcome<void> draw_shape(EditorState& state, const DrawShape<kind>&) {
    if (state.view.shape_kind != kind) take_tool(state, Tool::select);  // leaves a shape half drawn
    state.view.shape_kind = kind;
    take_tool(state, Tool::shape);
    return {};
}

template <ShapeKind kind>
bool is_drawn(const EditorState& state) {
    return state.tool == Tool::shape && state.view.shape_kind == kind;
}

template <std::size_t index>
CommandSpec drawing() {
    constexpr ShapeText text = shape_texts[index];
    static_assert(text.kind == static_cast<ShapeKind>(index));
    return {.name = text.command,
            .title = text.title,
            .explanation = text.explanation,
            .synonyms = "tool shape click draw",
            .group = CommandGroup::make,
            .submenu = drawing_menu,
            .offered = in_the_window,
            .is_checked = is_drawn<text.kind>,
            .run = body_of<draw_shape<text.kind>>};
}

template <std::size_t... index>
std::array<CommandSpec, shape_kind_count> all_shape_specs(std::index_sequence<index...>) {
    return {drawing<index>()...};
}

Outcome<void> set_polygon_sides(EditorState& state, const SetPolygonSides& command) {
    state.view.polygon_sides = command.sides;
    return {};
}

std::size_t polygon_sides(const EditorState& state) {
    return state.view.polygon_sides;
}

}  // namespace

template <>
const CommandSpec& TakeTool<Tool::select>::spec() {
    static const CommandSpec spec =
        taking<Tool::select>("tool-select", "Select and move", "Selects and drags control points and knots.", Key::v);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::add_point>::spec() {
    static const CommandSpec spec = taking<Tool::add_point>(
        "tool-add-point", "Add points", "Adds a control point where you click on the polygon.", Key::a);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::insert_knot>::spec() {
    static const CommandSpec spec =
        taking<Tool::insert_knot>("tool-insert-knot", "Insert knots",
                                  "Inserts a knot where you click on the curve, which stays as it is.", Key::k);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::weight>::spec() {
    static const CommandSpec spec = taking<Tool::weight>("tool-weight", "Change weights",
                                                         "Changes the weight of the control point you drag.", Key::w);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::draw_curve>::spec() {
    static const CommandSpec spec = taking<Tool::draw_curve>(
        "tool-draw-curve", "Draw curve",
        "Draws a new curve, one click for each point; the pen's modes say what these are.", Key::n);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::parameter>::spec() {
    static const CommandSpec spec =
        taking<Tool::parameter>("tool-parameter", "Move parameter", "Drags the parameter u along the curve.", Key::u);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::shape>::spec() {
    static const CommandSpec spec = taking<Tool::shape>(
        "tool-shape", "Draw shape", "Draws a line, circle, arc or other shape by clicks and typed numbers.", Key::s);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::joint>::spec() {
    static const CommandSpec spec = taking<Tool::joint>(
        "tool-joint", "Join curves", "Joins, matches, blends, rounds, trims and extends curves by clicks.", Key::j);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::brush>::spec() {
    static const CommandSpec spec = taking<Tool::brush>(
        "tool-brush", "Brush", "Moves points softly, or fairs what is painted over, within a circle.", Key::e);
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::transform>::spec() {
    static const CommandSpec spec = taking<Tool::transform>("transform-box", "Transform",
                                                            "Scales, turns, shears and moves what is selected by the "
                                                            "handles of a box around it.",
                                                            Key::r);
    return spec;
}

const CommandSpec& draw_shape_spec(ShapeKind kind) {
    static const std::array<CommandSpec, shape_kind_count> specs =
        all_shape_specs(std::make_index_sequence<shape_kind_count>());
    return specs[static_cast<std::size_t>(kind)];
}

const CommandSpec& SetPolygonSides::spec() {
    static const CommandSpec spec{.name = "set-polygon-sides",
                                  .title = "Set sides of polygons",
                                  .explanation = "Sets how many sides the shape tool's polygons have.",
                                  .group = CommandGroup::make,
                                  .submenu = drawing_menu,
                                  .offered = in_the_window,
                                  .fields = {field::count<&SetPolygonSides::sides>("sides", "how many, 3 or more")
                                                 .beginning_with<polygon_sides>()
                                                 .at_least(3.0)
                                                 .at_most(most_polygon_sides)},
                                  .run = body_of<set_polygon_sides>};
    return spec;
}

template <>
const CommandSpec& TakeTool<Tool::pencil>::spec() {
    static const CommandSpec spec = taking<Tool::pencil>(
        "tool-pencil", "Pencil", "Draws a smooth curve along a stroke of the hand, or a part of a curve anew.", Key::d);
    return spec;
}

const CommandSpec& SetTool::spec() {
    static const CommandSpec spec{
        .name = "set-tool",
        .title = "Set tool",
        .explanation = "Takes a tool by its name.",
        .group = CommandGroup::edit,
        .offered = {.menu = false, .scripts = false},
        .fields = {field::choice<&SetTool::tool>("tool", "which tool").beginning_with<current_tool>()},
        .run = body_of<set_tool>};
    return spec;
}

const CommandSpec& take_tool_spec(Tool tool) {
    switch (tool) {
        case Tool::select:
            return TakeTool<Tool::select>::spec();
        case Tool::add_point:
            return TakeTool<Tool::add_point>::spec();
        case Tool::insert_knot:
            return TakeTool<Tool::insert_knot>::spec();
        case Tool::weight:
            return TakeTool<Tool::weight>::spec();
        case Tool::draw_curve:
            return TakeTool<Tool::draw_curve>::spec();
        case Tool::pencil:
            return TakeTool<Tool::pencil>::spec();
        case Tool::parameter:
            return TakeTool<Tool::parameter>::spec();
        case Tool::shape:
            return TakeTool<Tool::shape>::spec();
        case Tool::joint:
            return TakeTool<Tool::joint>::spec();
        case Tool::brush:
            return TakeTool<Tool::brush>::spec();
        case Tool::transform:
            break;
    }
    return TakeTool<Tool::transform>::spec();
}

void add_tool_commands(CommandTable& table) {
    for (const Tool tool : all_tools) table.emplace_back(take_tool_spec(tool));
    for (std::size_t i = 0; i < shape_kind_count; ++i) table.emplace_back(draw_shape_spec(static_cast<ShapeKind>(i)));
    add_all<SetPolygonSides, SetTool>(table);
}

}  // namespace batten::editor
