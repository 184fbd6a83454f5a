#include "app/editor/cards/curvature_card.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/editor/cards/card_texts.h"
#include "app/editor/commands/construction_commands.h"
#include "app/editor/scene/bend_marks.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/number_column.h"
#include "core/base/sentence.h"
#include "core/evaluate/de_boor_polygons.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/tangent.h"
#include "core/measure/curvature.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr std::size_t most_bend_rows = 12;

struct BendRow {
    double u = 0.0;
    std::string what;
    std::string curvature;
};

std::vector<BendRow> bend_rows(const EditorState& state, const Bends& bends) {
    std::vector<BendRow> rows;
    for (const core::Inflection& inflection : bends.inflections)
        rows.push_back({inflection.u, "inflection", inflection.is_jump ? "jumps" : "0"});
    for (const core::CurvatureExtremum& extremum : bends.extrema)
        rows.push_back({extremum.u, extremum.is_maximum ? "maximum" : "minimum",
                        short_text(state.view.notation, extremum.curvature)});
    std::ranges::stable_sort(rows, {}, &BendRow::u);
    return rows;
}

CardTable table_of_bends(const core::Curve& curve, const std::vector<BendRow>& rows) {
    CardTable table{.rows = {{{.text = "u"}, {.text = "what"}, {.text = "κ"}}}, .has_heading = true};
    for (std::size_t k = 0; k < rows.size() && k < most_bend_rows; ++k)
        table.rows.push_back({{.text = parameter_text(curve, rows[k].u),
                               .hover = HoveredCurve{rows[k].u},
                               .command = SetParameter{.u = rows[k].u}},
                              {.text = rows[k].what, .hover = HoveredCurve{rows[k].u}},
                              {.text = rows[k].curvature}});
    return table;
}

}  // namespace

Card osculating_circle_card(const EditorState& state) {
    Card card{.title = "Osculating circle", .blocks = {}};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return card_without_curve(std::move(card));
    const Notation& notation = state.view.notation;
    const double u = state.parameter();
    const core::Jet at = core::derivatives_at(*curve, u, 2);
    const auto curvature = core::curvature_at(*curve, u);
    card.formula("κ = det(C′, C″) / |C′|^{3}");
    if (!curvature) return card.line("The curve stands still here, so it has no curvature.", CardTone::bad), card;
    const double speed = core::robust_length(at[1]);
    card.formula(fmt::format("C′ = {}", pair_text(notation, at[1])));
    card.formula(fmt::format("C″ = {}", pair_text(notation, at[2])));
    card.formula(fmt::format("κ({}) = {} / {}^{{3}}", parameter_text(*curve, u),
                             short_text(notation, core::cross(at[1], at[2])), short_text(notation, speed)));
    card.formula(fmt::format("κ({}) = {}", parameter_text(*curve, u), short_text(notation, *curvature)),
                 CardTone::strong);
    const auto circle = core::osculating_circle(*curve, u);
    if (!circle) return card.line("The curve does not bend here: its circle is a straight line."), card;
    card.formula(fmt::format("ρ = 1/|κ| = {}", short_text(notation, circle->radius)), CardTone::strong);
    card.formula(fmt::format(
        "M = {}", position_text(notation, std::max(state.derived.of(*curve)->size, circle->radius), circle->center)));
    card.line(*curvature > 0.0 ? "The curve turns left: the center is on the left."
                               : "The curve turns right: the center is on the right.");
    return card;
}

Card tangent_normal_card(const EditorState& state) {
    Card card{.title = "Tangent and normal", .blocks = {}};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return card_without_curve(std::move(card));
    const Notation& notation = state.view.notation;
    const double u = state.parameter();
    const core::Jet at = core::derivatives_at(*curve, u, 1);
    card.formula(fmt::format("C′({}) = {}", parameter_text(*curve, u), pair_text(notation, at[1])));
    card.formula(fmt::format("|C′| = {}", short_text(notation, core::robust_length(at[1]))));
    const auto tangent = core::tangent_at(*curve, u);
    if (!tangent) return card.line("The piece is a single point, so it has no tangent.", CardTone::bad), card;
    card.formula(fmt::format("T = C′/|C′| = {}", pair_text(notation, *tangent)), CardTone::strong);
    card.formula(fmt::format("N = {}", pair_text(notation, core::turned_left(*tangent))), CardTone::strong);
    const auto left = core::tangent_at(*curve, u, core::Side::left);
    constexpr double corner = 1e-9;
    if (core::is_at_tear(*curve, core::de_boor_triangle(*curve, u)))
        card.line("The curve is torn here; this is the tangent of the part that begins.");
    else if (left && core::length(*left - *tangent) > corner)
        card.line("The curve has a corner here; dashed is its tangent from the left.");
    return card;
}

Card curvature_marks_card(const EditorState& state) {
    Card card{.title = "Inflections and extremes", .blocks = {}};
    const core::Curve* curve = state.visible_active_curve();
    if (curve == nullptr) return card_without_curve(std::move(card));
    if (!is_searched_whole(*curve)) {
        card.line(sentence("The curve has more than {count} spans: what is seen is searched once it has no more.",
                           {{"count", most_bent_spans}}));
        return card;
    }
    const auto bends = state.measured.bends(*curve, {curve->domain()});
    if (bends->inflections.empty() && bends->extrema.empty())
        card.line("Its curvature has neither a change of sign nor an extreme.");
    if (!bends->inflections.empty())
        card.line(sentence({.one = "1 inflection, where the curve turns from one side to the other",
                            .many = "{count} inflections, where the curve turns from one side to the other"},
                           bends->inflections.size()));
    if (!bends->extrema.empty())
        card.line(sentence({.one = "1 extreme of the curvature", .many = "{count} extremes of the curvature"},
                           bends->extrema.size()));
    const std::vector<BendRow> rows = bend_rows(state, *bends);
    if (!rows.empty()) card.add(table_of_bends(*curve, rows));
    if (rows.size() > most_bend_rows)
        card.line(sentence("Showing {shown} of {count}", {{"shown", most_bend_rows}, {"count", rows.size()}}),
                  CardTone::dim);
    return card;
}

}  // namespace batten::editor
