#include "app/editor/cards/halves_card.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/editor/cards/card_texts.h"
#include "app/editor/commands/piece_commands.h"
#include "app/editor/scene/halves.h"
#include "app/editor/words/cell_names.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

constexpr std::size_t most_listed_points = 8;

std::string joined_names(std::vector<std::string> names) {
    if (names.size() > most_listed_points) {
        names.erase(names.begin() + most_listed_points / 2, names.end() - most_listed_points / 2);
        names.insert(names.begin() + most_listed_points / 2, "…");
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string name_of_point(std::size_t i) {
    return fmt::format("P_{{{}}}", i);
}

std::vector<std::string> names_of_cells(const NamedTriangle& named, const std::vector<core::CellPlace>& cells) {
    std::vector<std::string> names;
    for (const core::CellPlace place : cells) names.push_back(named.point(place));
    return names;
}

/// Of the points `first` to `last` - 1; of very many the first and the last, which are enough for what joined_names()
/// leaves.
std::vector<std::string> names_of_points(std::size_t first, std::size_t last) {
    std::vector<std::string> names;
    const std::size_t left_out_from = std::min(last, first + most_listed_points);
    for (std::size_t i = first; i < left_out_from; ++i) names.push_back(name_of_point(i));
    for (std::size_t i = std::max(left_out_from, last > most_listed_points ? last - most_listed_points : 0); i < last;
         ++i)
        names.push_back(name_of_point(i));
    return names;
}

struct HalfText {
    const char* pattern;
    core::Interval domain;
    std::size_t point_count;
    std::vector<std::string> names;
    render::Color color;
};

void add_half(Card& card, const Notation& notation, const HalfText& half) {
    const std::string text = core::sentence(half.pattern, {{"begin", exact_text(notation, half.domain.lower)},
                                                           {"end", exact_text(notation, half.domain.upper)},
                                                           {"count", half.point_count}});
    card.add(CardLine{{.text = text, .tone = CardTone::strong, .color = half.color}});
    card.formula(joined_names(half.names));
}

void add_open_halves(Card& card, const EditorState& state, const NamedTriangle& named) {
    const core::SplitPolygons polygons = core::split_polygons(named.curve, named.triangle);
    const HalfColors colors = half_colors(shown_theme(state.view));
    const core::Interval domain = named.curve.domain();
    const std::size_t first = named.triangle.levels[0].front().index;
    const std::size_t after_last = named.triangle.levels[0].back().index + 1;
    const std::size_t n = named.curve.control_points().size();
    std::vector<std::string> before = names_of_points(0, first);
    for (std::string& name : names_of_cells(named, polygons.before)) before.push_back(std::move(name));
    std::vector<std::string> after = names_of_cells(named, polygons.after);
    for (std::string& name : names_of_points(after_last, n)) after.push_back(std::move(name));
    add_half(card, named.notation,
             {"Before u, over [{begin}, {end}]: {count} control points",
              {domain.lower, named.triangle.u},
              first + polygons.before.size(),
              std::move(before),
              colors.before});
    add_half(card, named.notation,
             {"After u, over [{begin}, {end}]: {count} control points",
              {named.triangle.u, domain.upper},
              polygons.after.size() + n - after_last,
              std::move(after),
              colors.after});
    if (core::is_at_tear(named.curve, named.triangle))
        card.line("The curve is torn at u: each part has an end of its own there.", CardTone::dim);
    else
        card.line("The new points are the two sides of the triangle; both polygons meet in C(u).", CardTone::dim);
    card.add(CardButtons{{{.text = "Split here", .command = Split{.u = named.triangle.u}}}});
}

void add_opened(Card& card, const EditorState& state, const NamedTriangle& named) {
    const core::SplitPolygons polygons = core::split_polygons(named.curve, named.triangle);
    card.line("A closed curve has no two halves: it is opened at u into one curve, which begins and ends in C(u).");
    const render::Color color = half_colors(shown_theme(state.view)).before;
    card.add(CardLine{{.text = "It begins with", .tone = CardTone::strong, .color = color}});
    card.formula(joined_names(names_of_cells(named, polygons.after)));
    card.add(CardLine{{.text = "and ends with", .tone = CardTone::strong, .color = color}});
    card.formula(joined_names(names_of_cells(named, polygons.before)));
    card.add(CardButtons{{{.text = "Open it here", .command = Split{.u = named.triangle.u}}}});
}

}  // namespace

Card halves_card(const EditorState& state) {
    if (state.active_curve() == nullptr) return card_without_curve({}, "cubic-de-boor");
    const core::Curve& curve = *state.active_curve();
    const core::DeBoorTriangle triangle = core::de_boor_triangle(curve, state.parameter());
    const NamedTriangle named{curve, triangle, state.view.notation};
    Card card;
    const core::Interval domain = curve.domain();
    if (curve.is_periodic())
        add_opened(card, state, named);
    else if (triangle.u == domain.lower || triangle.u == domain.upper)
        card.line("u is at an end of the curve, where there is nothing to split; move it inside.");
    else
        add_open_halves(card, state, named);
    return card;
}

}  // namespace batten::editor
