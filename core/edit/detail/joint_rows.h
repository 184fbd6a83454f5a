/// The conditions of joints on the moves of control points, to first order, and the shortest moves that meet them.
#pragma once

#include <optional>
#include <vector>

#include "core/edit/detail/joint_arms.h"

namespace batten::core {

/// sum of gradients[j] . move[j] = -miss.
struct MendRow {
    std::vector<Vector> gradients;
    double miss = 0.0;
};

/// What one joint asks of its points, of which those that are free can move: the places of both arms on `place`, or
/// together where none is given, and what the level says.
std::vector<MendRow> rows_of(const JointArms& arms, const std::vector<Point>& points, const std::vector<bool>& is_free,
                             int level, std::optional<Point> place);

/// The moves of `count` points with the least sum of squares that meet all rows; of rows that contradict others the
/// first count.
std::vector<Vector> shortest_moves(std::vector<MendRow> rows, std::size_t count);

}  // namespace batten::core
