#include "app/editor/scene/farin_marks.h"

#include <fmt/core.h>

#include <set>

#include "app/editor/scene/label_side.h"
#include "app/editor/words/root_text.h"
#include "core/evaluate/farin_points.h"

namespace batten::editor {

namespace {

constexpr std::size_t most_farin_points = 200;
constexpr std::size_t most_searched_legs = 20000;
constexpr std::size_t most_names = 24;
constexpr double farin_radius = 4.5;

/// How many control points are in the picture, but no more than one too many.
std::size_t seen_point_count(const CanvasFrame& frame, std::set<std::size_t>& legs) {
    std::size_t seen = 0;
    const std::size_t points = frame.curve->control_points().size();
    const auto take = [&](std::size_t i, core::Point, std::size_t of_many) {
        seen += of_many;
        if (seen > most_farin_points) return;
        legs.insert((i + points - 1) % points);
        legs.insert(i);
    };
    frame.kept->polygon().visit_points(frame.seen(0.0), 0.0, most_candidates(frame), take);
    return seen;
}

/// The legs that may be seen; of a very long polygon those that have an end in the picture. None where they are too
/// many.
std::set<std::size_t> seen_legs(const CanvasFrame& frame) {
    const std::size_t count = core::leg_count(*frame.curve);
    std::set<std::size_t> legs;
    if (count <= most_farin_points) {
        for (std::size_t leg = 0; leg < count; ++leg) legs.insert(leg);
        return legs;
    }
    if (seen_point_count(frame, legs) > most_farin_points) return {};
    if (const auto* committed = frame.state.history.present().active_curve();
        count <= most_searched_legs && committed) {
        const core::Box seen = frame.seen(0.0);
        frame.state.derived.near_parts(committed->curve)
            ->visit_near(seen.center(), 0.5 * core::length(seen.size()), [&](std::size_t leg) { legs.insert(leg); });
    }
    std::erase_if(legs, [&](std::size_t leg) { return leg >= count; });
    return legs;
}

void draw_farin_point(CanvasFrame& frame, std::size_t leg, bool is_hovered) {
    frame.pen.symbol(frame.screen(core::farin_point(*frame.curve, leg).point),
                     {.shape = render::MarkerShape::square,
                      .radius = is_hovered ? farin_radius + 1.5 : farin_radius,
                      .fill = is_hovered ? frame.theme.accent : frame.theme.canvas,
                      .outline = is_hovered ? frame.theme.canvas : frame.theme.text,
                      .outline_width = 2.0});
}

/// The side of the leg that is farther from the middle of the polygon.
LabelSide outer_side(const CanvasFrame& frame, std::size_t leg, glm::dvec2 place) {
    const auto points = frame.curve->control_points();
    const glm::dvec2 along = frame.screen(points[(leg + 1) % points.size()]) - frame.screen(points[leg]);
    const core::Box box = frame.state.derived.of(*frame.curve)->control_box;
    const glm::dvec2 outward = place - frame.screen(core::middle(box.lower, box.upper));
    const glm::dvec2 across{-along.y, along.x};
    return side_toward(across.x * outward.x + across.y * outward.y < 0.0 ? -across : across);
}

void wish_name(CanvasFrame& frame, std::size_t leg, bool is_hovered) {
    const std::size_t next = (leg + 1) % frame.curve->control_points().size();
    const auto weights = frame.curve->weights();
    const glm::dvec2 place = frame.screen(core::farin_point(*frame.curve, leg).point);
    WishedLabel label{.place = place,
                      .words = {{fmt::format("F_{{{}}}", leg), {.color = frame.theme.text}}},
                      .distance = 8.0,
                      .first = outer_side(frame, leg, place)};
    if (is_hovered) {
        label.words.push_back({fmt::format("w_{{{}}}/w_{{{}}} = {}", next, leg,
                                           root_text(frame.state.view.notation, weights[next] / weights[leg])),
                               {.color = frame.theme.accent}});
        label.crowding = Crowding::cover_symbols;
    }
    frame.labels.push_back(std::move(label));
    const glm::dvec2 reach(frame.pen.px(farin_radius));
    frame.covered.push_back({place - reach, place + reach});
}

}  // namespace

void draw_farin_points(CanvasFrame& frame) {
    const auto* hovered = std::get_if<HoveredFarinPoint>(&frame.state.hover);
    std::set<std::size_t> legs = seen_legs(frame);
    std::erase_if(legs, [&](std::size_t leg) {
        return !frame.pen.reach().contains(frame.screen(core::farin_point(*frame.curve, leg).point));
    });
    const bool are_named = legs.size() <= most_names;
    if (hovered != nullptr && hovered->leg < core::leg_count(*frame.curve)) legs.insert(hovered->leg);
    for (const std::size_t leg : legs) {
        const bool is_hovered = hovered != nullptr && hovered->leg == leg;
        draw_farin_point(frame, leg, is_hovered);
        if (is_hovered || (are_named && frame.shows(Overlay::labels))) wish_name(frame, leg, is_hovered);
    }
}

}  // namespace batten::editor
