/// Dear ImGui's colors, metrics and pairs from ours.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "app/editor/state/theme.h"

struct ImVec2;
struct ImVec4;

namespace batten::ui {

/// Sets colors, paddings, roundings of the current context for `theme` at `scale` (window pixels per design pixel).
void apply_style(const editor::Theme& theme, double scale);

ImVec4 imgui_color(render::Color color);
std::uint32_t imgui_packed(render::Color color);
ImVec2 imgui_pair(glm::dvec2 pair);

}  // namespace batten::ui
