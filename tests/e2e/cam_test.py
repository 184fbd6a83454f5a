"""A cam with two exact dwells and flanks that continue their curvature, as docs/drawing/cam.md tells."""

import fractions
import math
import unittest

import spline
from session import SessionTest

LOW, HIGH = 20, 28  # radii of the dwells in millimeters
# The dwells: radius, where it begins, where it ends, in degrees, counterclockwise.
DWELLS = ((LOW, 200, 340), (HIGH, 60, 120))


class CamTest(SessionTest):
    page = "cam"

    def test_a_cam_is_drawn(self):
        self.begin()
        self.zoom_out()
        for dwell in DWELLS:
            self.draw_dwell(*dwell)
        self.picture("dwells")
        self.blend()
        self.join(self.save())
        (cam,) = self.save()
        self.check(cam)
        self.assert_told()
        self.undo_all()

    def at(self, radius, degrees):
        angle = math.radians(degrees)
        return self.place(radius * math.cos(angle), radius * math.sin(angle))

    def zoom_out(self):
        self.editor.move(*self.place(0, 0))
        while (zoom := self.editor.settle()["zoom"]) > 8:
            self.editor.wheel(-1)
            self.editor.wait(lambda state: state["zoom"] < zoom and state["is_settled"], "the turn of the wheel")

    def draw_dwell(self, radius, start, end):
        self.choose_tool("shape", "draw-arc")
        self.editor.move(*self.at(radius, start))
        self.type_place("0,0\n")
        self.type_place(f"{radius}<{start}\n")
        for angle in range(start, end + 1, 20):
            self.editor.move(*self.at(radius, angle))
        self.type_place(f"<{end}\n")

    def blend(self):
        (low, low_start, low_end), (high, high_start, high_end) = DWELLS
        self.choose_tool("joint", "click-to-blend")
        self.editor.key("2")
        pairs = ((self.at(low, low_end), self.at(high, high_start)), (self.at(high, high_end), self.at(low, low_start)))
        for one, other in pairs:
            self.editor.click(*one)
            self.editor.move(*other)
            self.editor.settle()
            if other is pairs[1][1]:
                self.picture("blend")
            self.editor.click(*other)
            self.editor.settle()

    def join(self, curves):
        """Each with the next one around, clicked beside the end that is meant."""
        low, high, rise, fall = curves
        self.choose_tool("joint", "click-to-join")
        self.editor.key("0")
        for before, after in ((low, rise), (rise, high), (high, fall)):
            self.editor.click(*self.place(*self.near(before, 0.9)))
            self.editor.click(*self.place(*self.near(after, 0.1)))
            self.wait_for_message("Joined with")
        self.editor.key("Escape")
        self.editor.click_widget("closed")
        self.wait_for_message("Closed curve; the curve is unchanged")
        self.run_typed("toggle-fill")
        self.rest()
        self.picture("cam")

    def near(self, curve, share):
        lower, upper = spline.domain_of(curve)
        return spline.point_at(curve, lower + share * (upper - lower))

    def check(self, cam):
        """Radii in exact arithmetic of the numbers in the file."""
        self.assertTrue(cam["periodic"])
        exact = spline.exact(cam)
        radii = {LOW: [], HIGH: [], None: []}
        angles = {LOW: 0, HIGH: 0}
        for span, lower, upper in spline.spans_of(exact):
            places = [spline.derivatives(exact, lower + (upper - lower) * fractions.Fraction(k, 8), span=span)[0] for k in range(9)]
            found = [math.hypot(x, y) for x, y in places]
            dwell = next((radius for radius in (LOW, HIGH) if abs(found[4] - radius) < 1e-6), None)
            # x^2 + y^2 - r^2 is exact; divided by 2 r it is how far the radius is off.
            radii[dwell] += [abs(float((x * x + y * y - dwell * dwell) / (2 * dwell))) for x, y in places] if dwell else found
            if dwell:
                angles[dwell] += spline.turn(*(math.atan2(y, x) for x, y in (places[0], places[-1])))
        for name, radius, start, end in (("low", *DWELLS[0]), ("high", *DWELLS[1])):
            self.assert_found(f"{name} dwell: how far the radius is off, mm", max(radii[radius]), 1e-12)
            self.assertAlmostEqual(math.degrees(angles[radius]), end - start, 9)
        self.assertEqual(len(radii[None]), 18, "two flanks")
        for flank, goes_up in ((radii[None][:9], True), (radii[None][9:], False)):
            self.assertEqual(flank, sorted(flank, reverse=not goes_up))
        joints = spline.jumps(cam)
        self.assert_found("gap at a joint, mm", max(gap for _, gap, _, _ in joints), 1e-12)
        self.assert_found("turn at a joint, rad", max(abs(turn) for _, _, turn, _ in joints), 1e-12)
        self.assert_found("jump of curvature at a joint, 1/mm", max(abs(jump) for _, _, _, jump in joints), 1e-12)
        self.assertGreater(min(spline.curvatures(cam)), 0)


if __name__ == "__main__":
    unittest.main()
