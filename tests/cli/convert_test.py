"""Curves of other programs, and for them."""

import json
import pathlib
import tempfile
import unittest

from program import answer, run, write_document

LINE = {"name": "a", "degree": 1, "knots": [0, 0, 1, 1], "points": [[0, 0], [1, 0]]}


class Convert(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.line = write_document(self.folder / "line.json", LINE)

    def test_a_native_file_stays_what_it_is(self):
        copy = self.folder / "copy.json"
        process = run("convert", self.line, "-o", copy)
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertEqual(process.stdout, f"{self.line}: its curves are exact\n{copy}: its curves are exact\n")
        self.assertEqual(json.loads(copy.read_text())["curves"][0]["points"], LINE["points"])

    def test_what_is_told_goes_to_the_errors_beside_a_result(self):
        process = run("convert", self.line, "-o", "-")
        self.assertEqual(json.loads(process.stdout)["curves"][0]["points"], LINE["points"])
        self.assertEqual(process.stderr, f"{self.line}: its curves are exact\nstandard output: its curves are exact\n")

    def test_the_native_kind_is_chosen_too(self):
        for name in ("copy.svg", "copy.xyz"):
            copy = self.folder / name
            self.assertEqual(run("convert", self.line, "-o", copy, "--to", "batten").stdout.splitlines()[1], f"{copy}: its curves are exact")
            self.assertEqual(json.loads(copy.read_text())["format"], "batten")
        back = run("convert", self.folder / "copy.svg", "--from", "batten", "-o", "-", "--to", "batten")
        self.assertEqual(json.loads(back.stdout)["curves"][0]["points"], LINE["points"])
        self.assertEqual(run("convert", self.folder / "copy.svg", "-o", "-").returncode, 1)

    def test_exact_curves_beside_a_loss_are_told_as_such(self):
        drawing = self.folder / "drawing.svg"
        drawing.write_text('<svg xmlns="http://www.w3.org/2000/svg"><path id="a" d="M0 0h1 X"/><polygon id="b" points="0,0 1,0 1,1 x"/></svg>')
        self.assertEqual(run("convert", drawing, "-o", "-").stderr.splitlines()[:3], [
            f"{drawing}: its curves are exact apart from what follows",
            f"{drawing}: the path data go wrong at character 8 of 'a'; they are read up to there",
            f"{drawing}: the points go wrong at character 13 of 'b'; they are read up to there"])

    def test_errors_are_told_in_numbers_that_can_be_copied(self):
        circle = self.folder / "circle.json"
        self.assertEqual(run("new", "circle", 0, 0, 1, "elevate", 1, "-o", circle).returncode, 0)
        copy = self.folder / "copy.svg"
        told = run("convert", circle, "-o", copy, "--tolerance", "1e-5").stdout.splitlines()[1]
        head = f"{copy}: its curves are off by at most "
        self.assertTrue(told.startswith(head), told)
        self.assertTrue(0 < float(told.removeprefix(head)) <= 1e-5, told)

    def test_a_format_that_the_ending_does_not_say_is_chosen(self):
        circle = self.folder / "circle.json"
        self.assertEqual(run("new", "circle", 0, 0, 1, "-o", circle).returncode, 0)
        for format, title in (("nurbs-python", "NURBS-Python"), ("tinyspline", "tinyspline"), ("rhino", "Rhino-style"),
                              ("opencascade", "OpenCASCADE-style")):
            foreign = self.folder / "foreign.json"
            self.assertEqual(run("convert", circle, "-o", foreign, "--to", format).returncode, 0)
            refused = run("info", foreign)
            self.assertEqual(refused.returncode, 1)
            self.assertIn(f"it looks like a file in the format {title}, which has to be chosen", refused.stderr)
            [curve] = json.loads(run("convert", foreign, "--from", format, "-o", "-").stdout)["curves"]
            x, y = curve["points"][1]
            self.assertAlmostEqual(x * x + y * y, 2, delta=1e-12)

    def test_a_table_holds_samples_and_is_read_as_points(self):
        arcs, table = self.folder / "arcs.json", self.folder / "arcs.csv"
        self.assertEqual(run("new", "circle", 0, 0, 1, "-o", arcs).returncode, 0)
        written = run("convert", arcs, "-o", table, "--samples", 9)
        self.assertEqual(written.stdout.splitlines()[1:], [
            f"{table}: it holds samples of the curves, from which points can be read again, but not the curves themselves"])
        told = json.loads(run("convert", arcs, "-o", table, "--samples", 9, "--json").stdout)
        self.assertEqual([report["largest_error"] for report in told], [0.0, None])
        refused = run("convert", table, "-o", self.folder / "back.json")
        self.assertEqual(refused.returncode, 1)
        self.assertIn(f"'batten new interpolate @{table}'", refused.stderr)
        [through] = json.loads(run("new", "polyline", f"@{table}", "-o", "-").stdout)["curves"]
        self.assertEqual(len(through["points"]), 9, "the two rows of a knot are one point")

    def test_every_format_that_is_written_and_read_brings_a_circle_back(self):
        circle = self.folder / "circle.json"
        self.assertEqual(run("new", "circle", 3, 4, 5, "-o", circle).returncode, 0)
        for ending in ("svg", "dxf", "nurbs-python.json", "tinyspline.json", "rhino.json", "opencascade.json"):
            copy = self.folder / f"copy.{ending}"
            written = run("convert", circle, "-o", copy)
            self.assertEqual((written.returncode, written.stderr), (0, ""), ending)
            [info] = answer("info", copy)["curves"]
            self.assertAlmostEqual(info["length"], 31.41592653589793, delta=1e-9, msg=ending)
            self.assertEqual([[round(x, 9) for x in corner] for corner in info["bounds"]], [[-2, -1], [8, 9]], ending)

    def test_json_tells_of_both_files(self):
        copy = self.folder / "copy.json"
        told = [{"file": str(path), "largest_error": 0.0, "left_out": [], "looks": []} for path in (self.line, copy)]
        self.assertEqual(answer("convert", self.line, "-o", copy), told)

    def test_what_is_lost_of_the_look_of_a_drawing_is_told(self):
        drawing = self.folder / "drawing.svg"
        drawing.write_text('<svg viewBox="0 0 9 9"><path d="M0 0h3v2z" stroke="red" stroke-width="2"/></svg>')
        looks = ["a shape is filled; its outline is read as a line, and the fill is left out",
                 "the width or the dashes of a line are left out, since all curves are drawn alike but for their colors",
                 "the size of the page is left out; a file that is written has a page around its curves"]
        read, _ = answer("convert", drawing, "-o", self.folder / "read.json")
        self.assertEqual((read["left_out"], read["looks"]), ([], looks))
        said = run("convert", drawing, "-o", self.folder / "said.json").stdout
        for sentence in looks:
            self.assertIn(sentence, said)

    def test_what_is_wrong_is_told_and_nothing_is_written(self):
        result = self.folder / "out.json"
        missing = run("convert", self.folder / "none.json", "-o", result)
        self.assertEqual(missing.returncode, 1)
        self.assertIn("none.json: ", missing.stderr)
        foreign = run("convert", self.line, "-o", self.folder / "out.ai")
        self.assertEqual((foreign.returncode, foreign.stdout), (2, ""))
        self.assertRegex(foreign.stderr, "^batten convert: 'out.ai' ends in .ai, and curves are not written to such files; name it 'out.json', or with "
                         ".svg, .dxf, .* or .csv\n$")
        for words, problem in (
            (("--samples", "1"), "--samples: 1 is no whole number from 2 to 10000000"),
            (("--samples", "2.5"), "--samples: 2.5 is no whole number from 2 to 10000000"),
            (("--tolerance", "-1"), "--tolerance: -1 is no length above 0"),
            (("--to", "word"), "--to: 'word' is none of them; possible are batten, svg, "),
        ):
            refused = run("convert", self.line, "-o", result, *words)
            self.assertEqual(refused.returncode, 2, words)
            self.assertIn(problem, refused.stderr)
        for words in (("--from", "word"), ("--tolerance", "0"), ("--tolerance", "nan"), ("--tolerance", "1e999"), ("--samples", "1")):
            self.assertEqual(run("convert", self.line, "-o", result, *words).returncode, 2, words)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["line.json"])


if __name__ == "__main__":
    unittest.main()
