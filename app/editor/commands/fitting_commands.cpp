#include "app/editor/commands/fitting_commands.h"

#include <algorithm>

#include "app/editor/commands/active_curve.h"
#include "app/editor/commands/curve_list.h"
#include "app/editor/commands/groups.h"
#include "app/editor/commands/suggestions.h"
#include "app/editor/fields/field_kinds.h"
#include "app/editor/words/refusal.h"
#include "core/make/fit.h"
#include "core/make/interpolate.h"

namespace batten::editor {

namespace {

using Points = std::vector<core::Point>;

template <class Command>
Outcome<Edit> interpolated(const EditorState& state, const Command& command, int degree, core::Ends ends) {
    auto result =
        core::interpolate(command.points, {degree, command.parametrization, std::move(ends), {}}, state.progress);
    if (!result) return refused(state, result.error());
    return with_curve(state, "curve", std::move(result->curve));
}

// Of too few points the degree is lowered, as for a drawn curve.
Outcome<Edit> interpolate(const EditorState& state, const Interpolate& command) {
    const int degree = std::min(command.degree, static_cast<int>(command.points.size()) - 1);
    return interpolated(state, command, degree, core::FreeEnds{});
}

Outcome<Edit> interpolate_closed(const EditorState& state, const InterpolateClosed& command) {
    return interpolated(state, command, command.degree, core::ClosedEnds{});
}

Outcome<Edit> interpolate_natural(const EditorState& state, const InterpolateNatural& command) {
    return interpolated(state, command, command.degree, core::NaturalEnds{});
}

Outcome<Edit> interpolate_tangents(const EditorState& state, const InterpolateTangents& command) {
    return interpolated(state, command, command.degree, core::EndTangents{command.start, command.end});
}

template <class Command>
bool has_tangents(const Command& command) {
    return command.start || command.end;
}

// A closed fit leaves out the derivatives that were asked for at ends, and says so.
template <class Command>
Outcome<core::Ends> ends_of(const Command& command) {
    if (command.closed && command.natural)
        return tl::unexpected<std::string>("a closed curve has no ends that could be natural: ask for one of the two");
    if (command.natural && has_tangents(command))
        return tl::unexpected<std::string>(
            "natural ends have free derivatives: leave out those at the start and the end");
    if (command.closed) return core::ClosedEnds{};
    if (command.natural) return core::NaturalEnds{};
    return core::EndTangents{command.start, command.end};
}

template <class Command>
Outcome<core::FitRequest> request_of(const Command& command) {
    return ends_of(command).map([&](core::Ends ends) {
        return core::FitRequest{.degree = command.degree, .ends = std::move(ends), .smoothing = command.smoothing};
    });
}

Outcome<Edit> with_fitted(const EditorState& state, core::Result<core::Approximation> found) {
    if (!found) return refused(state, found.error());
    Edit edit = with_curve(state, "fit", std::move(found->curve));
    edit.error = found->error;
    return edit;
}

Outcome<Edit> fit_points(const EditorState& state, const FitPoints& command) {
    const auto request = request_of(command);
    if (!request) return tl::unexpected(request.error());
    return with_fitted(state, core::fit(command.points, command.count, *request, state.progress));
}

Outcome<Edit> fit_points_within(const EditorState& state, const FitPointsWithin& command) {
    const auto request = request_of(command);
    if (!request) return tl::unexpected(request.error());
    return with_fitted(state, core::fit_within(command.points, command.tolerance, *request, state.progress));
}

StepTexts texts_of_fit(const EditorState&, const FitPoints& command) {
    return {"Fit curve to points", command.closed && has_tangents(command)
                                       ? "Fitted closed curve to points, without the derivatives at ends that it lacks"
                                       : "Fitted curve to points"};
}

StepTexts texts_of_fit_within(const EditorState&, const FitPointsWithin& command) {
    return {"Fit curve within tolerance",
            command.closed && has_tangents(command)
                ? "Fitted closed curve within tolerance, without the derivatives at ends that it lacks"
                : "Fitted curve within tolerance"};
}

// Half as many as there are points, and enough for a cubic.
std::optional<std::size_t> half_the_points(const EditorState& state) {
    const std::optional<Points> points = suggest::points_of_curve(state);
    if (!points) return std::nullopt;
    return std::max<std::size_t>((points->size() + 1) / 2, 4);
}

template <class Command>
Field points_field() {
    return field::positions<&Command::points>("coordinates",
                                              "x and y of each point; left out, the selected or all control points")
        .template suggesting<suggest::points_of_curve>()
        .at_least(2.0);
}

template <class Command>
Field degree_field(const char* meaning) {
    return field::count<&Command::degree>("degree", meaning).usually(3);
}

template <class Command>
Field parametrization_field() {
    return field::choice<&Command::parametrization>("parametrization", "how far apart the parameters of points are")
        .usually(core::Parametrization::centripetal);
}

constexpr const char* start_meaning = "x and y of the derivative at the start; none leaves it free";
constexpr const char* end_meaning = "x and y of the derivative at the end; none leaves it free";

// What the fits have in common: coordinates, degree, smoothing, and what the ends do.
template <class Command>
std::vector<Field> fit_fields(Field first) {
    return {
        std::move(first),
        points_field<Command>(),
        degree_field<Command>("from 1 to 25"),
        field::flag<&Command::closed>("closed", "yes for a periodic curve, no for an open one").usually(false),
        field::number<&Command::smoothing>("smoothing", "how strongly bending is penalized, 0 or more").usually(0.0),
        field::vector<&Command::start>("start", start_meaning).absent_as("0,0"),
        field::vector<&Command::end>("end", end_meaning).absent_as("0,0"),
        field::flag<&Command::natural>("natural", "yes for ends that do not bend, of degree 3 or more").usually(false)};
}

}  // namespace

const CommandSpec& Interpolate::spec() {
    static const CommandSpec spec{
        .name = "interpolate",
        .title = "Interpolate points",
        .explanation = "Adds a curve through points, with knots averaged from their parameters.",
        .synonyms = "through spline",
        .group = CommandGroup::make,
        .submenu = "Through points",
        .fields = {points_field<Interpolate>(), degree_field<Interpolate>("lowered where there are too few points"),
                   parametrization_field<Interpolate>()},
        .run = body_of<interpolate>,
        .at_work = "Interpolating points",
        .done = "Interpolated points"};
    return spec;
}

const CommandSpec& InterpolateClosed::spec() {
    static const CommandSpec spec{
        .name = "interpolate-closed",
        .title = "Interpolate closed",
        .explanation = "Adds a periodic curve through points that returns to the first one.",
        .synonyms = "through spline periodic",
        .group = CommandGroup::make,
        .submenu = "Through points",
        .fields = {points_field<InterpolateClosed>(), degree_field<InterpolateClosed>("from 1 to 25"),
                   parametrization_field<InterpolateClosed>()},
        .run = body_of<interpolate_closed>,
        .at_work = "Interpolating points",
        .step = "Interpolate closed curve",
        .done = "Interpolated closed curve"};
    return spec;
}

const CommandSpec& InterpolateNatural::spec() {
    static const CommandSpec spec{
        .name = "interpolate-natural",
        .title = "Interpolate with natural ends",
        .explanation = "Adds a curve through points whose second derivative is zero at both ends.",
        .synonyms = "through spline",
        .group = CommandGroup::make,
        .submenu = "Through points",
        .fields = {points_field<InterpolateNatural>(), degree_field<InterpolateNatural>("from 3 to 25"),
                   parametrization_field<InterpolateNatural>()},
        .run = body_of<interpolate_natural>,
        .at_work = "Interpolating points",
        .done = "Interpolated with natural ends"};
    return spec;
}

const CommandSpec& InterpolateTangents::spec() {
    static const CommandSpec spec{
        .name = "interpolate-tangents",
        .title = "Interpolate with end tangents",
        .explanation = "Adds a curve through points with given derivatives at its ends, over the domain from 0 to 1.",
        .synonyms = "through spline Hermite",
        .group = CommandGroup::make,
        .submenu = "Through points",
        .fields = {field::vector<&InterpolateTangents::start>("start", start_meaning).absent_as("0,0").required(),
                   field::vector<&InterpolateTangents::end>("end", end_meaning).absent_as("0,0").required(),
                   points_field<InterpolateTangents>(), degree_field<InterpolateTangents>("from 2 to 25"),
                   parametrization_field<InterpolateTangents>()},
        .run = body_of<interpolate_tangents>,
        .at_work = "Interpolating points",
        .done = "Interpolated with end tangents"};
    return spec;
}

const CommandSpec& FitPoints::spec() {
    static const CommandSpec spec{
        .name = "fit-points",
        .title = "Fit curve to points",
        .explanation = "Adds the curve nearest to points by least squares, with a given number of control points.",
        .synonyms = "approximate smooth",
        .group = CommandGroup::make,
        .submenu = "Near points",
        .fields = fit_fields<FitPoints>(
            field::count<&FitPoints::count>("count", "how many control points").suggesting<half_the_points>()),
        .run = body_of<fit_points>,
        .at_work = "Fitting a curve to points",
        .texts = texts_of<texts_of_fit>};
    return spec;
}

const CommandSpec& FitPointsWithin::spec() {
    static const CommandSpec spec{
        .name = "fit-points-within",
        .title = "Fit curve within tolerance",
        .explanation = "Adds a curve within a tolerance of points, with knots only where they are needed.",
        .synonyms = "approximate smooth",
        .group = CommandGroup::make,
        .submenu = "Near points",
        .fields = fit_fields<FitPointsWithin>(
            field::length<&FitPointsWithin::tolerance>("tolerance", "the largest distance, above 0")
                .suggesting<suggest::thousandth_of_size>()),
        .run = body_of<fit_points_within>,
        .at_work = "Fitting a curve to points",
        .texts = texts_of<texts_of_fit_within>};
    return spec;
}

void add_fitting_commands(CommandTable& table) {
    add_all<Interpolate, InterpolateClosed, InterpolateNatural, InterpolateTangents>(table);
    add_all<FitPoints, FitPointsWithin>(table);
}

}  // namespace batten::editor
