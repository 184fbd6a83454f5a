/// Figures as files: which painter writes which format.
#pragma once

#include <filesystem>
#include <optional>

#include "render/cairo_painter.h"

namespace batten::render {

enum class FigureFormat { svg, pdf, png, tikz };

/// The format of files with this ending: ".svg", ".pdf", ".png", ".tex" or ".tikz", in letters of any case.
std::optional<FigureFormat> figure_format(const std::filesystem::path& file);

/// Whether files of that format show pixels where they are enlarged.
constexpr bool has_pixels(FigureFormat format) {
    return format == FigureFormat::png;
}

/// The bytes of a file.
FigureBytes figure_bytes(const Figure& figure, FigureFormat format);

/// What that file lacks of the figure.
FigureLosses figure_losses(const Figure& figure, FigureFormat format);

/// Adds to `losses` what `more` has beside them.
void add_losses(FigureLosses& losses, const FigureLosses& more);

}  // namespace batten::render
