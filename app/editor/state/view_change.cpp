#include "app/editor/state/view_change.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "app/editor/pointer/fit_view.h"
#include "app/editor/scene/legend.h"
#include "app/editor/state/picture_gauge.h"
#include "app/editor/state/show_dialog.h"
#include "app/editor/state/state.h"
#include "app/editor/upkeep.h"
#include "render/orbit_camera.h"

namespace batten::editor {

namespace {

constexpr double least_picture_px = 1.0;
constexpr core::Interval interface_scales{0.1, 20.0};
constexpr double seconds_for_domain = 5.0;  // at speed 1

// A share of the domain, 0..1, with the direction in which it moves on.
struct Position {
    double share = 0.0;
    int direction = 1;
};

// Unfolds the way there and back into one way of length 2, on which the place is found by a remainder.
Position turned(Position from, double way) {
    const double start = from.direction > 0 ? from.share : 2.0 - from.share;
    const double end = std::fmod(start + way, 2.0);
    return end < 1.0 ? Position{end, 1} : Position{2.0 - end, -1};
}

Position wrapped(Position from, double way) {
    const double end = from.share + way;
    return {end <= 1.0 ? end : std::fmod(end, 1.0), 1};
}

void advance(EditorState& state, double seconds) {
    Playback& playback = state.view.playback;
    if (!playback.is_playing || state.active_curve() == nullptr) return;
    const core::Interval domain = state.active_curve()->domain();
    const double way = playback.speed * seconds / seconds_for_domain;
    // Not into_domain: at the end of a closed curve that would be the start, which cannot be turned at.
    const Position from{(domain.clamp(state.view.parameter) - domain.lower) / domain.length(), playback.direction};
    const Position to = playback.ping_pong ? turned(from, way) : wrapped(from, way);
    state.view.parameter = domain.clamp(domain.lower + to.share * domain.length());
    playback.direction = to.direction;
}

// The camera for a picture of another size that shows all that `camera` shows, and nothing larger.
render::Camera with_size(render::Camera camera, glm::dvec2 size_px) {
    const glm::dvec2 shares = size_px / camera.size_px;
    const double factor = std::min({1.0, shares.x, shares.y});
    camera.scale = std::max(factor * camera.scale, render::Camera::min_scale);
    camera.size_px = size_px;
    return camera;
}

void resize(EditorState& state, glm::dvec2 size_px) {
    View& view = state.view;
    Framing& framing = view.framing;
    const bool is_fitted = std::exchange(view.fits_on_open, false) || framing.fitted == view.camera;
    if (framing.resized != view.camera) framing.chosen = view.camera;
    view.camera = with_size(framing.chosen, size_px);
    framing.resized = view.camera;
    if (is_fitted) fit_view(state);
}

// One case for each change.
struct Apply {
    EditorState& state;

    void operator()(const SetHover& change) const {
        state.hover = is_in(change.hover, state.shown()) ? change.hover : Hover(HoveredNothing{});
    }
    void operator()(const ShowPlace& change) const {
        state.placing.place = change.place;
        if (!change.place) state.placing.typed = {};
    }
    void operator()(const TypePlace& change) const { state.placing.typed = change.typed; }
    void operator()(const PanCamera& change) const {
        state.view.camera = render::panned(state.view.camera, change.offset_px);
    }
    void operator()(const ZoomCamera& change) const {
        assert(change.factor > 0.0);
        state.view.camera = render::zoomed(state.view.camera, change.factor, change.anchor_px);
    }
    void operator()(const ResizeCanvas& change) const {
        resize(state, {std::max(change.size_px.x, least_picture_px), std::max(change.size_px.y, least_picture_px)});
    }
    void operator()(const PlaceLegend& legend) const { state.view.legend_corner = legend.corner; }
    void operator()(const SetInterfaceScale& change) const {
        state.view.interface_scale = interface_scales.clamp(change.scale);
    }
    void operator()(const SetInspectorWidth& change) const {
        state.view.inspector_width = inspector_widths.clamp(change.width);
    }
    void operator()(const SetCardsWidth& change) const { state.view.cards_width = cards_widths.clamp(change.width); }
    void operator()(const SetDockHeight& change) const { state.view.dock_height = dock_heights.clamp(change.height); }
    void operator()(const SetPlotRange& change) const {
        assert(change.range.lower < change.range.upper);
        state.view.plot_range = change.range;
    }
    void operator()(const SetCombFactor& change) const {
        state.view.shape.comb_factor = comb_factors.clamp(change.factor);
    }
    void operator()(const SetProbeLine& change) const {
        assert(is_line(change.line));
        state.view.shape.line = change.line;
    }
    void operator()(const TurnOrbit& change) const {
        Orbit& orbit = state.view.orbit;
        const render::OrbitCamera camera = render::turned({.yaw = orbit.yaw, .pitch = orbit.pitch}, change.drag);
        orbit = {camera.yaw, camera.pitch, orbit_zooms.clamp(orbit.zoom * change.factor)};
    }
    void operator()(const AddGaugePoint& change) const { add_gauge_point(state, change.point); }
    void operator()(const SetBrushRadius& change) const { state.view.brush.radius = brush_radii.clamp(change.radius); }
    void operator()(const SetPivot& change) const {
        state.pivot.reset();
        if (change.point) state.pivot = TransformPivot{*change.point, state.history.present().active, state.selection};
    }
    void operator()(const SetAxisPoint& change) const {
        if (state.axis_pick) state.axis_pick->first = change.point;
    }
    void operator()(const EndAxisPick&) const { state.axis_pick.reset(); }
    void operator()(const Advance& change) const {
        assert(change.seconds >= 0.0);
        advance(state, change.seconds);
    }
    void operator()(const TellTime& change) const { state.now = change.seconds; }
    void operator()(const ShowRefusal& change) const { state.message = {change.sentence, change.is_alarm}; }
    void operator()(const ShowForm& change) const {
        show_dialog(state, Dialog::command_form);
        state.form = change.spec;
    }
    void operator()(const OfferRecovery& change) const { state.recoverable = change.recoverable; }
};

}  // namespace

void apply(EditorState& state, const ViewChange& change) {
    std::visit(Apply{state}, change);
}

}  // namespace batten::editor
