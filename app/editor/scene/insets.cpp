#include "app/editor/scene/insets.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "app/editor/cards/floating_cards.h"

namespace batten::editor {

namespace {

/// An overlay that has an inset, and its size in design pixels.
struct InsetSize {
    Overlay overlay;
    glm::dvec2 size;
};

constexpr std::array inset_sizes{InsetSize{Overlay::hodograph, {200.0, 150.0}},
                                 InsetSize{Overlay::second_hodograph, {200.0, 150.0}},
                                 InsetSize{Overlay::homogeneous, {320.0, 290.0}}};

constexpr double inset_margin = 14.0;
constexpr double gap = 8.0;
constexpr double inset_bottom = 28.0;  // leaves room for the numbers of the grid
constexpr double most_width = 0.45;    // of the canvas, for one inset
constexpr double most_height = 0.75;
constexpr double most_share = 0.6;  // of the width beside cards; the first inset is always shown

/// Tried one after the other until all insets have room.
constexpr std::array shrinkings{1.0, 0.85, 0.7, 0.6};

/// Smaller in a small canvas.
glm::dvec2 fitting(glm::dvec2 size, glm::dvec2 picture) {
    return size * std::min({1.0, most_width * picture.x / size.x, most_height * picture.y / size.y});
}

/// Those that have room when all are made smaller by `shrinking`.
std::vector<InsetPlace> shrunk_places(const EditorState& state, double shrinking) {
    std::vector<InsetPlace> places;
    const double scale = state.view.interface_scale;
    glm::dvec2 picture = state.view.camera.size_px / scale;
    if (const auto cards = floating_cards_box(state)) picture.x = cards->lower_px.x / scale;
    glm::dvec2 corner{picture.x - inset_margin, inset_margin};  // the upper right one of the next inset
    double column_width = 0.0;
    for (const auto& [overlay, wanted] : inset_sizes) {
        if (!state.view.overlays.is_shown(overlay)) continue;
        const glm::dvec2 size = shrinking * fitting(wanted, picture);
        if (column_width > 0.0 && corner.y + size.y > picture.y - inset_bottom) {
            corner = {corner.x - column_width - gap, inset_margin};
            column_width = 0.0;
        }
        const double left = corner.x - size.x;
        if (!places.empty() && left < (1.0 - most_share) * picture.x) continue;
        places.push_back({overlay, {scale * glm::dvec2(left, corner.y), scale * (corner + glm::dvec2(0.0, size.y))}});
        column_width = std::max(column_width, size.x);
        corner.y += size.y + gap;
    }
    return places;
}

}  // namespace

std::vector<InsetPlace> inset_places(const EditorState& state) {
    if (state.visible_active_curve() == nullptr) return {};
    const auto count = std::count_if(inset_sizes.begin(), inset_sizes.end(), [&](const InsetSize& inset) {
        return state.view.overlays.is_shown(inset.overlay);
    });
    std::vector<InsetPlace> places;
    for (const double shrinking : shrinkings) {
        places = shrunk_places(state, shrinking);
        if (std::ssize(places) == count) break;
    }
    return places;
}

std::optional<render::PixelBox> inset_box(const EditorState& state, Overlay overlay) {
    for (const InsetPlace& place : inset_places(state))
        if (place.overlay == overlay) return place.box;
    return std::nullopt;
}

std::optional<render::PixelBox> insets_box(const EditorState& state) {
    std::optional<render::PixelBox> box;
    for (const InsetPlace& place : inset_places(state))
        box = box ? render::PixelBox{glm::min(box->lower_px, place.box.lower_px),
                                     glm::max(box->upper_px, place.box.upper_px)}
                  : place.box;
    return box;
}

std::optional<InsetPlace> inset_at(const EditorState& state, glm::dvec2 place_px) {
    for (const InsetPlace& place : inset_places(state))
        if (place.box.contains(place_px)) return place;
    return std::nullopt;
}

}  // namespace batten::editor
