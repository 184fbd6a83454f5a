"""The transform box in the real window: handles dragged, numbers typed in mid-drag, the pivot, and axes chosen by clicks."""

import json
import unittest

from case import WindowTest

MARGIN = 12  # design pixels from the control points to the handles
BEYOND = 15  # from a corner to the handle that turns


class TransformTest(WindowTest):
    def type_keys(self, editor, text):
        names = {"\t": "Tab", "\n": "Return", ".": "period", "%": "percent", "-": "minus"}
        editor.key(*(names.get(c, c) for c in text))
        editor.settle()

    def curves(self, editor):
        self.save(editor)
        return json.loads(self.path.read_text())["curves"]

    def box(self, editor):
        """Left, top, right and bottom of the control points in the window."""
        places = [editor.point(i) for i in range(7)]
        xs, ys = [x for x, _ in places], [y for _, y in places]
        return min(xs), min(ys), max(xs), max(ys)

    def begin(self):
        editor = self.open_editor()
        editor.key("r")
        editor.wait(lambda state: state["tool"] == "transform" and state["is_settled"], "the tool")
        return editor

    def test_a_side_is_scaled_by_a_typed_percentage_in_one_step(self):
        editor = self.begin()
        left, top, right, bottom = self.box(editor)
        handle = right + MARGIN, (top + bottom) / 2
        editor.drag(handle, (handle[0] - 60, handle[1]), release=False)
        editor.screenshot("scaling")
        self.type_keys(editor, "200%\n")
        editor.release()
        points = self.curves(editor)[0]["points"]
        self.assertEqual(points[0], [-6, -2.25])
        self.assertEqual(points[6], [18.5, 2.75])  # 12.25 from the left side, twice
        editor.key("ctrl+z")
        self.assertEqual(self.curves(editor)[0]["points"][6], [6.25, 2.75])

    def test_it_is_turned_about_a_pivot_on_a_point(self):
        editor = self.begin()
        left, top, right, bottom = self.box(editor)
        editor.drag(((left + right) / 2, (top + bottom) / 2), editor.point(0))
        editor.screenshot("pivot")
        left, top, right, bottom = self.box(editor)
        handle = right + MARGIN + BEYOND, top - MARGIN - BEYOND
        editor.drag(handle, (handle[0] - 30, handle[1] - 30), release=False)
        editor.screenshot("turning")
        self.type_keys(editor, "90\n")
        editor.release()
        points = self.curves(editor)[0]["points"]
        self.assertEqual(points[0], [-6, -2.25])
        self.assertEqual(points[6], [-11, 10])  # from (12.25, 5) to (-5, 12.25)

    def test_a_drag_of_the_inside_moves_and_escape_restores(self):
        editor = self.begin()
        left, top, right, bottom = self.box(editor)
        inside = left + 0.25 * (right - left), bottom - 12
        editor.drag(inside, (inside[0] + 50, inside[1] - 20), release=False)
        editor.key("Escape")
        editor.release()
        self.assertFalse(editor.settle()["is_modified"])
        editor.drag(inside, (inside[0] + 50, inside[1] - 20), release=False)
        self.type_keys(editor, "x1\t2\n")
        editor.release()
        self.assertEqual(self.curves(editor)[0]["points"][0], [-5, -0.25])

    def test_the_axis_of_a_mirror_image_is_clicked(self):
        editor = self.open_editor()
        self.choose(editor, "edit", "Symmetry", "pick-link-mirror")
        editor.wait(lambda state: "form smooth" in state["widgets"] and state["is_settled"], "the form")
        editor.key("Return")
        editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the end of the form")
        end = editor.point(6)
        editor.click(*end)
        editor.settle()
        editor.move(end[0] + 3, end[1] - 80)
        editor.screenshot("axis")
        self.type_keys(editor, "5\t90\n")  # 5 upward from the first point
        editor.settle()
        curves = self.curves(editor)
        self.assertEqual(len(curves), 2)
        self.assertEqual(curves[1]["points"][0], [18.5, -2.25])
        self.assertEqual(curves[0]["symmetry"]["group"], curves[1]["symmetry"]["group"])

    def test_the_center_of_a_ring_is_clicked(self):
        editor = self.open_editor()
        self.choose(editor, "edit", "Arrange", "pick-array-polar")
        editor.wait(lambda state: "form count" in state["widgets"] and state["is_settled"], "the form")
        editor.key("Return")
        editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the end of the form")
        editor.click(*editor.point(0))
        editor.settle()
        curves = self.curves(editor)
        self.assertEqual(len(curves), 5)
        for curve in curves:
            self.assertAlmostEqual(curve["points"][0][0], -6, 12)
            self.assertAlmostEqual(curve["points"][0][1], -2.25, 12)


if __name__ == "__main__":
    unittest.main()
