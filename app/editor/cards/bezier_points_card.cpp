#include "app/editor/cards/bezier_points_card.h"

#include <fmt/ranges.h>

#include "app/editor/cards/card_texts.h"
#include "app/editor/commands/edit_commands.h"
#include "app/editor/commands/file_commands.h"
#include "app/editor/commands/refinement_commands.h"
#include "app/editor/commands/subdivision_commands.h"
#include "app/editor/derived/bezier_points.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

/// "f(0, 0, 1/4)": the lower end p-k times, the upper one k times.
std::string blossom_of_point(const Notation& notation, const core::BezierPiece& piece, std::size_t k) {
    const std::size_t p = piece.points.size() - 1;
    std::vector<std::string> arguments(p - k, exact_text(notation, piece.interval.lower));
    arguments.insert(arguments.end(), k, exact_text(notation, piece.interval.upper));
    return fmt::format("f({})", fmt::join(arguments, ", "));
}

CardTable table_of_piece(const Notation& notation, double size, const NamedPiece& named) {
    constexpr std::size_t most_arguments = 5;  // more would not fit beside the place
    const core::BezierPiece& piece = named.piece;
    const bool has_blossoms = piece.points.size() <= most_arguments + 1;
    CardTable table{.rows = {{{.text = "point"}}}, .has_heading = true};
    if (has_blossoms) table.rows[0].push_back({.text = "blossom"});
    table.rows[0].push_back({.text = "place"});
    for (std::size_t k = 0; k < piece.points.size(); ++k) {
        std::vector<CardText> row{{.text = bezier_name(named.numbers[k]), .tone = CardTone::strong}};
        if (has_blossoms) row.push_back({.text = blossom_of_point(notation, piece, k)});
        row.push_back({.text = position_text(notation, size, core::project(piece.points[k]))});
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace

Card bezier_points_card(const EditorState& state) {
    Card card{.title = "Bézier points", .blocks = {}};
    const core::Curve* curve = state.active_curve();
    if (curve == nullptr) {
        card.line("There is no curve.");
        card.add(CardButtons{{{"Open an example", OpenExample{.name = "knot-insertion"}}}});
        return card;
    }
    const Notation& notation = state.view.notation;
    const std::size_t span = curve->knots().span_at(state.parameter());
    const NamedPiece named = named_piece(*curve, *state.derived.of(curve->knots()), span);
    card.line(core::sentence("The piece over [{lower}, {upper}], in which u is:",
                             {{"lower", exact_text(notation, named.piece.interval.lower)},
                              {"upper", exact_text(notation, named.piece.interval.upper)}}));
    card.add(table_of_piece(notation, state.derived.of(*curve)->size, named));
    card.line(
        named.is_complete
            ? "Both ends of the piece have multiplicity p: its Bézier points are control points of the curve."
            : "Insert the knots at both ends until they have multiplicity p: then these points are control points "
              "of the curve.",
        named.is_complete ? CardTone::good : CardTone::plain);
    card.add(CardButtons{{{"Insert the next knot", InsertForBezier{}}, {"All", ToBezier{}}, {"Undo", Undo{}}}});
    return card;
}

}  // namespace batten::editor
