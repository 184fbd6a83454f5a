"""Several curves at once in the real window: selected with the mouse, moved, hidden, grouped, and put in order."""

import json
import unittest

from case import WindowTest

CURVES = [
    {"name": "low", "degree": 1, "knots": [0, 0, 1, 2, 2], "points": [[-5, -2], [0, -2.5], [5, -2]]},
    {"name": "high", "degree": 1, "knots": [0, 0, 1, 2, 2], "points": [[-5, 2], [0, 2.5], [5, 2]]},
    {"name": "bar", "degree": 1, "knots": [0, 0, 1, 1], "points": [[-6, 0], [-3, 0.5]]},
    {"name": "rod", "degree": 1, "knots": [0, 0, 1, 1], "points": [[3, 0.5], [6, 0]]},
]


class SelectionTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.path.write_text(json.dumps({"format": "batten", "version": 1, "curves": CURVES}))

    def pixels(self, editor):
        """Where places of the world are: the ends of the first curve, which is active, are 10 apart."""
        (x0, y0), (x1, _) = editor.point(0), editor.point(2)
        scale = (x1 - x0) / 10
        return lambda x, y: (x0 + scale * (x + 5), y0 - scale * (y + 2))

    def curves(self, editor):
        self.save(editor)
        return json.loads(self.path.read_text())["curves"]

    def held(self, editor, *keys):
        """With these keys held down."""
        test = self

        class Held:
            def __enter__(self):
                for key in keys:
                    editor.xdotool("keydown", key)

            def __exit__(self, *_):
                for key in keys:
                    editor.xdotool("keyup", key)
                test.assertIsNotNone(editor.state())

        return Held()

    def wait_for_parts(self, editor, parts):
        editor.wait(lambda state: state["selected_parts"] == parts and state["is_settled"], f"'{parts}' selected")

    def open_list(self, editor):
        editor.click_widget("section curves")
        editor.wait(lambda state: "curve 0 name" in state["widgets"] and state["is_settled"], "the list of curves")

    def names(self, editor):
        widgets = editor.state()["widgets"]
        rows = [(place["y"], place["value"]) for name, place in widgets.items() if name.startswith("curve ") and name.endswith(" name")]
        return [value for _, value in sorted(rows)]

    def test_points_of_two_curves_are_dragged_together(self):
        editor = self.open_editor()
        at = self.pixels(editor)
        with self.held(editor, "ctrl"):
            editor.drag(at(4.5, 2.8), at(5.5, -3))
        self.wait_for_parts(editor, "0:2 1:2")
        editor.screenshot("points")
        editor.drag(at(5, 2), at(5.5, 3))
        editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the move")
        editor.screenshot("moved")
        low, high, bar, rod = self.curves(editor)
        move = [high["points"][2][k] - CURVES[1]["points"][2][k] for k in (0, 1)]
        self.assertAlmostEqual(move[0], 0.5, delta=0.05)
        self.assertAlmostEqual(move[1], 1, delta=0.05)
        for k in (0, 1):
            self.assertAlmostEqual(low["points"][2][k] - CURVES[0]["points"][2][k], move[k], 12)
        self.assertEqual(low["points"][:2], CURVES[0]["points"][:2])
        self.assertEqual((bar["points"], rod["points"]), (CURVES[2]["points"], CURVES[3]["points"]))
        editor.key("ctrl+z")
        editor.wait(lambda state: state["undo_count"] == 0 and state["is_settled"], "the undone move")
        self.assertEqual([curve["points"] for curve in self.curves(editor)], [curve["points"] for curve in CURVES])

    def test_whole_curves_are_grouped_hidden_and_moved(self):
        editor = self.open_editor()
        at = self.pixels(editor)
        editor.click(*at(-4, 1 / 3))
        editor.wait(lambda state: "bar" in state["message"] or state["is_settled"], "the active curve")
        with self.held(editor, "shift"):
            editor.click(*at(4, 1 / 3))
        self.wait_for_parts(editor, "2 3")
        editor.screenshot("wholes")
        editor.key("ctrl+g")
        editor.wait(lambda state: state["undo_label"] == "Group 'group'" and state["is_settled"], "the group")
        self.open_list(editor)
        editor.screenshot("group")
        editor.key("Escape")
        self.wait_for_parts(editor, "")
        editor.click_widget("group group name")
        self.wait_for_parts(editor, "2 3")
        editor.key("Up")
        editor.wait(lambda state: state["undo_count"] == 2 and state["is_settled"], "the nudge")
        editor.click_widget("group group visible")
        self.wait_for_parts(editor, "")
        editor.screenshot("hidden")
        low, high, bar, rod = self.curves(editor)
        self.assertEqual([curve["visible"] for curve in (low, high, bar, rod)], [True, True, False, False])
        self.assertEqual([curve.get("group") for curve in (low, high, bar, rod)], [None, None, "group", "group"])
        self.assertGreater(bar["points"][0][1], 0)
        self.assertEqual(bar["points"][0][1], rod["points"][1][1])
        editor.click_widget("group group fold")
        editor.wait(lambda state: "curve 2 name" not in state["widgets"] and state["is_settled"], "the folded group")
        editor.screenshot("folded")

    def test_an_entry_of_the_list_is_dragged_to_another_place(self):
        editor = self.open_editor()
        self.open_list(editor)
        self.assertEqual(self.names(editor), ["low", "high", "bar", "rod"])
        x, y = editor.widget_center("curve 0 name")
        _, below = editor.widget_center("curve 2 name")
        editor.drag((x, y), (x, below + 6), release=False)
        editor.screenshot("dragging")
        editor.release()
        editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the other order")
        self.assertEqual(self.names(editor), ["high", "bar", "low", "rod"])
        self.assertEqual([curve["name"] for curve in self.curves(editor)], ["high", "bar", "low", "rod"])
        with self.held(editor, "ctrl"):
            editor.click_widget("curve 0 name")
        self.wait_for_parts(editor, "0 2")
        editor.click_widget("curve 2 visible")
        editor.wait(lambda state: state["undo_count"] == 2 and state["is_settled"], "both hidden")
        self.assertEqual([curve["visible"] for curve in self.curves(editor)], [False, True, False, True])
        editor.key("ctrl+z", "ctrl+z")
        editor.wait(lambda state: state["undo_count"] == 0 and state["is_settled"], "the order before")
        self.assertEqual(self.names(editor), ["low", "high", "bar", "rod"])

    def test_escape_leaves_the_order_of_the_list(self):
        editor = self.open_editor()
        self.open_list(editor)
        x, y = editor.widget_center("curve 0 name")
        row = editor.widget_center("curve 1 name")[1] - y
        editor.drag((x, y), (x, y + 2.3 * row), release=False)
        editor.key("Escape")
        editor.move(x, y + 3.2 * row)
        editor.release()
        self.assertEqual(editor.state()["undo_count"], 0)
        self.assertEqual(self.names(editor), ["low", "high", "bar", "rod"])
        editor.drag((x, y), (x, y + 1.3 * row))
        editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the next drag")

    def test_a_group_is_dragged_by_its_heading(self):
        curves = [dict(curve, group=group) for curve, group in zip(CURVES, ["", "g", "g", ""])]
        self.path.write_text(json.dumps({"format": "batten", "version": 1, "curves": curves}))
        editor = self.open_editor()
        self.open_list(editor)
        x, y = editor.widget_center("group g name")
        row = editor.widget_center("curve 1 name")[1] - y
        editor.drag((x, y), (x, y - 1.3 * row))
        editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the group first")
        self.assertEqual([curve["name"] for curve in self.curves(editor)], ["high", "bar", "low", "rod"])
        y = editor.widget_center("group g name")[1]
        editor.drag((x, y), (x, y + 4.3 * row))
        editor.wait(lambda state: state["undo_count"] == 2 and state["is_settled"], "the group last")
        self.assertEqual([curve["name"] for curve in self.curves(editor)], ["low", "rod", "high", "bar"])


if __name__ == "__main__":
    unittest.main()
