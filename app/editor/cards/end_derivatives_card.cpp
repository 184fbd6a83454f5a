#include "app/editor/cards/end_derivatives_card.h"

#include <algorithm>

#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/refinement_commands.h"
#include "app/editor/state/state.h"
#include "app/editor/words/end_formula.h"

namespace batten::editor {

namespace {

void add_end_formula(Card& card, const EndFormula& formula, const Hover& hover) {
    card.add(CardLine{{.text = formula.symbols, .hover = hover}});
    for (const std::string& line : formula.numbers) card.line(line, CardTone::dim);
}

// The leg along which the curve begins or ends.
Hover leg_of(const core::EndDerivatives& at) {
    return HoveredLeg{std::min(at.end_point.index, at.near_point.index)};
}

// Returns whether the formulas hold.
bool add_end_derivatives(Card& card, const core::Curve& curve, core::CurveEnd end, const Notation& notation) {
    const bool is_start = end == core::CurveEnd::start;
    card.line(is_start ? "At the start" : "At the end", CardTone::strong);
    const auto at = core::end_derivatives(curve, end);
    if (!at) {
        card.line(is_start ? "The start is not clamped: fewer than p knots are equal there, and it is no control point."
                           : "The end is not clamped: fewer than p knots are equal there, and it is no control point.",
                  CardTone::dim);
        return false;
    }
    add_end_formula(card, first_end_formula(*at, notation), leg_of(*at));
    if (at->second) add_end_formula(card, second_end_formula(*at, notation), HoveredPoint{at->second->far_point.index});
    return true;
}

Card& offer_curve_with_ends(Card& card) {
    return card.add(CardButtons{{{.text = "Open an example", .command = OpenExample{.name = "bezier-cubic"}}}});
}

}  // namespace

Card end_derivatives_card(const EditorState& state) {
    Card card;
    card.title = "End derivatives";
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return offer_curve_with_ends(card.line("There is no curve to be measured.", CardTone::dim));
    if (curve->is_periodic())
        return offer_curve_with_ends(card.line("The curve is periodic: it has no ends.", CardTone::dim));
    const bool start_is_clamped = add_end_derivatives(card, *curve, core::CurveEnd::start, state.view.notation);
    const bool end_is_clamped = add_end_derivatives(card, *curve, core::CurveEnd::end, state.view.notation);
    if (!start_is_clamped || !end_is_clamped)
        card.add(CardButtons{{{.text = "Clamp both ends", .command = Clamp{.end = CurveEnds::both}}}});
    return card;
}

}  // namespace batten::editor
