#include "core/evaluate/de_boor_polygons.h"

#include <algorithm>
#include <cassert>

namespace batten::core {

namespace {

// The origins of `places`, each once.
std::vector<CellPlace> origins_of(const DeBoorTriangle& triangle, std::vector<CellPlace> places) {
    for (CellPlace& place : places) place = origin_of(triangle, place);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

std::vector<CellPlace> difference(const std::vector<CellPlace>& places, const std::vector<CellPlace>& others) {
    std::vector<CellPlace> result;
    std::copy_if(places.begin(), places.end(), std::back_inserter(result), [&](const CellPlace& place) {
        return std::find(others.begin(), others.end(), place) == others.end();
    });
    return result;
}

CellPlace apex_of(const DeBoorTriangle& triangle) {
    return origin_of(triangle, {triangle.levels.size() - 1, 0});
}

}  // namespace

CellPlace origin_of(const DeBoorTriangle& triangle, CellPlace place) {
    while (place.level > 0) {
        const double alpha = triangle.levels[place.level][place.index].alpha;
        if (alpha != 0.0 && alpha != 1.0) break;
        place = {place.level - 1, place.index + (alpha == 1.0 ? 1 : 0)};
    }
    return place;
}

std::size_t insertion_count(const DeBoorTriangle& triangle) {
    return apex_of(triangle).level;
}

std::vector<CellPlace> inserted_polygon(const DeBoorTriangle& triangle, std::size_t times) {
    assert(times <= insertion_count(triangle));
    std::vector<CellPlace> places;
    for (std::size_t r = 0; r < times; ++r) places.push_back({r, 0});
    for (std::size_t j = 0; j < triangle.levels[times].size(); ++j) places.push_back({times, j});
    for (std::size_t r = times; r-- > 0;) places.push_back({r, triangle.levels[r].size() - 1});
    return origins_of(triangle, std::move(places));
}

InsertionStep insertion_step(const DeBoorTriangle& triangle, std::size_t times) {
    assert(times >= 1);
    const std::vector<CellPlace> before = inserted_polygon(triangle, times - 1);
    const std::vector<CellPlace> after = inserted_polygon(triangle, times);
    return {difference(after, before), difference(before, after)};
}

bool is_at_tear(const Curve& curve, const DeBoorTriangle& triangle) {
    const auto p = static_cast<std::size_t>(curve.degree());
    return triangle.span > p && curve.knots()[triangle.span - p] == triangle.u;
}

SplitPolygons split_polygons(const Curve& curve, const DeBoorTriangle& triangle) {
    SplitPolygons polygons;
    for (std::size_t r = 0; r < triangle.levels.size(); ++r) {
        polygons.before.push_back({r, 0});
        polygons.after.insert(polygons.after.begin(), {r, triangle.levels[r].size() - 1});
    }
    if (is_at_tear(curve, triangle)) polygons.before.clear();
    return {origins_of(triangle, std::move(polygons.before)), origins_of(triangle, std::move(polygons.after))};
}

}  // namespace batten::core
