#include <fmt/core.h>

#include "app/editor/cards/cubic_card_parts.h"
#include "app/editor/cards/cubic_cards.h"
#include "app/editor/words/uniform_cubic_formula.h"

namespace batten::editor {

namespace {

CardTable form(const EditorState& state, const core::FergusonSegment& segment, const ShownCubic& cubic) {
    const Notation& notation = state.view.notation;
    std::array<std::string, 4> P;
    for (std::size_t j = 0; j < 4; ++j) P[j] = point_name(cubic.points[j]);
    return {
        .rows = {
            formula_row("Q_{0}", fmt::format("({} + 4 {} + {})/6", P[0], P[1], P[2]),
                        exact_place(notation, segment.start)),
            formula_row("Q_{1}", fmt::format("({} + 4 {} + {})/6", P[1], P[2], P[3]),
                        exact_place(notation, segment.end)),
            formula_row("Q_{0}′", fmt::format("({} − {})/2", P[2], P[0]), exact_place(notation, segment.start_tangent)),
            formula_row("Q_{1}′", fmt::format("({} − {})/2", P[3], P[1]), exact_place(notation, segment.end_tangent))}};
}

/// Ferguson's polynomials and their values at t.
CardTable polynomials(const Notation& notation, double t) {
    const char* name = local_parameter(notation);
    const std::array<double, 4> values{1.0 - t * t * (3.0 - 2.0 * t), t * t * (3.0 - 2.0 * t),
                                       t * (1.0 - t) * (1.0 - t), -t * t * (1.0 - t)};
    const std::vector<std::string> texts = exact_texts(notation, values);
    return {.rows = {formula_row("F_{0}", fmt::format("1 − 3 {0}^{{2}} + 2 {0}^{{3}}", name), texts[0]),
                     formula_row("F_{1}", fmt::format("3 {0}^{{2}} − 2 {0}^{{3}}", name), texts[1]),
                     formula_row("F_{2}", fmt::format("{0} − 2 {0}^{{2}} + {0}^{{3}}", name), texts[2]),
                     formula_row("F_{3}", fmt::format("−{0}^{{2}} + {0}^{{3}}", name), texts[3])}};
}

}  // namespace

Card ferguson_card(const EditorState& state) {
    constexpr const char* title = "Ferguson form";
    if (std::optional<Card> lack = card_of_lack(state, title)) return *std::move(lack);
    const ShownCubic cubic = shown_cubic(state);
    const core::FergusonSegment segment = core::ferguson_segment(*state.visible_active_curve(), cubic.segment);
    const Notation& notation = state.view.notation;
    Card card{.title = title, .blocks = {}};
    add_segment_lines(card, state, cubic);
    card.line("The segment by its ends and its tangents there, derivatives per knot step:");
    card.add(form(state, segment, cubic));
    card.formula(fmt::format("C({}) = F_{{0}} Q_{{0}} + F_{{1}} Q_{{1}} + F_{{2}} Q_{{0}}′ + F_{{3}} Q_{{1}}′",
                             local_parameter(notation)));
    card.add(polynomials(notation, cubic.t));
    return card;
}

}  // namespace batten::editor
