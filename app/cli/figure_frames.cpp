#include "app/cli/figure_frames.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/cli/drawn_document.h"
#include "app/editor/derived/cut_polygon.h"
#include "app/editor/editor.h"
#include "app/editor/scene/figure_scene.h"
#include "app/editor/state/point_hues.h"
#include "core/base/number_text.h"
#include "core/base/sentence.h"
#include "core/edit/knot_edit.h"
#include "core/refine/corner_cutting.h"
#include "core/refine/knot_insertion.h"

namespace batten::cli {

namespace {

using Checked = tl::expected<void, std::string>;

/// The knot that `index` goes to: the next one that is larger; none where there is none.
std::optional<double> next_knot(const core::Curve& curve, std::size_t index) {
    const auto knots = curve.knots().stored();
    const auto next = std::upper_bound(knots.begin(), knots.end(), knots[index]);
    return next == knots.end() ? std::nullopt : std::optional(*next);
}

Checked check_inside(const core::Curve& curve, double u) {
    if (curve.is_periodic() || curve.domain().contains(u)) return {};
    return tl::unexpected(core::describe({.code = core::CurveErrorCode::parameter_outside_domain,
                                          .value = u,
                                          .lower = curve.domain().lower,
                                          .upper = curve.domain().upper}));
}

/// What the figure does not tell about where the curve is; empty where it tells nothing that is not so.
std::string note_on_place(const DrawnPlace& place, const editor::Overlays& overlays) {
    const bool is_moved = place.offset != core::Vector(0.0, 0.0) && has_coordinates(overlays);
    const bool is_scaled = place.exponent != 0 && has_lengths(overlays);
    const char* pattern = "";
    if (is_moved)
        pattern = "the curve is drawn moved by ({x}, {y}), and places on the figure are those of the drawn one";
    if (is_scaled)
        pattern =
            "the curve is drawn 2^{exponent} times as large as it is, and lengths on the figure are those of the drawn "
            "one";
    if (is_moved && is_scaled)
        pattern =
            "the curve is drawn moved by ({x}, {y}) and then 2^{exponent} times as large as it is, and places and "
            "lengths on the figure are those of the drawn one";
    return core::filled_as_needed(pattern, {{"x", core::shortest_text(place.offset.x)},
                                            {"y", core::shortest_text(place.offset.y)},
                                            {"exponent", place.exponent}});
}

/// Whether a curve can move so.
struct CheckMotion {
    const core::Curve& curve;

    Checked operator()(const RunningParameter& running) const {
        return check_inside(curve, running.range.lower).and_then([&] {
            return check_inside(curve, running.range.upper);
        });
    }
    Checked operator()(const InsertedKnot& knot) const {
        const auto cutting = core::corner_cutting(curve, knot.u);
        if (cutting) return {};
        if (cutting.error().code != core::CurveErrorCode::multiplicity_full)
            return tl::unexpected(core::describe(cutting.error()));
        return tl::unexpected(
            core::sentence("no knot {value} can come in: there are {count} of them already, the most that there may be",
                           {{"value", core::shortest_text(knot.u)}, {"count", count_of(knot.u)}}));
    }
    Checked operator()(const MergedKnot& knot) const {
        const std::size_t count = curve.knots().stored().size();
        if (knot.index >= count)
            return tl::unexpected(core::sentence("there is no knot {index}; the knots have the indices 0 to {last}",
                                                 {{"index", knot.index}, {"last", count - 1}}));
        const auto next = next_knot(curve, knot.index);
        if (!next)
            return tl::unexpected(core::sentence("no knot is larger than knot {index}, so it has none to go to",
                                                 {{"index", knot.index}}));
        const auto merged = core::set_knot(curve, knot.index, *next);
        if (merged) return {};
        if (merged.error().code != core::CurveErrorCode::multiplicity_too_high)
            return tl::unexpected(core::describe(merged.error()));
        return tl::unexpected(
            core::sentence("knot {index} cannot go to {value}: {count} knots are there already, the "
                           "most that there may be",
                           {{"index", knot.index}, {"value", core::shortest_text(*next)}, {"count", count_of(*next)}}));
    }

    std::size_t count_of(double value) const {
        const auto knots = curve.knots().stored();
        return static_cast<std::size_t>(std::count(knots.begin(), knots.end(), value));
    }
};

}  // namespace

tl::expected<FigureFrames, std::string> FigureFrames::make(const core::Document& document, const FigureOrder& order) {
    const core::Curve& curve = *document.active_curve()->curve;
    Checked checked = order.at ? check_inside(curve, *order.at) : Checked{};
    if (checked && order.motion) checked = std::visit(CheckMotion{curve}, *order.motion);
    if (!checked) return tl::unexpected(std::move(checked.error()));
    FigureFrames frames(order);
    frames.document_ = document;
    if (!order.has_pictures) frames.document_.pictures.clear();
    if (!order.has_guides) frames.document_.guides.clear();
    const DrawnPlace place = drawn_place(frames.document_);
    const bool is_moved = place.offset != core::Vector(0.0, 0.0);
    if (is_moved || place.exponent != 0) frames.document_ = drawn_document(frames.document_, place);
    frames.note_ = note_on_place(place, order.overlays);
    frames.posed_ = editor::Editor(frames.document_).state();
    editor::View& view = frames.posed_.view;
    view.theme = order.theme;
    view.overlays = order.overlays;
    view.parts = order.parts;
    if (order.at) view.parameter = *order.at;
    // Numbers that run would be fractions here and there.
    if (order.motion) view.notation.numbers = editor::NumberStyle::decimals;
    pose_for_figure(frames.posed_, order.form, order.size_px);
    return frames;
}

editor::EditorState FigureFrames::with_curve(const core::Curve& curve) const {
    core::Document document = document_;
    editor::replace_curve(document.curves[document.active], std::make_shared<const core::Curve>(curve));
    editor::EditorState state = editor::Editor(std::move(document)).state();
    state.view = posed_.view;
    return state;
}

render::Figure FigureFrames::at(double share) {
    const core::Curve& curve = *document_.active_curve()->curve;
    editor::EditorState state = posed_;
    editor::MovingPolygon moving;
    const auto* running = order_.motion ? std::get_if<RunningParameter>(&*order_.motion) : nullptr;
    const auto* inserted = order_.motion ? std::get_if<InsertedKnot>(&*order_.motion) : nullptr;
    const auto* merged = order_.motion ? std::get_if<MergedKnot>(&*order_.motion) : nullptr;
    if (running != nullptr) state.view.parameter = std::lerp(running->range.lower, running->range.upper, share);
    if (merged != nullptr) {
        const double from = curve.knots().stored()[merged->index];
        const auto moved =
            core::set_knot(curve, merged->index, std::lerp(from, *next_knot(curve, merged->index), share));
        if (moved) state = with_curve(*moved);
    }
    if (inserted != nullptr) {
        state = with_curve(*core::insert_knot(curve, inserted->u));
        moving = {editor::cut_polygon(curve, *core::corner_cutting(curve, inserted->u), share), share};
    }
    return figure_of(state, order_.form, order_.size_px, moving, spots_);
}

}  // namespace batten::cli
