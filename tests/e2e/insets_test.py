"""The pictures in boxes over the canvas, with the mouse: turning, dragging a lifted weight, and what lights where."""

import json
import math
import unittest

from case import WindowTest

HALF = math.sqrt(0.5)
ARC = {
    "format": "batten",
    "version": 1,
    "curves": [{"name": "arc", "degree": 2, "knots": [0, 0, 0, 1, 1, 1], "points": [[1, 0], [1, 1], [0, 1]], "weights": [1, HALF, 1]}],
    "view": {"parameter": 0.25, "overlays": ["polygon", "knots", "labels", "homogeneous"]},
}
BASIC = ["polygon", "knots", "labels"]


def center(place):
    return place["x"] + place["width"] / 2, place["y"] + place["height"] / 2


class InsetsTest(WindowTest):
    def open_arc(self):
        self.path.write_text(json.dumps(ARC))
        return self.open_editor()

    def lifted(self, editor, index):
        place = editor.state()["lifted_points"][index]
        return place["x"], place["y"]

    def test_dragging_beside_the_points_turns_the_homogeneous_view(self):
        editor = self.open_arc()
        before = editor.state()
        box = before["insets"]["homogeneous"]
        start = (box["x"] + 20, box["y"] + 40)
        editor.drag(start, (start[0] + 50, start[1] + 20))
        after = editor.settle()
        # A hundredth of a radian for a pixel.
        self.assertAlmostEqual(after["orbit"]["yaw"], before["orbit"]["yaw"] - 0.5, 6)
        self.assertAlmostEqual(after["orbit"]["pitch"], before["orbit"]["pitch"] + 0.2, 6)
        self.assertEqual(after["undo_count"], 0, "looking is not undone")
        self.assertNotEqual(after["lifted_points"][1], before["lifted_points"][1])
        self.assertEqual(after["points"], before["points"], "the canvas stays")
        editor.screenshot("turned")

    def test_a_lifted_weight_is_dragged_along_its_ray(self):
        editor = self.open_arc()
        origin_side = self.lifted(editor, 1)
        editor.drag(origin_side, (origin_side[0], origin_side[1] - 40), release=False)
        state = editor.wait(lambda state: state["has_preview"] and state["weights"][1] > HALF + 0.05, "a larger weight")
        self.assertEqual(state["weights"][0], 1)
        editor.screenshot("lifting")
        editor.release()
        state = editor.wait(lambda state: state["undo_count"] == 1 and not state["has_preview"], "one step")
        self.assertEqual(state["selected_points"], [1])
        saved = self.save(editor)
        self.assertGreater(saved["weights"][1], HALF + 0.05)
        self.assertEqual(saved["points"], ARC["curves"][0]["points"])

    def test_escape_restores_the_lifted_weight(self):
        editor = self.open_arc()
        x, y = self.lifted(editor, 1)
        editor.drag((x, y), (x, y - 40), release=False)
        editor.wait(lambda state: state["has_preview"], "the preview")
        editor.key("Escape")
        editor.release()
        state = editor.wait(lambda state: not state["has_preview"] and state["is_settled"], "the end")
        self.assertEqual(state["weights"], [1, HALF, 1])
        self.assertEqual(state["undo_count"], 0)

    def test_a_place_of_a_hodograph_lights_the_curve_there(self):
        editor = self.open_editor(settings={"overlays": [*BASIC, "hodograph"]})
        box = editor.state()["insets"]["hodograph"]
        found = []
        for share in range(1, 20):
            editor.move(box["x"] + box["width"] * share / 20, box["y"] + box["height"] * 0.55)
            state = editor.settle()
            if state["hovered_u"] is not None:
                found.append(state["hovered_u"])
                self.assertEqual(state["cursor"], "arrow", "it cannot be dragged")
        self.assertTrue(found, "the pointer crosses C'")
        self.assertTrue(all(0 <= u <= 1 for u in found))
        editor.screenshot("hodograph")
        editor.move(*center(editor.state()["canvas"]))
        editor.wait(lambda state: state["hovered_u"] is None or state["cursor"] == "hand", "out of the inset")


if __name__ == "__main__":
    unittest.main()
