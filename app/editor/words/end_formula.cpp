#include "app/editor/words/end_formula.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/editor/words/formula.h"
#include "app/editor/words/wording.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

using core::EndDerivatives;
using core::filled_as_needed;
using core::Place;

// The places of all templates, as letters or as numbers.
std::vector<Place> letters_of(const EndDerivatives& at, const std::string& u) {
    const auto indexed = [](const char* letter, std::size_t i) { return fmt::format("{}_{{{}}}", letter, i); };
    std::vector<Place> places{{"u", u},
                              {"p", "p"},
                              {"end", indexed("P", at.end_point.index)},
                              {"near", indexed("P", at.near_point.index)},
                              {"end_weight", indexed("w", at.end_point.index)},
                              {"near_weight", indexed("w", at.near_point.index)},
                              {"end_knot", indexed("u", at.end_knot.index)},
                              {"near_knot", indexed("u", at.near.index)}};
    if (!at.second) return places;
    places.emplace_back("far", indexed("P", at.second->far_point.index));
    places.emplace_back("far_weight", indexed("w", at.second->far_point.index));
    places.emplace_back("far_knot", indexed("u", at.second->far.index));
    return places;
}

std::string pair_text(const Notation& notation, core::Vector v, int digits = 4) {
    return fmt::format("({}, {})", exact_text(notation, v.x, digits), exact_text(notation, v.y, digits));
}

// That tell the control points apart.
int digits_of_points(const EndDerivatives& at) {
    const core::Point end = at.end_point.point;
    const core::Point near = at.near_point.point;
    const core::Point far = at.second ? at.second->far_point.point : near;
    return std::max(digits_that_tell_apart(end.x, near.x, far.x), digits_that_tell_apart(end.y, near.y, far.y));
}

// "(1/2)" where a fraction stands below a bar.
std::string divisor_text(const Notation& notation, double value) {
    std::string text = exact_text(notation, value);
    return text.find('/') == std::string::npos ? text : fmt::format("({})", text);
}

std::vector<Place> end_numbers(const EndDerivatives& at, const Notation& notation) {
    const double far_value = at.second ? at.second->far.value : at.near.value;
    const int digits = digits_that_tell_apart(at.end_knot.value, at.near.value, far_value);
    const auto knot = [&](double value) { return parenthesized_if_negative(exact_text(notation, value, digits)); };
    const int digits_of_point = digits_of_points(at);
    const auto point = [&](core::Point place) { return pair_text(notation, core::vector_to(place), digits_of_point); };
    std::vector<Place> places{{"p", at.degree},
                              {"less", at.degree - 1},
                              {"end", point(at.end_point.point)},
                              {"near", point(at.near_point.point)},
                              {"end_weight", divisor_text(notation, at.end_point.weight)},
                              {"near_weight", divisor_text(notation, at.near_point.weight)},
                              {"end_knot", knot(at.end_knot.value)},
                              {"near_knot", knot(at.near.value)},
                              {"far_knot", knot(far_value)}};
    if (!at.second) return places;
    places.emplace_back("far", point(at.second->far_point.point));
    places.emplace_back("far_weight", exact_text(notation, at.second->far_point.weight));
    places.emplace_back("a", exact_text(notation, at.second->far_factor));
    places.emplace_back("b", exact_text(notation, at.second->near_factor));
    const double sign = at.end == core::CurveEnd::start ? 1.0 : -1.0;
    places.emplace_back("near_leg", pair_text(notation, sign * (at.near_point.point - at.end_point.point)));
    places.emplace_back("far_leg", pair_text(notation, sign * (at.second->far_point.point - at.near_point.point)));
    places.emplace_back("h", divisor_text(notation, at.near.distance));
    places.emplace_back("k", divisor_text(notation, at.second->far.distance));
    return places;
}

std::string value_line(const Notation& notation, core::Vector value) {
    if (!core::is_finite(value)) return "is too large for numbers";
    return core::sentence("= {value}", {{"value", pair_text(notation, without_rounding(value))}});
}

// One formula, by letters and by numbers, from the start inward and before the end.
struct Patterns {
    const char* symbols;
    const char* numbers;
};

constexpr Patterns first_at_start{"C′({u}) = p ({near} − {end})/({near_knot} − {end_knot})",
                                  "= {p} · ({near} − {end})/({near_knot} − {end_knot})"};
constexpr Patterns first_at_end{"C′({u}) = p ({end} − {near})/({end_knot} − {near_knot})",
                                "= {p} · ({end} − {near})/({end_knot} − {near_knot})"};
constexpr Patterns weighted_first_at_start{
    "C′({u}) = p {near_weight}/{end_weight} ({near} − {end})/({near_knot} − {end_knot})",
    "= {p} · {near_weight}/{end_weight} · ({near} − {end})/({near_knot} − {end_knot})"};
constexpr Patterns weighted_first_at_end{
    "C′({u}) = p {near_weight}/{end_weight} ({end} − {near})/({end_knot} − {near_knot})",
    "= {p} · {near_weight}/{end_weight} · ({end} − {near})/({end_knot} − {near_knot})"};

constexpr Patterns second_at_start{"C″({u}) = p (p − 1)/h (({far} − {near})/k − ({near} − {end})/h)",
                                   "= {p} · {less}/{h} · ({far_leg}/{k} − {near_leg}/{h})"};
constexpr Patterns second_at_end{"C″({u}) = p (p − 1)/h (({end} − {near})/h − ({near} − {far})/k)",
                                 "= {p} · {less}/{h} · ({near_leg}/{h} − {far_leg}/{k})"};

constexpr Patterns weighted_second{"C″({u}) = a ({far} − {end}) − b ({near} − {end})",
                                   "= {a} · ({far} − {end}) − {b} · ({near} − {end})"};
constexpr const char* distances_at_start = "h = {near_knot} − {end_knot} = {h}, k = {far_knot} − {end_knot} = {k}";
constexpr const char* distances_at_end = "h = {end_knot} − {near_knot} = {h}, k = {end_knot} − {far_knot} = {k}";
constexpr Patterns far_factor{"a = p (p − 1)/(h k) {far_weight}/{end_weight}", "= {a}"};
constexpr Patterns near_factor{
    "b = p (p − 1)/h (1/h + 1/k) {near_weight}/{end_weight} + 2 p^{{2}}/h^{{2}} ({near_weight} − {end_weight}) "
    "{near_weight}/{end_weight}^{{2}}",
    "= {b}"};

}  // namespace

EndFormula first_end_formula(const EndDerivatives& at, const Notation& notation) {
    const bool is_start = at.end == core::CurveEnd::start;
    const Patterns& patterns = at.near_point.weight == at.end_point.weight
                                   ? (is_start ? first_at_start : first_at_end)
                                   : (is_start ? weighted_first_at_start : weighted_first_at_end);
    return {filled_as_needed(patterns.symbols, letters_of(at, exact_text(notation, at.end_knot.value))),
            {filled_as_needed(patterns.numbers, end_numbers(at, notation)), value_line(notation, at.first)}};
}

EndFormula second_end_formula(const EndDerivatives& at, const Notation& notation) {
    const bool is_start = at.end == core::CurveEnd::start;
    auto letters = letters_of(at, exact_text(notation, at.end_knot.value));
    letters.emplace_back("h", exact_text(notation, at.near.distance));
    letters.emplace_back("k", exact_text(notation, at.second->far.distance));
    const auto numbers = end_numbers(at, notation);
    const Patterns& whole = at.is_rational ? weighted_second : is_start ? second_at_start : second_at_end;
    EndFormula formula{filled_as_needed(whole.symbols, letters),
                       {filled_as_needed(is_start ? distances_at_start : distances_at_end, letters)}};
    if (at.is_rational)
        for (const Patterns& part : {far_factor, near_factor}) {
            formula.numbers.push_back(filled_as_needed(part.symbols, letters));
            formula.numbers.push_back(filled_as_needed(part.numbers, numbers));
        }
    formula.numbers.push_back(filled_as_needed(whole.numbers, numbers));
    formula.numbers.push_back(value_line(notation, at.second->value));
    return formula;
}

}  // namespace batten::editor
