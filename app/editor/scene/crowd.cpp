#include "app/editor/scene/crowd.h"

#include <algorithm>
#include <cmath>

namespace batten::editor {

namespace {

constexpr double mark_gap = 2.0;               // between marks
constexpr std::size_t accepted_meetings = 12;  // in a small curve points may meet
constexpr std::size_t accepted_share = 4;      // one in so many places

/// Squares that lie still in the world while the view moves.
class CellGrid {
  public:
    CellGrid(const CanvasFrame& frame, double cell_px) : cell_px_(cell_px) {
        // Where a corner of the world's squares is in the picture, at or before the picture's reach.
        const render::PixelBox& reach = frame.pen.reach();
        const glm::dvec2 zero = frame.screen({0.0, 0.0});
        const auto start = [&](double lower, double at_zero) {
            const double squares = std::floor((lower - at_zero) / cell_px);
            const double corner = at_zero + squares * cell_px;
            return std::isfinite(corner) && std::abs(corner - lower) <= cell_px ? corner : lower;
        };
        start_ = {start(reach.lower_px.x, zero.x), start(reach.lower_px.y, zero.y)};
        column_count_ = static_cast<std::size_t>((reach.upper_px.x - start_.x) / cell_px) + 1;
        const std::size_t row_count = static_cast<std::size_t>((reach.upper_px.y - start_.y) / cell_px) + 1;
        taken_.resize(column_count_ * row_count);
    }

    /// Takes the square of a place in the picture's reach, if nobody did before.
    bool take(glm::dvec2 place) {
        const auto column = static_cast<std::size_t>(std::max(0.0, (place.x - start_.x) / cell_px_));
        const auto row = static_cast<std::size_t>(std::max(0.0, (place.y - start_.y) / cell_px_));
        const std::size_t square = row * column_count_ + column;
        if (taken_[square]) return false;
        taken_[square] = true;
        return true;
    }

  private:
    double cell_px_;
    glm::dvec2 start_{};
    std::size_t column_count_ = 0;
    std::vector<bool> taken_;
};

std::vector<MarkPlace> one_for_each_cell(const CanvasFrame& frame, const std::vector<MarkPlace>& places,
                                         double cell_px) {
    CellGrid grid(frame, cell_px);
    std::vector<MarkPlace> kept;
    for (const MarkPlace& place : places)
        if (grid.take(place.place)) kept.push_back(place);
    return kept;
}

}  // namespace

std::vector<bool> is_among(std::span<const MarkPlace> places, std::size_t count) {
    std::vector<bool> is_there(count);
    for (const MarkPlace& place : places) is_there[place.index] = true;
    return is_there;
}

Crowd settle(const CanvasFrame& frame, std::vector<MarkPlace> places, const MarkSizes& sizes) {
    const double largest = sizes.radii.front();
    const double smallest = sizes.radii.back();
    if (places.size() <= accepted_meetings && !sizes.is_thinned) return {largest, false, false, std::move(places)};
    for (const double radius : sizes.radii) {
        if (places.size() > sizes.most || sizes.is_thinned) break;
        const double cell = frame.pen.px(2.0 * radius + mark_gap);
        const std::size_t hidden = places.size() - one_for_each_cell(frame, places, cell).size();
        if (hidden <= accepted_meetings || hidden <= places.size() / accepted_share)
            return {radius, radius != largest, false, std::move(places)};
    }
    double cell = frame.pen.px(2.0 * smallest + sizes.gap_when_thinned);
    std::vector<MarkPlace> kept = one_for_each_cell(frame, places, cell);
    // One mark is left where the picture has no room for any.
    for (; kept.size() > 1 && 2 * kept.size() > sizes.most; cell *= 1.25)
        kept = one_for_each_cell(frame, places, 1.25 * cell);
    return {smallest, true, true, std::move(kept)};
}

}  // namespace batten::editor
