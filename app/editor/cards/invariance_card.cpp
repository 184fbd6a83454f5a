#include "app/editor/cards/invariance_card.h"

#include <algorithm>

#include "app/editor/cards/card_texts.h"
#include "app/editor/cards/invariance_picture.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/invariance_commands.h"
#include "app/editor/commands/transform_commands.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/refusal.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"

namespace batten::editor {

namespace {

using core::sentence;

void add_both_ways(Card& card, const EditorState& state, const core::Curve& curve, const core::PlaneMap& map,
                   const MapCheck& check) {
    const double u = state.parameter();
    const double size = std::max(state.derived.of(curve)->size, state.derived.of(*check.image)->size);
    const auto text = [&](core::Point place) { return position_text(state.view.notation, size, place); };
    card.line(sentence("The middle of the control points, ({x}, {y}), is where the map is seen from.",
                       {{"x", coordinate_text(state.view.notation, size, map.pivot.x)},
                        {"y", coordinate_text(state.view.notation, size, map.pivot.y)}}),
              CardTone::dim);
    card.line("First the point, then the map:");
    card.formula(sentence("M(C(u)) = {place}", {{"place", text(core::mapped(map, core::point_at(curve, u)))}}),
                 CardTone::parameter);
    card.line("First the map of the polygon, then the point:");
    card.formula(sentence("C^{{*}}(u) = {place}", {{"place", text(core::point_at(*check.image, u))}}),
                 CardTone::parameter);
}

void add_verdict(Card& card, const MapCheck& check) {
    const core::Place most("most", bound_text(check.difference.distance, 2));
    const core::Place count("count", compared_parameters);
    if (check.difference.distance == 0.0)
        card.line(sentence("They agree: no difference at {count} parameters.", {count}), CardTone::good);
    else if (check.agrees())
        card.line(sentence("They agree: the largest difference at {count} parameters is {most}, which is rounding.",
                           {count, most}),
                  CardTone::good);
    else
        card.line(sentence("The largest difference at {count} parameters is {most}: numbers of this size are too large "
                           "or too far apart for more digits.",
                           {count, most}),
                  CardTone::bad);
}

void add_affine_reason(Card& card, const core::Curve& curve) {
    card.line("It is so because the basis functions sum to 1 and the map is affine:", CardTone::dim);
    card.formula(curve.is_rational() ? "M(Σ R_{i} P_{i}) = Σ R_{i} M(P_{i})" : "M(Σ N_{i} P_{i}) = Σ N_{i} M(P_{i})");
    if (curve.is_rational()) card.line("The weights stay as they are.", CardTone::dim);
}

void add_projective_reason(Card& card, const EditorState& state, const core::Curve& curve, const MapCheck& check) {
    card.line("It is so because the map is linear in homogeneous coordinates, where weights are mapped too:",
              CardTone::dim);
    card.formula("w_{i}^{*} = w_{i} (h_{1} x_{i} + h_{2} y_{i} + h_{3})");
    const Units& units = state.shown().units;
    const auto [least, most] = std::ranges::minmax(check.image->weights());
    const core::Place lower("lower", exact_text(state.view.notation, least));
    const core::Place upper("upper", exact_text(state.view.notation, most));
    if (!curve.is_rational() && check.image->is_rational())
        card.line(
            sentence("The B-spline becomes rational: its weights were equal, now they are from {lower} to {upper}.",
                     {lower, upper}));
    else
        card.line(sentence("The weights are now from {lower} to {upper}.", {lower, upper}));
    if (check.kept_difference && check.kept_difference->distance > 1e3 * check.difference.distance)
        card.line(
            sentence("With the old weights (red dots) the results would be {distance} apart at u = {u}.",
                     {{"distance", with_unit(units, number_text(in_units(units, check.kept_difference->distance), 3))},
                      {"u", number_text(check.kept_difference->parameter, 3)}}),
            CardTone::bad);
}

CardButtons kinds(const EditorState& state) {
    CardButtons row;
    for (const ShownMapKind kind : all_shown_maps)
        row.buttons.push_back({core::title_of(kind), ShowMap{.kind = kind, .amount = usual_amount(kind)},
                               state.view.shown_map.kind == kind});
    return row;
}

// What maps the curve as it is shown.
Command command_of(const ShownMap& shown, const core::Box& box) {
    constexpr MapTarget what = MapTarget::curve;
    const double amount = shown.amount;
    switch (shown.kind) {
        case ShownMapKind::rotate:
            return Rotate{.angle = amount, .what = what};
        case ShownMapKind::scale:
            return Scale{.factor = amount, .what = what};
        case ShownMapKind::stretch:
            return Stretch{.along_x = amount, .along_y = 1.0 / amount, .what = what};
        case ShownMapKind::shear:
            return Shear{.axis = ShearAxis::x, .factor = amount, .what = what};
        case ShownMapKind::mirror:
            return Mirror{.angle = amount, .what = what};
        case ShownMapKind::project:
            break;
    }
    const auto rows = core::about_origin(map_over(shown, box)).rows;
    const auto list = [](const std::array<double, 3>& row) { return std::vector<double>(row.begin(), row.end()); };
    return MapProjectively{.x_row = list(rows[0]), .y_row = list(rows[1]), .w_row = list(rows[2]), .what = what};
}

CardButtons amounts(const EditorState& state, const core::Box& box) {
    const ShownMap& shown = state.view.shown_map;
    const auto by = [&](double step) {
        const double amount = amounts_of(shown.kind).clamp(shown.amount + step);
        return ShowMap{.kind = shown.kind, .amount = amount};
    };
    const double step = amount_step(shown.kind);
    return {{{"Less", by(-step)}, {"More", by(step)}, {"Map the curve so", command_of(shown, box)}}};
}

}  // namespace

Card invariance_card(const EditorState& state) {
    Card card{"Map and evaluate", {}};
    const core::Curve* curve = state.active_curve();
    if (curve == nullptr) {
        card.line("There is no curve to map; an example has one.");
        card.add(CardButtons{{{"Open an example", OpenExample{.name = "wave"}}}});
        return card;
    }
    const ShownMap& shown = state.view.shown_map;
    card.line(map_words(shown), CardTone::strong);
    card.add(kinds(state));
    const core::Box box = state.derived.of(*curve)->control_box;
    card.add(amounts(state, box));
    const core::PlaneMap map = map_over(shown, box);
    const auto check = state.derived.map_check({*curve, map});
    if (!check->image) {
        card.line(sentence("This map is not possible here: {problem}.",
                           {{"problem", refusal_words(state.shown().units, check->image.error())}}),
                  CardTone::bad);
        return card;
    }
    card.add(invariance_picture(state, {*curve, map}, check));
    add_both_ways(card, state, *curve, map, *check);
    add_verdict(card, *check);
    if (map.is_affine())
        add_affine_reason(card, *curve);
    else
        add_projective_reason(card, state, *curve, *check);
    return card;
}

}  // namespace batten::editor
