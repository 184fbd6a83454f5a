/// What a step of a lesson asks of the document, and whether it is so.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/editor/state/overlay.h"
#include "core/curve/curve_end.h"
#include "core/curve/knot_vector.h"
#include "core/measure/conic_form.h"

namespace batten::editor {

struct EditorState;

/// Whether a check holds, and a sentence that says what is so, and what is asked for where that is something else.
struct CheckResult {
    bool holds = false;
    std::string sentence;
};

/// How smooth a joint is: C where derivatives agree, G where tangent direction and curvature do.
enum class JointOrder { C0, C1, C2, G1, G2 };

/// What may be convex.
enum class ConvexShape { polygon, curve };

// Each is about the active curve, unless it says otherwise. Numbers of points and curves begin with 0.

struct DegreeIs {
    int is = 0;
};
struct PointCountIs {
    std::size_t is = 0;
};
struct SegmentCountIs {
    std::size_t is = 0;
};
struct CurveCountIs {  ///< of the document
    std::size_t is = 0;
};
struct MultiplicityIs {
    double knot = 0.0;
    int is = 0;
};
struct ContinuityIs {  ///< what the multiplicity of the knot promises, C^(p - m)
    double knot = 0.0;
    int is = 0;
};
struct NoInteriorKnot {};
struct KindIs {  ///< what the values of the knots say
    core::KnotKind is = core::KnotKind::custom;
};
struct PassesThrough {  ///< a control point of the curve, or a place where none is given
    std::optional<std::size_t> point{};
    core::Point at{};
    double within = 1e-6;
};
struct IsCircle {          ///< all of the curve is on one circle
    double within = 1e-6;  ///< of the radius
};
struct ConicIs {  ///< a quadratic of one piece
    core::ConicType is = core::ConicType::ellipse;
};
struct IsClosed {};
struct IsRational {
    bool is = true;
};
struct WeightIs {
    std::size_t point = 0;
    double is = 1.0;
    double within = 1e-9;
};
struct PointIsAt {
    std::size_t point = 0;
    core::Point at{};
    double within = 1e-6;
};
struct ParameterIs {
    double is = 0.0;
    double within = 1e-6;
};
struct OverlayIsShown {
    Overlay overlay = Overlay::polygon;
};
struct CurvesJoin {  ///< two curves of the document, by number, where their ends are nearest
    std::size_t first = 0;
    std::size_t second = 1;
    JointOrder order = JointOrder::C0;
    double within = 1e-6;  ///< as of SmoothnessIs, the size being that of both
};
struct PointsAreCollinear {
    std::vector<std::size_t> points;
    double within = 1e-6;  ///< of their extent
};
struct SmoothnessIs {  ///< what the shape has at the knot, at least
    double knot = 0.0;
    JointOrder order = JointOrder::C0;
    double within = 1e-6;  ///< of the curve's size, of its derivatives and curvature, and radians between tangents
};
struct IsClamped {                        ///< p + 1 equal knots
    std::optional<core::CurveEnd> end{};  ///< none: both ends
};
struct CrossingsAre {  ///< of the line of the view of variation diminishing, which must be shown
    std::optional<std::size_t> polygon{};
    std::optional<std::size_t> curve{};
};
struct IsConvex {
    ConvexShape of = ConvexShape::polygon;
};

using LessonCheck =
    std::variant<DegreeIs, PointCountIs, SegmentCountIs, CurveCountIs, MultiplicityIs, ContinuityIs, NoInteriorKnot,
                 KindIs, PassesThrough, IsCircle, ConicIs, IsClosed, IsRational, WeightIs, PointIsAt, ParameterIs,
                 OverlayIsShown, CurvesJoin, PointsAreCollinear, SmoothnessIs, IsClamped, CrossingsAre, IsConvex>;

/// Whether `check` holds for the committed document. Cost: at most that of a NearestFinder.
CheckResult result_of(const LessonCheck& check, const EditorState& state);

}  // namespace batten::editor

namespace batten::core {

template <>
struct Names<editor::JointOrder> {
    using enum editor::JointOrder;
    static constexpr std::array table{Named{C0, "C0", "C⁰"}, Named{C1, "C1", "C¹"}, Named{C2, "C2", "C²"},
                                      Named{G1, "G1", "G¹"}, Named{G2, "G2", "G²"}};
};

template <>
struct Names<editor::ConvexShape> {
    using enum editor::ConvexShape;
    static constexpr std::array table{Named{polygon, "polygon", "polygon"}, Named{curve, "curve", "curve"}};
};

}  // namespace batten::core
