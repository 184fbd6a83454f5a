#include "app/editor/cards/basis_values_card.h"

#include <fmt/core.h>

#include <array>
#include <span>
#include <vector>

#include "app/editor/cards/card_texts.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/derived/shown_function.h"
#include "app/editor/state/point_hues.h"
#include "app/editor/state/state.h"
#include "app/editor/words/basis_formula.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/root_text.h"
#include "core/base/sentence.h"
#include "core/evaluate/rational_basis.h"

namespace batten::editor {

namespace {

/// What the rows are about.
struct Functions {
    explicit Functions(const EditorState& shown)
        : state(shown),
          curve(*shown.active_curve()),
          theme(shown_theme(shown.view)),
          u(shown.parameter()),
          basis(core::basis_functions(curve.knots(), u)) {}

    const core::BasisRow& values() const { return basis.derivatives[0]; }

    /// The control point of local function j.
    std::size_t index(std::size_t j) const {
        return (basis.span - static_cast<std::size_t>(curve.degree()) + j) % curve.control_points().size();
    }

    CardText named(std::size_t j, std::string text) const {
        return {.text = std::move(text),
                .hover = HoveredBasis{index(j)},
                .color = theme.point_text(point_hue(*state.shown().active_curve(), index(j)))};
    }

    std::string number(double value) const { return exact_text(state.view.notation, value); }

    std::vector<std::string> numbers(std::span<const double> values) const {
        return exact_texts(state.view.notation, values);
    }

    std::string parameter() const { return knot_value_text(curve.knots(), u, state.view.notation); }

    const EditorState& state;
    const core::Curve& curve;
    Theme theme;
    double u;
    core::BasisValues basis;
};

double sum_of(std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values) sum += value;
    return sum;
}

/// The values and their sum; fractions have their decimals beside them.
CardTable values_table(const Functions& shown) {
    CardTable table{.rows = {{{.text = "function"}, {.text = "value"}}}, .has_heading = true};
    const std::vector<std::string> values = shown.numbers(shown.values());
    for (std::size_t j = 0; j < values.size(); ++j)
        table.rows.push_back(
            {shown.named(j, function_name(shown.state, shown.curve.knots(), shown.index(j))), {.text = values[j]}});
    const double sum = sum_of(shown.values());
    table.rows.push_back(
        {{.text = "sum", .tone = CardTone::strong}, {.text = shown.number(sum), .tone = CardTone::strong}});
    if (shown.state.view.notation.numbers == NumberStyle::decimals) return table;
    table.rows.front().push_back({.text = "decimal"});
    for (std::size_t j = 0; j < values.size(); ++j)
        table.rows[j + 1].push_back({.text = fixed_text(shown.values()[j], 4), .tone = CardTone::dim});
    table.rows.back().push_back({.text = fixed_text(sum, 4), .tone = CardTone::dim});
    return table;
}

}  // namespace

Card basis_values_card(const EditorState& state) {
    Card card{.title = "Values and sum", .blocks = {}};
    if (state.active_curve() == nullptr) return card_without_curve(std::move(card));
    const Functions shown(state);
    card.line(core::sentence("At u = {u}", {{"u", shown.parameter()}}), CardTone::parameter);
    card.add(values_table(shown));
    return card.line(
        "All other functions are 0 here. In the domain the sum is always 1, so that a point of the curve "
        "is an average of control points.",
        CardTone::dim);
}

Card rational_basis_card(const EditorState& state) {
    Card card{.title = "Rational basis", .blocks = {}};
    if (state.active_curve() == nullptr) return card_without_curve(std::move(card));
    const Functions shown(state);
    if (!shown.curve.is_rational()) {
        card.line(core::sentence("All weights are equal, so each R_{{i,p}} is {letter}_{{i,p}}.",
                                 {{"letter", basis_letter(state, shown.curve.knots())}}));
        return card.add(CardButtons{{{.text = "Open a circle", .command = OpenExample{.name = "circle-nurbs"}}}});
    }
    const core::RationalBasis rational = core::rational_basis(shown.curve, shown.u);
    const char* letter = basis_letter(state, shown.curve.knots());
    std::vector<std::string> weights;
    std::vector<double> products;
    for (std::size_t j = 0; j < shown.values().size(); ++j) {
        const double weight = shown.curve.weights()[shown.index(j)];
        weights.push_back(root_text(state.view.notation, weight));
        products.push_back(shown.values()[j] * weight);
    }
    const double w = sum_of(products);
    CardTable table{.rows = {{{.text = "i"},
                              {.text = letter},
                              {.text = "w"},
                              {.text = fmt::format("{} w", letter)},
                              {.text = fmt::format("R = {} w / w(u)", letter)}}},
                    .has_heading = true};
    const std::array columns{shown.numbers(shown.values()), weights, shown.numbers(products),
                             shown.numbers(rational.derivatives[0])};
    for (std::size_t j = 0; j < products.size(); ++j)
        table.rows.push_back({shown.named(j, std::to_string(shown.index(j))),
                              {.text = columns[0][j]},
                              {.text = columns[1][j]},
                              {.text = columns[2][j]},
                              {.text = columns[3][j], .tone = CardTone::strong}});
    table.rows.push_back({{.text = "sum", .tone = CardTone::strong},
                          {.text = shown.number(sum_of(shown.values()))},
                          {.text = ""},
                          {.text = shown.number(w), .tone = CardTone::parameter},
                          {.text = shown.number(sum_of(rational.derivatives[0])), .tone = CardTone::strong}});
    card.line(core::sentence("At u = {u}, w(u) = {w}", {{"u", shown.parameter()}, {"w", shown.number(w)}}),
              CardTone::parameter);
    card.add(std::move(table));
    return card.line(core::sentence("In the plot R is dashed, beside {letter}.", {{"letter", letter}}), CardTone::dim);
}

}  // namespace batten::editor
