#include "app/editor/cards/cubic_card_parts.h"

#include <fmt/core.h>

#include <utility>

#include "app/editor/commands/construction_commands.h"
#include "app/editor/commands/degree_commands.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/knot_commands.h"
#include "app/editor/words/cubic_sentences.h"
#include "app/editor/words/uniform_cubic_formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

CardButtons remedies(const EditorState& state, CubicLack lack) {
    CardButtons buttons;
    if (lack == CubicLack::degree) buttons.buttons.push_back({"Set degree 3", SetDegree{.degree = 3}});
    if (lack == CubicLack::knots)
        buttons.buttons.push_back({"Space the knots equally",
                                   SetKind{.kind = state.active_curve()->is_periodic() ? core::KnotKind::periodic
                                                                                       : core::KnotKind::uniform}});
    buttons.buttons.push_back({"Open the example", OpenExample{.name = "coons-open"}});
    return buttons;
}

double middle_of_segment(const core::Curve& curve, std::size_t segment) {
    return 0.5 * curve.knots()[segment + 3] + 0.5 * curve.knots()[segment + 4];
}

}  // namespace

std::optional<Card> card_of_lack(const EditorState& state, const char* title) {
    const std::optional<CubicLack> lack = cubic_lack(state);
    if (!lack) return std::nullopt;
    Card card{.title = title, .blocks = {}};
    card.line(lack_sentence(state, *lack));
    card.add(remedies(state, *lack));
    return card;
}

std::string point_name(std::size_t i) {
    return fmt::format("P_{{{}}}", i);
}

CardText point_cell(std::size_t i) {
    return {.text = point_name(i), .hover = HoveredPoint{i}};
}

void add_segment_lines(Card& card, const EditorState& state, const ShownCubic& cubic) {
    const core::Curve& curve = *state.visible_active_curve();
    const Notation& notation = state.view.notation;
    card.line(core::sentence("Segment {segment} of {count}, u from {lower} to {upper}: {t} = {value}",
                             {{"segment", cubic.segment + 1},
                              {"count", cubic.segment_count},
                              {"lower", exact_text(notation, curve.knots()[cubic.segment + 3])},
                              {"upper", exact_text(notation, curve.knots()[cubic.segment + 4])},
                              {"t", local_parameter(notation)},
                              {"value", exact_text(notation, cubic.t)}}),
              CardTone::parameter);
    if (cubic.segment_count == 1) return;
    CardButtons buttons;
    if (cubic.segment > 0)
        buttons.buttons.push_back({"Previous segment", SetParameter{.u = middle_of_segment(curve, cubic.segment - 1)}});
    if (cubic.segment + 1 < cubic.segment_count)
        buttons.buttons.push_back({"Next segment", SetParameter{.u = middle_of_segment(curve, cubic.segment + 1)}});
    card.add(std::move(buttons));
}

std::vector<CardText> formula_row(std::string name, std::string formula, std::string value) {
    return {
        {.text = std::move(name), .tone = CardTone::strong}, {.text = std::move(formula)}, {.text = std::move(value)}};
}

}  // namespace batten::editor
