/// Writes core/ACCURACY.md: the errors of Batten, SISL and OpenCASCADE on the reference results.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>

#include "peers/spline_library.h"
#include "tests/core/golden_cases.h"

namespace batten::bench {

namespace {

using nlohmann::json;
namespace golden = core::golden;
using Values = std::vector<double>;
using Libraries = std::vector<std::unique_ptr<SplineLibrary>>;

// Of the size of the curve; far more than any error that is made.
constexpr double removal_tolerance = 1e-6;

/// The error of one case in each of its quantities (point, first derivative...), for one library. A quantity has none
/// where the library did not answer; an answer of the wrong form counts as infinitely wrong.
using CaseErrors = std::vector<std::optional<double>>;

/// One operation: its cases, the names of its quantities, and how a library is measured on one case.
struct Operation {
    std::string file;
    std::vector<std::string> quantities;
    std::function<CaseErrors(const SplineLibrary&, const json&)> measure;
};

double largest(std::span<const double> values) {
    double result = 0.0;
    for (const double value : values) result = std::max(result, std::abs(value));
    return result;
}

Values weights_of(const Values& weights, std::size_t count) {
    return weights.empty() ? Values(count, 1.0) : weights;
}

/// Points relative to the largest coordinate of the curve operated on, weights to the largest weight. The answer need
/// not be a curve: the derivative of a polygon is of degree 0.
double error_of(const CurveDefinition& found, const json& expected, double scale) {
    const auto points = golden::points_of(expected.at("points"));
    const Values weights = weights_of(expected.value("weights", Values{}), points.size());
    const Values found_weights = weights_of(found.weights, found.points.size());
    return std::max(golden::relative(golden::largest_difference(found.points, points), scale),
                    golden::relative(golden::largest_difference(found_weights, weights), largest(weights)));
}

double scale_of(const Curve& curve) {
    return golden::largest_coordinate(curve.control_points());
}

std::optional<double> worse(std::optional<double> a, double b) {
    return a ? std::max(*a, b) : b;
}

std::optional<double> error_of(const std::optional<CurveDefinition>& found, const json& expected, double scale) {
    if (!found) return {};
    return error_of(*found, expected, scale);
}

/// Several values of one place or piece after the other, in the order of the quantities, against their scales.
class ByOrder {
  public:
    explicit ByOrder(std::size_t quantities) : errors_(quantities), scales_(quantities) {}

    void take_scale(std::size_t r, double value) {
        if (r < scales_.size()) scales_[r] = std::max(scales_[r], value);
    }
    void set_scale(std::size_t r, double scale) { scales_[r] = scale; }
    void add(std::size_t r, double error) {
        if (r < errors_.size()) errors_[r] = worse(errors_[r], golden::relative(error, scales_[r]));
    }
    CaseErrors errors() const { return errors_; }

  private:
    CaseErrors errors_;
    Values scales_;
};

CaseErrors measure_evaluation(const SplineLibrary& library, const json& item) {
    const Curve curve = golden::curve_of(item);
    ByOrder orders(4);
    for (const json& place : item.at("at")) {
        const auto expected = golden::points_of(place.at("derivatives"));
        for (std::size_t r = 0; r < expected.size(); ++r)
            orders.take_scale(r, golden::largest_coordinate(std::span(expected).subspan(r, 1)));
    }
    orders.set_scale(0, scale_of(curve));
    for (const json& place : item.at("at")) {
        const auto expected = golden::points_of(place.at("derivatives"));
        const auto found = library.derivatives(curve, place.at("u"), static_cast<int>(expected.size()) - 1);
        if (!found) return CaseErrors(4);
        for (std::size_t r = 0; r < expected.size(); ++r)
            orders.add(r,
                       golden::largest_difference(std::span(*found).subspan(r, 1), std::span(expected).subspan(r, 1)));
    }
    return orders.errors();
}

// There the libraries choose different sides, and so answer different questions.
bool is_beside_interior_knot(const core::KnotVector& knots, double u) {
    const auto [lower, upper] = knots.domain();
    return std::ranges::any_of(knots.values(), [&](double knot) {
        return lower < knot && knot < upper && std::abs(u - knot) <= 1e-15 * (upper - lower);
    });
}

CaseErrors measure_basis(const SplineLibrary& library, const json& item) {
    const int degree = item.at("degree");
    const auto knots = core::KnotVector::make(degree, item.at("knots")).value();
    ByOrder orders(4);
    const auto rows_of = [](const json& place) { return place.at("derivatives").get<std::vector<Values>>(); };
    for (const json& place : item.at("at")) {
        const auto expected = rows_of(place);
        for (std::size_t r = 0; r < expected.size(); ++r) orders.take_scale(r, largest(expected[r]));
    }
    for (const json& place : item.at("at")) {
        const double u = place.at("u");
        if (is_beside_interior_knot(knots, u)) continue;
        const auto expected = rows_of(place);
        const auto found = library.basis(knots, u, std::min(degree, 3));
        if (!found) return CaseErrors(4);
        for (std::size_t r = 0; r < found->size(); ++r)
            orders.add(r, golden::largest_difference((*found)[r], expected[r]));
    }
    return orders.errors();
}

CaseErrors measure_insertion(const SplineLibrary& library, const json& item) {
    const Curve curve = golden::curve_of(item);
    return {error_of(library.insert(curve, item.at("insert").get<Values>()), item.at("result"), scale_of(curve))};
}

CaseErrors measure_removal(const SplineLibrary& library, const json& item) {
    const Curve refined = golden::curve_of(item.at("result"));
    const auto knots = item.at("insert").get<Values>();
    const double scale = scale_of(golden::curve_of(item));
    return {error_of(library.remove(refined, knots, removal_tolerance * scale), item, scale)};
}

CaseErrors measure_elevation(const SplineLibrary& library, const json& item) {
    const Curve curve = golden::curve_of(item);
    return {error_of(library.elevate(curve, item.at("by")), item.at("result"), scale_of(curve))};
}

CaseErrors measure_hodograph(const SplineLibrary& library, const json& item) {
    const auto points = golden::points_of(item.at("result").at("points"));
    return {error_of(library.hodograph(golden::curve_of(item)), item.at("result"), golden::largest_coordinate(points))};
}

CaseErrors measure_split(const SplineLibrary& library, const json& item) {
    const Curve curve = golden::curve_of(item);
    const auto found = library.split(curve, item.at("u"));
    if (!found) return {std::nullopt};
    return {std::max(error_of((*found)[0], item.at("left"), scale_of(curve)),
                     error_of((*found)[1], item.at("right"), scale_of(curve)))};
}

CaseErrors measure_pieces(const SplineLibrary& library, const json& item) {
    const Curve curve = golden::curve_of(item);
    const auto found = library.bezier_pieces(curve);
    const json& expected = item.at("segments");
    if (!found) return {std::nullopt};
    if (found->size() != expected.size()) return {std::numeric_limits<double>::infinity()};
    double error = 0.0;
    for (std::size_t k = 0; k < expected.size(); ++k)
        error = std::max(error, error_of((*found)[k], expected[k], scale_of(curve)));
    return {error};
}

// Not every library gives a sign.
CaseErrors measure_curvature(const SplineLibrary& library, const json& item) {
    const Curve curve = golden::curve_of(item);
    ByOrder orders(1);
    for (const json& place : item.at("at")) orders.take_scale(0, std::abs(place.at("curvature").get<double>()));
    for (const json& place : item.at("at")) {
        const auto found = library.curvature(curve, place.at("u"));
        if (!found) return {std::nullopt};
        orders.add(0, std::abs(std::abs(*found) - std::abs(place.at("curvature").get<double>())));
    }
    return orders.errors();
}

CaseErrors measure_length(const SplineLibrary& library, const json& item) {
    const double expected = item.at("length");
    const auto found = library.arc_length(golden::curve_of(item));
    if (!found) return {std::nullopt};
    return {golden::relative(std::abs(*found - expected), expected)};
}

CaseErrors measure_closest_point(const SplineLibrary& library, const json& item) {
    const Curve curve = golden::curve_of(item);
    const std::vector<Point> expected = golden::points_of(json::array({item.at("point")}));
    const auto found = library.closest_point(curve, golden::points_of(json::array({item.at("query")}))[0]);
    if (!found) return {std::nullopt};
    return {golden::relative(golden::largest_difference(std::vector{*found}, expected), scale_of(curve))};
}

CaseErrors measure_interpolation(const SplineLibrary& library, const json& item) {
    const json& result = item.at("result");
    const InterpolationTask task{.degree = item.at("degree"),
                                 .through = golden::points_of(item.at("through")),
                                 .parameters = result.at("parameters"),
                                 .knots = result.at("knots")};
    return {error_of(library.interpolate(task), result, scale_of(golden::curve_of(result)))};
}

// How far points of the curve are from the conic that it is: |F| / |grad F|, computed with more digits.
CaseErrors measure_conic(const SplineLibrary& library, const json& item) {
    const Curve curve = golden::curve_of(item);
    const auto k = item.at("implicit").get<std::vector<long double>>();
    const auto [lower, upper] = curve.domain();
    std::optional<double> error;
    for (int i = 0; i <= 256; ++i) {
        const auto found = library.derivatives(curve, lower + (upper - lower) * i / 256, 0);
        if (!found) return {std::nullopt};
        const long double x = (*found)[0].x;
        const long double y = (*found)[0].y;
        const long double f = k[0] * x * x + k[1] * x * y + k[2] * y * y + k[3] * x + k[4] * y + k[5];
        const long double slope = std::hypot(2 * k[0] * x + k[1] * y + k[3], k[1] * x + 2 * k[2] * y + k[4]);
        error = worse(error, static_cast<double>(std::abs(f) / slope) / scale_of(curve));
    }
    return {error};
}

std::vector<Operation> operations() {
    const std::vector<std::string> orders{"", ", first derivative", ", second derivative", ", third derivative"};
    const auto with = [&](const std::string& name) {
        std::vector<std::string> names;
        for (const std::string& order : orders) names.push_back(name + order);
        return names;
    };
    return {{"evaluate.json", with("evaluation"), measure_evaluation},
            {"basis.json", with("basis functions"), measure_basis},
            {"curvature.json", {"curvature"}, measure_curvature},
            {"knot_insertion.json", {"knot insertion"}, measure_insertion},
            {"knot_insertion.json", {"knot removal (of the knots inserted)"}, measure_removal},
            {"bezier_decomposition.json", {"Bézier decomposition"}, measure_pieces},
            {"degree_elevation.json", {"degree elevation"}, measure_elevation},
            {"split.json", {"splitting"}, measure_split},
            {"hodograph.json", {"hodograph"}, measure_hodograph},
            {"arc_length.json", {"arc length"}, measure_length},
            {"closest_point.json", {"closest point"}, measure_closest_point},
            {"interpolation.json", {"interpolation"}, measure_interpolation},
            {"conics.json", {"conics, distance of curve points"}, measure_conic}};
}

/// The errors of one library in one row of the table.
struct Cell {
    Values errors;
    std::size_t refused = 0;
};

double median(Values values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

std::string text(double value) {
    if (!std::isfinite(value)) return "wrong";
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.1e", value);
    return value == 0.0 ? "0" : buffer;
}

std::string text(const Cell& cell) {
    if (cell.errors.empty()) return "– | –";
    std::string worst = text(*std::max_element(cell.errors.begin(), cell.errors.end()));
    if (cell.refused > 0) worst += " (" + std::to_string(cell.refused) + " refused)";
    return worst + " | " + text(median(cell.errors));
}

struct Row {
    std::string name;
    std::size_t cases = 0;
    std::vector<Cell> cells;
};

// Cases that the reference results allow three digits less get rows of their own.
bool is_hard(const json& item) {
    return item.contains("points") && golden::is_hard(golden::curve_of(item));
}

std::vector<Row> rows_of(const Operation& operation, const Libraries& libraries, bool hard) {
    std::vector<Row> rows;
    for (const std::string& quantity : operation.quantities)
        rows.push_back({quantity + (hard ? " (hard)" : ""), 0, std::vector<Cell>(libraries.size())});
    for (const json& item : golden::cases(operation.file)) {
        if (is_hard(item) != hard) continue;
        std::vector<bool> is_answered(rows.size());
        for (std::size_t k = 0; k < libraries.size(); ++k) {
            const CaseErrors errors = operation.measure(*libraries[k], item);
            for (std::size_t q = 0; q < rows.size(); ++q) {
                if (errors[q]) rows[q].cells[k].errors.push_back(*errors[q]);
                is_answered[q] = is_answered[q] || errors[q];
            }
        }
        for (std::size_t q = 0; q < rows.size(); ++q)
            if (is_answered[q]) ++rows[q].cases;
    }
    for (Row& row : rows)
        for (Cell& cell : row.cells) cell.refused = row.cases - cell.errors.size();
    return rows;
}

void write_table(std::ostream& out, const Libraries& libraries) {
    out << "| operation | cases |";
    for (const auto& library : libraries) out << ' ' << library->name() << " | |";
    out << "\n|---|---|";
    for (std::size_t k = 0; k < libraries.size(); ++k) out << "---|---|";
    out << "\n| | |";
    for (std::size_t k = 0; k < libraries.size(); ++k) out << " worst | median |";
    out << '\n';
    for (const Operation& operation : operations())
        for (const bool hard : {false, true})
            for (const Row& row : rows_of(operation, libraries, hard)) {
                if (row.cases == 0) continue;
                out << "| " << row.name << " | " << row.cases << " |";
                for (const Cell& cell : row.cells) out << ' ' << text(cell) << " |";
                out << '\n';
            }
}

constexpr const char* introduction = R"(# Accuracy

Relative errors on the reference results of `tests/data/golden`, which are exact rational arithmetic rounded once, for Batten and for two other
spline libraries on the same cases. Written by `bench_accuracy`, not by hand:

```
apt-get install libsisl-dev libocct-foundation-dev libocct-modeling-data-dev libocct-modeling-algorithms-dev
cmake --preset release -DBATTEN_PEERS=ON && cmake --build build/release --target bench_accuracy
build/release/bench/bench_accuracy core/ACCURACY.md
```

The error of a case is the largest of its answers: of points relative to the largest coordinate of the control points, of weights to the largest
weight, of derivatives, basis functions and curvatures to the largest of that order in the case, of lengths to the length. The table gives the worst
and the median case. 1.1e-16 is the rounding of one operation. *Hard* cases have a degree above 10 or weights that differ by more than a factor of
1000. "–": the library has no such operation; *refused*: it has no answer to so many of the cases, which then do not count for it.

)";

constexpr const char* notes = R"(
- OpenCASCADE takes a parameter that is within rounding of a knot for the knot, and its basis functions on the left of a knot; such places are left
  out for basis functions. Where it has several functions for a value (D0 to D3), the one for the lowest order is used.
- SISL's arc length and closest point depend on a tolerance; those chosen are the tightest with which it still comes to an end. Both libraries
  miss the closest point of curves of a size of 1e-8. OpenCASCADE finds feet of perpendiculars, to which the ends are added.
- SISL's and OpenCASCADE's interpolation is given parameters and knots, Batten's the parameters.
- Knot removal takes out what knot insertion put in; the answer is the original curve. Its error grows with the number of removals at one knot.
)";

}  // namespace

}  // namespace batten::bench

// bench_accuracy [FILE]: writes to the file, or to the standard output.
int main(int argc, char** argv) {
    using namespace batten::bench;
    Libraries libraries;
    libraries.push_back(make_batten());
    libraries.push_back(make_sisl());
    libraries.push_back(make_occt());
    std::ofstream file;
    if (argc > 1) file.open(argv[1]);
    std::ostream& out = argc > 1 ? file : std::cout;
    out << introduction;
    write_table(out, libraries);
    out << notes;
    if (out.flush()) return 0;
    std::cerr << "cannot write " << argv[1] << '\n';
    return 1;
}
