/// The graphs of basis functions that were traced, kept while knots and axes stay as they are.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "app/editor/pointer/plot_layout.h"

namespace batten::editor {

/// One function as far as it is shown.
struct BasisGraph {
    std::size_t index = 0;  ///< of the function and its control point
    std::vector<std::vector<glm::dvec2>>
        runs;                    ///< in pixels, from left to right; a run ends where the function jumps or is zero
    glm::dvec2 peak{0.0, 1e30};  ///< the highest place
};

class BasisCache {
  public:
    /// Forgets everything unless it belongs to these knots and axes; what was returned before is of no more use.
    void follow(const core::KnotVector& knots, const PlotLayout& layout);

    /// All graphs, by `trace()` when they are asked for first.
    template <class Trace>
    const std::vector<BasisGraph>& all(const Trace& trace) {
        if (!all_) {
            all_ = trace();
            traced_count_ += all_->size();
        }
        return *all_;
    }

    /// The graph of one function, by `trace(index)` when it is asked for first; it stays where it is.
    template <class Trace>
    const BasisGraph& single(std::size_t index, const Trace& trace) {
        const auto found = singles_.find(index);
        if (found != singles_.end()) return found->second;
        ++traced_count_;
        return singles_.emplace(index, trace(index)).first->second;
    }

    /// The functions shown whatever the parameter, by `choose()` when they are asked for first.
    template <class Choose>
    const std::vector<std::size_t>& chosen(const Choose& choose) {
        if (!chosen_) chosen_ = choose();
        return *chosen_;
    }

    /// How many functions were traced so far.
    std::size_t traced_count() const { return traced_count_; }

  private:
    std::optional<std::pair<core::KnotVector, PlotLayout>> key_;
    std::optional<std::vector<BasisGraph>> all_;
    std::unordered_map<std::size_t, BasisGraph> singles_;
    std::optional<std::vector<std::size_t>> chosen_;
    std::size_t traced_count_ = 0;
};

}  // namespace batten::editor
