/// Texts that are left out rather than written over one another.
#pragma once

#include <string>
#include <vector>

#include "app/editor/scene/pen.h"

namespace batten::editor {

/// Remembers what was written; what matters most is to be written first.
class TextRow {
  public:
    /// Writes `text` unless it would come within a few pixels of an earlier one; what the edges of the picture would
    /// cut moves inside. Returns whether it did. Cost grows with the number of texts written so far.
    bool write(Pen& pen, glm::dvec2 position, const std::string& text, const TextStyle& style);

  private:
    std::vector<render::PixelBox> boxes_;
};

}  // namespace batten::editor
