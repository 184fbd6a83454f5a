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

    def test_cards_can_be_moved(self):
        editor = self.open_small()
        cards = self.present(editor)["widgets"]["floating cards"]
        start = (cards["x"] + 30, cards["y"] + cards["height"] - 12)
        editor.drag(start, (start[0] - 500, start[1]))
        moved = editor.settle()["widgets"]["floating cards"]
        self.assertLess(moved["x"], cards["x"] - 400)

    def test_says_what_was_done_and_which_keys_were_pressed(self):
        editor = self.open_small()
        self.present(editor)
        self.run_typed(editor, "insert-knot 0.5")
        caption = editor.settle()["widgets"]["presented message"]["value"]
        self.assertTrue(caption.startswith("p = 3: Inserted knot 0.5"), caption)
        self.assertIn("C¹", caption)
        self.run_typed(editor, "toggle-keys")
        editor.key("h")
        editor.wait(lambda state: state["widgets"].get("presented keys", {}).get("value") == "H: Hull", "the key")
        editor.screenshot("captions")


if __name__ == "__main__":
    unittest.main()
