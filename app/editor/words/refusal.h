/// Refusals of the core as people read them: their lengths in the unit of the document.
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "app/editor/words/length.h"
#include "core/base/curve_error.h"

namespace batten::editor {

struct EditorState;

/// The sentence about `error`: that of core::describe where its numbers are none of the world's, as where there is no
/// unit, and in the document's unit where they are lengths.
std::string refusal_words(const Units& units, const core::CurveError& error);

/// What a command returns that the core refuses, in the unit of the committed document, or in `units`: none where the
/// numbers are not the world's but parameters or pixels of a picture.
tl::unexpected<std::string> refused(const EditorState& state, const core::CurveError& error);
tl::unexpected<std::string> refused(const Units& units, const core::CurveError& error);

}  // namespace batten::editor
