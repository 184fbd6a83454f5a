#include "app/editor/cards/card_texts.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/editor/commands/file_commands.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/number_column.h"

namespace batten::editor {

std::string short_text(const Notation& notation, double value) {
    constexpr std::size_t most_letters = 4;
    const std::string size = exact_text(notation, std::abs(value));
    return size.size() <= most_letters ? exact_text(notation, value) : number_text(value);
}

std::string pair_text(const Notation& notation, core::Vector pair) {
    return fmt::format("({}, {})", short_text(notation, pair.x), short_text(notation, pair.y));
}

std::string coordinate_text(const Notation& notation, double size, double value) {
    constexpr double rounding = 1e-14;
    constexpr int least_digits = 4;
    constexpr int most_digits = 17;
    if (std::abs(value) <= rounding * size) return "0";
    const int whole = std::abs(value) >= 1.0 ? static_cast<int>(std::log10(std::abs(value))) + 1 : 0;
    return exact_text(notation, value, std::clamp(whole + decimals_for(size), least_digits, most_digits));
}

std::string position_text(const Notation& notation, double size, core::Point place) {
    return fmt::format("({}, {})", coordinate_text(notation, size, place.x), coordinate_text(notation, size, place.y));
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
