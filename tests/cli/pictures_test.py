"""Curves from pictures and from tables of points, measured by closed forms."""

import json
import math
import pathlib
import tempfile
import unittest

from program import run

PICTURES = pathlib.Path(__file__).parent.parent / "data" / "pictures"
# The ring in the pictures: its middle from the lower left corner, in pixels.
CENTER = (32.3, 64 - 31.6)



class Pictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.output = self.folder / "out.json"

    def made(self, *words):
        process = run("new", *words, "-o", self.output)
        self.assertEqual(process.returncode, 0, process.stderr)
        return json.loads(self.output.read_text())

    def refused(self, *words):
        process = run("new", *words)
        self.assertNotEqual(process.returncode, 0)
        self.assertEqual(process.stdout, "")
        return process.stderr

    def test_outlines_are_closed_curves_of_few_points(self):
        curves = self.made("trace", PICTURES / "ring_gray.png")["curves"]
        self.assertEqual(len(curves), 2)
        for curve, radius in zip(curves, (24, 12)):
            self.assertTrue(curve["periodic"])
            self.assertLessEqual(len(curve["points"]), 12)
            # Six control points of a circle lie a fifth of its radius outside.
            for x, y in curve["points"]:
                self.assertLess(abs(math.hypot(x - CENTER[0], y - CENTER[1]) - radius), 0.25 * radius)

    def test_wrong_pictures_are_refused_in_a_sentence(self):
        self.assertIn("cut_off.png: the picture is damaged or cut off and cannot be read",
                      self.refused("trace", PICTURES / "cut_off.png"))
        self.assertIn("there is no such file", self.refused("trace", self.folder / "none.png"))

    def test_a_picture_stays_with_the_document(self):
        document = self.made("add-picture", PICTURES / "ring_gray.png", "0", "0", "64", "0.5")
        (picture,) = document["pictures"]
        self.assertEqual((picture["width"], picture["height"], picture["scale"]), (64, 64, 1))
        self.assertEqual(picture["position"], [-32, -32])
        self.assertFalse(pathlib.Path(picture["path"]).is_absolute())
        self.assertTrue((self.folder / picture["path"]).samefile(PICTURES / "ring_gray.png"))
        process = run("apply", self.output, "trace-picture", "-o", self.output)
        self.assertEqual(process.returncode, 0, process.stderr)
        document = json.loads(self.output.read_text())
        self.assertEqual(len(document["curves"]), 2)
        self.assertEqual(len(document["pictures"]), 1)

    def test_points_of_a_file(self):
        table = self.folder / "offsets.csv"
        table.write_text("station;x;y\n1;0,0;1,25\n2;1,5;2\n3;3,0;1,75\n4;4,5;1\n")
        (curve,) = self.made("points-from-file", table, "control", "usual", "open", "1", "2")["curves"]
        self.assertEqual(curve["points"], [[1, 0], [2, 1.5], [3, 3], [4, 4.5]])
        # Those named x and y.
        (curve,) = self.made("points-from-file", table, "control")["curves"]
        self.assertEqual(curve["points"], [[0, 1.25], [1.5, 2], [3, 1.75], [4.5, 1]])
        self.assertEqual(curve["name"], "offsets")


if __name__ == "__main__":
    unittest.main()
