#include "app/ui/style.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

namespace batten::ui {

namespace {

void apply_metrics(ImGuiStyle& style, double scale) {
    const auto px = [scale](double design_px) { return static_cast<float>(std::round(design_px * scale)); };
    const auto pair = [&px](double x, double y) { return ImVec2(px(x), px(y)); };
    style.WindowPadding = pair(16, 12);
    style.FramePadding = pair(8, 4);
    style.ItemSpacing = pair(8, 4);
    style.ItemInnerSpacing = pair(8, 4);
    style.CellPadding = pair(4, 2);
    style.IndentSpacing = px(16);
    style.ScrollbarSize = px(10);
    style.GrabMinSize = px(12);
    style.WindowRounding = 0.0F;
    style.ChildRounding = px(6);
    style.FrameRounding = px(5);
    style.PopupRounding = px(6);
    style.ScrollbarRounding = px(5);
    style.GrabRounding = px(4);
    style.WindowMinSize = ImVec2(1.0F, 1.0F);
    style.WindowBorderSize = 0.0F;
    style.ChildBorderSize = std::max(1.0F, px(1));
    style.PopupBorderSize = std::max(1.0F, px(1));
    style.FrameBorderSize = 0.0F;
    style.WindowTitleAlign = ImVec2(0.0F, 0.5F);
    style.DisabledAlpha = 0.45F;
    style.AntiAliasedLines = true;
    style.AntiAliasedFill = true;
    style.CurveTessellationTol = 0.6F;
}

void apply_surfaces(ImVec4* colors, const editor::Theme& theme) {
    colors[ImGuiCol_Text] = imgui_color(theme.text);
    colors[ImGuiCol_TextDisabled] = imgui_color(theme.dim);
    colors[ImGuiCol_TextSelectedBg] = imgui_color(render::faded(theme.accent, 0.35));
    colors[ImGuiCol_WindowBg] = imgui_color(theme.panel);
    colors[ImGuiCol_ChildBg] = imgui_color(render::faded(theme.panel, 0.0));
    colors[ImGuiCol_PopupBg] = imgui_color(theme.panel);
    colors[ImGuiCol_MenuBarBg] = imgui_color(theme.panel);
    colors[ImGuiCol_Border] = imgui_color(theme.line);
    colors[ImGuiCol_BorderShadow] = imgui_color(render::faded(theme.line, 0.0));
    colors[ImGuiCol_Separator] = imgui_color(theme.line);
    colors[ImGuiCol_ModalWindowDimBg] = imgui_color(render::faded(theme.canvas, 0.6));
    colors[ImGuiCol_ScrollbarBg] = imgui_color(render::faded(theme.panel, 0.0));
    colors[ImGuiCol_ScrollbarGrab] = imgui_color(theme.line);
    colors[ImGuiCol_ScrollbarGrabHovered] = imgui_color(render::blended(theme.dim, 0.5, theme.line));
    colors[ImGuiCol_ScrollbarGrabActive] = imgui_color(theme.dim);
}

void apply_widgets(ImVec4* colors, const editor::Theme& theme) {
    const auto tinted = [&theme](double opacity) {
        return imgui_color(render::blended(theme.accent, opacity, theme.field));
    };
    const auto accent = [&theme](double opacity) { return imgui_color(render::faded(theme.accent, opacity)); };
    colors[ImGuiCol_FrameBg] = imgui_color(theme.field);
    colors[ImGuiCol_FrameBgHovered] = tinted(0.12);
    colors[ImGuiCol_FrameBgActive] = tinted(0.22);
    colors[ImGuiCol_Button] = imgui_color(theme.field);
    colors[ImGuiCol_ButtonHovered] = tinted(0.16);
    colors[ImGuiCol_ButtonActive] = tinted(0.30);
    colors[ImGuiCol_Header] = accent(0.16);
    colors[ImGuiCol_HeaderHovered] = accent(0.20);
    colors[ImGuiCol_HeaderActive] = accent(0.30);
    colors[ImGuiCol_CheckMark] = imgui_color(theme.accent);
    colors[ImGuiCol_SliderGrab] = imgui_color(theme.accent);
    colors[ImGuiCol_SliderGrabActive] = imgui_color(theme.accent);
    colors[ImGuiCol_SeparatorHovered] = accent(0.6);
    colors[ImGuiCol_SeparatorActive] = imgui_color(theme.accent);
    colors[ImGuiCol_NavHighlight] = imgui_color(theme.accent);
    colors[ImGuiCol_DragDropTarget] = imgui_color(theme.accent);
    colors[ImGuiCol_TableBorderLight] = imgui_color(theme.line);
    colors[ImGuiCol_TableBorderStrong] = imgui_color(theme.line);
    colors[ImGuiCol_TableHeaderBg] = imgui_color(theme.panel);
}

}  // namespace

void apply_style(const editor::Theme& theme, double scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    apply_metrics(style, scale);
    apply_surfaces(style.Colors, theme);
    apply_widgets(style.Colors, theme);
}

ImVec4 imgui_color(render::Color color) {
    constexpr float full = 255.0F;
    return {static_cast<float>(color.red) / full, static_cast<float>(color.green) / full,
            static_cast<float>(color.blue) / full, static_cast<float>(color.alpha) / full};
}

std::uint32_t imgui_packed(render::Color color) {
    return IM_COL32(color.red, color.green, color.blue, color.alpha);
}

ImVec2 imgui_pair(glm::dvec2 pair) {
    return {static_cast<float>(pair.x), static_cast<float>(pair.y)};
}

}  // namespace batten::ui
