/// How much of each pixel of a picture is covered: for lines so long and dense that most of them lies under the rest.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "render/pixel_box.h"

namespace batten::render {

/// A rectangle of whole pixels, from `lower` to before `upper`.
struct PixelRange {
    glm::ivec2 lower{};
    glm::ivec2 upper{};

    [[nodiscard]] bool is_empty() const { return lower.x >= upper.x || lower.y >= upper.y; }
};

/// How the segments of a line are covered with ink, in pixels.
struct InkStyle {
    double width_px = 1.0;  ///< > 0
    double dash_px = 0.0;   ///< 0 for a solid line
    double gap_px = 0.0;

    bool operator==(const InkStyle&) const = default;
};

/// A picture of one byte for each pixel, 255 where it is covered. What is painted last does not lie over the rest: each
/// pixel keeps its largest coverage. It knows where all is covered, so that what would not be seen can be left out.
class CoverageMap {
  public:
    explicit CoverageMap(glm::ivec2 size_px);

    [[nodiscard]] glm::ivec2 size_px() const { return size_; }

    /// 0 to 255, for a pixel in the picture.
    [[nodiscard]] std::uint8_t coverage(glm::ivec2 pixel) const { return values_[index_of(pixel)]; }

    /// Row by row from the top.
    [[nodiscard]] std::span<const std::uint8_t> values() const { return values_; }

    /// All pixels of more than no coverage are in it.
    [[nodiscard]] PixelRange touched() const { return touched_; }

    /// The segment from a to b with round ends, its dashes beginning at a. Cost: the pixels
    /// that are not covered yet, and an eighth of those that are.
    void stroke(glm::dvec2 a, glm::dvec2 b, const InkStyle& style);

    /// At least that coverage in row `y` of the picture from pixel `first` on.
    void cover_row(int y, int first, std::span<const std::uint8_t> coverage);

    /// Whether all of the box that is in the picture is known to be covered or hidden; may fail to know within 7 px of
    /// what is not. Cost: the box in blocks of 64 x 64, near its edges of 8 x 8; less where it is not so.
    [[nodiscard]] bool is_full(const PixelBox& box) const;

    /// The same for all within `reach_px` of the segment from a to b.
    [[nodiscard]] bool is_full_about(glm::dvec2 a, glm::dvec2 b, double reach_px) const;

    /// The same moved to the right and downwards, with nothing in what comes into the picture, and nothing hidden.
    [[nodiscard]] CoverageMap shifted(glm::ivec2 by) const;

    /// Clears blocks of 8 x 8 pixels so that all of the box is as at first, but for what hid it. Returns their pixels.
    PixelRange clear(const PixelBox& box);

    /// Counts what `above`, of the same size, covers as covered, without painting it: this will be painted first.
    void hide_under(const CoverageMap& above);

  private:
    struct Segment {
        glm::dvec2 a{};
        glm::dvec2 direction{};
        double length = 0.0;
        double half_width = 0.5;
    };

    [[nodiscard]] std::size_t index_of(glm::ivec2 pixel) const {
        return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size_.x) +
               static_cast<std::size_t>(pixel.x);
    }
    [[nodiscard]] std::size_t block_of(glm::ivec2 pixel) const {
        return static_cast<std::size_t>(pixel.y / block_px) * static_cast<std::size_t>(blocks_.x) +
               static_cast<std::size_t>(pixel.x / block_px);
    }
    [[nodiscard]] PixelRange pixels_of(const PixelBox& box) const;
    [[nodiscard]] std::size_t group_of(glm::ivec2 block) const {
        return static_cast<std::size_t>(block.y / group_blocks) * static_cast<std::size_t>(groups_.x) +
               static_cast<std::size_t>(block.x / group_blocks);
    }
    [[nodiscard]] bool has_open_block(glm::ivec2 first, glm::ivec2 last) const;
    void count_open();
    void count_groups();
    [[nodiscard]] std::uint8_t block_size(glm::ivec2 block) const;
    void stroke_solid(glm::dvec2 a, glm::dvec2 b, double half_width);
    void paint(const Segment& segment, double from, double to);
    void raise(std::uint8_t& value, glm::ivec2 pixel, std::uint8_t painted);
    void paint_row(const Segment& segment, int y, int first, int end);

    static constexpr int block_px = 8;
    static constexpr int group_blocks = 8;

    glm::ivec2 size_{};
    glm::ivec2 blocks_{};
    glm::ivec2 groups_{};
    std::vector<std::uint8_t> values_;
    std::vector<std::uint8_t> open_;         ///< pixels of each block that are not covered
    std::vector<std::uint8_t> open_blocks_;  ///< blocks of each group that have such pixels
    PixelRange touched_;
};

}  // namespace batten::render
