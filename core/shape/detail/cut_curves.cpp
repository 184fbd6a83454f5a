#include "core/shape/detail/cut_curves.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/curve/control_box.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/continuity.h"
#include "core/measure/intersect_curves.h"
#include "core/measure/nearest.h"
#include "core/refine/periodic.h"
#include "core/refine/split.h"

namespace batten::core {

namespace {

// Of the size of all curves.
constexpr double same_vertex = 1e-12;

// Parameters that differ by less than this part of the domain may be one place of a curve.
constexpr double same_split = 1e-6;

// How far along the curves a contact without a crossing may be off, as a part of the size.
constexpr double touching_reach = 1e-5;

constexpr int most_polishings = 6;
constexpr int most_rounds = 16;

double largest_side(const Box& box) {
    return std::max(box.size().x, box.size().y);
}

// Numbers that are found to be one.
class Unions {
  public:
    std::size_t add() {
        parents_.push_back(parents_.size());
        return parents_.size() - 1;
    }
    std::size_t root(std::size_t i) {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> parents_;
};

// A part that two curves, or one with itself, have in common.
struct Overlap {
    std::size_t first = 0;
    std::size_t second = 0;
    Interval on_first{};
    Interval on_second{};
};

// A contact without a crossing.
struct Touch {
    std::size_t first = 0;
    std::size_t second = 0;
    double u = 0.0;
    double v = 0.0;
};

class Cutter {
  public:
    explicit Cutter(const Progress& progress) : progress_(progress) {}

    Result<CutCurves> cut(std::span<const Curve> curves) {
        if (auto check = take(curves); !check) return refuse(check.error());
        if (!find_contacts()) return refuse({.code = CurveErrorCode::shapes_not_decided});
        if (!carry_over_overlaps()) return refuse({.code = CurveErrorCode::shapes_not_decided});
        join_near_places();
        number_vertices();
        if (auto check = add_edges(); !check) return refuse(check.error());
        find_lines();
        return std::move(graph_);
    }

  private:
    Result<void> take(std::span<const Curve> curves) {
        Box box;
        for (const Curve& curve : curves) {
            const Box own = control_box(curve);
            box.include(own.lower);
            box.include(own.upper);
        }
        if (curves.empty()) return {};
        graph_.origin = middle(box.lower, box.upper);
        graph_.size = largest_side(box);
        graph_.tolerance = same_vertex * graph_.size;
        for (const Curve& curve : curves) {
            auto open = to_clamped(seen_from(curve, graph_.origin));
            if (!open) return refuse(open.error());
            curves_.push_back(*std::move(open));
            const Interval domain = curves_.back().domain();
            splits_.emplace_back();
            const std::size_t start = add_split(splits_.size() - 1, domain.lower);
            const std::size_t end = add_split(splits_.size() - 1, domain.upper);
            if (is_closed(curve)) places_.join(start, end);
        }
        return {};
    }

    // The number of the place at parameter `u` of curve `c`, perhaps one that is known.
    std::size_t add_split(std::size_t c, double u) {
        auto& splits = splits_[c];
        const Point point = point_at(curves_[c], u);
        const double slack = same_split * curves_[c].domain().length();
        for (auto at = splits.lower_bound(u - slack); at != splits.end() && at->first <= u + slack; ++at)
            if (distance(points_[at->second], point) <= graph_.tolerance) return at->second;
        points_.push_back(point);
        return splits[u] = places_.add();
    }

    void add_contact(std::size_t a, std::size_t b, const CurveContact& contact) {
        const Interval second{std::min(contact.second_begin, contact.second_end),
                              std::max(contact.second_begin, contact.second_end)};
        if (contact.is_overlap()) overlaps_.push_back({a, b, contact.on_first, second});
        places_.join(add_split(a, contact.on_first.lower), add_split(b, contact.second_begin));
        places_.join(add_split(a, contact.on_first.upper), add_split(b, contact.second_end));
    }

    bool find_contacts() {
        std::vector<Box> boxes;
        for (const Curve& curve : curves_) boxes.push_back(control_box(curve));
        bool is_complete = true;
        for (std::size_t a = 0; a < curves_.size(); ++a) {
            tell(progress_, a, curves_.size());
            for (std::size_t b = a; b < curves_.size(); ++b) {
                if (!boxes[a].intersects(boxes[b])) continue;
                const CurveContacts found =
                    a == b ? self_intersections(curves_[a]) : intersect_curves(curves_[a], curves_[b]);
                is_complete = is_complete && found.is_complete;
                for (const CurveContact& contact : found.contacts) {
                    if (contact.is_tangent && !contact.is_overlap())
                        touches_.push_back({a, b, contact.u, contact.v});
                    else
                        add_contact(a, b, contact);
                }
            }
        }
        for (const Touch& touch : touches_) add_touch(polished(touch));
        return is_complete;
    }

    // By Newton's iteration for parallel tangents across which the curves meet.
    Touch polished(Touch touch) const {
        const double reach = touching_reach * graph_.size;
        Touch found = touch;
        for (int k = 0; k < most_polishings; ++k) {
            const Jet a = derivatives_at(curves_[found.first], found.u, 2);
            const Jet b = derivatives_at(curves_[found.second], found.v, 2);
            const Vector apart = a.point - b.point;
            const double parallel = cross(a[1], b[1]);
            const double along = dot(apart, a[1]);
            // Rows of the Jacobian by u and v.
            const Vector first{cross(a[2], b[1]), cross(a[1], b[2])};
            const Vector second{dot(a[1], a[1]) + dot(apart, a[2]), -dot(b[1], a[1])};
            const double determinant = cross(first, second);
            const double step_u = (parallel * second.y - along * first.y) / determinant;
            const double step_v = (first.x * along - second.x * parallel) / determinant;
            if (!std::isfinite(step_u) || !std::isfinite(step_v)) return touch;
            found.u = curves_[found.first].domain().clamp(found.u - step_u);
            found.v = curves_[found.second].domain().clamp(found.v - step_v);
        }
        const Point place = point_at(curves_[found.first], found.u);
        const bool is_near = distance(place, point_at(curves_[touch.first], touch.u)) <= reach;
        const bool meets = distance(place, point_at(curves_[found.second], found.v)) <= graph_.tolerance;
        return is_near && meets ? found : touch;
    }

    // Where curves touch is known less well along them than across. So a place near it that is known takes it over, if
    // the curves are as near there.
    void add_touch(const Touch& touch) {
        if (const auto place = known_place(touch.first, touch.u, touch.second))
            return places_.join(place->first, add_split(touch.second, place->second));
        if (const auto place = known_place(touch.second, touch.v, touch.first))
            return places_.join(place->first, add_split(touch.first, place->second));
        places_.join(add_split(touch.first, touch.u), add_split(touch.second, touch.v));
    }

    // A place of curve `c` near parameter `u` where `other` passes, and the parameter of that.
    std::optional<std::pair<std::size_t, double>> known_place(std::size_t c, double u, std::size_t other) const {
        if (c == other) return std::nullopt;
        const Point point = point_at(curves_[c], u);
        for (const auto& [at, place] : splits_[c]) {
            if (!(distance(points_[place], point) <= touching_reach * graph_.size)) continue;
            const CurveSample found = nearest_point(curves_[other], points_[place]);
            if (distance(found.point, points_[place]) <= graph_.tolerance) return std::pair(place, found.u);
        }
        return std::nullopt;
    }

    // Where one of two curves that coincide is cut, the other one is, too.
    bool carry_over_overlaps() {
        for (int round = 0; round < most_rounds; ++round) {
            const std::size_t before = points_.size();
            for (const Overlap& overlap : overlaps_) {
                carry_over(overlap.first, overlap.on_first, overlap.second, overlap.on_second);
                carry_over(overlap.second, overlap.on_second, overlap.first, overlap.on_first);
            }
            if (points_.size() == before) return true;
        }
        return false;
    }

    void carry_over(std::size_t from, Interval range, std::size_t to, Interval target) {
        if (!(target.length() > 0.0)) return;
        std::vector<std::size_t> inside;
        const auto& splits = splits_[from];
        for (auto at = splits.upper_bound(range.lower); at != splits.end() && at->first < range.upper; ++at)
            inside.push_back(at->second);
        if (inside.empty()) return;
        const auto part = sub_curve(curves_[to], target.lower, target.upper);
        if (!part) return;
        const NearestFinder finder(*part);
        for (const std::size_t place : inside) {
            const CurveSample found = finder.nearest(points_[place]);
            if (distance(found.point, points_[place]) <= 4.0 * graph_.tolerance)
                places_.join(place, add_split(to, found.u));
        }
    }

    void join_near_places() {
        std::vector<std::size_t> order(points_.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(),
                  [&](std::size_t a, std::size_t b) { return points_[a].x < points_[b].x; });
        for (std::size_t i = 0; i < order.size(); ++i)
            for (std::size_t k = i + 1;
                 k < order.size() && points_[order[k]].x - points_[order[i]].x <= graph_.tolerance; ++k)
                if (distance(points_[order[i]], points_[order[k]]) <= graph_.tolerance)
                    places_.join(order[i], order[k]);
    }

    void number_vertices() {
        vertices_.assign(points_.size(), 0);
        for (std::size_t place = 0; place < points_.size(); ++place) {
            if (places_.root(place) == place) {
                vertices_[place] = graph_.vertices.size();
                graph_.vertices.push_back(points_[place]);
            }
            vertices_[place] = vertices_[places_.root(place)];
        }
    }

    Result<void> add_edges() {
        for (std::size_t c = 0; c < curves_.size(); ++c) {
            graph_.first_edges.push_back(graph_.edges.size());
            double start = splits_[c].begin()->first;
            std::size_t from = vertices_[splits_[c].begin()->second];
            for (auto at = std::next(splits_[c].begin()); at != splits_[c].end(); ++at) {
                auto arc = sub_curve(curves_[c], start, at->first);
                if (!arc) return refuse(arc.error());
                const std::size_t to = vertices_[at->second];
                const bool is_a_place = from == to && largest_side(control_box(*arc)) <= 8.0 * graph_.tolerance;
                // The next edge then begins where this one would.
                const bool is_last = std::next(at) == splits_[c].end();
                if (!is_a_place || (is_last && graph_.first_edges.back() == graph_.edges.size()))
                    graph_.edges.push_back({c, {start, at->first}, from, to, snapped(*arc, from, to)});
                start = at->first;
                from = to;
            }
        }
        graph_.first_edges.push_back(graph_.edges.size());
        return {};
    }

    Curve snapped(const Curve& arc, std::size_t from, std::size_t to) const {
        CurveDefinition definition = arc.definition();
        definition.points.front() = graph_.vertices[from];
        definition.points.back() = graph_.vertices[to];
        return Curve::make(std::move(definition)).value_or(arc);
    }

    void find_lines() {
        std::map<std::array<std::size_t, 2>, std::vector<std::size_t>> between;
        for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
            CutEdge& edge = graph_.edges[e];
            edge.line = e;
            auto& others = between[{std::min(edge.from, edge.to), std::max(edge.from, edge.to)}];
            const auto same = std::find_if(others.begin(), others.end(), [&](std::size_t other) {
                return graph_.edges[other].line == other && are_one(graph_.edges[other].arc, edge.arc);
            });
            if (same == others.end()) {
                others.push_back(e);
                continue;
            }
            edge.line = *same;
            edge.is_turned = runs_against(graph_.edges[*same], edge);
        }
    }

    // Edges between the same vertices that do not coincide have nothing else in common.
    bool are_one(const Curve& a, const Curve& b) const {
        const double near = 8.0 * graph_.tolerance;
        const Point place = point_at(b, middle_of_domain(b));
        Box reach = control_box(a);
        reach.lower -= Vector(near, near);
        reach.upper += Vector(near, near);
        return reach.contains(place) && distance(nearest_point(a, place).point, place) <= near;
    }

    static double middle_of_domain(const Curve& curve) { return curve.domain().lower + 0.5 * curve.domain().length(); }

    // Compared where the edge is smooth: inside its widest span.
    static bool runs_against(const CutEdge& line, const CutEdge& edge) {
        if (line.from != line.to) return line.from != edge.from;
        const auto knots = edge.arc.knots().values();
        std::size_t widest = 0;
        for (std::size_t i = 0; i + 1 < knots.size(); ++i)
            if (knots[i + 1] - knots[i] > knots[widest + 1] - knots[widest]) widest = i;
        const double u = knots[widest] + 0.5 * (knots[widest + 1] - knots[widest]);
        const double v = nearest_point(line.arc, point_at(edge.arc, u)).u;
        return dot(derivatives_at(edge.arc, u, 1)[1], derivatives_at(line.arc, v, 1)[1]) < 0.0;
    }

    const Progress& progress_;
    std::vector<Curve> curves_{};
    std::vector<std::map<double, std::size_t>> splits_{};  // of each curve: the place at a parameter
    std::vector<Point> points_{};                          // of the places
    Unions places_{};
    std::vector<Overlap> overlaps_{};
    std::vector<Touch> touches_{};
    std::vector<std::size_t> vertices_{};  // of the places
    CutCurves graph_{};
};

}  // namespace

Result<CutCurves> cut_where_they_meet(std::span<const Curve> curves, const Progress& progress) {
    return Cutter(progress).cut(curves);
}

}  // namespace batten::core
