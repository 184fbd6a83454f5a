/// What changes how the document is looked at without being a command: neither undone nor logged, since it happens
/// every frame or follows the window. A plain variant beside the command table.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <variant>
#include <vector>

#include "app/editor/state/placing.h"
#include "app/editor/state/recoverable.h"
#include "app/editor/state/selection.h"
#include "app/editor/state/view.h"
#include "core/base/geometry.h"

namespace batten::editor {

struct CommandSpec;
struct EditorState;

/// The pointer is over something; over nothing where the shown curve does not have it.
struct SetHover {
    Hover hover;
};

/// A gesture puts something there; none: it is over, and what was typed for it is gone.
struct ShowPlace {
    std::optional<ShownPlace> place;
};

/// This is typed for the place of a gesture.
struct TypePlace {
    TypedPlace typed;
};

struct PanCamera {
    glm::dvec2 offset_px;
};

/// Enlarges the picture by `factor` (> 0) around a pixel.
struct ZoomCamera {
    double factor;
    glm::dvec2 anchor_px;
};

/// What was in view stays in view, and comes back as it was with the size; a fitted camera is fitted anew.
struct ResizeCanvas {
    glm::dvec2 size_px;
};

/// The legend stands in this corner; which one is best, free_corner() tells.
struct PlaceLegend {
    Corner corner;
};

/// So many pixels of the window make a design pixel.
struct SetInterfaceScale {
    double scale;
};

struct SetInspectorWidth {
    double width;  ///< design pixels
};

struct SetCardsWidth {
    double width;  ///< design pixels
};

struct SetDockHeight {
    double height;  ///< design pixels
};

/// The lifted curve is turned by a drag of so many design pixels, and enlarged by a factor (> 0).
struct TurnOrbit {
    glm::dvec2 drag{0.0, 0.0};
    double factor = 1.0;
};

/// The plot shows these parameters; not an empty interval.
struct SetPlotRange {
    core::Interval range;
};

/// The teeth of the comb are so many times as long as by themselves.
struct SetCombFactor {
    double factor;
};

/// The line whose crossings are shown; of different points.
struct SetProbeLine {
    ProbeLine line;
};

/// The brush is so large, in design pixels.
struct SetBrushRadius {
    double radius;
};

/// So many seconds (>= 0) went by, in which a running parameter moves on.
struct Advance {
    double seconds;
};

/// The clock of the desktop stands at so many seconds.
struct TellTime {
    double seconds;
};

/// Why something that was asked for could not even become a command.
struct ShowRefusal {
    std::string sentence;
    bool is_alarm = true;  ///< false where there just is nothing to do
};

/// Opens the form that asks for the fields of a command.
struct ShowForm {
    const CommandSpec* spec;
};

/// A point of the picture that is to be scaled was clicked.
struct AddGaugePoint {
    core::Point point;
};

/// The pivot of the transform box is there; none: it is where it is by itself.
struct SetPivot {
    std::optional<core::Point> point;
};

/// The first of two points of an axis was clicked; none takes it back.
struct SetAxisPoint {
    std::optional<core::Point> point;
};

/// The axis, or the center, is chosen.
struct EndAxisPick {};

/// These documents were found that sessions left unsaved.
struct OfferRecovery {
    std::vector<Recoverable> recoverable;
};

using ViewChange = std::variant<SetHover, ShowPlace, TypePlace, PanCamera, ZoomCamera, ResizeCanvas, PlaceLegend,
                                SetInterfaceScale, SetInspectorWidth, SetCardsWidth, SetDockHeight, SetPlotRange,
                                SetCombFactor, SetProbeLine, TurnOrbit, AddGaugePoint, SetBrushRadius, SetPivot,
                                SetAxisPoint, EndAxisPick, Advance, TellTime, ShowRefusal, ShowForm, OfferRecovery>;

/// Makes the change; sizes are brought into their ranges.
void apply(EditorState& state, const ViewChange& change);

}  // namespace batten::editor
