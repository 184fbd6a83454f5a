#include "app/editor/state/notation.h"

#include <cctype>
#include <string_view>

#include "app/editor/words/formula.h"
#include "core/base/fraction.h"

namespace batten::editor {

namespace {

bool is_latin_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0;
}

bool is_part_of_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '\'';
}

/// Whether the letter at `place` stands by itself; an index may follow it.
bool stands_alone(std::string_view text, std::size_t place) {
    const bool begins = place == 0 || !is_part_of_word(text[place - 1]);
    const bool ends = place + 1 == text.size() || !is_latin_letter(text[place + 1]);
    return begins && ends;
}

template <core::HasNames Enum>
void read(const std::map<std::string, std::string>& names, const char* name, Enum& value) {
    const auto found = names.find(name);
    if (found != names.end()) value = core::value_named<Enum>(found->second).value_or(value);
}

}  // namespace

std::string notated(const std::string& text, const Notation& notation) {
    std::string result = text;
    const char point = core::name_of(notation.points)[0];
    const bool has_t = notation.parameter == ParameterLetter::t;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char letter = text[i];
        if ((letter != 'P' && letter != 'u' && letter != 'U') || !stands_alone(text, i)) continue;
        if (letter == 'P')
            result[i] = point;
        else if (has_t)
            result[i] = letter == 'u' ? 't' : 'T';
    }
    return result;
}

std::string exact_text(const Notation& notation, double value, int digits) {
    const auto fraction =
        notation.numbers == NumberStyle::fractions ? core::small_fraction(value) : std::optional<core::Fraction>();
    if (!fraction || fraction->denominator == 1) return number_text(value, digits);
    std::string text = core::fraction_text(*fraction);
    if (text.front() == '-') text.replace(0, 1, true_minus);
    return text;
}

std::map<std::string, std::string> names_of(const Notation& notation) {
    return {{"points", std::string(core::name_of(notation.points))},
            {"parameter", std::string(core::name_of(notation.parameter))},
            {"degree", std::string(core::name_of(notation.degree))},
            {"triangles", std::string(core::name_of(notation.triangles))},
            {"numbers", std::string(core::name_of(notation.numbers))}};
}

Notation notation_named(const std::map<std::string, std::string>& names) {
    Notation notation;
    read(names, "points", notation.points);
    read(names, "parameter", notation.parameter);
    read(names, "degree", notation.degree);
    read(names, "triangles", notation.triangles);
    read(names, "numbers", notation.numbers);
    return notation;
}

}  // namespace batten::editor
