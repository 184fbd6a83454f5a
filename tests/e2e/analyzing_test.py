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
        self.assertTrue(editor.state()["widgets"]["finding 0"]["value"].startswith("inflection | "))
        self.assertIn("2 inflections", editor.state()["message"])
        self.assertEqual(editor.state()["undo_count"], 0)
        editor.screenshot("inflections")
        editor.click_widget("finding 1")
        moved = editor.wait(lambda state: state["parameter"] != 0.4, "the parameter")
        self.assertGreater(moved["parameter"], 0.5)

    def headings(self, editor):
        widgets = editor.settle()["widgets"]
        return {name: place["y"] for name, place in widgets.items() if name.startswith(("section ", "point ", "show ", "step ")) and name != "section findings"}

    def test_findings_come_and_go_without_moving_the_sections(self):
        for size, is_scrolled in (((1280, 720), False), ((1280, 720), True), ((1024, 700), False)):
            with self.subTest(size=size, is_scrolled=is_scrolled):
                settings = {"window": {"x": 0, "y": 0, "width": size[0], "height": size[1]}}
                with self.start(self.display(*size), settings=settings) as editor:
                    x, y = editor.widget_center("section curve")
                    editor.move(x, y)
                    if is_scrolled:
                        editor.wheel(-30)
                        editor.move(x, y + 1)
                        self.assertIn("show labels", editor.state()["widgets"])
                    before = self.headings(editor)
                    self.choose(editor, "analyze", "Shape", "inflections")
                    shown = editor.wait(lambda state: "finding 1" in state["widgets"] and state["is_settled"], "the findings")
                    editor.screenshot(f"findings-{size[0]}-{is_scrolled}")
                    after = self.headings(editor)
                    top = shown["widgets"]["section findings"]["y"]
                    self.assertTrue(after)
                    self.assertEqual(after, {name: before[name] for name in after})
                    self.assertGreater(min((y for name, y in before.items() if name not in after), default=top), top - 10)
                    editor.key("Escape")
                    editor.wait(lambda state: "finding 0" not in state["widgets"] and state["is_settled"], "their end")
                    self.assertEqual(self.headings(editor), before)

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
