"""The pen in the real window: its modes, taking back, closing, moving the view meanwhile; fit points dragged, inserted and deleted."""

import json
import unittest

from case import WindowTest


class PenTest(WindowTest):
    def setUp(self):
        super().setUp()
        self.editor = self.open_editor()
        canvas = self.editor.state()["canvas"]
        self.at = lambda x, y: (canvas["x"] + x, canvas["y"] + y)

    def take_pen(self, mode):
        self.editor.click_widget("tool draw-curve")
        self.editor.click_widget(f"menu-item pen-{mode}")
        self.editor.wait(lambda state: state["tool"] == "draw-curve" and state["is_settled"], mode)

    def click_all(self, *places):
        for place in places:
            self.editor.click(*self.at(*place))
            self.editor.settle()

    def wait_for_curves(self, count):
        return self.editor.wait(lambda state: state["curve_count"] == count and state["is_settled"], f"{count} curves")

    def wait_for_message(self, text):
        self.editor.wait(lambda state: text in state["message"] and state["is_settled"], text)

    def last_curve(self):
        self.save(self.editor)
        return json.loads(self.path.read_text())["curves"][-1]

    def test_a_curve_through_the_points(self):
        editor = self.editor
        self.take_pen("through-c2")
        places = [(200, 60), (320, 20), (440, 60), (560, 30)]
        self.click_all(*places, (600, 300))
        editor.key("BackSpace")
        editor.move(*self.at(640, 60))
        editor.settle()
        editor.screenshot("through")
        editor.key("Return")
        self.wait_for_curves(2)
        fit = self.last_curve()["fit"]
        self.assertEqual(fit["kind"], "c2")
        self.assertEqual(len(fit["points"]), 4, "one was taken back")
        editor.drag(self.at(*places[1]), self.at(340, 80))
        self.wait_for_message("Moved fit point 1")
        editor.click(*self.at(*places[3]))
        editor.key("Delete")
        self.wait_for_message("Deleted fit point 3")
        editor.double_click(*self.at(*places[2]))
        self.wait_for_message("Set joint of fit point 2 to 'corner'")
        editor.click(*self.at(340, 80), button=3)
        editor.click_widget("menu-item give-fit-point-tangent")
        self.wait_for_message("Set joint of fit point 1 to 'tangent given'")
        editor.screenshot("joints")
        self.assertEqual(self.last_curve()["fit"]["joints"], ["smooth", "tangent", "corner"])

    def test_the_inspector_lists_the_fit_points(self):
        editor = self.editor
        self.take_pen("through-c2")
        self.click_all((200, 300), (320, 180), (440, 300))
        editor.key("Return")
        self.wait_for_curves(2)
        editor.click_widget("fit point 1 y")
        self.retype(editor, "fit point 1 y", "3.5")
        editor.key("Return")
        self.wait_for_message("Moved fit point 1")
        editor.click_widget("fit point 0")
        editor.settle()
        editor.click_widget("add fit point")
        self.wait_for_message("Inserted fit point 1")
        editor.click_widget("fit point 1 joint")
        editor.click_widget("menu-item make-fit-point-corner")
        self.wait_for_message("Set joint of fit point 1 to 'corner'")
        editor.click_widget("fit parameters")
        editor.screenshot("parameters")
        editor.click_widget("fit parameters uniform")
        self.wait_for_message("Made the curve through its points anew")
        editor.click_widget("fit point 3")
        editor.settle()
        editor.click_widget("delete fit point")
        self.wait_for_message("Deleted fit point 3")
        fit = self.last_curve()["fit"]
        self.assertEqual(fit["points"][2][1], 3.5)
        self.assertEqual((fit["joints"], fit["parametrization"], fit["parameters"]), (["smooth", "corner", "smooth"], "uniform", [0, 1, 2]))

    def test_the_first_point_closes_and_a_right_click_ends(self):
        self.take_pen("through-fair")
        self.click_all((200, 300), (320, 180), (440, 300))
        self.editor.move(*self.at(201, 301))
        self.editor.settle()
        self.editor.screenshot("closes")
        self.click_all((200, 300))
        self.wait_for_curves(2)
        self.assertTrue(self.last_curve()["fit"]["closed"])
        self.take_pen("control-points")
        self.click_all((300, 330), (420, 180), (540, 330))
        self.editor.click(*self.at(600, 350), button=3)
        state = self.wait_for_curves(3)
        self.assertEqual(len(state["points"]), 3)
        self.assertEqual(state["tool"], "select")

    def test_bezier_handles_are_dragged_out(self):
        self.take_pen("bezier")
        self.editor.drag(self.at(250, 350), self.at(250, 250))
        self.editor.drag(self.at(450, 350), self.at(450, 450), release=False)
        self.editor.settle()
        self.editor.screenshot("bezier")
        self.editor.release()
        self.click_all((600, 330))
        self.editor.key("Return")
        state = self.wait_for_curves(2)
        self.assertEqual(len(state["points"]), 7)
        self.assertAlmostEqual(state["points"][1]["y"], self.at(250, 250)[1], delta=9)
        self.assertAlmostEqual(state["points"][2]["y"], self.at(450, 250)[1], delta=9)

    def test_the_view_moves_while_drawing(self):
        self.take_pen("through-local")
        self.click_all((200, 300), (320, 180))
        self.editor.move(*self.at(400, 300))
        self.editor.press(2)
        self.editor.move(*self.at(450, 320))
        self.editor.release(2)
        self.editor.wheel(1)
        self.editor.key("ctrl+z")
        self.click_all((500, 250))
        self.editor.key("Return")
        self.wait_for_curves(2)
        self.assertEqual(len(self.last_curve()["fit"]["points"]), 2)


if __name__ == "__main__":
    unittest.main()
