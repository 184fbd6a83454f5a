"""The joint tool in the real window: ends, sides and parts are clicked, keys choose the continuity."""

import json
import math
import unittest

import views
from case import WindowTest

CURVES = [
    {"name": "left", "degree": 1, "knots": [0, 0, 1, 1], "points": [[-5, 2], [-1, 2]]},
    {"name": "right", "degree": 2, "knots": [0, 0, 0, 1, 1, 1], "points": [[1, 3], [3, 4.5], [5, 3]]},
    {"name": "corner", "degree": 1, "knots": [0, 0, 1, 2, 2], "points": [[-5, -1], [3, -1], [3, -4]]},
    {"name": "bar", "degree": 1, "knots": [0, 0, 1, 1], "points": [[-3, 0], [-3, -3]]},
]


class JointsTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.path.write_text(json.dumps({"format": "batten", "version": 1, "curves": CURVES}))

    def take(self, editor, operation):
        editor.click_widget("tool joint")
        editor.wait(lambda state: f"menu-item click-to-{operation}" in state["widgets"] and state["is_settled"], "the operations")
        editor.screenshot(f"menu-{operation}")
        editor.click_widget(f"menu-item click-to-{operation}")
        editor.settle()

    def pixels(self, editor):
        """Where places of the world are: the ends of the first curve, which is active, are 4 apart."""
        (x0, y0), (x1, _) = editor.point(0), editor.point(1)
        scale = (x1 - x0) / 4
        return lambda x, y: (x0 + scale * (x + 5), y0 - scale * (y - 2))

    def curves(self, editor):
        self.save(editor)
        return {curve["name"]: curve for curve in json.loads(self.path.read_text())["curves"]}

    def test_two_ends_are_blended_with_the_continuity_of_a_key(self):
        editor = self.open_editor()
        at = self.pixels(editor)
        self.take(editor, "blend")
        editor.move(*at(-1.3, 2))
        editor.key("3")
        editor.click(*at(-1.3, 2))
        editor.move(*at(1.1, 3.05))
        editor.settle()
        editor.screenshot("blend")
        editor.click(*at(1.1, 3.05))
        editor.settle()
        blend = self.curves(editor)["left to right"]
        self.assertEqual(blend["degree"], 7)
        self.assertEqual((blend["points"][0], blend["points"][-1]), ([-1, 2], [1, 3]))
        # It leaves along the line without curvature, whose change is none: the first four points lie on it.
        for x, y in blend["points"][:4]:
            self.assertAlmostEqual(y, 2, 12)
            self.assertGreaterEqual(x, -1)

    def test_a_match_changes_one_curve_and_shows_what_jumps(self):
        editor = self.open_editor()
        at = self.pixels(editor)
        self.take(editor, "match")
        editor.click(*at(-1.3, 2))
        editor.move(*at(1.1, 3.05))
        editor.settle()
        editor.screenshot("match")
        self.assertTrue(any("gap" in label for label in editor.labels()), editor.labels())
        editor.click(*at(1.1, 3.05))
        editor.settle()
        curves = self.curves(editor)
        self.assertEqual(curves["right"]["points"], CURVES[1]["points"])
        self.assertEqual(curves["left"]["points"][-1], [1, 3])
        self.assertEqual(curves["left"]["points"][0], [-5, 2])

    def test_a_corner_is_rounded_and_a_part_trimmed(self):
        editor = self.open_editor()
        at = self.pixels(editor)
        self.take(editor, "fillet")
        editor.click(*at(1.5, -1))
        editor.move(*at(3, -2.6))
        editor.settle()
        editor.screenshot("fillet")
        editor.click(*at(3, -2.6))
        editor.settle()
        rounded = self.curves(editor)["corner"]
        self.assertEqual(rounded["degree"], 2)
        weights = set(round(w, 12) for w in rounded["weights"])
        self.assertEqual(weights, {1.0, round(math.sqrt(0.5), 12)})
        self.take(editor, "trim")
        editor.move(*at(-4, -1))
        editor.settle()
        editor.screenshot("trim")
        editor.click(*at(-4, -1))
        editor.settle()
        trimmed = self.curves(editor)["corner"]
        self.assertAlmostEqual(trimmed["points"][0][0], -3, 12)
        self.assertAlmostEqual(trimmed["points"][0][1], -1, 12)
        editor.key("Escape")
        self.assertEqual(editor.settle()["tool"], "select")

    def test_a_radius_is_dragged_out_of_a_corner_and_typed(self):
        editor = self.open_editor()
        at = self.pixels(editor)
        self.take(editor, "fillet")
        editor.move(*at(3, -1))
        editor.drag(at(3, -1), at(2.2, -1.6), release=False)
        editor.settle()
        editor.screenshot("radius")
        self.assertTrue(editor.state()["has_preview"])
        editor.key("0", "period", "5", "Return")
        editor.settle()
        editor.release()
        editor.settle()
        corner = self.curves(editor)["corner"]
        self.assertEqual(corner["degree"], 2)
        # The arc leaves the upper side at (2.5, -1) and arrives at (3, -1.5).
        for place in ([2.5, -1], [3, -1.5]):
            self.assertLess(min(math.dist(place, point) for point in corner["points"]), 1e-12)

    def test_the_list_of_joints_has_lines_for_turn_and_curvature(self):
        editor = self.open_editor()
        views.run_typed(editor, "check-joints 0.001")
        row = editor.wait(lambda state: "finding 0" in state["widgets"] and state["is_settled"], "the list")["widgets"]["finding 0"]
        editor.screenshot("list")
        self.assertIn("turn in degrees −90", row["value"])
        # In one line of the inspector there is room for the place and the gap only.
        self.assertGreater(row["height"], 50)

    def test_an_offset_is_dragged_out_of_a_curve(self):
        editor = self.open_editor()
        at = self.pixels(editor)
        editor.click_widget("tool joint")
        editor.wait(lambda state: "menu-item drag-to-offset" in state["widgets"] and state["is_settled"], "the operations")
        editor.click_widget("menu-item drag-to-offset")
        editor.settle()
        editor.move(*at(3, 3.75))
        editor.drag(at(3, 3.75), at(3, 4.4), release=False)
        editor.settle()
        editor.screenshot("offset")
        editor.key("period", "5", "Return")
        editor.settle()
        editor.release()
        editor.settle()
        offset = self.curves(editor)["offset of right"]
        (x0, y0), (x1, y1) = offset["points"][0], offset["points"][-1]
        self.assertAlmostEqual(math.hypot(x0 - 1, y0 - 3), 0.5, 9)
        self.assertAlmostEqual(math.hypot(x1 - 5, y1 - 3), 0.5, 9)


if __name__ == "__main__":
    unittest.main()
