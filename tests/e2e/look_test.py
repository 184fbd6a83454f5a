"""The look of the window at common sizes, in both themes and at scale 2, kept as pictures; and that nothing is drawn while nothing happens."""

import os
import subprocess
import time
import unittest

from case import WindowTest

SIZES = ((1024, 700), (1280, 720), (1440, 900), (1920, 1080))
MENUS = ("file", "edit", "make", "curve", "construct", "analyze", "view", "watch", "help")
TOOLS = ("tool select", "tool add-point", "tool insert-knot", "tool weight", "tool draw-curve", "tool parameter",
         "tool-bar undo", "tool-bar redo", "tool-bar fit", "tool-bar toggle-play")


def processor_seconds(process):
    with open(f"/proc/{process.pid}/stat") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def luminance(color):
    """Relative, 0 to 1, of 8-bit sRGB."""
    parts = [part / 255 for part in color]
    red, green, blue = (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


class LookTest(WindowTest):
    def assert_inside(self, state, size):
        for name, place in state["widgets"].items():
            self.assertGreaterEqual(place["x"], -1, name)
            self.assertLessEqual(place["x"] + place["width"], size[0] + 1, name)

    def test_sizes_and_themes(self):
        for size in SIZES:
            with self.subTest(size=size):
                geometry = {"x": 0, "y": 0, "width": size[0], "height": size[1]}
                with self.start(self.display(*size), settings={"window": geometry}) as editor:
                    name = f"{size[0]}x{size[1]}"
                    editor.screenshot(f"dark-{name}")
                    self.assert_inside(editor.state(), size)
                    editor.key("t")
                    editor.wait(lambda state: state["theme"] == "light" and state["is_settled"], "the light theme")
                    editor.screenshot(f"light-{name}")

    def assert_reachable_tools(self, editor):
        names = set(editor.state()["widgets"])
        if "tool-bar more" in names:
            editor.click_widget("tool-bar more")
            names |= set(editor.wait(lambda state: TOOLS[-1] in state["widgets"], "the rest of the tools")["widgets"])
            editor.key("Escape")
        self.assertLessEqual(set(TOOLS), names)

    def assert_reachable_triangle(self, editor):
        x, y = editor.widget_center("section curve")
        editor.move(x, y)
        for _ in range(40):
            widgets = editor.settle()["widgets"]
            if "cell 3 0" in widgets and "step 3" in widgets:
                return
            editor.wheel(-1)
        self.fail("the triangle is not to be reached")

    def assert_whole_key_sheet(self, editor):
        editor.key("F1")
        widgets = editor.wait(lambda state: "key-sheet signs" in state["widgets"] and state["is_settled"], "the keys")["widgets"]
        sheet, signs = widgets["dialog"], widgets["key-sheet signs"]
        self.assertLess(signs["x"] + signs["width"], sheet["x"] + sheet["width"] - 10)
        editor.key("Escape")

    def test_nothing_is_cut_off_in_a_small_window_of_any_scale(self):
        size = (1024, 700)
        geometry = {"x": 0, "y": 0, "width": size[0], "height": size[1]}
        for scale in (1.0, 1.5, 2.0):
            with self.subTest(scale=scale):
                settings = {"window": geometry, "user_scale": scale}
                with self.start(self.display(*size), settings=settings) as editor:
                    editor.screenshot(f"small-{scale}")
                    state = editor.state()
                    self.assert_inside(state, size)
                    for menu in MENUS:
                        self.assertIn(f"menu {menu}", state["widgets"])
                    for x, y in (editor.point(i) for i in range(7)):
                        canvas = state["canvas"]
                        self.assertTrue(canvas["x"] < x < canvas["x"] + canvas["width"], scale)
                        self.assertTrue(canvas["y"] < y < canvas["y"] + canvas["height"], scale)
                    self.assert_reachable_tools(editor)
                    self.assert_reachable_triangle(editor)
                    self.assert_whole_key_sheet(editor)

    def test_a_title_that_finds_no_room_ends_with_a_clause(self):
        size = (1024, 700)
        settings = {"window": {"x": 0, "y": 0, "width": size[0], "height": size[1]}, "user_scale": 2.0}
        with self.start(self.display(*size), "--example", "wave", settings=settings) as editor:
            editor.screenshot("small-title")
            state = editor.settle()
            sentence, canvas = state["widgets"]["title sentence"], state["canvas"]
            self.assertGreater(sentence["height"], 10)
            self.assertLess(sentence["y"] + sentence["height"], canvas["y"])

    def test_a_form_in_a_low_window_shows_its_first_rows_whole(self):
        size = (1024, 700)
        settings = {"window": {"x": 0, "y": 0, "width": size[0], "height": size[1]}, "user_scale": 2.0}
        with self.start(self.display(*size), settings=settings) as editor:
            editor.key("ctrl+p")
            editor.wait(lambda state: state["dialog"] == "command-palette" and state["is_settled"], "the palette")
            editor.type("set-units")
            editor.wait(lambda state: state["widgets"]["palette input"]["value"] == "set-units", "the name")
            editor.key("Return")
            widgets = editor.wait(lambda state: "form scale" in state["widgets"] and state["is_settled"], "the form")["widgets"]
            editor.screenshot("low-form")
            unit, scale, button = widgets["form unit"], widgets["form scale"], widgets["form apply"]
            self.assertGreater(unit["height"], 40)
            self.assertAlmostEqual(unit["height"], scale["height"], delta=1)
            self.assertLess(scale["y"] + scale["height"], button["y"])

    def test_the_numbers_of_a_narrow_table_have_the_same_decimals(self):
        size = (1024, 700)
        settings = {"window": {"x": 0, "y": 0, "width": size[0], "height": size[1]}}
        with self.start(self.display(*size), self.path, "--display-scale", 2, settings=settings) as editor:
            widgets = editor.settle()["widgets"]
            shown = [widgets[f"point {i} {axis}"]["value"] for i in range(2) for axis in "xy"]
            self.assertEqual([len(text.partition(".")[2]) for text in shown], [1] * 4, shown)
            editor.click_widget("section curve")
            editor.click_widget("section points")
            editor.click_widget("section knots")
            widgets = editor.wait(lambda state: "knot 5 value" in state["widgets"] and state["is_settled"], "the knots")["widgets"]
            self.assertEqual([widgets[f"knot {i} value"]["value"] for i in (0, 4, 5)], ["0.00", "0.25", "0.50"])
            editor.screenshot("narrow-knots")

    def pixels(self, picture, place):
        """The colors in a place of a screenshot, as (red, green, blue)."""
        box = f"{place['width']:.0f}x{place['height']:.0f}+{place['x']:.0f}+{place['y']:.0f}"
        raw = subprocess.run(["convert", str(picture), "-crop", box, "-depth", "8", "rgb:-"], capture_output=True, check=True).stdout
        return set(zip(raw[0::3], raw[1::3], raw[2::3]))

    def test_an_empty_check_box_stands_out_from_its_field(self):
        editor = self.open_editor()
        for theme in ("dark", "light"):
            state = editor.wait(lambda state: state["theme"] == theme and state["is_settled"], f"the {theme} theme")
            self.assertEqual(state["widgets"]["closed"]["value"], "off")
            levels = sorted(luminance(color) for color in self.pixels(editor.screenshot(f"box-{theme}"), state["widgets"]["closed"]))
            self.assertGreaterEqual((levels[-1] + 0.05) / (levels[0] + 0.05), 3.0, theme)
            editor.key("t")

    def test_scale_two(self):
        size = (2880, 1800)
        geometry = {"x": 0, "y": 0, "width": size[0], "height": size[1]}
        arguments = (self.path, "--display-scale", "2")
        with self.start(self.display(*size), *arguments, settings={"window": geometry}) as editor:
            self.assertEqual(editor.state()["interface_scale"], 2)
            editor.screenshot("scale-2")
            self.assert_inside(editor.state(), size)

    def test_playing_shows_one_parameter_in_a_frame(self):
        editor = self.open_editor()
        editor.click_widget("play")
        shown = set()
        while len(shown) < 20:
            state = editor.wait(lambda state: state["is_playing"], "the parameter in motion")
            u = f"{state['parameter']:.3f}"
            labels = [label["text"] for label in state["labels"]]
            self.assertIn(f"C({u})", labels)
            self.assertIn(u, [text.split(" = ")[1] for text in labels if " u = " in text])
            self.assertEqual(state["widgets"]["parameter"]["value"], u)
            self.assertIn(f"u = {u}", state["widgets"]["section construction"]["value"])
            shown.add(u)

    def test_idle_draws_nothing(self):
        editor = self.open_editor()
        before = editor.settle()["frame_count"]
        used = processor_seconds(editor.process)
        time.sleep(2.0)
        self.assertEqual(editor.state()["frame_count"], before)
        self.assertLessEqual(processor_seconds(editor.process) - used, 0.03)


if __name__ == "__main__":
    unittest.main()
