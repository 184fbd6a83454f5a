#include "app/editor/scene/other_curves.h"

#include <algorithm>

#include "app/editor/scene/canvas_frame.h"
#include "app/editor/scene/curve_strokes.h"

namespace batten::editor {

namespace {

constexpr double most_other_places = 4.0;  // of all lines, for each pixel of the picture's width

// Of what is painted anew with every move of the pointer.
constexpr double moving_tolerance_px = 1.0;

std::vector<CurveInColor> others(const CanvasFrame& frame) {
    const core::Document& document = frame.state.shown();
    std::vector<CurveInColor> found;
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        const core::DocumentCurve& item = document.curves[i];
        if (i == document.active || !item.visible) continue;
        const render::Color color = color_of_other(item, frame.theme);
        found.push_back({i, {item.curve, color}});
    }
    return found;
}

// Whether one of them is not as it is in the committed document.
bool are_moving(const CanvasFrame& frame, const std::vector<CurveInColor>& curves) {
    const core::Document& committed = frame.state.history.present();
    return frame.state.preview && std::ranges::any_of(curves, [&](const CurveInColor& one) {
               return one.index >= committed.curves.size() || committed.curves[one.index].curve != one.item.curve;
           });
}

bool is_kept(const OtherInk& kept, const InkPlace& place, double tolerance_px,
             const std::vector<CurveInColor>& curves) {
    return !kept.inks.empty() && kept.place == place && kept.tolerance_px <= tolerance_px &&
           std::equal(kept.items.begin(), kept.items.end(), curves.begin(), curves.end(),
                      [](const OtherInk::Item& item, const CurveInColor& other) { return item == other.item; });
}

OtherInk inked(CanvasFrame& frame, const InkPlace& place, double tolerance_px,
               const std::vector<CurveInColor>& curves) {
    OtherInk kept{place, tolerance_px, {}, {}};
    std::vector<std::shared_ptr<render::CoverageMap>> maps;
    for (const CurveInColor& other : curves) {
        kept.items.push_back(other.item);
        const auto of_color = std::find_if(kept.inks.begin(), kept.inks.end(),
                                           [&](const render::Ink& ink) { return ink.color == other.item.color; });
        const auto k = static_cast<std::size_t>(of_color - kept.inks.begin());
        if (of_color == kept.inks.end()) {
            maps.push_back(std::make_shared<render::CoverageMap>(place.size_px));
            kept.inks.push_back({maps.back(), other.item.color});
        }
        paint_curve(frame, frame.cache.curve(other.index, other.item.curve).strips(), place, tolerance_px, *maps[k]);
    }
    return kept;
}

/// The lines of the curves; none where they have too many places.
std::vector<SeenLine> lines_of(CanvasFrame& frame, const std::vector<CurveInColor>& curves) {
    const double most = most_other_places * frame.state.view.parts.fineness * frame.pen.size_px().x;
    double places = 0.0;
    std::vector<SeenLine> lines;
    for (const CurveInColor& other : curves) {
        auto line = seen_polylines(frame, frame.cache.curve(other.index, other.item.curve).strips());
        if (!line) return {};
        for (const auto& run : line->runs) places += static_cast<double>(run.size());
        if (places > most) return {};
        lines.push_back(std::move(*line));
    }
    return lines;
}

}  // namespace

void draw_curves(CanvasFrame& frame, const std::vector<CurveInColor>& curves, double width, MovingInk moving,
                 OtherInk& kept) {
    Stroke stroke{.color = {}, .width = width};
    const InkPlace place = ink_place(frame, stroke);
    const bool is_moving = are_moving(frame, curves);
    // What was too much for lines before it moved still is.
    const bool is_much = is_moving && !kept.inks.empty() && kept.place == place && kept.items.size() == curves.size();
    if (is_much && moving == MovingInk::nothing) return;
    const double tolerance_px = is_moving ? moving_tolerance_px : ink_tolerance_px;
    if (!is_kept(kept, place, tolerance_px, curves)) {
        const std::vector<SeenLine> lines = is_much ? std::vector<SeenLine>() : lines_of(frame, curves);
        for (std::size_t k = 0; k < lines.size(); ++k) {
            stroke.color = curves[k].item.color;
            draw_line(frame, lines[k], stroke);
        }
        kept = lines.size() == curves.size() ? OtherInk() : inked(frame, place, tolerance_px, curves);
    }
    for (const render::Ink& ink : kept.inks) frame.pen.ink(ink.map, ink.color);
}

void draw_other_curves(CanvasFrame& frame) {
    const core::Document& document = frame.state.shown();
    frame.cache.forget_beyond(document.curves.size());
    draw_curves(frame, others(frame), other_curve_width, MovingInk::coarse, frame.cache.others());
    // Over its dimmer line, which so need not be left out.
    const auto* hovered = std::get_if<HoveredOtherCurve>(&frame.state.hover);
    if (hovered == nullptr || hovered->index >= document.curves.size()) return;
    if (!document.curves[hovered->index].visible) return;
    const core::DocumentCurve& item = document.curves[hovered->index];
    const Stroke full{.color = color_of(item, frame.theme), .width = active_curve_width};
    draw_line(frame, seen_curve(frame, frame.cache.curve(hovered->index, item.curve), full), full);
}

}  // namespace batten::editor
