#include "app/editor/cards/end_derivatives_card.h"

#include "app/editor/end_formula.h"
#include "app/editor/state.h"

namespace batten::editor {

namespace {

void add_formula(Card& card, const EndFormula& formula) {
    card.line(formula.symbols);
    for (const std::string& line : formula.numbers) card.line(line, CardTone::dim);
}

void add_end(Card& card, const core::Curve& curve, core::CurveEnd end, const Notation& notation) {
    const bool is_start = end == core::CurveEnd::start;
    card.line(is_start ? "At the start" : "At the end", CardTone::strong);
    const auto at = core::end_derivatives(curve, end);
    if (!at) {
        card.line(is_start ? "The start is not clamped: fewer than p knots are equal there, and it is no control point."
                           : "The end is not clamped: fewer than p knots are equal there, and it is no control point.",
                  CardTone::dim);
        return;
    }
    add_formula(card, first_end_formula(*at, notation));
    if (at->second) add_formula(card, second_end_formula(*at, notation));
}

}  // namespace

Card end_derivatives_card(const EditorState& state) {
    Card card;
    card.title = "End derivatives";
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return card.line("There is no curve to be measured.", CardTone::dim);
    if (curve->is_periodic()) return card.line("The curve is periodic: it has no ends.", CardTone::dim);
    for (const core::CurveEnd end : {core::CurveEnd::start, core::CurveEnd::end})
        add_end(card, *curve, end, state.view.notation);
    return card;
}

}  // namespace batten::editor
