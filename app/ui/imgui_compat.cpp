#include "app/ui/imgui_compat.h"

#include <imgui_internal.h>

namespace batten::ui {

float font_height(const ImFont* font) {
#if IMGUI_VERSION_NUM >= 19200
    return font->LegacySize;
#else
    return font->FontSize;
#endif
}

void clear_fonts(ImFontAtlas& atlas) {
#if IMGUI_VERSION_NUM >= 19200
    atlas.ClearFonts();
#else
    atlas.Clear();
#endif
}

void stand_in([[maybe_unused]] ImFontAtlas& atlas, ImFont& font, ImWchar character, ImWchar another) {
#if IMGUI_VERSION_NUM >= 19200
    if (!font.IsGlyphInFont(character)) font.AddRemapChar(character, another);
#else
    if (!atlas.IsBuilt()) atlas.Build();
    font.AddRemapChar(character, another, false);
#endif
}

void close_popups() {
    if (ImGui::GetCurrentContext()->OpenPopupStack.Size > 0) ImGui::ClosePopupToLevel(0, false);
}

}  // namespace batten::ui
