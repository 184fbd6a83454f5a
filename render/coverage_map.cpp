#include "render/coverage_map.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/clip.h"

namespace batten::render {

namespace {

constexpr double piece_px = 8.0;      // what is looked at and painted, or left out, at a time
constexpr double longest_px = 1e12;   // of a segment whose places in the picture are known well enough
constexpr int most_dashes = 1 << 14;  // of one segment; more are a solid line
constexpr std::uint8_t full = 255;

}  // namespace

CoverageMap::CoverageMap(glm::ivec2 size_px)
    : size_(glm::max(size_px, glm::ivec2(0))),
      blocks_((size_ + glm::ivec2(block_px - 1)) / block_px),
      groups_((blocks_ + glm::ivec2(group_blocks - 1)) / group_blocks),
      values_(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y)),
      open_(static_cast<std::size_t>(blocks_.x) * static_cast<std::size_t>(blocks_.y)),
      open_blocks_(static_cast<std::size_t>(groups_.x) * static_cast<std::size_t>(groups_.y)),
      touched_{size_, {0, 0}} {
    for (int y = 0; y < blocks_.y; ++y)
        for (int x = 0; x < blocks_.x; ++x) open_[block_of(block_px * glm::ivec2(x, y))] = block_size({x, y});
    count_groups();
}

// How many pixels the block has, fewer at the picture's upper edges.
std::uint8_t CoverageMap::block_size(glm::ivec2 block) const {
    const glm::ivec2 extent = glm::min(size_ - block_px * block, glm::ivec2(block_px));
    return static_cast<std::uint8_t>(extent.x * extent.y);
}

// The pixels that the box touches, as far as they are in the picture, and perhaps one more at each upper edge.
PixelRange CoverageMap::pixels_of(const PixelBox& box) const {
    const auto inside = [](double place, int size) {
        return place > 0.0 ? static_cast<int>(std::min<double>(place, size)) : 0;
    };
    return {{inside(box.lower_px.x, size_.x), inside(box.lower_px.y, size_.y)},
            {inside(box.upper_px.x + 1.0, size_.x), inside(box.upper_px.y + 1.0, size_.y)}};
}

bool CoverageMap::is_full(const PixelBox& box) const {
    const PixelRange range = pixels_of(box);
    if (range.is_empty()) return true;
    const glm::ivec2 first = range.lower / block_px;
    const glm::ivec2 last = (range.upper - 1) / block_px;
    for (int y = first.y / group_blocks; y <= last.y / group_blocks; ++y)
        for (int x = first.x / group_blocks; x <= last.x / group_blocks; ++x) {
            const glm::ivec2 corner = group_blocks * glm::ivec2(x, y);
            if (open_blocks_[group_of(corner)] > 0 &&
                has_open_block(glm::max(first, corner), glm::min(last, corner + (group_blocks - 1))))
                return false;
        }
    return true;
}

bool CoverageMap::has_open_block(glm::ivec2 first, glm::ivec2 last) const {
    for (int y = first.y; y <= last.y; ++y) {
        const std::uint8_t* open = &open_[static_cast<std::size_t>(y) * static_cast<std::size_t>(blocks_.x)];
        for (int x = first.x; x <= last.x; ++x)
            if (open[x] != 0) return true;
    }
    return false;
}

bool CoverageMap::is_full_about(glm::dvec2 a, glm::dvec2 b, double reach_px) const {
    const double length = glm::distance(a, b);
    // What is outside of the picture needs no look.
    const glm::dvec2 margin(reach_px);
    const auto near = clip_segment({-margin, glm::dvec2(size_) + margin}, a, b);
    if (!near) return true;
    if (!(length < longest_px)) return false;
    const double step = std::max(piece_px, reach_px) / length;
    double from = near->first;
    do {
        const double to = from + step < near->last ? from + step : near->last;
        const PixelBox core = PixelBox::between(a + from * (b - a), a + to * (b - a));
        if (!is_full({core.lower_px - reach_px, core.upper_px + reach_px})) return false;
        from = to;
    } while (from < near->last);
    return true;
}

CoverageMap CoverageMap::shifted(glm::ivec2 by) const {
    if (by == glm::ivec2(0)) return *this;
    CoverageMap moved(size_);
    const PixelRange kept{glm::clamp(by, glm::ivec2(0), size_), glm::clamp(size_ + by, glm::ivec2(0), size_)};
    if (kept.is_empty()) return moved;
    for (int y = kept.lower.y; y < kept.upper.y; ++y) {
        const auto from = values_.begin() + static_cast<std::ptrdiff_t>(index_of(glm::ivec2(kept.lower.x, y) - by));
        std::copy_n(from, kept.upper.x - kept.lower.x, &moved.values_[index_of({kept.lower.x, y})]);
    }
    moved.touched_ = {glm::clamp(touched_.lower + by, glm::ivec2(0), size_),
                      glm::clamp(touched_.upper + by, glm::ivec2(0), size_)};
    moved.count_open();
    return moved;
}

void CoverageMap::count_open() {
    for (int y = 0; y < size_.y; ++y) {
        const std::uint8_t* value = &values_[index_of({0, y})];
        std::uint8_t* open = &open_[block_of({0, y})];
        for (int x = 0; x < size_.x; ++x)
            if (value[x] == full) --open[x / block_px];
    }
    count_groups();
}

void CoverageMap::count_groups() {
    std::fill(open_blocks_.begin(), open_blocks_.end(), std::uint8_t{0});
    for (int y = 0; y < blocks_.y; ++y)
        for (int x = 0; x < blocks_.x; ++x)
            if (open_[block_of(block_px * glm::ivec2(x, y))] > 0) ++open_blocks_[group_of({x, y})];
}

PixelRange CoverageMap::clear(const PixelBox& box) {
    const PixelRange pixels = pixels_of(box);
    if (pixels.is_empty()) return {};
    const PixelRange blocks{pixels.lower / block_px, (pixels.upper + (block_px - 1)) / block_px};
    const PixelRange cleared{block_px * blocks.lower, glm::min(block_px * blocks.upper, size_)};
    for (int y = cleared.lower.y; y < cleared.upper.y; ++y)
        std::fill(&values_[index_of({cleared.lower.x, y})], &values_[index_of({cleared.upper.x - 1, y})] + 1, 0);
    for (int y = blocks.lower.y; y < blocks.upper.y; ++y)
        for (int x = blocks.lower.x; x < blocks.upper.x; ++x)
            open_[block_of(block_px * glm::ivec2(x, y))] = block_size({x, y});
    count_groups();
    return cleared;
}

void CoverageMap::hide_under(const CoverageMap& above) {
    for (std::size_t block = 0; block < open_.size(); ++block)
        if (above.open_[block] == 0) open_[block] = 0;
    count_groups();
}

void CoverageMap::stroke(glm::dvec2 a, glm::dvec2 b, const InkStyle& style) {
    const double half_width = 0.5 * style.width_px;
    const double length = glm::distance(a, b);
    if (std::isnan(length)) return;
    const double period = style.dash_px + style.gap_px;
    const glm::dvec2 margin(half_width + 1.0);
    const auto seen = clip_segment({-margin, glm::dvec2(size_) + margin}, a, b);
    if (!seen) return;
    const glm::dvec2 first = a + seen->first * (b - a);
    const double seen_length = (seen->last - seen->first) * length;
    if (style.dash_px <= 0.0 || !(seen_length < most_dashes * period))
        return stroke_solid(first, a + seen->last * (b - a), half_width);
    // From what is seen on, so that a line that comes from far away goes on, too.
    const glm::dvec2 direction = length > 0.0 ? (b - a) / length : glm::dvec2(0.0);
    const double phase = std::fmod(seen->first * length, period);
    for (double dash = -phase; dash < seen_length; dash += period) {
        const double begin = std::max(dash, 0.0);
        const double end = std::min(dash + style.dash_px, seen_length);
        if (begin < end) stroke_solid(first + begin * direction, first + end * direction, half_width);
    }
}

void CoverageMap::stroke_solid(glm::dvec2 a, glm::dvec2 b, double half_width) {
    const double length = glm::distance(a, b);
    const Segment segment{a, length > 0.0 ? (b - a) / length : glm::dvec2(1.0, 0.0), length, half_width};
    const double reach = half_width + 0.5;
    double open_from = 0.0;  // where the pieces begin that are not covered yet
    double from = 0.0;
    do {
        const double to = std::min(from + piece_px, length);
        const PixelBox core = PixelBox::between(a + from * segment.direction, a + to * segment.direction);
        if (is_full({core.lower_px - reach, core.upper_px + reach})) {
            if (open_from < from) paint(segment, open_from, from);
            open_from = to;
        }
        from = to;
    } while (from < length);
    if (open_from < length || length == 0.0) paint(segment, open_from, length);
}

// The pixels about the segment's places `from` to `to`.
void CoverageMap::paint(const Segment& segment, double from, double to) {
    const glm::dvec2 begin = segment.a + from * segment.direction;
    const glm::dvec2 end = segment.a + to * segment.direction;
    const double reach = segment.half_width + 0.5;
    const PixelBox core = PixelBox::between(begin, end);
    const PixelRange range = pixels_of({core.lower_px - reach, core.upper_px + reach});
    if (range.is_empty()) return;
    touched_ = {glm::min(touched_.lower, range.lower), glm::max(touched_.upper, range.upper)};
    const double slope = segment.direction.x / segment.direction.y;
    const double across = reach / std::abs(segment.direction.y);
    for (int y = range.lower.y; y < range.upper.y; ++y) {
        // Where the strip about the line crosses the row of pixels.
        const double middle = begin.x + (y + 0.5 - begin.y) * slope;
        const double left = middle - across - 0.5;
        const double right = middle + across + 0.5;
        const int first =
            left > range.lower.x ? static_cast<int>(std::min<double>(left, range.upper.x)) : range.lower.x;
        const int last = right < range.upper.x ? static_cast<int>(std::max<double>(right + 1.0, 0.0)) : range.upper.x;
        paint_row(segment, y, first, std::min(last, range.upper.x));
    }
}

void CoverageMap::cover_row(int y, int first, std::span<const std::uint8_t> coverage) {
    if (coverage.empty()) return;
    const auto count = static_cast<int>(coverage.size());
    touched_ = {glm::min(touched_.lower, glm::ivec2(first, y)),
                glm::max(touched_.upper, glm::ivec2(first + count, y + 1))};
    std::uint8_t* value = &values_[index_of({0, y})];
    for (int k = 0; k < count; ++k) raise(value[first + k], {first + k, y}, coverage[static_cast<std::size_t>(k)]);
}

// Counts the pixel where it becomes covered.
void CoverageMap::raise(std::uint8_t& value, glm::ivec2 pixel, std::uint8_t painted) {
    if (painted <= value) return;
    value = painted;
    std::uint8_t& open = open_[block_of(pixel)];
    if (painted < full || open == 0) return;
    if (--open == 0) --open_blocks_[group_of(pixel / block_px)];
}

void CoverageMap::paint_row(const Segment& segment, int y, int first, int end) {
    const glm::dvec2 direction = segment.direction;
    const glm::dvec2 offset = glm::dvec2(first + 0.5, y + 0.5) - segment.a;
    double along = glm::dot(offset, direction);
    double across = offset.x * direction.y - offset.y * direction.x;
    std::uint8_t* value = &values_[index_of({0, y})];
    for (int x = first; x < end; ++x, along += direction.x, across += direction.y) {
        if (value[x] == full) continue;
        const double beyond = along < 0.0 ? -along : along - segment.length;
        const double distance = beyond > 0.0 ? std::sqrt(across * across + beyond * beyond) : std::abs(across);
        const double share = std::clamp(segment.half_width + 0.5 - distance, 0.0, 1.0);
        const auto painted = static_cast<std::uint8_t>(255.0 * share + 0.5);
        raise(value[x], {x, y}, painted);
    }
}

}  // namespace batten::render
