/// Paints figures with Cairo: PDF and PNG, and what other painters need of it.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "render/figure.h"

namespace batten::render {

/// The bytes of a file, or a sentence of Cairo's.
using FigureBytes = tl::expected<std::string, std::string>;

/// `figure` as a page of PDF with the same lines, fills, marks and labels as in the window; labels are text, in the
/// interface's fonts or what the system has for them.
FigureBytes pdf_bytes(const Figure& figure);

/// `figure` in pixels, its size in whole ones, at most 32767 a side; what has no ground is transparent.
FigureBytes png_bytes(const Figure& figure);

/// The part of the ink's map that is touched, as a PNG; one clear pixel where none is.
FigureBytes png_bytes(const Ink& ink);

/// The image, which has at most 32767 pixels a side, as a PNG.
FigureBytes png_bytes(const Image& image);

/// How wide `text` without scripts is in a font of `size_px`.
double text_width(std::string_view text, double size_px, LabelFont font);

/// The signs of a label for which neither the interface's fonts nor DejaVu Sans have a picture, so that boxes stand for
/// them; in order.
std::vector<std::string> letters_without_font(std::string_view label);

}  // namespace batten::render
