/// The handlebar: a place of the active curve with its tangent, all of which can be dragged.
#pragma once

#include <optional>

#include "app/editor/pointer/gesture.h"
#include "app/editor/pointer/modes.h"

namespace batten::editor {

/// An end of the tangent.
struct HandlebarArm {
    double u = 0.0;  ///< where its derivative is taken; at the ends of a closed curve not that of the handlebar
    core::Side side = core::Side::right;
    double reach = 0.0;  ///< the tip is the place and so many times C'; negative behind it
    core::Point tip{};
};

struct Handlebar {
    double u = 0.0;
    core::Point place{};
    bool is_kinked = false;               ///< the arms are not in line
    std::optional<HandlebarArm> ahead{};  ///< none at the end of an open curve, and where the curve stands still
    std::optional<HandlebarArm> behind{};
};

/// The handlebar of `curve` at u: arms half as long as the legs of the Bézier piece over the span, from 20 to 160
/// design pixels; beside a leg of less than 40 they are 40 pixels long, or 20 longer than it. So they lie on no control
/// point where pieces meet. Those reaches are of the committed curve, and so stay while it is dragged. Cost O(p^2 + log
/// n).
Handlebar handlebar_of(const EditorState& state, const core::Curve& curve, double u);

/// The parameter of the p-fold knot where the curve runs through control point `index`; none where it need not.
std::optional<double> parameter_at_point(const core::Curve& curve, std::size_t index);

/// What is shown and can be dragged: with the select tool, of a curve that is visible and not made of points.
std::optional<Handlebar> shown_handlebar(const EditorState& state);

/// Where the part is; none where it is missing.
std::optional<core::Point> place_of(const Handlebar& bar, HandlebarPart part);

/// The part that is within `reach_px` of a place of the picture, the nearest one.
std::optional<HandlebarPart> handlebar_part_at(const EditorState& state, glm::dvec2 position_px, double reach_px);

}  // namespace batten::editor
