/// Commands on how the document is looked at.
#pragma once

#include "app/editor/command.h"
#include "app/editor/view.h"
#include "core/edit/knot_edit.h"

namespace batten::editor {

struct FitView {
    static const CommandSpec& spec();
};

struct ZoomIn {
    static const CommandSpec& spec();
};

struct ZoomOut {
    static const CommandSpec& spec();
};

/// One command for each overlay, for its shortcut and its switch.
template <Overlay overlay>
struct ToggleOverlay {
    static const CommandSpec& spec();
};

template <>
const CommandSpec& ToggleOverlay<Overlay::polygon>::spec();
template <>
const CommandSpec& ToggleOverlay<Overlay::hull>::spec();
template <>
const CommandSpec& ToggleOverlay<Overlay::bezier_pieces>::spec();
template <>
const CommandSpec& ToggleOverlay<Overlay::curvature_comb>::spec();
template <>
const CommandSpec& ToggleOverlay<Overlay::knots>::spec();
template <>
const CommandSpec& ToggleOverlay<Overlay::hodograph>::spec();
template <>
const CommandSpec& ToggleOverlay<Overlay::labels>::spec();
template <>
const CommandSpec& ToggleOverlay<Overlay::grid>::spec();
template <>
const CommandSpec& ToggleOverlay<Overlay::construction>::spec();

/// The description of the command that shows or hides `overlay`.
const CommandSpec& toggle_overlay_spec(Overlay overlay);

struct ToggleTheme {
    static const CommandSpec& spec();
};

struct ScaleUp {
    static const CommandSpec& spec();
};

struct ScaleDown {
    static const CommandSpec& spec();
};

struct ResetScale {
    static const CommandSpec& spec();
};

struct ToggleInspector {
    static const CommandSpec& spec();
};

struct ToggleDock {
    static const CommandSpec& spec();
};

/// The title and the sentence of the document, above the canvas.
struct ToggleTitle {
    static const CommandSpec& spec();
};

struct TogglePresenting {
    static const CommandSpec& spec();
};

struct FitPlot {
    static const CommandSpec& spec();
};

struct SetKnotMove {
    core::KnotMove mode;
    static const CommandSpec& spec();
};

}  // namespace batten::editor
