#include "app/editor/scene/label_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "render/clip.h"

namespace batten::editor {

namespace {

constexpr double column_px = 48.0;
constexpr double impossible = std::numeric_limits<double>::infinity();
constexpr double line_cost = 1.0;
constexpr double symbol_cost = 4.0;
constexpr double script_share = 0.2;  // of a line by which sub- and superscripts reach beyond it
constexpr double width_error = 0.1;   // of the width of a text that is not measured with its font

constexpr std::array all_sides{LabelSide::upper_right, LabelSide::upper_left, LabelSide::lower_right,
                               LabelSide::lower_left,  LabelSide::right,      LabelSide::left,
                               LabelSide::above,       LabelSide::below};

/// The direction from the point to the label: -1, 0 or 1 to the right and downwards.
glm::dvec2 direction_of(LabelSide side) {
    switch (side) {
        case LabelSide::upper_right:
            return {1.0, -1.0};
        case LabelSide::upper_left:
            return {-1.0, -1.0};
        case LabelSide::lower_right:
            return {1.0, 1.0};
        case LabelSide::lower_left:
            return {-1.0, 1.0};
        case LabelSide::right:
            return {1.0, 0.0};
        case LabelSide::left:
            return {-1.0, 0.0};
        case LabelSide::above:
            return {0.0, -1.0};
        case LabelSide::below:
            return {0.0, 1.0};
    }
    return {1.0, -1.0};
}

LabelPlace place_at(glm::dvec2 point, glm::dvec2 text_px, double offset_px, LabelSide side) {
    const glm::dvec2 direction = direction_of(side);
    const bool is_diagonal = direction.x != 0.0 && direction.y != 0.0;
    // Diagonal labels may come closer in height: there is room beside a round symbol.
    const double rise = is_diagonal ? 0.45 * offset_px : offset_px;
    LabelPlace place;
    place.position.x = point.x + direction.x * offset_px;
    place.position.y = point.y + direction.y * (rise + 0.5 * text_px.y);
    double left = place.position.x;
    if (direction.x < 0.0) {
        place.anchor = render::Anchor::right;
        left -= text_px.x;
    } else if (direction.x == 0.0) {
        place.anchor = render::Anchor::center;
        left -= 0.5 * text_px.x;
    }
    place.box.lower_px = {left, place.position.y - 0.5 * text_px.y};
    place.box.upper_px = place.box.lower_px + text_px;
    return place;
}

}  // namespace

LabelLayout::LabelLayout(glm::dvec2 size_px)
    : size_px_(size_px), columns_(static_cast<std::size_t>(std::clamp(size_px.x / column_px, 0.0, 1000.0)) + 1) {}

std::size_t LabelLayout::column(double x) const {
    return static_cast<std::size_t>(std::clamp(x / column_px, 0.0, static_cast<double>(columns_.size() - 1)));
}

void LabelLayout::add(const Obstacle& obstacle) {
    const auto [left, right] = std::minmax(obstacle.a.x, obstacle.b.x);
    for (std::size_t k = column(left); k <= column(right); ++k) columns_[k].push_back(obstacle);
}

void LabelLayout::avoid_line(std::span<const glm::dvec2> points) {
    const render::PixelBox picture{{}, size_px_};
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        if (const auto part = render::clip_segment(picture, points[i], points[i + 1])) {
            const glm::dvec2 leg = points[i + 1] - points[i];
            add({Kind::line, points[i] + part->first * leg, points[i] + part->last * leg});
        }
}

void LabelLayout::avoid_symbol(glm::dvec2 center, double radius_px) {
    const render::PixelBox picture{{}, size_px_};
    if (picture.contains(center)) add({Kind::symbol, center - glm::dvec2(radius_px), center + glm::dvec2(radius_px)});
}

void LabelLayout::avoid_box(const render::PixelBox& box) {
    add({Kind::box, box.lower_px, box.upper_px});
}

double LabelLayout::cost(const render::PixelBox& box, double limit) const {
    const render::PixelBox picture{{}, size_px_};
    const glm::dvec2 beyond = glm::dvec2(width_error, script_share) * (box.upper_px - box.lower_px);
    if (!picture.contains(box.lower_px - beyond) || !picture.contains(box.upper_px + beyond)) return impossible;
    double sum = 0.0;
    for (std::size_t k = column(box.lower_px.x); k <= column(box.upper_px.x); ++k)
        for (const Obstacle& obstacle : columns_[k]) {
            if (sum >= limit) return sum;
            if (obstacle.kind == Kind::line) {
                const glm::dvec2 lower{std::min(obstacle.a.x, obstacle.b.x), std::min(obstacle.a.y, obstacle.b.y)};
                const glm::dvec2 upper{std::max(obstacle.a.x, obstacle.b.x), std::max(obstacle.a.y, obstacle.b.y)};
                const bool is_near = box.lower_px.x <= upper.x && lower.x <= box.upper_px.x &&
                                     box.lower_px.y <= upper.y && lower.y <= box.upper_px.y;
                if (is_near && render::clip_segment(box, obstacle.a, obstacle.b)) sum += line_cost;
            } else if (box.overlaps({obstacle.a, obstacle.b})) {
                if (obstacle.kind == Kind::box) return impossible;
                sum += symbol_cost;
            }
        }
    return sum;
}

std::optional<LabelPlace> LabelLayout::place(glm::dvec2 point, glm::dvec2 text_px, double offset_px, LabelSide first,
                                             Crowding crowding) {
    std::optional<LabelPlace> best;
    double least = crowding == Crowding::leave_out ? symbol_cost : impossible;
    const auto consider = [&](LabelSide side) {
        if (least == 0.0) return;
        const LabelPlace candidate = place_at(point, text_px, offset_px, side);
        const double sum = cost(candidate.box, least);
        if (sum < least) {
            least = sum;
            best = candidate;
        }
    };
    consider(first);
    for (const LabelSide side : all_sides) consider(side);
    if (best) avoid_box(best->box);
    return best;
}

}  // namespace batten::editor
