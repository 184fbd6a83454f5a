/// The fonts of the interface, from the system's packages.
#pragma once

#include <filesystem>
#include <string>
#include <tl/expected.hpp>

#include "render/draw_list.h"

struct ImFont;

namespace batten::ui {

/// Loaded at one scale; Inter and JetBrains Mono, else DejaVu, else the font built into Dear ImGui.
struct Fonts {
    ImFont* text = nullptr;  ///< 13 px at scale 1
    ImFont* bold = nullptr;
    ImFont* number = nullptr;  ///< monospaced
    ImFont* small = nullptr;   ///< 11 px at scale 1, sub- and superscripts too
    ImFont* large = nullptr;   ///< 22 px at scale 1, headings of the welcome screen
    double scale = 1.0;
};

/// Fills the font atlas of the current Dear ImGui context anew for `scale` (window pixels per design pixel). The atlas'
/// texture must be made again afterward by the renderer backend.
Fonts load_fonts(double scale);

/// The ImGui font for a label's font.
ImFont* font_of(const Fonts& fonts, render::LabelFont font);

}  // namespace batten::ui
