/// The one place for what differs between the versions of Dear ImGui that distributions carry (1.86 to 1.92).
#pragma once

#include <imgui.h>

// Input fields for std::string; where their header is differs too.
#if __has_include(<imgui_stdlib.h>)
#include <imgui_stdlib.h>
#else
#include <misc/cpp/imgui_stdlib.h>
#endif

namespace batten::ui {

/// Leaves the menu open in which a row is clicked.
#if IMGUI_VERSION_NUM >= 19100
inline constexpr int row_leaves_menu_open = ImGuiSelectableFlags_NoAutoClosePopups;
#else
inline constexpr int row_leaves_menu_open = ImGuiSelectableFlags_DontClosePopups;
#endif

/// The height in pixels of a line of `font`, as it was loaded.
float font_height(const ImFont* font);

/// Removes every font from `atlas`, so that it can be filled anew.
void clear_fonts(ImFontAtlas& atlas);

/// Shows `character` as `another` where `font`, one of `atlas` with all its fonts, does not have it.
void stand_in(ImFontAtlas& atlas, ImFont& font, ImWchar character, ImWchar another);

/// Closes every open menu, list and other popup.
void close_popups();

}  // namespace batten::ui
