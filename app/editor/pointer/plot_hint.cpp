#include <fmt/core.h>

#include "app/editor/derived/shown_function.h"
#include "app/editor/pointer/gesture.h"
#include "app/editor/pointer/hint_text.h"
#include "app/editor/pointer/plot_mode.h"
#include "app/editor/words/formula.h"
#include "app/editor/words/number_column.h"
#include "core/base/sentence.h"

namespace batten::editor {
namespace {

using core::sentence;

/// "0.5 (×2, C¹)".
std::string knot_text(const core::KnotVector& knots, std::size_t stored_index) {
    if (stored_index >= knots.stored().size()) return {};
    const double u = knots.stored()[stored_index];
    const int multiplicity = knots.multiplicity(u);
    const bool is_inside = knots.is_periodic() || (knots.domain().lower < u && u < knots.domain().upper);
    const std::string continuity = plain_text(continuity_text(knots.degree() - multiplicity));
    if (!is_inside)
        return multiplicity > 1 ? fmt::format("{} (×{})", number_text(u, 6), multiplicity) : number_text(u, 6);
    if (multiplicity == 1) return fmt::format("{} ({})", number_text(u, 6), continuity);
    return fmt::format("{} (×{}, {})", number_text(u, 6), multiplicity, continuity);
}

/// How a knot that is to be dragged behaves at its neighbors.
const char* pattern_of_hover(core::KnotMove mode) {
    switch (mode) {
        case core::KnotMove::stop:
            return "Drag the knot {knot} to move it; it stops before its neighbors · double-click to raise its "
                   "multiplicity (keeps the shape)";
        case core::KnotMove::push:
            return "Drag the knot {knot} to move it; it pushes its neighbors · double-click to raise its multiplicity "
                   "(keeps the shape)";
        case core::KnotMove::snap:
            break;
    }
    return "Drag the knot {knot} to move it; it snaps onto its neighbors · double-click to raise its multiplicity "
           "(keeps the shape)";
}

const char* pattern_of_drag(core::KnotMove mode) {
    switch (mode) {
        case core::KnotMove::stop:
            return "Knot at {knot}; it stops before its neighbors · Ctrl keeps to round numbers · Escape restores";
        case core::KnotMove::push:
            return "Knot at {knot}; it pushes its neighbors · Ctrl keeps to round numbers · Escape restores";
        case core::KnotMove::snap:
            break;
    }
    return "Knot at {knot}; it snaps onto its neighbors · Ctrl keeps to round numbers · Escape restores";
}

/// One case for each thing that can be hovered in the dock.
struct HoverHint {
    const EditorState& state;
    const core::Curve& curve;

    std::string operator()(const HoveredKnot& h) const {
        return sentence(pattern_of_hover(state.view.knot_move), {{"knot", knot_text(curve.knots(), h.index)}});
    }
    std::string operator()(const HoveredBasis& h) const {
        const std::string basis = plain_text(function_name(state, curve.knots(), h.index));
        return sentence("{basis} belongs to {point} · press to set u here",
                        {{"basis", basis}, {"point", point_text(h.index)}});
    }
    std::string operator()(const HoveredSpan& h) const {
        const core::KnotVector& knots = curve.knots();
        if (h.span + 1 >= knots.size()) return {};
        return sentence(
            "Double-click to insert a knot between {lower} and {upper} (keeps the shape) · press to set u here",
            {{"lower", number_text(knots[h.span], 6)}, {"upper", number_text(knots[h.span + 1], 6)}});
    }
    std::string operator()(const HoveredParameter&) const {
        return sentence("Drag to move u = {u} · Ctrl keeps to knots and round numbers",
                        {{"u", parameter_text(curve, state.parameter())}});
    }
    template <class Other>
    std::string operator()(const Other&) const {
        return "Press to set u here · the wheel zooms · middle-drag or Space-drag pans";
    }
};

/// One case for each mode.
struct PlotModeHint {
    const EditorState& state;
    const core::Curve& curve;

    std::string operator()(const PlotIdle&) const {
        const core::DocumentCurve* active = state.shown().active_curve();
        if (active->locked && std::holds_alternative<HoveredKnot>(state.hover)) return locked_sentence(*active);
        return std::visit(HoverHint{state, curve}, state.hover);
    }
    std::string operator()(const DoubleClickingPlot&) const { return (*this)(PlotIdle{}); }
    std::string operator()(const DraggingKnot& mode) const {
        return sentence(pattern_of_drag(state.view.knot_move),
                        {{"knot", knot_text(curve.knots(), moving_knot(state, mode.index))}});
    }
    std::string operator()(const DraggingPlotParameter&) const { return parameter_text(state); }
    std::string operator()(const PanningPlot&) const { return "Panning the u axis"; }
};

}  // namespace

std::string plot_hint(const PlotMode& mode, const EditorState& state) {
    const core::Curve* curve = state.active_curve();
    return curve == nullptr ? std::string()
                            : notated(std::visit(PlotModeHint{state, *curve}, mode), state.view.notation);
}

}  // namespace batten::editor
