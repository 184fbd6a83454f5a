"""Recorded sessions: a drawing from an empty window to a saved file, told in a page of docs/drawing.

The page says how many clicks and keys it took and what was measured in the file, outside of the program; both are compared with
what the session did. Its pictures are taken anew where BATTEN_PICTURES names the folder of the pages.
"""

import json
import os
import pathlib
import re
import shutil

import views
from case import WindowTest
from driver import Display, Editor

PAGES = pathlib.Path(__file__).resolve().parents[2] / "docs" / "drawing"
OVERLAYS = ["polygon", "knots", "labels", "grid"]
KEYS = {"\t": "Tab", "\n": "Return", ".": "period", ",": "comma", "@": "at", "<": "less", "-": "minus"}


class Recorder(Editor):
    """The editor, which counts what a person would do: clicks with drags, and keys."""

    clicks = 0
    keys = 0

    def xdotool(self, *words):
        super().xdotool(*words)
        if words[0] == "mousedown":
            self.clicks += 1
        elif words[0] == "click" and words[-1] == 1:
            self.clicks += words[2] if words[1] == "--repeat" else 1
        elif words[0] == "key":
            self.keys += len(words) - 1
        elif words[0] == "type":
            self.keys += len(str(words[-1]))


class SessionTest(WindowTest):
    page = None  # its name

    def begin(self):
        """An empty document in a window of the size of the pictures, by the welcome screen."""
        self.path = self.folder / f"{self.page}.json"
        self.pictures = []
        width, height = views.PICTURE_SIZE
        settings = {"window": {"x": 0, "y": 0, "width": width, "height": height}, "theme": "light", "overlays": OVERLAYS}
        display = self.enterContext(Display(width, height))
        editor = Recorder(os.environ["BATTEN_BINARY"], display, self.artifacts(), settings=settings)
        self.editor = self.enterContext(editor)
        self.editor.click_widget("welcome new")
        self.editor.wait(lambda state: state["dialog"] == "none" and state["curve_count"] == 0 and state["is_settled"], "an empty document")
        self.editor.key("F4")  # without the plot
        self.editor.settle()

    # What a person does.

    def place(self, x, y):
        """Where a place of the world is in the window."""
        state = self.editor.settle()
        return state["origin"]["x"] + state["zoom"] * x, state["origin"]["y"] - state["zoom"] * y

    def type_place(self, text):
        self.editor.key(*(KEYS.get(character, character) for character in text))
        self.editor.settle()

    def run_typed(self, text):
        views.run_typed(self.editor, text)

    def choose_tool(self, tool, choice):
        self.editor.click_widget(f"tool {tool}")
        self.editor.wait(lambda state: f"menu-item {choice}" in state["widgets"] and state["is_settled"], "the choices")
        self.editor.click_widget(f"menu-item {choice}")
        self.editor.settle()

    def choose(self, *names):
        menu, *items = names
        self.editor.click_widget(f"menu {menu}")
        for item in items:
            self.editor.click_widget(f"menu-item {item}")

    def wait_for_form(self):
        return self.editor.wait(lambda state: state["dialog"] == "command-form" and "form apply" in state["widgets"] and state["is_settled"],
                                "the form")

    def fill(self, field, text):
        name = f"form {field}"
        self.editor.click_widget(name)
        self.editor.key("ctrl+a")
        self.editor.type(text)
        self.editor.wait(lambda state: state["widgets"][name]["value"] == text and state["is_settled"], f"'{text}' in the field")

    def apply(self):
        undo_count = self.editor.settle()["undo_count"]
        self.editor.click_widget("form apply")
        return self.editor.wait(lambda state: state["dialog"] == "none" and state["undo_count"] > undo_count and state["is_settled"],
                                "the end of the form")

    def type_path(self, dialog, path):
        self.editor.wait(lambda state: state["dialog"] == dialog and state["is_settled"], "the file dialog")
        self.editor.key("ctrl+a")
        self.editor.type(path)
        self.editor.wait(lambda state: state["widgets"]["file-dialog name"]["value"] == str(path), "the typed path")
        self.editor.key("Return")
        self.editor.keys -= len(str(path.parent))  # which a test has elsewhere each time

    def wait_for_message(self, text):
        return self.editor.wait(lambda state: text in state["message"] and state["is_settled"], text)

    def save(self):
        """The saved curves."""
        self.editor.key("ctrl+s")
        if not self.path.exists():
            self.type_path("save-file", self.path)
        self.editor.wait(lambda state: not state["is_modified"] and state["dialog"] == "none" and state["is_settled"], "the saved file")
        return json.loads(self.path.read_text())["curves"]

    def undo_all(self):
        self.editor.key(*["ctrl+z"] * self.editor.settle()["undo_count"])
        self.editor.wait(lambda state: state["undo_count"] == 0 and state["curve_count"] == 0 and state["is_settled"], "an empty document")

    # What the page tells.

    def rest(self):
        """The pointer in a corner of the canvas, where it points at nothing."""
        canvas = self.editor.settle()["canvas"]
        self.editor.move(canvas["x"] + 3, canvas["y"] + 3)

    def picture(self, name):
        self.editor.settle()
        taken = self.editor.screenshot(f"{self.page}-{name}")
        self.pictures.append(taken.stem)
        if "BATTEN_PICTURES" in os.environ:
            kept = pathlib.Path(os.environ["BATTEN_PICTURES"]) / taken.name
            shutil.copy(taken, kept)
            views.shrink(kept, 32)

    def text(self):
        return (PAGES / f"{self.page}.md").read_text()

    def assert_told(self):
        if "BATTEN_PICTURES" in os.environ:
            return print(f"{self.page}: {self.editor.clicks} clicks and {self.editor.keys} keys")
        self.assertIn(f"{self.editor.clicks} clicks and {self.editor.keys} keys", self.text())
        self.assertEqual(re.findall(r"\]\(([\w-]+)\.png\)", self.text()), self.pictures)
        for name in self.pictures:
            self.assertLess((PAGES / f"{name}.png").stat().st_size, 64_000, name)

    def assert_found(self, what, value, limit):
        """The value is within the limit, and the page's table tells it, by two digits or as less than something."""
        self.assertLessEqual(value, limit, what)
        if "BATTEN_PICTURES" in os.environ:
            return print(f"{self.page}: {what}: {value}")
        told = re.search(rf"^\| {re.escape(what)} \| (<?) ?([-\d.e]+)", self.text(), re.MULTILINE)
        self.assertIsNotNone(told, f"the page tells: {what}, found {value}")
        if told[1]:
            self.assertLess(value, float(told[2]), what)
        else:
            self.assertAlmostEqual(value, float(told[2]), delta=0.05 * abs(float(told[2])), msg=what)
