#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/editor/formula.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/panels.h"
#include "app/ui/rich_text.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "core/base/sentence.h"
#include "core/evaluate/evaluate.h"
#include "render/camera.h"

namespace batten::ui {

namespace {

constexpr double bar_margin = 16.0;
constexpr double gap = 20.0;
/// The scale of the camera that is called 100 %, in design pixels for a unit.
constexpr double full_zoom = 64.0;

/// A number with its name, in a column of fixed width so that it does not shift what is beside it.
struct Readout {
    std::string name;
    std::string value;
    std::size_t columns;
    std::string unit = {};
};

std::size_t letter_count(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string padded(const std::string& text, std::size_t columns) {
    const std::size_t count = letter_count(text);
    return count < columns ? std::string(columns - count, ' ') + text : text;
}

std::string text_of(const Readout& readout) {
    const std::string value = padded(readout.value, readout.columns);
    return readout.name.empty() ? fmt::format("{}{}", value, readout.unit)
                                : fmt::format("{} {}{}", readout.name, value, readout.unit);
}

/// As many digits as a pixel of the canvas tells apart.
int decimals_of(const render::Camera& camera) {
    return std::clamp(static_cast<int>(std::ceil(std::log10(camera.scale))), 0, 12);
}

std::string coordinate_text(double value, int decimals) {
    const std::string text = editor::fixed_text(value, decimals);
    return letter_count(text) <= 16 ? text : editor::number_text(value, 6);
}

void add_position(const PanelContext& context, std::vector<Readout>& readouts) {
    const render::Camera& camera = context.state.view.camera;
    const int decimals = decimals_of(camera);
    const std::size_t columns = static_cast<std::size_t>(std::max(7, decimals + 5));
    std::string x = "–";
    std::string y = "–";
    if (context.panels.pointer.canvas_px) {
        const core::Point world(render::world_from_screen(camera, *context.panels.pointer.canvas_px));
        x = coordinate_text(world.x, decimals);
        y = coordinate_text(world.y, decimals);
    }
    readouts.push_back({"x", x, columns});
    readouts.push_back({"y", y, columns});
}

std::string curvature_text(const editor::EditorState& state) {
    const core::Curve* curve = state.active_curve();
    if (curve == nullptr) return "–";
    const std::optional<double> curvature = core::curvature_at(*curve, state.parameter());
    return curvature ? editor::number_text(*curvature, 3) : "–";
}

std::string zoom_text(double percent) {
    return percent >= 10.0 && percent < 1e5 ? editor::fixed_text(percent, 0) : editor::number_text(percent, 2);
}

Readout frame_rate(const PanelContext& context, double frames_per_second) {
    const bool is_moving = frames_per_second >= 0.5 &&
                           (context.state.view.playback.is_playing || context.panels.pointer.captured != Picture::none);
    return {"", is_moving ? editor::fixed_text(frames_per_second, 0) : "", 3, is_moving ? " fps" : "    "};
}

/// From left to right; where the window is narrow the left ones are given up first.
std::vector<Readout> readouts_of(const PanelContext& context, double frames_per_second) {
    std::vector<Readout> readouts{frame_rate(context, frames_per_second), {"κ", curvature_text(context.state), 9}};
    add_position(context, readouts);
    const double zoom = 100.0 * context.state.view.camera.scale / (full_zoom * context.scale);
    readouts.push_back({"zoom", zoom_text(zoom), 5, " %"});
    return readouts;
}

/// Draws the readouts that fit into `room_px` at the right end; returns where they begin.
float draw_readouts(const PanelContext& context, const Rectangle& place, double frames_per_second, float room_px) {
    std::vector<Readout> readouts = readouts_of(context, frames_per_second);
    const auto width_of = [&] {
        float width = 0.0F;
        for (const Readout& readout : readouts) width += text_width(text_of(readout), context.fonts.number);
        return width + context.px(gap) * static_cast<float>(readouts.size());
    };
    while (!readouts.empty() && width_of() > room_px) readouts.erase(readouts.begin());
    const float begin = static_cast<float>(place.origin_px.x + place.size_px.x) - context.px(bar_margin) - width_of();
    const float line = font_height(context.fonts.number);
    const float y = static_cast<float>(place.origin_px.y) + 0.5F * (static_cast<float>(place.size_px.y) - line);
    float x = begin;
    for (const Readout& readout : readouts) {
        const std::string text = text_of(readout);
        const float width = text_width(text, context.fonts.number);
        x += context.px(gap);
        ImGui::GetWindowDrawList()->AddText(context.fonts.number, line, {std::floor(x), std::floor(y)},
                                            imgui_packed(context.theme.dim), text.c_str());
        context.widgets.push_back({fmt::format("status {}", readout.name.empty() ? "fps" : readout.name),
                                   {{x, y}, {width, line}},
                                   readout.value});
        x += width;
    }
    return begin;
}

/// What happened last; while a gesture previews a change, how far it goes.
editor::Message message_of(const editor::EditorState& state) {
    if (state.preview && state.ghost) {
        const std::string deviation = editor::number_text(state.ghost->deviation, 3);
        return {core::sentence("deviates by at most {deviation}", {{"deviation", deviation}}), false};
    }
    return state.message;
}

/// Draws `text` with its left end at `x_px`, shortened to `room_px`; returns its width.
float draw_status_text(const PanelContext& context, const std::string& name, const std::string& text, float x_px,
                       const Rectangle& place, float room_px, render::Color color) {
    if (text.empty() || room_px < context.px(40)) return 0.0F;
    const float line = font_height(context.fonts.text);
    const float y = static_cast<float>(place.origin_px.y) + 0.5F * (static_cast<float>(place.size_px.y) - line);
    const std::string shown = elided(text, context.fonts.text, room_px);
    draw_rich_text(ImGui::GetWindowDrawList(), shown, context.fonts.text, line, std::floor(x_px), y, color);
    const float width = rich_text_size(shown, context.fonts.text, line).width_px;
    context.widgets.push_back({name, {{x_px, y}, {width, line}}, text});
    return width;
}

}  // namespace

void draw_status_bar(const PanelContext& context, const Rectangle& place, const std::string& hint,
                     double frames_per_second) {
    begin_panel("status bar", place);
    draw_edge(context, {place.origin_px.x, place.origin_px.y + 0.5},
              {place.origin_px.x + place.size_px.x, place.origin_px.y + 0.5});
    const float left = static_cast<float>(place.origin_px.x) + context.px(bar_margin);
    const float begin = draw_readouts(context, place, frames_per_second, 0.62F * static_cast<float>(place.size_px.x));
    const editor::Message message = message_of(context.state);
    const std::string text = message.is_error ? fmt::format("⚠ {}", message.text) : message.text;
    // The message is worth more than the hint, which only gets what is left.
    const float room = begin - left;
    const float message_px = text.empty() ? 0.0F : std::min(text_width(text, context.fonts.text) + 1.0F, room);
    draw_status_text(context, "status message", text, begin - message_px, place, message_px,
                     message.is_error ? context.theme.error : context.theme.text);
    draw_status_text(context, "status hint", hint, left, place, room - message_px - context.px(gap), context.theme.dim);
    end_panel();
}

}  // namespace batten::ui
