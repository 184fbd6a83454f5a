/// Finds places for labels where they cover neither one another nor what matters in the picture.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "render/coverage_map.h"
#include "render/draw_list.h"
#include "render/pixel_box.h"

namespace batten::editor {

/// The places of a label around a point.
enum class LabelSide { upper_right, upper_left, lower_right, lower_left, right, left, above, below };

/// What happens to a label that has no free place.
enum class Crowding {
    cover_nothing,  ///< it is left out rather than cover anything, be it a line
    leave_out,      ///< it is left out rather than cover a symbol or several lines
    cover_symbols   ///< it may cover anything but other labels
};

/// Where a label came to stand.
struct LabelPlace {
    glm::dvec2 position{};  ///< for render::Label, with `anchor`
    render::Anchor anchor = render::Anchor::left;
    render::PixelBox box;
    LabelSide side = LabelSide::upper_right;
};

/// Greedy: every label takes the first of eight places around its point that is free, in a fixed order, so that labels
/// stay where they are while nothing comes in their way; else the one that covers least. Labels never cover labels and
/// never leave the picture. Cost of a place: what stands near it, by cells of the picture.
class LabelLayout {
  public:
    explicit LabelLayout(glm::dvec2 size_px);

    /// Makes labels stay off a line, a symbol, or (under all
    /// circumstances) a box.
    void avoid_line(std::span<const glm::dvec2> points);
    /// Of these many count no more than few, so that a label among them is not left out.
    void avoid_faint_line(std::span<const glm::dvec2> points);
    void avoid_symbol(glm::dvec2 center, double radius_px);
    void avoid_box(const render::PixelBox& box);

    /// Makes labels stay off what is covered in any of `maps`, which are of one size, as off a line for each eight rows
    /// of pixels.
    void avoid_ink(std::span<const render::CoverageMap* const> maps);

    /// From now on a label around one of `points` stands nearer to it than to any other one, so that it is not read as
    /// the name of that; points less than half of a label's height apart are one mark to the eye.
    void tell_apart(std::vector<glm::dvec2> points) { named_ = std::move(points); }

    /// A place for a text of `text_px` that begins `offset_px` sideways of `point`, and about half as far above or
    /// below; `first` is tried first. None when every place would cover another label, leave
    /// the picture, or what `crowding` forbids.
    std::optional<LabelPlace> place(glm::dvec2 point, glm::dvec2 text_px, double offset_px, LabelSide first,
                                    Crowding crowding);

    /// The same on that side alone.
    std::optional<LabelPlace> place_on(LabelSide side, glm::dvec2 point, glm::dvec2 text_px, double offset_px,
                                       Crowding crowding);

    /// How many lines, symbols, boxes and labels were looked at for all places so far.
    std::size_t look_count() const { return look_count_; }

  private:
    enum class Kind : std::uint8_t { line, faint_line, symbol, box };
    struct Obstacle {
        Kind kind = Kind::line;
        glm::dvec2 a{};
        glm::dvec2 b{};
        std::size_t first_row = 0;  ///< of the cells in its column that it is in
    };

    /// The first of `sides` that costs least; none where that is too much.
    std::optional<LabelPlace> best_of(std::span<const LabelSide> sides, glm::dvec2 point, glm::dvec2 text_px,
                                      double offset_px, Crowding crowding);

    /// The cells from the first to the last one that a range of coordinates touches.
    struct Cells {
        std::size_t first = 0;
        std::size_t last = 0;
    };

    Cells columns(double left, double right) const;
    Cells rows(double top, double bottom) const;
    std::vector<Obstacle>& cell(std::size_t column, std::size_t row) { return cells_[column * row_count_ + row]; }
    void add_lines(Kind kind, std::span<const glm::dvec2> points);
    void add_line(Kind kind, glm::dvec2 a, glm::dvec2 b);
    void add_block(Kind kind, const render::PixelBox& box);
    /// What `obstacle` adds to the cost of `box`.
    static double cost_of(const Obstacle& obstacle, const render::PixelBox& box);
    /// Whether what stands in `box` is read as the name of `point`.
    bool belongs_to(const render::PixelBox& box, glm::dvec2 point) const;
    /// What the box would cover; no more is counted once that reaches `limit`.
    double cost(const render::PixelBox& box, double limit);

    glm::dvec2 size_px_;
    std::size_t column_count_;
    std::size_t row_count_;
    std::vector<std::vector<Obstacle>> cells_;  ///< obstacles by the cells of the picture that they touch
    std::vector<glm::dvec2> named_;             ///< points whose labels are told apart
    std::size_t look_count_ = 0;
};

}  // namespace batten::editor
