/// What a teaching view says beside the canvas, as data: lines, tables, pictures and buttons.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/editor/command.h"
#include "app/editor/scene/pen.h"
#include "app/editor/state/selection.h"

namespace batten::editor {

/// How a text stands out.
enum class CardTone { plain, dim, strong, good, bad, parameter, accent };

/// A text in the notation of render::Label. Where it has something to point at, hovering it lights that, and it is lit
/// while that is hovered anywhere.
struct CardText {
    std::string text;
    CardTone tone = CardTone::plain;
    Hover hover{};
    std::optional<render::Color> color{};  ///< in place of the tone's
    std::optional<Command> command{};      ///< run by a click
};

/// One text, broken into lines where it is too long; formulas are set in the font of numbers.
struct CardLine {
    CardText text;
    bool is_formula = false;
};

/// The text of a line that shows nothing, where as many lines shall stand whatever is told.
inline constexpr const char* blank_line = "\u00a0";

/// Rows of cells that stand in columns, as wide as their texts; cells of the first row are headings where
/// `has_heading`. A row of one cell beside longer ones reaches over all columns.
struct CardTable {
    std::vector<std::vector<CardText>> rows;
    bool has_heading = false;
};

/// Part of a picture that can be pointed at.
struct CardPlace {
    std::string name;  ///< "cell 1 2"; unique in the card
    render::PixelBox box;
    Hover hover;
    std::string value;  ///< what it says, for tests and tool tips
};

/// What a picture shows at its size.
struct CardDrawing {
    render::DrawList list;
    std::vector<CardPlace> places;
};

/// A picture as wide as the card.
struct CardPicture {
    double height = 0.0;                                                ///< design pixels
    std::function<CardDrawing(glm::dvec2 size_px, double scale)> draw;  ///< `scale` is pixels for a design pixel
    double least_width = 0.0;  ///< design pixels; a narrower card scrolls sideways
};

/// Buttons side by side, in as many rows as it takes.
struct CardButton {
    std::string text;
    Command command;
    bool is_active = false;
};
struct CardButtons {
    std::vector<CardButton> buttons;
};

using CardBlock = std::variant<CardLine, CardTable, CardPicture, CardButtons>;

struct Card {
    std::string title;
    std::vector<CardBlock> blocks;

    Card& line(std::string text, CardTone tone = CardTone::plain);
    Card& formula(std::string text, CardTone tone = CardTone::plain);
    Card& add(CardBlock block);
};

/// All texts of a card in plain Unicode, one in a line, the cells of a row with " | " between them: for tests and for
/// what is read aloud.
std::string card_text(const Card& card);

}  // namespace batten::editor
