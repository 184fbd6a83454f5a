#include "render/figure_file.h"

#include <algorithm>
#include <array>

#include "render/prose.h"
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

void add_new(std::vector<std::string>& texts, const std::vector<std::string>& more) {
    for (const std::string& text : more)
        if (std::ranges::find(texts, text) == texts.end()) texts.push_back(text);
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
    FigureLosses losses{.labels = figure.unplaced,
                        .thinned = figure.thinned,
                        .has_title = figure.lacks_title,
                        .has_legend = figure.lacks_legend};
    const bool is_tikz = format == FigureFormat::tikz;
    const bool has_pictures = format == FigureFormat::pdf || format == FigureFormat::png;
    for (const FigurePart& part : figure.parts)
        for (const DrawCommand& command : part.list.commands) {
            losses.has_images = losses.has_images || (is_tikz && std::holds_alternative<ImageQuad>(command));
            const auto* label = std::get_if<Label>(&command);
            if (label == nullptr) continue;
            if (is_tikz) add_new(losses.letters, letters_without_tex(label->text));
            if (!is_tikz && part.is_prose) add_new(losses.commands, unset_commands(label->text));
            if (has_pictures)
                add_new(losses.boxes, letters_without_font(part.is_prose ? prose_label(label->text) : label->text));
        }
    return losses;
}

void add_losses(FigureLosses& losses, const FigureLosses& more) {
    add_new(losses.labels, more.labels);
    add_new(losses.letters, more.letters);
    add_new(losses.boxes, more.boxes);
    add_new(losses.commands, more.commands);
    if (losses.thinned.empty()) losses.thinned = more.thinned;  // numbers that differ from frame to frame
    losses.has_images = losses.has_images || more.has_images;
    losses.has_title = losses.has_title || more.has_title;
    losses.has_legend = losses.has_legend || more.has_legend;
}

}  // namespace batten::render
