"""Every teaching view in the real window, in both themes, at common sizes and for a projector, as docs/tour.md shows it."""

import os
import re
import subprocess
import unittest

import views
from case import WindowTest

SMALL = (1280, 720)
LARGE = (1920, 1080)
TOUR = views.TOUR.with_suffix(".md")


def texts_of(state):
    cards = [widget["value"] for name, widget in state["widgets"].items() if name.startswith("card ")]
    return cards + [label["text"] for label in state["labels"]]


def identified(picture, what):
    return subprocess.run(["identify", "-format", what, picture], capture_output=True, text=True, check=True).stdout


def says(state, wanted):
    return any(wanted in text for text in texts_of(state))


class Chapter:
    """Tests of the views of one chapter."""

    chapter = ()

    def test_small(self):
        self.look_at_all(SMALL, is_presented=False)

    def test_large_and_presented(self):
        self.look_at_all(LARGE, is_presented=True)

    def look_at_all(self, size, is_presented):
        display = self.display(*size)
        for view in self.chapter:
            with self.subTest(view=view.name), views.shown(view, os.environ["BATTEN_BINARY"], display, self.artifacts()) as editor:
                if is_presented and not view.is_presented:
                    self.look_presented(view, editor, display)
                for _ in range(2):
                    theme = editor.state()["theme"]
                    self.look(view, editor, size, f"{theme}-{size[1]}")
                    editor.key("t")
                    editor.wait(lambda state, theme=theme: state["theme"] != theme and state["is_settled"], "the other theme")

    def look_presented(self, view, editor, display):
        views.present(editor, display)
        views.rest_pointer(view, editor)
        self.look(view, editor, display.size, "presented")
        editor.key("F11")
        editor.wait(lambda state: "menu file" in state["widgets"] and state["is_settled"], "the window")
        views.rest_pointer(view, editor)

    def look(self, view, editor, size, name):
        state = editor.settle()
        self.assert_shows(view, state, name)
        self.assert_inside(state, size, name)
        self.assert_drawn(editor.screenshot(f"{view.name}-{name}"), state)

    def assert_shows(self, view, state, name):
        """The overlays are on, their cards are there, and all is said."""
        self.assertLessEqual(set(view.overlays), set(state["overlays"]), name)
        self.assertFalse(state["message_is_error"], state["message"])
        for card in view.cards():
            self.assertIn(f"card {card}", list(state["widgets"]), name)
        self.assertEqual([text for text in view.says if not says(state, text)], [], name)

    def assert_inside(self, state, size, name):
        """No widget is cut at the sides of the window, no label stands outside of canvas and plot."""
        for widget, place in state["widgets"].items():
            self.assertGreaterEqual(place["x"], -1, (widget, name))
            self.assertLessEqual(place["x"] + place["width"], size[0] + 1, (widget, name))
        canvas, plot = state["canvas"], state["plot"]
        for label in state["labels"]:
            self.assertTrue(canvas["x"] <= label["x"] <= canvas["x"] + canvas["width"], (label, name))
            self.assertTrue(canvas["y"] <= label["y"] <= plot["y"] + plot["height"], (label, name))

    def assert_drawn(self, picture, state):
        """The canvas has hundreds of colors, by the soft edges of lines."""
        place = state["canvas"]
        box = f"{place['width']:.0f}x{place['height']:.0f}+{place['x']:.0f}+{place['y']:.0f}"
        self.assertGreater(int(identified(f"{picture}[{box}]", "%k")), 200, picture)


class ConstructionTest(Chapter, WindowTest):
    chapter = views.CONSTRUCTION + views.INSERTION


class BasisTest(Chapter, WindowTest):
    chapter = views.BASIS + views.QUESTIONS


class ShapeTest(Chapter, WindowTest):
    chapter = views.SHAPE


class CubicsTest(Chapter, WindowTest):
    chapter = views.CUBICS + views.WEIGHTS


class TeachingTest(Chapter, WindowTest):
    chapter = views.TEACHING


class WithoutTest(WindowTest):
    def test_what_a_view_says_is_not_said_without_it(self):
        display = self.display(*SMALL)
        for view in views.VIEWS:
            if not view.overlays or view.is_presented:
                continue
            with self.subTest(view=view.name), views.shown(view.plain(), os.environ["BATTEN_BINARY"], display, self.artifacts()) as editor:
                state = editor.state()
                for card in view.cards():
                    self.assertNotIn(f"card {card}", list(state["widgets"]))
                self.assertTrue(any(not says(state, text) for text in view.says))


class TourTest(unittest.TestCase):
    def test_the_tour_names_every_view_and_has_every_picture(self):
        header = (views.ROOT / "app" / "editor" / "state" / "overlay.h").read_text()
        names = re.findall(r'Named\{\w+, "([\w-]+)"', header)
        count = int(re.search(r"basic_overlay_count = (\d+)", header)[1])
        tour = TOUR.read_text()
        shown = {overlay for view in views.VIEWS for overlay in view.overlays}
        for name in names[count:]:
            self.assertIn(name, shown, "a picture")
            self.assertIn(f"`toggle-{name}`", tour)
        pictures = re.findall(r"\]\(tour/([\w-]+)\.png\)", tour)
        self.assertEqual(sorted(pictures), sorted(view.name for view in views.VIEWS))
        self.assertEqual({path.stem for path in views.TOUR.iterdir()}, set(pictures))
        for picture in pictures:
            size = identified(views.TOUR / f"{picture}.png", "%w %h")
            self.assertEqual(size, "{} {}".format(*views.PICTURE_SIZE), picture)


if __name__ == "__main__":
    unittest.main()
