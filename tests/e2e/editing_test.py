"""Editing in the real window: what is dragged, typed and clicked is what is saved."""

import json
import unittest

import spline
from case import WindowTest


def scale_of(editor, curve):
    """Window pixels for a unit, from two control points."""
    (x0, y0), (x1, y1) = editor.point(0), editor.point(6)
    return (x1 - x0) / (curve["points"][6][0] - curve["points"][0][0])


class EditingTest(WindowTest):
    def test_dragged_point_is_saved_exactly_there(self):
        editor = self.open_editor()
        before = self.save(editor)
        scale = scale_of(editor, before)
        x, y = editor.point(2)
        start, end = (round(x), round(y)), (round(x) + 60, round(y) + 35)
        editor.drag(start, end, release=False)
        self.assertEqual(editor.state()["undo_count"], 0)
        editor.screenshot("dragging")
        editor.release()
        self.assertEqual(editor.state()["undo_label"], "Move P₂")
        after = self.save(editor)
        expected = [before["points"][2][0] + 60 / scale, before["points"][2][1] - 35 / scale]
        for found, wanted in zip(after["points"][2], expected):
            self.assertAlmostEqual(found, wanted, delta=1e-9)
        after["points"][2] = before["points"][2]
        self.assertEqual(after, before)

    def test_escape_gives_up_a_drag(self):
        editor = self.open_editor()
        before = self.save(editor)
        x, y = editor.point(3)
        editor.drag((x, y), (x - 50, y + 20), release=False)
        editor.wait(lambda state: state["has_preview"], "the preview")
        editor.key("Escape")
        editor.wait(lambda state: not state["has_preview"], "the end of the preview")
        editor.release()
        self.assertEqual(editor.state()["undo_count"], 0)
        self.assertEqual(self.save(editor), before)

    def test_knot_dragged_onto_another_lowers_the_continuity(self):
        editor = self.open_editor()
        knots = editor.state()["knots"]
        self.assertEqual([(knot["value"], knot["continuity"]) for knot in knots[1:4]], [(0.25, 2), (0.5, 2), (0.75, 2)])
        self.assertEqual(editor.labels().count("C^{2}"), 3)
        self.assertNotIn("×2 C^{1}", editor.labels())
        editor.drag(editor.strip_knot(5), editor.strip_knot(4), release=False)
        editor.wait(lambda state: "×2 C^{1}" in [label["text"] for label in state["labels"]], "C^{1} while dragging")
        editor.release()
        editor.screenshot("merged")
        self.assertEqual(self.save(editor)["knots"], [0, 0, 0, 0, 0.25, 0.25, 0.75, 1, 1, 1, 1])
        self.assertIn("×2 C^{1}", editor.labels())
        self.assertEqual(editor.labels().count("C^{2}"), 1)

    def test_curve_that_may_tear_comes_apart_under_a_dragged_knot_and_is_mended_by_undo(self):
        points = [[-6, -2], [-4.5, 2.5], [-3, 3], [-2, 1], [0, -2], [2.5, -3], [3.5, 2], [5, 3], [6, 2]]
        curve = {"degree": 3, "knots": [0, 0, 0, 0, 0.3, 0.3, 0.3, 0.8, 0.8, 1, 1, 1, 1], "points": points}
        self.path.write_text(json.dumps({"format": "batten", "version": 1, "curves": [curve]}))
        editor = self.open_editor()
        editor.drag(editor.strip_knot(7), editor.strip_knot(6))
        editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "a knot beside the full stack")
        self.assertNotIn("×4 jump", editor.labels())
        editor.key("ctrl+z")
        editor.click_widget("tears")
        editor.wait(lambda state: state["widgets"]["tears"]["value"] == "on" and state["is_settled"], "the switch")
        editor.drag(editor.strip_knot(7), editor.strip_knot(6))
        editor.wait(lambda state: "×4 jump" in [label["text"] for label in state["labels"]], "the torn curve")
        editor.screenshot("torn")
        saved = self.save(editor)
        self.assertEqual(saved["knots"], [0, 0, 0, 0, 0.3, 0.3, 0.3, 0.3, 0.8, 1, 1, 1, 1])
        self.assertTrue(saved["tears"])
        editor.key("ctrl+z")
        editor.wait(lambda state: "×3 C^{0}" in [label["text"] for label in state["labels"]], "the whole curve")

    def test_insert_stays_under_the_pointer_while_the_lists_grow(self):
        for name, size, folded in (("scrolled", (1024, 700), ()), ("short", (1440, 900), ("construction", "show", "curves"))):
            with self.subTest(name):
                editor = self.enterContext(self.start(self.display(*size)))
                editor.click_widget("section knots")
                for section in folded:
                    editor.click_widget(f"section {section}")
                if not folded:
                    editor.move(900, 400)
                    editor.wheel(-4)
                place = editor.settle()["widgets"]["insert knot"]
                editor.move(place["x"] + 20, place["y"] + 10)
                for count in range(1, 4):
                    editor.press()
                    editor.release()
                    state = editor.wait(lambda state: state["undo_count"] == count and state["is_settled"], f"insertion {count}")
                    self.assertAlmostEqual(state["widgets"]["insert knot"]["x"], place["x"], delta=1)
                    self.assertAlmostEqual(state["widgets"]["insert knot"]["y"], place["y"], delta=1)
                editor.screenshot(name)
                self.assertEqual([knot["multiplicity"] for knot in state["knots"] if knot["value"] == 0.4], [3])

    def test_enter_and_a_click_insert_one_knot(self):
        editor = self.open_editor()
        editor.click_widget("section knots")
        editor.click_widget("insert u")
        editor.wait(lambda state: state["widgets"]["insert u"]["value"] == "0.4" and state["is_settled"], "the field")
        self.retype(editor, "insert u", "1/3")
        editor.key("Return")
        editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the knot")
        editor.click_widget("insert knot")
        self.assertEqual(editor.settle()["undo_count"], 1)
        self.assertIn(1 / 3, self.save(editor)["knots"])
        editor.key("ctrl+z")
        editor.wait(lambda state: state["undo_count"] == 0 and state["is_settled"], "the undoing")
        editor.click_widget("insert knot")
        editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the knot again")

    def test_a_knot_dragged_or_typed_in_the_list_never_joins_its_neighbor_in_the_mode_stop(self):
        editor = self.open_editor()
        editor.click_widget("section knots")
        editor.click_widget("knot move stop")
        x, y = editor.widget_center("knot 5 value")
        editor.drag((x, y), (x - 400, y))
        state = editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the move")
        self.assertIn("which it joins where 'snap' is chosen", state["message"])
        editor.click_widget("knot 6 value")
        editor.wait(lambda state: state["widgets"]["knot 6 value"]["value"] == "0.75" and state["is_settled"], "the field")
        self.retype(editor, "knot 6 value", "0.255")
        editor.key("Return")
        editor.wait(lambda state: state["undo_count"] == 2 and state["is_settled"], "the second move")
        self.assertEqual(self.save(editor)["knots"], [0, 0, 0, 0, 0.25, 0.255, 0.26, 1, 1, 1, 1])

    def test_a_burst_of_arrow_presses_is_one_step(self):
        editor = self.open_editor()
        before = self.save(editor)
        editor.click(*editor.point(3))
        editor.key("Right", "Right", "Right", "shift+Up")
        state = editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the step")
        self.assertEqual(state["undo_label"], "Nudge P₃")
        self.assertNotEqual(self.save(editor)["points"][3], before["points"][3])
        editor.key("ctrl+z")
        editor.wait(lambda state: state["undo_count"] == 0 and state["is_settled"], "the undoing")
        self.assertEqual(self.save(editor), before)

    def test_double_click_on_the_curve_inserts_a_knot_and_keeps_the_curve(self):
        editor = self.open_editor()
        before = self.save(editor)
        place = editor.state()["curve_places"][5]
        editor.double_click(place["x"], place["y"])
        editor.wait(lambda state: state["undo_count"] == 1, "the insertion")
        editor.screenshot("inserted")
        after = self.save(editor)
        self.assertEqual(len(after["knots"]), len(before["knots"]) + 1)
        self.assertEqual(len(after["points"]), len(before["points"]) + 1)
        new = [knot for knot in after["knots"] if knot not in before["knots"]]
        self.assertEqual(len(new), 1)
        self.assertAlmostEqual(new[0], place["u"], delta=0.02)
        self.assertLess(spline.largest_deviation(before, after), 1e-12 * spline.size_of(before))

    def test_typed_weight_is_saved(self):
        editor = self.open_editor()
        before = self.save(editor)
        self.type_into(editor, "point 5 w", "3.5")
        editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the new weight")
        editor.screenshot("weight")
        after = self.save(editor)
        self.assertEqual(after["weights"], [1, 1, 1, 1, 1, 3.5, 1])
        self.assertEqual(after["points"], before["points"])

    def type_into(self, editor, name, text):
        editor.click_widget(name)
        self.retype(editor, name, text)
        editor.key("Return")

    def test_undoing_everything_gives_the_saved_file_byte_for_byte(self):
        editor = self.open_editor()
        self.save(editor)
        first = self.path.read_bytes()
        x, y = editor.point(1)
        editor.drag((x, y), (x + 30, y - 25))
        editor.drag(editor.strip_knot(6), editor.strip_knot(5))
        place = editor.state()["curve_places"][1]
        editor.double_click(place["x"], place["y"])
        self.type_into(editor, "point 3 x", "1.75")
        editor.wait(lambda state: state["undo_count"] == 4 and state["is_settled"], "four steps")
        self.save(editor)
        self.assertNotEqual(self.path.read_bytes(), first)
        for left in (3, 2, 1, 0):
            editor.key("ctrl+z")
            editor.wait(lambda state: state["undo_count"] == left, f"{left} steps left")
        self.save(editor)
        self.assertEqual(self.path.read_bytes(), first)
        for done in (1, 2, 3, 4):
            editor.key("ctrl+shift+z")
            editor.wait(lambda state: state["undo_count"] == done, f"{done} steps done again")

    def test_playing_moves_the_parameter_and_stops(self):
        editor = self.open_editor()
        editor.click_widget("play")
        editor.wait(lambda state: state["is_playing"] and state["parameter"] > 0.45, "the parameter moving")
        editor.click_widget("play")
        editor.wait(lambda state: not state["is_playing"] and state["is_settled"], "rest")


if __name__ == "__main__":
    unittest.main()
