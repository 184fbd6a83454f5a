#include "app/editor/upkeep.h"

#include <algorithm>

#include "app/editor/state/selected_parts.h"
#include "core/make/fit_points.h"

namespace batten::editor {

namespace {

std::size_t fit_point_count(const core::Document& document) {
    const core::DocumentCurve* active = document.active_curve();
    return active != nullptr && active->fit != nullptr ? active->fit->points.size() : 0;
}

// Whether the parts of a curve that hover names exist; one overload for each thing that can be hovered.
struct HoverCheck {
    const core::Document& document;
    const core::Curve& curve;

    std::size_t point_count() const { return curve.control_points().size(); }

    bool operator()(const HoveredNothing&) const { return true; }
    bool operator()(const HoveredPoint& hovered) const { return hovered.index < point_count(); }
    bool operator()(const HoveredWeightRing& hovered) const { return hovered.index < point_count(); }
    bool operator()(const HoveredBasis& hovered) const { return hovered.index < point_count(); }
    bool operator()(const HoveredKnot& hovered) const { return hovered.index < curve.knots().stored().size(); }
    bool operator()(const HoveredParameter&) const { return true; }
    bool operator()(const HoveredCurve&) const { return true; }

    bool operator()(const HoveredHandle&) const { return true; }

    bool operator()(const HoveredSpan& hovered) const {
        const core::KnotVector& knots = curve.knots();
        return hovered.span + 1 < knots.size() && knots[hovered.span] < knots[hovered.span + 1];
    }
    bool operator()(const HoveredCell& hovered) const {
        const auto p = static_cast<std::size_t>(curve.degree());
        return hovered.level <= p && hovered.index <= p - hovered.level;
    }
    bool operator()(const HoveredBasisCell& hovered) const {
        return hovered.degree <= static_cast<std::size_t>(curve.degree()) &&
               hovered.function + hovered.degree + 1 < curve.knots().size();
    }
    bool operator()(const HoveredLeg& hovered) const {
        return hovered.index + (curve.is_periodic() ? 0 : 1) < point_count();
    }
    bool operator()(const HoveredFarinPoint& hovered) const { return (*this)(HoveredLeg{hovered.leg}); }
    bool operator()(const HoveredLifted& hovered) const { return !hovered.index || *hovered.index < point_count(); }
    bool operator()(const HoveredHodograph& hovered) const {
        return !hovered.index || *hovered.index + (curve.is_periodic() ? 0 : hovered.order) < point_count();
    }
    bool operator()(const HoveredFitPoint& hovered) const { return hovered.index < fit_point_count(document); }
    bool operator()(const HoveredFitHandle& hovered) const { return hovered.index < fit_point_count(document); }
    bool operator()(const HoveredHandlebar&) const { return true; }
    bool operator()(const HoveredGuide& hovered) const { return hovered.index < document.guides.size(); }
    bool operator()(const HoveredPicture& hovered) const { return hovered.index < document.pictures.size(); }
    bool operator()(const HoveredOtherPoint& hovered) const {
        return (*this)(HoveredOtherCurve{hovered.curve}) &&
               hovered.index < document.curves[hovered.curve].curve->control_points().size();
    }
    bool operator()(const HoveredRuler&) const { return true; }
    bool operator()(const HoveredGrip&) const { return true; }
    bool operator()(const HoveredOtherCurve& hovered) const {
        return hovered.index < document.curves.size() && hovered.index != document.active;
    }
};

void keep_selection(Selection& selection, const core::Document& before, const core::Document& after) {
    const core::Curve& old_active = *before.active_curve()->curve;
    const core::Curve& active = *after.active_curve()->curve;
    // With another count the old indices would silently mean other points or knots.
    if (old_active.control_points().size() != active.control_points().size()) selection.points.clear();
    if (old_active.knots().stored().size() != active.knots().stored().size()) selection.knot.reset();
    if (selection.handlebar && !active.domain().contains(*selection.handlebar)) selection.handlebar.reset();
    keep_parts(selection, before, after);
}

// The line stays where it was seen while the curve changes.
void keep_line(View& view, const core::Curve& before) {
    if (view.overlays.is_shown(Overlay::variation) && !view.shape.line) view.shape.line = level_line_through(before);
}

}  // namespace

bool is_in(const Hover& hover, const core::Document& document) {
    const core::DocumentCurve* active = document.active_curve();
    if (const auto* guide = std::get_if<HoveredGuide>(&hover)) return guide->index < document.guides.size();
    if (std::holds_alternative<HoveredRuler>(hover)) return true;
    if (const auto* picture = std::get_if<HoveredPicture>(&hover)) return picture->index < document.pictures.size();
    if (active == nullptr) return std::holds_alternative<HoveredNothing>(hover);
    return std::visit(HoverCheck{document, *active->curve}, hover);
}

void follow_shown(EditorState& state) {
    if (!is_in(state.hover, state.shown())) state.hover = HoveredNothing{};
}

void follow_document(EditorState& state, const core::Document& before) {
    state.preview.reset();
    state.ghost.reset();
    state.findings.reset();
    const core::Document& after = state.history.present();

    if (fit_point_count(before) != fit_point_count(after)) state.selection.fit_point.reset();
    const core::DocumentCurve* old_active = before.active_curve();
    const core::DocumentCurve* active = after.active_curve();
    if (old_active == nullptr || active == nullptr || before.active != after.active ||
        before.curves.size() != after.curves.size()) {
        state.selection = {};
        state.view.plot_range.reset();
        state.inserted.reset();
    } else {
        keep_selection(state.selection, before, after);
        keep_line(state.view, *old_active->curve);
    }
    if (active != nullptr && state.view.level && *state.view.level > active->curve->degree()) state.view.level.reset();
}

void note_insertion(EditorState& state, const core::Document& before) {
    const core::DocumentCurve* old_active = before.active_curve();
    const core::DocumentCurve* active = state.history.present().active_curve();
    if (old_active == nullptr || active == nullptr || before.active != state.history.present().active) return;
    const auto old_knots = old_active->curve->knots().stored();
    const auto knots = active->curve->knots().stored();
    if (knots.size() == old_knots.size()) return;
    state.inserted.reset();
    if (knots.size() == old_knots.size() + 1 && old_active->curve->degree() == active->curve->degree())
        state.inserted = InsertedKnot{*std::ranges::mismatch(knots, old_knots).in1, state.view.parameter};
}

}  // namespace batten::editor
