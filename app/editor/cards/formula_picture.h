/// A formula with matrices as a picture: texts and bracketed columns side by side.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/editor/cards/card.h"
#include "app/editor/state/theme.h"

namespace batten::editor {

/// Part of a formula: a text, or a matrix of texts in brackets. Every row of a matrix has as many entries.
struct FormulaPart {
    std::vector<std::vector<CardText>> rows;
    bool has_brackets = true;
};

/// A text by itself.
FormulaPart formula_text(std::string text);

/// A row and a column of texts.
FormulaPart formula_row_vector(const std::vector<std::string>& texts);
FormulaPart formula_column(std::vector<CardText> texts);

/// The parts from left to right, in the middle of the card where there is room, else as wide as they are. Entries that
/// have something to point at are places of the picture, named "PREFIX entry PART ROW COLUMN".
CardPicture formula_picture(std::vector<FormulaPart> parts, const Theme& theme, const Notation& notation,
                            std::string prefix);

}  // namespace batten::editor
