#include "app/editor/formula.h"
#include "app/editor/gesture.h"
#include "app/editor/plot_mode.h"

namespace batten::editor {
namespace {

/// "0.5 (×2, C¹)".
std::string knot_text(const core::KnotVector& knots, std::size_t stored_index) {
    if (stored_index >= knots.stored().size()) return {};
    const double u = knots.stored()[stored_index];
    const int multiplicity = knots.multiplicity(u);
    std::string text = number_text(u);
    const bool is_inside = knots.is_periodic() || (knots.domain().lower < u && u < knots.domain().upper);
    if (!is_inside) return multiplicity > 1 ? text + " (×" + std::to_string(multiplicity) + ")" : text;
    text += multiplicity > 1 ? " (×" + std::to_string(multiplicity) + ", " : " (";
    return text + plain_text(continuity_text(knots.degree() - multiplicity)) + ")";
}

const char* meaning_of(core::KnotMove mode) {
    switch (mode) {
        case core::KnotMove::stop:
            return "stops at its neighbours";
        case core::KnotMove::push:
            return "pushes its neighbours";
        case core::KnotMove::snap:
            return "snaps onto its neighbours";
    }
    return "";
}

/// One case for each thing that can be hovered in the dock.
struct HoverHint {
    const EditorState& state;
    const core::Curve& curve;

    std::string operator()(const HoveredKnot& h) const {
        return "Drag the knot " + knot_text(curve.knots(), h.index) + " to move it; it " +
               meaning_of(state.view.knot_move) + " · double-click to raise its multiplicity (keeps the shape)";
    }
    std::string operator()(const HoveredBasis& h) const {
        const std::string i = std::to_string(h.index);
        return plain_text("N_{" + i + "," + std::to_string(curve.degree()) + "}") + " belongs to " +
               plain_text("P_{" + i + "}") + " · press to set u here";
    }
    std::string operator()(const HoveredSpan& h) const {
        const core::KnotVector& knots = curve.knots();
        if (h.span + 1 >= knots.size()) return {};
        return "Double-click to insert a knot between " + number_text(knots[h.span]) + " and " +
               number_text(knots[h.span + 1]) + " (keeps the shape) · press to set u here";
    }
    std::string operator()(const HoveredParameter&) const {
        return "Drag to move u = " + number_text(state.parameter());
    }
    template <class Other>
    std::string operator()(const Other&) const {
        return "Press to set u here · the wheel zooms · middle-drag or Space-drag pans";
    }
};

/// One case for each mode.
struct ModeHint {
    const EditorState& state;
    const core::Curve& curve;

    std::string operator()(const PlotIdle&) const {
        const core::DocumentCurve* active = state.shown().active_curve();
        if (active->locked && std::holds_alternative<HoveredKnot>(state.hover))
            return "'" + active->name + "' is locked; unlock it in the inspector to edit it";
        return std::visit(HoverHint{state, curve}, state.hover);
    }
    std::string operator()(const DraggingKnot& mode) const {
        return "Knot at " + knot_text(curve.knots(), moving_knot(state, mode.index)) + "; it " +
               meaning_of(state.view.knot_move) + " · Ctrl keeps to round numbers · Escape restores";
    }
    std::string operator()(const DraggingPlotParameter&) const { return "u = " + number_text(state.parameter()); }
    std::string operator()(const PanningPlot&) const { return "Panning the u axis"; }
};

}  // namespace

std::string plot_hint(const PlotMode& mode, const EditorState& state) {
    const core::Curve* curve = state.active_curve();
    return curve == nullptr ? std::string() : std::visit(ModeHint{state, *curve}, mode);
}

}  // namespace batten::editor
