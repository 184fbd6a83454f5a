/// Commands on how the document is looked at.
#pragma once

#include "app/editor/command.h"
#include "app/editor/commands/overlay_commands.h"
#include "app/editor/state/notation.h"
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

/// Hides what is in the way of drawing, and thins control points that are close to one another; what was shown is
/// shown again afterward.
struct ToggleDrawing {
    static const CommandSpec& spec();
};

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

/// The keys that were pressed last, while presenting.
struct ToggleKeys {
    static const CommandSpec& spec();
};

/// The letters and numbers in which everything is told.
struct SetNotation {
    PointLetter points;
    ParameterLetter parameter;
    DegreeOrOrder degree;
    CellNumbering triangles;
    NumberStyle numbers;
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
