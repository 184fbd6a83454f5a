/// Joints of curves that are marked, so that edits keep them as they are.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/base/names.h"
#include "core/curve/curve.h"
#include "core/curve/curve_end.h"

namespace batten::core {

/// What is kept at a joint.
enum class JointMark {
    corner,    ///< nothing but the place, where ends meet
    smooth,    ///< the direction (G1)
    curvature  ///< the direction and the curvature (G2)
};

/// A knot inside the domain of a curve, or the seam of a periodic one at the lower end of its domain.
struct KnotMark {
    double u = 0.0;
    JointMark mark = JointMark::smooth;
    std::string unknown_members{};  ///< that this version does not know, as a JSON object; empty if none
    bool operator==(const KnotMark&) const = default;
};

/// An end of a curve, which meets the other end in the document that has the same number.
struct EndMark {
    CurveEnd end = CurveEnd::end;
    std::size_t joint = 0;
    JointMark mark = JointMark::smooth;
    std::string unknown_members{};  ///< likewise
    bool operator==(const EndMark&) const = default;
};

/// What is marked of one curve.
struct JointMarks {
    std::vector<KnotMark> knots{};  ///< ascending, each once
    std::vector<EndMark> ends{};    ///< at most one for each end, the start first; none of a periodic curve

    bool is_empty() const { return knots.empty() && ends.empty(); }
    bool operator==(const JointMarks&) const = default;
};

/// Whether u is a knot inside the domain, or the seam of a periodic curve at its lower end: where a KnotMark can be.
bool is_inner_knot(const Curve& curve, double u);

template <>
struct Names<JointMark> {
    using enum JointMark;
    static constexpr std::array table{Named{corner, "corner", "corner"}, Named{smooth, "smooth", "smooth (G1)"},
                                      Named{curvature, "curvature", "curvature-smooth (G2)"}};
};

}  // namespace batten::core
