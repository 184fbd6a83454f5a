"""Drawing by a picture and tracing it, in the real window and measured in the saved file."""

import json
import math
import pathlib
import unittest

import spline
from case import WindowTest

PICTURES = pathlib.Path(__file__).parent.parent / "data" / "pictures"
EMPTY = {"format": "batten", "version": 1, "curves": []}


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
        # The length is what is left to be typed; what was clicked is told with a few digits.
        self.retype(editor, "form length", "32")
        for name in ("x1", "y1", "x2", "y2"):
            self.assertLessEqual(len(editor.state()["widgets"][f"form {name}"]["value"]), 9)
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
            for point in spline.samples(curve):
                self.assertLess(abs(math.dist(point, center) / scale - radius), 0.5)

    def test_a_width_is_in_the_unit_of_the_document(self):
        """A millimeter is 10 of the world."""
        self.path.write_text(json.dumps({**EMPTY, "units": {"unit": "mm", "scale": 10}}))
        editor = self.open_editor()
        self.file_dialog(editor, "choose-picture", "open-picture", PICTURES / "ring_gray.png")
        state = editor.wait(lambda state: "picture 0 width" in state["widgets"] and state["is_settled"], "the picture")
        shown = state["widgets"]["picture 0 width"]["value"]
        (picture,) = self.document(editor)["pictures"]
        self.assertAlmostEqual(float(shown.removesuffix(" mm")), picture["scale"] * 64 / 10, 2)
        editor.click_widget("picture 0 width")
        self.retype(editor, "picture 0 width", "2.54")
        editor.key("Return")
        editor.wait(lambda state: state["is_modified"] and state["is_settled"], "the new width")
        (picture,) = self.document(editor)["pictures"]
        self.assertAlmostEqual(picture["scale"] * 64, 25.4, 12)


if __name__ == "__main__":
    unittest.main()
