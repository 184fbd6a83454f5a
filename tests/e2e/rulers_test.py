"""Rulers, units, guides out of the rulers, and the drawing mode in the real window."""

import json
import unittest

from case import WindowTest

RULER = 20  # design pixels


class RulersTest(WindowTest):
    def document(self, editor):
        self.save(editor)
        return json.loads(self.path.read_text())

    def type_keys(self, editor, text):
        names = {"\t": "Tab", "\n": "Return", ".": "period"}
        editor.key(*(names.get(c, c) for c in text))
        editor.settle()

    def open_ruled(self, **options):
        editor = self.open_editor(**options)
        canvas = editor.settle()["canvas"]
        self.choose_rulers(editor)
        after = editor.wait(lambda state: "rulers" in state["overlays"] and state["is_settled"], "the rulers")["canvas"]
        self.assertEqual((after["x"], after["y"]), (canvas["x"] + RULER, canvas["y"] + RULER))
        return editor

    def choose_rulers(self, editor):
        editor.click_widget("menu view")
        editor.click_widget("menu-item toggle-rulers")

    def place_of(self, canvas, x, y):
        return canvas["x"] + x, canvas["y"] + y

    def test_guides_come_out_of_the_rulers_and_go_back(self):
        editor = self.open_ruled()
        canvas = editor.settle()["canvas"]
        point = editor.point(2)
        editor.drag(self.place_of(canvas, 300, -RULER / 2), (point[0] + 2, point[1] + 2))
        guides = self.document(editor)["guides"]
        self.assertEqual(guides, [{"point": [-1.5, 3.5], "angle": 0}])
        editor.drag(self.place_of(canvas, -RULER / 2, 200), self.place_of(canvas, 100, 150), release=False)
        editor.screenshot("guides")
        editor.release()
        guides = self.document(editor)["guides"]
        self.assertEqual([guide["angle"] for guide in guides], [0, 90])
        editor.drag(self.place_of(canvas, 100, 60), self.place_of(canvas, -RULER / 2, 60))
        self.assertEqual(len(self.document(editor)["guides"]), 1)
        editor.key("ctrl+z")
        self.assertEqual(self.document(editor)["guides"], guides)

    def test_lengths_are_told_and_typed_in_the_unit(self):
        editor = self.open_ruled()
        canvas = editor.settle()["canvas"]
        editor.click(*self.place_of(canvas, -RULER / 2, -RULER / 2))
        editor.wait(lambda state: "form unit" in state["widgets"] and state["is_settled"], "the form")
        editor.click_widget("form unit")
        editor.click_widget("form unit mm")
        editor.wait(lambda state: state["has_preview"] and state["is_settled"], "the preview")
        editor.click_widget("form apply")
        state = editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the end of the form")
        self.assertEqual(state["widgets"]["ruler x"]["value"], "mm")
        x, y = editor.point(1)
        editor.drag((x, y), (x + 40, y - 20), release=False)
        editor.screenshot("millimeters")
        self.type_keys(editor, "1in\t0\n")
        editor.release()
        document = self.document(editor)
        self.assertEqual(document["units"], {"unit": "mm", "scale": 1})
        self.assertEqual(document["curves"][0]["points"][1], [-4.5 + 25.4, 2.5])

    def test_the_drawing_mode_hides_and_shows_again(self):
        editor = self.open_editor()
        before = editor.settle()
        self.assertGreater(before["plot"]["height"], 0)
        editor.key("m")
        bare = editor.wait(lambda state: "hull" not in state["overlays"] and state["is_settled"], "the drawing mode")
        for hidden in ("construction", "labels", "knots"):
            self.assertNotIn(hidden, bare["overlays"])
        self.assertIn("polygon", bare["overlays"])
        self.assertEqual(bare["plot"]["height"], 0)
        self.assertGreater(bare["canvas"]["height"], before["canvas"]["height"])
        editor.screenshot("bare")
        self.save(editor)
        editor.key("m")
        after = editor.wait(lambda state: "hull" in state["overlays"] and state["is_settled"], "its end")
        self.assertEqual(after["overlays"], before["overlays"])
        self.assertEqual(after["plot"], before["plot"])
        overlays = json.loads(self.path.read_text())["view"]["overlays"]
        self.assertEqual(sorted(overlays), sorted(before["overlays"]))


if __name__ == "__main__":
    unittest.main()
