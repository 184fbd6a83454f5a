"""The views of derivatives in the real window: they follow what is dragged."""

import unittest

from case import WindowTest

OVERLAYS = ["polygon", "knots", "labels", "grid", "continuity", "end-derivatives", "hodograph", "second-hodograph"]


def card_texts(state, card):
    return [widget["value"] for name, widget in state["widgets"].items() if name.startswith(f"card {card} ")]


class DerivativesTest(WindowTest):
    def open_with_views(self):
        return self.open_editor(settings={"overlays": OVERLAYS})

    def test_the_meter_follows_a_knot_onto_another(self):
        editor = self.open_with_views()
        self.assertIn("u = 1/4: C² by its knots", card_texts(editor.state(), "continuity"))
        editor.drag(editor.strip_knot(5), editor.strip_knot(4), release=False)
        editor.wait(lambda state: "u = 1/4 ×2: C¹ by its knots" in card_texts(state, "continuity"), "C¹ while dragging")
        self.assertIn("C¹ by its knots", [label["text"] for label in editor.state()["labels"]])
        editor.screenshot("meter")
        editor.key("Escape")
        editor.release()
        editor.wait(lambda state: "u = 1/4: C² by its knots" in card_texts(state, "continuity"), "C² again")

    def test_a_row_of_the_meter_leads_to_its_knot(self):
        editor = self.open_with_views()
        name = next(
            name for name, widget in editor.state()["widgets"].items()
            if name.startswith("card continuity ") and widget["value"].startswith("u = 3/4")
        )
        editor.click_widget(name)
        editor.wait(lambda state: state["parameter"] == 0.75, "the parameter at the knot")

    def test_the_end_derivatives_follow_a_point(self):
        editor = self.open_with_views()
        # 3 (P1 - P0) / (1/4)
        self.assertIn("= (18, 57)", card_texts(editor.state(), "end-derivatives"))
        x, y = editor.point(1)
        editor.drag((x, y), (x + 40, y + 10), release=False)
        editor.wait(lambda state: "= (18, 57)" not in card_texts(state, "end-derivatives"), "other numbers")
        editor.release()


if __name__ == "__main__":
    unittest.main()
