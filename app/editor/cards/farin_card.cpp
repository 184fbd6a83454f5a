#include <fmt/core.h>

#include <algorithm>

#include "app/editor/cards/weight_cards.h"
#include "app/editor/words/root_text.h"
#include "core/base/sentence.h"
#include "core/evaluate/farin_points.h"

namespace batten::editor {

namespace {

constexpr std::size_t most_farin_rows = 8;

/// The legs between the points that act on the span of the parameter.
std::vector<std::size_t> active_legs(const core::Curve& curve, double u) {
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t first = curve.knots().span_at(curve.knots().into_domain(u)) - p;
    std::vector<std::size_t> legs;
    for (std::size_t k = 0; k < std::min(p, most_farin_rows); ++k)
        legs.push_back((first + k) % curve.control_points().size());
    return legs;
}

std::vector<CardText> farin_row(const EditorState& state, const core::Curve& curve, std::size_t leg) {
    const std::size_t next = (leg + 1) % curve.control_points().size();
    const auto exact = [&](double value) { return root_text(state.view.notation, value); };
    const Hover hover = HoveredFarinPoint{leg};
    return {{.text = fmt::format("F_{{{}}}", leg), .tone = CardTone::strong, .hover = hover},
            {.text = fmt::format("w_{{{}}} : w_{{{}}} = {} : {}", next, leg, exact(curve.weights()[next]),
                                 exact(curve.weights()[leg])),
             .hover = hover},
            {.text = exact(core::farin_point(curve, leg).share), .hover = hover}};
}

}  // namespace

Card farin_card(const EditorState& state) {
    Card card{.title = "Farin points", .blocks = {}};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return card.line("There is no curve to be seen.", CardTone::dim);
    card.line("F_{i} divides the leg from P_{i} to P_{i+1} in the ratio of the weights, nearer to the heavier point:");
    card.formula("F_{i} = (w_{i} P_{i} + w_{i+1} P_{i+1}) / (w_{i} + w_{i+1})");
    CardTable table{.rows = {{{.text = "point"}, {.text = "ratio of the weights"}, {.text = "share"}}},
                    .has_heading = true};
    for (const std::size_t leg : active_legs(*curve, state.parameter()))
        table.rows.push_back(farin_row(state, *curve, leg));
    card.add(std::move(table));
    card.line(
        curve->is_periodic()
            ? "Drag F_{i} to change w_{i+1}, and with it F_{i+1}: around a closed curve the ratios multiply to 1."
            : "Drag F_{i} to change its ratio alone: all weights from w_{i+1} on get the same factor, so that the "
              "other Farin points stay.",
        CardTone::dim);
    return card;
}

}  // namespace batten::editor
