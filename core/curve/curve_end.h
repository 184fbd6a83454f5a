/// The two ends of an open curve.
#pragma once

namespace batten::core {

enum class CurveEnd { start, end };

}  // namespace batten::core
