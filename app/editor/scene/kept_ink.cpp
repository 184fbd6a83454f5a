#include "app/editor/scene/kept_ink.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

namespace batten::editor {

namespace {

// More than so many parts that change are painted with all the rest.
constexpr std::size_t most_loose = 1024;

double reach_px(const InkPlace& place) {
    return 0.5 * place.style.width_px + 1.0;
}

core::Box world_box(const render::Camera& camera, glm::dvec2 lower_px, glm::dvec2 upper_px) {
    core::Box box;
    box.include(core::Point(render::world_from_screen(camera, lower_px)));
    box.include(core::Point(render::world_from_screen(camera, upper_px)));
    return box;
}

/// By how many pixels the picture moves from one place to another; none where it is not the same picture, or moves by a
/// part of a pixel.
std::optional<glm::ivec2> shift_between(InkPlace from, const InkPlace& to) {
    const glm::dvec2 moved = render::screen_from_world(to.camera, from.camera.center) - 0.5 * to.camera.size_px;
    from.camera.center = to.camera.center;
    constexpr double rounding_px = 1e-6;
    const glm::dvec2 whole = glm::round(moved);
    const bool is_whole = glm::distance(moved, whole) <= rounding_px && glm::length(whole) < 1e6;
    if (!(from == to) || !is_whole) return std::nullopt;
    return glm::ivec2(whole);
}

/// What comes into a picture that moves.
std::vector<render::PixelRange> new_pixels(glm::ivec2 size, glm::ivec2 shift) {
    std::vector<render::PixelRange> bands;
    if (shift.x != 0)
        bands.push_back({{shift.x > 0 ? 0 : size.x + shift.x, 0}, {shift.x > 0 ? shift.x : size.x, size.y}});
    if (shift.y != 0)
        bands.push_back({{0, shift.y > 0 ? 0 : size.y + shift.y}, {size.x, shift.y > 0 ? shift.y : size.y}});
    return bands;
}

}  // namespace

std::optional<core::Box> KeptInk::uncovered(const KeptInk* above, glm::ivec2 shift) const {
    if (above == nullptr && above_ == nullptr) return core::Box();
    if (above == nullptr || above_ == nullptr) return std::nullopt;
    if (above->lasting_.map == above_ && shift == glm::ivec2(0)) return core::Box();
    if (above->lasting_.previous != above_ || above->lasting_.shift != shift) return std::nullopt;
    return above->lasting_.region;
}

void KeptInk::follow(const core::StripChange& change, const InkPlace& place, const KeptInk* above,
                     const InkPainter& painter) {
    const bool is_unchanged = change.number == number_;
    const bool is_next = change.number == number_ + 1 && !change.is_all && change.parts.size() <= most_loose;
    const auto shift = shift_between(std::exchange(place_, place), place);
    const auto seen_anew = shift ? uncovered(above, *shift) : std::nullopt;
    const bool goes_on = lasting_.map != nullptr && (is_unchanged || is_next) && seen_anew;
    number_ = change.number;
    if (!goes_on) {
        loose_.clear();
        paint_all(above, painter);
    } else {
        core::Box region = *seen_anew;
        Map source = lasting_.map;
        const auto& parts = change.parts;
        const bool is_loose = std::includes(loose_.begin(), loose_.end(), parts.begin(), parts.end());
        if (is_next && (change.is_renumbered || !is_loose)) {
            region.include(change.before.lower);
            region.include(change.before.upper);
            source = whole_;
            loose_ = parts;
        }
        const bool is_same = region.is_empty() && *shift == glm::ivec2(0);
        if (is_same && is_unchanged) return;
        if (!is_same) repaint(source, *shift, region, above, painter);
    }
    above_ = above == nullptr ? nullptr : above->lasting_.map;
    whole_ = lasting_.map;
    if (loose_.empty()) return;
    auto map = std::make_shared<render::CoverageMap>(*lasting_.map);
    for (const std::size_t part : loose_) painter.paint_part(*map, part);
    whole_ = std::move(map);
}

void KeptInk::paint_all(const KeptInk* above, const InkPainter& painter) {
    auto map = std::make_shared<render::CoverageMap>(place_.size_px);
    if (above != nullptr && above->lasting_.map != nullptr) map->hide_under(*above->lasting_.map);
    const glm::dvec2 reach(reach_px(place_));
    painter.paint(*map, world_box(place_.camera, -reach, glm::dvec2(place_.size_px) + reach), loose_);
    lasting_ = {std::move(map), nullptr, {}, {}};
}

void KeptInk::repaint(const Map& source, glm::ivec2 shift, const core::Box& region, const KeptInk* above,
                      const InkPainter& painter) {
    auto map = std::make_shared<render::CoverageMap>(source->shifted(shift));
    const glm::dvec2 reach(reach_px(place_));
    std::vector<render::PixelRange> ranges = new_pixels(place_.size_px, shift);
    core::Box cleared;
    if (!region.is_empty()) {
        const auto box = render::PixelBox::between(render::screen_from_world(place_.camera, region.lower),
                                                   render::screen_from_world(place_.camera, region.upper));
        ranges.push_back(map->clear({box.lower_px - reach, box.upper_px + reach}));
        cleared = world_box(place_.camera, glm::dvec2(ranges.back().lower), glm::dvec2(ranges.back().upper));
    }
    if (above != nullptr && above->lasting_.map != nullptr) map->hide_under(*above->lasting_.map);
    for (const render::PixelRange& range : ranges) {
        const core::Box view =
            world_box(place_.camera, glm::dvec2(range.lower) - reach, glm::dvec2(range.upper) + reach);
        if (!range.is_empty()) painter.paint(*map, view, loose_);
    }
    lasting_ = {std::move(map), lasting_.map, shift, cleared};
}

}  // namespace batten::editor
