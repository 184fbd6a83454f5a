/// Pictures of what the canvas shows, as files for slides and papers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/editor/command.h"
#include "app/editor/state/figure.h"

namespace batten::editor {

struct ExportFigure {
    std::filesystem::path path;  ///< its ending decides the format: .svg, .pdf, .png or .tex
    FigureView view = FigureView::curve;
    double scale = 1.0;  ///< pixels of a PNG for each of the design
    bool is_transparent = false;
    std::optional<std::string> title{};
    bool replace = false;                ///< a file that is there
    std::optional<double> width{};       ///< design pixels, > 0; none: as on the screen, or as the height asks for
    std::optional<double> height{};      ///< likewise
    std::optional<FigureTheme> theme{};  ///< none: that of the screen
    static const CommandSpec& spec();
};

}  // namespace batten::editor
