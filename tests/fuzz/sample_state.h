/// The editor that targets begin with.
#pragma once

#include "app/editor/editor.h"

namespace batten::fuzz {

/// With a cubic over custom knots whose weights differ, a closed quadratic, and a locked line.
editor::Editor sample_editor();

/// Requires that every curve is one, and that the document is written and read again to the same text.
void require_sound(const core::Document& document);

}  // namespace batten::fuzz
