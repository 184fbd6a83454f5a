/// A picture as data: polylines, fills, ink, regions, markers and labels in pixels, painted in order.
#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "render/color.h"
#include "render/coverage_map.h"
#include "render/image.h"
#include "render/region_cover.h"

namespace batten::render {

/// A position in pixels of the picture: x to the right, y down, (0, 0) the upper left corner.
using Pixel = glm::vec2;

/// A connected line. Joints are round; translucent ones do not darken at joints.
struct Polyline {
    std::vector<Pixel> points;
    Color color;
    float width_px = 1.0F;
    float dash_px = 0.0F;  ///< length of a dash, 0 for a solid line
    float gap_px = 0.0F;
    bool is_closed = false;
};

/// A convex polygon, filled.
struct Fill {
    std::vector<Pixel> points;
    Color color;
};

/// Pixels of one color as far as they are covered: a line that is too long and dense to be painted as a line.
struct Ink {
    std::shared_ptr<const CoverageMap> map;  ///< not null
    Color color;
};

/// What loops enclose, filled. Painters that know no such paths paint the map.
struct Region {
    std::shared_ptr<const RegionLoops> loops;  ///< not null
    std::shared_ptr<const CoverageMap> map;    ///< their region_coverage; not null
    Color color;
};

/// An image stretched to a parallelogram. Corners are doubles: they may be far outside.
struct ImageQuad {
    std::shared_ptr<const Image> image;  ///< not null, not empty
    glm::dvec2 upper_left{};
    glm::dvec2 upper_right{};
    glm::dvec2 lower_left{};
    double opacity = 1.0;
};

enum class MarkerShape { disc, diamond, square };

/// A symbol of fixed size. `radius_px` is half the width of the shape without its outline.
struct Marker {
    Pixel center{};
    MarkerShape shape = MarkerShape::disc;
    float radius_px = 4.0F;
    Color fill;               ///< alpha 0: hollow
    Color outline;            ///< alpha 0: none
    float outline_px = 0.0F;  ///< drawn centered on the shape's edge
    float dash_px = 0.0F;     ///< length of the outline's dashes and gaps (discs only), 0 for solid
};

/// Where a label's position is in its text box.
enum class Anchor { left, center, right };

/// Which of the interface's fonts a label is set in.
enum class LabelFont { text, bold, number };

/// A line of text, centered vertically on its position. In the text _{..} is set as subscript and ^{..} as superscript,
/// which may follow one another: "P_{3}^{1}".
struct Label {
    Pixel position{};
    std::string text;
    Color color;
    float size_px = 13.0F;
    Anchor anchor = Anchor::left;
    LabelFont font = LabelFont::text;
    float gap_px = 0.0F;  ///< above 0: it goes on so far behind the label before it, on the side to which both run
};

using DrawCommand = std::variant<Fill, Polyline, Ink, Region, ImageQuad, Marker, Label>;

/// What to draw, in order; later commands cover earlier ones.
struct DrawList {
    std::vector<DrawCommand> commands;

    template <typename Command>
    void add(Command&& command) {
        commands.emplace_back(std::forward<Command>(command));
    }
};

}  // namespace batten::render
