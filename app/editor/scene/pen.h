/// Adds marks to a draw list: places in doubles, cut to what can be seen, sizes in design pixels.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <string>
#include <vector>

#include "app/editor/state/notation.h"
#include "render/draw_list.h"
#include "render/pixel_box.h"

namespace batten::editor {

/// How a line is drawn, in design pixels.
struct Stroke {
    render::Color color;
    double width = 1.0;
    double dash = 0.0;  ///< 0 for a solid line
    double gap = 0.0;
};

/// How a symbol is drawn, in design pixels.
struct Symbol {
    render::MarkerShape shape = render::MarkerShape::disc;
    double radius = 4.0;
    render::Color fill;
    render::Color outline;
    double outline_width = 0.0;
    double dash = 0.0;
};

/// How a text is set, in design pixels.
struct TextStyle {
    render::Color color;
    double size = 13.0;
    render::Anchor anchor = render::Anchor::left;
    render::LabelFont font = render::LabelFont::text;
    double gap = 0.0;  ///< above 0: to the text before, which this one goes on
};

inline constexpr render::Color no_color{0, 0, 0, 0};

/// Writes to one draw list. Places are pixels of the picture as doubles, however far; what is outside of `reach` (the
/// picture and a margin) is cut off or left out before it becomes a float.
class Pen {
  public:
    /// `scale` is pixels of the picture per design pixel, > 0; texts are brought into `notation`.
    Pen(render::DrawList& list, glm::dvec2 size_px, double scale, const Notation& notation = {});

    glm::dvec2 size_px() const { return size_px_; }
    double px(double design) const { return design * scale_; }
    const render::PixelBox& reach() const { return reach_; }

    /// A pen for the same list that draws nothing outside of `box`, but for symbols and texts whose places are in it.
    Pen within(const render::PixelBox& box) const;

    /// A line through `points`; the dashes begin `along_px` before its first point, wherever it is cut.
    void line(std::span<const glm::dvec2> points, const Stroke& stroke, double along_px = 0.0);
    void segment(glm::dvec2 a, glm::dvec2 b, const Stroke& stroke);

    /// The outline of a polygon.
    void outline(std::vector<glm::dvec2> points, const Stroke& stroke);

    /// A convex polygon; nothing for fewer than three points.
    void fill(std::vector<glm::dvec2> polygon, render::Color color);

    void region(const render::Region& region);
    void ink(std::shared_ptr<const render::CoverageMap> map, render::Color color);
    void symbol(glm::dvec2 center, const Symbol& symbol);
    void text(glm::dvec2 position, const std::string& text, const TextStyle& style);

    /// Takes out the texts in the list that reach into `box`, for what lies over them there: texts are painted over all
    /// else.
    void clear_texts(const render::PixelBox& box);

  private:
    render::DrawList& list_;
    glm::dvec2 size_px_;
    double scale_;
    render::PixelBox reach_;
    Notation notation_;
};

/// The corners of a rectangle with rounded corners.
std::vector<glm::dvec2> rounded_rectangle(const render::PixelBox& box, double radius_px);

/// The corners of a rectangle.
std::vector<glm::dvec2> corners_of(const render::PixelBox& box);

}  // namespace batten::editor
