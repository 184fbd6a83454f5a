#include "app/editor/scene/corner_cutting_scene.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/editor/derived/shown_cutting.h"
#include "core/base/sentence.h"
#include "core/evaluate/basis.h"

namespace batten::editor {

namespace {

constexpr double corner_opacity = 0.13;
constexpr double new_polygon_width = 2.5;
constexpr double ghost_width = 2.0;
constexpr double new_point_radius = 6.0;
constexpr double ghost_radius = 5.0;
constexpr double cut_name_size = 15.0;
constexpr double alpha_size = 15.0;
constexpr double old_name_size = 13.0;
constexpr std::size_t most_labels_at_all_costs = 5;  // more of them give way to one another
constexpr double function_width = 2.0;
constexpr double cut_spacing_px = 4.0;
constexpr double most_cut_steps = 300.0;  // in a span

std::vector<core::Point> old_polygon(const core::CornerCutting& cutting) {
    std::vector<core::Point> points;
    for (const core::OldCorner& corner : cutting.corners) points.push_back(corner.point);
    return points;
}

std::vector<core::Point> new_polygon(const core::CornerCutting& cutting) {
    std::vector<core::Point> points{cutting.corners.front().point};
    for (const core::LegCut& cut : cutting.cuts) points.push_back(cut.point);
    points.push_back(cutting.corners.back().point);
    return points;
}

void draw_ghost_corners(CanvasFrame& frame, const ShownCutting& shown) {
    frame.pen.line(frame.screen(old_polygon(shown.cutting)),
                   {.color = frame.theme.dim, .width = ghost_width, .dash = 3.0, .gap = 4.0});
    const glm::dvec2 reach(frame.pen.px(ghost_radius + 1.0));
    for (std::size_t j = 1; j + 1 < shown.cutting.corners.size(); ++j) {
        const glm::dvec2 place = frame.screen(shown.cutting.corners[j].point);
        frame.covered.push_back({place - reach, place + reach});
        frame.pen.symbol(place, {.radius = ghost_radius,
                                 .fill = frame.theme.canvas,
                                 .outline = frame.theme.point(shown.corner_hues[j]),
                                 .outline_width = 1.75,
                                 .dash = 2.5});
    }
}

void draw_new_points(CanvasFrame& frame, const ShownCutting& shown) {
    for (std::size_t j = 0; j < shown.cutting.cuts.size(); ++j)
        frame.pen.symbol(frame.screen(shown.cutting.cuts[j].point), {.shape = render::MarkerShape::diamond,
                                                                     .radius = new_point_radius,
                                                                     .fill = frame.theme.point(shown.cut_hues[j]),
                                                                     .outline = frame.theme.text,
                                                                     .outline_width = 1.5});
}

/// "α = 1/2", and where on the leg that is in the plane, if weights make it another place.
std::string alpha_text(const Notation& notation, const core::LegCut& cut) {
    constexpr double same_place = 1e-9;
    const core::Place alpha("alpha", exact_text(notation, cut.alpha, 3));
    if (std::abs(cut.leg_share - cut.alpha) <= same_place) return core::sentence("α = {alpha}", {alpha});
    return core::sentence("α = {alpha}, at {share} of the leg",
                          {alpha, {"share", exact_text(notation, cut.leg_share, 3)}});
}

void wish_names(CanvasFrame& frame, const ShownCutting& shown) {
    const auto& cuts = shown.cutting.cuts;
    const bool is_few = cuts.size() <= most_labels_at_all_costs;
    std::vector<WishedLabel> names;
    for (std::size_t j = 0; j < cuts.size(); ++j)
        names.push_back({.place = frame.screen(cuts[j].point),
                         .words = {{fmt::format("Q_{{{}}}", cuts[j].i),
                                    {.color = frame.theme.point_text(shown.cut_hues[j]),
                                     .size = cut_name_size,
                                     .font = render::LabelFont::bold}},
                                   {alpha_text(frame.state.view.notation, cuts[j]),
                                    {.color = frame.theme.text, .size = alpha_size}}},
                         .distance = 11.0,
                         .first = LabelSide::lower_right,
                         .crowding = is_few ? Crowding::cover_symbols : Crowding::leave_out});
    // What was wished for below matters less.
    frame.labels.insert(frame.labels.begin(), names.begin(), names.end());
}

/// What the corners were called before, in parentheses, where the points now have other names.
void wish_old_names(CanvasFrame& frame, const ShownCutting& shown) {
    const auto& corners = shown.cutting.corners;
    for (std::size_t j = 1; j < corners.size(); ++j)
        frame.labels.push_back({.place = frame.screen(corners[j].point),
                                .words = {{fmt::format("(P_{{{}}})", corners[j].index),
                                           {.color = frame.theme.dim, .size = old_name_size}}},
                                .distance = 10.0,
                                .first = LabelSide::lower_right,
                                .crowding = Crowding::leave_out});
}

/// Functions over a few knots, numbered from the first one.
struct LocalFunctions {
    core::KnotVector knots;
    std::size_t first = 0;  ///< the index of the first in `knots`
    std::size_t count = 0;
};

/// The first and the last knot are repeated until the vector is clamped; no function over the others knows that.
std::optional<LocalFunctions> local_functions(const std::vector<double>& window, std::size_t p) {
    const auto missing = [&](double end) {
        const auto there = static_cast<std::size_t>(std::ranges::count(window, end));
        return p + 1 - std::min(there, p + 1);
    };
    std::vector<double> knots(missing(window.front()), window.front());
    const std::size_t first = knots.size();
    knots.insert(knots.end(), window.begin(), window.end());
    knots.insert(knots.end(), missing(window.back()), window.back());
    auto made =
        core::KnotVector::make(static_cast<int>(p), std::move(knots), core::KnotKind::custom, core::Tears::allow);
    if (!made) return std::nullopt;
    return LocalFunctions{*std::move(made), first, window.size() - p - 1};
}

/// The knots under the functions on the other side of the insertion: after it, or before.
std::vector<double> other_window(const ShownCutting& shown) {
    std::vector<double> window = shown.cutting.knots;
    if (!shown.has_happened) window.insert(std::ranges::upper_bound(window, shown.cutting.u), shown.cutting.u);
    return window;
}

/// Their colors: the first and the last one are those of corners that stay.
std::vector<std::size_t> other_hues(const ShownCutting& shown) {
    if (shown.has_happened) return shown.corner_hues;
    std::vector<std::size_t> hues{shown.corner_hues.front()};
    hues.insert(hues.end(), shown.cut_hues.begin(), shown.cut_hues.end());
    hues.push_back(shown.corner_hues.back());
    return hues;
}

/// One function after another over one span, moved by `shift`.
void draw_span(PlotFrame& frame, const LocalFunctions& functions, const std::vector<std::size_t>& hues, std::size_t s,
               double shift) {
    const core::Interval range = frame.layout.range;
    const core::Interval domain = frame.curve.domain();
    const double lower = std::max(functions.knots[s], std::max(range.lower, domain.lower) - shift);
    const double upper = std::min(functions.knots[s + 1], std::min(range.upper, domain.upper) - shift);
    if (!(lower < upper)) return;
    const auto p = static_cast<std::size_t>(functions.knots.degree());
    const double width = frame.x(upper + shift) - frame.x(lower + shift);
    const auto steps = static_cast<std::size_t>(
        std::clamp(frame.state.view.parts.fineness * width / cut_spacing_px, 2.0, most_cut_steps));
    std::vector<std::vector<glm::dvec2>> lines(p + 1);
    for (std::size_t k = 0; k <= steps; ++k) {
        const double u =
            k == steps ? upper : lower + (upper - lower) * static_cast<double>(k) / static_cast<double>(steps);
        const core::Side side = u < functions.knots[s + 1] ? core::Side::right : core::Side::left;
        const auto values = core::basis_functions(functions.knots, u, 0, side).derivatives[0];
        for (std::size_t j = 0; j <= p; ++j) lines[j].push_back({frame.x(u + shift), frame.y(values[j])});
    }
    for (std::size_t j = 0; j <= p; ++j) {
        const std::size_t i = s - p + j;
        if (i < functions.first || i >= functions.first + functions.count) continue;
        frame.pen.line(
            lines[j],
            {.color = frame.theme.point(hues[i - functions.first]), .width = function_width, .dash = 5.0, .gap = 4.0});
    }
}

}  // namespace

void draw_cut_corners(CanvasFrame& frame) {
    const auto shown = shown_cutting(frame.state);
    if (!shown) return;
    const core::CornerCutting& cutting = shown->cutting;
    for (std::size_t j = 0; j + 1 < cutting.cuts.size(); ++j) {
        const std::vector<core::Point> corner{cutting.cuts[j].point, cutting.corners[j + 1].point,
                                              cutting.cuts[j + 1].point};
        frame.pen.fill(frame.screen(corner),
                       render::faded(frame.theme.point(shown->corner_hues[j + 1]), corner_opacity));
    }
}

void draw_corner_cutting(CanvasFrame& frame) {
    const auto shown = shown_cutting(frame.state);
    if (!shown) return;
    if (shown->has_happened)
        draw_ghost_corners(frame, *shown);
    else
        frame.pen.line(frame.screen(new_polygon(shown->cutting)),
                       {.color = frame.theme.accent, .width = new_polygon_width});
    draw_new_points(frame, *shown);
    wish_names(frame, *shown);
    if (shown->has_happened) wish_old_names(frame, *shown);
}

void draw_cut_functions(PlotFrame& frame) {
    const auto shown = shown_cutting(frame.state);
    if (!shown) return;
    const auto p = static_cast<std::size_t>(frame.curve.degree());
    const auto functions = local_functions(other_window(*shown), p);
    if (!functions) return;
    const std::vector<std::size_t> hues = other_hues(*shown);
    const double period = frame.curve.domain().length();
    const core::KnotVector& knots = functions->knots;
    // Of a periodic curve they go on from its end at its start.
    for (const double shift : {-period, 0.0, period}) {
        if (shift != 0.0 && !frame.curve.is_periodic()) continue;
        for (std::size_t s = p; s + p + 1 < knots.size(); ++s)
            if (knots[s] < knots[s + 1]) draw_span(frame, *functions, hues, s, shift);
    }
}

}  // namespace batten::editor
