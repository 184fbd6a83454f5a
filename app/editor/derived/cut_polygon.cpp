#include "app/editor/derived/cut_polygon.h"

#include <algorithm>
#include <cmath>

namespace batten::editor {

namespace {

core::Point on_way(core::Point from, core::Point to, double share) {
    return core::tip_of((1.0 - share) * core::vector_to(from) + share * core::vector_to(to));
}

CutCorner corner_on_way(const core::OldCorner& from, const core::LegCut& to, double share) {
    return {on_way(from.point, to.point, share), from.index, to.new_index, std::lerp(from.weight, to.weight, share)};
}

/// What a control point that stays is called after the insertion: those behind the last cut follow it.
std::size_t next_of(const core::Curve& curve, const core::CornerCutting& cutting, std::size_t index) {
    const std::size_t n = curve.control_points().size();
    const std::size_t behind = (index + n - cutting.corners.back().index) % n;
    return (cutting.cuts.back().new_index + 1 + behind) % (n + 1);
}

}  // namespace

std::vector<CutCorner> cut_polygon(const core::Curve& curve, const core::CornerCutting& cutting, double share) {
    const std::vector<core::OldCorner>& corners = cutting.corners;
    const std::vector<core::LegCut>& cuts = cutting.cuts;
    const auto points = curve.control_points();
    std::vector<std::vector<CutCorner>> places;
    for (std::size_t i = 0; i < points.size(); ++i)
        places.push_back({{points[i], i, next_of(curve, cutting, i), curve.weights()[i]}});
    for (std::size_t j = 1; j + 1 < corners.size(); ++j)
        places[corners[j].index] = {corner_on_way(corners[j], cuts[j - 1], share),
                                    corner_on_way(corners[j], cuts[j], share)};
    // A single cut takes no corner: its point comes out of the one before it.
    if (cuts.size() == 1) places[corners.front().index].push_back(corner_on_way(corners.front(), cuts.front(), share));
    std::vector<CutCorner> polygon;
    for (const std::vector<CutCorner>& there : places) polygon.insert(polygon.end(), there.begin(), there.end());
    return polygon;
}

std::vector<CutCorner> corners_apart(std::vector<CutCorner> corners, bool is_closed) {
    const auto are_one = [](const CutCorner& a, const CutCorner& b) {
        return a.place == b.place && (a.index == b.index || a.next == b.next);
    };
    corners.erase(std::unique(corners.begin(), corners.end(), are_one), corners.end());
    if (is_closed && corners.size() > 1 && are_one(corners.back(), corners.front())) corners.pop_back();
    return corners;
}

}  // namespace batten::editor
