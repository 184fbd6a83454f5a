#include "app/editor/theme.h"

namespace batten::editor {

namespace {

using render::rgb;

// Stays apart under the common color-vision deficiencies, on both canvases.
constexpr std::array palette{rgb(0xE69F00), rgb(0x56B4E9), rgb(0x2FBF8F), rgb(0xD9C93B),
                             rgb(0x4C7FE0), rgb(0xE8743B), rgb(0xD583B6), rgb(0x9B8CF2)};

Theme dark_theme() {
    Theme theme;
    theme.canvas = rgb(0x14161B);
    theme.panel = rgb(0x1B1E25);
    theme.field = rgb(0x22262F);
    theme.line = rgb(0x2D323D);
    theme.text = rgb(0xE7EAF0);
    theme.dim = rgb(0x8E96A6);
    theme.accent = rgb(0x5AA9FF);
    theme.curve = rgb(0xF1F4F9);
    theme.polygon = rgb(0x5F6878);
    theme.grid_minor = rgb(0x1D2027);
    theme.grid_major = rgb(0x262A33);
    theme.parameter = rgb(0xFFD166);
    theme.error = rgb(0xFF7B72);
    theme.levels = {rgb(0x4FC3A1), rgb(0xF2A65A), rgb(0xEF6F8E)};
    theme.palette = palette;
    return theme;
}

Theme light_theme() {
    Theme theme;
    theme.canvas = rgb(0xFBFBFD);
    theme.panel = rgb(0xF1F3F7);
    theme.field = rgb(0xE6E9F0);
    theme.line = rgb(0xD3D8E2);
    theme.text = rgb(0x1B2130);
    theme.dim = rgb(0x667085);
    theme.accent = rgb(0x1F6FEB);
    theme.curve = rgb(0x10131A);
    theme.polygon = rgb(0x9AA3B2);
    theme.grid_minor = rgb(0xF0F2F6);
    theme.grid_major = rgb(0xE3E7EE);
    theme.parameter = rgb(0xB45309);
    theme.error = rgb(0xB42318);
    theme.levels = {rgb(0x0F8A66), rgb(0xC2620E), rgb(0xC4314B)};
    theme.palette = palette;
    return theme;
}

}  // namespace

Theme theme_of(ThemeName name) {
    return name == ThemeName::dark ? dark_theme() : light_theme();
}

}  // namespace batten::editor
