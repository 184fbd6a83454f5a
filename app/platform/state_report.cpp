#include "app/platform/state_report.h"

#include <fmt/core.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "app/editor/derived/lifted_stage.h"
#include "app/editor/pointer/plot_layout.h"
#include "app/editor/scene/insets.h"
#include "app/editor/state/selected_parts.h"
#include "core/curve/knot_analysis.h"
#include "core/evaluate/evaluate.h"

namespace batten::platform {

using nlohmann::json;

namespace {

json place_json(const ui::Rectangle& place) {
    return {
        {"x", place.origin_px.x}, {"y", place.origin_px.y}, {"width", place.size_px.x}, {"height", place.size_px.y}};
}

json pixel_json(glm::dvec2 pixel) {
    return {{"x", pixel.x}, {"y", pixel.y}};
}

json widgets_json(const ui::FrameLayout& layout) {
    json result = json::object();
    for (const ui::WidgetPlace& widget : layout.widgets) {
        result[widget.name] = place_json(widget.place);
        result[widget.name]["value"] = widget.value;
    }
    return result;
}

void add_labels(json& labels, const render::DrawList& picture, const ui::Rectangle& place) {
    for (const render::DrawCommand& command : picture.commands) {
        const auto* label = std::get_if<render::Label>(&command);
        if (label == nullptr) continue;
        json entry = pixel_json(place.origin_px + glm::dvec2(label->position));
        entry["text"] = label->text;
        labels.push_back(entry);
    }
}

json points_json(const editor::EditorState& state, const ui::Rectangle& canvas) {
    json result = json::array();
    for (const core::Point& point : state.active_curve()->control_points()) {
        result.push_back(pixel_json(canvas.origin_px + render::screen_from_world(state.view.camera, point)));
    }
    return result;
}

json strip_knots_json(const editor::EditorState& state, const ui::Rectangle& plot) {
    json result = json::array();
    for (const editor::KnotMark& mark : editor::knot_marks(state, editor::plot_layout(state, plot.size_px))) {
        json entry = pixel_json(plot.origin_px + mark.center_px);
        entry["index"] = mark.index;
        result.push_back(entry);
    }
    return result;
}

/// Where the curve is at its knots and in the middle of its spans, for clicks on it.
json curve_places_json(const editor::EditorState& state, const ui::Rectangle& canvas) {
    const core::Curve& curve = *state.active_curve();
    json result = json::array();
    std::optional<double> before;
    const auto add = [&](double u) {
        json entry =
            pixel_json(canvas.origin_px + render::screen_from_world(state.view.camera, core::point_at(curve, u)));
        entry["u"] = u;
        result.push_back(entry);
    };
    for (const core::DistinctKnot& knot : core::distinct_knots(curve.knots())) {
        if (!knot.in_domain) continue;
        if (before) add(0.5 * (*before + knot.value));
        add(knot.value);
        before = knot.value;
    }
    return result;
}

json knots_json(const core::Curve& curve) {
    json result = json::array();
    for (const core::DistinctKnot& knot : core::distinct_knots(curve.knots())) {
        result.push_back({{"value", knot.value}, {"multiplicity", knot.multiplicity}, {"continuity", knot.continuity}});
    }
    return result;
}

json insets_json(const editor::EditorState& state, const ui::Rectangle& canvas) {
    json result = json::object();
    for (const editor::InsetPlace& inset : editor::inset_places(state))
        result[core::name_of(inset.overlay)] =
            place_json({canvas.origin_px + inset.box.lower_px, inset.box.upper_px - inset.box.lower_px});
    return result;
}

/// Where the homogeneous view shows the control points; none while it is not shown.
json lifted_points_json(const editor::EditorState& state, const ui::Rectangle& canvas) {
    json result = json::array();
    const auto box = editor::inset_box(state, editor::Overlay::homogeneous);
    if (!box) return result;
    const editor::LiftedStage stage = editor::lifted_stage(state, *box);
    const core::Curve& curve = *state.active_curve();
    for (std::size_t i = 0; i < curve.control_points().size(); i += editor::lifted_stride(curve))
        result.push_back(pixel_json(canvas.origin_px + stage.screen(curve.control_points()[i], curve.weights()[i])));
    return result;
}

json overlay_names(const editor::Overlays& overlays) {
    json names = json::array();
    for (std::size_t i = 0; i < editor::overlay_count; ++i)
        if (overlays.is_shown(static_cast<editor::Overlay>(i)))
            names.push_back(core::name_of(static_cast<editor::Overlay>(i)));
    return names;
}

void add_curve(json& report, const editor::EditorState& state, const ui::FrameLayout& layout) {
    report["points"] = points_json(state, layout.canvas);
    report["weights"] = state.active_curve()->weights();
    report["insets"] = insets_json(state, layout.canvas);
    report["lifted_points"] = lifted_points_json(state, layout.canvas);
    report["strip_knots"] = strip_knots_json(state, layout.plot);
    report["curve_places"] = curve_places_json(state, layout.canvas);
    report["knots"] = knots_json(*state.active_curve());
    report["degree"] = state.active_curve()->degree();
}

// What of the input is handled, and how far the frames are.
void add_input(json& report, const ShownFrame& frame) {
    report["pointer"] = pixel_json(frame.input.handled_position_px());
    report["buttons_down"] = frame.input.handled_buttons_down();
    report["press_count"] = frame.input.handled_press_count();
    report["key_count"] = frame.input.handled_key_count();
    report["frames_per_second"] = frame.clock.frames_per_second();
    report["frame_count"] = frame.clock.frame_count();
    report["is_settled"] = frame.clock.is_settled() && !frame.input.is_pending();
}

}  // namespace

void write_state_report(const ShownFrame& frame, const std::filesystem::path& path) {
    const editor::EditorState& state = frame.state;
    json report;
    report["canvas"] = place_json(frame.layout.canvas);
    report["plot"] = place_json(frame.layout.plot);
    report["widgets"] = widgets_json(frame.layout);
    report["labels"] = json::array();
    add_labels(report["labels"], frame.canvas, frame.layout.canvas);
    add_labels(report["labels"], frame.plot, frame.layout.plot);
    if (state.active_curve() != nullptr) add_curve(report, state, frame.layout);
    report["curve_count"] = state.shown().curves.size();
    report["cursor"] = core::name_of(frame.layout.cursor);
    report["tool"] = core::name_of(state.tool);
    report["zoom"] = state.view.camera.scale;
    report["origin"] =
        pixel_json(frame.layout.canvas.origin_px + render::screen_from_world(state.view.camera, core::Point{}));
    report["parameter"] = state.parameter();
    report["selected_points"] = state.selection.points;
    report["selected_parts"] = editor::text_of_parts(editor::selected_parts(state));
    report["message"] = state.message.text;
    report["message_is_error"] = state.message.is_error;
    report["dialog"] = core::name_of(state.dialog);
    report["sketched_points"] = state.at_work ? state.at_work->sketch.points().size() : 0;
    report["at_work"] = state.at_work ? json(state.at_work->text) : json(nullptr);
    report["undo_label"] = state.history.undo_label();
    report["undo_count"] = state.history.undo_count();
    report["redo_count"] = state.history.redo_count();
    report["is_modified"] = state.is_modified();
    report["has_preview"] = state.preview.has_value();
    report["has_ghost"] = state.ghost.has_value();
    report["deviation"] = state.ghost ? json(state.ghost->deviation) : json(nullptr);
    report["path"] = state.path.string();
    report["interface_scale"] = state.view.interface_scale;
    const auto hovered = editor::hovered_u(state.hover);
    report["hovered_u"] = hovered ? json(*hovered) : json(nullptr);
    report["orbit"] = {{"yaw", state.view.orbit.yaw}, {"pitch", state.view.orbit.pitch}};
    report["theme"] = core::name_of(state.view.theme);
    report["overlays"] = overlay_names(state.view.overlays);
    report["is_playing"] = state.view.playback.is_playing;
    add_input(report, frame);

    const std::filesystem::path temporary = fmt::format("{}.new", path.string());
    std::ofstream(temporary) << report.dump(-1, ' ', false, json::error_handler_t::replace);
    std::error_code ignored;
    std::filesystem::rename(temporary, path, ignored);
}

}  // namespace batten::platform
