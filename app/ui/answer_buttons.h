/// The answers to a dialog's question, as buttons at its foot.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "app/ui/panels.h"

namespace batten::ui {

struct Answer {
    const char* name;  ///< of its widget
    const char* label;
};

/// Draws the answers to the question of the dialog that is shown, the last one at the right, and returns the index of
/// the one that is given: by a click, or by Enter or Space the one that Tab and the arrow keys have chosen, which is
/// `first` in the beginning.
std::optional<std::size_t> draw_answers(const PanelContext& context, std::span<const Answer> answers,
                                        std::size_t first);

}  // namespace batten::ui
