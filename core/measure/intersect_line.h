/// Where a curve meets a straight line.
#pragma once

#include <limits>
#include <vector>

#include "core/base/names.h"
#include "core/curve/curve.h"

namespace batten::core {

/// How two curves behave where they meet.
enum class ContactKind {
    crossing,  ///< from one side to the other
    touching,  ///< the same side before and after
    ending     ///< the curve begins or ends there
};

template <>
struct Names<ContactKind> {
    static constexpr std::array table{Named{ContactKind::crossing, "crossing", "crosses"},
                                      Named{ContactKind::touching, "touching", "touches"},
                                      Named{ContactKind::ending, "ending", "ends there"}};
};

/// A place where a curve meets a line.
struct LineContact {
    Interval where;      ///< one parameter, or the whole of a piece that lies in the line
    double u = 0.0;      ///< the middle of `where`
    Point point{};       ///< C(u)
    double along = 0.0;  ///< where on the line: 0 at its first point, 1 at its second
    ContactKind kind = ContactKind::crossing;
};

/// A place where a control polygon passes from one side of a line to the other.
struct LegCrossing {
    std::size_t leg = 0;  ///< from control point `leg`, beside the line, to the next one
    Point point{};        ///< where it passes the line; of control points in the line, the middle of first and last
    double along = 0.0;   ///< where on the line, as above
};

/// All that a line has in common with a curve and with its control polygon.
struct LineContacts {
    std::vector<LineContact> contacts;    ///< in order of u
    std::size_t crossings = 0;            ///< of the curve
    std::vector<LegCrossing> on_polygon;  ///< in order of the legs; that of a closed polygon closes
    std::size_t polygon_crossings = 0;    ///< of the control polygon, never fewer (variation diminishing)
    bool is_complete = true;  ///< else the spans were too many: no contacts, and places on the polygon only of some
};

inline constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

/// The contacts with the infinite line through `a` and `b`, all of them: each once, tangential ones
/// too, a straight piece in the line as one interval. Where the ends of the curve meet they count as one place, and an
/// interval across the seam is given unwrapped. Gaps of a torn curve are no contacts. A control point in the line is no
/// crossing of the polygon by itself: it counts, once, with what is before and after it on different sides. Where more
/// than `most_spans` spans have control points on both sides, these are not looked at. Cost: one look at each control
/// point, and a search in each such span. Error: points_coincide.
[[nodiscard]] Result<LineContacts> intersect_line(const Curve& curve, Point a, Point b,
                                                  std::size_t most_spans = any_number);

/// The contacts with the segment from `a` to `b` only. A straight piece in the line counts as far as the segment
/// reaches. The crossings of the polygon are those of the segment as well and so no bound. Error: points_coincide.
[[nodiscard]] Result<LineContacts> intersect_segment(const Curve& curve, Point a, Point b);

}  // namespace batten::core
