"""The little of spline mathematics that checking saved files takes, written independently of the program."""

import math


def span_of(degree, knots, count, u):
    last = max(i for i in range(degree, count) if knots[i] < knots[i + 1])
    return next((i for i in range(degree, count) if knots[i] <= u < knots[i + 1]), last)


def point_at(curve, u):
    """The point of the curve (a member of "curves" in a file) at u, by de Boor's algorithm."""
    degree, knots = curve["degree"], curve["knots"]
    weights = curve.get("weights") or [1.0] * len(curve["points"])
    span = span_of(degree, knots, len(curve["points"]), u)
    level = [(x * w, y * w, w) for (x, y), w in zip(curve["points"], weights)][span - degree:span + 1]
    for r in range(1, degree + 1):
        alphas = [(u - knots[i]) / (knots[i + degree - r + 1] - knots[i]) for i in range(span - degree + r, span + 1)]
        level = [tuple((1 - a) * p + a * q for p, q in zip(level[j], level[j + 1])) for j, a in enumerate(alphas)]
    x, y, w = level[0]
    return x / w, y / w


def size_of(curve):
    return max(abs(value) for point in curve["points"] for value in point)


def largest_deviation(one, other, samples=500):
    """The largest distance between two curves with the same domain, compared at equal parameters."""
    lower, upper = one["knots"][one["degree"]], one["knots"][len(one["points"])]
    worst = 0.0
    for i in range(samples + 1):
        u = lower + (upper - lower) * i / samples
        (x0, y0), (x1, y1) = point_at(one, u), point_at(other, u)
        worst = max(worst, abs(x1 - x0), abs(y1 - y0))
    return worst


def chord_length(curve, lower, upper, pieces):
    points = [point_at(curve, lower + (upper - lower) * i / pieces) for i in range(pieces)] + [point_at(curve, upper)]
    return sum(math.dist(p, q) for p, q in zip(points, points[1:]))


def length(curve, pieces=500):
    """The length over the domain: for each span two sums of chords, extrapolated."""
    domain = curve["knots"][curve["degree"]:len(curve["points"]) + 1]
    spans = [(lower, upper) for lower, upper in zip(domain, domain[1:]) if lower < upper]
    return sum((4 * chord_length(curve, *span, 2 * pieces) - chord_length(curve, *span, pieces)) / 3 for span in spans)
