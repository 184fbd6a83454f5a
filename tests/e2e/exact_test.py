"""Exact drawing in the real window: numbers typed in the middle of a drag, places snapped to, shapes drawn by clicks and numbers."""

import json
import math
import unittest

from case import WindowTest


class ExactTest(WindowTest):
    def type_place(self, editor, text):
        """Types characters one after the other; xdotool's `type` would not press Tab and Enter as keys."""
        names = {"\t": "Tab", "\n": "Return", ".": "period", ",": "comma", "@": "at", "<": "less", "-": "minus"}
        editor.key(*(names.get(c, c) for c in text))
        editor.settle()

    def curves(self, editor):
        self.save(editor)
        return json.loads(self.path.read_text())["curves"]

    def test_digits_in_a_drag_set_length_and_angle(self):
        editor = self.open_editor()
        x, y = editor.point(1)
        editor.drag((x, y), (x + 40, y - 20), release=False)
        self.type_place(editor, "12.5\t30")
        editor.screenshot("typed")
        self.assertTrue(editor.state()["has_preview"] if "has_preview" in editor.state() else True)
        self.type_place(editor, "\n")
        editor.release()
        found = self.curves(editor)[0]["points"][1]
        self.assertAlmostEqual(found[0], -4.5 + 12.5 * math.cos(math.radians(30)), 13)
        self.assertAlmostEqual(found[1], 2.5 + 6.25, 13)
        editor.key("ctrl+z")
        self.assertEqual(self.curves(editor)[0]["points"][1], [-4.5, 2.5])

    def test_escape_drops_the_number_before_the_drag(self):
        editor = self.open_editor()
        x, y = editor.point(1)
        editor.drag((x, y), (x + 40, y), release=False)
        self.type_place(editor, "x3")
        editor.key("Escape")
        editor.key("Escape")
        editor.release()
        self.assertFalse(editor.settle()["is_modified"])

    def test_a_point_snaps_to_another_and_alt_lets_go(self):
        editor = self.open_editor()
        target = editor.point(4)
        editor.drag(editor.point(3), (target[0] + 5, target[1] + 4), release=False)
        self.assertIn("P₄", editor.labels())
        editor.screenshot("snapped")
        editor.release()
        self.assertEqual(self.curves(editor)[0]["points"][3], [2.5, -3.25])

    def test_points_of_a_new_curve_are_typed(self):
        editor = self.open_editor()
        canvas = editor.settle()["canvas"]
        editor.move(canvas["x"] + canvas["width"] / 2, canvas["y"] + canvas["height"] / 2)
        editor.key("n")
        editor.move(canvas["x"] + canvas["width"] / 2 + 9, canvas["y"] + canvas["height"] / 2)
        for place in ("3,4\n", "@10,5\n", "10<90\n"):
            self.type_place(editor, place)
        editor.screenshot("drawing")
        editor.key("Return")
        editor.settle()
        self.assertEqual(self.curves(editor)[-1]["fit"]["points"], [[3, 4], [13, 9], [13, 19]])

    def test_the_key_of_the_number_pad_begins_decimals(self):
        """Whatever it prints: in many layouts that is a comma."""
        editor = self.open_editor()
        start = editor.point(1)
        editor.drag(start, (start[0] + 40, start[1]), release=False)
        editor.key("x", "2", "KP_Decimal", "5", "Tab", "0", "KP_Decimal", "2", "5")
        editor.settle()
        editor.screenshot("number-pad")
        editor.key("Return")
        editor.release()
        self.assertEqual(self.curves(editor)[0]["points"][1], [-4.5 + 2.5, 2.5 + 0.25])

    def test_a_circle_is_drawn_with_a_typed_radius(self):
        editor = self.open_editor()
        editor.click_widget("tool shape")
        editor.wait(lambda state: "menu-item draw-circle" in state["widgets"] and state["is_settled"], "the shapes")
        editor.screenshot("shapes")
        editor.click_widget("menu-item draw-circle")
        editor.settle()
        canvas = editor.settle()["canvas"]
        middle = canvas["x"] + canvas["width"] / 2, canvas["y"] + canvas["height"] / 2
        editor.move(*middle)
        self.type_place(editor, "1,2\n")
        editor.move(middle[0] + 60, middle[1] + 30)
        self.type_place(editor, "2.5")
        editor.screenshot("circle")
        self.type_place(editor, "\n")
        circle = self.curves(editor)[-1]
        self.assertEqual(circle["points"][0], [3.5, 2])
        self.assertEqual(circle["points"][4], [-1.5, 2])

    def test_numbers_change_what_is_there_and_show_their_own_digits(self):
        editor = self.open_editor()
        for typed, wanted in (("+=1/4", -1.25), ("*=-2", 2.5), ("-=2.49874", 0.00126)):
            editor.click_widget("point 2 x")
            self.retype(editor, "point 2 x", typed)
            editor.key("Return")
            editor.settle()
            self.assertAlmostEqual(self.curves(editor)[0]["points"][2][0], wanted, 15)
        self.assertEqual(editor.settle()["widgets"]["point 2 x"]["value"], "0.00126")

    def test_a_form_changes_what_it_began_with_and_leaves_the_canvas_free(self):
        editor = self.open_editor()
        self.choose(editor, "make", "Shapes", "circle")
        state = editor.wait(lambda state: "form radius" in state["widgets"] and state["is_settled"], "the form")
        canvas, form = state["canvas"], state["widgets"]["dialog"]
        self.assertGreater(form["x"], canvas["x"] + 0.9 * canvas["width"])
        radius = float(state["widgets"]["form radius"]["value"])
        editor.click_widget("form radius")
        self.retype(editor, "form radius", "*=1.5")
        editor.wait(lambda state: state["has_preview"] and state["is_settled"], "the preview")
        editor.key("Return")
        editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the end of the form")
        points = self.curves(editor)[-1]["points"]
        self.assertAlmostEqual(points[0][0] - points[4][0], 3 * radius, 14)

    def test_kinds_are_switched_by_the_magnet(self):
        editor = self.open_editor()
        editor.click_widget("tool-bar set-snap")
        editor.wait(lambda state: "menu-item toggle-snap-grid" in state["widgets"] and state["is_settled"], "the kinds")
        editor.screenshot("kinds")
        # Several are switched one after another.
        editor.click_widget("menu-item toggle-snap-grid")
        editor.click_widget("menu-item toggle-snap-knots")
        editor.click_widget("menu-item toggle-snap-knots")
        editor.key("Escape")
        editor.wait(lambda state: "menu-item toggle-snap-grid" not in state["widgets"] and state["is_settled"], "the end of the menu")
        start = editor.point(3)
        editor.drag(start, (start[0] + 43, start[1] - 31))
        x, y = self.curves(editor)[0]["points"][3]
        self.assertAlmostEqual(x * 10 % 1, 0, 9)
        self.assertAlmostEqual(y * 10 % 1, 0, 9)


if __name__ == "__main__":
    unittest.main()
