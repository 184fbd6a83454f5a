#include "app/editor/scene/kept_ink.h"

#include <algorithm>
#include <utility>

namespace batten::editor {

namespace {

double reach_px(const InkPlace& place) {
    return 0.5 * place.style.width_px + 1.0;
}

core::Box world_box(const render::Camera& camera, glm::dvec2 lower_px, glm::dvec2 upper_px) {
    core::Box box;
    box.include(core::Point(render::world_from_screen(camera, lower_px)));
    box.include(core::Point(render::world_from_screen(camera, upper_px)));
    return box;
}

}  // namespace

std::optional<core::Box> KeptInk::uncovered(const KeptInk* above) const {
    const Map now = above == nullptr ? nullptr : above->lasting_.map;
    if (now == above_) return core::Box();
    if (now == nullptr || above->lasting_.previous == nullptr || above->lasting_.previous != above_)
        return std::nullopt;
    return above->lasting_.region;
}

void KeptInk::follow(const core::StripChange& change, const InkPlace& place, const KeptInk* above,
                     const InkPainter& painter) {
    const bool is_unchanged = change.number == number_;
    const bool is_next = change.number == number_ + 1 && !change.is_all;
    const bool is_same_place = std::exchange(place_, place) == place;
    const std::optional<core::Box> seen_anew = uncovered(above);
    const bool goes_on = lasting_.map != nullptr && is_same_place && (is_unchanged || is_next) && seen_anew;
    if (goes_on && is_unchanged && seen_anew->is_empty()) return;
    number_ = change.number;
    if (!goes_on) {
        loose_.clear();
        paint_all(above, painter);
    } else {
        core::Box region = *seen_anew;
        Map source = lasting_.map;
        const auto& parts = change.parts;
        if (is_next &&
            (change.is_renumbered || !std::includes(loose_.begin(), loose_.end(), parts.begin(), parts.end()))) {
            region.include(change.before.lower);
            region.include(change.before.upper);
            source = whole_;
            loose_ = parts;
        }
        if (!region.is_empty()) paint_region(source, region, above, painter);
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
    lasting_ = {std::move(map), nullptr, {}};
}

void KeptInk::paint_region(const Map& source, const core::Box& region, const KeptInk* above,
                           const InkPainter& painter) {
    auto map = std::make_shared<render::CoverageMap>(*source);
    const glm::dvec2 reach(reach_px(place_));
    const auto box = render::PixelBox::between(render::screen_from_world(place_.camera, region.lower),
                                               render::screen_from_world(place_.camera, region.upper));
    const render::PixelRange cleared = map->clear({box.lower_px - reach, box.upper_px + reach});
    if (above != nullptr && above->lasting_.map != nullptr) map->hide_under(*above->lasting_.map);
    const glm::dvec2 lower(cleared.lower);
    const glm::dvec2 upper(cleared.upper);
    if (!cleared.is_empty()) painter.paint(*map, world_box(place_.camera, lower - reach, upper + reach), loose_);
    lasting_ = {std::move(map), lasting_.map, world_box(place_.camera, lower, upper)};
}

}  // namespace batten::editor
