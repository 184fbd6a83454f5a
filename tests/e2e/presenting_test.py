"""The projector mode: the whole screen, larger, with cards, captions and keys."""

import unittest

from case import WindowTest

SCREEN = (1920, 1080)
SMALL = {"window": {"x": 40, "y": 30, "width": 1000, "height": 700}}


class PresentingTest(WindowTest):
    def open_small(self, *arguments, **settings):
        return self.enterContext(self.start(self.display(*SCREEN), *arguments, settings={**SMALL, **settings}))

    def present(self, editor):
        editor.key("F11")
        return editor.wait(lambda state: state["canvas"]["width"] == SCREEN[0] and state["is_settled"], "the whole screen")

    def run_typed(self, editor, text):
        editor.key("ctrl+p")
        editor.wait(lambda state: state["dialog"] == "command-palette", "the palette")
        editor.type(text)
        editor.wait(lambda state: state["widgets"].get("palette input", {}).get("value") == text and state["is_settled"], text)
        editor.key("Return")
        editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "the end of the command")

    def test_covers_the_screen_and_goes_back(self):
        editor = self.open_small()
        before = editor.state()
        state = self.present(editor)
        self.assertNotIn("menu file", state["widgets"])
        self.assertIn("card triangle", state["widgets"], "which the inspector has otherwise")
        cards = state["widgets"]["floating cards"]
        for place in state["points"]:
            self.assertTrue(0 < place["x"] < cards["x"], "beside the cards")
        editor.screenshot("presenting")
        editor.key("F11")
        after = editor.wait(lambda state: state["canvas"]["width"] == before["canvas"]["width"] and state["is_settled"], "the window")
        self.assertIn("menu file", after["widgets"])

    def move_cards(self, editor, dx, dy):
        cards = editor.state()["widgets"]["floating cards"]
        start = (cards["x"] + 12, cards["y"] + cards["height"] - 12)
        editor.drag(start, (start[0] + dx, start[1] + dy))
        return editor.settle()["widgets"]["floating cards"]

    def test_cards_can_be_moved_and_stay_where_they_were_put(self):
        editor = self.open_small()
        cards = self.present(editor)["widgets"]["floating cards"]
        moved = self.move_cards(editor, -500, 0)
        self.assertLess(moved["x"], cards["x"] - 400)
        editor.key("F4")
        higher = editor.wait(lambda state: state["plot"]["height"] == 0 and state["is_settled"], "no plot")["widgets"]["floating cards"]
        self.assertEqual((higher["x"], higher["width"]), (moved["x"], moved["width"]))
        editor.key("F11")
        editor.wait(lambda state: "menu file" in state["widgets"] and state["is_settled"], "the window")
        again = self.present(editor)["widgets"]["floating cards"]
        self.assertEqual((again["x"], again["width"]), (moved["x"], moved["width"]))

    def test_cards_come_back_onto_the_canvas(self):
        editor = self.open_small()
        canvas = self.present(editor)["canvas"]
        cards = self.move_cards(editor, -1300, -400)
        self.assertGreaterEqual(cards["x"], canvas["x"])
        self.assertGreaterEqual(cards["y"], canvas["y"])
        self.assertLessEqual(cards["y"] + cards["height"], canvas["y"] + canvas["height"])

    def test_a_card_just_turned_on_is_in_view(self):
        editor = self.enterContext(self.start(self.display(1280, 720), settings={"window": {"x": 0, "y": 0, "width": 1280, "height": 720}}))
        editor.key("F11")
        editor.wait(lambda state: "floating cards" in state["widgets"] and state["is_settled"], "the cards")
        for view in ("continuity", "basis-pieces", "knot-questions", "halves"):
            self.run_typed(editor, f"toggle-{view}")
            state = editor.wait(lambda state, view=view: f"card {view} dismiss" in state["widgets"] and state["is_settled"], view)
            cards = state["widgets"]["floating cards"]
            card = state["widgets"][f"card {view}"]
            self.assertLess(card["y"], cards["y"] + cards["height"] / 2, view)
            if view == "knot-questions":
                editor.screenshot("cards-720")

    def test_tells_how_to_leave_until_something_is_done(self):
        editor = self.open_small()
        hint = self.present(editor)["widgets"]["presented hint"]["value"]
        for key in ("F11", "F4", "F2", "F1", "Ctrl+P"):
            self.assertIn(key, hint)
        editor.key("F2")
        editor.wait(lambda state: "presented hint" not in state["widgets"] and state["widgets"]["presented keys"]["value"] == "F2: Pressed keys", "the key")

    def test_says_what_was_done_and_which_keys_were_pressed(self):
        editor = self.open_small()
        self.present(editor)
        self.run_typed(editor, "insert-knot 0.5")
        caption = editor.settle()["widgets"]["presented message"]["value"]
        self.assertTrue(caption.startswith("Inserted knot 0.5"), caption)
        self.assertEqual(editor.state()["widgets"]["presented degree"]["value"], "p = 3")
        self.assertIn("C¹", caption)
        editor.key("F2")
        editor.key("h")
        editor.wait(lambda state: state["widgets"].get("presented keys", {}).get("value") == "H: Hull", "the key")
        editor.screenshot("captions")


if __name__ == "__main__":
    unittest.main()
