/// Where the pictures in boxes over the canvas stand: below one another at its right edge, or beside the cards of a
/// projector, then in further columns.
#pragma once

#include <optional>
#include <vector>

#include "app/editor/state/state.h"
#include "render/pixel_box.h"

namespace batten::editor {

struct InsetPlace {
    Overlay overlay;
    render::PixelBox box;
};

/// The insets that are shown, smaller where that makes room for all; those for which the canvas has none are left out.
/// None without a visible curve.
std::vector<InsetPlace> inset_places(const EditorState& state);

/// The place of one of them; none where it is not shown.
std::optional<render::PixelBox> inset_box(const EditorState& state, Overlay overlay);

/// The box around all of them; none where there are none.
std::optional<render::PixelBox> insets_box(const EditorState& state);

/// The inset under a pixel of the canvas.
std::optional<InsetPlace> inset_at(const EditorState& state, glm::dvec2 place_px);

}  // namespace batten::editor
