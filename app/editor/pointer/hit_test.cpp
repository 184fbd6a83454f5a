#include "app/editor/pointer/hit_test.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "app/editor/derived/construction_cells.h"
#include "app/editor/pointer/fit_point_drag.h"
#include "app/editor/pointer/handlebar.h"
#include "app/editor/pointer/inset_hit.h"
#include "app/editor/pointer/nearest.h"
#include "app/editor/pointer/snap.h"
#include "app/editor/pointer/view_handle.h"
#include "app/editor/pointer/weight_ring.h"
#include "app/editor/scene/insets.h"
#include "app/editor/scene/ruler.h"
#include "app/editor/scene/thinned_points.h"
#include "app/editor/state/selected_parts.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/farin_points.h"

namespace batten::editor {
namespace {

/// How near the pointer must be, in design pixels.
namespace reach {
constexpr double point = 9.0;  ///< C(u) and control points
constexpr double ring = 4.0;
constexpr double farin_point = 8.0;
constexpr double knot = 8.0;
constexpr double cell = 7.0;
constexpr double curve = 6.0;
constexpr double leg = 5.0;
constexpr double guide = 5.0;
}  // namespace reach

using NearestThing = Nearest<Hover>;

double distance_to_segment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double squared = glm::dot(along, along);
    const double t = squared > 0.0 ? std::clamp(glm::dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * along);
}

/// The pointer on the canvas and what it needs to find things.
struct CanvasPointer {
    const EditorState& state;
    glm::dvec2 position_px;

    const render::Camera& camera() const { return state.view.camera; }
    double px(double design_px) const { return design_px * state.view.interface_scale; }
    bool shows(Overlay overlay) const { return state.view.overlays.is_shown(overlay); }
    core::Point world() const { return core::Point(render::world_from_screen(camera(), position_px)); }
    double distance_to(core::Point world) const {
        return glm::distance(position_px, render::screen_from_world(camera(), world));
    }

    /// In the plane of the curves, with what may be lost by rounding; what is within it is measured in pixels then.
    double world_reach(double design_px) const {
        constexpr double rounding_px = 1.0;
        return (px(design_px) + rounding_px) / camera().scale;
    }

    /// The nearest point of a curve, if it is within reach.
    std::optional<core::CurveSample> on_curve(const core::NearParts& parts) const {
        const auto sample = parts.nearest(world(), world_reach(reach::curve));
        return sample && distance_to(sample->point) <= px(reach::curve) ? sample : std::nullopt;
    }
};

/// The active curve on the canvas.
class ActiveCurve {
  public:
    ActiveCurve(const CanvasPointer& pointer, const core::NearParts& parts, const core::FitPoints* fit)
        : pointer_(pointer), parts_(parts), curve_(parts.curve()), fit_(fit) {}

    std::optional<Hover> hit() const;

  private:
    std::optional<Hover> hit_parameter_or_points() const;
    void offer_points(NearestThing& nearest) const;
    void offer_thinned_points(NearestThing& nearest) const;
    std::optional<Hover> hit_fit_handles() const;
    std::optional<Hover> hit_rings() const;
    std::optional<Hover> hit_farin_points() const;
    std::optional<Hover> hit_knots() const;
    std::optional<Hover> hit_construction() const;
    std::optional<Hover> hit_curve() const;
    std::optional<Hover> hit_legs() const;

    std::size_t point_count() const { return curve_.control_points().size(); }
    double distance_to(std::size_t point) const { return pointer_.distance_to(curve_.control_points()[point]); }
    glm::dvec2 place_of(std::size_t point) const {
        return render::screen_from_world(pointer_.camera(), curve_.control_points()[point % point_count()]);
    }

    /// Calls `visit` for the first `count` control points of the unrolled curve as far as they, or what begins with
    /// them, may be so near; ascending.
    template <class Visit>
    void visit_near(double design_px, std::size_t count, const Visit& visit) const {
        parts_.visit_near(pointer_.world(), pointer_.world_reach(design_px), [&](std::size_t i) {
            if (i < count) visit(i);
        });
    }

    /// Calls `visit` with the index in values() and the value of the topmost knot of each stack of the domain where the
    /// curve may be so near: those that begin a span, and the end of the domain.
    template <class Visit>
    void visit_knots(double design_px, const Visit& visit) const {
        const core::KnotVector& knots = curve_.knots();
        const auto p = static_cast<std::size_t>(curve_.degree());
        visit_near(design_px, knots.size() - 2 * p - 1, [&](std::size_t i) {
            if (knots[i + p] < knots[i + p + 1]) visit(i + p, knots[i + p]);
        });
        const double end = knots.domain().upper;
        const auto stored = knots.stored();
        const auto after_end = std::upper_bound(stored.begin(), stored.end(), end);
        visit(knots.stored_offset() + static_cast<std::size_t>(after_end - stored.begin()) - 1, end);
    }

    const CanvasPointer& pointer_;
    const core::NearParts& parts_;
    const core::Curve& curve_;
    const core::FitPoints* fit_;  ///< null unless the curve is made of such; its control points then cannot be held
};

void ActiveCurve::offer_points(NearestThing& nearest) const {
    if (pointer_.state.view.overlays.is_drawing()) return offer_thinned_points(nearest);
    visit_near(reach::point, point_count(), [&](std::size_t i) { nearest.offer(HoveredPoint{i}, distance_to(i)); });
}

/// Those that the drawing mode shows; which they are the points around them say.
void ActiveCurve::offer_thinned_points(NearestThing& nearest) const {
    std::vector<MarkPlace> places;
    visit_near(reach::point + 2.0 * drawing_gap, point_count(), [&](std::size_t i) {
        places.push_back({i, place_of(i)});
    });
    const glm::dvec2 origin_px = render::screen_from_world(pointer_.camera(), {0.0, 0.0});
    for (const MarkPlace& place : thinned(places, pointer_.px(drawing_gap), origin_px))
        nearest.offer(HoveredPoint{place.index}, distance_to(place.index));
    for (const std::size_t i : picked_points(pointer_.state.selection)) nearest.offer(HoveredPoint{i}, distance_to(i));
    for (const std::size_t i : {std::size_t{0}, point_count() - 1}) nearest.offer(HoveredPoint{i}, distance_to(i));
}

/// C(u) or a control point, whichever is nearer; the point where they coincide, because at the end of a clamped curve
/// it could not be grabbed otherwise.
std::optional<Hover> ActiveCurve::hit_parameter_or_points() const {
    NearestThing nearest(pointer_.px(reach::point));
    if (fit_ != nullptr) {
        visit_knots(reach::point, [&](std::size_t, double u) {
            if (const auto i = fit_point_at(*fit_, u))
                nearest.offer(HoveredFitPoint{*i}, pointer_.distance_to(fit_->points[*i].place));
        });
    } else if (pointer_.shows(Overlay::polygon)) {
        offer_points(nearest);
    }
    nearest.offer(HoveredParameter{}, pointer_.distance_to(core::point_at(curve_, pointer_.state.parameter())));
    return nearest.found();
}

std::optional<Hover> ActiveCurve::hit_rings() const {
    NearestThing nearest(pointer_.px(reach::ring));
    const auto offer = [&](std::size_t i) {
        if (const auto radius = weight_ring_radius_px(pointer_.state, i))
            nearest.offer(HoveredWeightRing{i}, std::abs(distance_to(i) - *radius));
    };
    const bool all_may_have_rings =
        curve_.is_rational() || curve_.weights().front() != 1.0 || pointer_.state.tool == Tool::weight;
    if (all_may_have_rings)
        visit_near(greatest_ring_radius + reach::ring, point_count(), offer);
    else if (pointer_.state.selection.points.size() == 1)
        offer(pointer_.state.selection.points.front());
    return nearest.found();
}

std::optional<Hover> ActiveCurve::hit_farin_points() const {
    NearestThing nearest(pointer_.px(reach::farin_point));
    visit_near(reach::farin_point, core::leg_count(curve_), [&](std::size_t leg) {
        nearest.offer(HoveredFarinPoint{leg}, pointer_.distance_to(core::farin_point(curve_, leg).point));
    });
    return nearest.found();
}

std::optional<Hover> ActiveCurve::hit_knots() const {
    NearestThing nearest(pointer_.px(reach::knot));
    visit_knots(reach::knot, [&](std::size_t index, double u) {
        nearest.offer(HoveredKnot{index - curve_.knots().stored_offset()},
                      pointer_.distance_to(core::point_at(curve_, u)));
    });
    return nearest.found();
}

/// Both ends of the handles; of those that cover the same place the first.
std::optional<Hover> ActiveCurve::hit_fit_handles() const {
    NearestThing nearest(pointer_.px(reach::point));
    for (const std::size_t i : points_with_handles(*fit_, pointer_.state.selection))
        for (const HandleEnd end : {HandleEnd::ahead, HandleEnd::behind})
            nearest.offer(HoveredFitHandle{i, end}, pointer_.distance_to(handle_tip(*fit_, i, end)));
    return nearest.found();
}

std::optional<Hover> ActiveCurve::hit_construction() const {
    NearestThing nearest(pointer_.px(reach::cell));
    const core::DeBoorTriangle triangle = core::de_boor_triangle(curve_, pointer_.state.parameter());
    for (const auto [level, index] : marked_cells(pointer_.state.view, triangle))
        nearest.offer(HoveredCell{level, index}, pointer_.distance_to(triangle.levels[level][index].point));
    return nearest.found();
}

std::optional<Hover> ActiveCurve::hit_curve() const {
    const auto sample = pointer_.on_curve(parts_);
    return sample ? std::optional<Hover>(HoveredCurve{sample->u}) : std::nullopt;
}

std::optional<Hover> ActiveCurve::hit_legs() const {
    NearestThing nearest(pointer_.px(reach::leg));
    visit_near(reach::leg, core::leg_count(curve_), [&](std::size_t i) {
        nearest.offer(HoveredLeg{i}, distance_to_segment(pointer_.position_px, place_of(i), place_of(i + 1)));
    });
    return nearest.found();
}

std::optional<Hover> ActiveCurve::hit() const {
    const double point_px = pointer_.px(reach::point);
    if (const auto part = handlebar_part_at(pointer_.state, pointer_.position_px, point_px))
        return HoveredHandlebar{*part};
    if (const auto found = hit_parameter_or_points()) return found;
    if (fit_ != nullptr)
        if (const auto found = hit_fit_handles()) return found;
    if (const auto handle = handle_at(pointer_.state, pointer_.position_px)) return HoveredHandle{*handle};
    const bool has_polygon = pointer_.shows(Overlay::polygon) && fit_ == nullptr;
    if (has_polygon)
        if (const auto found = hit_rings()) return found;
    if (pointer_.shows(Overlay::farin_points))
        if (const auto found = hit_farin_points()) return found;
    if (pointer_.shows(Overlay::knots) && fit_ == nullptr)
        if (const auto found = hit_knots()) return found;
    if (pointer_.shows(Overlay::construction))
        if (const auto found = hit_construction()) return found;
    if (const auto found = hit_curve()) return found;
    if (is_on_probe_line(pointer_.state, pointer_.position_px)) return HoveredHandle{ViewHandle::line};
    if (has_polygon) return hit_legs();
    return std::nullopt;
}

/// Of the curves whose points are shown beside those of the active one.
std::optional<Hover> hit_other_points(const CanvasPointer& pointer) {
    NearestThing nearest(pointer.px(reach::point));
    const core::Document& document = pointer.state.shown();
    for (const std::size_t k : curves_showing_points(pointer.state)) {
        const auto points = document.curves[k].curve->control_points();
        const auto parts = pointer.state.derived.near_parts(document.curves[k].curve);
        parts->visit_near(pointer.world(), pointer.world_reach(reach::point), [&](std::size_t i) {
            if (i < points.size()) nearest.offer(HoveredOtherPoint{k, i}, pointer.distance_to(points[i]));
        });
    }
    return nearest.found();
}

/// Whether `hit` is a small thing, which lies above points of other curves.
bool is_small(const Hover& hit) {
    return !std::holds_alternative<HoveredCurve>(hit) && !std::holds_alternative<HoveredLeg>(hit) &&
           !std::holds_alternative<HoveredHandle>(hit);
}

Hover hit_other_curves(const CanvasPointer& pointer) {
    NearestThing nearest(pointer.px(reach::curve));
    const core::Document& document = pointer.state.shown();
    for (std::size_t i = 0; i < document.curves.size(); ++i) {
        if (i == document.active || !document.curves[i].visible) continue;
        if (const auto sample = pointer.on_curve(*pointer.state.derived.near_parts(document.curves[i].curve)))
            nearest.offer(HoveredOtherCurve{i}, pointer.distance_to(sample->point));
    }
    return nearest.found().value_or(HoveredNothing{});
}

Hover hit_guides(const CanvasPointer& pointer) {
    NearestThing nearest(pointer.px(reach::guide));
    const auto& guides = pointer.state.shown().guides;
    for (std::size_t k = 0; k < guides.size(); ++k)
        nearest.offer(HoveredGuide{k}, pointer.distance_to(nearest_on_guide(guides[k], pointer.world())));
    return nearest.found().value_or(HoveredNothing{});
}

}  // namespace

Hover hit_canvas(const EditorState& state, glm::dvec2 position_px) {
    if (const auto axis = ruler_at(state, position_px)) return HoveredRuler{*axis};
    if (const auto inset = inset_at(state, position_px)) return hit_inset(state, *inset, position_px);
    const CanvasPointer pointer{state, position_px};
    const core::DocumentCurve* active = state.shown().active_curve();
    std::optional<Hover> hit;
    if (active != nullptr && active->visible)
        hit = ActiveCurve(pointer, *state.derived.near_parts(active->curve), active->fit.get()).hit();
    if (hit && is_small(*hit)) return *hit;
    if (auto point = hit_other_points(pointer)) return *point;
    if (hit) return *hit;
    const Hover other = hit_other_curves(pointer);
    return std::holds_alternative<HoveredNothing>(other) ? hit_guides(pointer) : other;
}

}  // namespace batten::editor
