#include "app/editor/state/theme.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace batten::editor {

namespace {

using render::rgb;

// Both stay apart under the common color-vision deficiencies; the dark one, for light grounds, by its lightness too.
constexpr std::array bright_palette{rgb(0xE69F00), rgb(0x56B4E9), rgb(0x2FBF8F), rgb(0xD9C93B),
                                    rgb(0x4C7FE0), rgb(0xE8743B), rgb(0xD583B6), rgb(0x9B8CF2)};
constexpr std::array deep_palette{rgb(0x9A5B00), rgb(0x1B739D), rgb(0x18825E), rgb(0x8E7D00),
                                  rgb(0x3647AE), rgb(0x9D2A10), rgb(0x863665), rgb(0x7B6ACE)};
constexpr std::array bright_contrast_palette{rgb(0xE69F00), rgb(0x56B4E9), rgb(0x2FBF8F), rgb(0xD9C93B),
                                             rgb(0x5988E2), rgb(0xE8743B), rgb(0xD583B6), rgb(0x9B8CF2)};
constexpr std::array deep_contrast_palette{rgb(0x915600), rgb(0x196A90), rgb(0x157152), rgb(0x726400),
                                           rgb(0x3647AE), rgb(0x9D2A10), rgb(0x863665), rgb(0x6557A9)};
constexpr double share_in_text = 0.7;
constexpr double share_at_rest = 0.9;
constexpr double comb_share_at_rest = 0.7;

Theme dark_theme() {
    Theme theme;
    theme.canvas = rgb(0x14161B);
    theme.panel = rgb(0x1B1E25);
    theme.field = rgb(0x22262F);
    theme.line = rgb(0x2D323D);
    theme.text = rgb(0xE7EAF0);
    theme.dim = rgb(0x979EAD);
    theme.accent = rgb(0x5AA9FF);
    theme.curve = rgb(0xF1F4F9);
    theme.polygon = rgb(0x616A7A);
    theme.grid_minor = rgb(0x1D2027);
    theme.grid_major = rgb(0x262A33);
    theme.parameter = rgb(0xFFD166);
    theme.error = rgb(0xFF7B72);
    theme.comb = rgb(0xC58AF9);
    theme.levels = {rgb(0x4FC3A1), rgb(0xF2A65A), rgb(0xEF6F8E)};
    theme.palette = bright_palette;
    return theme;
}

Theme light_theme() {
    Theme theme;
    theme.canvas = rgb(0xFBFBFD);
    theme.panel = rgb(0xF1F3F7);
    theme.field = rgb(0xE6E9F0);
    theme.line = rgb(0xD3D8E2);
    theme.text = rgb(0x1B2130);
    theme.dim = rgb(0x555D6F);
    theme.accent = rgb(0x1157C4);
    theme.curve = rgb(0x10131A);
    theme.polygon = rgb(0x818C9F);
    theme.grid_minor = rgb(0xF0F2F6);
    theme.grid_major = rgb(0xE3E7EE);
    theme.parameter = rgb(0xA94E08);
    theme.error = rgb(0xB42318);
    theme.comb = rgb(0x8A2BB8);
    theme.levels = {rgb(0x0C7556), rgb(0xA2520C), rgb(0xC0304A)};
    theme.palette = deep_palette;
    return theme;
}

Theme dark_contrast_theme() {
    Theme theme = dark_theme();
    theme.canvas = rgb(0x000000);
    theme.panel = rgb(0x0B0D11);
    theme.field = rgb(0x171A21);
    theme.line = rgb(0x4A5262);
    theme.text = rgb(0xFFFFFF);
    theme.dim = rgb(0xB6BBC6);
    theme.accent = rgb(0x84BFFF);
    theme.curve = rgb(0xFFFFFF);
    theme.polygon = rgb(0x858D9A);
    theme.error = rgb(0xFF8279);
    theme.comb = rgb(0xCB98FA);
    theme.levels = {rgb(0x4FC3A1), rgb(0xF2A65A), rgb(0xF286A0)};
    theme.palette = bright_contrast_palette;
    return theme;
}

Theme light_contrast_theme() {
    Theme theme = light_theme();
    theme.canvas = rgb(0xFFFFFF);
    theme.panel = rgb(0xF7F8FA);
    theme.field = rgb(0xEDEFF4);
    theme.line = rgb(0xA7AEBC);
    theme.text = rgb(0x000000);
    theme.dim = rgb(0x3C424F);
    theme.accent = rgb(0x0C3E8B);
    theme.curve = rgb(0x000000);
    theme.polygon = rgb(0x5D6472);
    theme.parameter = rgb(0x7B3906);
    theme.error = rgb(0x951D14);
    theme.comb = rgb(0x681890);
    theme.levels = {rgb(0x095740), rgb(0x783D09), rgb(0x8C1C45)};
    theme.palette = deep_contrast_palette;
    return theme;
}

double luminance(render::Color color) {
    const auto linear = [](std::uint8_t part) {
        const double share = part / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

}  // namespace

render::Color Theme::point_text(std::size_t i) const {
    return render::blended(point(i), share_in_text, text);
}

render::Color Theme::resting_point(std::size_t i) const {
    return render::blended(point(i), share_at_rest, panel);
}

render::Color Theme::resting_comb() const {
    return render::blended(comb, comb_share_at_rest, canvas);
}

Theme theme_of(ThemeName name) {
    return name == ThemeName::dark ? dark_theme() : light_theme();
}

Theme high_contrast(ThemeName name) {
    return name == ThemeName::dark ? dark_contrast_theme() : light_contrast_theme();
}

double contrast(render::Color a, render::Color b) {
    const auto [darker, lighter] = std::minmax({luminance(a), luminance(b)});
    return (lighter + 0.05) / (darker + 0.05);
}

render::Color seen_on_canvas(render::Color color, const Theme& theme) {
    constexpr double contrast_of_line = 3.0;
    constexpr int steps = 20;
    render::Color seen = color;
    for (int k = 1; k <= steps && contrast(seen, theme.canvas) < contrast_of_line; ++k)
        seen = render::blended(theme.text, static_cast<double>(k) / steps, color);
    return seen;
}

}  // namespace batten::editor
