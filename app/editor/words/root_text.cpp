#include "app/editor/words/root_text.h"

#include <fmt/core.h>

#include <cstdint>
#include <numeric>

#include "core/base/fraction.h"

namespace batten::editor {

namespace {

constexpr std::int64_t greatest_denominator = 12;
constexpr std::int64_t greatest_radicand = 50;

/// factor root(radicand) / denominator, in lowest terms.
struct Root {
    std::int64_t factor = 1;
    std::int64_t radicand = 1;
    std::int64_t denominator = 1;
};

/// The root of n/d is that of nd over d.
Root root_of(core::Fraction square) {
    Root root{1, square.numerator * square.denominator, square.denominator};
    for (std::int64_t k = 2; k * k <= root.radicand; ++k)
        while (root.radicand % (k * k) == 0) {
            root.radicand /= k * k;
            root.factor *= k;
        }
    const std::int64_t common = std::gcd(root.factor, root.denominator);
    root.factor /= common;
    root.denominator /= common;
    return root;
}

}  // namespace

std::string root_text(const Notation& notation, double value) {
    std::string plain = exact_text(notation, value);
    if (notation.numbers != NumberStyle::fractions || !(value > 0.0) || core::small_fraction(value)) return plain;
    const auto square = core::small_fraction(value * value);
    if (!square || square->denominator > greatest_denominator || square->numerator > greatest_radicand) return plain;
    const Root root = root_of(*square);
    if (root.radicand > greatest_radicand) return plain;
    const std::string numerator =
        root.factor == 1 ? fmt::format("√{}", root.radicand) : fmt::format("{}√{}", root.factor, root.radicand);
    return root.denominator == 1 ? numerator : fmt::format("{}/{}", numerator, root.denominator);
}

}  // namespace batten::editor
