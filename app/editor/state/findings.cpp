#include "app/editor/state/findings.h"

#include <fmt/format.h>

#include <cmath>

#include "app/editor/state/state.h"
#include "app/editor/words/reading_text.h"
#include "core/base/number_text.h"

namespace batten::editor {

namespace {

double unless_noise(double value, double error) {
    return std::abs(value) <= error ? 0.0 : value;
}

FindingColumns columns_of(const Findings& findings) {
    std::vector<double> parameters;
    std::vector<double> coordinates;
    std::map<std::string, std::vector<double>> numbers;
    for (const Finding& row : findings.rows) {
        if (row.parameter) parameters.push_back(*row.parameter);
        if (row.point)
            for (const double value : {row.point->x, row.point->y})
                coordinates.push_back(unless_noise(value, findings.coordinate_error));
        for (const FoundNumber& number : row.numbers)
            numbers[number.name].push_back(unless_noise(number.value, number.error));
    }
    FindingColumns columns{column_for(parameters), column_for(coordinates), {}};
    for (const auto& [name, values] : numbers) columns.numbers[name] = column_for(values);
    return columns;
}

std::string place_of_finding(const Findings& findings, core::Point place) {
    const auto text = [&](double value) {
        return column_text(unless_noise(value, findings.coordinate_error), findings.columns.coordinate);
    };
    return fmt::format("({}, {})", text(place.x), text(place.y));
}

}  // namespace

std::string details_text(const Findings& findings, const Finding& row) {
    std::vector<std::string> parts;
    if (!row.note.empty()) parts.push_back(reading_text(row.note));
    if (row.point) parts.push_back(place_of_finding(findings, *row.point));
    for (const FoundNumber& number : row.numbers) {
        const auto column = findings.columns.numbers.find(number.name);
        const NumberColumn style = column == findings.columns.numbers.end() ? NumberColumn{} : column->second;
        parts.push_back(
            fmt::format("{} {}", number.name, column_text(unless_noise(number.value, number.error), style)));
    }
    return fmt::format("{}", fmt::join(parts, "   "));
}

std::string full_text(const Findings& findings, const Finding& row) {
    std::vector<std::string> lines{row.label};
    const auto add = [&lines](const std::string& name, double value) {
        lines.push_back(fmt::format("{} = {}", name, core::shortest_text(value)));
    };
    if (row.parameter) add("u", *row.parameter);
    if (row.point) add("x", unless_noise(row.point->x, findings.coordinate_error));
    if (row.point) add("y", unless_noise(row.point->y, findings.coordinate_error));
    for (const FoundNumber& number : row.numbers) add(number.name, unless_noise(number.value, number.error));
    if (!row.note.empty()) lines.push_back(row.note);
    return fmt::format("{}", fmt::join(lines, "\n"));
}

void show_findings(EditorState& state, Findings findings) {
    findings.columns = columns_of(findings);
    state.message = {findings.summary, false};
    state.findings = std::move(findings);
}

}  // namespace batten::editor
