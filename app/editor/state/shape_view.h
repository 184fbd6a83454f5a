/// What the views of a curve's shape are set to.
#pragma once

#include <optional>

#include "app/editor/state/probe_line.h"

namespace batten::editor {

/// What the comb may be lengthened by, and how many parts there may be.
inline constexpr core::Interval comb_factors{1.0 / 64.0, 64.0};
inline constexpr int least_part_count = 1;
inline constexpr int most_part_count = 200;

struct ShapeView {
    double comb_factor = 1.0;       ///< how many times longer than by themselves the teeth of the comb are
    int part_count = 10;            ///< of equal steps and of equal lengths
    std::optional<ProbeLine> line;  ///< none while it stands where it begins
};

}  // namespace batten::editor
