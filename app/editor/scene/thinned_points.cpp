#include "app/editor/scene/thinned_points.h"

#include <bit>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <unordered_map>

namespace batten::editor {

namespace {

constexpr int reach_in_cells = 2;  // cells are half a gap wide: all in one are nearer to each other than a gap

/// The first point stays longest; of others the one whose index is divided by the higher power of two, then the one
/// that comes first.
bool lasts_longer(std::size_t a, std::size_t b) {
    if (a == 0 || b == 0) return a == 0 && b != 0;
    const int zeros_of_a = std::countr_zero(a);
    const int zeros_of_b = std::countr_zero(b);
    return zeros_of_a != zeros_of_b ? zeros_of_a > zeros_of_b : a < b;
}

/// The place that lasts longest of each cell.
class LastingPlaces {
  public:
    LastingPlaces(const std::vector<MarkPlace>& places, double gap_px, glm::dvec2 origin_px)
        : gap_px_(gap_px), origin_px_(origin_px) {
        for (const MarkPlace& place : places) {
            const auto [cell, is_first] = best_.try_emplace(key(cell_of(place.place)), place);
            if (!is_first && lasts_longer(place.index, cell->second.index)) cell->second = place;
        }
    }

    bool keeps(const MarkPlace& place) const {
        const glm::dvec2 cell = cell_of(place.place);
        if (best_.at(key(cell)).index != place.index) return false;
        for (int x = -reach_in_cells; x <= reach_in_cells; ++x)
            for (int y = -reach_in_cells; y <= reach_in_cells; ++y) {
                const auto other = best_.find(key(cell + glm::dvec2(x, y)));
                if (other != best_.end() && hides(other->second, place)) return false;
            }
        return true;
    }

  private:
    struct Hash {
        std::size_t operator()(const std::pair<double, double>& cell) const {
            return std::hash<double>()(cell.first) * 31 + std::hash<double>()(cell.second);
        }
    };

    bool hides(const MarkPlace& other, const MarkPlace& place) const {
        return lasts_longer(other.index, place.index) && glm::distance(other.place, place.place) < gap_px_;
    }
    glm::dvec2 cell_of(glm::dvec2 place) const { return glm::floor(2.0 * (place - origin_px_) / gap_px_); }
    static std::pair<double, double> key(glm::dvec2 cell) { return {cell.x, cell.y}; }

    double gap_px_;
    glm::dvec2 origin_px_;
    std::unordered_map<std::pair<double, double>, MarkPlace, Hash> best_;
};

}  // namespace

std::size_t lasting_index(std::size_t first, std::size_t count) {
    std::size_t index = first;
    const std::size_t end = first + count;
    while (index != 0) {
        const std::size_t next = index + (index & (~index + 1));
        if (next >= end || next < index) break;
        index = next;
    }
    return index;
}

std::vector<MarkPlace> thinned(const std::vector<MarkPlace>& places, double gap_px, glm::dvec2 origin_px) {
    const LastingPlaces lasting(places, gap_px, origin_px);
    std::vector<MarkPlace> kept;
    for (const MarkPlace& place : places)
        if (lasting.keeps(place)) kept.push_back(place);
    return kept;
}

std::span<const std::size_t> picked_points(const Selection& selection) {
    constexpr std::size_t most_picked = 200;
    if (selection.points.size() > most_picked) return {};
    return selection.points;
}

}  // namespace batten::editor
