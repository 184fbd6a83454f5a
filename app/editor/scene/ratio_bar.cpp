#include "app/editor/scene/ratio_bar.h"

#include <algorithm>

#include "app/editor/derived/blend_lines.h"
#include "app/editor/derived/construction_cells.h"
#include "app/editor/scene/text_size.h"

namespace batten::editor {

namespace {

constexpr double place_below_strip = 0.76;  // of the room below the strip's axis
constexpr double bar_half_height = 10.5;
constexpr double text_size_in_bar = 13.0;
constexpr double share_margin = 4.0;
constexpr double cut_width = 3.0;
constexpr double cut_beyond = 2.0;
constexpr double part_opacity = 0.35;

/// One side of the cut.
struct RatioPart {
    core::Interval parameters;
    std::string term;
    std::string share;
    double opacity;
};

struct RatioBar {
    RatioPart before;
    RatioPart after;
    render::Color color;
};

RatioBar bar_of(const PlotFrame& frame, const core::DeBoorTriangle& triangle, core::CellPlace place) {
    const Notation& notation = frame.state.view.notation;
    const BlendedCell blended{{frame.curve, triangle, notation}, place};
    const core::DeBoorCell& cell = blended.named.cell(place);
    const ShareTexts terms = blend_terms(blended);
    const ShareTexts shares = share_texts(notation, cell.alpha);
    const core::KnotVector& knots = frame.curve.knots();
    return {{{knots[cell.lower_knot], triangle.u}, terms.upper, shares.upper, 2.0 * part_opacity},
            {{triangle.u, knots[cell.upper_knot]}, terms.lower, shares.lower, part_opacity},
            frame.theme.level(place.level)};
}

render::PixelBox strip_box(const PlotFrame& frame, core::Interval x) {
    const double room = frame.pen.size_px().y - frame.layout.strip_px;
    const double y = frame.layout.strip_px + place_below_strip * room;
    const double half =
        std::min(frame.pen.px(bar_half_height), (1.0 - place_below_strip) * room - frame.pen.px(cut_beyond));
    return {{x.lower, y - half}, {x.upper, y + half}};
}

/// "8/15 P_{3}", "8/15" or nothing, as far as it fits.
void write_share(PlotFrame& frame, const render::PixelBox& box, const RatioPart& part) {
    const TextStyle style{.color = frame.theme.text,
                          .size = text_size_in_bar,
                          .anchor = render::Anchor::center,
                          .font = render::LabelFont::bold};
    const double room = box.upper_px.x - box.lower_px.x - 2.0 * frame.pen.px(share_margin);
    for (const std::string& text : {part.term, part.share}) {
        if (text_size(text, frame.pen.px(style.size), style.font).x > room) continue;
        frame.pen.text(0.5 * (box.lower_px + box.upper_px), text, style);
        return;
    }
}

/// The part as far as it is shown, `shift` later.
void draw_ratio_part(PlotFrame& frame, const RatioPart& part, double shift, render::Color color) {
    const auto band = frame.band({part.parameters.lower + shift, part.parameters.upper + shift});
    if (!band) return;
    const render::PixelBox box = strip_box(frame, {band->lower_px.x, band->upper_px.x});
    frame.pen.fill(corners_of(box), render::blended(color, part.opacity, frame.theme.panel));
    frame.pen.outline(corners_of(box), {.color = color, .width = 1.5});
    write_share(frame, box, part);
}

void draw_cut(PlotFrame& frame) {
    if (!frame.layout.range.contains(frame.u)) return;
    const double x = frame.x(frame.u);
    const render::PixelBox box = strip_box(frame, {x, x});
    const double beyond = frame.pen.px(cut_beyond);
    frame.pen.segment({x, box.lower_px.y - beyond}, {x, box.upper_px.y + beyond},
                      {.color = frame.theme.parameter, .width = cut_width});
}

}  // namespace

bool has_ratio_bar(const PlotFrame& frame) {
    const auto* cell = std::get_if<HoveredCell>(&frame.state.hover);
    return cell != nullptr && cell->level > 0;
}

void draw_ratio_bar(PlotFrame& frame) {
    if (!has_ratio_bar(frame)) return;
    const core::DeBoorTriangle triangle = core::de_boor_triangle(frame.curve, frame.u);
    const auto place = hovered_cell(frame.state, triangle);
    if (!place) return;
    const RatioBar bar = bar_of(frame, triangle, *place);
    const double period = frame.curve.domain().length();
    for (const RatioPart& part : {bar.before, bar.after}) {
        draw_ratio_part(frame, part, 0.0, bar.color);
        if (!frame.curve.is_periodic()) continue;
        draw_ratio_part(frame, part, period, bar.color);
        draw_ratio_part(frame, part, -period, bar.color);
    }
    draw_cut(frame);
}

}  // namespace batten::editor
