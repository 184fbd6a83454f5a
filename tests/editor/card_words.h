/// What a card says.
#pragma once

#include <string>

#include "app/editor/cards/card.h"

namespace batten::editor::test {

/// Whether `text` is a part of it.
inline bool says(const Card& card, const std::string& text) {
    return card_text(card).find(text) != std::string::npos;
}

}  // namespace batten::editor::test
