/// Pointer modes of the canvas: one small struct for each thing that a drag can be about.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "app/editor/command.h"
#include "app/editor/pointer/brush_mode.h"
#include "app/editor/pointer/drawing_mode.h"
#include "app/editor/pointer/fit_point_mode.h"
#include "app/editor/pointer/guide_mode.h"
#include "app/editor/pointer/handlebar_mode.h"
#include "app/editor/pointer/joint_mode.h"
#include "app/editor/pointer/pencil_mode.h"
#include "app/editor/pointer/picture_mode.h"
#include "app/editor/pointer/pointer.h"
#include "app/editor/pointer/selection_mode.h"
#include "app/editor/pointer/shape_mode.h"
#include "app/editor/pointer/transform_mode.h"
#include "app/editor/pointer/view_handle.h"
#include "app/editor/state/state.h"

namespace batten::editor {

struct CanvasIdle {};

/// The second press of a double click, which does what it does when it is released. A drag is that of a single press.
struct DoubleClicking {
    PointerEvent press;
};

/// The selected points follow the pointer. Ctrl snaps the grabbed point to the grid, Shift keeps to one axis.
struct DraggingPoints {
    std::size_t grabbed = 0;
    std::vector<std::size_t> indices;
    glm::dvec2 press_px{};
    bool was_selected = false;  ///< before the press; a mere click then selects it alone, or with Shift takes it out
    bool has_moved = false;
};

/// A weight grows by a factor for each pixel that the pointer moves up or to the right (by the square root of ten for
/// 100 design pixels) and shrinks by it down or to the left, so that 0.01 and 100 are equally far. It stays within
/// 1e-6..1e6.
struct DraggingWeight {
    std::size_t index = 0;
    double start_weight = 1.0;
    glm::dvec2 press_px{};
    bool has_moved = false;
};

struct BoxSelecting {
    glm::dvec2 press_px{};
    glm::dvec2 position_px{};
    std::vector<SelectedPart> before;    ///< kept when Shift is held
    std::optional<std::size_t> curve{};  ///< that was pressed on
    bool takes_all_curves = false;       ///< else points of the active one
};

struct Panning {
    glm::dvec2 last_px{};
};

/// C(u) follows the pointer along the curve.
struct DraggingParameter {
    double start = 0.0;
};

/// A knot's diamond dragged along the curve.
struct DraggingCurveKnot {
    std::size_t index = 0;  ///< in stored() of the committed curve
    glm::dvec2 press_px{};
    bool has_moved = false;
};

/// The point of the curve that was grabbed follows the pointer, with the least change of the control points. Ctrl snaps
/// it to the grid, Shift keeps to one axis.
struct DraggingCurvePoint {
    double u = 0.0;
    glm::dvec2 press_px{};
    bool has_moved = false;
};

/// A handle of a teaching view follows the pointer. Escape puts it back.
struct DraggingHandle {
    HandleStart start;
    glm::dvec2 press_px{};
};

/// A Farin point dragged along its leg. With Ctrl it keeps to twelfths of it.
struct DraggingFarinPoint {
    std::size_t leg = 0;
    glm::dvec2 press_px{};
    bool has_moved = false;
};

/// A lifted control point dragged along its ray in the homogeneous view, which changes its weight.
struct DraggingLiftedWeight {
    std::size_t index = 0;
    glm::dvec2 press_px{};
    bool has_moved = false;
};

/// The homogeneous view turned.
struct TurningOrbit {
    glm::dvec2 last_px{};
};

using CanvasMode =
    std::variant<CanvasIdle, DraggingPoints, DraggingWeight, BoxSelecting, Panning, DraggingParameter,
                 DraggingCurveKnot, DraggingCurvePoint, DraggingHandle, DraggingFarinPoint, DraggingLiftedWeight,
                 TurningOrbit, DrawingCurve, DraggingFitPoint, DraggingFitHandle, DrawingShape, DraggingGuide,
                 PullingGuide, DraggingTransform, DraggingPicture, PencilStroke, PickingJoint, DraggingSelection,
                 DraggingHandlebar, Brushing, DoubleClicking>;

/// The mode that is left where the tool was changed without the pointer: a curve that is being drawn ends with its last
/// point, which is asked of `queue`; what else is half done is given up.
CanvasMode with_present_tool(CanvasMode mode, const EditorState& state, CommandQueue& queue);

/// The mode after `event`; what it asks of the editor goes to `queue`. Pure: depends on its arguments only. A gesture
/// previews on every move and commits once on release; Escape cancels the preview. A press that moves less than 3
/// design pixels is a click.
CanvasMode step_canvas(const CanvasMode& mode, const PointerEvent& event, const EditorState& state,
                       CommandQueue& queue);

/// Whether nothing is held or half done, so that a menu interrupts nothing; tools may show what a click would do.
bool is_at_rest(const CanvasMode& mode);

/// Whether Enter, Backspace and Ctrl+Z are about what is being clicked together, and not about the document.
bool listens_to_drawing_keys(const CanvasMode& mode, const EditorState& state);

/// What a click or drag would do here, for the status bar: "Drag P₅ to move it · hold Alt to change its weight".
std::string canvas_hint(const CanvasMode& mode, const EditorState& state);

}  // namespace batten::editor
