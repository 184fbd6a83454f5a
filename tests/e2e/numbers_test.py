"""Numbers in the real window: few digits on screen, all of them where the pointer is and on the clipboard, one value everywhere."""

import json
import re
import unittest

import spline
from case import WindowTest


class NumbersTest(WindowTest):
    def run_typed(self, editor, command):
        """Runs a command by its name in the palette, with what its form suggests."""
        self.open_palette(editor)
        editor.type(command)
        editor.wait(lambda state: state["widgets"]["palette input"]["value"] == command, "the command")
        editor.key("Return")
        if editor.wait(lambda state: state["dialog"] != "command-palette" and state["is_settled"], "the command's end")["dialog"] != "none":
            editor.key("Return")
        return editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the end of the form")

    def open_palette(self, editor):
        editor.key("ctrl+p")
        editor.wait(lambda state: state["dialog"] == "command-palette" and "palette input" in state["widgets"], "the palette")

    def tip_at(self, editor, name):
        """The text beside the pointer over a widget, with all of it in the window."""
        editor.move(*editor.widget_center(name))
        state = editor.wait(lambda state: "tool tip" in state["widgets"] and state["is_settled"], f"the tool tip of '{name}'")
        tip = state["widgets"]["tool tip"]
        self.assertGreaterEqual(tip["x"], 0)
        self.assertGreaterEqual(tip["y"], 0)
        return tip["value"]

    def copied_at(self, editor, name):
        """What Ctrl+C copies there, as a field of one line takes it: without the ends of lines."""
        editor.move(*editor.widget_center(name))
        editor.key("ctrl+c")
        editor.wait(lambda state: state["message"] == "Copied the text" and state["is_settled"], "the copy")
        self.open_palette(editor)
        editor.key("ctrl+v")
        text = editor.wait(lambda state: state["widgets"]["palette input"]["value"] and state["is_settled"], "the paste")["widgets"]["palette input"]["value"]
        editor.key("Escape")
        editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the end of the palette")
        return text

    def test_a_finding_has_all_digits_under_the_pointer_and_on_the_clipboard(self):
        editor = self.open_editor()
        curve = self.save(editor)
        self.choose(editor, "analyze", "Shape", "inflections")
        found = editor.wait(lambda state: "finding 0" in state["widgets"] and state["is_settled"], "the findings")
        label, parameter, place = found["widgets"]["finding 0"]["value"].split(" | ")
        tip = self.tip_at(editor, "finding 0")
        written = dict(re.findall(r"(\w) = (\S+)", tip))
        u, x, y = (float(written[name].replace("−", "-")) for name in "uxy")
        for found_there, wanted in zip((x, y), spline.point_at(curve, u)):
            self.assertAlmostEqual(found_there, wanted, delta=1e-14)
        self.assertGreaterEqual(min(len(text.strip("−0.")) for text in written.values()), 15)
        self.assertEqual((label, parameter), ("inflection", f"u {u:.6f}"))
        self.assertEqual(place, f"({x:.5f}, {y:.5f})".replace("-", "−"))
        numbers = tip.rsplit("\n", 1)[0]
        self.assertEqual(self.copied_at(editor, "finding 0"), numbers.replace("\n", "").replace("−", "-"))

    def test_a_message_has_all_digits_under_the_pointer_and_on_the_clipboard(self):
        editor = self.open_editor()
        curve = self.save(editor)
        length = spline.length(curve)
        told = self.run_typed(editor, "arc-length")
        self.assertEqual(told["widgets"]["status message"]["value"], f"wave has the length {length:.4f}")
        tip = self.tip_at(editor, "status message")
        whole = re.fullmatch(r"(wave has the length (\S+))\nCtrl\+C copies this", tip)
        self.assertAlmostEqual(float(whole[2]), length, delta=1e-9)
        self.assertGreaterEqual(len(whole[2]), 15)
        self.assertEqual(self.copied_at(editor, "status message"), whole[1])

    def test_a_refusal_has_all_digits_under_the_pointer_and_on_the_clipboard(self):
        editor = self.open_editor()
        editor.click_widget("section knots")
        editor.click_widget("knot 5 value")
        editor.wait(lambda state: state["widgets"]["knot 5 value"]["value"] == "0.5", "the field")
        self.retype(editor, "knot 5 value", "-7.123456789")
        editor.key("Return")
        editor.wait(lambda state: "notice text" in state["widgets"] and state["is_settled"], "the refusal")
        self.assertIn(" −7.12346,", editor.state()["widgets"]["notice text"]["value"])
        self.assertIn(" −7.123456789,", self.tip_at(editor, "notice text"))
        self.assertIn(" -7.123456789,", self.copied_at(editor, "notice text"))

    def test_what_a_dialog_refuses_has_all_digits_under_the_pointer(self):
        editor = self.open_editor()
        self.open_palette(editor)
        editor.type("insert-knot 1.23456789")
        editor.wait(lambda state: state["widgets"]["palette input"]["value"] == "insert-knot 1.23456789", "the command")
        editor.key("Return")
        refused = editor.wait(lambda state: "dialog error" in state["widgets"] and state["is_settled"], "the reason")
        self.assertIn(" 1.23457 ", refused["widgets"]["dialog error"]["value"])
        self.assertIn(" 1.23456789 ", self.tip_at(editor, "dialog error"))

    def test_a_typed_weight_is_the_same_in_its_field_in_the_table_and_on_the_canvas(self):
        editor = self.open_editor()
        editor.click_widget("point 5 w")
        editor.wait(lambda state: state["widgets"]["point 5 w"]["value"] == "1" and state["is_settled"], "the field")
        self.retype(editor, "point 5 w", "1.995")
        editor.key("Return")
        table = editor.wait(lambda state: state["undo_count"] == 1 and state["is_settled"], "the new weight")
        self.assertEqual(table["widgets"]["point 5 w"]["value"], "1.995")
        self.assertEqual([label["text"] for label in table["labels"] if "w " in label["text"]], ["· w 1.995"])
        self.assertIn(" to 1.995;", table["message"])
        editor.screenshot("weight")
        editor.click_widget("point 5 w")
        editor.wait(lambda state: state["widgets"]["point 5 w"]["value"] == "1.995" and state["is_settled"] and state["has_preview"] is False, "the field")
        editor.key("Escape")
        self.assertEqual(self.save(editor)["weights"][5], 1.995)

    def test_a_typed_weight_keeps_its_digits_beside_a_great_one(self):
        data = json.loads(self.path.read_text())
        data["curves"][0]["weights"] = [1, 1, 1, 12345.678, 1, 1.995, 1]
        self.path.write_text(json.dumps(data))
        state = self.open_editor().state()
        self.assertEqual(float(state["widgets"]["point 5 w"]["value"]), 1.995)
        self.assertEqual(state["widgets"]["point 3 w"]["value"], "12345.7")
        self.assertEqual([label["text"] for label in state["labels"] if "w " in label["text"]], ["· w 12345.7", "· w 1.995"])

    def test_a_number_that_does_not_fit_is_written_with_a_power_of_ten(self):
        data = json.loads(self.path.read_text())
        data["curves"][0]["points"] = [[x - 5e5, y + 5e5] for x, y in data["curves"][0]["points"]]
        self.path.write_text(json.dumps(data))
        size = (1024, 700)
        settings = {"window": {"x": 0, "y": 0, "width": size[0], "height": size[1]}}
        editor = self.enterContext(self.start(self.display(*size), self.path, "--display-scale", 2, settings=settings))
        self.assertEqual(editor.widget("point 0 x")["value"], "−5e5")
        self.assertEqual(self.tip_at(editor, "point 0 x"), "−500006")

    def test_a_field_with_a_hint_of_its_own_tells_all_digits_too(self):
        data = json.loads(self.path.read_text())
        data["curves"][0]["knots"] = [0, 0, 0, 0, 1 / 3, 1 / 3, 0.75, 1, 1, 1, 1]
        self.path.write_text(json.dumps(data))
        editor = self.open_editor()
        editor.click_widget("section knots")
        self.assertEqual(editor.widget("knot 4 value")["value"], "0.333")
        tip = self.tip_at(editor, "knot 4 value")
        self.assertTrue(tip.startswith("0.3333333333333333\n"), tip)
        self.assertIn("one knot out of the stack", tip)

    def test_tool_tips_lie_in_a_small_window(self):
        size = (1024, 700)
        settings = {"window": {"x": 0, "y": 0, "width": size[0], "height": size[1]}}
        editor = self.enterContext(self.start(self.display(*size), self.path, "--display-scale", 2, settings=settings))
        self.choose(editor, "analyze", "Shape", "inflections")
        editor.wait(lambda state: "finding 0" in state["widgets"] and state["is_settled"], "the findings")
        self.tip_at(editor, "finding 0")
        editor.screenshot("tip")
        tip, row = (editor.state()["widgets"][name] for name in ("tool tip", "finding 0"))
        self.assertLessEqual(tip["x"] + tip["width"], row["x"])


if __name__ == "__main__":
    unittest.main()
