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

/// A position on or beside a curve that is `size` large, as fractions or with the digits that tell it from its
/// neighbors however far from zero it is: "(0, 1/2)", "(1000001.46, 0.83)". What is rounding beside the size is 0.
std::string coordinate_text(const Notation& notation, double size, double value);
std::string position_text(const Notation& notation, double size, core::Point place);

/// Whether a condition holds, as a green tick or a red cross.
CardText tick(bool holds);

/// The card of a view without a curve to be seen: that, and a button that opens the example of this name.
Card card_without_curve(Card card, const char* example = "wave");

}  // namespace batten::editor
