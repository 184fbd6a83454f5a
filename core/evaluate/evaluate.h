/// Points and derivatives of a curve.
#pragma once

#include <cassert>
#include <optional>

#include "core/base/detail/short_list.h"
#include "core/curve/curve.h"

namespace batten::core {

/// A point of a curve and how the curve goes on there.
struct Jet {
    Point point{};                       ///< C(u)
    ShortList<Vector, 3> derivatives{};  ///< C'(u), C''(u), ...

    /// C^(k)(u), k >= 1.
    const Vector& operator[](std::size_t k) const {
        assert(1 <= k && k <= derivatives.size());
        return derivatives[k - 1];
    }

    bool operator==(const Jet&) const = default;
};

/// C(u); u is clamped to the domain (wrapped when periodic). At the ends of a clamped curve bit-equal to the end point.
/// Cost O(p^2 + log n); no allocation. Source: de Boor 1972.
Point point_at(const Curve& curve, double u, Side side = Side::right);

/// C(u) and C'(u), ..., C^(order)(u) of the rational curve, order >= 0, seen from `side` at a knot. Where `u` is an end
/// of the domain of an open curve the side is the one inside. Cost O(min(order, p) p^2 + order^2 + log n); no
/// allocation up to order 3. Source: The NURBS
/// Book, equations 3.8 (derivatives of control points) and 4.8 (A4.2).
Jet derivatives_at(const Curve& curve, double u, int order, Side side = Side::right);

/// The signed curvature det(C', C'') / |C'|^3, positive where the curve turns left; none at zero speed, which is a
/// speed too small to be told from zero in doubles, given the control points of the span.
std::optional<double> curvature_at(const Curve& curve, double u, Side side = Side::right);

}  // namespace batten::core
