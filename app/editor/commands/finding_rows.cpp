#include "app/editor/commands/finding_rows.h"

#include <fmt/core.h>

namespace batten::editor {

core::Place active_name(const EditorState& state) {
    return {"name", state.history.present().active_curve()->name};
}

void add_numbers(Finding& finding, const char* name, core::Vector vector) {
    finding.numbers.push_back({fmt::format("{} x", name), vector.x});
    finding.numbers.push_back({fmt::format("{} y", name), vector.y});
}

void add_numbers(Finding& finding, const char* name, core::Point point) {
    add_numbers(finding, name, core::vector_to(point));
}

void add_interval(Finding& finding, core::Interval where) {
    if (where.length() == 0.0) return;
    finding.numbers.push_back({"from", where.lower});
    finding.numbers.push_back({"to", where.upper});
}

Outcome<void> show_rows(EditorState& state, const char* title, std::string summary, std::vector<Finding> rows) {
    show_findings(state, {title, std::move(summary), std::move(rows)});
    return {};
}

Outcome<void> show_counted_rows(EditorState& state, const char* title, const core::PluralPattern& summary,
                                std::vector<Finding> rows) {
    std::string text = core::sentence(summary, rows.size(), {active_name(state)});
    return show_rows(state, title, std::move(text), std::move(rows));
}

}  // namespace batten::editor
