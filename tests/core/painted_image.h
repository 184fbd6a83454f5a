/// Images of known shapes, each pixel as dark as it is covered.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "core/make/contours.h"

namespace batten::core {

using Outline = std::vector<Point>;

/// The part of a polygon on one side: where sign * coordinate <= sign * bound.
inline Outline cut(const Outline& polygon, int axis, double bound, double sign) {
    const auto depth = [&](Point p) { return sign * ((axis == 0 ? p.x : p.y) - bound); };
    Outline kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point a = polygon[i];
        const Point b = polygon[(i + 1) % polygon.size()];
        if (depth(a) <= 0.0) kept.push_back(a);
        if ((depth(a) < 0.0 && depth(b) > 0.0) || (depth(a) > 0.0 && depth(b) < 0.0))
            kept.push_back(a + depth(a) / (depth(a) - depth(b)) * (b - a));
    }
    return kept;
}

/// Outlines counterclockwise, holes clockwise, in the coordinates of contours(); each pixel is exactly as dark as it is
/// covered, rounded to one of 256 shades between `dark` and `light`.
inline GrayImage painted(int width, int height, const std::vector<Outline>& outlines, double dark = 0.0,
                         double light = 255.0) {
    GrayImage image{width, height, {}};
    for (int j = 0; j < height; ++j) {
        std::vector<Outline> rows;
        for (const Outline& outline : outlines)
            rows.push_back(cut(cut(outline, 1, height - j, 1.0), 1, height - j - 1, -1.0));
        for (int i = 0; i < width; ++i) {
            double covered = 0.0;
            for (const Outline& row : rows) covered += area_of(cut(cut(row, 0, i + 1, 1.0), 0, i, -1.0));
            image.values.push_back(static_cast<std::uint8_t>(std::lround(light + covered * (dark - light))));
        }
    }
    return image;
}

inline Outline arc(Point center, double radius, double from_degrees, double to_degrees, int count = 720) {
    Outline points;
    for (int k = 0; k <= count; ++k) {
        const double angle = (from_degrees + (to_degrees - from_degrees) * k / count) * std::numbers::pi / 180.0;
        points.push_back(center + radius * Vector(std::cos(angle), std::sin(angle)));
    }
    return points;
}

inline Outline circle_outline(Point center, double radius) {
    Outline points = arc(center, radius, 0.0, 360.0);
    points.pop_back();
    return points;
}

inline Outline reversed(Outline outline) {
    return {outline.rbegin(), outline.rend()};
}

/// The distance of a point to an outline.
inline double distance_to(const Outline& outline, Point point) {
    double least = 1e300;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point a = outline[i];
        const Vector side = outline[(i + 1) % outline.size()] - a;
        const double size = dot(side, side);
        const double along = size > 0.0 ? std::clamp(dot(point - a, side) / size, 0.0, 1.0) : 0.0;
        least = std::min(least, distance(point, a + along * side));
    }
    return least;
}

}  // namespace batten::core
