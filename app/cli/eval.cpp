#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>

#include "app/cli/input.h"
#include "app/cli/json_output.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"

namespace batten::cli {

namespace {

std::string place_of(const core::DocumentCurve& entry) {
    return core::sentence("curve '{name}'", {{"name", entry.name}});
}

// The parameters must lie in the domain of an open curve; a periodic one goes on for ever.
bool are_parameters_inside(const EvalOptions& options, Output output, const core::DocumentCurve& entry) {
    const core::Curve& curve = *entry.curve;
    for (const double u : options.at) {
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

bool are_finite(const std::vector<core::Vector>& values) {
    return std::all_of(values.begin(), values.end(),
                       [](const core::Vector& v) { return std::isfinite(v.x) && std::isfinite(v.y); });
}

void print_row(std::ostream& out, double u, const std::vector<core::Vector>& values) {
    out << core::shortest_text(u);
    for (const core::Vector& value : values)
        out << '\t' << core::shortest_text(value.x) << '\t' << core::shortest_text(value.y);
    out << '\n';
}

Json json_of_row(double u, const std::vector<core::Vector>& values) {
    Json derivatives = Json::array();
    for (std::size_t r = 1; r < values.size(); ++r) derivatives.push_back(json_of(values[r]));
    return {{"u", u}, {"point", json_of(values.front())}, {"derivatives", std::move(derivatives)}};
}

}  // namespace

ExitStatus eval(const EvalOptions& options, Output output) {
    const std::optional<core::Document> document = load(output, options.file);
    if (!document) return ExitStatus::wrong_input;
    const std::optional<std::size_t> index = find_curve(output, options.file, *document, options.curve);
    if (!index) return ExitStatus::wrong_input;
    const core::DocumentCurve& entry = document->curves[*index];
    if (!are_parameters_inside(options, output, entry)) return ExitStatus::wrong_input;

    Json rows = Json::array();
    std::ostringstream table;
    for (const double u : options.at) {
        std::vector<core::Vector> values = core::derivatives_at(*entry.curve, u, options.derivatives, options.side);
        if (!are_finite(values)) {
            say_error(output, options.file, place_of(entry),
                      core::sentence("the values at {u} are too large for a double", {{"u", core::shortest_text(u)}}));
            return ExitStatus::wrong_input;
        }
        if (options.as_json) {
            rows.push_back(json_of_row(u, values));
        } else {
            print_row(table, u, values);
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
