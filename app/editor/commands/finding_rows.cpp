#include "app/editor/commands/finding_rows.h"

#include <fmt/core.h>

#include <cmath>

#include "app/editor/words/wording.h"

namespace batten::editor {

namespace {

std::optional<std::string> number_out_of_range(const Finding& row) {
    for (const FoundNumber& number : row.numbers)
        if (!std::isfinite(number.value)) return number.name;
    if (row.point && !core::is_finite(*row.point)) return row.label;
    return std::nullopt;
}

}  // namespace

core::Place active_name(const EditorState& state) {
    return {"name", state.history.present().active_curve()->name};
}

namespace {

void add_pair(Finding& finding, const char* name, core::Vector pair, double error, int power) {
    finding.numbers.push_back({fmt::format("{} x", name), pair.x, error, power});
    finding.numbers.push_back({fmt::format("{} y", name), pair.y, error, power});
}

}  // namespace

void add_numbers(Finding& finding, const char* name, core::Vector vector, int power) {
    add_pair(finding, name, vector, rounding_error * core::robust_length(vector), power);
}

void add_numbers(Finding& finding, const char* name, core::Point point, double error) {
    add_pair(finding, name, core::vector_to(point), error, 1);
}

void add_interval(Finding& finding, core::Interval where) {
    if (where.length() == 0.0) return;
    finding.numbers.push_back({"from", where.lower});
    finding.numbers.push_back({"to", where.upper});
}

Outcome<void> show_rows(EditorState& state, const char* title, std::string summary, std::vector<Finding> rows) {
    for (const Finding& row : rows)
        if (const std::optional<std::string> number = number_out_of_range(row))
            return tl::unexpected(
                core::sentence("{number} of {name} cannot be computed: its points, weights or knots are too far apart, "
                               "too large or too small",
                               {active_name(state), {"number", *number}}));
    const double error = coordinate_error(*state.history.present().active_curve()->curve);
    show_findings(state, {title, std::move(summary), std::move(rows), error});
    return {};
}

Outcome<void> show_counted_rows(EditorState& state, const char* title, const core::PluralPattern& summary,
                                std::vector<Finding> rows) {
    std::string text = core::sentence(summary, rows.size(), {active_name(state)});
    return show_rows(state, title, std::move(text), std::move(rows));
}

}  // namespace batten::editor
