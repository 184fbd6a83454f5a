/// The two ends of an open curve.
#pragma once

#include <array>

#include "core/base/geometry.h"
#include "core/base/names.h"

namespace batten::core {

enum class CurveEnd { start, end };

/// Where that end is in the domain.
inline double parameter_of(Interval domain, CurveEnd end) {
    return end == CurveEnd::start ? domain.lower : domain.upper;
}

/// An end of one curve and one of another.
struct JoinedEnds {
    CurveEnd first = CurveEnd::end;
    CurveEnd second = CurveEnd::start;

    bool operator==(const JoinedEnds&) const = default;
};

/// All that there are; first those with which the second curve keeps its direction.
inline constexpr std::array all_joined_ends{
    JoinedEnds{CurveEnd::end, CurveEnd::start}, JoinedEnds{CurveEnd::start, CurveEnd::end},
    JoinedEnds{CurveEnd::end, CurveEnd::end}, JoinedEnds{CurveEnd::start, CurveEnd::start}};

template <>
struct Names<CurveEnd> {
    static constexpr std::array table{Named{CurveEnd::start, "start", "start"}, Named{CurveEnd::end, "end", "end"}};
};

}  // namespace batten::core
