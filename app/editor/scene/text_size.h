/// How large a label will be, without the fonts.
#pragma once

#include <glm/vec2.hpp>
#include <string_view>

#include "render/draw_list.h"

namespace batten::editor {

/// About how wide and high `text` (in the notation of render::Label) is at `size` pixels: the widths of common
/// interface fonts, sub- and superscripts at 0.7 of the size. Meant for keeping labels apart, good to about a tenth.
glm::dvec2 text_size(std::string_view text, double size, render::LabelFont font = render::LabelFont::text);

}  // namespace batten::editor
