/// What the cards of uniform cubics share.
#pragma once

#include <optional>
#include <string>

#include "app/editor/cards/card.h"
#include "app/editor/derived/shown_cubic.h"

namespace batten::editor {

/// Where the shown active curve is no uniform cubic: what it lacks, and buttons that make it one or open an example.
std::optional<Card> card_of_lack(const EditorState& state, const char* title);

/// "P_{3}", which lights that control point.
std::string point_name(std::size_t i);
CardText point_cell(std::size_t i);

/// Which segment is shown, its parameters and t, and buttons for the segments beside it.
void add_segment_lines(Card& card, const EditorState& state, const ShownCubic& cubic);

/// A row of a table: a name, its formula, and its value.
std::vector<CardText> formula_row(std::string name, std::string formula, std::string value);

}  // namespace batten::editor
