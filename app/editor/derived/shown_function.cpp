#include "app/editor/derived/shown_function.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/evaluate/basis.h"

namespace batten::editor {

namespace {

// Of the functions on a span that repeat `index` the first; else its first repetition whose support begins in the
// domain.
std::size_t function_number(const core::KnotVector& knots, std::size_t span, std::size_t index) {
    if (!knots.is_periodic()) return index;
    const auto p = static_cast<std::size_t>(knots.degree());
    const std::size_t n = knots.control_point_count();
    for (std::size_t i = span - p; i <= span; ++i)
        if (i % n == index) return i;
    std::size_t number = index;
    while (number < p) number += n;
    return number;
}

}  // namespace

std::optional<ShownFunction> shown_function(const EditorState& state) {
    const core::Curve* curve = state.active_curve();
    if (curve == nullptr) return std::nullopt;
    const core::KnotVector& knots = curve->knots();
    const std::size_t n = curve->control_points().size();
    const auto& selected = state.selection.points;
    const core::BasisValues basis = core::basis_functions(knots, state.parameter());
    if (!selected.empty() && selected.front() < n)
        return ShownFunction{selected.front(), function_number(knots, basis.span, selected.front())};
    const core::BasisRow& values = basis.derivatives[0];
    const auto largest = static_cast<std::size_t>(std::ranges::max_element(values) - values.begin());
    const std::size_t number = basis.span - static_cast<std::size_t>(knots.degree()) + largest;
    return ShownFunction{number % n, number};
}

const char* basis_letter(const EditorState& state, const core::KnotVector& knots) {
    return state.derived.of(knots)->is_bezier ? "B" : "N";
}

std::string function_name(const EditorState& state, const core::KnotVector& knots, std::size_t i) {
    return fmt::format("{}_{{{},{}}}", basis_letter(state, knots), i, knots.degree());
}

std::optional<HoveredBasisCell> shown_basis_cell(const EditorState& state) {
    const std::optional<ShownFunction> function = shown_function(state);
    if (!function) return std::nullopt;
    if (const auto* cell = std::get_if<HoveredBasisCell>(&state.hover)) return *cell;
    return HoveredBasisCell{function->number, static_cast<std::size_t>(state.active_curve()->degree())};
}

}  // namespace batten::editor
