#include "app/editor/derived/bezier_points.h"

#include <fmt/core.h>

#include <algorithm>

namespace batten::editor {

namespace {

/// The place of the span among the non-empty ones.
std::size_t piece_number(const core::KnotVector& knots, const KnotFacts& facts, std::size_t span) {
    const auto stored = knots.stored();
    const auto count_up_to = [&](double u) {
        const auto above = std::ranges::upper_bound(facts.runs, u, {}, [&](std::uint32_t i) { return stored[i]; });
        return static_cast<std::size_t>(above - facts.runs.begin());
    };
    return count_up_to(knots[span]) - count_up_to(knots.domain().lower);
}

}  // namespace

NamedPiece named_piece(const core::Curve& curve, const KnotFacts& facts, std::size_t span) {
    const core::KnotVector& knots = curve.knots();
    const auto p = static_cast<std::size_t>(curve.degree());
    const std::size_t between = facts.is_torn() ? p + 1 : p;
    const std::size_t first = between * piece_number(knots, facts, span);
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k <= p; ++k) numbers.push_back(first + k);
    if (curve.is_periodic()) numbers.back() %= p * facts.segment_count;
    const bool is_complete =
        knots.multiplicity(knots[span]) >= curve.degree() && knots.multiplicity(knots[span + 1]) >= curve.degree();
    return {core::bezier_piece(curve, span), std::move(numbers), is_complete};
}

std::string bezier_name(std::size_t number) {
    return fmt::format("b_{{{}}}", number);
}

}  // namespace batten::editor
