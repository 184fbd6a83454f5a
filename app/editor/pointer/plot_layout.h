/// Where things are in the dock: the basis plot and the knot strip share one u axis.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "app/editor/state/state.h"
#include "core/base/geometry.h"
#include "core/evaluate/quantity_graph.h"
#include "render/pixel_box.h"

namespace batten::editor {

/// What can be plotted along the curve below the knot strip, from above.
struct PlottedQuantity {
    Overlay overlay;
    core::Quantity quantity;
};
inline constexpr std::array plotted_quantities{PlottedQuantity{Overlay::curvature_plot, core::Quantity::curvature},
                                               PlottedQuantity{Overlay::speed_plot, core::Quantity::speed}};

/// The quantities that are plotted now.
std::vector<core::Quantity> plotted_now(const View& view);

/// By how many design pixels the dock is higher for them.
double height_of_plots(const View& view);

/// The axes of the dock, in pixels of its picture.
struct PlotLayout {
    core::Interval range;  ///< parameters from left to right
    double left_px = 0.0;
    double right_px = 0.0;
    double top_px = 0.0;                     ///< where N = 1
    double bottom_px = 0.0;                  ///< where N = 0
    double strip_px = 0.0;                   ///< the axis of the knot strip, below the plot
    double labels_px = 0.0;                  ///< the height of the labels below it
    double diamond_px = 8.0;                 ///< half the width of a knot's diamond
    double stack_px = 10.0;                  ///< how far the diamonds of a stack are apart
    std::vector<render::PixelBox> graphs{};  ///< below the strip, one for each shown of plotted_quantities

    bool operator==(const PlotLayout&) const = default;
};

/// The parameters from the first to the last knot of the active curve, one period when periodic; [0, 1] without a
/// curve. Those of the committed curve, so that the axis stands still while a knot is dragged.
core::Interval whole_plot_range(const EditorState& state);

/// The layout for a picture of `size_px`, which is the whole dock with its title row, for the active curve (its whole
/// range unless zoomed). Usable from 400 x 160 design pixels; the plot takes what the dock is higher. High stacks are
/// pressed together.
PlotLayout plot_layout(const EditorState& state, glm::dvec2 size_px);

double x_from_parameter(const PlotLayout& layout, double u);
double parameter_from_x(const PlotLayout& layout, double x_px);
double y_from_value(const PlotLayout& layout, double value);

/// One diamond of a stack on the strip.
struct KnotMark {
    std::size_t index = 0;  ///< in KnotVector::stored()
    glm::dvec2 center_px{};
};

/// The diamonds of the shown active curve that are in the range, bottom to top within a stack of equal knots. Knots
/// that only nearly agree stand beside each other, each at its own x.
std::vector<KnotMark> knot_marks(const EditorState& state, const PlotLayout& layout);

/// The same between two places of the axis.
std::vector<KnotMark> knot_marks(const EditorState& state, const PlotLayout& layout, core::Interval x_px);

}  // namespace batten::editor
