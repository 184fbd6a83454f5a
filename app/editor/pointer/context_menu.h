/// What a right click offers, by the thing under the pointer: commands of the table, their fields filled in.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/editor/command_spec.h"
#include "app/editor/state/state.h"

namespace batten::editor {

struct OnCanvas {
    Hover hit;
    core::Point position;  ///< in the plane of the curves
};

struct OnPlot {
    Hover hit;
    double u = 0.0;
};

/// A row of the inspector or a cell of the construction that stands for a part of the active curve.
struct OnPart {
    Hover hit;
};

/// A row of the list of curves.
struct OnCurve {
    std::size_t index = 0;
};

/// A row of the results shown.
struct OnFinding {
    std::size_t index = 0;
    std::string text;  ///< all that is known of it
};

struct OnText {
    std::string text;
};

struct OnTitleLine {};
struct OnToolBar {};

/// The button of the shape tool, which offers the shapes.
struct OnShapes {};

/// The choice of what the pen draws.
struct OnPens {};

/// The button of the joint tool, which offers what it can do.
struct OnJoints {};

/// The button of the brush, which offers what it can do.
struct OnBrushes {};

/// The button that tells what the pointer snaps to.
struct OnSnapping {};

/// Anywhere else in the interface.
struct OnPanel {};

using MenuTarget = std::variant<OnPanel, OnCanvas, OnPlot, OnPart, OnCurve, OnFinding, OnText, OnTitleLine, OnToolBar,
                                OnShapes, OnPens, OnJoints, OnBrushes, OnSnapping>;

/// One line of the menu.
struct MenuEntry {
    const CommandSpec* spec;
    std::optional<Command> command{};  ///< none: with what suggests itself, or by its form
    bool begins_group = false;
    bool stays_open = false;  ///< the menu, since several of its lines are wanted at once
};

/// Selects the control point or knot that the menu is about, unless it is selected already, or activates the curve.
void select_for_menu(const EditorState& state, const MenuTarget& target, CommandQueue& queue);

/// What applies to the target, as far as it is still there; never empty.
std::vector<MenuEntry> context_menu(const EditorState& state, const MenuTarget& target);

}  // namespace batten::editor
