"""Drawing with the pencil in the real window: a stroke, its smoothness, a part drawn anew."""

import json
import math
import unittest

from case import WindowTest


class DrawingTest(WindowTest):
    def draw(self, editor, places):
        editor.move(*places[0])
        editor.press()
        for place in places[1:]:
            editor.move(*place)
        editor.release()

    def arc(self, editor, start, end, radius, count=60):
        canvas = editor.settle()["canvas"]
        x, y = canvas["x"] + canvas["width"] / 2, canvas["y"] + canvas["height"] / 2
        angles = [start + (end - start) * k / count for k in range(count + 1)]
        return [(round(x + radius * math.cos(a)), round(y - radius * math.sin(a))) for a in angles]

    def test_a_stroke_becomes_a_smooth_curve_that_can_be_made_smoother_and_redrawn(self):
        self.path.write_text(json.dumps({"format": "batten", "version": 1, "curves": []}))
        with self.start(self.display()) as editor:
            editor.key("d")
            self.draw(editor, self.arc(editor, 0.3, 2.8, 180))
            drawn = editor.wait(lambda state: "stroke smoothness" in state["widgets"] and state["is_settled"], "the stroke")
            editor.screenshot("pencil-stroke")
            self.assertLessEqual(len(drawn["points"]), 10)
            x, y = editor.widget_center("stroke smoothness")
            editor.drag((x - 30, y), (x + 50, y))
            smoother = editor.wait(lambda state: state["widgets"]["stroke smoothness"]["value"] != "4" and state["is_settled"],
                                   "a smoother stroke")
            self.assertLessEqual(len(smoother["points"]), len(drawn["points"]))
            self.draw(editor, self.arc(editor, 1.0, 1.3, 180, 4) + self.arc(editor, 1.3, 1.8, 230, 12)
                      + self.arc(editor, 1.8, 2.1, 180, 4))
            editor.wait(lambda state: state["undo_label"] == "Redraw part" and state["is_settled"], "the redrawn part")
            editor.screenshot("pencil-redrawn")
            editor.key("ctrl+z")
            editor.key("ctrl+z")
            editor.wait(lambda state: state["curve_count"] == 0 and state["is_settled"], "an empty document")


if __name__ == "__main__":
    unittest.main()
