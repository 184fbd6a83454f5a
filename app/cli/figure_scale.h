/// Curves that are too large or too small for the numbers of a picture.
#pragma once

#include <string>

#include "app/editor/state/overlay.h"
#include "core/document/document.h"

namespace batten::cli {

/// The power of two by which lengths of `document` are multiplied to be drawn: 0 for what a camera can show, about
/// 1e-10 to 1e10, else the one by which its visible curves are about 1 large.
int drawn_exponent(const core::Document& document);

/// The document with all lengths multiplied by that power of two, which is exact but where coordinates become
/// subnormal.
core::Document drawn_document(const core::Document& document, int exponent);

/// Whether any of these overlays writes lengths beside what it draws.
bool has_lengths(const editor::Overlays& overlays);

}  // namespace batten::cli
