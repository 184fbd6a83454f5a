#include "core/shape/offset_shape.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "core/curve/control_box.h"
#include "core/curve/detail/edit_checks.h"
#include "core/edit/offset.h"
#include "core/evaluate/evaluate.h"
#include "core/measure/nearest.h"
#include "core/refine/bezier_form.h"
#include "core/refine/degree.h"
#include "core/refine/reparametrize.h"
#include "core/refine/reverse.h"
#include "core/refine/split.h"
#include "core/shape/detail/chains.h"
#include "core/shape/detail/offset_fit.h"
#include "core/shape/detail/offset_parts.h"

namespace batten::core {

namespace {

// Of the tolerance: what is left to the fit after the crossings took theirs.
constexpr double fit_share = 0.8;

// How much nearer than the distance, beside it, counts as nearer.
constexpr double nearer_share = 1e-9;

// Of the size of everything: a part that is smaller is a point.
constexpr double point_share = 1e-11;

// Edges of one part that follow one another.
struct PartRun {
    std::size_t part = 0;
    Interval range{};
    std::size_t first = 0;  // edges
    std::size_t last = 0;
};

class Trimmer {
  public:
    Trimmer(const std::vector<OffsetSource>& sources, std::vector<OffsetPart> parts, double tolerance)
        : sources_(sources), parts_(std::move(parts)), tolerance_(tolerance), finder_(sources.front().curve()) {
        for (const OffsetPart& part : parts_) curves_.push_back(part.curve);
    }

    Result<void> cut(const Progress& progress) {
        auto graph = cut_where_they_meet(curves_, progress);
        if (!graph) return refuse(graph.error());
        graph_ = *std::move(graph);
        return {};
    }

    // Whether what is left of all parts has ends.
    bool is_open() const {
        const auto chains = chains_of(graph_, kept_edges([](const OffsetPart&) { return true; }));
        return std::any_of(chains.begin(), chains.end(), [](const Chain& chain) { return !chain.is_closed; });
    }

    // What is left of the parts that are wanted.
    Result<OffsetCurves> trimmed(const std::function<bool(const OffsetPart&)>& is_wanted) const {
        OffsetCurves result;
        for (const Chain& chain : chains_of(graph_, kept_edges(is_wanted))) {
            auto curve = curve_of(chain, result.error);
            if (!curve) return refuse(curve.error());
            result.curves.push_back(*std::move(curve));
        }
        return result;
    }

  private:
    const OffsetSource& source_of(const OffsetPart& part) const { return sources_[part.source]; }
    double offset_distance() const { return sources_.front().distance(); }

    std::vector<ChainEdge> kept_edges(const std::function<bool(const OffsetPart&)>& is_wanted) const {
        std::vector<ChainEdge> kept;
        std::map<std::size_t, std::vector<std::size_t>> by_line;
        for (std::size_t e = 0; e < graph_.edges.size(); ++e)
            if (is_wanted(parts_[graph_.edges[e].curve]) && is_kept(graph_.edges[e]))
                by_line[graph_.edges[e].line].push_back(e);
        for (const auto& on_line : by_line) {
            const std::vector<std::size_t>& edges = on_line.second;
            // Two that run against each other have nothing between them.
            const auto turned = std::find_if(edges.begin(), edges.end(), [&](std::size_t e) {
                return graph_.edges[e].is_turned != graph_.edges[edges.front()].is_turned;
            });
            if (turned == edges.end()) kept.push_back({edges.front(), true});
        }
        std::sort(kept.begin(), kept.end(), [](const ChainEdge& a, const ChainEdge& b) { return a.line < b.line; });
        return kept;
    }

    bool is_kept(const CutEdge& edge) const {
        const Vector extent = control_box(edge.arc).size();
        if (std::max(extent.x, extent.y) <= point_share * graph_.size) return false;
        const OffsetPart& part = parts_[edge.curve];
        const double u = edge.range.lower + 0.5 * edge.range.length();
        if (part.kind == OffsetPartKind::raw) {
            const auto place = source_of(part).at(u, Side::right);
            return place && is_clear(place->point, offset_distance());
        }
        const Point place = point_at(part.curve, u);
        // On a cap or corner that is cut off only what is nearer than the end or corner is in the way.
        return is_clear(place, part.is_cut_off ? distance(place, part.center) : offset_distance());
    }

    bool is_clear(Point place, double wanted) const {
        const double slack = nearer_share * offset_distance() + point_share * graph_.size;
        return distance(finder_.nearest(place).point, place) >= wanted - slack;
    }

    bool goes_on(std::size_t edge, std::size_t next) const {
        if (graph_.edges[edge].curve != graph_.edges[next].curve) return false;
        const OffsetPart& part = parts_[graph_.edges[edge].curve];
        const bool is_over_seam = edge + 1 == graph_.first_edges[graph_.edges[edge].curve + 1] &&
                                  next == graph_.first_edges[graph_.edges[edge].curve] && edge != next;
        return next == edge + 1 ||
               (is_over_seam && source_of(part).is_smoothly_closed() && part.kind == OffsetPartKind::raw);
    }

    std::vector<PartRun> runs_of(const Chain& chain) const {
        std::vector<PartRun> runs;
        const auto period_at = [&](std::size_t part) { return curves_[part].domain().length(); };
        for (const ChainEdge& kept : chain.edges) {
            const CutEdge& edge = graph_.edges[kept.line];
            if (!runs.empty() && goes_on(runs.back().last, kept.line)) {
                const bool is_wrapped = edge.range.upper <= runs.back().range.lower;
                runs.back().range.upper = edge.range.upper + (is_wrapped ? period_at(edge.curve) : 0.0);
                runs.back().last = kept.line;
            } else {
                runs.push_back({edge.curve, edge.range, kept.line, kept.line});
            }
        }
        if (chain.is_closed && runs.size() > 1 && goes_on(runs.back().last, runs.front().first)) {
            const double turn = runs.front().range.lower < runs.back().range.lower ? period_at(runs.front().part) : 0.0;
            runs.front().range = {runs.back().range.lower, runs.front().range.upper + turn};
            runs.front().first = runs.back().first;
            runs.pop_back();
        }
        return runs;
    }

    Result<Curve> curve_of(const Chain& chain, double& error) const {
        const std::vector<PartRun> runs = runs_of(chain);
        std::vector<Curve> curves;
        int degree = 0;
        for (const PartRun& run : runs) {
            auto curve = curve_of(run, error);
            if (!curve) return refuse(curve.error());
            if (curve->is_periodic()) return curve;
            degree = std::max(degree, curve->degree());
            curves.push_back(*std::move(curve));
        }
        return joined(curves, degree, chain.is_closed);
    }

    Result<Curve> curve_of(const PartRun& run, double& error) const {
        const OffsetPart& part = parts_[run.part];
        if (part.kind != OffsetPartKind::raw) {
            const bool is_whole = run.range == part.curve.domain();
            return is_whole ? part.curve : sub_curve(part.curve, run.range.lower, run.range.upper);
        }
        const double period = part.curve.domain().length();
        const bool is_turn = source_of(part).is_smoothly_closed() && run.range.length() >= period * (1.0 - 1e-14) &&
                             run.last + 1 == graph_.first_edges[run.part + 1];
        auto fitted = fit_offset(source_of(part), is_turn ? part.curve.domain() : run.range, fit_share * tolerance_);
        if (!fitted) return refuse(with_whole_tolerance(fitted.error()));
        error = std::max(error, fitted->error);
        return fitted->curve.is_periodic() ? fitted->curve : snapped(fitted->curve, run, error);
    }

    // As it was asked for.
    CurveError with_whole_tolerance(CurveError error) const {
        if (error.code == CurveErrorCode::tolerance_not_reached) error.value = tolerance_;
        return error;
    }

    // With its ends where the others meet it.
    Curve snapped(const Curve& curve, const PartRun& run, double& error) const {
        const Vector from_origin = vector_to(graph_.origin);
        CurveDefinition definition = curve.definition();
        const auto snap = [&](Point& end, std::size_t vertex) {
            const Point place = graph_.vertices[vertex] + from_origin;
            error = std::max(error, distance(place, end));
            end = place;
        };
        snap(definition.points.front(), graph_.edges[run.first].from);
        snap(definition.points.back(), graph_.edges[run.last].to);
        return Curve::make(std::move(definition)).value_or(curve);
    }

    static Result<Curve> joined(std::span<const Curve> curves, int degree, bool is_closed) {
        std::optional<CurveDefinition> whole;
        for (const Curve& curve : curves) {
            Result<Curve> next = curve;
            if (degree > curve.degree()) next = elevate_degree(curve, degree - curve.degree());
            if (next && whole) next = shift_domain(*next, whole->knots.back());
            if (!next) return refuse(next.error());
            whole = whole ? concatenated(*std::move(whole), next->definition()) : next->definition();
        }
        if (is_closed) whole->points.back() = whole->points.front();
        return Curve::make(degree == 1 ? without_straight_corners(*std::move(whole), is_closed) : *std::move(whole));
    }

    // Legs of a polygon that go on straight are one.
    static CurveDefinition without_straight_corners(const CurveDefinition& polygon, bool is_closed) {
        CurveDefinition kept{.degree = 1, .knots = {polygon.knots[0], polygon.knots[1]}, .points = {polygon.points[0]}};
        for (std::size_t i = 1; i + 1 < polygon.points.size(); ++i) {
            if (is_straight(kept.points.back(), polygon.points[i], polygon.points[i + 1])) continue;
            kept.points.push_back(polygon.points[i]);
            kept.knots.push_back(polygon.knots[i + 1]);
        }
        kept.points.push_back(polygon.points.back());
        kept.knots.insert(kept.knots.end(), 2, polygon.knots.back());
        if (is_closed && is_straight(*(kept.points.end() - 2), kept.points[0], kept.points[1])) drop_start(kept);
        return kept;
    }

    static bool is_straight(Point a, Point b, Point c) {
        constexpr double straight = 1e-12;
        const Vector before = b - a;
        const Vector after = c - b;
        return std::abs(cross(before, after)) <= straight * length(before) * length(after) && dot(before, after) >= 0.0;
    }

    // A closed polygon then begins in its next corner.
    static void drop_start(CurveDefinition& polygon) {
        polygon.points.erase(polygon.points.begin());
        polygon.points.back() = polygon.points.front();
        polygon.knots.erase(polygon.knots.begin());
        polygon.knots.front() = polygon.knots[1];
    }

    const std::vector<OffsetSource>& sources_;
    std::vector<OffsetPart> parts_;
    double tolerance_;
    NearestFinder finder_;
    std::vector<Curve> curves_{};
    CutCurves graph_{};
};

Result<OffsetCurves> reversed(Result<OffsetCurves> found) {
    if (!found) return found;
    for (Curve& curve : found->curves) {
        auto turned = reverse(curve);
        if (!turned) return refuse(turned.error());
        curve = *std::move(turned);
    }
    return found;
}

// Lines and circles need no cutting.
std::optional<OffsetCurves> exact_on(OffsetSide side, const Curve& curve, double distance) {
    OffsetCurves found;
    if (side != OffsetSide::right)
        if (auto left = exact_offset(curve, distance)) found.curves.push_back(*std::move(left));
    if (side != OffsetSide::left)
        if (auto right = exact_offset(curve, -distance)) found.curves.push_back(*std::move(right));
    const std::size_t wanted = side == OffsetSide::both ? 2 : 1;
    return found.curves.size() == wanted ? std::optional(std::move(found)) : std::nullopt;
}

// All around the curve: to the left and back on the right, with caps between the ends of an open one. What lies on
// one side may be cut off by what belongs to the other.
Result<std::vector<OffsetPart>> parts_around(const std::vector<OffsetSource>& sources, const OffsetRequest& request,
                                             OffsetCaps caps) {
    auto there = offset_parts(sources[0], 0, request);
    auto back = offset_parts(sources[1], 1, request);
    if (!there || !back) return refuse(there ? back.error() : there.error());
    if (!sources[0].is_closed()) {
        const Point end_of_there = there->front().curve.control_points().front();
        auto end = offset_cap(sources[0], 0, *there, back->front().curve.control_points().front(), caps);
        auto start = offset_cap(sources[1], 1, *back, end_of_there, caps);
        if (!end || !start) return refuse(end ? start.error() : end.error());
        there->push_back(*std::move(end));
        back->push_back(*std::move(start));
    }
    there->insert(there->end(), back->begin(), back->end());
    return there;
}

Result<OffsetCurves> trimmed_on(OffsetSide side, const Curve& curve, const OffsetRequest& request,
                                const Progress& progress) {
    const auto turned = reverse(curve);
    if (!turned) return refuse(turned.error());
    const std::vector<OffsetSource> sources{OffsetSource(curve, request.distance),
                                            OffsetSource(*turned, request.distance)};
    const bool has_caps = side == OffsetSide::both && request.caps != OffsetCaps::none && !sources[0].is_closed();
    auto parts = parts_around(sources, request, has_caps ? request.caps : OffsetCaps::round);
    if (!parts) return refuse(parts.error());
    Trimmer trimmer(sources, *std::move(parts), request.tolerance);
    if (auto check = trimmer.cut(progress); !check) return refuse(check.error());
    if (has_caps && trimmer.is_open()) return refuse({.code = CurveErrorCode::shapes_not_decided});
    if (has_caps) return reversed(trimmer.trimmed([](const OffsetPart&) { return true; }));
    OffsetCurves found;
    for (const std::size_t source : {std::size_t{0}, std::size_t{1}}) {
        if (side == (source == 0 ? OffsetSide::right : OffsetSide::left)) continue;
        auto of_side = trimmer.trimmed(
            [&](const OffsetPart& part) { return part.source == source && part.kind != OffsetPartKind::cap; });
        if (source == 1) of_side = reversed(std::move(of_side));
        if (!of_side) return of_side;
        found.curves.insert(found.curves.end(), of_side->curves.begin(), of_side->curves.end());
        found.error = std::max(found.error, of_side->error);
    }
    return found;
}

}  // namespace

Result<OffsetCurves> offset_shape(const Curve& curve, const OffsetRequest& request, const Progress& progress) {
    if (!std::isfinite(request.distance)) return refuse({.code = CurveErrorCode::vector_not_finite});
    if (const auto check = check_tolerance(request.tolerance); !check) return refuse(check.error());
    if (request.distance == 0.0) return OffsetCurves{{curve}, 0.0};
    if (curve.is_torn()) return refuse({.code = CurveErrorCode::curve_has_corner, .value = curve.domain().lower});
    OffsetSide side = request.side;
    if (request.distance < 0.0 && side != OffsetSide::both)
        side = side == OffsetSide::left ? OffsetSide::right : OffsetSide::left;
    OffsetRequest positive = request;
    positive.distance = std::abs(request.distance);
    const bool has_caps = side == OffsetSide::both && request.caps != OffsetCaps::none;
    if (auto exact = has_caps ? std::nullopt : exact_on(side, curve, positive.distance)) return *std::move(exact);
    auto found = trimmed_on(side, curve, positive, progress);
    if (found && found->curves.empty())
        return refuse({.code = CurveErrorCode::shape_vanishes, .value = positive.distance});
    return found;
}

}  // namespace batten::core
