#include "core/evaluate/basis_pieces.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <type_traits>

#include "core/base/exact_number.h"

namespace batten::core {

namespace {

// Everywhere a Number is a double or an ExactNumber.
template <class Number>
Number whole(int value) {
    if constexpr (std::is_same_v<Number, double>)
        return value;
    else
        return Fraction{value, 1};
}

template <class Number>
using Powers = std::vector<Number>;

// Whether a number left 64 bits, from which nothing comes back.
template <class Number>
bool is_lost(const Powers<Number>& powers) {
    if constexpr (std::is_same_v<Number, double>)
        return false;
    else
        return !std::ranges::all_of(powers, [](const Number& power) { return power.has_value(); });
}

// u = origin + length x.
template <class Number>
struct Substitution {
    Number origin;
    Number length;
};

// Adds (u - zero_at) / (one_at - zero_at) times `powers`, which are none where the function vanishes on the span.
template <class Number>
void add_ramped(Powers<Number>& sum, const Powers<Number>& powers, const Number& zero_at, const Number& one_at,
                const Substitution<Number>& u) {
    if (powers.empty()) return;
    sum.resize(powers.size() + 1, whole<Number>(0));
    const Number constant = (u.origin - zero_at) / (one_at - zero_at);
    const Number slope = u.length / (one_at - zero_at);
    for (std::size_t n = 0; n < powers.size(); ++n) {
        sum[n] = sum[n] + constant * powers[n];
        sum[n + 1] = sum[n + 1] + slope * powers[n];
    }
}

// The function over all its `knots` on their span `s`, by the triangle above N_{s,0} = 1; none where it is lost.
template <class Number>
Powers<Number> powers_on_span(const std::vector<Number>& knots, std::size_t s, const Substitution<Number>& u) {
    const std::size_t degree = knots.size() - 2;
    std::vector<Powers<Number>> functions(degree + 1);
    functions[s] = {whole<Number>(1)};
    for (std::size_t k = 1; k <= degree; ++k)
        for (std::size_t j = 0; j + k <= degree; ++j) {
            Powers<Number> sum;
            add_ramped(sum, functions[j], knots[j], knots[j + k], u);
            add_ramped(sum, functions[j + 1], knots[j + k + 1], knots[j + 1], u);
            if (is_lost(sum)) return {};
            functions[j] = std::move(sum);
        }
    return functions[0];
}

// None where two knots would become one, or one is no small fraction.
std::vector<ExactNumber> exact_knots(std::span<const double> knots) {
    std::vector<ExactNumber> exact;
    for (std::size_t j = 0; j < knots.size(); ++j) {
        exact.push_back(small_fraction(knots[j]));
        if (!exact[j]) return {};
        if (j > 0 && knots[j - 1] < knots[j] && exact[j - 1] == exact[j]) return {};
    }
    return exact;
}

template <class Number>
Substitution<Number> in_u(const std::vector<Number>&, std::size_t) {
    return {whole<Number>(0), whole<Number>(1)};
}

template <class Number>
Substitution<Number> in_t(const std::vector<Number>& knots, std::size_t s) {
    return {knots[s], knots[s + 1] - knots[s]};
}

// The member of BasisPiece where one form stands, and what it substitutes for u on span `s`.
template <class Number>
struct Form {
    PowerForm BasisPiece::*member;
    Substitution<Number> (*on_span)(const std::vector<Number>& knots, std::size_t s);
};

template <class Number>
constexpr std::array<Form<Number>, 2> forms{{{&BasisPiece::in_u, in_u}, {&BasisPiece::in_t, in_t}}};

// One form of all pieces as fractions; none where one of them is lost.
std::vector<std::vector<Fraction>> fractions_of(const std::vector<BasisPiece>& pieces, std::size_t i,
                                                const std::vector<ExactNumber>& knots, const Form<ExactNumber>& form) {
    std::vector<std::vector<Fraction>> result;
    for (const BasisPiece& piece : pieces) {
        const std::size_t s = piece.span - i;
        const Powers<ExactNumber> powers = powers_on_span(knots, s, form.on_span(knots, s));
        if (powers.empty()) return {};
        result.emplace_back();
        for (const ExactNumber& power : powers) result.back().push_back(power.value());
    }
    return result;
}

}  // namespace

std::vector<BasisPiece> basis_pieces(const KnotVector& knots, std::size_t i, int k) {
    assert(0 <= k && k <= knots.degree() && i + static_cast<std::size_t>(k) + 1 < knots.size());
    const std::span<const double> own = knots.values().subspan(i, static_cast<std::size_t>(k) + 2);
    const std::vector<double> rounded(own.begin(), own.end());
    std::vector<BasisPiece> pieces;
    for (std::size_t s = 0; s + 1 < own.size(); ++s) {
        if (own[s] == own[s + 1]) continue;
        BasisPiece piece{.span = i + s, .interval = {own[s], own[s + 1]}, .in_u = {}, .in_t = {}};
        for (const auto& form : forms<double>)
            (piece.*form.member).coefficients = powers_on_span(rounded, s, form.on_span(rounded, s));
        pieces.push_back(std::move(piece));
    }
    const std::vector<ExactNumber> exact = exact_knots(own);
    if (exact.empty()) return pieces;
    for (const auto& form : forms<ExactNumber>) {
        auto fractions = fractions_of(pieces, i, exact, form);
        for (std::size_t j = 0; j < fractions.size(); ++j) (pieces[j].*form.member).fractions = std::move(fractions[j]);
    }
    return pieces;
}

}  // namespace batten::core
