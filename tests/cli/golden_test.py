"""The reference results through the command line: the same answers, at the same accuracy, as from the library."""

import itertools
import json
import os
import pathlib
import tempfile
import unittest

from program import answer, run, write_document

GOLDEN = pathlib.Path(os.environ["BATTEN_GOLDEN"])
# What the reference calls them, and what the command line does.
PARAMETRIZATIONS = {"chord-length": "chordal", "centripetal": "centripetal"}
CURVE_MEMBERS = ("degree", "knots", "points", "weights")


def members_of(case):
    return {**{name: case[name] for name in CURVE_MEMBERS if name in case}, "tears": True}


def is_hard(case):
    """Whether degree or weights allow three digits less."""
    weights = case.get("weights", [1])
    return case["degree"] > 10 or max(weights) > 100 * min(weights)


def largest(values):
    return max(abs(value) for value in flat(values))


def flat(values):
    return list(itertools.chain.from_iterable(map(flat, values))) if isinstance(values, list) else [values]


def difference(found, expected):
    found, expected = flat(found), flat(expected)
    assert len(found) == len(expected), f"{len(found)} numbers instead of {len(expected)}"
    return max((abs(a - b) for a, b in zip(found, expected)), default=0.0)


class Golden(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.input = pathlib.Path(self.folder.name) / "in.json"
        self.output = pathlib.Path(self.folder.name) / "out.json"

    def each(self, name, check_case):
        """Checks every case of a file; says at the end how far the answers were from them."""
        self.worst = {}
        cases = json.loads((GOLDEN / f"{name}.json").read_text())["cases"]
        for case in cases:
            with self.subTest(case["name"]):
                if "points" in case:
                    write_document(self.input, members_of(case))
                check_case(case)
        figures = ", ".join(f"{quantity} {error:.1e}" for quantity, error in self.worst.items())
        print(f"golden {name} by the command line: {len(cases)} cases; worst errors: {figures or 'none'}")

    def check(self, case, quantity, found, expected, allowed, scale=None):
        scale = largest(expected) if scale is None else scale
        error = difference(found, expected)
        error = error / scale if scale else error
        self.worst[quantity] = max(self.worst.get(quantity, 0.0), error)
        self.assertLessEqual(error, allowed * (1000 if is_hard(case) else 1), quantity)

    def check_curve(self, case, found, expected, allowed):
        scale = largest(case["points"])
        self.assertEqual(found["degree"], expected["degree"])
        self.check(case, "points", found["points"], expected["points"], allowed, scale)
        self.check(case, "knots", found["knots"], expected["knots"], 1e-15)
        self.check(case, "weights", found["weights"], expected.get("weights", found["weights"]), allowed)

    def applied(self, *operations):
        """The curves after these operations."""
        process = run("apply", self.input, *operations, "-o", self.output)
        self.assertEqual(process.returncode, 0, process.stderr)
        return json.loads(self.output.read_text())["curves"]

    def finding(self, *operation):
        """The one row that a measure found."""
        (result,) = answer("apply", self.input, *operation)
        return result["findings"][0]

    def test_evaluate(self):
        self.each("evaluate", self.check_evaluate)

    def check_evaluate(self, case):
        allowed = (1e-14, 1e-12, 1e-10, 1e-10)
        at = case["at"]
        order = len(at[0]["derivatives"]) - 1
        rows = answer("eval", self.input, "--derivatives", order, *(f"--at={row['u']!r}" for row in at))
        self.assertEqual([row["u"] for row in rows], [row["u"] for row in at])
        found = [[row["point"], *row["derivatives"]] for row in rows]
        for r in range(order + 1):
            expected = [row["derivatives"][r] for row in at]
            scale = largest(case["points"]) if r == 0 else largest(expected)
            self.check(case, f"derivative {r}", [row[r] for row in found], expected, allowed[r], scale)

    def test_basis(self):
        self.each("basis", self.check_basis)

    def check_basis(self, case):
        degree = case["degree"]
        count = len(case["knots"]) - degree - 1
        write_document(self.input, {**members_of(case), "points": [[float(i), 0.0] for i in range(count)]})
        rows = answer("eval", self.input, "--basis", "--derivatives", degree, *(f"--at={row['u']!r}" for row in case["at"]))
        for row, place in zip(rows, case["at"], strict=True):
            self.assertEqual([function["index"] for function in row["functions"]], list(range(place["span"] - degree, place["span"] + 1)))
        for r in range(degree + 1):
            expected = [place["derivatives"][r] for place in case["at"]]
            found = [[function["N"][r] for function in row["functions"]] for row in rows]
            self.check(case, f"derivative {r}", found, expected, (1e-14, 1e-12)[r] if r < 2 else 1e-10)

    def test_knot_insertion(self):
        self.each("knot_insertion", self.check_knot_insertion)

    def check_knot_insertion(self, case):
        words = itertools.chain.from_iterable(("insert-knot", repr(u)) for u in case["insert"])
        (curve,) = self.applied(*words)
        self.check_curve(case, curve, case["result"], 1e-14)

    def test_bezier_decomposition(self):
        self.each("bezier_decomposition", self.check_bezier_decomposition)

    def check_bezier_decomposition(self, case):
        pieces = self.applied("bezier-pieces")
        self.assertEqual(len(pieces), len(case["segments"]))
        for piece, segment in zip(pieces, case["segments"]):
            p = case["degree"]
            knots = [segment["from"]] * (p + 1) + [segment["to"]] * (p + 1)
            self.check_curve(case, piece, {"degree": p, "knots": knots, **segment}, 1e-14)

    def test_degree_elevation(self):
        self.each("degree_elevation", self.check_degree_elevation)

    def check_degree_elevation(self, case):
        (curve,) = self.applied("elevate", case["by"])
        self.check_curve(case, curve, case["result"], 1e-12)

    def test_split(self):
        self.each("split", self.check_split)

    def check_split(self, case):
        left, right = self.applied("split", repr(case["u"]))
        self.check_curve(case, left, case["left"], 1e-14)
        self.check_curve(case, right, case["right"], 1e-14)

    def test_hodograph(self):
        self.each("hodograph", self.check_hodograph)

    def check_hodograph(self, case):
        _, hodograph = self.applied("derivative")
        expected = case["result"]
        if expected["degree"] == 0:
            # A constant derivative on each leg; a curve has at least degree 1 and says it twice.
            points = [point for point in expected["points"] for _ in range(2)]
            self.check(case, "points", hodograph["points"], points, 1e-12)
        else:
            self.check_curve({**case, "points": expected["points"]}, hodograph, expected, 1e-12)

    def test_curvature(self):
        self.each("curvature", self.check_curvature)

    def check_curvature(self, case):
        words = itertools.chain.from_iterable(("evaluate", repr(row["u"])) for row in case["at"])
        found = [result["findings"][-1]["curvature"] for result in answer("apply", self.input, *words)]
        self.check(case, "curvature", found, [row["curvature"] for row in case["at"]], 1e-10)

    def test_arc_length(self):
        self.each("arc_length", self.check_arc_length)

    def check_arc_length(self, case):
        (curve,) = answer("info", self.input)["curves"]
        self.check(case, "length", curve["length"], case["length"], 1e-12)

    def test_closest_point(self):
        self.each("closest_point", self.check_closest_point)

    def check_closest_point(self, case):
        found = self.finding("nearest", *(repr(x) for x in case["query"]))
        scale = largest([case["points"], case["query"]])
        self.check(case, "distance", found["distance"], case["distance"], 1e-14, scale)
        self.check(case, "point", found["point"], case["point"], 1e-7, scale)

    def test_conics(self):
        self.each("conics", self.check_conics)

    def check_conics(self, case):
        a, b = case["knots"][case["degree"]], case["knots"][len(case["points"])]
        rows = answer("eval", self.input, *(f"--at={a + (b - a) * k / 16!r}" for k in range(17)))
        size = largest(case["points"])
        for x, y in (row["point"] for row in rows):
            terms = [c * t for c, t in zip(case["implicit"], (x * x, x * y, y * y, x, y, 1))]
            scale = sum(abs(c) * size**n for c, n in zip(case["implicit"], (2, 2, 2, 1, 1, 0)))
            self.check(case, "equation", sum(terms), 0.0, 1e-14, scale)

    def test_interpolation(self):
        self.each("interpolation", self.check_interpolation)

    def check_interpolation(self, case):
        write_document(self.input)
        coordinates = ",".join(repr(x) for x in flat(case["through"]))
        parametrization = PARAMETRIZATIONS[case["parametrization"]]
        (curve,) = self.applied("interpolate", coordinates, case["degree"], parametrization)
        self.check_curve({**case, "points": case["through"]}, curve, case["result"], 1e-11)

    def test_knot_analysis(self):
        self.each("knot_analysis", self.check_knot_analysis)

    def check_knot_analysis(self, case):
        count = case["control_points"]
        write_document(self.input, {**members_of(case), "points": [[float(i), 0.0] for i in range(count)]})
        (curve,) = answer("info", self.input)["curves"]
        self.assertEqual(curve["points"], count)
        self.assertEqual(curve["segments"], case["segments"])
        self.assertEqual(curve["clamped"], case["clamped"])
        self.assertEqual(curve["uniform"], case["uniform"])
        found = [{"knot": knot["value"], **{name: knot[name] for name in ("multiplicity", "continuity")}}
                 for knot in curve["knots"] if "continuity" in knot]
        self.assertEqual(found, case["multiplicities"])


if __name__ == "__main__":
    unittest.main()
