#include "render/figure_file.h"

#include <algorithm>
#include <array>

#include "render/svg_painter.h"
#include "render/tex_text.h"
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

FigureLosses figure_losses(const Figure& figure, FigureFormat format) {
    FigureLosses losses{.labels = figure.unplaced};
    if (format != FigureFormat::tikz) return losses;
    for (const FigurePart& part : figure.parts)
        for (const DrawCommand& command : part.list.commands) {
            losses.has_images = losses.has_images || std::holds_alternative<ImageQuad>(command);
            const auto* label = std::get_if<Label>(&command);
            if (label == nullptr) continue;
            for (std::string& letter : letters_without_tex(label->text))
                if (std::ranges::find(losses.letters, letter) == losses.letters.end())
                    losses.letters.push_back(std::move(letter));
        }
    return losses;
}

}  // namespace batten::render
