"""Times SciPy on the works that bench_speed shares with other languages, after comparing the answers:
scipy_speed.py SHARED_FOLDER WORKS OUT, where WORKS is a regular expression and OUT becomes a file like Google Benchmark's."""

import json
import pathlib
import re
import sys
import time

import numpy as np
from scipy import interpolate

DEGREE = 3


def spline(data):
    return interpolate.BSpline(data["knots"], data["points"].reshape(-1, 2), DEGREE)


def sorted_samples(data):
    curve = spline(data)
    return lambda: curve(data["parameters"])


def derivatives(data):
    curve = spline(data)
    parts = [curve, curve.derivative(1), curve.derivative(2)]
    return lambda: np.hstack([part(data["parameters"]) for part in parts])


def basis(data):
    return lambda: interpolate.BSpline.design_matrix(data["parameters"], data["knots"], DEGREE).data


def insert_knot(data):
    points = data["points"].reshape(-1, 2).T
    # FITPACK wants as many coefficients as knots.
    padded = [np.append(row, np.zeros(DEGREE + 1)) for row in points]
    u = float(data["knot"][0])

    def run():
        _, coefficients, _ = interpolate.insert(u, (data["knots"], padded, DEGREE))
        return np.array([row[: points.shape[1] + 1] for row in coefficients]).T

    return run


def interpolate_points(data):
    points = data["points"].reshape(-1, 2)
    return lambda: interpolate.make_interp_spline(data["parameters"], points, DEGREE, t=data["knots"]).c


# For each work what runs it, how many items it makes, and how far answers may differ, in parts of the largest number.
WORKS = {
    "sorted_samples": (sorted_samples, lambda data: len(data["parameters"]), 1e-13),
    "derivatives": (derivatives, lambda data: len(data["parameters"]), 1e-11),
    "basis": (basis, lambda data: len(data["parameters"]), 1e-13),
    "insert_knot": (insert_knot, lambda data: 1, 1e-13),
    "interpolate": (interpolate_points, lambda data: 1, 1e-12),
}


def seconds_of(run):
    """The least of five rounds, each of which takes a twentieth of a second or one run."""
    rounds = []
    times = 1
    while len(rounds) < 5:
        start = time.process_time()
        for _ in range(times):
            run()
        elapsed = time.process_time() - start
        if elapsed < 0.05 and not rounds:
            times = max(times + 1, int(times * min(10, 0.06 / max(elapsed, 1e-6))))
        else:
            rounds.append(elapsed / times)
    return min(rounds)


def main(shared, works, out):
    shared = pathlib.Path(shared)
    results = []
    for answer in sorted(shared.glob("**/answer")):
        work = str(answer.parent.relative_to(shared))
        if not re.search(works, work):
            continue
        make, items, tolerance = WORKS[work.split("/")[0]]
        data = {file.name: np.fromfile(file) for file in answer.parent.iterdir()}
        run = make(data)
        found = np.asarray(run()).ravel()
        expected = data["answer"]
        if found.shape != expected.shape or np.max(np.abs(found - expected)) > tolerance * np.max(np.abs(expected)):
            sys.exit(f"{work}: SciPy has another answer")
        results.append({"name": f"{work}/SciPy", "run_type": "iteration", "each": seconds_of(run) / items(data)})
    pathlib.Path(out).write_text(json.dumps({"benchmarks": results}))


if __name__ == "__main__":
    main(*sys.argv[1:])
