"""A letter S whose outline is G2 everywhere, as docs/drawing/letter.md tells."""

import unittest

import spline
from session import SessionTest

# Where the outline is clicked, in units of the window; the other half is the same, turned.
HALF = ((2.65, 2.75), (2.05, 3.95), (0.1, 4.6), (-2.0, 3.85), (-2.45, 1.75), (-0.35, -0.6), (1.35, -1.75), (1.2, -3.1), (0, -3.6),
        (-1.25, -3.1), (-1.95, -2.3))
INSIDE = ((0, 4.1), (-2.1, 2.5), (0, 0), (2.1, -2.5), (0, -4.1), (2.2, 3.0), (-2.2, -3.0))
OUTSIDE = ((0, 2.5), (1.5, 1.5), (3, 1.5), (0, -2.5), (-1.5, -1.5), (-3, -1.5))


def cross(one, other):
    """Whether two legs cross."""
    def side(start, end, point):
        return (end[0] - start[0]) * (point[1] - start[1]) - (end[1] - start[1]) * (point[0] - start[0])

    return side(*one, other[0]) * side(*one, other[1]) < 0 and side(*other, one[0]) * side(*other, one[1]) < 0


class LetterTest(SessionTest):
    page = "letter"

    def test_an_s_is_drawn(self):
        self.begin()
        self.choose_tool("draw-curve", "pen-through-fair")
        places = [self.place(*place) for place in HALF] + [self.place(-x, -y) for x, y in HALF]
        for place in places:
            self.editor.click(*place)
        self.editor.move(places[0][0] + 3, places[0][1] + 2)
        self.picture("clicked")
        self.editor.click(*places[0])
        self.editor.wait(lambda state: state["curve_count"] == 1 and state["is_settled"], "the curve")
        self.editor.key("c")
        self.editor.settle()
        self.picture("comb")
        self.editor.key("c")
        self.run_typed("toggle-fill")
        (letter,) = self.save()
        self.picture("letter")
        self.check(letter)
        self.assert_told()
        self.undo_all()

    def check(self, letter):
        self.assertTrue(letter["periodic"])
        joints = spline.jumps(letter)
        self.assertEqual(len(joints), 2 * len(HALF), "a knot at each point, and the seam")
        self.assert_found("gap at a knot, the seam with them", max(gap for _, gap, _, _ in joints), 1e-12)
        self.assert_found("turn of the tangent at a knot, rad", max(abs(turn) for _, _, turn, _ in joints), 1e-12)
        self.assert_found("jump of curvature at a knot", max(abs(jump) for _, _, _, jump in joints), 1e-9)
        self.assert_found("inflections", spline.sign_changes(spline.curvatures(letter)), 4)
        drawn = spline.samples(letter, 12)[:-1]
        legs = list(zip(drawn, drawn[1:] + drawn[:1]))
        self.assert_found("crossings of the outline with itself",
                          sum(cross(one, other) for i, one in enumerate(legs) for other in legs[:i]), 0)
        for place in INSIDE:
            self.assertEqual(abs(spline.winding(drawn, place)), 1, place)
        for place in OUTSIDE:
            self.assertEqual(spline.winding(drawn, place), 0, place)
        turned = [(-x, -y) for x, y in drawn]
        self.assert_found("from the letter to itself, turned by 180 degrees", max(spline.distance_to_polyline(p, drawn + drawn[:1]) for p in turned), 0.02)


if __name__ == "__main__":
    unittest.main()
