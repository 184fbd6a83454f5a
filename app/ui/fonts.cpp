#include "app/ui/fonts.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <span>
#include <string_view>

#include "app/ui/imgui_compat.h"

namespace batten::ui {

namespace {

/// A file that may be there, and the height of its lines for a size of 1, which is what Dear ImGui takes as the size.
struct FontFile {
    const char* path;
    double line_height;
};

constexpr double inter_line = 1.21;
constexpr double jetbrains_line = 1.32;
constexpr double dejavu_line = 1.164;

constexpr std::array text_files{
    FontFile{"/usr/share/fonts/opentype/inter/Inter-Regular.otf", inter_line},
    FontFile{"/usr/share/fonts/truetype/inter/Inter-Regular.ttf", inter_line},
    FontFile{"/usr/share/fonts/opentype/inter/static/Inter-Regular.otf", inter_line},
    FontFile{"/usr/share/fonts/inter/Inter-Regular.otf", inter_line},
    FontFile{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", dejavu_line},
    FontFile{"/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", dejavu_line},
    FontFile{"/usr/share/fonts/TTF/DejaVuSans.ttf", dejavu_line},
};

constexpr std::array bold_files{
    FontFile{"/usr/share/fonts/opentype/inter/Inter-SemiBold.otf", inter_line},
    FontFile{"/usr/share/fonts/truetype/inter/Inter-SemiBold.ttf", inter_line},
    FontFile{"/usr/share/fonts/opentype/inter/static/Inter-SemiBold.otf", inter_line},
    FontFile{"/usr/share/fonts/inter/Inter-SemiBold.otf", inter_line},
    FontFile{"/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf", dejavu_line},
    FontFile{"/usr/share/fonts/dejavu-sans-fonts/DejaVuSans-Bold.ttf", dejavu_line},
    FontFile{"/usr/share/fonts/TTF/DejaVuSans-Bold.ttf", dejavu_line},
};

constexpr std::array number_files{
    FontFile{"/usr/share/fonts/truetype/jetbrains-mono/JetBrainsMono-Regular.ttf", jetbrains_line},
    FontFile{"/usr/share/fonts/jetbrains-mono/JetBrainsMono-Regular.ttf", jetbrains_line},
    FontFile{"/usr/share/fonts/TTF/JetBrainsMono-Regular.ttf", jetbrains_line},
    FontFile{"/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf", dejavu_line},
    FontFile{"/usr/share/fonts/dejavu-sans-mono-fonts/DejaVuSansMono.ttf", dejavu_line},
    FontFile{"/usr/share/fonts/TTF/DejaVuSansMono.ttf", dejavu_line},
};

/// Has every sign that the interface shows; fills in what another font lacks.
constexpr std::array fallback_files{
    FontFile{"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", dejavu_line},
    FontFile{"/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", dejavu_line},
    FontFile{"/usr/share/fonts/TTF/DejaVuSans.ttf", dejavu_line},
};

/// Pairs of first and last character, ended by 0. The atlas reads them until it is built, so they outlive load_fonts().
constexpr std::array<ImWchar, 27> characters{0x0020, 0x00FF,  // Latin
                                             0x0100, 0x017F,  // Latin extended, for file names
                                             0x0370, 0x03FF,  // Greek
                                             0x1D62, 0x1D6A,  // subscript letters
                                             0x2010, 0x2027,  // dashes, quotes, bullet, ellipsis
                                             0x2030, 0x203A,  // primes, angle quotes
                                             0x2070, 0x209C,  // super- and subscripts
                                             0x2190, 0x21FF,  // arrows
                                             0x2200, 0x22FF,  // mathematics
                                             0x23E9, 0x23FA,  // play and pause
                                             0x2500, 0x25FF,  // boxes and geometric shapes
                                             0x2600, 0x26FF,  // signs
                                             0x2713, 0x2717,  // ticks and crosses
                                             0};

/// Whether it can be read and begins as files of TrueType and OpenType fonts do; Dear ImGui would end the program.
bool is_font(const char* path) {
    constexpr std::array<std::string_view, 4> beginnings{std::string_view("\0\1\0\0", 4), "OTTO", "true", "ttcf"};
    std::array<char, 4> beginning{};
    std::ifstream(path, std::ios::binary).read(beginning.data(), beginning.size());
    return std::ranges::find(beginnings, std::string_view(beginning.data(), beginning.size())) != beginnings.end();
}

const FontFile* first_present(std::span<const FontFile> files) {
    const auto found = std::ranges::find_if(files, [](const FontFile& file) { return is_font(file.path); });
    return found == files.end() ? nullptr : &*found;
}

/// Whole pixels, so that lines of text sit on whole pixels below one another.
float line_pixels(const FontFile& file, double size_px) {
    return static_cast<float>(std::max(6.0, std::round(size_px * file.line_height)));
}

ImFont* add_built_in(ImFontAtlas& atlas, double size_px) {
    ImFontConfig config;
    config.SizePixels = static_cast<float>(std::round(size_px));
    return atlas.AddFontDefault(&config);
}

/// Adds the first of `files` that is there, and behind it the signs that it lacks.
ImFont* add_font(ImFontAtlas& atlas, std::span<const FontFile> files, double size_px) {
    const FontFile* file = first_present(files);
    if (file == nullptr) return add_built_in(atlas, size_px);
    ImFontConfig config;
    config.OversampleH = 2;
    ImFont* font = atlas.AddFontFromFileTTF(file->path, line_pixels(*file, size_px), &config, characters.data());
    if (font == nullptr) return add_built_in(atlas, size_px);
    const FontFile* fallback = first_present(fallback_files);
    if (fallback != nullptr && fallback->path != file->path) {
        config.MergeMode = true;
        atlas.AddFontFromFileTTF(fallback->path, line_pixels(*fallback, size_px), &config, characters.data());
    }
    return font;
}

}  // namespace

Fonts load_fonts(double scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    clear_fonts(atlas);
    // Without mouse cursors the atlas is smaller; the window system draws the pointer.
    atlas.Flags |= ImFontAtlasFlags_NoMouseCursors;
    Fonts fonts;
    fonts.scale = scale;
    fonts.text = add_font(atlas, text_files, 13.0 * scale);
    fonts.bold = add_font(atlas, bold_files, 13.0 * scale);
    // The wide letters of the monospaced font look as large as the text at 12.
    fonts.number = add_font(atlas, number_files, 12.0 * scale);
    fonts.small = add_font(atlas, text_files, 11.0 * scale);
    fonts.large = add_font(atlas, bold_files, 22.0 * scale);
    // The font that is always there has no sign before negative numbers.
    constexpr ImWchar minus = 0x2212;
    for (ImFont* font : {fonts.text, fonts.bold, fonts.number, fonts.small, fonts.large})
        stand_in(atlas, *font, minus, '-');
    return fonts;
}

ImFont* font_of(const Fonts& fonts, render::LabelFont font) {
    switch (font) {
        case render::LabelFont::text:
            return fonts.text;
        case render::LabelFont::bold:
            return fonts.bold;
        case render::LabelFont::number:
            return fonts.number;
    }
    return fonts.text;
}

}  // namespace batten::ui
