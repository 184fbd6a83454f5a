#include "render/region_cover.h"

#include <algorithm>
#include <cmath>

namespace batten::render {

namespace {

constexpr int lines_of_row = 4;

// Where a loop crosses a line: to the right of it the winding number is larger by `step`.
struct Crossing {
    float x = 0.0F;
    int step = 0;
};

using LineCrossings = std::vector<std::vector<Crossing>>;

// Line k lies in the middle of the k-th quarter of a row.
double line_level(std::size_t line) {
    return (static_cast<double>(line) + 0.5) / lines_of_row;
}

// Half open, so that what crosses a line in a corner does so once.
void add_segment(LineCrossings& lines, glm::dvec2 a, glm::dvec2 b) {
    const int step = a.y < b.y ? 1 : -1;
    if (step < 0) std::swap(a, b);
    const auto line_after = [&](double y) {
        const double line = std::ceil(y * lines_of_row - 0.5);
        return static_cast<std::size_t>(std::clamp(line, 0.0, static_cast<double>(lines.size())));
    };
    for (std::size_t line = line_after(a.y); line < line_after(b.y); ++line) {
        const double share = (line_level(line) - a.y) / (b.y - a.y);
        lines[line].push_back({static_cast<float>(a.x + share * (b.x - a.x)), step});
    }
}

LineCrossings crossings_of(const RegionLoops& region, int height) {
    LineCrossings lines(static_cast<std::size_t>(std::max(height, 0)) * lines_of_row);
    for (const std::vector<glm::vec2>& loop : region.loops)
        for (std::size_t i = 0; i < loop.size(); ++i)
            add_segment(lines, glm::dvec2(loop[i]), glm::dvec2(loop[(i + 1) % loop.size()]));
    return lines;
}

// Coverage of one row, added up from its lines.
class Row {
  public:
    explicit Row(int width) : shares_(static_cast<std::size_t>(width)), values_(shares_.size()) {}

    void add(std::vector<Crossing>& crossings, FillRule rule) {
        std::sort(crossings.begin(), crossings.end(), [](Crossing a, Crossing b) { return a.x < b.x; });
        int winding = 0;
        for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
            winding += crossings[k].step;
            const bool is_inside = rule == FillRule::even_odd ? winding % 2 != 0 : winding != 0;
            if (is_inside) add_run(crossings[k].x, crossings[k + 1].x);
        }
    }

    void write(CoverageMap& map, int y) {
        if (!(first_ < end_)) return;
        for (std::size_t x = first_; x < end_; ++x)
            values_[x] = static_cast<std::uint8_t>(std::lround(255.0F * std::min(shares_[x] / lines_of_row, 1.0F)));
        map.cover_row(y, static_cast<int>(first_), std::span(values_).subspan(first_, end_ - first_));
        std::fill(shares_.begin() + static_cast<std::ptrdiff_t>(first_),
                  shares_.begin() + static_cast<std::ptrdiff_t>(end_), 0.0F);
        first_ = shares_.size();
        end_ = 0;
    }

  private:
    void add_run(float from, float to) {
        from = std::max(from, 0.0F);
        to = std::min(to, static_cast<float>(shares_.size()));
        if (!(from < to)) return;
        const auto first = static_cast<std::size_t>(from);
        const auto last = std::min(static_cast<std::size_t>(to), shares_.size() - 1);
        first_ = std::min(first_, first);
        end_ = std::max(end_, last + 1);
        if (first == last) {
            shares_[first] += to - from;
            return;
        }
        shares_[first] += static_cast<float>(first + 1) - from;
        for (std::size_t x = first + 1; x < last; ++x) shares_[x] += 1.0F;
        shares_[last] += to - static_cast<float>(last);
    }

    std::vector<float> shares_;
    std::vector<std::uint8_t> values_;
    std::size_t first_ = shares_.size();
    std::size_t end_ = 0;
};

}  // namespace

CoverageMap region_coverage(const RegionLoops& region, glm::ivec2 size_px) {
    CoverageMap map(size_px);
    const glm::ivec2 size = map.size_px();
    if (size.x == 0) return map;
    LineCrossings lines = crossings_of(region, size.y);
    Row row(size.x);
    for (int y = 0; y < size.y; ++y) {
        for (std::size_t k = 0; k < lines_of_row; ++k)
            row.add(lines[static_cast<std::size_t>(y) * lines_of_row + k], region.rule);
        row.write(map, y);
    }
    return map;
}

}  // namespace batten::render
