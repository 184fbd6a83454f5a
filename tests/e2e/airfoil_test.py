"""The airfoil NACA 2412 from a table of its points, as docs/drawing/airfoil.md tells."""

import math
import unittest

import spline
from session import SessionTest

STATIONS = 50  # of the table, along each side
FINE = 400  # of the check


def naca_2412(x, side):
    """By the formula of Jacobs, Ward and Pinkerton (1933), with the last coefficient that closes the trailing edge."""
    thickness = 0.6 * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)
    rear = 0.16 if x < 0.4 else 0.36
    camber = 0.02 / rear * ((0.8 * x if x < 0.4 else 0.2 + 0.8 * x) - x**2)
    angle = math.atan(0.04 / rear * (0.4 - x))
    return x - side * thickness * math.sin(angle), camber + side * thickness * math.cos(angle)


def outline(count):
    """Once around from the trailing edge over the upper side, closer together at both edges."""
    stations = [0.5 * (1 - math.cos(math.pi * k / count)) for k in range(count + 1)]
    return [naca_2412(x, 1) for x in reversed(stations)] + [naca_2412(x, -1) for x in stations[1:]]


class AirfoilTest(SessionTest):
    page = "airfoil"

    def test_an_airfoil_is_made_of_a_table(self):
        table = self.folder / "naca2412.dat"
        table.write_text("NACA 2412\n" + "".join(f" {x:.7f} {y:.7f}\n" for x, y in outline(STATIONS)))
        self.begin()
        self.choose("file", "open-table")
        self.type_path("open-table", table)
        self.wait_for_form()
        self.editor.click_widget("form ends")
        self.editor.click_widget("form ends corner")
        self.editor.settle()
        self.picture("table")
        self.apply()
        (foil,) = self.save()
        self.look()
        self.check(foil)
        self.assert_told()
        self.undo_all()

    def look(self):
        self.run_typed("toggle-knots")
        self.editor.key("c")
        self.picture("comb")

    def check(self, foil):
        self.assertEqual(foil["name"], "NACA 2412")
        self.assertEqual(foil["points"][0], foil["points"][-1])
        self.assertEqual(foil["points"][0], [1, 0])
        true, drawn = outline(FINE), spline.samples(foil, 20)
        self.assert_found("largest distance of the formula from the curve", max(spline.distance_to_polyline(p, drawn) for p in true), 1e-4)
        self.assert_found("largest distance of the curve from the formula", max(spline.distance_to_polyline(p, true) for p in drawn), 1e-4)
        jumps = [abs(jump) for _, _, _, jump in spline.jumps(foil)[:-1]]
        self.assert_found("largest jump of curvature at a knot", max(jumps), 1e-6)


if __name__ == "__main__":
    unittest.main()
