"""A display that changes under the window: a driver that loses the context, a monitor of another scale, one that is unplugged."""

import json
import subprocess
import unittest

from case import WindowTest
from faulty_display import FaultyDisplay, preloaded


@unittest.skipUnless(preloaded(), "GLFW is part of the program here, so that nothing can stand between")
class FaultyDisplayTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.faults = FaultyDisplay(self.folder / "faults")
        self.screen = self.display()
        self.config = self.folder / "config"

    def begin(self, *arguments):
        return self.start(self.screen, *arguments, config=self.config, before=self.faults.words())

    def duplicate(self, editor):
        before = editor.state()["undo_count"]
        editor.key("ctrl+d")
        return editor.wait(lambda state: state["undo_count"] == before + 1 and state["is_settled"], "the step")

    def picture(self, editor, name):
        editor.move(700, 880)
        editor.settle()
        path = editor.screenshot(name)
        return subprocess.run(["convert", str(path), "-format", "%#", "info:"], capture_output=True, text=True, check=True).stdout

    def lose_context(self, editor):
        """As the driver does after a reset; the next frame notices it."""
        self.faults.ask("reset")
        editor.xdotool("mousemove", 700, 300)
        editor.wait_until(lambda: self.faults.is_done("reset"), "the loss of the context")
        editor.xdotool("mousemove", 640, 320)
        editor.wait(lambda state: state["pointer"] == {"x": 640, "y": 320} and state["is_settled"], "a frame on the new context")

    def test_a_lost_context_is_replaced(self):
        with self.begin(self.path) as editor:
            self.duplicate(editor)
            before = self.picture(editor, "before")
            for _ in range(3):
                self.lose_context(editor)
                state = editor.settle()
                self.assertEqual((state["undo_count"], state["is_modified"], state["path"]), (1, True, str(self.path)))
                self.assertEqual(self.picture(editor, "after"), before, "the picture is not the same after the loss")
            editor.click(640, 320)
            self.duplicate(editor)
            editor.key("ctrl+z", "ctrl+z")
            editor.wait(lambda state: state["undo_count"] == 0 and not state["is_modified"], "the steps back")
            self.assertEqual(editor.error_text(), "")

    def texture_count(self, editor):
        self.faults.ask("count-textures")
        editor.move(700, 320)
        editor.move(640, 320)
        editor.wait_until(lambda: self.faults.is_done("count-textures"), "the count")
        return int((self.faults.folder / "textures").read_text())

    def test_a_window_has_its_fonts_once(self):
        with self.begin(self.path) as editor:
            first = self.texture_count(editor)
            self.faults.ask("scale", "2")
            self.lose_context(editor)
            editor.wait(lambda state: state["interface_scale"] == 2.0, "the other scale")
            self.assertEqual((first, self.texture_count(editor)), (1, 1))

    def test_a_drag_ends_with_the_context(self):
        with self.begin(self.path) as editor:
            x, y = editor.point(2)
            editor.drag((x, y), (x + 60, y + 40), release=False)
            self.lose_context(editor)
            editor.wait(lambda state: state["buttons_down"] == 0, "the release")
            editor.xdotool("mouseup", 1)
            editor.click(*editor.point(1))
            editor.settle()
            self.assertEqual(editor.error_text(), "")

    def test_a_context_is_lost_while_presenting(self):
        with self.begin(self.path) as editor:
            editor.key("F11")
            editor.wait(lambda state: state["interface_scale"] > 1 and state["is_settled"], "the presentation")
            self.lose_context(editor)
            editor.key("F11")
            state = editor.wait(lambda state: state["interface_scale"] == 1 and state["is_settled"], "the window")
            self.assertEqual(editor.error_text(), "")

    def test_without_another_context_nothing_unsaved_is_lost(self):
        with self.begin(self.path) as editor:
            self.duplicate(editor)
            self.duplicate(editor)
            self.faults.ask("no-window")
            self.faults.ask("reset")
            editor.xdotool("mousemove", 700, 300)
            editor.wait_until(lambda: editor.process.poll() is not None, "the end")
            self.assertEqual(editor.process.returncode, 1)
            self.assertEqual(editor.error_text(), "batten: the graphics driver lost the window, and no other can be opened (no reason given); "
                             "the next start offers what is not saved\n")
            editor.is_killed = True
        self.faults.clear()
        with self.begin(self.path) as editor:
            editor.wait(lambda state: state["dialog"] == "recovery" and state["is_settled"], "the offer")
            editor.key("Return")
            editor.wait(lambda state: state["dialog"] == "none" and state["is_modified"], "the document")
            editor.key("ctrl+s")
            editor.wait(lambda state: not state["is_modified"], "the saved document")
        self.assertEqual(len(json.loads(self.path.read_text())["curves"]), 3)

    def test_a_monitor_of_another_scale(self):
        with self.begin(self.path) as editor:
            place = editor.widget("menu file")
            before = self.picture(editor, "scale-1-first")
            for scale in (2, 1.25, 1):
                # Nobody touches the window, which shows itself anew all the same.
                self.faults.ask("scale", str(scale))
                state = editor.wait(lambda state: abs(state["interface_scale"] - scale) < 1e-6 and state["is_settled"], f"the scale {scale}")
                self.assertAlmostEqual(state["widgets"]["menu file"]["height"], scale * place["height"], delta=2)
                editor.screenshot(f"scale-{scale}")
            self.assertEqual(self.picture(editor, "scale-1-again"), before)

    def test_the_monitor_of_a_presentation_is_unplugged(self):
        with self.begin(self.path) as editor:
            editor.key("F11")
            editor.wait(lambda state: state["interface_scale"] > 1 and state["is_settled"], "the presentation")
            self.faults.ask("unplug")
            editor.wait_until(lambda: self.faults.is_done("unplug"), "the end of the monitor")
            editor.move(700, 400)
            editor.key("F11")
            editor.wait(lambda state: state["interface_scale"] == 1 and state["is_settled"], "the window")
            self.duplicate(editor)
            self.assertEqual(editor.error_text(), "")


if __name__ == "__main__":
    unittest.main()
