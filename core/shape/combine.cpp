#include "core/shape/combine.h"

#include <algorithm>

#include "core/measure/continuity.h"
#include "core/shape/detail/chains.h"
#include "core/shape/detail/edge_winding.h"

namespace batten::core {

namespace {

bool is_kept(bool in_first, bool in_second, ShapeOperation operation) {
    switch (operation) {
        case ShapeOperation::unite:
            return in_first || in_second;
        case ShapeOperation::intersect:
            return in_first && in_second;
        case ShapeOperation::subtract:
            return in_first && !in_second;
        case ShapeOperation::exclude:
            return in_first != in_second;
    }
    return false;
}

Result<void> check_closed(std::span<const Curve> curves) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const auto joints = joint_continuity(curves[i]);
        const bool is_torn =
            std::any_of(joints.begin(), joints.end(), [](const JointContinuity& joint) { return joint.geometric < 0; });
        if (is_torn || !is_closed(curves[i])) return refuse({.code = CurveErrorCode::curve_not_closed, .index = i});
    }
    return {};
}

}  // namespace

Result<std::vector<Curve>> combine(const Shape& first, const Shape& second, ShapeOperation operation,
                                   const Progress& progress) {
    std::vector<Curve> curves = first.curves;
    curves.insert(curves.end(), second.curves.begin(), second.curves.end());
    if (const auto check = check_closed(curves); !check) return refuse(check.error());
    std::vector<std::size_t> sets(first.curves.size(), 0);
    sets.resize(curves.size(), 1);
    const auto graph = cut_where_they_meet(curves, part_of(progress, 0.0, 0.7));
    if (!graph) return refuse(graph.error());
    const auto sides = sides_of_lines(*graph, sets, part_of(progress, 0.7, 1.0));
    if (!sides) return refuse(sides.error());
    const auto is_kept_at = [&](const WindingPair& winding) {
        return is_kept(is_inside(winding[0], first.rule), is_inside(winding[1], second.rule), operation);
    };
    std::vector<ChainEdge> kept;
    for (std::size_t e = 0; e < graph->edges.size(); ++e) {
        if (graph->edges[e].line != e) continue;
        const bool is_left = is_kept_at((*sides)[e].left);
        if (is_left != is_kept_at((*sides)[e].right)) kept.push_back({e, is_left});
    }
    std::vector<Curve> boundary;
    for (const Chain& chain : chains_of(*graph, kept)) {
        // Every edge must have one before and one after it; else what was found does not fit together.
        if (!chain.is_closed) return refuse({.code = CurveErrorCode::shapes_not_decided});
        auto curve = curve_along(*graph, curves, chain);
        if (!curve) return refuse(curve.error());
        boundary.push_back(*std::move(curve));
    }
    return boundary;
}

}  // namespace batten::core
