#include <fmt/core.h>

#include "app/editor/cards/cubic_card_parts.h"
#include "app/editor/cards/cubic_cards.h"
#include "app/editor/words/cubic_sentences.h"
#include "app/editor/words/uniform_cubic_formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

/// The names of the vertices of a triangle, counted around the seam.
std::array<std::string, 3> names_around(const core::Curve& curve, std::size_t i) {
    const std::size_t n = curve.control_points().size();
    return {point_name((i + n - 1) % n), point_name(i), point_name((i + 1) % n)};
}

CardTable construction(const EditorState& state, const core::Anticentroid& joint,
                       const std::array<std::string, 3>& names) {
    const Notation& notation = state.view.notation;
    const auto& [before, vertex, after] = names;
    return {
        .rows = {
            formula_row("M", fmt::format("({} + {})/2", before, after), exact_place(notation, joint.base_middle)),
            formula_row("S", fmt::format("{} + (M − {})/3", vertex, vertex), exact_place(notation, joint.anticentroid)),
            formula_row("", fmt::format("= ({} + 4 {} + {})/6", before, vertex, after), ""),
            formula_row("S′", fmt::format("({} − {})/2", after, before), exact_place(notation, joint.tangent)),
            formula_row("S″", fmt::format("{} − 2 {} + {}", before, vertex, after),
                        exact_place(notation, joint.second_derivative))}};
}

/// By u the derivatives are those per knot step over the step and its square.
void add_step_line(Card& card, const EditorState& state, const ShownCubic& cubic) {
    const core::KnotVector& knots = state.active_curve()->knots();
    const double step = knots[cubic.segment + 4] - knots[cubic.segment + 3];
    const std::string text = exact_text(state.view.notation, step);
    if (text == "1") return;
    card.line(
        core::sentence("Derivatives are per knot step; by u the first is divided by {step}, the second by {square}.",
                       {{"step", text}, {"square", exact_text(state.view.notation, step * step)}}),
        CardTone::dim);
}

}  // namespace

Card anticentroids_card(const EditorState& state) {
    constexpr const char* title = "Anticentroids";
    if (std::optional<Card> lack = card_of_lack(state, title)) return *std::move(lack);
    const ShownCubic cubic = shown_cubic(state);
    const core::Anticentroid& joint = cubic.focus;
    const std::array<std::string, 3> names = names_around(*state.visible_active_curve(), joint.index);
    Card card{.title = title, .blocks = {}};
    card.add(CardLine{{.text = core::sentence("Triangle {before} {vertex} {after}, joint S = C({u})",
                                              {{"before", names[0]},
                                               {"vertex", names[1]},
                                               {"after", names[2]},
                                               {"u", exact_text(state.view.notation, joint.u)}}),
                       .tone = CardTone::strong,
                       .hover = HoveredPoint{joint.index}}});
    card.add(construction(state, joint, names));
    card.line(joint_sentence(joint, names));
    card.line(core::sentence("S″ is the diagonal from {vertex} of the parallelogram over its two legs.",
                             {{"vertex", names[1]}}),
              CardTone::dim);
    add_step_line(card, state, cubic);
    return card;
}

}  // namespace batten::editor
