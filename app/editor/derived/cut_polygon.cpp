#include "app/editor/derived/cut_polygon.h"

#include <algorithm>

namespace batten::editor {

namespace {

core::Point on_way(core::Point from, core::Point to, double share) {
    return core::tip_of((1.0 - share) * core::vector_to(from) + share * core::vector_to(to));
}

}  // namespace

std::vector<CutCorner> cut_polygon(const core::Curve& curve, const core::CornerCutting& cutting, double share) {
    const std::vector<core::OldCorner>& corners = cutting.corners;
    const std::vector<core::LegCut>& cuts = cutting.cuts;
    const auto points = curve.control_points();
    std::vector<std::vector<core::Point>> places;
    for (const core::Point point : points) places.push_back({point});
    for (std::size_t j = 1; j + 1 < corners.size(); ++j)
        places[corners[j].index] = {on_way(corners[j].point, cuts[j - 1].point, share),
                                    on_way(corners[j].point, cuts[j].point, share)};
    // A single cut takes no corner: its point comes out of the one before it.
    if (cuts.size() == 1)
        places[corners.front().index].push_back(on_way(corners.front().point, cuts.front().point, share));
    std::vector<CutCorner> polygon;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (const core::Point place : places[i]) polygon.push_back({place, i});
    return polygon;
}

}  // namespace batten::editor
