#include "app/ui/rich_text.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <functional>
#include <string_view>

#include "app/ui/imgui_compat.h"
#include "app/ui/style.h"
#include "render/label_runs.h"

namespace batten::ui {

namespace {

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
    const float script_px = static_cast<float>(render::script_size) * size_px;
    ImFont* script_font = closest_font(font, script_px);
    float start = 0.0F;
    float end = 0.0F;
    for (const render::LabelRun& run : render::label_runs(text)) {
        if (!run.is_stacked) start = end;
        const bool is_script = run.script != render::Script::none;
        ImFont* run_font = is_script ? script_font : font;
        const float run_px = is_script ? script_px : size_px;
        const float top = is_script ? 0.5F * (size_px - run_px) + static_cast<float>(run.shift) * size_px : 0.0F;
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
