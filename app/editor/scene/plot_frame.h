/// What all parts of the dock are drawn from: the state, the axes, colors, and the curve.
#pragma once

#include <vector>

#include "app/editor/pointer/highlight.h"
#include "app/editor/pointer/plot_layout.h"
#include "app/editor/pointer/plot_mode.h"
#include "app/editor/scene/pen.h"

namespace batten::editor {

/// One picture of the dock while it is drawn. Only for a state with an active curve.
struct PlotFrame {
    PlotFrame(const EditorState& shown_state, const PlotMode& mode, glm::dvec2 size_px, render::DrawList& list);

    const EditorState& state;
    Theme theme;
    Pen pen;
    PlotLayout layout;
    const core::Curve& curve;
    Highlight lit;
    std::shared_ptr<const PlotBasis> basis;
    double u = 0.0;                         ///< the view's parameter in the domain
    std::size_t span = 0;                   ///< its span
    std::vector<std::size_t> chosen_knots;  ///< hovered, selected or dragged, by value: all stored knots equal to them

    double x(double parameter) const { return x_from_parameter(layout, parameter); }
    double y(double value) const { return y_from_value(layout, value); }

    /// The place in the palette, for Theme::point(), of function `i` and its control point.
    std::size_t hue(std::size_t i) const;

    /// The basis function of the local point j of `span_index`, a span of the curve.
    std::size_t function_of(std::size_t span_index, std::size_t j) const;

    /// The rectangle of the plot between two parameters, cut to the shown range; none when nothing of it is left.
    std::optional<render::PixelBox> band(core::Interval parameters) const;

    bool is_chosen(std::size_t stored_index) const;
};

}  // namespace batten::editor
