/// Draws what a card says: lines, tables, pictures, buttons.
#pragma once

#include "app/editor/cards/card.h"
#include "app/ui/panels.h"

namespace batten::ui {

/// Draws the blocks of `card` below the cursor in the current window, `width_px` wide; longer lines are broken, wider
/// tables and pictures scroll sideways. Every text and every place of a picture is reported as "NAME row column" or
/// "NAME place", so that tests can find it.
void draw_card_blocks(const PanelContext& context, const editor::Card& card, const std::string& name, float width_px);

}  // namespace batten::ui
