"""The mathematics by which the window tests check saved files, on curves with known values."""

import fractions
import math
import unittest

import spline

QUARTER = {"degree": 2, "knots": [0, 0, 0, 1, 1, 1], "points": [[2, 0], [2, 2], [0, 2]], "weights": [1, math.sqrt(0.5), 1]}
# Two parabolas y = x(2 - x) and, from (1, 1) on, y = 1 - (x - 1)^2 / 4 twice as wide: C'' jumps, C' does not.
PARABOLAS = spline.exact({"degree": 2, "knots": [0, 0, 0, 1, 3, 3, 3], "points": [[0, 0], [0.5, 1], [2, 1], [3, 0]]})
RING = {"degree": 2, "knots": [0, 1, 2, 3, 4], "points": [[1, 1], [-1, 1], [-1, -1], [1, -1]], "periodic": True}


class SplineTest(unittest.TestCase):
    def test_a_quarter_of_a_circle_has_its_curvature_and_length(self):
        for k in range(5):
            (x, y), _ = spline.derivatives(QUARTER, k / 4, 1)
            self.assertAlmostEqual(math.hypot(x, y), 2, 14)
            angle, curvature = spline.angle_and_curvature(QUARTER, k / 4)
            self.assertAlmostEqual(spline.turn(math.atan2(y, x), angle), math.pi / 2, 14)
            self.assertAlmostEqual(curvature, 0.5, 13)
        self.assertAlmostEqual(spline.length(QUARTER), math.pi, 9)

    def test_a_jump_of_curvature_is_found_from_both_sides(self):
        ((u, gap, turn, jump),) = spline.jumps(PARABOLAS)
        self.assertEqual((u, gap, turn), (1, 0, 0))
        place, first, second = spline.derivatives(PARABOLAS, 1, 2, span=2)
        self.assertEqual((place, first, second), ((1, 1), (1, 0), (0, -2)))
        self.assertEqual(spline.derivatives(PARABOLAS, 1, 2)[2], (0, -0.5))
        self.assertEqual(jump, 1.5)

    def test_a_periodic_curve_returns_and_its_seam_counts(self):
        self.assertEqual(spline.domain_of(RING), (0, 4))
        self.assertEqual(spline.point_at(RING, 0), (0, 1))
        self.assertEqual(spline.point_at(RING, 4), (0, 1))
        self.assertEqual([u for u, *_ in spline.jumps(RING)], [1, 2, 3, 0])
        drawn = spline.samples(RING, 10)[:-1]
        self.assertEqual(spline.winding(drawn, (0, 0)), 1)
        self.assertEqual(spline.winding(drawn, (1, 1)), 0)
        self.assertAlmostEqual(spline.area(drawn), 10 / 3, 1)

    def test_fractions_stay_exact(self):
        x, y = spline.point_at(spline.exact({**QUARTER, "weights": [1, 1, 1]}), fractions.Fraction(1, 3))
        self.assertEqual((x, y), (fractions.Fraction(16, 9), fractions.Fraction(10, 9)))


if __name__ == "__main__":
    unittest.main()
