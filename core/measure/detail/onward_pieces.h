/// The Bézier pieces of a curve, cut where it comes to a stop and may turn back upon itself.
#pragma once

#include "core/evaluate/bezier_pieces.h"

namespace batten::core {

/// The pieces of `curve`, seen from `origin`, none of which passes over its own way: what turns by half a turn or more
/// is cut where its speed is zero. Cost: that of bezier_pieces, and for pieces that turn so far of their speed's zeros.
std::vector<BezierPiece> onward_pieces(const Curve& curve, Point origin);

}  // namespace batten::core
