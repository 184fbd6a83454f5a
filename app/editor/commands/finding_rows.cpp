#include "app/editor/commands/finding_rows.h"

#include "app/editor/commands/active_curve.h"

namespace batten::editor {

const std::string& active_name(const EditorState& state) {
    return state.history.present().active_curve()->name;
}

std::string count_text(std::size_t count, const char* one, const char* many) {
    if (count == 0) return std::string("no ") + many;
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

void add_numbers(Finding& finding, const std::string& name, glm::dvec2 vector) {
    finding.numbers.push_back({name + " x", vector.x});
    finding.numbers.push_back({name + " y", vector.y});
}

Outcome<void> show_rows(EditorState& state, const char* title, const std::string& what, std::vector<Finding> rows) {
    show_findings(state, {title, active_name(state) + " " + what, std::move(rows)});
    return {};
}

CommandSpec measuring_command(const char* name, const char* title, const char* explanation, const char* submenu,
                              Outcome<void> (*act)(EditorState&, const Arguments&)) {
    return {.name = name,
            .title = title,
            .explanation = explanation,
            .group = CommandGroup::analyze,
            .submenu = submenu,
            .refusal = no_curve,
            .act = act};
}

}  // namespace batten::editor
