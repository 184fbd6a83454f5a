#include "app/editor/cards/support_card.h"

#include <fmt/core.h>

#include "app/editor/cards/card_texts.h"
#include "app/editor/commands/selection_commands.h"
#include "app/editor/derived/support_points.h"
#include "app/editor/pointer/highlight.h"
#include "app/editor/words/formula.h"
#include "core/base/sentence.h"
#include "core/evaluate/basis.h"

namespace batten::editor {

namespace {

using core::sentence;

std::string indexed(char letter, std::size_t index) {
    return fmt::format("{}_{{{}}}", letter, index);
}

/// How many non-empty spans of the domain lie in `part`. Cost: as many.
std::size_t spans_in(const core::KnotVector& knots, core::Interval part) {
    std::size_t count = 0;
    const std::size_t last = knots.span_at(part.upper, core::Side::left);
    for (std::size_t s = knots.span_at(part.lower); s <= last; ++s)
        if (knots[s] < knots[s + 1]) ++count;
    return count;
}

std::string interval_text(const EditorState& state, core::Interval interval) {
    const Notation& notation = state.view.notation;
    return sentence("[{lower}, {upper}]",
                    {{"lower", exact_text(notation, interval.lower)}, {"upper", exact_text(notation, interval.upper)}});
}

void add_support_of(Card& card, const EditorState& state, const core::Curve& curve, std::size_t i) {
    const core::KnotVector& knots = curve.knots();
    const std::size_t end = i + static_cast<std::size_t>(curve.degree()) + 1;
    const CardText name{.text = sentence("{point} acts on [{first}, {last}] = {support}",
                                         {{"point", indexed('P', i)},
                                          {"first", indexed('u', i)},
                                          {"last", indexed('u', end)},
                                          {"support", interval_text(state, core::basis_support(knots, i))}}),
                        .tone = CardTone::strong,
                        .hover = HoveredPoint{i}};
    card.add(CardLine{name, true});
    std::size_t moved = 0;
    for (const core::Interval& part : highlight_of_point(curve, i).parts) moved += spans_in(knots, part);
    const std::size_t all = state.derived.of(knots)->segment_count;
    card.line(
        sentence("It moves {moved} of {all} pieces of the curve, the rest stays.", {{"moved", moved}, {"all", all}}));
}

}  // namespace

Card span_hulls_card(const EditorState& state) {
    Card card{.title = "Convex hulls", .blocks = {}};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return card_without_curve(std::move(card));
    const core::KnotVector& knots = curve->knots();
    const std::size_t s = knots.span_at(state.parameter());
    const auto p = static_cast<std::size_t>(curve->degree());
    const std::size_t n = curve->control_points().size();
    card.line(
        sentence("Each piece of the curve lies in the convex hull of its {count} control points.", {{"count", p + 1}}));
    card.add(CardLine{{.text = sentence("[{lower}, {upper}]: in the hull of {first}, ..., {last}",
                                        {{"lower", indexed('u', s)},
                                         {"upper", indexed('u', s + 1)},
                                         {"first", indexed('P', (s - p) % n)},
                                         {"last", indexed('P', s % n)}}),
                       .tone = CardTone::strong,
                       .hover = HoveredSpan{s}},
                      true});
    card.line("The basis functions are not negative and their sum is 1, so each point is a mean of these.");
    return card;
}

Card support_card(const EditorState& state) {
    Card card{.title = "Support", .blocks = {}};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return card_without_curve(std::move(card));
    const std::vector<std::size_t> points = points_with_support(state);
    if (points.empty()) {
        card.line("Select a control point, or point at one, to see what it moves.");
        card.add(CardButtons{
            {{.text = "Select one", .command = SelectPoints{.points = {curve->control_points().size() / 2}}}}});
        return card;
    }
    for (const std::size_t i : points) add_support_of(card, state, *curve, i);
    card.line("Outside of these parameters its basis function is 0.", CardTone::dim);
    return card;
}

}  // namespace batten::editor
