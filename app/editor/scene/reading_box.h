/// A few lines of text on a ground of their own beside a place.
#pragma once

#include <span>
#include <string>

#include "app/editor/scene/canvas_frame.h"

namespace batten::editor {

struct ReadingRow {
    std::string text;
    render::Color color;
};

/// How high a reading of so many rows is.
double reading_height_px(const Pen& pen, std::size_t row_count);

/// Below and to the right of `place`, where there is room, else on the other side. It hides what lies beneath. Rows
/// that are wider than the picture are broken, if they can, between parts (" · "), else between words.
void draw_reading(CanvasFrame& frame, glm::dvec2 place, std::span<const ReadingRow> given);

}  // namespace batten::editor
