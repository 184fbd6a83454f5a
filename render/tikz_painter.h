/// Paints figures as TikZ, for papers set with LaTeX.
#pragma once

#include <string>

#include "render/figure.h"

namespace batten::render {

/// `figure` as a tikzpicture, which a document with \usepackage{tikz} takes by \input, as large as on a page of 96
/// pixels an inch. Labels are set in the fonts of the document, their indices as formulas; what has no ground is left
/// white.
std::string tikz_text(const Figure& figure);

}  // namespace batten::render
