/// Dear ImGui's colors and metrics from our theme.
#pragma once

#include <cstdint>

#include "app/editor/state/theme.h"

struct ImVec4;

namespace batten::ui {

/// Sets colors, paddings, roundings of the current context for `theme` at `scale` (window pixels per design pixel).
void apply_style(const editor::Theme& theme, double scale);

ImVec4 imgui_color(render::Color color);
std::uint32_t imgui_packed(render::Color color);

}  // namespace batten::ui
