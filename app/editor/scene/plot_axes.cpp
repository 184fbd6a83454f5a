#include "app/editor/scene/plot_axes.h"

#include <fmt/core.h>

#include <string>

#include "app/editor/scene/shown_parameter.h"
#include "app/editor/scene/text_size.h"
#include "app/editor/words/formula.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

void shade(PlotFrame& frame, core::Interval parameters, render::Color color) {
    if (const auto box = frame.band(parameters)) frame.pen.fill(corners_of(*box), color);
}

void draw_level(PlotFrame& frame, double value) {
    const double y = frame.y(value);
    const double left = frame.layout.left_px;
    frame.pen.segment({left, y}, {frame.layout.right_px, y},
                      {.color = render::blended(frame.theme.line, 0.7, frame.theme.panel)});
    frame.pen.text({left - frame.pen.px(7.0), y}, number_text(value),
                   {.color = frame.theme.dim, .size = 11.0, .anchor = render::Anchor::right});
}

std::string readout_text(const PlotFrame& frame) {
    const Playback& playback = frame.state.view.playback;
    const std::string u = shown_parameter(frame.state.view, frame.curve, frame.u);
    return playback.is_playing ? fmt::format("▶ {}× u = {}", number_text(playback.speed, 2), u)
                               : fmt::format("u = {}", u);
}

/// What the functions of one Bézier curve are called, and all others.
struct TitlePatterns {
    const char* full;
    const char* brief;
};
constexpr TitlePatterns basis_title{"Basis functions N_{{i,{degree}}}(u)", "N_{{i,{degree}}}(u)"};
constexpr TitlePatterns bernstein_title{"Bernstein polynomials B_{{i,{degree}}}(u)", "B_{{i,{degree}}}(u)"};
constexpr TitlePatterns rational_title{"Basis functions N_{{i,{degree}}}(u), dashed: R_{{i,{degree}}}(u)",
                                       "N_{{i,{degree}}}, R_{{i,{degree}}}"};
constexpr TitlePatterns rational_bernstein_title{
    "Bernstein polynomials B_{{i,{degree}}}(u), dashed: R_{{i,{degree}}}(u)", "B_{{i,{degree}}}, R_{{i,{degree}}}"};

const TitlePatterns& title_patterns(const PlotFrame& frame) {
    const bool is_bezier = frame.state.derived.of(frame.curve.knots())->is_bezier;
    if (frame.curve.is_rational() && frame.state.view.overlays.is_shown(Overlay::rational_basis))
        return is_bezier ? rational_bernstein_title : rational_title;
    return is_bezier ? bernstein_title : basis_title;
}

/// The name of the functions alone where there is no room for more.
std::string title_text(const PlotFrame& frame, double room_px) {
    const TitlePatterns& patterns = title_patterns(frame);
    const std::string title = core::sentence(patterns.full, {{"degree", frame.curve.degree()}});
    const TextStyle style{.color = frame.theme.text, .font = render::LabelFont::bold};
    return text_size(title, frame.pen.px(style.size), style.font).x <= room_px
               ? title
               : core::sentence(patterns.brief, {{"degree", frame.curve.degree()}});
}

}  // namespace

void draw_plot_axes(PlotFrame& frame) {
    const core::Interval domain = frame.curve.domain();
    const render::Color outside = render::blended(frame.theme.canvas, 0.75, frame.theme.panel);
    shade(frame, {frame.layout.range.lower, domain.lower}, outside);
    shade(frame, {domain.upper, frame.layout.range.upper}, outside);
    for (const core::Interval& part : frame.lit.parts)
        shade(frame, part, render::blended(frame.theme.accent, 0.06, frame.theme.panel));
    const core::KnotVector& knots = frame.curve.knots();
    if (frame.state.view.parts.parameter)
        shade(frame, {knots[frame.span], knots[frame.span + 1]}, render::faded(frame.theme.accent, 0.07));
    for (const double value : {0.0, 0.5, 1.0}) draw_level(frame, value);
}

void draw_plot_title(PlotFrame& frame, const std::string& note) {
    const double y = 0.4 * frame.layout.top_px;
    const double margin = frame.pen.px(16.0);
    const TextStyle style{
        .color = frame.theme.parameter, .anchor = render::Anchor::right, .font = render::LabelFont::bold};
    const PictureParts& parts = frame.state.view.parts;
    const std::string u = parts.parameter ? readout_text(frame) : "";
    const double room = frame.pen.size_px().x - 3.0 * margin - text_size(u, frame.pen.px(style.size), style.font).x;
    const TextStyle title_style{.color = frame.theme.text, .font = render::LabelFont::bold};
    const std::string title = title_text(frame, room);
    const double title_width = text_size(title, frame.pen.px(title_style.size), title_style.font).x;
    frame.pen.text({margin, y}, title, title_style);
    const TextStyle note_style{.color = frame.theme.dim};
    if (parts.window && !note.empty() && text_size(note, frame.pen.px(note_style.size)).x <= room - title_width)
        frame.pen.text({2.0 * margin + title_width, y}, note, note_style);
    if (!u.empty()) frame.pen.text({frame.pen.size_px().x - margin, y}, u, style);
}

void draw_parameter_line(PlotFrame& frame) {
    if (!frame.state.view.parts.parameter || !frame.layout.range.contains(frame.u)) return;
    const double x = frame.x(frame.u);
    const bool is_hovered = std::holds_alternative<HoveredParameter>(frame.state.hover);
    frame.pen.segment({x, frame.layout.top_px - frame.pen.px(7.0)}, {x, frame.layout.strip_px + frame.pen.px(13.0)},
                      {.color = frame.theme.parameter, .width = is_hovered ? 3.0 : 2.0});
}

}  // namespace batten::editor
