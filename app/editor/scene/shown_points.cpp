#include "app/editor/scene/shown_points.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <set>

#include "app/editor/scene/fit_marks.h"
#include "app/editor/scene/thinned_points.h"

namespace batten::editor {

namespace {

constexpr std::array point_radii{6.5, 4.5, 3.0};
constexpr double point_gap = 6.0;
constexpr double merged_points = 4.0;       // sixteen points that are closer together are seen as one
constexpr double most_points_per_px = 1.5;  // points for each pixel of the picture's width

/// In a window the points come with their polygon, in a figure by themselves, and for their names.
bool has_points(const CanvasFrame& frame) {
    const PictureParts& parts = frame.state.view.parts;
    return parts.window ? frame.shows(Overlay::polygon) : parts.points || (parts.names && frame.shows(Overlay::labels));
}

/// What the user points at, as far as it is in the picture.
std::vector<MarkPlace> pointed_at(const CanvasFrame& frame) {
    const auto points = frame.curve->control_points();
    std::set<std::size_t> indices(frame.lit.points.begin(), frame.lit.points.end());
    indices.insert({0, points.size() - 1});
    const std::span<const std::size_t> picked = picked_points(frame.state.selection);
    indices.insert(picked.begin(), picked.end());
    if (const auto* point = std::get_if<HoveredPoint>(&frame.state.hover)) indices.insert(point->index);
    std::vector<MarkPlace> places;
    for (const std::size_t i : indices) {
        if (i >= points.size()) continue;
        const glm::dvec2 place = frame.screen(points[i]);
        if (frame.pen.reach().contains(place)) places.push_back({i, place});
    }
    return places;
}

/// Both, in ascending order.
std::vector<MarkPlace> together(const std::vector<MarkPlace>& places, const std::vector<MarkPlace>& others) {
    std::vector<MarkPlace> all;
    const auto comes_first = [](const MarkPlace& a, const MarkPlace& b) { return a.index < b.index; };
    std::set_union(places.begin(), places.end(), others.begin(), others.end(), std::back_inserter(all), comes_first);
    return all;
}

/// Without repeats, which points that stand for others may have.
std::vector<MarkPlace> in_order(std::vector<MarkPlace> places) {
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
    const auto is_same = [](const MarkPlace& a, const MarkPlace& b) { return a.index == b.index; };
    places.erase(std::unique(places.begin(), places.end(), is_same), places.end());
    return places;
}

/// As many of the points as a hand can tell from each other, and what the user points at.
std::vector<MarkPlace> for_drawing(const CanvasFrame& frame, std::vector<MarkPlace> places) {
    return together(thinned(in_order(std::move(places)), frame.pen.px(drawing_gap), frame.screen({0.0, 0.0})),
                    pointed_at(frame));
}

}  // namespace

ShownPoints shown_points(const CanvasFrame& frame) {
    ShownPoints shown;
    if (!has_points(frame) || shown_fit(frame) != nullptr) return shown;
    std::vector<MarkPlace> places;
    const bool is_drawing = frame.state.view.overlays.is_drawing();
    const auto points = frame.curve->control_points();
    const auto take = [&](std::size_t i, core::Point, std::size_t count) {
        if (is_drawing && count > 1) i = lasting_index(i, std::min(count, points.size() - i));
        const glm::dvec2 place = frame.screen(points[i]);
        if (!frame.pen.reach().contains(place)) return;
        places.push_back({i, place});
        shown.seen += count;
    };
    const double scale = frame.state.view.camera.scale;
    const double margin = frame.pen.size_px().x - frame.pen.reach().upper_px.x;
    frame.kept->polygon().visit_points(frame.seen(-margin), frame.pen.px(merged_points) / scale, most_candidates(frame),
                                       take);
    const auto most = static_cast<std::size_t>(most_points_per_px * frame.pen.size_px().x);
    const bool is_thinned = shown.seen > places.size();
    if (is_drawing) places = for_drawing(frame, std::move(places));
    shown.crowd = settle(frame, std::move(places), {point_radii, point_gap, most, is_thinned});
    shown.large = is_dense(shown) ? pointed_at(frame) : shown.crowd.shown;
    return shown;
}

bool has_point_near(const CanvasFrame& frame, const ShownPoints& points, glm::dvec2 place, double distance_px) {
    if (is_dense(points) || !has_points(frame)) return false;
    core::Box box;
    for (const double side : {-distance_px, distance_px})
        box.include(core::Point(render::world_from_screen(frame.state.view.camera, place + glm::dvec2(side))));
    bool is_near = false;
    frame.kept->polygon().visit_points(box, 0.0, most_candidates(frame),
                                       [&](std::size_t, core::Point point, std::size_t) {
                                           is_near = is_near || glm::distance(frame.screen(point), place) < distance_px;
                                       });
    return is_near;
}

}  // namespace batten::editor
