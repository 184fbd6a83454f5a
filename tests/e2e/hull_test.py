"""A hull section through given offsets with given end tangents, faired within 1 mm, as docs/drawing/hull.md tells."""

import math
import unittest

import spline
from session import SessionTest

# Half-breadths and heights in millimeters, taken off a model: none is true to better than half a millimeter.
OFFSETS = ((0, 0), (289, 81), (554, 163), (794, 251), (1011, 346), (1205, 451), (1378, 572), (1530, 708), (1661, 865),
           (1773, 1045), (1867, 1249), (1941, 1484), (2000, 1750))
# At keel and sheer: the direction in degrees, and a third of the way to the next offset as the length of the handle.
DEADRISE, FLARE = 15, 80
HANDLES = ((0, 100, DEADRISE), (len(OFFSETS) - 1, 90, FLARE))


class HullTest(SessionTest):
    page = "hull"

    def test_a_section_is_drawn_and_faired(self):
        self.begin()
        self.type_offsets()
        self.give_tangents()
        self.editor.key("c")
        (before,) = self.save()
        self.picture("offsets")
        self.fair()
        (after,) = self.save()
        self.rest()
        self.picture("faired")
        self.check(before, after)
        self.assert_told()
        self.undo_all()

    def type_offsets(self):
        self.choose_tool("draw-curve", "pen-through-c2")
        self.editor.move(*self.place(0, 0))
        for x, y in OFFSETS:
            self.type_place(f"{x},{y}\n")
        self.editor.key("Return")
        self.editor.wait(lambda state: state["curve_count"] == 1 and state["is_settled"], "the curve")
        self.editor.key("f")
        self.editor.settle()

    def give_tangents(self):
        for number, length, angle in HANDLES:
            self.editor.click(*self.place(*OFFSETS[number]), button=3)
            self.editor.click_widget("menu-item give-fit-point-tangent")
            self.wait_for_message(f"Set joint of fit point {number} to 'tangent given'")
            inner, end = (self.editor.settle()["points"][k] for k in ((1, 0) if number == 0 else (-2, -1)))
            outward = 1 if number == 0 else -1
            tip = (end["x"] + outward * (inner["x"] - end["x"]), end["y"] + outward * (inner["y"] - end["y"]))
            self.editor.drag(tip, (tip[0] + 30, tip[1] - 30), release=False)
            self.type_place(f"{length}<{angle}\n")
            self.editor.release()
            self.wait_for_message(f"Set handle of fit point {number}")

    def fair(self):
        self.choose("curve", "Shape", "fair")
        self.wait_for_form()
        self.fill("distance", "1")
        self.picture("fairing")
        self.apply()

    def check(self, before, after):
        drawn = spline.samples(after, 100)
        self.assert_found("farthest offset from the curve, mm", max(spline.distance_to_polyline(p, drawn) for p in OFFSETS), 1)
        for name, end, angle in (("keel", 0, DEADRISE), ("sheer", -1, FLARE)):
            span, lower, upper = spline.spans_of(after)[end]
            found, _ = spline.angle_and_curvature(after, upper if end else lower, span)
            self.assert_found(f"turn of the tangent from {angle} degrees at the {name}, rad", abs(spline.turn(math.radians(angle), found)), 1e-9)
        for name, curve, limit in (("before", before, 20), ("after", after, 3)):
            kappa = spline.curvatures(curve)
            rises = [later - earlier for earlier, later in zip(kappa, kappa[1:])]
            self.assert_found(f"inflections {name} fairing", spline.sign_changes(kappa), 0)
            self.assert_found(f"changes from rising to falling curvature {name} fairing", spline.sign_changes(rises, 1e-9), limit)
            self.assert_found(f"sum of all changes of curvature {name} fairing, 1/m", 1000 * spline.variation(kappa), 2)


if __name__ == "__main__":
    unittest.main()
