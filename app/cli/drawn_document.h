/// Curves that are too large, too small or too far away for the numbers of a picture.
#pragma once

#include "app/editor/state/overlay.h"
#include "core/document/document.h"

namespace batten::cli {

/// How a document comes to where it is drawn: all of it is moved, then lengths are multiplied by a power of two.
struct DrawnPlace {
    core::Vector offset{0.0, 0.0};
    int exponent = 0;
};

/// No change for what a camera can show. Visible curves more than 1e10 times as far from the origin as they are large
/// are moved to it, and those that are then not about 1e-10 to 1e10 large become about 1 large.
DrawnPlace drawn_place(const core::Document& document);

/// The document at that place, which is exact but where coordinates become subnormal and for what lies far from the
/// visible curves.
core::Document drawn_document(const core::Document& document, const DrawnPlace& place);

/// Whether any of these overlays writes lengths beside what it draws.
bool has_lengths(const editor::Overlays& overlays);

/// Whether any of these overlays writes coordinates.
bool has_coordinates(const editor::Overlays& overlays);

}  // namespace batten::cli
