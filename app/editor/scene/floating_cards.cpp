#include "app/editor/scene/floating_cards.h"

#include <algorithm>

#include "app/editor/cards/cards.h"

namespace batten::editor {

namespace {

constexpr double edge_margin = 14.0;  // design pixels

}  // namespace

std::optional<render::PixelBox> floating_cards_box(const EditorState& state) {
    const View& view = state.view;
    if (!view.is_presenting || shown_cards(state).empty()) return std::nullopt;
    const glm::dvec2 picture = view.camera.size_px;
    const double width = std::min(view.cards_width * view.interface_scale, 0.5 * picture.x);
    return render::PixelBox{{picture.x - width - edge_margin * view.interface_scale, 0.0}, picture};
}

}  // namespace batten::editor
