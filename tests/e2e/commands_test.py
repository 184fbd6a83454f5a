"""Commands by their names in the real window: found in the palette, typed, and filled in by forms."""

import unittest

import spline
from case import WindowTest


class CommandsTest(WindowTest):
    def open_palette(self, editor):
        editor.key("ctrl+p")
        editor.wait(lambda state: state["dialog"] == "command-palette" and "palette input" in state["widgets"], "the palette")

    def test_the_palette_shown_from_the_palette_is_empty_and_at_rest(self):
        editor = self.open_editor()
        self.find(editor, "command-palette")
        editor.key("Return")
        editor.wait(lambda state: state["dialog"] == "command-palette" and state["widgets"]["palette input"]["value"] == "" and state["is_settled"], "the palette")

    def find(self, editor, typed):
        """What the palette lists for what was typed, best first."""
        self.open_palette(editor)
        editor.type(typed)
        found = editor.wait(lambda state: state["widgets"].get("palette input", {}).get("value") == typed and state["is_settled"], typed)
        items = {name: place for name, place in found["widgets"].items() if name.startswith("palette-item ")}
        return [name.split()[1] for name in sorted(items, key=lambda name: items[name]["y"])]

    def leave(self, editor):
        editor.key("Escape")
        editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the end of the dialog")

    def open_form(self, editor, command):
        self.assertEqual(self.find(editor, command)[0], command)
        editor.key("Return")
        return editor.wait(lambda state: state["dialog"] == "command-form" and "form apply" in state["widgets"] and state["is_settled"], "the form")

    def test_the_palette_finds_by_titles_synonyms_overlays_and_examples(self):
        editor = self.open_editor()
        for typed, wanted in (
            ("bezier pi", "toggle-pieces"),
            ("bezier pieces overlay", "toggle-pieces"),
            ("divide", "split"),
            ("example t1", "knots-t1"),
            ("reverse direction", "reverse"),
        ):
            self.assertEqual(self.find(editor, typed)[0], wanted, typed)
            if typed == "bezier pi":
                editor.screenshot("bezier")
            self.leave(editor)

    def test_a_typed_command_runs_without_a_form(self):
        editor = self.open_editor()
        self.find(editor, "insert-knot 0.3")
        editor.key("Return")
        state = editor.wait(lambda state: state["dialog"] == "none" and state["undo_count"] == 1 and state["is_settled"], "the knot")
        self.assertIn(0.3, [knot["value"] for knot in state["knots"]])
        self.assertEqual(state["undo_label"], "Insert knot 0.3")

    def test_a_typed_command_that_is_refused_stays_with_the_reason(self):
        editor = self.open_editor()
        self.find(editor, "insert-knot 7")
        editor.key("Return")
        refused = editor.wait(lambda state: "dialog error" in state["widgets"] and state["is_settled"], "the reason")
        self.assertEqual(refused["widgets"]["palette input"]["value"], "insert-knot 7")
        self.assertIn("outside the domain", refused["widgets"]["dialog error"]["value"])

    def test_a_form_previews_what_is_typed_and_enter_applies_it(self):
        editor = self.open_editor()
        before = self.save(editor)
        self.choose(editor, "edit", "Points", "set-weight")
        editor.wait(lambda state: state["dialog"] == "command-form" and state["is_settled"], "the form")
        self.retype(editor, "form index", "3")
        editor.click_widget("form w")
        self.retype(editor, "form w", "4/2+2")
        shown = editor.wait(lambda state: state["has_preview"] and state["has_ghost"] and state["is_settled"], "the preview")
        editor.screenshot("weight")
        self.assertEqual(shown["undo_count"], 0)
        told = float(shown["widgets"]["form effect"]["value"].split("at most ")[1])
        editor.key("Return")
        editor.wait(lambda state: state["dialog"] == "none" and state["undo_count"] == 1 and not state["has_preview"], "the edit")
        after = self.save(editor)
        self.assertEqual(after["weights"], [1, 1, 1, 4, 1, 1, 1])
        deviation = spline.largest_deviation(before, after)
        self.assertLessEqual(deviation, told * 1.001)
        self.assertGreater(deviation, 0.3 * told)

    def test_a_form_does_not_take_an_earlier_message_for_its_own(self):
        editor = self.open_editor()
        editor.key("ctrl+c")
        editor.wait(lambda state: state["widgets"]["status message"]["value"].startswith("Copied"), "the message")
        editor.click_widget("menu file")
        editor.click_widget("menu-item set-units")
        shown = editor.wait(lambda state: state["dialog"] == "command-form" and state["has_preview"] and state["is_settled"], "the preview")
        self.assertEqual([name for name in ("form effect", "form hint") if name in shown["widgets"]], [])
        self.leave(editor)

    def test_escape_leaves_nothing_of_a_form(self):
        editor = self.open_editor()
        before = self.save(editor)
        self.open_form(editor, "extend")
        self.retype(editor, "form length", "3.5")
        editor.wait(lambda state: state["has_preview"] and state["is_settled"], "the preview")
        self.leave(editor)
        state = editor.state()
        self.assertEqual((state["has_preview"], state["has_ghost"], state["undo_count"]), (False, False, 0))
        self.assertEqual(self.save(editor), before)

    def test_a_form_says_what_is_wrong_and_does_not_apply_it(self):
        editor = self.open_editor()
        self.open_form(editor, "extend")
        for wrong, reason in (("-1", "length"), ("abc", "length"), ("1e400", "length")):
            self.retype(editor, "form length", wrong)
            refused = editor.wait(lambda state: "dialog error" in state["widgets"] and not state["has_preview"] and state["is_settled"], "the reason")
            self.assertIn(reason, refused["widgets"]["dialog error"]["value"])
            editor.key("Return")
            editor.settle()
            self.assertEqual((editor.state()["dialog"], editor.state()["undo_count"]), ("command-form", 0))
        self.retype(editor, "form length", "1")
        editor.wait(lambda state: state["has_preview"] and "dialog error" not in state["widgets"], "the preview")
        editor.click_widget("form cancel")
        editor.wait(lambda state: state["dialog"] == "none" and not state["has_preview"], "the end of the form")

    def test_a_number_that_suggests_itself_is_shown_with_a_few_digits_and_taken_with_all(self):
        editor = self.open_editor()
        before = self.save(editor)
        length = spline.length(before)
        self.open_form(editor, "set-length")
        shown = editor.wait(lambda state: state["has_preview"] and state["is_settled"], "the preview")["widgets"]
        self.assertAlmostEqual(float(shown["form length"]["value"]), length, delta=0.001)
        self.assertLess(len(shown["form length"]["value"]), 9)
        self.assertEqual(shown["form effect"]["value"], "≅ keeps the shape")
        self.retype(editor, "form length", "*=2")
        editor.key("Return")
        editor.wait(lambda state: state["dialog"] == "none" and state["undo_count"] == 1, "the edit")
        self.assertAlmostEqual(spline.length(self.save(editor)) / length, 2, 9)

    def test_a_choice_is_chosen_from_a_list(self):
        editor = self.open_editor()
        self.open_form(editor, "extend")
        before = editor.state()["points"]
        editor.click_widget("form end")
        editor.click_widget("form end start")
        editor.wait(lambda state: state["widgets"]["form end"]["value"] == "start" and state["points"][0] != before[0] and state["is_settled"], "the other end")
        editor.click_widget("form apply")
        editor.wait(lambda state: state["undo_count"] == 1 and state["dialog"] == "none", "the edit")
        self.assertNotEqual(self.save(editor)["points"][0], [-6, -2.25])


if __name__ == "__main__":
    unittest.main()
