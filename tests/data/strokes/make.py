#!/usr/bin/env python3
"""Makes strokes of a hand from known curves: make.py FOLDER [SEED] writes NAME.csv, the samples, NAME_truth.csv, the
curve every half pixel, and strokes.csv with what is true of each: corners, inflections, whether it is closed."""
import math
import pathlib
import random
import sys

HALF = 0.5


def along(curve, length_guess=4000):
    """Points every half pixel of a curve given over [0, 1]."""
    fine = [curve(k / (8 * length_guess)) for k in range(8 * length_guess + 1)]
    return walked(fine)


def walked(fine):
    """Points every half pixel of a polyline, and its vertices only if they are such."""
    points, gone = [fine[0]], 0.0
    for a, b in zip(fine, fine[1:]):
        step = math.dist(a, b)
        while step > 0 and gone + step >= HALF * len(points):
            t = (HALF * len(points) - gone) / step
            points.append((a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])))
        gone += step
    if math.dist(points[-1], fine[-1]) > 1e-9:
        points.append(fine[-1])
    return points


def bent(pieces, start=(60.0, 300.0), heading=0.0):
    """A path of pieces (length, curvature) with ("turn", degrees) between them for corners."""
    x, y = start
    fine = [(x, y)]
    for piece in pieces:
        if piece[0] == "turn":
            heading += math.radians(piece[1])
            continue
        length, curvature = piece
        steps = max(1, round(length / 0.05))
        for _ in range(steps):
            heading += 0.5 * curvature * length / steps
            x += math.cos(heading) * length / steps
            y += math.sin(heading) * length / steps
            heading += 0.5 * curvature * length / steps
            fine.append((x, y))
    return walked(fine)


def arc(radius, degrees):
    return (radius * math.radians(abs(degrees)), math.copysign(1 / radius, degrees))


def zigzag(r):
    k = r.randint(3, 7)
    pieces, side = [], 1
    for _ in range(k):
        pieces += [(r.uniform(50, 110), 0), ("turn", side * r.uniform(70, 140))]
        side = -side
    return bent(pieces + [(r.uniform(50, 110), 0)], (60, 200), math.radians(-side * 40)), k, 0, False


def rounded_square(r):
    side = r.uniform(90, 220)
    pieces = [(side / 2, 0)] + 3 * [arc(10, 90), (side, 0)] + [arc(10, 90), (side / 2, 0)]
    return bent(pieces), 0, 0, True


def square(r):
    side = r.uniform(90, 220)
    return bent([(side / 2, 0)] + 3 * [("turn", 90), (side, 0)] + [("turn", 90), (side / 2, 0)]), 4, 0, True


def polygon(r):
    k, side = r.randint(3, 5), r.uniform(70, 150)
    return bent((k - 1) * [(side, 0), ("turn", 360 / k)] + [(side, 0)]), k, 0, True


def ellipse(r):
    a, b, turn = r.uniform(60, 200), r.uniform(40, 120), r.uniform(0, 3)
    c, s = math.cos(turn), math.sin(turn)

    def at(t):
        u, v = a * math.cos(2 * math.pi * t), b * math.sin(2 * math.pi * t)
        return 400 + c * u - s * v, 300 + s * u + c * v
    return along(at), 0, 0, True


def waves(r):
    k, height = r.randint(2, 4), r.uniform(25, 60)
    return along(lambda t: (60 + 500 * t, 300 + height * math.sin(k * math.pi * t))), 0, k - 1, False


def spiral(r):
    turns, first = r.uniform(1.5, 3), r.uniform(12, 25)
    step = r.uniform(20, 40)
    return along(lambda t: (400 + (first + step * turns * t) * math.cos(2 * math.pi * turns * t),
                            300 + (first + step * turns * t) * math.sin(2 * math.pi * turns * t))), 0, 0, False


def loop(r):
    radius = r.uniform(18, 45)
    return bent([(120, 0.0), (80, 1 / (4 * radius)), arc(radius, 250), (80, 1 / (4 * radius)), (120, 0.0)]), 0, 0, False


def letter_e(r):
    size = r.uniform(13, 24)
    return bent([(1.8 * size, 0), ("turn", 100), arc(size, 290)], (200, 300), -0.1), 1, 0, False


def letter_s(r):
    size = r.uniform(35, 70)
    return bent([arc(size, 200), arc(1.3 * size, -215)], (300, 200), 3.0), 0, 1, False


def beside(r):
    """A sharp corner next to tight curves."""
    return bent([(80, 0), arc(15, 100), (30, 0), ("turn", -r.uniform(80, 125)), (25, 0), arc(14, 120), (70, 0)]), 1, 0, False


def retraced(r):
    back = r.uniform(120, 250)
    return bent([(back, 0), ("turn", 180), (0.7 * back, 0)], (200, 300), r.uniform(0, 3)), 1, 0, False


def line(r):
    return bent([(r.uniform(150, 600), 0)], (100, 100), r.uniform(-1, 1)), 0, 0, False


def part_of_circle(r):
    return bent([arc(r.uniform(60, 200), r.uniform(60, 250))], (300, 300), r.uniform(0, 6)), 0, 0, False


def free(r):
    """Curvature that changes smoothly, like a flourish."""
    knots = [r.uniform(-1, 1) / 35 for _ in range(7)]
    pieces, changes = [], sum(1 for a, b in zip(knots, knots[1:]) if a * b < 0)
    for a, b in zip(knots, knots[1:]):
        for k in range(40):
            t = (k + 0.5) / 40
            pieces.append((2.0, a + (b - a) * t))
    return bent(pieces, (300, 300), r.uniform(0, 6)), 0, changes, False


def drawn(truth, r, step, noise, whole, tremor, uneven, pause):
    """Samples of a hand that follows the curve."""
    phases = [(r.uniform(14, 40), r.uniform(0, 6.3), r.uniform(0, 6.3)) for _ in range(4)]
    samples, s = [], 0.0
    end = HALF * (len(truth) - 1)
    stops = int(pause > 0)
    while True:
        x, y = truth[min(len(truth) - 1, round(s / HALF))]
        for wave, p, q in phases:
            x += tremor * math.sin(2 * math.pi * s / wave + p) / 2
            y += tremor * math.sin(2 * math.pi * s / wave + q) / 2
        count = 1
        if stops and s > 0.4 * end:
            count, stops = pause, 0
        for _ in range(count):
            a, b = x + r.gauss(0, noise), y + r.gauss(0, noise)
            samples.append((round(a), round(b)) if whole else (round(a, 2), round(b, 2)))
        if s >= end:
            return samples
        speed = 1.0 if not uneven else math.exp(1.1 * math.sin(2 * math.pi * s / 170 + phases[0][1]))
        s = min(end, s + step * speed * r.uniform(0.7, 1.3))


SHAPES = {f.__name__: f for f in (zigzag, rounded_square, square, polygon, ellipse, waves, spiral, loop, letter_e,
                                  letter_s, beside, retraced, line, part_of_circle, free)}
HANDS = {
    "gauss": dict(step=3, noise=0.7, whole=False, tremor=0, uneven=False, pause=0),
    "whole": dict(step=2, noise=0.0, whole=True, tremor=0, uneven=False, pause=0),
    "tremor": dict(step=2, noise=0.0, whole=True, tremor=0.8, uneven=False, pause=0),
    "uneven": dict(step=3, noise=0.6, whole=True, tremor=0, uneven=True, pause=0),
    "pause": dict(step=2.5, noise=0.7, whole=True, tremor=0, uneven=False, pause=300),
    "slow": dict(step=0.5, noise=0.5, whole=True, tremor=0.4, uneven=True, pause=0),
}
STORED = [("line", "gauss"), ("part_of_circle", "tremor"), ("letter_s", "gauss"), ("spiral", "gauss"),
          ("zigzag", "gauss"), ("rounded_square", "whole"), ("ellipse", "tremor"), ("loop", "pause"),
          ("letter_e", "whole"), ("beside", "whole"), ("waves", "uneven"), ("retraced", "slow")]


def write(folder, pairs, seed):
    facts = ["name,corners,inflections,closed"]
    for shape, hand in pairs:
        r = random.Random(f"{shape} {hand} {seed}")
        truth, corners, inflections, closed = SHAPES[shape](r)
        samples = drawn(truth, r, **HANDS[hand])
        name = f"{shape}_{hand}"
        for file, points in ((name, samples), (name + "_truth", truth)):
            (folder / f"{file}.csv").write_text("".join(f"{x:.6g},{y:.6g}\n" for x, y in points))
        facts.append(f"{name},{corners},{inflections},{int(closed)}")
    (folder / "strokes.csv").write_text("\n".join(facts) + "\n")


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    everything = [(shape, hand) for shape in SHAPES for hand in HANDS]
    write(folder, everything if len(sys.argv) > 2 else STORED, sys.argv[2] if len(sys.argv) > 2 else "stored")
