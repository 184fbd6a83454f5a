#include "app/editor/scene/label_layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "render/clip.h"

namespace batten::editor {

namespace {

constexpr double column_px = 48.0;
constexpr double row_px = 16.0;        // labels are wide and low
constexpr double most_cells = 1000.0;  // across
constexpr double impossible = std::numeric_limits<double>::infinity();
constexpr double line_cost = 1.0;
constexpr double symbol_cost = 4.0;
constexpr double faint_line_cost = 0.5;
constexpr double most_faint_cost = 2.0;
constexpr double script_reach = 0.2;  // of a line by which sub- and superscripts reach beyond it
constexpr double gap_share = 0.25;    // of a line, beside a label
constexpr double width_error = 0.1;   // of the width of a text that is not measured with its font

constexpr std::array all_sides{LabelSide::upper_right, LabelSide::upper_left, LabelSide::lower_right,
                               LabelSide::lower_left,  LabelSide::right,      LabelSide::left,
                               LabelSide::above,       LabelSide::below};

/// The direction from the point to the label: -1, 0 or 1 to the right and downwards.
glm::dvec2 direction_to(LabelSide side) {
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

std::size_t cells_across(double length_px, double cell_px) {
    return static_cast<std::size_t>(std::clamp(length_px / cell_px, 0.0, most_cells)) + 1;
}

/// Which of `count` cells a coordinate is in; the first or last one outside of the picture.
std::size_t cell_at(double coordinate, double cell_px, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(coordinate / cell_px, 0.0, static_cast<double>(count - 1)));
}

/// What a text with subscripts covers.
render::PixelBox with_subscripts(const render::PixelBox& box) {
    return {box.lower_px, box.upper_px + glm::dvec2(0.0, script_reach * (box.upper_px.y - box.lower_px.y))};
}

/// A place that costs as much or more is none.
double cost_limit(Crowding crowding) {
    switch (crowding) {
        case Crowding::cover_nothing:
            return faint_line_cost;
        case Crowding::leave_out:
            return symbol_cost;
        case Crowding::cover_symbols:
            break;
    }
    return impossible;
}

double distance_to(const render::PixelBox& box, glm::dvec2 point) {
    return glm::distance(point, glm::clamp(point, box.lower_px, box.upper_px));
}

/// The legs from one point that pass near all points since.
class LegsFrom {
  public:
    explicit LegsFrom(glm::dvec2 start) : start_(start) {}

    /// Whether the leg to `point` is such a one; `point` is one of them then.
    bool reaches(glm::dvec2 point) {
        const glm::dvec2 way = point - start_;
        const double distance = glm::length(way);
        if (distance < reach_ || (is_bounded_ && (cross(first_, way) < 0.0 || cross(way, last_) < 0.0))) return false;
        reach_ = distance;
        if (distance > nearness_px) narrow_to(way, distance);
        return true;
    }

  private:
    static constexpr double nearness_px = 0.25;

    static double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

    void narrow_to(glm::dvec2 way, double distance) {
        const double sine = nearness_px / distance;
        const double cosine = std::sqrt(1.0 - sine * sine);
        const glm::dvec2 aside = sine * glm::dvec2(-way.y, way.x);
        const glm::dvec2 first = cosine * way - aside;
        const glm::dvec2 last = cosine * way + aside;
        if (!is_bounded_ || cross(first_, first) > 0.0) first_ = first;
        if (!is_bounded_ || cross(last, last_) > 0.0) last_ = last;
        is_bounded_ = true;
    }

    glm::dvec2 start_;
    double reach_ = 0.0;
    bool is_bounded_ = false;
    glm::dvec2 first_{};  ///< the directions between which they run
    glm::dvec2 last_{};
};

/// The last of the points behind `first` to which one leg stands for the line, so that a line costs the same however
/// finely it is drawn.
std::size_t end_of_leg(std::span<const glm::dvec2> points, std::size_t first) {
    LegsFrom legs(points[first]);
    std::size_t end = first + 1;
    legs.reaches(points[end]);
    while (end + 1 < points.size() && legs.reaches(points[end + 1])) ++end;
    return end;
}

LabelPlace place_at(glm::dvec2 point, glm::dvec2 text_px, double offset_px, LabelSide side) {
    const glm::dvec2 direction = direction_to(side);
    const bool is_diagonal = direction.x != 0.0 && direction.y != 0.0;
    // Diagonal labels may come closer in height: there is room beside a round symbol.
    const double rise = is_diagonal ? 0.45 * offset_px : offset_px;
    LabelPlace place;
    place.side = side;
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
    : size_px_(size_px),
      column_count_(cells_across(size_px.x, column_px)),
      row_count_(cells_across(size_px.y, row_px)),
      cells_(column_count_ * row_count_) {}

LabelLayout::Cells LabelLayout::columns(double left, double right) const {
    return {cell_at(left, column_px, column_count_), cell_at(right, column_px, column_count_)};
}

LabelLayout::Cells LabelLayout::rows(double top, double bottom) const {
    return {cell_at(top, row_px, row_count_), cell_at(bottom, row_px, row_count_)};
}

/// Into the cells that the line passes, not all those of its box.
void LabelLayout::add_line(Kind kind, glm::dvec2 a, glm::dvec2 b) {
    if (a.x > b.x) std::swap(a, b);
    const Cells across = columns(a.x, b.x);
    const double rise = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0.0;
    for (std::size_t k = across.first; k <= across.last; ++k) {
        const double left = static_cast<double>(k) * column_px;
        const double y_in = k == across.first ? a.y : a.y + rise * (left - a.x);
        const double y_out = k == across.last ? b.y : a.y + rise * (left + column_px - a.x);
        const auto [top, bottom] = std::minmax(y_in, y_out);
        // A pixel more, since where the line enters a column is rounded.
        const Cells down = rows(top - 1.0, bottom + 1.0);
        for (std::size_t r = down.first; r <= down.last; ++r) cell(k, r).push_back({kind, a, b, down.first});
    }
}

void LabelLayout::add_block(Kind kind, const render::PixelBox& box) {
    const Cells across = columns(box.lower_px.x, box.upper_px.x);
    const Cells down = rows(box.lower_px.y, box.upper_px.y);
    for (std::size_t k = across.first; k <= across.last; ++k)
        for (std::size_t r = down.first; r <= down.last; ++r)
            cell(k, r).push_back({kind, box.lower_px, box.upper_px, down.first});
}

void LabelLayout::add_lines(Kind kind, std::span<const glm::dvec2> points) {
    const render::PixelBox picture{{}, size_px_};
    for (std::size_t i = 0; i + 1 < points.size();) {
        const std::size_t end = end_of_leg(points, i);
        if (const auto part = render::clip_segment(picture, points[i], points[end])) {
            const glm::dvec2 leg = points[end] - points[i];
            add_line(kind, points[i] + part->first * leg, points[i] + part->last * leg);
        }
        i = end;
    }
}

void LabelLayout::avoid_line(std::span<const glm::dvec2> points) {
    add_lines(Kind::line, points);
}

void LabelLayout::avoid_faint_line(std::span<const glm::dvec2> points) {
    add_lines(Kind::faint_line, points);
}

void LabelLayout::avoid_ink(std::span<const render::CoverageMap* const> maps) {
    if (maps.empty()) return;
    constexpr int rows_px = 8;
    const glm::ivec2 size = maps.front()->size_px();
    const auto is_inked = [&](int x, int y) {
        return std::any_of(maps.begin(), maps.end(), [&](const auto* map) { return map->coverage({x, y}) > 0; });
    };
    for (int y = rows_px / 2; y < size.y; y += rows_px)
        for (int x = 0; x < size.x; ++x) {
            const int first = x;
            while (x < size.x && is_inked(x, y)) ++x;
            if (x > first) add_line(Kind::line, {first, y}, {x, y});
        }
}

void LabelLayout::avoid_symbol(glm::dvec2 center, double radius_px) {
    const render::PixelBox picture{{}, size_px_};
    if (picture.contains(center))
        add_block(Kind::symbol, {center - glm::dvec2(radius_px), center + glm::dvec2(radius_px)});
}

void LabelLayout::avoid_box(const render::PixelBox& box) {
    add_block(Kind::box, box);
}

double LabelLayout::cost_of(const Obstacle& obstacle, const render::PixelBox& box) {
    if (obstacle.kind == Kind::line || obstacle.kind == Kind::faint_line) {
        const render::PixelBox whole = with_subscripts(box);
        const auto [top, bottom] = std::minmax(obstacle.a.y, obstacle.b.y);
        const bool is_near = whole.lower_px.x <= obstacle.b.x && obstacle.a.x <= whole.upper_px.x &&
                             whole.lower_px.y <= bottom && top <= whole.upper_px.y;
        if (!is_near || !render::clip_segment(whole, obstacle.a, obstacle.b)) return 0.0;
        return obstacle.kind == Kind::line ? line_cost : faint_line_cost;
    }
    if (!box.overlaps({obstacle.a, obstacle.b})) return 0.0;
    return obstacle.kind == Kind::box ? impossible : symbol_cost;
}

double LabelLayout::cost(const render::PixelBox& box, double limit) {
    const render::PixelBox picture{{}, size_px_};
    const glm::dvec2 beyond = glm::dvec2(width_error, script_reach) * (box.upper_px - box.lower_px);
    if (!picture.contains(box.lower_px - beyond) || !picture.contains(box.upper_px + beyond)) return impossible;
    const Cells across = columns(box.lower_px.x, box.upper_px.x);
    const Cells down = rows(box.lower_px.y, with_subscripts(box).upper_px.y);
    double sum = 0.0;
    double faint = 0.0;
    const auto total = [&] { return sum + std::min(faint, most_faint_cost); };
    for (std::size_t k = across.first; k <= across.last; ++k)
        for (std::size_t r = down.first; r <= down.last; ++r)
            for (const Obstacle& obstacle : cells_[k * row_count_ + r]) {
                if (total() >= limit) return total();
                ++look_count_;
                // What is in several of the rows counts once for each column.
                if (r != std::max(obstacle.first_row, down.first)) continue;
                (obstacle.kind == Kind::faint_line ? faint : sum) += cost_of(obstacle, box);
            }
    return total();
}

bool LabelLayout::belongs_to(const render::PixelBox& box, glm::dvec2 point) const {
    if (std::ranges::find(named_, point) == named_.end()) return true;
    const double own = distance_to(box, point);
    const double one_mark = 0.5 * (box.upper_px.y - box.lower_px.y);
    return std::ranges::all_of(named_, [&](glm::dvec2 other) {
        return glm::distance(other, point) < one_mark || distance_to(box, other) > own;
    });
}

std::optional<LabelPlace> LabelLayout::best_of(std::span<const LabelSide> sides, glm::dvec2 point, glm::dvec2 text_px,
                                               double offset_px, Crowding crowding) {
    std::optional<LabelPlace> best;
    double least = cost_limit(crowding);
    for (const LabelSide side : sides) {
        if (least == 0.0) break;
        const LabelPlace candidate = place_at(point, text_px, offset_px, side);
        const double sum = cost(candidate.box, least);
        if (sum < least && belongs_to(candidate.box, point)) {
            least = sum;
            best = candidate;
        }
    }
    if (best) {
        const glm::dvec2 gap(gap_share * text_px.y, 0.0);
        avoid_box({best->box.lower_px - gap, best->box.upper_px + gap});
    }
    return best;
}

std::optional<LabelPlace> LabelLayout::place(glm::dvec2 point, glm::dvec2 text_px, double offset_px, LabelSide first,
                                             Crowding crowding) {
    std::array<LabelSide, all_sides.size() + 1> sides{first};
    std::ranges::copy(all_sides, sides.begin() + 1);
    return best_of(sides, point, text_px, offset_px, crowding);
}

std::optional<LabelPlace> LabelLayout::place_on(LabelSide side, glm::dvec2 point, glm::dvec2 text_px, double offset_px,
                                                Crowding crowding) {
    return best_of(std::array{side}, point, text_px, offset_px, crowding);
}

}  // namespace batten::editor
