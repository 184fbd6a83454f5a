#include <fmt/core.h>

#include "app/editor/cards/card_texts.h"
#include "app/editor/cards/weight_cards.h"
#include "app/editor/commands/weight_commands.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/root_text.h"
#include "core/base/sentence.h"
#include "core/evaluate/lifted.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr std::size_t most_lifted_rows = 6;

/// The points of the active span, and what they are lifted to.
CardTable points_table(const EditorState& state, const core::Curve& curve) {
    const auto exact = [&](double value) { return root_text(state.view.notation, value); };
    // Roots are those of weights; what lies far from zero is told apart instead.
    const double size = state.derived.of(curve)->size;
    const auto coordinate = [&](double value, double w) {
        constexpr double far = 1000.0;
        return std::abs(value) < far ? exact(value) : coordinate_text(state.view.notation, w * size, value);
    };
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t span = curve.knots().span_at(curve.knots().into_domain(state.parameter()));
    CardTable table{.rows = {{{.text = "point"}, {.text = "w"}, {.text = "(wx, wy, w)"}}}, .has_heading = true};
    for (std::size_t i = span - p; i <= span && i < span - p + most_lifted_rows; ++i) {
        const std::size_t k = i % curve.control_points().size();
        const core::HomogeneousPoint lifted = curve.homogeneous_point(k);
        const Hover hover = HoveredLifted{k};
        table.rows.push_back({{.text = fmt::format("P_{{{}}}", k), .tone = CardTone::strong, .hover = hover},
                              {.text = exact(curve.weights()[k]), .hover = hover},
                              {.text = fmt::format("({}, {}, {})", coordinate(lifted.x, lifted.z),
                                                   coordinate(lifted.y, lifted.z), exact(lifted.z)),
                               .hover = hover}});
    }
    return table;
}

void write_shape(Card& card, const core::Curve& curve) {
    if (!curve.is_rational() && curve.weights().front() == 1.0)
        card.line("All weights are 1: the lifted curve lies in the plane w = 1 and is its own shadow.");
    else if (!curve.is_rational())
        card.line(
            "All weights are equal: the lifted curve lies in a plane of its own beside w = 1, and its shadow has "
            "the same shape.");
    else if (curve.degree() == 2)
        card.line("Every piece of degree 2 is a parabola in space; its shadow is any conic.");
    else
        card.line("In space the curve is a polynomial one; only its shadow is rational.");
}

}  // namespace

Card homogeneous_card(const EditorState& state) {
    Card card{.title = "Homogeneous view", .blocks = {}};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return card.line("There is no curve to be seen.", CardTone::dim);
    card.line(
        "A point (x, y) with weight w stands for (wx, wy, w) in space. Rays from the origin throw its shadow onto "
        "the plane w = 1: divide by w.");
    card.add(points_table(state, *curve));
    const core::LiftedSample now = core::lifted_at(*curve, state.parameter());
    card.formula(fmt::format("w(u) = {}, u = {}", root_text(state.view.notation, now.weight),
                             root_text(state.view.notation, now.u)),
                 CardTone::parameter);
    write_shape(card, *curve);
    const auto weights = state.derived.weights_of(*curve);
    const core::LiftView view =
        core::lift_view(state.derived.of(*curve)->control_box, {weights->lightest, weights->heaviest});
    if (view.exponent != 1.0)
        card.line(sentence("The weights differ so much that heights are drawn as w to the power {exponent}; each point "
                           "stays on its ray.",
                           {{"exponent", number_text(view.exponent, 2)}}),
                  CardTone::dim);
    card.add(CardButtons{{{"Aslant", SetOrbit{.yaw = -28.0, .pitch = 24.0, .zoom = 1.0}},
                          {"From the side", SetOrbit{.yaw = 0.0, .pitch = 0.0, .zoom = 1.0}},
                          {"From above", SetOrbit{.yaw = 0.0, .pitch = 90.0, .zoom = 1.0}}}});
    card.line("Drag a lifted point along its ray to change its weight; drag beside it to turn the view.",
              CardTone::dim);
    return card;
}

}  // namespace batten::editor
