/// Pictures side by side on one page: what painters write as a file.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/draw_list.h"
#include "render/pixel_box.h"

namespace batten::render {

/// A picture in `box` of the page, cut to it; its places count from the box's upper left corner.
struct FigurePart {
    DrawList list;
    PixelBox box;
    std::optional<Color> ground{};  ///< none: what lies below is seen
    bool is_prose = false;          ///< its labels are what a user wrote: words, and formulas between dollar signs
};

struct Figure {
    glm::dvec2 size_px{};  ///< > 0; a pixel is 1/96 of an inch on paper
    std::vector<FigurePart> parts;
    std::string title{};                  ///< what the file says of itself, as UTF-8; empty: nothing
    std::vector<std::string> unplaced{};  ///< labels that had no room
    std::vector<std::string> thinned{};   ///< sentences: of what not all is drawn
    bool lacks_title = false;             ///< which had no room either
    bool lacks_legend = false;            ///< likewise
};

/// What the file of a figure lacks.
struct FigureLosses {
    std::vector<std::string> labels{};    ///< that had no room, in the notation of Label
    std::vector<std::string> letters{};   ///< that LaTeX cannot set, each once
    std::vector<std::string> boxes{};     ///< letters for which no font has a picture, each once
    std::vector<std::string> commands{};  ///< of formulas, that stand there as they were typed, each once
    std::vector<std::string> thinned{};   ///< sentences: of what not all is drawn
    bool has_images = false;              ///< images, where the format has none
    bool has_title = false;               ///< a title that had no room
    bool has_legend = false;              ///< a legend likewise
};

/// A page with one picture on it.
inline Figure page_of(DrawList list, glm::dvec2 size_px, std::optional<Color> ground) {
    Figure figure{.size_px = size_px, .parts = {}};
    figure.parts.push_back({std::move(list), {{}, size_px}, ground});
    return figure;
}

}  // namespace batten::render
