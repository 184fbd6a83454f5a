/// What is selected of all curves and the box around it, kept as long as both stay as they are.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "app/editor/state/selection.h"
#include "core/base/geometry.h"
#include "core/document/document.h"

namespace batten::editor {

struct SelectedBox {
    std::vector<SelectedPart> parts;  ///< ascending by curve
    core::Box box;                    ///< around the control points of them; empty where there are none
};

/// Holds on to what was asked for last.
class KeptSelection {
  public:
    /// Of a selection in `document`, which has all that it names. Cost O(n) of what is selected; of the same selection
    /// of the same curves only that of finding so.
    std::shared_ptr<const SelectedBox> of(const Selection& selection, const core::Document& document) const;

  private:
    bool is_of(const Selection& selection, const core::Document& document) const;

    mutable Selection selection_;
    mutable std::size_t active_ = 0;
    mutable std::vector<std::shared_ptr<const core::Curve>> curves_;  // of the parts
    mutable std::shared_ptr<const SelectedBox> kept_;
};

}  // namespace batten::editor
