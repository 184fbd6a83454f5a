#include "app/editor/view.h"

#include <array>

namespace batten::editor {

namespace {

constexpr std::array<const char*, overlay_count> overlay_names{
    "polygon", "hull", "bezier-pieces", "curvature-comb", "knots", "hodograph", "labels", "grid", "construction"};

constexpr std::array<const char*, all_tools.size()> tool_names{"select", "add-point",  "insert-knot",
                                                               "weight", "draw-curve", "parameter"};

constexpr std::array<const char*, 3> knot_move_names{"stop", "push", "snap"};

constexpr std::array<const char*, 2> theme_names{"dark", "light"};

template <class Value, std::size_t count>
std::optional<Value> named(const std::array<const char*, count>& names, const std::string& name) {
    for (std::size_t i = 0; i < count; ++i)
        if (name == names[i]) return static_cast<Value>(i);
    return std::nullopt;
}

}  // namespace

const char* name_of(Overlay overlay) {
    return overlay_names[static_cast<std::size_t>(overlay)];
}

std::optional<Overlay> overlay_named(const std::string& name) {
    return named<Overlay>(overlay_names, name);
}

const char* name_of(Tool tool) {
    return tool_names[static_cast<std::size_t>(tool)];
}

std::optional<Tool> tool_named(const std::string& name) {
    return named<Tool>(tool_names, name);
}

const char* name_of(core::KnotMove move) {
    return knot_move_names[static_cast<std::size_t>(move)];
}

std::optional<core::KnotMove> knot_move_named(const std::string& name) {
    return named<core::KnotMove>(knot_move_names, name);
}

const char* name_of(ThemeName theme) {
    return theme_names[static_cast<std::size_t>(theme)];
}

std::optional<ThemeName> theme_named(const std::string& name) {
    return named<ThemeName>(theme_names, name);
}

}  // namespace batten::editor
