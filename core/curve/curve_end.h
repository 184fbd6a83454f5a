/// The two ends of an open curve.
#pragma once

#include "core/base/names.h"

namespace batten::core {

enum class CurveEnd { start, end };

template <>
struct Names<CurveEnd> {
    static constexpr std::array table{Named{CurveEnd::start, "start", "start"}, Named{CurveEnd::end, "end", "end"}};
};

}  // namespace batten::core
