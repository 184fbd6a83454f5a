/// How long operations tell how far they are, and how they are stopped.
#pragma once

#include <functional>

namespace batten::core {

/// Is told now and then how much of an operation is done, from 0 to 1. It stops the operation by throwing: what it
/// throws passes through, and nothing has changed. An empty one is told nothing.
using Progress = std::function<void(double share)>;

/// The progress of one part of an operation, which takes it from share `from` to share `to`. Copies `progress`.
inline Progress part_of(const Progress& progress, double from, double to) {
    if (!progress) return {};
    return [progress, from, to](double share) { progress(from + share * (to - from)); };
}

/// Tells `progress` that `done` of `all` parts are done.
inline void tell(const Progress& progress, std::size_t done, std::size_t all) {
    if (progress && all > 0) progress(static_cast<double>(done) / static_cast<double>(all));
}

}  // namespace batten::core
