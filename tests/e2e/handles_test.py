"""The handlebar, the brushes and marked joints in the real window; what they did is checked in the saved file."""

import json
import math
import unittest

from case import WindowTest
from spline import point_at

PIECES = {
    "name": "pieces", "degree": 3, "knots": [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2],
    "points": [[-6, 0], [-5, 3], [-1, 0], [0, 0], [2, 0], [5, 3], [6, 0]],
}


def derivative(curve, u, h=1e-5):
    (x0, y0), (x1, y1) = point_at(curve, u - h), point_at(curve, u + h)
    return (x1 - x0) / (2 * h), (y1 - y0) / (2 * h)


class HandlesTest(WindowTest):
    def place(self, editor, u):
        return next((p["x"], p["y"]) for p in editor.settle()["curve_places"] if abs(p["u"] - u) < 1e-12)

    def wait_for_message(self, editor, text):
        return editor.wait(lambda state: text in state["message"] and state["is_settled"], text)

    def take_brush(self, editor, kind):
        editor.click_widget("tool brush")
        editor.click_widget(f"menu-item brush-{kind}")
        editor.wait(lambda state: state["tool"] == "brush" and state["is_settled"], kind)

    def test_escape_closes_the_key_sheet_and_keeps_the_brush(self):
        editor = self.open_editor()
        editor.key("e")
        editor.move(*self.place(editor, 0.625))
        editor.wait(lambda state: state["tool"] == "brush" and state["is_settled"], "the brush")
        editor.key("F1")
        editor.wait(lambda state: state["dialog"] == "key-sheet" and state["is_settled"], "the key sheet")
        editor.key("Escape")
        state = editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], "no dialog")
        self.assertEqual(state["tool"], "brush")
        editor.key("Escape")
        editor.wait(lambda state: state["tool"] == "select" and state["is_settled"], "the select tool")

    def test_the_tangent_is_turned_by_its_end(self):
        editor = self.open_editor()
        before = self.saved()
        u, span = 0.625, 0.25
        x, y = self.place(editor, u)
        editor.click(x, y)
        zoom = editor.settle()["zoom"]
        dx, dy = derivative(before, u)
        leg = span / 3 * math.hypot(dx, dy) * zoom
        # Half of the leg of the Bézier piece, or beyond it.
        arm = min(leg / 2, 160) if leg >= 40 else max(40, leg + 20)
        reach = span / 3 * arm / leg
        tip = (x + reach * dx * zoom, y - reach * dy * zoom)
        editor.move(*tip)
        editor.settle()
        editor.screenshot("handlebar")
        editor.press()
        editor.move(tip[0] + 30, tip[1] - 50)
        editor.wait(lambda state: state["has_preview"] and state["is_settled"], "the preview")
        editor.type("2<30")
        editor.key("Return")
        self.wait_for_message(editor, "Set tangent at u = 0.625")
        editor.release()
        turned = self.save(editor)
        after = derivative(turned, u)
        # The click was at a whole pixel, so u is not quite this.
        self.assertAlmostEqual(reach * after[0], 2 * math.cos(math.pi / 6), delta=0.05)
        self.assertAlmostEqual(reach * after[1], 1.0, delta=0.05)
        off_by = math.sqrt(0.5) / zoom * (1 + math.hypot(*after) / math.hypot(dx, dy))
        self.assertLess(math.dist(point_at(before, u), point_at(turned, u)), off_by)
        self.assertEqual(before["points"][0], turned["points"][0])
        self.assertEqual(editor.state()["undo_count"], 1)
        editor.key("ctrl+z")
        self.assertEqual(self.save(editor)["points"], before["points"])

    def test_points_follow_the_brush(self):
        editor = self.open_editor()
        before = self.saved()
        self.take_brush(editor, "soft-move")
        x, y = editor.point(2)
        editor.move(x, y)
        editor.type("]]]]]]]]]]")
        editor.wheel(1)
        editor.settle()
        editor.screenshot("brush")
        editor.drag((x, y), (x + 20, y + 40))
        self.wait_for_message(editor, "Moved")
        zoom = editor.state()["zoom"]
        after = self.save(editor)
        radius = 80 * 1.15**11 / zoom
        move = [b - a for a, b in zip(before["points"][2], after["points"][2])]
        self.assertAlmostEqual(move[1], -40 / zoom, 1)
        shares = []
        for old, new in zip(before["points"], after["points"]):
            far = math.dist(old, before["points"][2]) / radius
            share = (1 - far**2) ** 2 if far < 1 else 0
            shares.append(share)
            for axis in (0, 1):
                self.assertAlmostEqual(new[axis], old[axis] + share * move[axis], 9)
        self.assertGreater(sum(0 < share < 1 for share in shares), 0, "some points were taken along a part of the way")
        editor.key("Escape")
        self.assertEqual(editor.settle()["tool"], "select")

    def test_a_part_is_faired_and_then_by_another_distance(self):
        editor = self.open_editor()
        before = self.saved()
        self.take_brush(editor, "fair")
        first, last = self.place(editor, 0.25), self.place(editor, 0.625)
        editor.drag(first, last, release=False)
        editor.settle()
        editor.screenshot("painted")
        editor.release()
        self.wait_for_message(editor, "Faired from u")
        count = editor.state()["undo_count"]
        faired = self.save(editor)
        self.assertNotEqual(faired["points"], before["points"])
        self.assertEqual((faired["points"][0], faired["points"][-1]), (before["points"][0], before["points"][-1]))
        editor.screenshot("faired")
        editor.double_click(*editor.widget_center("faired distance"))
        self.retype(editor, "faired distance", "0.5")
        editor.key("Return")
        self.wait_for_message(editor, "Faired the part within 0.5")
        self.assertEqual(editor.state()["undo_count"], count)
        self.assertNotEqual(self.save(editor)["points"], faired["points"])

    def test_a_marked_joint_stays_smooth(self):
        self.path.write_text(json.dumps({"format": "batten", "version": 1, "curves": [PIECES]}))
        editor = self.open_editor()
        editor.click(*editor.strip_knot(6), button=3)
        editor.click_widget("menu-item mark-smooth")
        self.wait_for_message(editor, "Marked the joint at u = 1 smooth (G1)")
        x, y = editor.point(4)
        editor.drag((x, y), (x - 60, y - 90), release=False)
        editor.settle()
        editor.screenshot("joint")
        editor.release()
        editor.wait(lambda state: state["undo_count"] == 2 and state["is_settled"], "the step")
        curve = self.save(editor)
        self.assertEqual(curve["joints"], [{"u": 1, "mark": "smooth"}])
        (bx, by), (x, y), (ax, ay) = curve["points"][2:5]
        self.assertNotEqual(by, 0)
        self.assertAlmostEqual((x - bx) * (ay - y) - (y - by) * (ax - x), 0, 12)
        self.assertAlmostEqual(math.hypot(bx - x, by - y), 1, 12)
        self.assertEqual([curve["points"][i] for i in (0, 1, 3, 5, 6)], [PIECES["points"][i] for i in (0, 1, 3, 5, 6)])


if __name__ == "__main__":
    unittest.main()
