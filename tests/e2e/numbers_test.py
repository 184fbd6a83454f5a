"""Numbers in the real window: few digits on screen, all of them where the pointer is."""

import unittest

from case import WindowTest


class NumbersTest(WindowTest):
    def tip_at(self, editor, name):
        """The text beside the pointer over a widget, with all of it in the window."""
        editor.move(*editor.widget_center(name))
        state = editor.wait(lambda state: "tool tip" in state["widgets"] and state["is_settled"], f"the tool tip of '{name}'")
        tip = state["widgets"]["tool tip"]
        self.assertGreaterEqual(tip["x"], 0)
        self.assertGreaterEqual(tip["y"], 0)
        return tip["value"]

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
