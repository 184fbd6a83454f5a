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

// As people read it.
double shown(const Findings& findings, const FoundNumber& number) {
    return in_units(findings.units, unless_noise(number.value, number.error), number.power);
}

core::Point shown(const Findings& findings, core::Point place) {
    const double error = findings.coordinate_error;
    return in_units(findings.units, core::Point(unless_noise(place.x, error), unless_noise(place.y, error)));
}

FindingColumns columns_of(const Findings& findings) {
    std::vector<double> parameters;
    std::vector<double> coordinates;
    std::map<std::string, std::vector<double>> numbers;
    for (const Finding& row : findings.rows) {
        if (row.parameter) parameters.push_back(*row.parameter);
        if (row.point) {
            const core::Point place = shown(findings, *row.point);
            coordinates.insert(coordinates.end(), {place.x, place.y});
        }
        for (const FoundNumber& number : row.numbers) numbers[number.name].push_back(shown(findings, number));
    }
    FindingColumns columns{column_for(parameters), column_for(coordinates), {}};
    for (const auto& [name, values] : numbers) columns.numbers[name] = column_for(values);
    return columns;
}

std::string place_of_finding(const Findings& findings, core::Point place) {
    const core::Point point = shown(findings, place);
    const auto text = [&](double value) { return column_text(value, findings.columns.coordinate); };
    return with_unit(findings.units, fmt::format("({}, {})", text(point.x), text(point.y)));
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
            fmt::format("{} {}", number.name,
                        with_unit(findings.units, column_text(shown(findings, number), style), number.power)));
    }
    return fmt::format("{}", fmt::join(parts, "   "));
}

std::string full_text(const Findings& findings, const Finding& row) {
    std::vector<std::string> lines{row.label};
    const auto add = [&](const std::string& name, double value, int power) {
        lines.push_back(fmt::format("{} = {}", name, with_unit(findings.units, core::shortest_text(value), power)));
    };
    if (row.parameter) add("u", *row.parameter, 0);
    if (row.point) add("x", shown(findings, *row.point).x, 1);
    if (row.point) add("y", shown(findings, *row.point).y, 1);
    for (const FoundNumber& number : row.numbers) add(number.name, shown(findings, number), number.power);
    if (!row.note.empty()) lines.push_back(row.note);
    return fmt::format("{}", fmt::join(lines, "\n"));
}

void show_findings(EditorState& state, Findings findings) {
    findings.units = units_of(state);
    findings.columns = columns_of(findings);
    state.message = {findings.summary, false};
    state.findings = std::move(findings);
}

}  // namespace batten::editor
