"""Keys in the real window: layouts of other languages, and frames that take long."""

import os
import signal
import subprocess
import unittest

from case import WindowTest

# Keycodes of the X server by what an American keyboard prints.
KEYS = {"1": 10, "3": 12, "6": 15, "0": 19, "-": 20, "=": 21, "q": 24, "w": 25, "y": 29, "]": 35, "a": 38, "z": 52, "/": 61}


class KeysTest(WindowTest):
    def open_with_layout(self, layout):
        display = self.display()
        environment = dict(os.environ, DISPLAY=display.name)
        subprocess.run(["setxkbmap", layout], env=environment, check=True)
        editor = self.enterContext(self.start(display))
        editor.quit_key = f"ctrl+{KEYS['a' if layout == 'fr' else 'q']}"
        return editor

    def strike(self, editor, key, *modifiers):
        editor.key("+".join([*modifiers, str(KEYS[key])]))

    def test_ctrl_z_undoes_in_every_layout(self):
        for layout, key in (("us", "z"), ("ru", "z"), ("gr", "z"), ("de", "y"), ("cz", "y"), ("hu", "y"), ("fr", "w")):
            with self.subTest(layout=layout):
                editor = self.open_with_layout(layout)
                self.choose(editor, "curve", "Knots", "insert-midpoints")
                editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the knots")
                self.strike(editor, key, "ctrl")
                editor.wait(lambda state: state["undo_count"] == 0 and state["is_settled"], "the undoing")
                editor.close()

    def test_the_interface_is_scaled_by_the_keys_that_print_the_signs(self):
        for layout, plus, minus in (
            ("us", ("=", "ctrl", "shift"), ("-", "ctrl")),
            ("us", ("=", "ctrl"), ("-", "ctrl")),
            ("ru", ("=", "ctrl", "shift"), ("-", "ctrl")),
            ("de", ("]", "ctrl"), ("/", "ctrl")),
            ("cz", ("1", "ctrl"), ("/", "ctrl")),
            ("hu", ("3", "ctrl", "shift"), ("/", "ctrl")),
            ("fr", ("=", "ctrl", "shift"), ("6", "ctrl")),
        ):
            with self.subTest(layout=layout):
                editor = self.open_with_layout(layout)
                scale = editor.state()["interface_scale"]
                self.strike(editor, *plus)
                larger = editor.wait(lambda state: state["interface_scale"] > scale and state["is_settled"], "a larger interface")
                self.strike(editor, *minus)
                editor.wait(lambda state: state["interface_scale"] < larger["interface_scale"] and state["is_settled"], "a smaller interface")
                self.strike(editor, *plus)
                editor.wait(lambda state: state["interface_scale"] == larger["interface_scale"], "a larger interface again")
                self.strike(editor, "0", "ctrl")
                editor.wait(lambda state: state["interface_scale"] == scale and state["is_settled"], "the scale of the display")
                editor.close()

    def begin_typing(self, editor, text):
        editor.click_widget("point 0 x")
        editor.wait(lambda state: state["widgets"]["point 0 x"]["value"] == "-6" and state["is_settled"], "the field")
        self.retype(editor, "point 0 x", text)

    def in_one_frame(self, editor, *words):
        """Sends keys while the editor is stopped, so that its next frame finds all of them."""
        os.kill(editor.process.pid, signal.SIGSTOP)
        editor.xdotool(*words)
        os.kill(editor.process.pid, signal.SIGCONT)

    def shortcut(self, key, first_up):
        last_up = key if first_up == "ctrl" else "ctrl"
        return ("keydown", "ctrl", "keydown", key, "keyup", first_up, "keyup", last_up)

    def test_shortcuts_of_text_fields_survive_a_slow_frame_in_whatever_order_the_keys_go_up(self):
        editor = self.open_editor()
        shows = lambda text: editor.wait(lambda state: state["widgets"]["point 0 x"]["value"] == text, f"'{text}' in the field")
        self.begin_typing(editor, "12")
        editor.key("ctrl+a")
        editor.key("ctrl+c")
        for i, first_up in enumerate(("ctrl", "v", "ctrl", "v"), start=1):
            editor.key("End")
            self.in_one_frame(editor, *self.shortcut("v", first_up))
            shows("12" * (i + 1))
        for first_up in ("ctrl", "a", "ctrl"):
            self.in_one_frame(editor, *self.shortcut("a", first_up), "key", "7", "key", "BackSpace", "key", "8", "key", "9")
            shows("89")
        editor.key("Escape")

    def test_ctrl_released_a_frame_after_its_press_is_still_held_for_the_key(self):
        editor = self.open_editor()
        self.begin_typing(editor, "12")
        editor.xdotool("keydown", "ctrl")
        editor.settle()
        self.in_one_frame(editor, "keydown", "a", "keyup", "ctrl", "keyup", "a", "key", "5")
        editor.wait(lambda state: state["widgets"]["point 0 x"]["value"] == "5", "the text replaced")
        editor.key("Escape")

    def test_a_text_field_selects_all_with_the_key_that_prints_an_a(self):
        editor = self.open_with_layout("fr")
        editor.click_widget("point 0 x")
        editor.wait(lambda state: state["widgets"]["point 0 x"]["value"] == "-6" and state["is_settled"], "the field")
        editor.key("End")
        self.strike(editor, "q", "ctrl")
        editor.type("7")
        editor.wait(lambda state: state["widgets"]["point 0 x"]["value"] == "7", "the text replaced")
        editor.key("Escape")


if __name__ == "__main__":
    unittest.main()
