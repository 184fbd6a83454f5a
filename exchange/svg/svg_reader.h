/// Reads curves from SVG: paths and basic shapes, where they are drawn.
#pragma once

#include "exchange/report.h"

namespace batten::exchange {

/// More curves than these are left out, with a sentence.
inline constexpr std::size_t most_svg_curves = 100'000;

/// Elements that are nested deeper are left out, also where they are used (`use`).
inline constexpr std::size_t most_svg_depth = 256;

/// Files with more elements and attributes are refused.
inline constexpr std::size_t most_svg_elements = 4'000'000;

/// So many elements are visited at most, also where `use` repeats them; the others are left out.
inline constexpr std::size_t most_svg_visits = 500'000;

/// Bytes of attributes, and elements, that are looked at beyond those of the file, since `use` repeats them; what then
/// follows is left out.
inline constexpr std::size_t most_svg_repeated_bytes = std::size_t{64} << 20U;

/// The paths, rects, circles, ellipses, lines, polylines and polygons that are drawn, with all transforms, also those
/// that `use` repeats; each subpath is a curve. Lines, Bézier pieces and arcs are exact; the degree is that of the
/// highest piece, and closed subpaths are periodic. Coordinates are those of the viewBox, but y goes up from its lower
/// edge (files of ours say from where); lengths have the unit of the width. Colors are those of strokes, else of fills;
/// names those of labels, titles, ids. Layers of Inkscape become groups where there are several; what is locked is
/// locked. Our own document in the file is what is read, where the file still draws just its curves on the same page;
/// names, colors, layers, locks and what is hidden may have changed. Nothing outside the text is read and no entity
/// expanded. Errors: no XML, with its line; compressed; no SVG; too many elements; nothing that is drawn, and why.
[[nodiscard]] core::FileResult<Imported> read_svg(std::string_view text);

}  // namespace batten::exchange
