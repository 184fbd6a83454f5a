"""Every lesson is taken with the mouse: each of its tasks is done by the gesture that does what its solution says."""

import contextlib
import json
import math
import pathlib
import unittest

from case import WindowTest

LESSONS = pathlib.Path(__file__).resolve().parents[2] / "assets" / "lessons"
PARTS = 3

# Where the menus have what a solution says in other words.
MENUS = {
    "split": ("curve", "Pieces"),
    "to-clamped": ("curve", "Closing"),
    "toggle-closed": ("curve", "Closing"),
}


def number(text):
    return float(text.replace("−", "-"))


class Hand:
    """Does what commands say with real pointer events."""

    def __init__(self, editor, snaps=False):
        self.editor = editor
        self.snapping = ["ctrl"] if snaps else []

    # Where things are.

    def place(self, x, y):
        """Where a point of the plane is in the window."""
        state = self.editor.state()
        first, widgets = state["points"][0], state["widgets"]
        from_first = x - number(widgets["point 0 x"]["value"]), y - number(widgets["point 0 y"]["value"])
        return first["x"] + from_first[0] * state["zoom"], first["y"] - from_first[1] * state["zoom"]

    def position(self, index):
        """Where a control point is in the plane."""
        first, point = self.editor.point(0), self.editor.point(index)
        state = self.editor.state()
        widgets = state["widgets"]
        return (number(widgets["point 0 x"]["value"]) + (point[0] - first[0]) / state["zoom"],
                number(widgets["point 0 y"]["value"]) - (point[1] - first[1]) / state["zoom"])

    def strip_x(self, u):
        state = self.editor.state()
        xs = sorted({round(knot["x"], 3) for knot in state["strip_knots"]})
        values = [knot["value"] for knot in state["knots"]]
        assert len(xs) == len(values), (xs, values)
        return xs[0] + (u - values[0]) * (xs[-1] - xs[0]) / (values[-1] - values[0])

    # Gestures.

    @contextlib.contextmanager
    def held(self, *keys):
        for key in keys:
            self.editor.xdotool("keydown", key)
        try:
            yield
        finally:
            for key in keys:
                self.editor.xdotool("keyup", key)

    def press_button(self, name, times=1):
        for _ in range(times):
            before = self.editor.state()["undo_count"]
            self.editor.click_widget(name)
            self.editor.wait(lambda state: state["undo_count"] > before and state["is_settled"], f"what '{name}' does")

    def choose(self, command):
        menu, submenu = MENUS[command]
        for name in (f"menu {menu}", f"menu-item {submenu}", f"menu-item {command}"):
            self.editor.click_widget(name)
        state = self.editor.settle()
        if state["dialog"] == "command-form":
            self.editor.click_widget("form apply")
        self.editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], f"the end of '{command}'")

    # What solutions say.

    def set_parameter(self, u):
        state = self.editor.state()
        y = state["plot"]["y"] + 0.4 * state["plot"]["height"]
        with self.held(*self.snapping):
            self.editor.drag((self.strip_x(state["parameter"]), y), (self.strip_x(u), y))

    def set_point(self, index, x, y):
        with self.held(*self.snapping):
            self.editor.drag(self.editor.point(index), self.place(x, y))

    def set_weight(self, index, weight):
        now = number(self.editor.state()["widgets"][f"point {index} w"]["value"])
        x, y = self.editor.point(index)
        with self.held("alt", *self.snapping):
            self.editor.drag((x, y), (x + 200.0 * math.log10(weight / now), y))

    def add_point(self, index, x, y):
        self.press_button("add point")
        self.editor.click_widget("tool-bar fit")
        self.set_point(index, x, y)

    def straighten(self, first, last):
        (x0, y0), (x1, y1) = self.position(first), self.position(last)
        for i in range(first + 1, last):
            share = (i - first) / (last - first)
            self.editor.drag(self.editor.point(i), self.place(x0 + share * (x1 - x0), y0 + share * (y1 - y0)))

    def move_knot(self, index, u):
        start = self.editor.strip_knot(index)
        self.editor.drag(start, (self.strip_x(u), start[1]))

    def insert_knot(self, u):
        at = [knot for knot in self.editor.state()["strip_knots"] if abs(knot["x"] - self.strip_x(u)) < 1.0]
        before = self.editor.state()["undo_count"]
        self.editor.double_click(at[0]["x"], at[0]["y"])
        self.editor.wait(lambda state: state["undo_count"] > before and state["is_settled"], f"the knot {u}")

    def to_bezier(self):
        degree = self.editor.state()["degree"]
        for knot in self.editor.state()["knots"][1:-1]:
            for _ in range(degree - knot["multiplicity"]):
                self.insert_knot(knot["value"])

    def set_kind(self, kind):
        assert kind == "piecewise-bezier"
        inner = [knot["value"] for knot in self.editor.state()["knots"]][1:-1]
        degree = self.editor.state()["degree"]
        self.move_knot(degree + 1, inner[1])
        self.move_knot(degree + 3, inner[1])

    def set_degree(self, degree):
        now = self.editor.state()["degree"]
        self.press_button("degree more" if degree > now else "degree less", abs(degree - now))

    def reduce(self, times):
        self.press_button("degree lower", times)

    def phantom_end(self, end):
        widgets = self.editor.state()["widgets"]
        buttons = [name for name, widget in widgets.items() if name.startswith("card end-vertices button") and widget["value"] == "phantom"]
        self.press_button(sorted(buttons)[0 if end == "start" else -1])

    def put_line(self, _x, _y, x, y):
        at = self.place(2.0, 0.0)
        self.editor.drag(at, (at[0], self.place(x, y)[1]))

    def do(self, name, *arguments):
        if name in MENUS:
            self.choose(name)
        else:
            getattr(self, name.replace("-", "_"))(*arguments)


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

    def work_through(self, editor, lesson):
        self.open_lesson(editor, lesson)
        steps = json.loads((LESSONS / f"{lesson}.json").read_text())["steps"]
        for number_of_step, step in enumerate(steps, 1):
            place = (number_of_step, len(steps))
            editor.wait(lambda state: self.step_of(state) == place and state["is_settled"], f"step {place}")
            if "task" in step:
                with self.subTest(lesson=lesson, step=number_of_step):
                    self.do_task(editor, step)
            if number_of_step < len(steps):
                editor.click_widget("lesson next")
        editor.screenshot(lesson)

    def do_task(self, editor, step):
        self.assertTrue(any(check.startswith("○") for check in self.checks_of(editor.state())))
        hand = Hand(editor, snaps="Ctrl" in step["task"])
        for command, *arguments in step["solution"]:
            hand.do(command, *arguments)
        checks = self.checks_of(editor.settle())
        self.assertEqual([check for check in checks if not check.startswith("✓")], [])


class Part(LessonTest):
    """One of PARTS that can be run beside one another."""

    part = None

    def test_lessons_are_worked_through_with_the_mouse(self):
        if self.part is None:
            self.skipTest("this is done in parts")
        editor = self.open_editor("--example", "wave")
        for lesson in (LESSONS / "order.txt").read_text().split()[self.part::PARTS]:
            self.work_through(editor, lesson)


class Part0(Part):
    part = 0


class Part1(Part):
    part = 1


class Part2(Part):
    part = 2


class WaysTest(LessonTest):
    """The ways to a lesson and through it."""

    def test_a_step_can_show_its_solution(self):
        editor = self.open_editor("--example", "wave")
        self.open_lesson(editor, "multiplicity-and-continuity")
        for step in (2, 3):
            editor.click_widget("lesson next")
            editor.wait(lambda state, step=step: self.step_of(state)[0] == step, f"step {step}")
        self.assertEqual(self.checks_of(editor.state()), ["○ the multiplicity of 1 is 2, not yet 3", "○ the curve is C¹ at 1 by its knots, not yet C⁰"])
        editor.click_widget("lesson solve")
        editor.wait(lambda state: self.checks_of(state) == ["✓ the multiplicity of 1 is 3", "✓ the curve is C⁰ at 1 by its knots"], "the task done")
        editor.screenshot("lesson")
        editor.click_widget("lesson close")
        editor.wait(lambda state: "lesson title" not in state["widgets"], "the end of the lesson")

    def test_follows_the_keys_of_a_presenter(self):
        editor = self.open_editor("--example", "wave")
        editor.key("ctrl+p")
        editor.wait(lambda state: state["dialog"] == "command-palette", "the palette")
        editor.type("open-lesson multiplicity-and-continuity")
        editor.key("Return")
        editor.wait(lambda state: "lesson title" in state["widgets"], "the lesson")
        for key, step in (("Next", 2), ("Next", 3), ("Prior", 2)):
            editor.key(key)
            editor.wait(lambda state, step=step: self.step_of(state)[0] == step, f"step {step}")

    def test_lessons_are_offered_beside_the_examples(self):
        for width, height, scale in ((1280, 720, 1), (1024, 700, 1), (1440, 900, 2)):
            with self.subTest(width=width, scale=scale):
                geometry = {"x": 0, "y": 0, "width": width, "height": height}
                editor = self.enterContext(self.start(self.display(width, height), "--display-scale", scale, settings={"window": geometry}))
                editor.screenshot(f"welcome-{width}")
                lesson, example = (editor.widget(name) for name in ("welcome lesson de-casteljau", "example bezier-cubic"))
                self.assertLessEqual(lesson["x"] + lesson["width"], example["x"])
                self.assertEqual(lesson["value"], "The algorithm of de Casteljau")
                editor.click_widget("welcome lesson de-casteljau")
                state = editor.wait(lambda state: "lesson title" in state["widgets"] and state["is_settled"], "the lesson")
                self.assertEqual((state["dialog"], self.step_of(state)[0]), ("none", 1))

    def test_the_line_of_a_lesson_is_above_the_cards_too(self):
        editor = self.open_editor("--example", "wave")
        state = self.open_lesson(editor, "bernstein-polynomials")
        card, text = state["widgets"]["card basis-values"], state["widgets"]["lesson text"]
        self.assertGreater(text["x"] + text["width"], card["x"])
        self.assertLess(text["y"] + text["height"], card["y"])


if __name__ == "__main__":
    unittest.main()
