#include "render/figure_file.h"

#include <algorithm>
#include <array>

#include "render/svg_painter.h"
#include "render/tikz_painter.h"

namespace batten::render {

namespace {

struct Ending {
    std::string_view text;
    FigureFormat format;
};

constexpr std::array endings{Ending{".svg", FigureFormat::svg}, Ending{".pdf", FigureFormat::pdf},
                             Ending{".png", FigureFormat::png}, Ending{".tex", FigureFormat::tikz},
                             Ending{".tikz", FigureFormat::tikz}};

char small_letter(char letter) {
    return 'A' <= letter && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

}  // namespace

std::optional<FigureFormat> figure_format(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::ranges::transform(ending, ending.begin(), small_letter);
    const auto* found = std::ranges::find(endings, ending, &Ending::text);
    return found == endings.end() ? std::nullopt : std::optional(found->format);
}

FigureBytes figure_bytes(const Figure& figure, FigureFormat format) {
    switch (format) {
        case FigureFormat::svg:
            return svg_text(figure);
        case FigureFormat::tikz:
            return tikz_text(figure);
        case FigureFormat::pdf:
            return pdf_bytes(figure);
        case FigureFormat::png:
            break;
    }
    return png_bytes(figure);
}

}  // namespace batten::render
