#include "app/editor/cards/card_texts.h"

#include <fmt/core.h>

#include <cmath>

#include "app/editor/commands/file_commands.h"
#include "app/editor/words/formula.h"

namespace batten::editor {

std::string short_text(const Notation& notation, double value) {
    constexpr std::size_t most_letters = 4;
    const std::string size = exact_text(notation, std::abs(value));
    return size.size() <= most_letters ? exact_text(notation, value) : number_text(value);
}

std::string pair_text(const Notation& notation, core::Vector pair) {
    return fmt::format("({}, {})", short_text(notation, pair.x), short_text(notation, pair.y));
}

CardText tick(bool holds) {
    return {.text = holds ? "✓" : "✗", .tone = holds ? CardTone::good : CardTone::bad};
}

Card card_without_curve(Card card, const char* example) {
    card.line("There is no visible active curve.");
    card.add(CardButtons{{{.text = "Open an example", .command = OpenExample{.name = example}}}});
    return card;
}

}  // namespace batten::editor
