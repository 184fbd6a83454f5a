#include "app/editor/state/shown_map.h"

#include <algorithm>

#include "core/base/number_text.h"
#include "core/base/sentence.h"

namespace batten::editor {

namespace {

// What is told of a kind of map.
struct MapFacts {
    double usual;
    double step;
    core::Interval range;
    const char* words;
};

const MapFacts& facts_of(ShownMapKind kind) {
    static constexpr std::array<MapFacts, all_shown_maps.size()> facts{{
        {30.0, 15.0, {-360.0, 360.0}, "Rotation by {amount}°"},
        {0.5, 0.25, {0.25, 4.0}, "Scaling by {amount}"},
        {1.5, 0.25, {0.25, 4.0}, "Stretching by {amount} along x and 1/{amount} along y"},
        {0.5, 0.25, {-4.0, 4.0}, "Shearing along x by {amount}"},
        {90.0, 15.0, {-360.0, 360.0}, "Mirroring in a line in the direction {amount}°"},
        {0.5, 0.125, {-0.875, 0.875}, "Projection that changes weights by up to {amount}"},
    }};
    return facts[static_cast<std::size_t>(kind)];
}

}  // namespace

double usual_amount(ShownMapKind kind) {
    return facts_of(kind).usual;
}

double amount_step(ShownMapKind kind) {
    return facts_of(kind).step;
}

core::Interval amounts_of(ShownMapKind kind) {
    return facts_of(kind).range;
}

core::PlaneMap map_over(const ShownMap& shown, const core::Box& box) {
    const core::Point middle = core::middle(box.lower, box.upper);
    const double amount = shown.amount;
    switch (shown.kind) {
        case ShownMapKind::rotate:
            return core::rotation(amount, middle);
        case ShownMapKind::scale:
            return core::scaling(amount, amount, middle);
        case ShownMapKind::stretch:
            return core::scaling(amount, 1.0 / amount, middle);
        case ShownMapKind::shear:
            return core::shearing(amount, 0.0, middle);
        case ShownMapKind::mirror:
            return core::reflection(amount, middle);
        case ShownMapKind::project:
            break;
    }
    // 1 - amount at the left side of the box, 1 + amount at the right one.
    const double half = 0.5 * std::max(box.size().x, box.size().y);
    core::PlaneMap map;
    map.pivot = middle;
    map.rows[2][0] = half > 0.0 ? amount / half : 0.0;
    return map;
}

std::string map_words(const ShownMap& shown) {
    return core::filled_as_needed(facts_of(shown.kind).words, {{"amount", core::shortest_text(shown.amount)}});
}

}  // namespace batten::editor
