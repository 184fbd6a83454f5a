"""Figures of what the window shows."""

import unittest
import xml.etree.ElementTree

from case import WindowTest

SVG = "{http://www.w3.org/2000/svg}"


class FiguresTest(WindowTest):
    def run_typed(self, editor, text):
        editor.key("ctrl+p")
        editor.wait(lambda state: state["dialog"] == "command-palette" and "palette input" in state["widgets"], "the palette")
        editor.type(text)
        editor.wait(lambda state: state["widgets"]["palette input"]["value"] == text and state["is_settled"], text)
        editor.key("Return")

    def test_a_figure_shows_the_points_where_the_window_does(self):
        editor = self.open_editor()
        figure = self.folder / "wave.svg"
        self.run_typed(editor, f"export-figure {figure}")
        state = editor.wait(lambda state: state["message"] == "Exported wave.svg" and state["is_settled"], "the figure")
        editor.screenshot("window")
        discs = [circle for circle in xml.etree.ElementTree.parse(figure).getroot().iter(SVG + "circle") if circle.get("r") == "6.5"]
        shown = sorted((float(disc.get("cx")), float(disc.get("cy"))) for disc in discs)
        points = sorted((point["x"], point["y"]) for point in state["points"])
        self.assertEqual(len(shown), 7)
        # The canvas begins somewhere in the window.
        left, top = points[0][0] - shown[0][0], points[0][1] - shown[0][1]
        for place, point in zip(shown, points):
            self.assertAlmostEqual(place[0] + left, point[0], delta=1.0)
            self.assertAlmostEqual(place[1] + top, point[1], delta=1.0)

    def test_the_menu_asks_for_the_file(self):
        editor = self.open_editor()
        editor.click_widget("menu file")
        editor.click_widget("menu-item export-figure")
        editor.wait(lambda state: state["dialog"] == "command-form" and "form path" in state["widgets"] and state["is_settled"], "the form")
        figure = self.folder / "wave.pdf"
        self.assertEqual(editor.state()["widgets"]["form apply"]["value"], "Export figure")
        another = self.folder / "another.svg"
        another.write_text("what was there")
        editor.click_widget("form path")
        self.retype(editor, "form path", str(another))
        editor.click_widget("form apply")
        editor.wait(lambda state: "is there already" in state["widgets"].get("dialog error", {}).get("value", "") and state["is_settled"], "the refusal")
        editor.click_widget("form path")
        self.retype(editor, "form path", str(figure))
        editor.wait(lambda state: "dialog error" not in state["widgets"] and state["is_settled"], "no refusal for the other name")
        editor.click_widget("form apply")
        editor.wait(lambda state: state["message"] == "Exported wave.pdf", "the figure")
        self.assertTrue(figure.read_bytes().startswith(b"%PDF-"))
        self.assertEqual(another.read_text(), "what was there")

    def test_all_fields_are_reached_in_a_small_window(self):
        settings = {"window": {"x": 0, "y": 0, "width": 1024, "height": 700}, "user_scale": 2.0}
        editor = self.enterContext(self.start(self.display(1024, 700), settings=settings))
        self.run_typed(editor, "Export figure")
        state = editor.wait(lambda state: state["dialog"] == "command-form" and "form path" in state["widgets"] and state["is_settled"], "the form")
        self.assertTrue(state["widgets"]["form path"]["value"].startswith("/"), "in which folder it will be")
        editor.screenshot("export-figure-in-a-small-window")
        apply = state["widgets"]["form apply"]
        fields = ["path", "view", "width", "height", "scale", "title", "theme", "transparent", "replace"]
        in_view = lambda widgets, name: f"form {name}" in widgets and widgets[f"form {name}"]["y"] + widgets[f"form {name}"]["height"] <= apply["y"]
        self.assertGreaterEqual(sum(in_view(state["widgets"], name) for name in fields), 3)
        for name in fields:
            editor.move(*editor.widget_center("form cancel"))
            for _ in range(20):
                if in_view(editor.state()["widgets"], name):
                    break
                editor.move(600, 250)
                editor.wheel(-1)
                editor.settle()
            self.assertTrue(in_view(editor.state()["widgets"], name), name)

    def test_a_figure_has_the_size_and_the_colors_that_are_asked_for(self):
        editor = self.open_editor()
        figure = self.folder / "wave.svg"
        self.run_typed(editor, f'export-figure {figure} both 300 250 1 "" high-contrast')
        editor.wait(lambda state: state["message"].startswith("Exported wave.svg"), "the figure")
        root = xml.etree.ElementTree.parse(figure).getroot()
        self.assertEqual((root.get("width"), root.get("height")), ("300", "250"))
        self.assertEqual(root.find(f".//{SVG}rect").get("fill"), "#ffffff")


if __name__ == "__main__":
    unittest.main()
