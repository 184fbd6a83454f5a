#include "app/editor/cards/floating_cards.h"

#include <algorithm>

#include "app/editor/cards/cards.h"

namespace batten::editor {

namespace {

constexpr double distance_from_edge = 14.0;  // design pixels
constexpr double largest_width = 0.5;        // of the canvas

}  // namespace

std::optional<render::PixelBox> floating_cards_box(const EditorState& state) {
    const View& view = state.view;
    if (!view.is_presenting || !view.parts.window || shown_cards(state).empty()) return std::nullopt;
    const glm::dvec2 canvas = view.camera.size_px;
    const double margin = distance_from_edge * view.interface_scale;
    const double width = std::min(view.cards_width * view.interface_scale, largest_width * canvas.x);
    const double right = canvas.x - margin;
    return render::PixelBox{{right - width, margin}, {right, std::max(canvas.y - margin, margin)}};
}

}  // namespace batten::editor
