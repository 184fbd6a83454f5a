#include <algorithm>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "core/make/fit.h"
#include "core/make/interpolate.h"

namespace batten::editor {

namespace {

using Kind = ParameterKind;
using Points = std::vector<core::Point>;

Outcome<core::Parametrization> parametrization_named(const std::string& name) {
    if (name == "uniform") return core::Parametrization::uniform;
    if (name == "chordal") return core::Parametrization::chordal;
    if (name == "centripetal") return core::Parametrization::centripetal;
    return tl::unexpected("parametrization is '" + name + "'; it must be uniform, chordal or centripetal");
}

// Of too few points the degree is lowered, as for a drawn curve.
Outcome<int> degree_for(const Points& points, double value) {
    return index_of(value, "degree").map([&](std::size_t degree) {
        return static_cast<int>(std::min(degree, points.size() - 1));
    });
}

// Arguments `first`.. are coordinates, degree and parametrization.
Outcome<Edit> interpolated(const EditorState& state, const Arguments& arguments, std::size_t first, core::Ends ends,
                           bool lowers_degree) {
    const auto points = points_of(arguments.numbers(first), 2, "interpolation");
    if (!points) return tl::unexpected(points.error());
    const auto lowered = degree_for(*points, arguments.number(first + 1));
    if (!lowered) return tl::unexpected(lowered.error());
    const auto way = parametrization_named(arguments.text(first + 2));
    if (!way) return tl::unexpected(way.error());
    const int degree = lowers_degree ? *lowered : static_cast<int>(arguments.number(first + 1));
    auto result = core::interpolate(*points, {degree, *way, std::move(ends), {}});
    if (!result) return tl::unexpected(core::describe(result.error()));
    return with_curve(state, "curve", std::move(result->curve));
}

Outcome<Edit> interpolate(const EditorState& state, const Arguments& arguments) {
    return interpolated(state, arguments, 0, core::FreeEnds{}, true);
}

Outcome<Edit> interpolate_closed(const EditorState& state, const Arguments& arguments) {
    return interpolated(state, arguments, 0, core::ClosedEnds{}, false);
}

Outcome<Edit> interpolate_natural(const EditorState& state, const Arguments& arguments) {
    return interpolated(state, arguments, 0, core::NaturalEnds{}, false);
}

// x and y of a tangent; none where both are 0.
Outcome<std::optional<core::Vector>> tangent_of(const std::vector<double>& numbers, const char* what) {
    if (numbers.size() != 2)
        return tl::unexpected(std::string(what) + " needs x and y; " + std::to_string(numbers.size()) +
                              (numbers.size() == 1 ? " number was given" : " numbers were given"));
    if (numbers[0] == 0.0 && numbers[1] == 0.0) return std::optional<core::Vector>();
    return std::optional(core::Vector(numbers[0], numbers[1]));
}

Outcome<Edit> interpolate_tangents(const EditorState& state, const Arguments& arguments) {
    const auto start = tangent_of(arguments.numbers(0), "start");
    if (!start) return tl::unexpected(start.error());
    const auto end = tangent_of(arguments.numbers(1), "end");
    if (!end) return tl::unexpected(end.error());
    return interpolated(state, arguments, 2, core::EndTangents{*start, *end}, false);
}

struct FitTask {
    Points points;
    core::FitRequest request;
};

// Arguments 1.. are coordinates, degree, closed, smoothing, and the derivatives at start and end.
Outcome<FitTask> fit_task(const Arguments& arguments) {
    const auto points = points_of(arguments.numbers(1), 2, "fitting");
    if (!points) return tl::unexpected(points.error());
    const auto degree = index_of(arguments.number(2), "degree");
    if (!degree) return tl::unexpected(degree.error());
    const auto start = tangent_of(arguments.numbers(5), "start");
    if (!start) return tl::unexpected(start.error());
    const auto end = tangent_of(arguments.numbers(6), "end");
    if (!end) return tl::unexpected(end.error());
    return FitTask{*points,
                   {.degree = static_cast<int>(*degree),
                    .is_closed = arguments.number(3) != 0.0,
                    .start_tangent = *start,
                    .end_tangent = *end,
                    .smoothing = arguments.number(4)}};
}

Outcome<Edit> with_fitted(const EditorState& state, core::Result<core::Approximation> found) {
    if (!found) return tl::unexpected(core::describe(found.error()));
    Edit edit = with_curve(state, "fit", std::move(found->curve));
    edit.error = found->error;
    return edit;
}

Outcome<Edit> fit_points(const EditorState& state, const Arguments& arguments) {
    const auto count = index_of(arguments.number(0), "count");
    if (!count) return tl::unexpected(count.error());
    const auto task = fit_task(arguments);
    if (!task) return tl::unexpected(task.error());
    return with_fitted(state, core::fit(task->points, *count, task->request));
}

Outcome<Edit> fit_points_within(const EditorState& state, const Arguments& arguments) {
    const auto task = fit_task(arguments);
    if (!task) return tl::unexpected(task.error());
    return with_fitted(state, core::fit_within(task->points, arguments.number(0), task->request));
}

// The selected control points of the active curve, all of them where fewer than two are selected.
std::optional<Argument> points_of_curve(const EditorState& state) {
    if (state.history.present().active_curve() == nullptr) return std::nullopt;
    const auto points = active_curve(state).control_points();
    const auto& selected = state.selection.points;
    std::vector<double> coordinates;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (selected.size() < 2 || state.selection.contains_point(i))
            coordinates.insert(coordinates.end(), {points[i].x, points[i].y});
    return coordinates;
}

std::optional<Argument> nothing_prescribed(const EditorState&) {
    return std::vector<double>{0.0, 0.0};
}

// Half as many as there are points, and enough for a cubic.
std::optional<Argument> half_the_points(const EditorState& state) {
    const auto points = points_of_curve(state);
    if (!points) return std::nullopt;
    const std::size_t count = std::get<std::vector<double>>(*points).size() / 2;
    return static_cast<double>(std::max<std::size_t>((count + 1) / 2, 4));
}

std::optional<Argument> thousandth_of_size(const EditorState& state) {
    return share_of_size(state, 1e-3);
}

template <int value>
std::optional<Argument> number(const EditorState&) {
    return static_cast<double>(value);
}

std::optional<Argument> centripetal(const EditorState&) {
    return "centripetal";
}

const ParameterSpec coordinates{"coordinates", Kind::numbers,
                                "x and y of each point; left out, the selected or all control points", points_of_curve};
const ParameterSpec parametrization{"parametrization", Kind::text, "uniform, chordal or centripetal", centripetal};

void add_interpolations(std::vector<CommandSpec>& table) {
    const ParameterSpec degree{"degree", Kind::number, "from 1 to 25", number<3>};
    table.push_back({.name = "interpolate",
                     .title = "Interpolate points",
                     .explanation = "Adds a curve through points, with knots averaged from their parameters.",
                     .group = CommandGroup::make,
                     .submenu = "Through points",
                     .parameters = {coordinates,
                                    {"degree", Kind::number, "lowered where there are too few points", number<3>},
                                    parametrization},
                     .edit = interpolate});
    table.push_back({.name = "interpolate-closed",
                     .title = "Interpolate closed",
                     .explanation = "Adds a periodic curve through points that returns to the first one.",
                     .group = CommandGroup::make,
                     .submenu = "Through points",
                     .parameters = {coordinates, degree, parametrization},
                     .edit = interpolate_closed});
    table.push_back({.name = "interpolate-natural",
                     .title = "Interpolate with natural ends",
                     .explanation = "Adds a curve through points whose second derivative is zero at both ends.",
                     .group = CommandGroup::make,
                     .submenu = "Through points",
                     .parameters = {coordinates, {"degree", Kind::number, "from 3 to 25", number<3>}, parametrization},
                     .edit = interpolate_natural});
    table.push_back(
        {.name = "interpolate-tangents",
         .title = "Interpolate with end tangents",
         .explanation = "Adds a curve through points with given derivatives at its ends, over the domain "
                        "from 0 to 1.",
         .group = CommandGroup::make,
         .submenu = "Through points",
         .parameters = {{"start", Kind::numbers, "x and y of the derivative at the start; 0,0 leaves it free"},
                        {"end", Kind::numbers, "x and y of the derivative at the end; 0,0 leaves it free"},
                        coordinates,
                        {"degree", Kind::number, "from 2 to 25", number<3>},
                        parametrization},
         .edit = interpolate_tangents});
}

void add_fits(std::vector<CommandSpec>& table) {
    const ParameterSpec degree{"degree", Kind::number, "from 1 to 25", number<3>};
    const ParameterSpec closed{"closed", Kind::number, "1 for a periodic curve, 0 for an open one", number<0>};
    const ParameterSpec smoothing{"smoothing", Kind::number, "how much bending counts beside the errors, 0 or more",
                                  number<0>};
    const ParameterSpec start{"start", Kind::numbers, "x and y of the derivative at the start; 0,0 leaves it free",
                              nothing_prescribed};
    const ParameterSpec end{"end", Kind::numbers, "x and y of the derivative at the end; 0,0 leaves it free",
                            nothing_prescribed};
    table.push_back(
        {.name = "fit-points",
         .title = "Fit curve to points",
         .explanation = "Adds the curve with so many control points that is nearest to points, by least squares.",
         .group = CommandGroup::make,
         .submenu = "Near points",
         .parameters = {{"count", Kind::number, "how many control points", half_the_points},
                        coordinates,
                        degree,
                        closed,
                        smoothing,
                        start,
                        end},
         .edit = fit_points});
    table.push_back({.name = "fit-points-within",
                     .title = "Fit curve within tolerance",
                     .explanation = "Adds a curve that is nowhere farther from points than a tolerance, with knots "
                                    "where they are needed.",
                     .group = CommandGroup::make,
                     .submenu = "Near points",
                     .parameters = {{"tolerance", Kind::number, "the largest distance, above 0", thousandth_of_size},
                                    coordinates,
                                    degree,
                                    closed,
                                    smoothing,
                                    start,
                                    end},
                     .edit = fit_points_within});
}

}  // namespace

void add_fitting_commands(std::vector<CommandSpec>& table) {
    add_interpolations(table);
    add_fits(table);
}

}  // namespace batten::editor
