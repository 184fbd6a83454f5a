#include <algorithm>
#include <ostream>
#include <string>

#include "app/cli/basis_rows.h"
#include "app/cli/input.h"
#include "app/cli/say.h"
#include "app/cli/table_argument.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"

namespace batten::cli {

namespace {

std::string place_of(const core::DocumentCurve& entry) {
    return core::sentence("curve '{name}'", {{"name", entry.name}});
}

// The parameters that the words stand for; none after saying why not.
std::optional<std::vector<double>> parameters_of(const EvalOptions& options, Output output) {
    std::vector<double> parameters;
    for (const std::string& word : options.at) {
        if (!names_table(word)) {
            parameters.push_back(core::leading_number(word)->value);
            continue;
        }
        const auto table = read_table(word, TableContent::numbers);
        if (!table) {
            say(output, table.error().sentence());
            return std::nullopt;
        }
        parameters.insert(parameters.end(), table->numbers.begin(), table->numbers.end());
    }
    return parameters;
}

// The parameters must lie in the domain of an open curve; a periodic one goes on for ever.
bool are_parameters_inside(const std::vector<double>& parameters, const EvalOptions& options, Output output,
                           const core::DocumentCurve& entry) {
    const core::Curve& curve = *entry.curve;
    for (const double u : parameters) {
        if (curve.is_periodic() || curve.domain().contains(u)) continue;
        const core::CurveError error{.code = core::CurveErrorCode::parameter_outside_domain,
                                     .value = u,
                                     .lower = curve.domain().lower,
                                     .upper = curve.domain().upper};
        say_error(output, options.file, place_of(entry), core::describe(error));
        return false;
    }
    return true;
}

bool is_finite(const core::Jet& jet) {
    return core::is_finite(jet.point) && std::all_of(jet.derivatives.begin(), jet.derivatives.end(),
                                                     [](core::Vector vector) { return core::is_finite(vector); });
}

void append_row(std::string& text, double u, const core::Jet& jet) {
    const auto append_pair = [&](const auto& pair) {
        text += '\t';
        core::append_shortest_text(text, pair.x);
        text += '\t';
        core::append_shortest_text(text, pair.y);
    };
    core::append_shortest_text(text, u);
    append_pair(jet.point);
    for (const core::Vector& derivative : jet.derivatives) append_pair(derivative);
    text += '\n';
}

// `before`, and a number as print() prints those of a double.
void append_json(std::string& text, const char* before, double value) {
    text += before;
    const std::size_t begin = text.size();
    core::append_json_text(text, value);
    const bool looks_whole = text.find_first_of(".e", begin) == std::string::npos;
    text += looks_whole ? ".0" : "";
}

// The row as print() prints a member of a list: it would take most of the time to make JSON values of a million.
void append_json_row(std::string& text, double u, const core::Jet& jet) {
    append_json(text, text.empty() ? "[\n  {\n    \"u\": " : ",\n  {\n    \"u\": ", u);
    append_json(text, ",\n    \"point\": [\n      ", jet.point.x);
    append_json(text, ",\n      ", jet.point.y);
    const char* before = "\n    ],\n    \"derivatives\": [\n      [\n        ";
    for (const core::Vector& derivative : jet.derivatives) {
        append_json(text, before, derivative.x);
        append_json(text, ",\n        ", derivative.y);
        before = "\n      ],\n      [\n        ";
    }
    text += jet.derivatives.empty() ? "\n    ],\n    \"derivatives\": []\n  }" : "\n      ]\n    ]\n  }";
}

// The points and derivatives, as basis_rows gives the functions.
tl::expected<std::string, double> point_rows(const core::Curve& curve, const std::vector<double>& parameters,
                                             const EvalOptions& options) {
    std::string text;
    for (const double u : parameters) {
        const core::Jet jet = core::derivatives_at(curve, u, options.derivatives, options.side);
        if (!is_finite(jet)) return tl::unexpected(u);
        options.as_json ? append_json_row(text, u, jet) : append_row(text, u, jet);
    }
    if (options.as_json) text += text.empty() ? "[]\n" : "\n]\n";
    return text;
}

}  // namespace

ExitStatus eval(const EvalOptions& options, Output output) {
    const std::optional<core::Document> document = load(output, options.file);
    if (!document) return ExitStatus::wrong_input;
    const std::optional<std::size_t> index = find_curve(output, options.file, *document, options.curve);
    if (!index) return ExitStatus::wrong_input;
    const core::DocumentCurve& entry = document->curves[*index];
    const auto parameters = parameters_of(options, output);
    if (!parameters || !are_parameters_inside(*parameters, options, output, entry)) return ExitStatus::wrong_input;

    const auto text =
        options.basis ? basis_rows(*entry.curve, *parameters, options) : point_rows(*entry.curve, *parameters, options);
    if (!text) {
        say_error(
            output, options.file, place_of(entry),
            core::sentence("the values at {u} are too large for a double", {{"u", core::shortest_text(text.error())}}));
        return ExitStatus::wrong_input;
    }
    output.results << *text;
    return ExitStatus::done;
}

}  // namespace batten::cli
