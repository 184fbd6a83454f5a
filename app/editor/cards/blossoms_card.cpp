#include "app/editor/cards/blossoms_card.h"

#include <fmt/core.h>

#include "app/editor/cards/card_texts.h"
#include "app/editor/cards/triangle_picture.h"
#include "app/editor/commands/construction_commands.h"
#include "app/editor/derived/blend_lines.h"
#include "app/editor/derived/construction_cells.h"
#include "app/editor/words/blossom_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr double least_blossom_cell = 68.0;
constexpr double blossom_column_share = 0.87;

std::string blossom_of_cell(const NamedTriangle& named, core::CellPlace place, bool by_values) {
    const core::BlossomLabel label = core::de_boor_label(named.curve.knots(), named.cell(place).index, place.level);
    return by_values ? blossom_by_values(label, named.notation) : blossom_by_indices(label);
}

/// "f(u_{4}, u_{5}, u)", "= 7/15 f(u_{3}, u_{4}, u_{5})" and "+ 8/15 f(u_{4}, u_{5}, u_{6})", one below the other.
void add_affine_lines(Card& card, const NamedTriangle& named, core::CellPlace place, bool by_values) {
    const BlendedCell blended{named, place};
    const ShareTexts shares = share_texts(named.notation, blended.alpha());
    card.formula(blossom_of_cell(named, place, by_values));
    card.formula(fmt::format("= {} {}", shares.lower, blossom_of_cell(named, blended.lower(), by_values)));
    card.formula(fmt::format("+ {} {}", shares.upper, blossom_of_cell(named, blended.upper(), by_values)));
}

}  // namespace

Card blossoms_card(const EditorState& state) {
    if (state.active_curve() == nullptr) return card_without_curve({}, "cubic-de-boor");
    const core::Curve& curve = *state.active_curve();
    const core::DeBoorTriangle triangle = core::de_boor_triangle(curve, state.parameter());
    const NamedTriangle named{curve, triangle, state.view.notation};
    const bool by_values = state.view.blossom_values;
    Card card;
    card.line("Each point is named by the arguments of f that give it: the knots after its own, and u.");
    card.add(
        CardButtons{{{.text = "By index", .command = SetBlossomValues{.by_value = false}, .is_active = !by_values},
                     {.text = "By value", .command = SetBlossomValues{.by_value = true}, .is_active = by_values}}});
    card.add(triangle_picture(
        state, {.inside = [by_values](const NamedTriangle& shown,
                                      core::CellPlace place) { return blossom_of_cell(shown, place, by_values); },
                .below = [](const NamedTriangle& shown, core::CellPlace place) { return shown.point(place); },
                .least_width = least_blossom_cell,
                .column_share = blossom_column_share}));
    const auto hovered = hovered_cell(state, triangle);
    const core::CellPlace told =
        hovered && hovered->level > 0 ? *hovered : core::CellPlace{triangle.levels.size() - 1, 0};
    card.line("f is affine in each argument; u lies between the two knots in which the parents differ:", CardTone::dim);
    add_affine_lines(card, named, told, by_values);
    if (curve.is_rational()) card.line("Of a rational curve f gives homogeneous points, (w x, w y, w).", CardTone::dim);
    return card;
}

}  // namespace batten::editor
