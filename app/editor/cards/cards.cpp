#include "app/editor/cards/cards.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace batten::editor {

namespace {

constexpr std::array<CardSource, 0> sources{};

}  // namespace

std::span<const CardSource> card_sources() {
    return sources;
}

std::vector<CardSource> shown_cards(const EditorState& state) {
    std::vector<CardSource> shown;
    std::copy_if(sources.begin(), sources.end(), std::back_inserter(shown),
                 [&](const CardSource& source) { return state.view.overlays.is_shown(source.overlay); });
    return shown;
}

}  // namespace batten::editor
