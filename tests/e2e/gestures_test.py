"""What the pointer and the keys do in the real window: menus of a right click, tools and their pointers, the title line and the welcome screen."""

import unittest

from case import WindowTest

WELCOME_SIZES = ((1024, 700, 1), (1440, 900, 1), (1920, 1080, 1), (2880, 1800, 2))
LECTURE = ("bezier-cubic", "coons-open", "coons-closed", "cubic-de-boor")


def is_inside(place, other):
    return (other["x"] - 1 <= place["x"] and place["x"] + place["width"] <= other["x"] + other["width"] + 1
            and other["y"] - 1 <= place["y"] and place["y"] + place["height"] <= other["y"] + other["height"] + 1)


class GesturesTest(WindowTest):
    def start_with_welcome(self, width, height, scale):
        geometry = {"x": 0, "y": 0, "width": width, "height": height}
        return self.start(self.display(width, height), "--display-scale", scale, settings={"window": geometry})

    def test_the_welcome_screen_is_a_lecture_and_cuts_no_text(self):
        for width, height, scale in WELCOME_SIZES:
            with self.subTest(width=width, scale=scale), self.start_with_welcome(width, height, scale) as editor:
                editor.screenshot(f"welcome-{width}")
                widgets = editor.settle()["widgets"]
                cards = [widgets[f"example {name}"] for name in LECTURE[:3]]
                for name, card in zip(LECTURE, cards):
                    self.assertTrue(is_inside(widgets[f"example {name} sentence"], card), name)
                self.assertEqual([card["y"] for card in cards], [cards[0]["y"]] * 3)
                self.assertEqual(sorted(card["x"] for card in cards), [card["x"] for card in cards])
                dialog = widgets["dialog"]
                self.assertGreater(dialog["width"], 0.9 * width)
                self.assertGreater(dialog["height"], 0.9 * height)

    def test_the_welcome_screen_of_a_small_window_shows_a_whole_card_and_scrolls_to_the_last(self):
        with self.start_with_welcome(1024, 700, 2) as editor:
            editor.screenshot("welcome-small")
            widgets = editor.settle()["widgets"]
            self.assertTrue(is_inside(widgets["example bezier-cubic"], widgets["dialog"]))
            self.assertTrue(is_inside(widgets["example bezier-cubic sentence"], widgets["example bezier-cubic"]))
            self.assertGreater(widgets["example coons-open"]["height"], 10, "the next one shows that there is more")
            editor.move(*editor.widget_center("example bezier-cubic"))
            editor.wheel(-200)
            editor.wait(lambda state: "example wave" in state["widgets"] and state["is_settled"], "the last card")
            editor.click_widget("example wave")
            editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the example")

    def test_the_title_line_stays_until_dismissed_and_returns_with_the_next_example(self):
        with self.start_with_welcome(1440, 900, 1) as editor:
            editor.click_widget("example bezier-cubic")
            shown = editor.wait(lambda state: "title sentence" in state["widgets"] and state["is_settled"], "the title line")
            self.assertEqual(shown["widgets"]["title"]["value"], "Bézier cubic")
            self.assertIn("de Casteljau", shown["widgets"]["title sentence"]["value"])
            line, canvas = shown["widgets"]["title sentence"], shown["canvas"]
            self.assertLessEqual(line["y"] + line["height"], canvas["y"])
            for point in shown["points"]:
                self.assertTrue(canvas["y"] < point["y"] < canvas["y"] + canvas["height"])
            editor.screenshot("title")
            editor.drag(editor.point(1), (editor.point(1)[0] + 30, editor.point(1)[1]))
            self.assertIn("title", editor.settle()["widgets"])
            editor.key("ctrl+z")
            editor.click_widget("title dismiss")
            gone = editor.wait(lambda state: "title" not in state["widgets"] and state["is_settled"], "the line to go")
            self.assertLess(gone["canvas"]["y"], canvas["y"])
            editor.click_widget("menu file")
            editor.click_widget("menu-item examples")
            editor.click_widget("menu-item example knot-insertion")
            back = editor.wait(lambda state: "title" in state["widgets"] and state["is_settled"], "the next title")
            self.assertEqual((back["dialog"], back["is_modified"]), ("none", False))
            self.assertIn("two control points become three", back["widgets"]["title sentence"]["value"])

    def open_menu(self, editor, x, y, wanted):
        editor.click(x, y, button=3)
        return editor.wait(lambda state: f"menu-item {wanted}" in state["widgets"] and state["is_settled"], f"a menu with {wanted}")

    def close_menu(self, editor):
        editor.key("Escape")
        editor.wait(lambda state: not any(name.startswith("menu-item") for name in state["widgets"]) and state["is_settled"], "the end of the menu")

    def test_a_right_click_opens_a_menu_of_what_is_there(self):
        editor = self.open_editor()
        canvas = editor.state()["canvas"]
        empty = (canvas["x"] + canvas["width"] - 30, canvas["y"] + canvas["height"] - 40)
        shown = self.open_menu(editor, *editor.point(2), "set-weight")
        self.assertEqual(shown["selected_points"], [2])
        editor.screenshot("point")
        self.open_menu(editor, *empty, "fit")
        self.close_menu(editor)
        editor.click_widget("section curves")
        editor.wait(lambda state: "curve 0 name" in state["widgets"] and state["is_settled"], "the list of curves")
        leg = [(a + b) / 2 for a, b in zip(editor.point(4), editor.point(5))]
        places = (
            ("plot", editor.strip_knot(5), "raise-knot"),
            ("curve", tuple(editor.state()["curve_places"][3][axis] for axis in "xy"), "insert-knot"),
            ("leg", leg, "add-point"),
            ("row of a point", editor.widget_center("point 4 name"), "set-point"),
            ("row of a curve", editor.widget_center("curve 0 name"), "rename-curve"),
            ("heading", editor.widget_center("section points"), "toggle-inspector"),
            ("edge of the inspector", editor.widget_center("inspector edge"), "toggle-inspector"),
            ("edge of the dock", editor.widget_center("dock edge"), "toggle-inspector"),
            ("tool bar", editor.widget_center("tool weight"), "tool-weight"),
            ("status bar", editor.widget_center("status zoom"), "copy-text"),
        )
        for name, place, wanted in places:
            with self.subTest(name=name):
                self.open_menu(editor, *place, wanted)
                self.close_menu(editor)
        self.open_menu(editor, *editor.strip_knot(5), "raise-knot")
        editor.click_widget("menu-item raise-knot")
        editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the knot")
        self.assertEqual(self.save(editor)["knots"], [0, 0, 0, 0, 0.25, 0.5, 0.5, 0.75, 1, 1, 1, 1])

    def test_the_middle_of_a_drag_listens_to_typed_functions_and_to_ctrl_z(self):
        editor = self.open_editor()
        before = self.save(editor)["points"]
        start = editor.point(2)
        editor.drag(start, (start[0] + 60, start[1] - 20), release=False)
        editor.key("ctrl+z")
        editor.release()
        self.assertEqual((editor.settle()["undo_count"], self.save(editor)["points"]), (0, before))
        editor.drag(editor.point(2), (start[0] + 60, start[1] - 20), release=False)
        editor.type("sqrt(9)<90")
        editor.key("Return")
        editor.release()
        self.assertEqual(editor.settle()["undo_count"], 1)
        (x, y), (was_x, was_y) = self.save(editor)["points"][2], before[2]
        self.assertAlmostEqual(x, was_x, delta=1e-12)
        self.assertAlmostEqual(y, was_y + 3, delta=1e-12)

    def test_tools_show_their_pointer_and_escape_leaves_them(self):
        editor = self.open_editor()
        canvas = editor.state()["canvas"]
        editor.move(canvas["x"] + canvas["width"] - 30, canvas["y"] + 40)
        self.assertEqual(editor.settle()["cursor"], "arrow")
        for key, tool, cursor in (("a", "add-point", "crosshair"), ("k", "insert-knot", "crosshair"), ("w", "weight", "crosshair"),
                                  ("n", "draw-curve", "crosshair"), ("u", "parameter", "hand")):
            editor.key(key)
            self.assertEqual(editor.wait(lambda state: state["tool"] == tool and state["is_settled"], tool)["cursor"], cursor)
            editor.key("Escape")
            self.assertEqual(editor.wait(lambda state: state["tool"] == "select" and state["is_settled"], "select")["cursor"], "arrow")
        editor.move(*editor.point(2))
        self.assertEqual(editor.settle()["cursor"], "move")
        editor.move(*editor.widget_center("inspector edge"))
        self.assertEqual(editor.settle()["cursor"], "horizontal")
        editor.move(*editor.widget_center("dock edge"))
        self.assertEqual(editor.settle()["cursor"], "vertical")

    def test_the_pen_taken_anew_begins_a_new_curve(self):
        editor = self.open_editor()
        canvas = editor.state()["canvas"]
        at = lambda x, y: (canvas["x"] + x, canvas["y"] + y)
        editor.key("n")
        editor.click(*at(60, 60))
        editor.click(*at(160, 60))
        editor.key("v", "n")
        kept = editor.wait(lambda state: state["curve_count"] == 2 and state["is_settled"], "the curve that another tool ended")
        self.assertEqual(kept["undo_count"], 1)
        for place in (at(300, 300), at(400, 320), at(500, 300)):
            editor.click(*place)
        editor.key("Return")
        drawn = editor.wait(lambda state: state["curve_count"] == 3 and state["is_settled"], "the curve")
        self.assertEqual(len(drawn["points"]), 5)
        self.assertAlmostEqual(drawn["points"][0]["x"], at(300, 300)[0], delta=0.01)
        self.assertEqual(drawn["tool"], "select")

    def test_a_second_curve_leaves_the_inspector_where_it_is(self):
        editor = self.open_editor()

        def headings():
            widgets = editor.settle()["widgets"]
            return {name: place["y"] for name, place in widgets.items() if name.startswith(("section ", "point "))}

        before = headings()
        self.assertIn("section curve", before)
        editor.key("ctrl+c", "ctrl+v")
        editor.wait(lambda state: state["curve_count"] == 2 and state["is_settled"], "the copy")
        after = headings()
        self.assertEqual(after, before)

    def test_a_paste_lands_beside_its_original(self):
        editor = self.open_editor()
        before = editor.state()["points"]
        editor.key("ctrl+c", "ctrl+v")
        after = editor.wait(lambda state: state["curve_count"] == 2 and state["is_settled"], "the copy")["points"]
        for old, new in zip(before, after):
            self.assertTrue(16 <= new["x"] - old["x"] <= 40)
            self.assertAlmostEqual(new["y"] - old["y"], new["x"] - old["x"], delta=0.01)

    def test_sideways_scrolling_pans(self):
        editor = self.open_editor()
        editor.move(*editor.point(3))
        before = editor.state()
        editor.xdotool("click", 7)
        after = editor.wait(lambda state: state["points"] != before["points"] and state["is_settled"], "the panning")
        self.assertEqual(after["zoom"], before["zoom"])
        for old, new in zip(before["points"], after["points"]):
            self.assertAlmostEqual(new["x"] - old["x"], -60, delta=0.01)
            self.assertAlmostEqual(new["y"], old["y"], delta=0.01)

    def test_delete_with_all_points_removes_the_curve(self):
        editor = self.open_editor()
        editor.key("ctrl+a", "Delete")
        editor.wait(lambda state: state["curve_count"] == 0 and not state["message_is_error"] and state["is_settled"], "an empty document")


if __name__ == "__main__":
    unittest.main()
