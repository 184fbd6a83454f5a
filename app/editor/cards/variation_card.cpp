#include "app/editor/cards/variation_card.h"

#include <algorithm>

#include "app/editor/cards/card_texts.h"
#include "app/editor/commands/shape_view_commands.h"
#include "app/editor/pointer/view_handle.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

void add_counts(Card& card, const core::LineContacts& found) {
    const auto touches = std::ranges::count(found.contacts, core::ContactKind::touching, &core::LineContact::kind);
    card.add(CardTable{
        .rows = {{{.text = "crossings with the polygon"},
                  {.text = sentence("{count}", {{"count", found.polygon_crossings}}), .tone = CardTone::strong}},
                 {{.text = "crossings with the curve"},
                  {.text = sentence("{count}", {{"count", found.crossings}}), .tone = CardTone::parameter}},
                 {{.text = "places where it only touches"},
                  {.text = sentence("{count}", {{"count", static_cast<std::size_t>(touches)}})}}}});
    card.formula(sentence("{crossings} ≤ {polygon_crossings}",
                          {{"crossings", found.crossings}, {"polygon_crossings", found.polygon_crossings}}),
                 CardTone::good);
}

}  // namespace

Card variation_card(const EditorState& state) {
    Card card{.title = "Variation diminishing", .blocks = {}};
    const core::Curve* curve = state.visible_active_curve();
    const auto line = shown_probe_line(state);
    if (curve == nullptr || !line) return card_without_curve(std::move(card));
    card.line("No line crosses the curve more often than its control polygon. Drag the line, or its ends.");
    if (const auto found = state.measured.crossings(*curve, *line)) {
        if (found->is_complete)
            add_counts(card, *found);
        else
            card.line(sentence("The line crosses the polygon {count} times, and runs along too many spans to mark all.",
                               {{"count", found->polygon_crossings}}));
    }
    card.add(CardButtons{{{.text = "Level line", .command = LevelLine{}}}});
    return card;
}

}  // namespace batten::editor
