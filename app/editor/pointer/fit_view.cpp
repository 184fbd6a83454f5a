#include "app/editor/pointer/fit_view.h"

#include <algorithm>
#include <glm/common.hpp>

#include "app/editor/cards/floating_cards.h"
#include "app/editor/pointer/canvas_cover.h"
#include "app/editor/scene/insets.h"
#include "app/editor/scene/legend.h"
#include "app/editor/scene/views.h"
#include "core/curve/control_box.h"

namespace batten::editor {

namespace {

using render::Camera;
using render::PixelBox;

// Design pixels.
constexpr double fit_margin = 56.0;  // room for the labels of points at the rim
constexpr double least_margin = 18.0;

constexpr double largest_share = 0.15;  // of a small picture that the margin may take
constexpr double least_share = 0.25;    // of the scale without panels that going around them may leave
constexpr double default_scale = 64.0;
constexpr int most_fit_rounds = 6;

core::Box visible_box(const core::Document& document) {
    core::Box box;
    for (const core::DocumentCurve& item : document.curves) {
        if (!item.visible) continue;
        const core::Box curve_box = core::control_box(*item.curve);
        box.include(curve_box.lower);
        box.include(curve_box.upper);
    }
    for (const core::Picture& picture : document.pictures) {
        if (!picture.visible) continue;
        const double w = picture.width;
        const double h = picture.height;
        for (const core::PicturePlace corner : {core::PicturePlace{0, 0}, {w, 0}, {w, h}, {0, h}})
            box.include(core::plane_from_picture(picture, corner));
    }
    return box;
}

/// What lies over the canvas with the legend in `corner`.
std::vector<PixelBox> panels_of(const EditorState& state, Corner corner) {
    std::vector<PixelBox> panels;
    if (has_legend(state)) panels.push_back(legend_box(state, corner));
    if (const auto insets = insets_box(state)) panels.push_back(*insets);
    if (const auto cards = floating_cards_box(state))
        panels.push_back({{cards->lower_px.x, 0.0}, state.view.camera.size_px});
    return panels;
}

/// The parts of `area` that can be used beside a panel at one of its edges: all, what is level with none of the panel,
/// what is above or below none of it.
std::array<PixelBox, 3> parts_beside(const PixelBox& area, const PixelBox& panel) {
    std::array<PixelBox, 3> parts{area, area, area};
    const bool is_upper = panel.lower_px.y - area.lower_px.y < area.upper_px.y - panel.upper_px.y;
    const bool is_left = panel.lower_px.x - area.lower_px.x < area.upper_px.x - panel.upper_px.x;
    (is_upper ? parts[1].lower_px : parts[1].upper_px).y = is_upper ? panel.upper_px.y : panel.lower_px.y;
    (is_left ? parts[2].lower_px : parts[2].upper_px).x = is_left ? panel.upper_px.x : panel.lower_px.x;
    return parts;
}

std::vector<PixelBox> areas_beside(const PixelBox& picture, const std::vector<PixelBox>& panels) {
    std::vector<PixelBox> areas{picture};
    for (const PixelBox& panel : panels) {
        std::vector<PixelBox> smaller;
        for (const PixelBox& area : areas)
            for (const PixelBox& part : parts_beside(area, panel)) smaller.push_back(part);
        areas = std::move(smaller);
    }
    return areas;
}

/// The camera that shows `box` in the middle of `area`.
Camera fitted_into(const View& view, const core::Box& box, const PixelBox& area) {
    Camera camera = view.camera;
    camera.size_px = glm::max(area.upper_px - area.lower_px, glm::dvec2(1.0));
    const double smaller_px = std::min(camera.size_px.x, camera.size_px.y);
    const double scale = view.interface_scale;
    const double margin_px = std::clamp(largest_share * smaller_px, least_margin * scale, fit_margin * scale);
    camera = render::fitted(camera, box.lower, box.upper, margin_px);
    camera.size_px = view.camera.size_px;
    return render::panned(camera, 0.5 * (area.lower_px + area.upper_px - camera.size_px));
}

bool is_clear(const EditorState& state, const Camera& camera, const std::vector<PixelBox>& panels, SceneCache& cache) {
    return std::all_of(panels.begin(), panels.end(),
                       [&](const PixelBox& panel) { return covered(state, camera, panel, cache) == 0; });
}

/// With what views draw beyond `box`, as far as that is no more than a picture away on each side of `shown`.
core::Box with_reach(const EditorState& state, core::Box box, const core::Box& shown, SceneCache& cache) {
    EditorState trial = state;
    Camera& camera = trial.view.camera;
    camera = fitted_into(state.view, shown, {{}, camera.size_px});
    camera.size_px *= 3.0;
    const std::optional<PixelBox> reach = reach_of_views(trial, cache);
    if (!reach) return box;
    for (const glm::dvec2 corner : {reach->lower_px, reach->upper_px})
        box.include(core::Point(render::world_from_screen(camera, corner)));
    return box;
}

/// Teeth and arrows keep their pixels: they reach farther in the plane where more of it is seen.
core::Box with_views(const EditorState& state, const core::Box& box, SceneCache& cache) {
    core::Box shown = box;
    for (int round = 0; round < most_fit_rounds; ++round) {
        const core::Box wanted = with_reach(state, box, shown, cache);
        if (wanted.lower == shown.lower && wanted.upper == shown.upper) break;
        shown = wanted;
    }
    return shown;
}

/// Whether all of `box` is seen beside the insets.
bool is_beside_insets(const EditorState& state, const Camera& camera, const core::Box& box) {
    const auto insets = insets_box(state);
    const auto place = [&](core::Point corner) { return render::screen_from_world(camera, corner); };
    return !insets || !insets->overlaps(PixelBox::between(place(box.lower), place(box.upper)));
}

/// Tries all corners and ways around what lies over the canvas; the largest picture that is clear of it wins.
void fit_box(EditorState& state, const core::Box& curves) {
    View& view = state.view;
    SceneCache cache;
    const core::Box box = with_views(state, curves, cache);
    const bool has_more = box.lower != curves.lower || box.upper != curves.upper;
    const PixelBox picture{{}, view.camera.size_px};
    Camera best = fitted_into(view, box, picture);
    Corner corner = all_corners.front();
    double scale = least_share * best.scale;
    for (const Corner tried : all_corners) {
        if (has_legend(state) && meets_inset(state, tried)) continue;
        const std::vector<PixelBox> panels = panels_of(state, tried);
        for (const PixelBox& area : areas_beside(picture, panels)) {
            const Camera camera = fitted_into(view, box, area);
            if (camera.scale <= scale || !is_clear(state, camera, panels, cache)) continue;
            if (has_more && !is_beside_insets(state, camera, box)) continue;
            best = camera;
            corner = tried;
            scale = camera.scale;
        }
    }
    view.camera = best;
    view.legend_corner = corner;
}

}  // namespace

void fit_view(EditorState& state) {
    View& view = state.view;
    const core::Box box = visible_box(state.shown());
    if (box.is_empty()) {
        view.camera.center = {0.0, 0.0};
        view.camera.scale = default_scale * view.interface_scale;
    } else {
        fit_box(state, box);
    }
    view.framing.fitted = view.camera;
}

void refit_view(EditorState& state) {
    if (state.view.framing.fitted == state.view.camera) fit_view(state);
}

}  // namespace batten::editor
