#include "app/editor/pointer/snap.h"

#include <algorithm>
#include <cmath>

#include "app/editor/pointer/direction.h"
#include "app/editor/pointer/gesture.h"
#include "app/editor/pointer/grid_step.h"
#include "app/editor/pointer/snap_text.h"
#include "app/editor/state/selected_parts.h"
#include "core/curve/control_box.h"
#include "core/edit/plane_map.h"
#include "core/evaluate/basis.h"
#include "core/evaluate/evaluate.h"
#include "core/evaluate/farin_points.h"
#include "core/measure/contacts_near.h"
#include "core/measure/intersect_line.h"
#include "core/measure/lines_from_point.h"

namespace batten::editor {
namespace {

constexpr double right_angle = 90.0;            // degrees
constexpr std::size_t most_near_points = 1000;  // of a curve; more are a smear
constexpr std::size_t most_near_curves = 50;    // likewise
constexpr std::size_t most_near_spans = 16;     // that perpendiculars and tangents are looked for on
constexpr double nearer_by = 1e-9;              // of the reach: of what is equally near the first counts

/// A curve that comes near the pointer.
struct NearCurve {
    std::size_t index = 0;  ///< in the document
    const core::NearParts* parts = nullptr;
    bool is_crowded = false;

    const core::Curve& curve() const { return parts->curve(); }
};

class Snapper {
  public:
    Snapper(const EditorState& state, const SnapQuery& query)
        : state_(state), query_(query), document_(state.history.present()), reach_(snap_distance(state)) {}

    std::optional<Snap> snap() {
        find_near_curves();
        least_ = reach_;
        offer_places();
        if (!best_) offer_lines();
        if (!best_ && has(SnapKind::grid)) best_ = SnapFound{SnapKind::grid, grid_corner(state_, query_.place)};
        if (!best_) return std::nullopt;
        return snap_of(document_, *best_);
    }

  private:
    bool has(SnapKind kind) const { return state_.view.snap.kinds.has(kind); }
    bool shows_points(const NearCurve& near) const {
        return state_.view.overlays.is_shown(near.index == document_.active ? Overlay::polygon
                                                                            : Overlay::other_polygons);
    }

    bool moves_point(const NearCurve& near, std::size_t point) const {
        if (const SelectedPart* part = part_of(query_.dragged.parts, near.index))
            return part->is_whole() || std::binary_search(part->points.begin(), part->points.end(), point);
        if (near.index != document_.active) return false;
        const auto& moved = query_.dragged.points;
        return query_.dragged.is_curve || std::binary_search(moved.begin(), moved.end(), point);
    }

    /// Whether a point that acts on the place at `u` moves.
    bool moves_place(const NearCurve& near, double u) const {
        const bool is_part = part_of(query_.dragged.parts, near.index) != nullptr;
        if (!is_part && near.index != document_.active) return false;
        if (query_.dragged.is_curve) return true;
        if (!is_part && query_.dragged.points.empty()) return false;
        const core::BasisValues basis = core::basis_functions(near.curve().knots(), u);
        const core::BasisRow& values = basis.derivatives[0];
        const std::size_t first = basis.span + 1 - values.size();
        const std::size_t count = near.curve().control_points().size();
        for (std::size_t j = 0; j < values.size(); ++j)
            if (values[j] != 0.0 && moves_point(near, (first + j) % count)) return true;
        return false;
    }

    void offer(SnapFound found) {
        const double away = core::distance(found.position, query_.place);
        if (!(away <= least_) || (best_ && away > least_ - nearer_by * reach_)) return;
        least_ = away;
        best_ = std::move(found);
    }

    void find_near_curves() {
        for (std::size_t k = 0; k < document_.curves.size(); ++k) {
            const core::DocumentCurve& item = document_.curves[k];
            if (!item.visible || near_.size() == most_near_curves) continue;
            kept_.push_back(state_.derived.near_parts(item.curve));
            const core::NearParts& parts = *kept_.back();
            if (parts.is_crowded(query_.place, reach_, 0))
                near_.push_back({k, &parts, parts.is_crowded(query_.place, reach_, most_near_points)});
            else
                kept_.pop_back();
        }
    }

    template <class Visit>
    void visit_near(const NearCurve& near, std::size_t count, const Visit& visit) const {
        if (near.is_crowded) return;
        near.parts->visit_near(query_.place, reach_, [&](std::size_t i) {
            if (i < count) visit(i);
        });
    }

    void offer_places() {
        if (has(SnapKind::points)) for_each_near([&](const NearCurve& near) { offer_points(near); });
        if (has(SnapKind::ends)) for_each_near([&](const NearCurve& near) { offer_ends(near); });
        if (has(SnapKind::intersections)) offer_intersections();
        if (has(SnapKind::intersections)) for_each_near([&](const NearCurve& near) { offer_guides_across(near); });
        if (has(SnapKind::knots)) for_each_near([&](const NearCurve& near) { offer_knots(near); });
        if (has(SnapKind::midpoints)) for_each_near([&](const NearCurve& near) { offer_midpoints(near); });
        if (query_.from && has(SnapKind::tangent)) offer_feet(SnapKind::tangent, core::tangent_points);
        if (query_.from && has(SnapKind::perpendicular)) offer_feet(SnapKind::perpendicular, core::perpendicular_feet);
        if (has(SnapKind::guides)) offer_guide_crossings();
    }

    template <class Offer>
    void for_each_near(const Offer& offer_of) const {
        for (const NearCurve& near : near_) offer_of(near);
    }

    void offer_points(const NearCurve& near) {
        if (!shows_points(near)) return;
        const auto points = near.curve().control_points();
        visit_near(near, points.size(), [&](std::size_t i) {
            if (!moves_point(near, i)) offer({SnapKind::points, points[i], near.index, i});
        });
    }

    void offer_ends(const NearCurve& near) {
        const core::Curve& curve = near.curve();
        if (curve.is_periodic()) return;
        for (const double u : {curve.domain().lower, curve.domain().upper})
            if (!moves_place(near, u)) offer({SnapKind::ends, core::point_at(curve, u), near.index, 0, u});
    }

    void offer_intersections() {
        std::vector<const core::NearParts*> parts;
        for (const NearCurve& near : near_) parts.push_back(near.parts);
        for (const core::NearContact& contact : core::contacts_near(parts, query_.place, reach_)) {
            const NearCurve& first = near_[contact.first];
            const NearCurve& second = near_[contact.second];
            if (moves_place(first, contact.u) || moves_place(second, contact.v)) continue;
            SnapFound found{SnapKind::intersections, contact.point, first.index};
            found.other = second.index;
            offer(found);
        }
    }

    void offer_guides_across(const NearCurve& near) {
        const std::vector<std::size_t> guides = near_guides();
        if (guides.empty()) return;
        const auto parts = near.parts->parts_near(query_.place, reach_, most_near_spans);
        if (!parts) return;
        for (const core::Curve& part : *parts)
            for (const std::size_t k : guides) offer_guide_across(near, part, k);
    }

    void offer_guide_across(const NearCurve& near, const core::Curve& part, std::size_t k) {
        const core::Guide& guide = document_.guides[k];
        const core::Point base = nearest_on_guide(guide, query_.place);
        const double size = core::length(core::control_box(part).size()) + reach_;
        const auto found = core::intersect_line(part, base, base + size * direction_of(guide.angle));
        if (!found) return;
        for (const core::LineContact& contact : found->contacts) {
            if (contact.where.length() > 0.0 || moves_place(near, contact.u)) continue;
            SnapFound crossing{SnapKind::intersections, on_guide(guide, contact.point), near.index, 0, contact.u};
            crossing.guide = k;
            offer(std::move(crossing));
        }
    }

    void offer_knots(const NearCurve& near) {
        const core::Curve& curve = near.curve();
        const core::KnotVector& knots = curve.knots();
        const auto p = static_cast<std::size_t>(curve.degree());
        visit_near(near, knots.size() - 2 * p - 1, [&](std::size_t i) {
            const double u = knots[i + p];
            if (u < knots[i + p + 1] && !moves_place(near, u))
                offer({SnapKind::knots, core::point_at(curve, u), near.index, i + p, u});
        });
        const double end = knots.domain().upper;
        if (!curve.is_periodic() && !moves_place(near, end))
            offer({SnapKind::knots, core::point_at(curve, end), near.index, knots.size() - p - 1, end});
    }

    void offer_midpoints(const NearCurve& near) {
        if (!shows_points(near)) return;
        const auto points = near.curve().control_points();
        visit_near(near, core::leg_count(near.curve()), [&](std::size_t i) {
            const std::size_t next = (i + 1) % points.size();
            if (moves_point(near, i) || moves_point(near, next)) return;
            SnapFound found{SnapKind::midpoints, core::middle(points[i], points[next]), near.index, i};
            found.other = next;
            offer(found);
        });
    }

    template <class Feet>
    void offer_feet(SnapKind kind, const Feet& feet) {
        for (const NearCurve& near : near_) {
            const auto parts = near.parts->parts_near(query_.place, reach_, most_near_spans);
            if (!parts) continue;
            for (const core::Curve& part : *parts)
                for (const core::CurveSample& foot : feet(part, *query_.from)) {
                    if (moves_place(near, foot.u) || foot.point == *query_.from) continue;
                    SnapFound found{kind, foot.point, near.index, 0, foot.u};
                    found.lines = {{*query_.from, foot.point}};
                    offer(found);
                }
        }
    }

    void offer_guide_crossings() {
        const std::vector<std::size_t> near = near_guides();
        for (std::size_t a = 0; a < near.size(); ++a)
            for (std::size_t b = a + 1; b < near.size(); ++b) {
                const core::Guide& first = document_.guides[near[a]];
                const core::Guide& second = document_.guides[near[b]];
                const core::Vector along = direction_of(first.angle);
                const core::Vector across = direction_of(second.angle);
                const double sine = core::cross(along, across);
                if (sine == 0.0) continue;
                const double way = core::cross(second.point - first.point, across) / sine;
                SnapFound found{SnapKind::guides, crossing(first, second, way), near[a], near[b]};
                found.is_crossing = true;
                offer(found);
            }
    }

    /// Exact where a guide is level or upright.
    static core::Point crossing(const core::Guide& first, const core::Guide& second, double way) {
        return on_guide(second, on_guide(first, first.point + way * direction_of(first.angle)));
    }

    /// A place of a guide without what rounding put beside it, where the guide is level or upright.
    static core::Point on_guide(const core::Guide& guide, core::Point point) {
        if (guide.angle == 0.0) point.y = guide.point.y;
        if (guide.angle == right_angle) point.x = guide.point.x;
        return point;
    }

    std::vector<std::size_t> near_guides() const {
        std::vector<std::size_t> near;
        for (std::size_t k = 0; k < document_.guides.size() && near.size() < most_near_spans; ++k)
            if (k != query_.dragged.guide &&
                core::distance(nearest_on_guide(document_.guides[k], query_.place), query_.place) <= reach_)
                near.push_back(k);
        return near;
    }

    void offer_lines() {
        if (has(SnapKind::guides))
            for (const std::size_t k : near_guides())
                offer({SnapKind::guides, nearest_on_guide(document_.guides[k], query_.place), k});
        if (has(SnapKind::curve)) for_each_near([&](const NearCurve& near) { offer_curve(near); });
        if (query_.from && has(SnapKind::angles)) offer_direction(*query_.from);
    }

    void offer_curve(const NearCurve& near) {
        const auto sample = near.parts->nearest(query_.place, reach_);
        if (sample && !moves_place(near, sample->u)) offer({SnapKind::curve, sample->point, near.index, 0, sample->u});
    }

    void offer_direction(core::Point from) {
        const core::Vector way = query_.place - from;
        if (core::length(way) < reach_) return;
        const double step = state_.view.snap.angle_step;
        const double degrees = std::round(degrees_of(way) / step) * step;
        const core::Vector along = direction_of(degrees);
        const core::Point position = from + core::dot(way, along) * along;
        SnapFound found{SnapKind::angles, position, 0, 0, degrees};
        found.lines = {{from, position}};
        offer(found);
    }

    const EditorState& state_;
    const SnapQuery& query_;
    const core::Document& document_;
    double reach_;
    double least_ = 0.0;
    std::vector<NearCurve> near_;
    std::vector<std::shared_ptr<const core::NearParts>> kept_;  // as long as near_ has them
    std::optional<SnapFound> best_;
};

}  // namespace

double snap_distance(const EditorState& state) {
    return pixels(state, snap_reach) / state.view.camera.scale;
}

std::optional<Snap> snap_at(const EditorState& state, const SnapQuery& query) {
    if (!core::is_finite(query.place)) return std::nullopt;
    return Snapper(state, query).snap();
}

core::Point grid_corner(const EditorState& state, core::Point place) {
    const double step = canvas_grid_steps(state).minor;
    return {rounded_to_step(place.x, step), rounded_to_step(place.y, step)};
}

core::Point nearest_on_guide(const core::Guide& guide, core::Point place) {
    if (guide.angle == 0.0) return {place.x, guide.point.y};
    if (guide.angle == right_angle) return {guide.point.x, place.y};
    const core::Vector along = direction_of(guide.angle);
    return guide.point + core::dot(place - guide.point, along) * along;
}

}  // namespace batten::editor
