/// Texts that many cards have.
#pragma once

#include <string>

#include "app/editor/cards/card.h"
#include "app/editor/state/notation.h"
#include "core/base/geometry.h"

namespace batten::editor {

/// A measured number: as a fraction where that is short, else with four digits.
std::string short_text(const Notation& notation, double value);

/// "(1/2, −3)", of such numbers.
std::string pair_text(const Notation& notation, core::Vector pair);

/// Whether a condition holds, as a green tick or a red cross.
CardText tick(bool holds);

/// The card of a view without a curve to be seen: that, and an example to begin with.
Card without_curve(Card card);

}  // namespace batten::editor
