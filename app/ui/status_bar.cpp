#include <fmt/core.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "app/editor/words/formula.h"
#include "app/editor/words/length.h"
#include "app/editor/words/reading_text.h"
#include "app/editor/words/wording.h"
#include "app/ui/context_popup.h"
#include "app/ui/imgui_compat.h"
#include "app/ui/panels.h"
#include "app/ui/rich_text.h"
#include "app/ui/shell_widgets.h"
#include "app/ui/style.h"
#include "app/ui/text_lines.h"
#include "core/base/sentence.h"
#include "core/base/utf8.h"
#include "core/evaluate/evaluate.h"
#include "render/camera.h"

namespace batten::ui {

namespace {

constexpr double bar_margin = 16.0;
constexpr double gap = 20.0;
constexpr std::size_t most_hint_lines = 2;
constexpr double straight = 1e-12;  ///< of curvature times size, which is not above its rounding
/// The scale of the camera that is called 100 %, in design pixels for a unit.
constexpr double full_zoom = 64.0;

/// A number with its name, in a column of fixed width so that it does not shift what is beside it.
struct Readout {
    std::string name;
    std::string value;
    std::size_t columns;
    std::string unit = {};
    std::string widget = {};  ///< what it is reported as where it has no name
    bool is_kept = false;     ///< whatever else finds no room
};

std::size_t letter_count(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return !core::continues_utf8(c); }));
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
int pixel_decimals(double pixels_per_unit) {
    return std::clamp(static_cast<int>(std::ceil(std::log10(pixels_per_unit))), 0, 12);
}

std::string coordinate_text(double value, int decimals) {
    const std::string text = editor::fixed_text(value, decimals);
    return letter_count(text) <= 16 ? text : editor::number_text(value, 6);
}

void add_position(const PanelContext& context, std::vector<Readout>& readouts) {
    const render::Camera& camera = context.state.view.camera;
    const editor::Units& units = context.state.shown().units;
    const int decimals = pixel_decimals(camera.scale * editor::world_per_length(units));
    const std::size_t columns = static_cast<std::size_t>(std::max(7, decimals + 5));
    std::string x = "–";
    std::string y = "–";
    if (context.panels.pointer.canvas_px) {
        const core::Point world(render::world_from_screen(camera, *context.panels.pointer.canvas_px));
        x = coordinate_text(editor::in_units(units, world.x), decimals);
        y = coordinate_text(editor::in_units(units, world.y), decimals);
    }
    // What has no value has no unit, but its place stays as wide.
    std::string unit = editor::unit_ending(units);
    if (!context.panels.pointer.canvas_px) unit.assign(letter_count(unit), ' ');
    readouts.push_back({"x", x, columns, unit, {}, true});
    readouts.push_back({"y", y, columns, unit, {}, true});
}

std::string curvature_text(const editor::EditorState& state) {
    const core::Curve* curve = state.active_curve();
    if (curve == nullptr) return "–";
    const std::optional<double> curvature = core::curvature_at(*curve, state.parameter());
    if (!curvature) return "–";
    const bool is_noise = std::abs(*curvature) * state.derived.of(*curve)->size < straight;
    return editor::number_text(is_noise ? 0.0 : editor::in_units(state.shown().units, *curvature, -1), 3);
}

std::string zoom_text(double percent) {
    return percent >= 10.0 && percent < 1e5 ? editor::fixed_text(percent, 0) : editor::number_text(percent, 2);
}

Readout frame_rate(const PanelContext& context, double frames_per_second) {
    const bool is_moving = frames_per_second >= 0.5 &&
                           (context.state.view.playback.is_playing || context.panels.pointer.captured != Picture::none);
    return {"", is_moving ? editor::fixed_text(frames_per_second, 0) : "", 3, is_moving ? " fps" : "    ", "fps"};
}

std::string recording_text(const editor::LessonRecording& recording) {
    return core::sentence({.one = "Recording a lesson: 1 step", .many = "Recording a lesson: {count} steps"},
                          recording.lesson.steps.size());
}

/// From left to right; where the window is narrow those that are not kept are given up, the left ones first.
std::vector<Readout> readouts_of(const PanelContext& context, double frames_per_second) {
    std::vector<Readout> readouts{frame_rate(context, frames_per_second), {"κ", curvature_text(context.state), 9}};
    add_position(context, readouts);
    const double zoom = 100.0 * context.state.view.camera.scale / (full_zoom * context.scale);
    readouts.push_back({"zoom", zoom_text(zoom), 5, " %"});
    // What runs unseen is forgotten.
    if (context.state.recording)
        readouts.push_back({"", recording_text(*context.state.recording), 0, "", "recording", true});
    return readouts;
}

float readouts_width(const PanelContext& context, const std::vector<Readout>& readouts) {
    float width = 0.0F;
    for (const Readout& readout : readouts)
        width += text_width(text_of(readout), context.fonts.number) + context.px(gap);
    return width;
}

/// Draws the readouts from `x` on.
void draw_readouts(const PanelContext& context, const Rectangle& place, const std::vector<Readout>& readouts, float x) {
    const float line = font_height(context.fonts.number);
    const float y = static_cast<float>(place.origin_px.y) + 0.5F * (static_cast<float>(place.size_px.y) - line);
    for (const Readout& readout : readouts) {
        const std::string text = text_of(readout);
        const float width = text_width(text, context.fonts.number);
        x += context.px(gap);
        ImGui::GetWindowDrawList()->AddText(context.fonts.number, line, {std::floor(x), std::floor(y)},
                                            imgui_packed(context.theme.dim), text.c_str());
        context.widgets.push_back({fmt::format("status {}", readout.name.empty() ? readout.widget : readout.name),
                                   {{x, y}, {width, line}},
                                   readout.value});
        x += width;
    }
}

/// What happened last; while a gesture previews a change, how far it goes.
editor::Message message_of(const editor::EditorState& state) {
    // A preview of very much does not tell how far it goes.
    if (state.preview && state.ghost && !std::isnan(state.ghost->deviation)) {
        if (!std::isfinite(state.ghost->deviation)) return {"How far the curve moves cannot be computed", false};
        if (state.ghost->deviation == 0.0) return {"The curve stays as it is", false};
        const editor::Units& units = state.shown().units;
        const std::string deviation = editor::bound_words(units, state.ghost->deviation, 3);
        return {core::sentence("The curve moves by at most {deviation}", {{"deviation", deviation}}), false};
    }
    return state.message;
}

/// Hint and message as they find room side by side.
struct StatusTexts {
    ImFont* font = nullptr;
    TextLines hint;
    TextLines message;

    bool are_whole() const { return hint.is_whole && message.is_whole; }
};

/// The message is worth more than the hint, but takes no more than `share` of the room from it.
StatusTexts arranged(const PanelContext& context, ImFont* font, const std::string& hint, const std::string& message,
                     float room_px, float share) {
    StatusTexts texts{font, {}, {}};
    const float most_px = hint.empty() ? room_px : share * room_px;
    texts.message = broken_into_lines(message, font, most_px, most_hint_lines);
    const float rest_px = room_px - texts.message.width_px - context.px(gap);
    texts.hint = broken_into_lines(hint, font, rest_px, most_hint_lines);
    if (texts.hint.width_px > rest_px) texts.hint = {.lines = {}, .is_whole = false};
    return texts;
}

/// Gives up readouts until hint and message are whole, then the size of the letters, then the end of the hint,
/// then, for a long message, hint and readouts.
StatusTexts arranged(const PanelContext& context, const std::string& hint, const std::string& message,
                     std::vector<Readout>& readouts, float room_px) {
    for (;;) {
        const float room = std::max(room_px - readouts_width(context, readouts), 0.0F);
        for (const float share : {0.5F, 0.35F}) {
            StatusTexts texts = arranged(context, context.fonts.text, hint, message, room, share);
            if (texts.are_whole()) return texts;
        }
        const auto next =
            std::find_if(readouts.begin(), readouts.end(), [](const Readout& readout) { return !readout.is_kept; });
        if (next != readouts.end()) {
            readouts.erase(next);
            continue;
        }
        for (const float share : {0.3F, 0.6F}) {
            StatusTexts texts = arranged(context, context.fonts.small, hint, message, room, share);
            if (texts.message.is_whole) return texts;
        }
        readouts.clear();
        return arranged(context, context.fonts.small, hint, message, std::max(room_px, 0.0F), 1.0F);
    }
}

/// Draws the lines from `x_px` on, one above the other.
void draw_status_text(const PanelContext& context, const std::string& name, const std::string& text,
                      const TextLines& lines, ImFont* font, float x_px, const Rectangle& place, render::Color color) {
    if (lines.lines.empty()) return;
    const float line = font_height(font);
    const float height = line * static_cast<float>(lines.lines.size());
    const float top = static_cast<float>(place.origin_px.y) + 0.5F * (static_cast<float>(place.size_px.y) - height);
    float y = std::floor(top);
    for (const std::string& part : lines.lines) {
        draw_rich_text(ImGui::GetWindowDrawList(), part, font, line, std::floor(x_px), y, color);
        y += line;
    }
    context.widgets.push_back({name, {{x_px, top}, {lines.width_px, height}}, text});
}

/// The text of the bar under the pointer; none beside them.
std::optional<std::string> pointed_text(const PanelContext& context, std::size_t first_widget) {
    const ImVec2 mouse = ImGui::GetMousePos();
    for (std::size_t i = first_widget; i < context.widgets.size(); ++i)
        if (context.widgets[i].place.contains({mouse.x, mouse.y})) return context.widgets[i].value;
    return std::nullopt;
}

void open_status_menu(const PanelContext& context, std::size_t first_widget) {
    if (!ImGui::IsWindowHovered() || !asks_for_menu()) return;
    if (const std::optional<std::string> text = pointed_text(context, first_widget))
        open_context_menu(context, editor::OnText{*text});
    else
        open_context_menu(context, editor::OnPanel{});
}

/// Pointing at a hint that had to be cut shows all of it.
void show_cut_hint(const PanelContext& context, const std::string& hint, const TextLines& lines,
                   const Rectangle& place) {
    if (lines.is_whole || !ImGui::IsWindowHovered()) return;
    const ImVec2 mouse = ImGui::GetMousePos();
    if (Rectangle{place.origin_px, {lines.width_px, place.size_px.y}}.contains({mouse.x, mouse.y}))
        draw_tooltip_at(context, editor::plain_text(hint), {place.origin_px.x, place.origin_px.y - context.px(6)},
                        {0.0, 1.0});
}

/// Pointing at the message shows all of it, with all digits.
void draw_message_item(const PanelContext& context, const std::string& message, const Rectangle& place) {
    if (message.empty() || place.size_px.x < 1.0) return;
    ImGui::SetCursorScreenPos({static_cast<float>(place.origin_px.x), static_cast<float>(place.origin_px.y)});
    ImGui::InvisibleButton("message", {static_cast<float>(place.size_px.x), static_cast<float>(place.size_px.y)});
    offer_full_message(context, message, {place.origin_px.x + place.size_px.x, place.origin_px.y - context.px(4)},
                       {1.0, 1.0});
}

}  // namespace

void draw_status_bar(const PanelContext& context, const Rectangle& place, const std::string& hint,
                     double frames_per_second) {
    begin_panel("status bar", place);
    const std::size_t first_widget = context.widgets.size();
    draw_edge(context, {place.origin_px.x, place.origin_px.y + 0.5},
              {place.origin_px.x + place.size_px.x, place.origin_px.y + 0.5});
    const editor::Message message = message_of(context.state);
    const std::string shown = context.notated(editor::reading_text(message.text));
    const std::string text = message.is_error ? fmt::format("⚠ {}", shown) : shown;
    const float left = static_cast<float>(place.origin_px.x) + context.px(bar_margin);
    const float room = static_cast<float>(place.size_px.x) - 2.0F * context.px(bar_margin);
    std::vector<Readout> readouts = readouts_of(context, frames_per_second);
    const StatusTexts texts = arranged(context, hint, text, readouts, room);
    const float begin = left + room - readouts_width(context, readouts);
    draw_readouts(context, place, readouts, begin);
    draw_status_text(context, "status message", text, texts.message, texts.font, begin - texts.message.width_px, place,
                     message.is_error ? context.theme.error : context.theme.text);
    draw_message_item(context, message.text,
                      {{begin - texts.message.width_px, place.origin_px.y}, {texts.message.width_px, place.size_px.y}});
    draw_status_text(context, "status hint", hint, texts.hint, texts.font, left, place, context.theme.dim);
    show_cut_hint(context, hint, texts.hint, {{left, place.origin_px.y}, place.size_px});
    open_status_menu(context, first_widget);
    end_panel();
}

}  // namespace batten::ui
