"""What the window tests share: a display, a file to work on, and its reading back."""

import json
import os
import pathlib
import tempfile
import unittest

from driver import Display, Editor

CUBIC = {
    "format": "batten",
    "version": 1,
    "curves": [
        {
            "name": "wave",
            "degree": 3,
            "knots": [0, 0, 0, 0, 0.25, 0.5, 0.75, 1, 1, 1, 1],
            "points": [[-6, -2.25], [-4.5, 2.5], [-1.5, 3.5], [-0.5, -2.5], [2.5, -3.25], [3.5, 2.25], [6.25, 2.75]],
        }
    ],
    "view": {"parameter": 0.4},
}


class WindowTest(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="batten-files-")))
        self.path = self.folder / "wave.json"
        self.path.write_text(json.dumps(CUBIC))

    def display(self, width=1440, height=900):
        return self.enterContext(Display(width, height))

    def start(self, display, *arguments, **options):
        """The editor on the display, open on the test's file unless other arguments are given."""
        return Editor(os.environ["BATTEN_BINARY"], display, self.artifacts(), arguments or (self.path,), **options)

    def artifacts(self):
        return pathlib.Path(os.environ.get("BATTEN_ARTIFACTS", self.folder)) / self.id().split(".", 1)[1]

    def open_editor(self, *arguments, **options):
        return self.enterContext(self.start(self.display(), *arguments, **options))

    def saved(self):
        return json.loads(self.path.read_text())["curves"][0]

    def save(self, editor):
        before = self.path.stat().st_ino
        editor.key("ctrl+s")
        editor.wait_until(lambda: self.path.stat().st_ino != before, "the saved file")
        editor.wait(lambda state: not state["is_modified"] and state["is_settled"], "the end of saving")
        return self.saved()

    def choose(self, editor, menu, submenu, command):
        editor.click_widget(f"menu {menu}")
        editor.click_widget(f"menu-item {submenu}")
        editor.click_widget(f"menu-item {command}")

    def retype(self, editor, name, text):
        """Replaces the text of the active field, whose widget is `name`."""
        editor.key("ctrl+a")
        editor.type(text)
        editor.wait(lambda state: state["widgets"][name]["value"] == text, f"'{text}' in the field")
