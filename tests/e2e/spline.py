"""The little of spline mathematics that checking saved files takes, written independently of the program.

Basis functions by their recurrence; numbers may be floats or fractions, in the curve as in the parameter.
"""

import fractions
import math

CURVATURE_NEEDS = 2


def exact(curve):
    """The same curve with fractions for its numbers, in which everything but roots is computed without rounding."""
    numbers = {name: [fractions.Fraction(value) for value in curve[name]] for name in ("knots", "weights") if curve.get(name)}
    return {**curve, **numbers, "points": [[fractions.Fraction(value) for value in point] for point in curve["points"]]}


def unrolled(curve):
    """Knots and points of the open curve that a periodic one draws; those of an open one as they are."""
    degree, knots, points = curve["degree"], curve["knots"], curve["points"]
    weights = curve.get("weights") or [1] * len(points)
    if curve.get("periodic"):
        count, period = len(points), knots[-1] - knots[0]
        knots = [knots[(k - degree) % count] + period * ((k - degree) // count) for k in range(count + 2 * degree + 1)]
        points, weights = points + points[:degree], weights + weights[:degree]
    return degree, knots, points, weights


def domain_of(curve):
    degree, knots, points, _ = unrolled(curve)
    return knots[degree], knots[len(points)]


def spans_of(curve):
    """The spans of the domain that are not empty: (index, lower, upper)."""
    degree, knots, points, _ = unrolled(curve)
    return [(i, knots[i], knots[i + 1]) for i in range(degree, len(points)) if knots[i] < knots[i + 1]]


def span_at(curve, u):
    """The index of the span that ends at u or holds it; of two that meet there the later one."""
    spans = spans_of(curve)
    return next((index for index, lower, upper in reversed(spans) if lower <= u), spans[0][0])


def basis(degree, knots, span, u, order):
    """For d to `order` the d-th derivatives of the basis functions span - degree to span, as the span has them."""
    known = {}

    def value(i, p, d):
        if p == 0:
            return int(i == span and d == 0)
        if (i, p, d) not in known:
            left, right = knots[i + p] - knots[i], knots[i + p + 1] - knots[i + 1]
            total = 0
            if left > 0:
                total += (p * value(i, p - 1, d - 1) if d else (u - knots[i]) * value(i, p - 1, 0)) / left
            if right > 0:
                total += (-p * value(i + 1, p - 1, d - 1) if d else (knots[i + p + 1] - u) * value(i + 1, p - 1, 0)) / right
            known[i, p, d] = total
        return known[i, p, d]

    return [[value(i, degree, d) for i in range(span - degree, span + 1)] for d in range(order + 1)]


def derivatives(curve, u, order=0, span=None):
    """The point at u and its derivatives; those of a given span also where it ends."""
    degree, knots, points, weights = unrolled(curve)
    span = span_at(curve, u) if span is None else span
    acting = list(zip(points, weights))[span - degree:span + 1]
    lifted = [[sum(n * f(p, w) for n, (p, w) in zip(row, acting)) for f in (lambda p, w: p[0] * w, lambda p, w: p[1] * w, lambda p, w: w)]
              for row in basis(degree, knots, span, u, order)]
    found = []
    for d, (x, y, _) in enumerate(lifted):
        for k in range(1, d + 1):
            binomial = math.comb(d, k) * lifted[k][2]
            x, y = x - binomial * found[d - k][0], y - binomial * found[d - k][1]
        found.append((x / lifted[0][2], y / lifted[0][2]))
    return found


def point_at(curve, u):
    return derivatives(curve, u)[0]


def angle_and_curvature(curve, u, span=None):
    _, (dx, dy), (ddx, ddy) = derivatives(curve, u, CURVATURE_NEEDS, span)
    return math.atan2(dy, dx), (dx * ddy - dy * ddx) / math.hypot(dx, dy) ** 3


def turn(one, other):
    """The angle from one direction to another, from -pi to pi."""
    return math.remainder(other - one, 2 * math.pi)


def jumps(curve):
    """At each inner knot, and at the seam of a curve that returns: (u, gap, turn, jump of curvature)."""
    spans = spans_of(curve)
    pairs = list(zip(spans, spans[1:]))
    first, last = derivatives(curve, spans[0][1], span=spans[0][0])[0], derivatives(curve, spans[-1][2], span=spans[-1][0])[0]
    if math.dist(first, last) < 1e-9 * size_of(curve):
        pairs.append((spans[-1], spans[0]))
    return [(after[1], *jump((curve, before[2], before[0]), (curve, after[1], after[0]))) for before, after in pairs]


def jump(before, after):
    """Gap, turn and jump of curvature between two ends (curve, u, span)."""
    gap = math.dist(*(derivatives(curve, u, span=span)[0] for curve, u, span in (before, after)))
    (angle, curvature), (next_angle, next_curvature) = (angle_and_curvature(*end) for end in (before, after))
    return gap, turn(angle, next_angle), next_curvature - curvature


def samples(curve, for_each_span=50):
    """Points in every span, its ends with them."""
    found = []
    for span, lower, upper in spans_of(curve):
        found += [derivatives(curve, lower + (upper - lower) * k / for_each_span, span=span)[0] for k in range(for_each_span)]
    return found + [derivatives(curve, upper, span=span)[0]]


def curvatures(curve, for_each_span=50):
    """The curvature in every span, its ends with them, along the curve."""
    return [angle_and_curvature(curve, lower + (upper - lower) * k / for_each_span, span)[1]
            for span, lower, upper in spans_of(curve) for k in range(for_each_span + 1)]


def sign_changes(values, tolerance=0.0):
    """How often the sign changes among values larger than the tolerance."""
    signs = [value > 0 for value in values if abs(value) > tolerance]
    return sum(one != other for one, other in zip(signs, signs[1:]))


def variation(values):
    return sum(abs(other - one) for one, other in zip(values, values[1:]))


def distance_to_leg(point, start, end):
    direction = end[0] - start[0], end[1] - start[1]
    square = direction[0] ** 2 + direction[1] ** 2
    along = 0.0
    if square > 0:
        along = ((point[0] - start[0]) * direction[0] + (point[1] - start[1]) * direction[1]) / square
    along = min(1.0, max(0.0, along))
    return math.dist(point, (start[0] + along * direction[0], start[1] + along * direction[1]))


def distance_to_polyline(point, polyline):
    return min(distance_to_leg(point, start, end) for start, end in zip(polyline, polyline[1:]))


def size_of(curve):
    return max(abs(value) for point in curve["points"] for value in point)


def largest_deviation(one, other, count=500):
    """The largest distance between two curves with the same domain, compared at equal parameters."""
    lower, upper = domain_of(one)
    worst = 0.0
    for i in range(count + 1):
        u = lower + (upper - lower) * i / count
        (x0, y0), (x1, y1) = point_at(one, u), point_at(other, u)
        worst = max(worst, abs(x1 - x0), abs(y1 - y0))
    return worst


def chord_length(points):
    return sum(math.dist(p, q) for p, q in zip(points, points[1:]))


def length(curve, pieces=500):
    """The length over the domain: for each span two sums of chords, extrapolated."""
    return (4 * chord_length(samples(curve, 2 * pieces)) - chord_length(samples(curve, pieces))) / 3


def area(points):
    """What a closed polyline encloses, positive where it runs counterclockwise."""
    return sum(x0 * y1 - x1 * y0 for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1])) / 2


def winding(polyline, point):
    """How often a closed polyline runs around a point."""
    angles = [math.atan2(y - point[1], x - point[0]) for x, y in polyline + polyline[:1]]
    return round(sum(turn(one, other) for one, other in zip(angles, angles[1:])) / (2 * math.pi))
