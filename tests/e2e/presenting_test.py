"""The projector mode: the whole screen, larger, with cards, captions and keys; and lessons, taken with mouse and keys."""

import pathlib
import unittest

from case import WindowTest

LESSONS = pathlib.Path(__file__).resolve().parents[2] / "assets" / "lessons"
SCREEN = (1920, 1080)
SMALL = {"window": {"x": 40, "y": 30, "width": 1000, "height": 700}}


class PresentingTest(WindowTest):
    def open_small(self, *arguments, **settings):
        return self.enterContext(self.start(self.display(*SCREEN), *arguments, settings={**SMALL, **settings}))

    def present(self, editor):
        editor.key("F11")
        return editor.wait(lambda state: state["canvas"]["width"] == SCREEN[0] and state["is_settled"], "the whole screen")

    def run_typed(self, editor, text):
        editor.key("ctrl+p")
        editor.wait(lambda state: state["dialog"] == "command-palette", "the palette")
        editor.type(text)
        editor.key("Return")
        editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the end of the command")

    def test_covers_the_screen_and_goes_back(self):
        editor = self.open_small()
        before = editor.state()
        state = self.present(editor)
        self.assertNotIn("menu file", state["widgets"])
        self.assertIn("card triangle", state["widgets"], "which the inspector has otherwise")
        cards = state["widgets"]["floating cards"]
        for place in state["points"]:
            self.assertTrue(0 < place["x"] < cards["x"], "beside the cards")
        editor.screenshot("presenting")
        editor.key("F11")
        after = editor.wait(lambda state: state["canvas"]["width"] == before["canvas"]["width"] and state["is_settled"], "the window")
        self.assertIn("menu file", after["widgets"])

    def test_cards_can_be_moved(self):
        editor = self.open_small()
        cards = self.present(editor)["widgets"]["floating cards"]
        start = (cards["x"] + 30, cards["y"] + cards["height"] - 12)
        editor.drag(start, (start[0] - 500, start[1]))
        moved = editor.settle()["widgets"]["floating cards"]
        self.assertLess(moved["x"], cards["x"] - 400)

    def test_says_what_was_done_and_which_keys_were_pressed(self):
        editor = self.open_small()
        self.present(editor)
        self.run_typed(editor, "insert-knot 0.5")
        caption = editor.settle()["widgets"]["presented message"]["value"]
        self.assertTrue(caption.startswith("p = 3: Inserted knot 0.5"), caption)
        self.assertIn("C¹", caption)
        self.run_typed(editor, "toggle-keys")
        editor.key("h")
        editor.wait(lambda state: state["widgets"].get("presented keys", {}).get("value") == "H: Hull", "the key")
        editor.screenshot("captions")


class LessonTest(WindowTest):
    def open_lesson(self, editor, name):
        editor.click_widget("menu help")
        editor.click_widget("menu-item Lessons")
        editor.click_widget("menu-item open-lesson")
        editor.click_widget(f"menu-item lesson {name}")
        return editor.wait(lambda state: "lesson title" in state["widgets"] and state["is_settled"], "the lesson")

    @staticmethod
    def step_of(state):
        """Which step it is, and of how many."""
        return tuple(map(int, state["widgets"]["lesson title"]["value"].rsplit(" · ", 1)[1].split(" of ")))

    @staticmethod
    def checks_of(state):
        return [widget["value"] for name, widget in state["widgets"].items() if name.startswith("lesson check ")]

    def test_a_task_is_done_with_the_mouse(self):
        editor = self.open_editor("--example", "wave")
        self.open_lesson(editor, "multiplicity-and-continuity")
        for step in (2, 3):
            editor.click_widget("lesson next")
            editor.wait(lambda state, step=step: self.step_of(state) == (step, 3), f"step {step}")
        self.assertEqual(self.checks_of(editor.state()), ["○ the multiplicity of 1 is 2, not yet 3", "○ the curve is C¹ at 1 by its knots, not yet C⁰"])
        editor.drag(editor.strip_knot(6), editor.strip_knot(5))
        editor.wait(lambda state: self.checks_of(state) == ["✓ the multiplicity of 1 is 3", "✓ the curve is C⁰ at 1 by its knots"], "the task done")
        editor.screenshot("lesson")
        editor.click_widget("lesson close")
        editor.wait(lambda state: "lesson title" not in state["widgets"], "the end of the lesson")

    def test_every_lesson_is_worked_through(self):
        editor = self.open_editor("--example", "wave")
        names = (LESSONS / "order.txt").read_text().split()
        self.assertTrue(names)
        for name in names:
            with self.subTest(lesson=name):
                self.work_through(editor, name)

    def work_through(self, editor, name):
        state = self.open_lesson(editor, name)
        count = self.step_of(state)[1]
        for step in range(1, count + 1):
            state = editor.wait(lambda state, step=step: self.step_of(state) == (step, count) and state["is_settled"], f"step {step}")
            if "lesson solve" in state["widgets"]:
                self.assertTrue(any(check.startswith("○") for check in self.checks_of(state)), f"step {step}")
                editor.click_widget("lesson solve")
                editor.wait(lambda state: all(check.startswith("✓") for check in self.checks_of(state)), f"step {step} done")
            if step < count:
                editor.click_widget("lesson next")
        editor.screenshot(name)

    def test_follows_the_keys_of_a_presenter(self):
        editor = self.open_editor("--example", "wave")
        editor.key("ctrl+p")
        editor.wait(lambda state: state["dialog"] == "command-palette", "the palette")
        editor.type("open-lesson multiplicity-and-continuity")
        editor.key("Return")
        editor.wait(lambda state: "lesson title" in state["widgets"], "the lesson")
        for key, step in (("Next", 2), ("Next", 3), ("Prior", 2)):
            editor.key(key)
            editor.wait(lambda state, step=step: f"{step} of 3" in state["widgets"]["lesson title"]["value"], f"step {step}")


if __name__ == "__main__":
    unittest.main()
