#include "app/editor/words/knot_text.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/editor/fields/expression.h"
#include "core/base/ascii.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::sentence;

constexpr std::size_t most_knots = 100000;

// Behind "T =", where the text begins so.
std::string_view without_name(std::string_view text) {
    text = core::trimmed(text);
    if (text.empty() || !core::is_letter(text.front()) || text.front() == 'p') return text;
    const std::string_view rest = core::trimmed(text.substr(1));
    return !rest.empty() && rest.front() == '=' ? core::trimmed(rest.substr(1)) : text;
}

// The text of the knots and that of the degree, which may be empty.
struct Parts {
    std::string_view knots;
    std::string_view degree;
};

std::string_view behind_p(std::string_view text) {
    text = core::trimmed(text, " \t\r\n,;");
    if (text.empty() || text.front() != 'p') return text;
    const std::string_view rest = core::trimmed(text.substr(1));
    return !rest.empty() && rest.front() == '=' ? core::trimmed(rest.substr(1)) : text;
}

// Where the parenthesis closes that `text` begins with.
std::size_t closing_parenthesis(std::string_view text) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '(') ++depth;
        if (text[i] == ')' && --depth == 0) return i;
    }
    return std::string_view::npos;
}

Parts divided(std::string_view text) {
    text = without_name(text);
    if (!text.empty() && text.front() == '(') {
        const std::size_t end = closing_parenthesis(text);
        if (end == std::string_view::npos) return {text, {}};
        return {text.substr(1, end - 1), behind_p(text.substr(end + 1))};
    }
    const std::size_t equals = text.rfind('=');
    if (equals == std::string_view::npos) return {text, {}};
    const std::string_view before = core::trimmed(text.substr(0, equals));
    if (before.empty() || before.back() != 'p') return {text, {}};
    return {core::trimmed(before.substr(0, before.size() - 1), " \t\r\n,;"), core::trimmed(text.substr(equals + 1))};
}

// What stands before and between "..." or "…".
std::vector<std::string_view> parts_of(std::string_view text) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = std::min(text.find("..."), text.find("…"));
        parts.push_back(core::trimmed(text.substr(0, end), " \t\r\n,;"));
        if (end == std::string_view::npos) return parts;
        // Both are three bytes long.
        text.remove_prefix(end + 3);
    }
}

double step_of(const std::vector<double>& knots) {
    const std::size_t count = knots.size();
    return count > 1 && knots[count - 1] > knots[count - 2] ? knots[count - 1] - knots[count - 2] : 1.0;
}

// The knots between the last one and `next`.
Outcome<void> fill_up(std::vector<double>& knots, double next) {
    const double first = knots.back();
    const double step = step_of(knots);
    const double steps = std::round((next - first) / step);
    if (!(steps >= 1.0) || std::abs(first + steps * step - next) > 1e-9 * std::abs(next - first))
        return tl::unexpected(sentence("the knots from {first} do not lead to {next} in steps of {step}",
                                       {{"first", core::shortest_text(first)},
                                        {"next", core::shortest_text(next)},
                                        {"step", core::shortest_text(step)}}));
    if (steps > static_cast<double>(most_knots))
        return tl::unexpected(sentence("that would be {count} knots; at most {most} can be written so",
                                       {{"count", core::shortest_text(steps)}, {"most", most_knots}}));
    for (double k = 1.0; k < steps; k += 1.0) knots.push_back(first + k * step);
    return {};
}

Outcome<std::vector<double>> read_knots(std::string_view text) {
    std::vector<double> knots;
    for (const std::string_view part : parts_of(text)) {
        const auto values = parse_expressions(part);
        if (!values)
            return tl::unexpected(sentence("the knots cannot be read: {problem}", {{"problem", values.error()}}));
        if (values->empty())
            return tl::unexpected(
                Refusal("knots are needed, like 0 0 0 1 2 3 3 3 or (0, ..., 7), and with \"...\" one "
                        "on both sides of it"));
        if (!knots.empty())
            if (auto filled = fill_up(knots, values->front()); !filled) return tl::unexpected(filled.error());
        knots.insert(knots.end(), values->begin(), values->end());
    }
    return knots;
}

}  // namespace

bool is_typed_vector(std::string_view text) {
    const std::string_view bare = without_name(text);
    if (bare.empty()) return false;
    if (bare.front() == '(' || bare.front() == '[' || bare.size() != core::trimmed(text).size()) return true;
    constexpr std::string_view begins = "0123456789.+-";
    constexpr std::string_view goes_on = "0123456789.,;+-*/^() \t=pe";
    return begins.find(bare.front()) != std::string_view::npos &&
           bare.find_first_of(" \t,;") != std::string_view::npos &&
           bare.find_first_not_of(goes_on) == std::string_view::npos;
}

Outcome<TypedVector> read_vector(std::string_view text) {
    const Parts parts = divided(text);
    Outcome<std::vector<double>> knots = read_knots(parts.knots);
    if (!knots) return tl::unexpected(knots.error());
    TypedVector vector{*std::move(knots)};
    if (parts.degree.empty()) return vector;
    const auto degree = parse_expression(parts.degree);
    if (!degree || *degree != std::round(*degree) || std::abs(*degree) > static_cast<double>(most_knots))
        return tl::unexpected(sentence("the degree is {found}; a whole number is needed", {{"found", parts.degree}}));
    vector.degree = static_cast<int>(*degree);
    return vector;
}

std::string vector_text(std::span<const double> knots, const NumberWriter& text_of) {
    constexpr std::size_t most = 24;
    constexpr std::size_t first = 12;
    constexpr std::size_t last = 6;
    const bool is_long = knots.size() > most;
    std::vector<std::string> entries;
    for (const double knot : knots.first(is_long ? first : knots.size())) entries.push_back(text_of(knot));
    if (is_long) entries.emplace_back("…");
    for (const double knot : knots.last(is_long ? last : 0)) entries.push_back(text_of(knot));
    return fmt::format("({})", fmt::join(entries, ", "));
}

}  // namespace batten::editor
