/// The cards of the teaching views.
#pragma once

#include <span>

#include "app/editor/cards/card.h"
#include "app/editor/state/overlay.h"
#include "app/editor/state/state.h"

namespace batten::editor {

/// The card of one view, made anew whenever it is shown; its cost must not grow with the number of points.
struct CardSource {
    Overlay overlay;
    Card (*make)(const EditorState& state);
};

/// Every view that has a card, in the order in which they are shown.
std::span<const CardSource> card_sources();

/// Those that are shown now; for a projector the triangle stands in for the inspector, after the others.
std::vector<CardSource> shown_cards(const EditorState& state);

}  // namespace batten::editor
