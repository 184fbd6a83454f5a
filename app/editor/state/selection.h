/// What is selected, and what the pointer is over.
#pragma once

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "app/editor/state/transform_grip.h"

namespace batten::editor {

/// What of one curve is selected: some of its control points, or the curve as a whole.
struct SelectedPart {
    std::size_t curve = 0;              ///< its index in the document
    std::vector<std::size_t> points{};  ///< ascending, without repeats; none where the curve is selected as a whole

    bool is_whole() const { return points.empty(); }
    bool operator==(const SelectedPart&) const = default;
};

/// Parts of the active curve, and beside it of others, that commands without arguments act on. See selected_parts.h.
struct Selection {
    std::vector<std::size_t> points;         ///< indices of control points, ascending, without repeats
    std::optional<std::size_t> knot;         ///< index in KnotVector::stored()
    std::optional<std::size_t> fit_point{};  ///< of the points that the curve is made to pass
    bool is_whole = false;                   ///< the active curve as a whole; no points then
    std::vector<SelectedPart> others{};      ///< of the curves that are not active, ascending by curve
    std::optional<double> handlebar{};       ///< the parameter at which the curve is held

    bool contains_point(std::size_t i) const;

    /// Whether nothing is selected that could be deleted or moved; a handlebar only holds the curve.
    bool is_empty() const { return points.empty() && !knot && !fit_point && !is_over_curves(); }

    /// Whether more is selected than points, or a knot, of the active curve.
    bool is_over_curves() const { return is_whole || !others.empty(); }
    bool operator==(const Selection&) const = default;
};

struct HoveredNothing {
    bool operator==(const HoveredNothing&) const = default;
};
struct HoveredPoint {  ///< a control point of the active curve
    std::size_t index = 0;
    bool operator==(const HoveredPoint&) const = default;
};
struct HoveredWeightRing {  ///< the ring around a control point that changes its weight
    std::size_t index = 0;
    bool operator==(const HoveredWeightRing&) const = default;
};
struct HoveredKnot {  ///< a knot, by the index in stored() of the topmost of its stack
    std::size_t index = 0;
    bool operator==(const HoveredKnot&) const = default;
};
struct HoveredSpan {  ///< a non-empty span [u_s, u_{s+1}), s an index in values()
    std::size_t span = 0;
    bool operator==(const HoveredSpan&) const = default;
};
struct HoveredCell {  ///< cell j of level r of the construction
    std::size_t level = 0;
    std::size_t index = 0;
    bool operator==(const HoveredCell&) const = default;
};
struct HoveredParameter {  ///< the point C(u), or the line at u in the plot
    bool operator==(const HoveredParameter&) const = default;
};
struct HoveredCurve {  ///< the active curve at u
    double u = 0.0;
    bool operator==(const HoveredCurve&) const = default;
};
struct HoveredLeg {  ///< the leg of the control polygon from point `index` to the next
    std::size_t index = 0;
    bool operator==(const HoveredLeg&) const = default;
};
struct HoveredOtherCurve {  ///< a curve of the document that is not active
    std::size_t index = 0;
    bool operator==(const HoveredOtherCurve&) const = default;
};
struct HoveredOtherPoint {  ///< a control point of a curve that is not active, which is shown
    std::size_t curve = 0;
    std::size_t index = 0;
    bool operator==(const HoveredOtherPoint&) const = default;
};
/// What of a teaching view can be dragged: the comb's length, the ends of the line, and the line.
enum class ViewHandle { comb, line_first, line_second, line };
struct HoveredHandle {
    ViewHandle handle = ViewHandle::comb;
    bool operator==(const HoveredHandle&) const = default;
};
struct HoveredBasis {  ///< the graph of N_{i,p} in the plot
    std::size_t index = 0;
    bool operator==(const HoveredBasis&) const = default;
};
struct HoveredBasisCell {      ///< N_{i,k} in the triangle of the recurrence
    std::size_t function = 0;  ///< i, by the knots of values()
    std::size_t degree = 0;    ///< k
    bool operator==(const HoveredBasisCell&) const = default;
};
struct HoveredFarinPoint {  ///< the Farin point on the leg from point `leg` to the next
    std::size_t leg = 0;
    bool operator==(const HoveredFarinPoint&) const = default;
};
struct HoveredLifted {  ///< the inset of the lifted curve, and a control point or else a place of the curve in it
    std::optional<std::size_t> index;
    std::optional<double> u{};
    bool operator==(const HoveredLifted&) const = default;
};
struct HoveredHodograph {  ///< the inset of a derivative, and a control point or else a place of the curve in it
    std::size_t order = 1;
    std::optional<std::size_t> index;
    std::optional<double> u{};
    bool operator==(const HoveredHodograph&) const = default;
};
struct HoveredGuide {  ///< a guide of the document
    std::size_t index = 0;
    bool operator==(const HoveredGuide&) const = default;
};

/// The rulers, by the direction in which they measure.
enum class RulerAxis { x, y };
struct HoveredRuler {  ///< out of which guides are dragged
    RulerAxis axis = RulerAxis::x;
    bool operator==(const HoveredRuler&) const = default;
};

struct HoveredGrip {  ///< of the transform box
    TransformGrip grip;
    bool operator==(const HoveredGrip&) const = default;
};

struct HoveredPicture {  ///< a picture that can be dragged
    std::size_t index = 0;
    bool operator==(const HoveredPicture&) const = default;
};

struct HoveredFitPoint {  ///< a point that the active curve is made to pass
    std::size_t index = 0;
    bool operator==(const HoveredFitPoint&) const = default;
};
/// An end of the handle of a fit point with a given tangent: the one ahead of the point, or the one behind it.
enum class HandleEnd { ahead, behind };
struct HoveredFitHandle {
    std::size_t index = 0;  ///< of the fit point
    HandleEnd end = HandleEnd::ahead;
    bool operator==(const HoveredFitHandle&) const = default;
};

/// The bar that holds the curve at a parameter: its middle, which is on the curve, or an end of its tangent.
enum class HandlebarPart { middle, ahead, behind };
struct HoveredHandlebar {
    HandlebarPart part = HandlebarPart::middle;
    bool operator==(const HoveredHandlebar&) const = default;
};

using Hover =
    std::variant<HoveredNothing, HoveredPoint, HoveredWeightRing, HoveredKnot, HoveredSpan, HoveredCell,
                 HoveredParameter, HoveredCurve, HoveredLeg, HoveredOtherCurve, HoveredBasis, HoveredBasisCell,
                 HoveredHandle, HoveredFarinPoint, HoveredLifted, HoveredHodograph, HoveredFitPoint, HoveredFitHandle,
                 HoveredGuide, HoveredOtherPoint, HoveredHandlebar, HoveredRuler, HoveredGrip, HoveredPicture>;

/// The parameter of the active curve that the pointer is on, on the curve itself or in an inset; none elsewhere.
std::optional<double> hovered_u(const Hover& hover);

/// The leg of the control polygon that the pointer is on, or on whose derivative it is; none elsewhere.
std::optional<std::size_t> hovered_leg(const Hover& hover);

}  // namespace batten::editor
