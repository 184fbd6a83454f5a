#include "app/ui/rich_text.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <functional>
#include <string_view>

#include "app/ui/imgui_compat.h"
#include "app/ui/style.h"

namespace batten::ui {

namespace {

enum class Script { none, sub, super };

struct Run {
    std::string_view text;
    Script script = Script::none;
};

// Of the height of the base font.
constexpr float script_size = 0.74F;
constexpr float script_shift = 0.3F;

/// Takes the next run off `rest`.
Run take_run(std::string_view& rest) {
    const auto starts_script = [](std::string_view text) {
        return text.substr(0, 2) == "_{" || text.substr(0, 2) == "^{";
    };
    if (starts_script(rest)) {
        const std::size_t end = std::min(rest.find('}'), rest.size());
        const Run run{rest.substr(2, end - 2), rest[0] == '_' ? Script::sub : Script::super};
        rest.remove_prefix(std::min(end + 1, rest.size()));
        return run;
    }
    std::size_t length = 1;
    while (length < rest.size() && !starts_script(rest.substr(length))) ++length;
    const Run run{rest.substr(0, length), Script::none};
    rest.remove_prefix(length);
    return run;
}

/// The loaded font whose own size is closest to `size_px`, for scripts: glyphs shrunk far from the size they were made
/// for blur.
ImFont* closest_font(ImFont* font, float size_px) {
    for (ImFont* other : ImGui::GetIO().Fonts->Fonts) {
        const float change = std::abs(font_height(other) - size_px);
        if (change < std::abs(font_height(font) - size_px)) font = other;
    }
    return font;
}

float run_width(std::string_view text, ImFont* font, float size_px) {
    return font->CalcTextSizeA(size_px, FLT_MAX, 0.0F, text.data(), text.data() + text.size()).x;
}

/// Calls visit(run, font, size, x, y) for each run, relative to the upper left corner; returns the width of the whole.
template <class Visit>
float lay_out(const std::string& text, ImFont* font, float size_px, const Visit& visit) {
    const float script_px = script_size * size_px;
    ImFont* script_font = closest_font(font, script_px);
    Script last = Script::none;
    float start = 0.0F;
    float end = 0.0F;
    for (std::string_view rest = text; !rest.empty();) {
        const Run run = take_run(rest);
        const bool is_stacked = last != Script::none && run.script != Script::none && run.script != last;
        if (!is_stacked) start = end;
        last = is_stacked ? Script::none : run.script;
        const bool is_script = run.script != Script::none;
        ImFont* run_font = is_script ? script_font : font;
        const float run_px = is_script ? script_px : size_px;
        const float shift = run.script == Script::sub ? script_shift : -script_shift;
        const float top = is_script ? 0.5F * (size_px - run_px) + shift * size_px : 0.0F;
        visit(run.text, run_font, run_px, start, top);
        end = std::max(end, start + run_width(run.text, run_font, run_px));
    }
    return end;
}

}  // namespace

TextSize rich_text_size(const std::string& text, ImFont* font, float size_px) {
    return {lay_out(text, font, size_px, [](auto&&...) {}), size_px};
}

void draw_rich_text(ImDrawList* list, const std::string& text, ImFont* font, float size_px, float x_px, float y_px,
                    render::Color color) {
    lay_out(text, font, size_px, [&](std::string_view run, ImFont* run_font, float run_px, float x, float y) {
        const ImVec2 corner(x_px + x, std::round(y_px + y));
        list->AddText(run_font, run_px, corner, imgui_packed(color), run.data(), run.data() + run.size());
    });
}

void rich_text_item(const std::string& text, ImFont* font, render::Color color) {
    const float size_px = font_height(font);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    draw_rich_text(ImGui::GetWindowDrawList(), text, font, size_px, corner.x, corner.y, color);
    const TextSize size = rich_text_size(text, font, size_px);
    ImGui::Dummy(ImVec2(size.width_px, size.height_px));
}

}  // namespace batten::ui
