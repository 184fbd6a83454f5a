#include "app/editor/commands/typed_knot.h"

#include <algorithm>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/tear_commands.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/edit/knot_edit.h"

namespace batten::editor {

namespace {

// The knots before and after the stack of knot `index`, by their numbers; none beyond the first and the last.
struct Neighbors {
    std::optional<std::size_t> lower;
    std::optional<std::size_t> upper;
};

Neighbors neighbors_of(std::span<const double> knots, std::size_t index) {
    const auto [first, last] = std::equal_range(knots.begin(), knots.end(), knots[index]);
    Neighbors neighbors;
    if (first != knots.begin()) neighbors.lower = static_cast<std::size_t>(first - knots.begin()) - 1;
    if (last != knots.end()) neighbors.upper = static_cast<std::size_t>(last - knots.begin());
    return neighbors;
}

const char* pattern_of_range(const Neighbors& neighbors, bool joins_lower, bool joins_upper) {
    if (!neighbors.lower) return joins_upper ? "it must be at most {upper}" : "it must be below {upper}";
    if (!neighbors.upper) return joins_lower ? "it must be at least {lower}" : "it must be above {lower}";
    if (joins_lower && joins_upper) return "it must be from {lower} to {upper}";
    if (joins_lower) return "it must be at least {lower} and below {upper}";
    if (joins_upper) return "it must be above {lower} and at most {upper}";
    return "it must be above {lower} and below {upper}";
}

// What may be typed: values between the neighbors, and theirs unless they occur as often as is allowed.
std::string range_of_knot(const EditorState& state, std::size_t index, const Neighbors& neighbors) {
    const std::span<const double> knots = active_curve(state).knots().stored();
    const auto joins = [&](std::optional<std::size_t> neighbor) {
        return neighbor && core::set_knot(active_curve(state), index, knots[*neighbor], tears_of_active(state));
    };
    const auto text = [&](std::optional<std::size_t> neighbor) {
        return neighbor ? core::shortest_text(knots[*neighbor]) : "";
    };
    return core::filled_as_needed(pattern_of_range(neighbors, joins(neighbors.lower), joins(neighbors.upper)),
                                  {{"lower", text(neighbors.lower)}, {"upper", text(neighbors.upper)}});
}

// Which neighbor is in the way of a typed value.
std::optional<std::string> obstacle(const EditorState& state, std::size_t index, double u, const Neighbors& neighbors) {
    const std::span<const double> knots = active_curve(state).knots().stored();
    const auto found = [&](const char* pattern, std::size_t neighbor) {
        return core::filled_as_needed(pattern, {{"index", index},
                                                {"u", core::shortest_text(u)},
                                                {"neighbor", neighbor},
                                                {"value", core::shortest_text(knots[neighbor])},
                                                {"count", std::ranges::count(knots, knots[neighbor])}});
    };
    const char* above = "knot number {index} cannot be {u}, above knot number {neighbor}, which is {value}";
    const char* below = "knot number {index} cannot be {u}, below knot number {neighbor}, which is {value}";
    const char* full = "knot number {index} cannot be {u}, which occurs {count} times already";
    const auto [lower, upper] = neighbors;
    if (upper && u > knots[*upper]) return found(above, *upper);
    if (lower && u < knots[*lower]) return found(below, *lower);
    // One more than the degree is for edit_or_tear to speak of.
    if (core::set_knot(active_curve(state), index, u, core::Tears::allow)) return std::nullopt;
    if (upper && u == knots[*upper]) return found(full, *upper);
    if (lower && u == knots[*lower]) return found(full, *lower);
    return std::nullopt;
}

}  // namespace

std::optional<Refusal> refusal_of_typed_knot(const EditorState& state, std::size_t index, double u) {
    const Neighbors neighbors = neighbors_of(active_curve(state).knots().stored(), index);
    const auto found = obstacle(state, index, u, neighbors);
    if (!found) return std::nullopt;
    return core::sentence("{found}; {allowed}",
                          {{"found", *found}, {"allowed", range_of_knot(state, index, neighbors)}});
}

}  // namespace batten::editor
