#include "app/editor/cards/triangle_card.h"

#include <fmt/core.h>

#include "app/editor/cards/card_texts.h"
#include "app/editor/cards/triangle_picture.h"
#include "app/editor/commands/view_commands.h"
#include "app/editor/derived/blend_lines.h"
#include "app/editor/derived/construction_cells.h"
#include "app/editor/state/state.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/number_column.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr std::size_t most_levels_with_lines = 5;

/// What the card is about.
struct ShownTriangle {
    const EditorState& state;
    const core::Curve& curve;
    core::DeBoorTriangle triangle;
    Theme theme;

    const Notation& notation() const { return state.view.notation; }
    NamedTriangle named() const { return {curve, triangle, notation()}; }
    std::size_t degree() const { return triangle.levels.size() - 1; }
};

/// "De Boor at u = 2/5 in the span [1/4, 1/2)"; the last span holds its end too.
std::string place_sentence(const ShownTriangle& shown) {
    const core::KnotVector& knots = shown.curve.knots();
    const std::size_t s = shown.triangle.span;
    const std::string u = exact_text(shown.notation(), shown.triangle.u);
    if (shown.state.derived.of(knots)->is_bezier) return core::sentence("De Casteljau at u = {u}", {{"u", u}});
    const bool is_last = knots[s + 1] == shown.curve.domain().upper && !shown.curve.is_periodic();
    return core::sentence(
        is_last ? "De Boor at u = {u} in the span [{begin}, {end}]" : "De Boor at u = {u} in the span [{begin}, {end})",
        {{"u", u},
         {"begin", exact_text(shown.notation(), knots[s])},
         {"end", exact_text(shown.notation(), knots[s + 1])}});
}

/// Why one ratio does for all, which it does only for a Bézier curve.
std::string ratio_sentence(const ShownTriangle& shown) {
    const core::Interval domain = shown.curve.domain();
    if (domain == core::Interval{0.0, 1.0}) return "Every ratio α is u, and C(u) is the sum of B_{i,n}(u) P_{i}.";
    return core::sentence(
        "Every ratio α is (u − {begin})/({end} − {begin}), that of u in the domain.",
        {{"begin", exact_text(shown.notation(), domain.lower)}, {"end", exact_text(shown.notation(), domain.upper)}});
}

void add_lines_of_level(Card& card, const ShownTriangle& shown, std::size_t r) {
    for (std::size_t j = 0; j < shown.triangle.levels[r].size(); ++j)
        card.add(CardLine{
            {.text = blend_line({shown.named(), {r, j}}), .hover = HoveredCell{r, j}, .color = shown.theme.level(r)},
            true});
}

void add_lines(Card& card, const ShownTriangle& shown) {
    const std::size_t last = shown_level(shown.state.view, shown.curve.degree());
    if (shown.degree() <= most_levels_with_lines) {
        for (std::size_t r = 1; r <= last; ++r) add_lines_of_level(card, shown, r);
        return;
    }
    card.line(core::sentence("The lines of level {level}; the steps of the construction lead to the others.",
                             {{"level", last}}),
              CardTone::dim);
    if (last > 0) add_lines_of_level(card, shown, last);
}

/// All that makes one point, in lines that are as many for every point.
void add_cell_formulas(Card& card, const ShownTriangle& shown, core::CellPlace place) {
    const BlendedCell blended{shown.named(), place};
    const AlphaFormula alpha = alpha_formula(shown.named(), place);
    card.formula(alpha.symbols);
    card.formula(alpha.numbers);
    if (shown.curve.is_rational()) {
        const WeightFormula weight = weight_formula(blended);
        card.line("Homogeneous, the weight among the coordinates:", CardTone::dim);
        card.formula(homogeneous_line(blended));
        card.formula(weight.symbols);
        card.formula(weight.numbers);
        card.line("Euclidean, divided by the weight:", CardTone::dim);
        card.formula(projected_line(blended));
    }
    card.formula(blend_line(blended));
    const core::Point point = shown.named().cell(place).point;
    card.formula(fmt::format("{} = {}", shown.named().point(place),
                             place_text(shown.state.derived.of(shown.curve)->size, point)),
                 CardTone::strong);
}

/// The hovered point of level >= 1, else the last one of the last level that is shown: C(u) where all are. None where
/// not even level 1 is shown.
std::optional<core::CellPlace> told_cell(const ShownTriangle& shown) {
    const auto hovered = hovered_cell(shown.state, shown.triangle);
    if (hovered && hovered->level > 0) return hovered;
    const std::size_t last = shown_level(shown.state.view, shown.curve.degree());
    if (last == 0) return std::nullopt;
    return core::CellPlace{last, shown.triangle.levels[last].size() - 1};
}

void add_told_point(Card& card, const ShownTriangle& shown) {
    const std::optional<core::CellPlace> told = told_cell(shown);
    if (!told) return;
    card.line(core::sentence("How {point} is made", {{"point", shown.named().point(*told)}}), CardTone::strong);
    add_cell_formulas(card, shown, *told);
}

SetNotation numbered_by(const Notation& notation, CellNumbering numbering) {
    return {.points = notation.points,
            .parameter = notation.parameter,
            .degree = notation.degree,
            .triangles = numbering,
            .numbers = notation.numbers};
}

CardButtons numbering_buttons(const Notation& notation) {
    const auto button = [&](const char* text, CellNumbering numbering) {
        return CardButton{text, numbered_by(notation, numbering), notation.triangles == numbering};
    };
    return {{button("Last parent", CellNumbering::last), button("First parent", CellNumbering::first)}};
}

void add_numbering(Card& card, const ShownTriangle& shown) {
    card.line(shown.notation().triangles == CellNumbering::last ? "A point has the index of its last parent."
                                                                : "A point has the index of its first parent.",
              CardTone::dim);
    card.add(numbering_buttons(shown.notation()));
}

std::string cell_alpha_text(const NamedTriangle& named, core::CellPlace place) {
    return fmt::format("α {}", share_texts(named.notation, named.cell(place).alpha).upper);
}

}  // namespace

Card triangle_card(const EditorState& state) {
    if (state.active_curve() == nullptr) return card_without_curve({}, "cubic-de-boor");
    const core::Curve& curve = *state.active_curve();
    const ShownTriangle shown{state, curve, core::de_boor_triangle(curve, state.parameter()), shown_theme(state.view)};
    Card card;
    card.line(place_sentence(shown), CardTone::strong);
    if (state.derived.of(curve.knots())->is_bezier) card.line(ratio_sentence(shown), CardTone::dim);
    const auto name = [](const NamedTriangle& named, core::CellPlace place) { return named.point(place); };
    card.add(triangle_picture(state, {.inside = name, .below = cell_alpha_text}));
    if (!state.view.is_presenting) add_numbering(card, shown);
    add_lines(card, shown);
    add_told_point(card, shown);
    // A projector's card is low: first what is told there.
    if (state.view.is_presenting) add_numbering(card, shown);
    return card;
}

}  // namespace batten::editor
