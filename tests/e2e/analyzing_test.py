"""Measures and new shapes in the real window: found, marked, shown, and left again."""

import unittest

from case import WindowTest


class AnalyzingTest(WindowTest):
    def rows(self, editor):
        return [name for name in editor.state()["widgets"] if name.startswith("finding ")]

    def test_findings_are_listed_and_lead_to_their_parameters(self):
        editor = self.open_editor()
        self.choose(editor, "analyze", "Shape", "inflections")
        editor.wait(lambda state: "finding 0" in state["widgets"] and state["is_settled"], "the findings")
        self.assertEqual(self.rows(editor), ["finding 0", "finding 1"])
        self.assertEqual(editor.state()["widgets"]["finding 0"]["value"], "inflection")
        self.assertIn("2 inflections", editor.state()["message"])
        self.assertEqual(editor.state()["undo_count"], 0)
        editor.screenshot("inflections")
        editor.click_widget("finding 1")
        moved = editor.wait(lambda state: state["parameter"] != 0.4, "the parameter")
        self.assertGreater(moved["parameter"], 0.5)

    def test_findings_are_forgotten_by_escape_and_by_edits(self):
        editor = self.open_editor()
        for leave in (lambda: editor.key("Escape"), lambda: editor.click_widget("clear findings"), lambda: editor.key("i")):
            self.choose(editor, "analyze", "Shape", "inflections")
            editor.wait(lambda state: "finding 0" in state["widgets"] and state["is_settled"], "the findings")
            leave()
            editor.wait(lambda state: "finding 0" not in state["widgets"], "their end")

    def test_a_shape_is_made_from_the_menu_with_the_size_that_suggests_itself(self):
        editor = self.open_editor()
        self.choose(editor, "make", "Shapes", "circle")
        editor.wait(lambda state: state["dialog"] == "command-form" and state["has_preview"], "the form")
        editor.key("Return")
        state = editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the circle")
        self.assertEqual((state["degree"], len(state["points"])), (2, 9))
        self.assertEqual(state["undo_label"], "Make circle")
        editor.screenshot("circle")
        editor.key("ctrl+z")
        editor.wait(lambda state: state["curve_count"] == 1, "its end")


if __name__ == "__main__":
    unittest.main()
