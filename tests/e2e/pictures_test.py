"""Drawing by a picture and tracing it, and curves from tables, in the real window and measured in the saved file."""

import json
import math
import pathlib
import unittest

from case import WindowTest

PICTURES = pathlib.Path(__file__).parent.parent / "data" / "pictures"
EMPTY = {"format": "batten", "version": 1, "curves": []}


def naca_2412(x, side):
    """By the formula of Jacobs, Ward and Pinkerton (1933), with a sharp trailing edge."""
    thickness = 0.6 * (0.2969 * math.sqrt(x) - 0.1260 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4)
    rear = 0.16 if x < 0.4 else 0.36
    camber = 0.02 / rear * ((0.8 * x if x < 0.4 else 0.2 + 0.8 * x) - x**2)
    angle = math.atan(0.04 / rear * (0.4 - x))
    return x - side * thickness * math.sin(angle), camber + side * thickness * math.cos(angle)


def value_at(curve, u):
    """The point of a curve without weights, by de Boor's algorithm; of a periodic one by its unrolled knots."""
    p, points, knots = curve["degree"], curve["points"], curve["knots"]
    if curve["periodic"]:
        n, period = len(points), knots[-1] - knots[0]
        unrolled = [knots[(k - p) % n] + period * ((k - p) // n) for k in range(n + 2 * p + 1)]
        points, knots = points + points[:p], unrolled
    k = max(i for i in range(p, len(points)) if knots[i] <= u and knots[i] < knots[i + 1])
    d = [points[k - p + j] for j in range(p + 1)]
    for r in range(1, p + 1):
        for j in range(p, r - 1, -1):
            a = (u - knots[k - p + j]) / (knots[k + 1 + j - r] - knots[k - p + j])
            d[j] = tuple((1 - a) * s + a * t for s, t in zip(d[j - 1], d[j]))
    return d[p]


def samples(curve, count=600):
    knots, p = curve["knots"], curve["degree"]
    start, end = (knots[0], knots[-1]) if curve["periodic"] else (knots[p], knots[-p - 1])
    return [value_at(curve, start + (end - start) * k / count) for k in range(count)]


class PicturesTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.path.write_text(json.dumps(EMPTY))

    def file_dialog(self, editor, menu_item, dialog, path):
        editor.click_widget("menu file")
        editor.click_widget(f"menu-item {menu_item}")
        editor.wait(lambda state: state["dialog"] == dialog and state["is_settled"], "the file dialog")
        editor.type(path)
        editor.wait(lambda state: state["widgets"]["file-dialog name"]["value"] == str(path), "the typed path")
        editor.key("Return")

    def wait_for_form(self, editor):
        return editor.wait(lambda state: state["dialog"] == "command-form" and "form apply" in state["widgets"] and state["is_settled"], "the form")

    def apply(self, editor):
        editor.click_widget("form apply")
        editor.wait(lambda state: state["dialog"] == "none" and state["is_modified"] and state["is_settled"], "the end of the form")

    def document(self, editor):
        self.save(editor)
        return json.loads(self.path.read_text())

    def save(self, editor):
        before = self.path.stat().st_ino
        editor.key("ctrl+s")
        editor.wait_until(lambda: self.path.stat().st_ino != before, "the saved file")
        editor.wait(lambda state: not state["is_modified"] and state["is_settled"], "the end of saving")

    def test_a_picture_is_added_scaled_and_traced(self):
        editor = self.open_editor()
        self.file_dialog(editor, "choose-picture", "open-picture", PICTURES / "ring_gray.png")
        editor.wait(lambda state: "picture 0 opacity" in state["widgets"] and state["is_settled"], "the picture")
        editor.screenshot("added")
        # Two points half of its height apart, of which the distance is said to be 32: a pixel is 1 then.
        editor.click_widget("picture 0 measure")
        canvas = editor.state()["canvas"]
        middle = canvas["x"] + canvas["width"] / 2, canvas["y"] + canvas["height"] / 2
        editor.click(middle[0] - 100, middle[1])
        editor.click(middle[0] + 100, middle[1])
        self.wait_for_form(editor)
        editor.screenshot("scaled")
        editor.key("Escape")
        editor.click_widget("menu make")
        editor.click_widget("menu-item trace-picture")
        state = self.wait_for_form(editor)
        self.assertIn("2 outlines", state["widgets"]["form effect"]["value"])
        editor.screenshot("tracing")
        self.apply(editor)
        editor.click_widget("picture 0 locked")
        document = self.document(editor)
        (picture,) = document["pictures"]
        self.assertTrue(picture["locked"])
        scale, (x, y) = picture["scale"], picture["position"]
        center = x + scale * 32.3, y + scale * (64 - 31.6)
        self.assertEqual(len(document["curves"]), 2)
        for curve, radius in zip(document["curves"], (24, 12)):
            self.assertLessEqual(len(curve["points"]), 12)
            for point in samples(curve):
                self.assertLess(abs(math.dist(point, center) / scale - radius), 0.5)

    def test_an_airfoil_from_a_table(self):
        table = self.folder / "naca2412.dat"
        stations = [0.5 * (1 - math.cos(math.pi * k / 50)) for k in range(51)]
        rows = [naca_2412(x, 1) for x in reversed(stations)] + [naca_2412(x, -1) for x in stations[1:]]
        table.write_text("NACA 2412\n" + "".join(f" {x:.7f} {y:.7f}\n" for x, y in rows))
        editor = self.open_editor()
        self.file_dialog(editor, "open-table", "open-table", table)
        state = self.wait_for_form(editor)
        self.assertIn("101 points in columns 1 and 2", state["widgets"]["form effect"]["value"])
        editor.click_widget("form ends")
        editor.click_widget("form ends corner")
        editor.screenshot("airfoil")
        self.apply(editor)
        (curve,) = self.document(editor)["curves"]
        self.assertEqual(curve["name"], "NACA 2412")
        self.assertEqual(curve["points"][0], curve["points"][-1])
        drawn = samples(curve, 20000)
        for k in range(1, 400):
            x = 0.5 * (1 - math.cos(math.pi * k / 400))
            for side in (1, -1):
                true = naca_2412(x, side)
                self.assertLess(min(math.dist(true, point) for point in drawn), 1e-4)


if __name__ == "__main__":
    unittest.main()
