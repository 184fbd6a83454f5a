#include <algorithm>
#include <ostream>
#include <sstream>

#include "app/cli/input.h"
#include "app/cli/json_output.h"
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
        const auto numbers = read_table(word, TableLine::numbers);
        if (!numbers) {
            output.errors << numbers.error().sentence() << '\n';
            return std::nullopt;
        }
        parameters.insert(parameters.end(), numbers->begin(), numbers->end());
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

void print_row(std::ostream& out, double u, const core::Jet& jet) {
    const auto print_pair = [&](const auto& pair) {
        out << '\t' << core::shortest_text(pair.x) << '\t' << core::shortest_text(pair.y);
    };
    out << core::shortest_text(u);
    print_pair(jet.point);
    for (const core::Vector& derivative : jet.derivatives) print_pair(derivative);
    out << '\n';
}

Json json_of_row(double u, const core::Jet& jet) {
    Json derivatives = Json::array();
    for (const core::Vector& derivative : jet.derivatives) derivatives.push_back(cli::json_of(derivative));
    return {{"u", u}, {"point", cli::json_of(jet.point)}, {"derivatives", std::move(derivatives)}};
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

    Json rows = Json::array();
    std::ostringstream table;
    for (const double u : *parameters) {
        const core::Jet jet = core::derivatives_at(*entry.curve, u, options.derivatives, options.side);
        if (!is_finite(jet)) {
            say_error(output, options.file, place_of(entry),
                      core::sentence("the values at {u} are too large for a double", {{"u", core::shortest_text(u)}}));
            return ExitStatus::wrong_input;
        }
        if (options.as_json) {
            rows.push_back(json_of_row(u, jet));
        } else {
            print_row(table, u, jet);
        }
    }
    if (options.as_json) {
        print(output.results, rows);
    } else {
        output.results << table.str();
    }
    return ExitStatus::done;
}

}  // namespace batten::cli
