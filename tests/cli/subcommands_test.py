"""The subcommands: what they print, what they refuse and how, and what they end with."""

import json
import math
import os
import pathlib
import re
import tempfile
import unittest

from program import answer, run, write_document

# A quarter of the unit circle, from (1, 0) to (0, 1), and a straight line of length 5.
QUARTER = {"name": "quarter", "degree": 2, "knots": [0, 0, 0, 1, 1, 1], "points": [[1, 0], [1, 1], [0, 1]], "weights": [1, 0.5**0.5, 1]}
LINE = {"name": "line", "degree": 1, "knots": [0, 0, 2, 2], "points": [[0, 0], [3, 4]]}


class Subcommands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = write_document(self.folder / "two.json", QUARTER, LINE)
        self.output = self.folder / "out.json"

    def refused(self, status, *arguments):
        """What stands on standard error; nothing must stand on standard output."""
        process = run(*arguments)
        self.assertEqual(process.returncode, status, process.stderr)
        self.assertEqual(process.stdout, "")
        return process.stderr

    def curves(self):
        return json.loads(self.output.read_text())["curves"]

    def test_info_tells_what_curves_are(self):
        result = answer("info", self.file)
        self.assertEqual(result["file"], str(self.file))
        quarter, line = result["curves"]
        self.assertEqual(
            {name: quarter[name] for name in ("name", "degree", "kind", "periodic", "rational", "clamped", "points", "segments", "domain")},
            {"name": "quarter", "degree": 2, "kind": "Bézier", "periodic": False, "rational": True, "clamped": True, "points": 3,
             "segments": 1, "domain": [0, 1]})
        self.assertAlmostEqual(quarter["length"], 1.5707963267948966, delta=1e-14)
        for found, expected in zip(quarter["bounds"], [[0, 0], [1, 1]]):
            self.assertAlmostEqual(found[0], expected[0], delta=1e-15)
            self.assertAlmostEqual(found[1], expected[1], delta=1e-15)
        self.assertEqual(quarter["knots"], [{"value": 0, "multiplicity": 3}, {"value": 1, "multiplicity": 3}])
        self.assertEqual((line["length"], line["domain"]), (5, [0, 2]))

    def test_info_as_json_has_one_member_a_line(self):
        for file in (self.file, write_document(self.folder / "none.json")):
            text = run("info", "--json", file).stdout
            self.assertEqual(text, json.dumps(json.loads(text), indent=2, ensure_ascii=False) + "\n")

    def test_info_as_text_names_the_same(self):
        text = run("info", self.file).stdout
        for part in ("quarter", "Bézier, rational", "multiplicity 3", "0 to 2", "line"):
            self.assertIn(part, text)

    def test_eval_answers_in_the_order_asked(self):
        rows = answer("eval", self.file, "--curve", "line", "--at", 2, "--at", 0.5, "--derivatives", 2)
        self.assertEqual(rows, [{"u": 2, "point": [3, 4], "derivatives": [[1.5, 2], [0, 0]]},
                                {"u": 0.5, "point": [0.75, 1], "derivatives": [[1.5, 2], [0, 0]]}])
        self.assertEqual(run("eval", self.file, "--curve", "line", "--at", "0.5").stdout, "0.5\t0.75\t1\n")

    def test_eval_prints_basis_functions(self):
        uniform = {"name": "uniform", "degree": 3, "knots": [0, 1, 2, 3, 4, 5, 6, 7], "points": [[0, 0], [1, 0], [1, 1], [0, 1]]}
        write_document(self.file, uniform)
        (row,) = answer("eval", self.file, "--at", 3.5, "--basis", "--derivatives", 2)
        self.assertEqual([function["index"] for function in row["functions"]], [0, 1, 2, 3])
        self.assertEqual((row["u"], row["sum"]), (3.5, 1))
        # In t = 1/2: (1 - t)^3 / 6, (3 t^3 - 6 t^2 + 4) / 6, and so on.
        expected = [[1 / 48, -1 / 8, 1 / 2], [23 / 48, -5 / 8, -1 / 2], [23 / 48, 5 / 8, -1 / 2], [1 / 48, 1 / 8, 1 / 2]]
        for function, numbers in zip(row["functions"], expected):
            self.assertNotIn("R", function)
            for found, number in zip(function["N"], numbers, strict=True):
                self.assertAlmostEqual(found, number, delta=1e-15)
        text = run("eval", self.file, "--at", 3, "--at", 4, "--basis").stdout
        self.assertEqual([line.split("\t")[:2] for line in text.splitlines()], [[u, i] for u in "34" for i in "0123"])
        self.assertEqual([float(line.split("\t")[2]) for line in text.splitlines()], [1 / 6, 2 / 3, 1 / 6, 0, 0, 1 / 6, 2 / 3, 1 / 6])

    def test_eval_prints_rational_basis_functions_beside_the_others(self):
        # R_1 = 2 t (1 - t) w / (1 - 2 t (1 - t) (1 - w)), with w = 3 and t = 1/2: 3/4, and by symmetry stationary.
        write_document(self.file, {**QUARTER, "weights": [1, 3, 1]})
        (row,) = answer("eval", self.file, "--at", 0.5, "--basis", "--derivatives", 1)
        self.assertEqual([function["N"] for function in row["functions"]], [[0.25, -1], [0.5, 0], [0.25, 1]])
        self.assertEqual([function["R"] for function in row["functions"]], [[0.125, -0.5], [0.75, 0], [0.125, 0.5]])
        self.assertEqual(run("eval", self.file, "--at", 0.5, "--basis").stdout,
                         "0.5\t0\t0.25\t0.125\n0.5\t1\t0.5\t0.75\n0.5\t2\t0.25\t0.125\n")

    def test_eval_prints_basis_functions_from_a_side_and_once_for_each_point(self):
        corner = {"name": "corner", "degree": 1, "knots": [0, 0, 1, 2, 2], "points": [[0, 0], [1, 0], [1, 1]]}
        write_document(self.file, corner)
        for side, indices in (("left", [0, 1]), ("right", [1, 2])):
            (row,) = answer("eval", self.file, "--at", 1, "--basis", "--side", side)
            self.assertEqual([function["index"] for function in row["functions"]], indices)
        # Two points and three local functions, the first and the last of which are one.
        closed = {"name": "closed", "degree": 2, "knots": [0, 1, 2], "points": [[0, 0], [1, 0]], "periodic": True}
        write_document(self.file, closed)
        (row,) = answer("eval", self.file, "--at", 0.5, "--basis", "--derivatives", 1)
        self.assertEqual(row["functions"], [{"index": 0, "N": [0.25, 0]}, {"index": 1, "N": [0.75, 0]}])

    def test_eval_refuses_basis_functions_beyond_doubles(self):
        write_document(self.file, {**LINE, "knots": [0, 0, 1e-320, 1e-320]})
        self.assertIn("too large for a double", self.refused(1, "eval", self.file, "--at", 0, "--basis", "--derivatives", 1))
        self.assertIn("outside the domain", self.refused(1, "eval", self.file, "--at", 1, "--basis"))

    def test_eval_lays_its_rows_out_as_all_json(self):
        write_document(self.file, {**LINE, "points": [[-0.0, 0.1], [0.3, 4]]})
        for count in (0, 1, 2):
            rows = run("eval", self.file, "--at", 0, "--at", 1.5, "--derivatives", count, "--json").stdout
            self.assertEqual(rows, json.dumps(json.loads(rows), indent=2) + "\n")

    def test_eval_prints_numbers_in_full(self):
        ((row),) = answer("eval", self.file, "--at", "0.1")
        x, y = row["point"]
        self.assertAlmostEqual(x * x + y * y, 1.0, delta=4e-16)

    def test_eval_computes_parameters(self):
        write_document(self.file, QUARTER)
        rows = answer("eval", self.file, "--at", "1/4", "--at", "sqrt(4)/4", "--at", "sin(30 deg)")
        self.assertEqual([row["u"] for row in rows], [0.25, 0.5, 0.5])
        self.assertIn("1/0", self.refused(2, "eval", self.file, "--at", "1/0"))

    def test_eval_takes_a_side_at_a_knot(self):
        corner = {"name": "corner", "degree": 1, "knots": [0, 0, 1, 2, 2], "points": [[0, 0], [1, 0], [1, 1]]}
        write_document(self.file, corner)
        for side, direction in (("left", [1, 0]), ("right", [0, 1])):
            (row,) = answer("eval", self.file, "--at", 1, "--derivatives", 1, "--side", side)
            self.assertEqual(row["derivatives"], [direction])

    def test_eval_wraps_parameters_of_periodic_curves_only(self):
        closed = {"name": "closed", "degree": 2, "knots": [0, 1, 2, 3], "points": [[0, 0], [1, 0], [0, 1]], "periodic": True}
        write_document(self.file, closed)
        inside, outside = answer("eval", self.file, "--at", 0.5, "--at", -2.5)
        self.assertEqual(inside["point"], outside["point"])

    def test_input_that_is_wrong_ends_with_1_and_a_sentence(self):
        self.assertEqual(self.refused(1, "eval", self.file, "--at", 1.5),
                         f"{self.file}: curve 'quarter': the parameter 1.5 is outside the domain; it must be from 0 to 1\n")
        self.assertIn("there is no curve 'x'; there are 'quarter', 'line', with the numbers 0 to 1\n", self.refused(1, "eval", self.file, "--at", 0, "--curve", "x"))
        self.assertIn("cannot be opened", self.refused(1, "info", self.folder / "none.json"))
        broken = write_document(self.folder / "broken.json", {**LINE, "knots": [0, 0, 2, 1]})
        self.assertRegex(self.refused(1, "check", broken), r"^.*broken\.json: /curves/0/knots/3: .*decrease")

    def test_values_beyond_doubles_are_refused(self):
        write_document(self.file, {**QUARTER, "weights": [1, 1e308, 1], "points": [[1, 0], [1e10, 1], [0, 1]]})
        self.assertEqual(answer("eval", self.file, "--at", 0.5)[0]["point"], [1e10, 1])
        self.assertIn("length    not known: the weights or points are too far apart", run("info", self.file).stdout)
        self.assertIn("bounds    (0, 0) to (1e+10, 1)", run("info", self.file).stdout)
        write_document(self.file, {**QUARTER, "points": [[-1.7e308, 0], [1.7e308, 1], [0, 1]]})
        self.assertIn("too large for a double", self.refused(1, "eval", self.file, "--at", 0.5, "--derivatives", 1))
        self.assertIn("too large for a double", run("info", self.file).stdout)

    def test_a_deviation_beyond_doubles_is_null_and_told(self):
        write_document(self.file, {**LINE, "points": [[-1.5e308, 0], [1.5e308, 0]]})
        (moved,) = answer("apply", self.file, "set-point", 0, "1.5e308", 1)
        self.assertIsNone(moved["deviation"])
        self.assertEqual(moved["message"], "Moved P₀ from (-1.5e+308, 0) to (1.5e+308, 1); how far the curve moved cannot be computed: "
                         "its points, weights or knots are too far apart, too large or too small")
        (same,) = answer("apply", self.file, "set-point", 0, "-1.5e308", 0)
        self.assertNotIn("deviation", same)
        (near,) = answer("apply", self.file, "set-point", 0, "-1.5e308", 1e300)
        self.assertAlmostEqual(near["deviation"] / 1e300, 1, delta=1e-4)

    def test_bounds_beyond_doubles_are_null_and_told(self):
        # The difference of the points, from which the curve is blended, is no double.
        write_document(self.file, {"name": "ring", "degree": 2, "knots": [0, 1, 2], "points": [[-1.2e308, 0], [1.2e308, 1]], "periodic": True})
        self.assertIsNone(answer("info", self.file)["curves"][0]["bounds"])
        self.assertIn("bounds    not known: the weights or points are too far apart", run("info", self.file).stdout)

    def test_a_joint_is_told_with_numbers_in_full(self):
        # From the end (1, 0) to the other's beginning (1.3, 0.1), which goes on by (1.7, 0.8).
        lines = [{**LINE, "points": [[0, 0], [1, 0]]}, {**LINE, "name": "other", "points": [[1.3, 0.1], [3, 0.9]]}]
        write_document(self.file, *lines)
        (joined,) = answer("apply", self.file, "join", "other", "C1")
        told = re.search("the joint had a gap of (.*?), a turn of (.*?)° and the curvatures 0 and 0;", joined["message"])
        self.assertAlmostEqual(float(told[1]), 0.1**0.5, delta=1e-15)
        self.assertAlmostEqual(float(told[2]), math.degrees(math.atan2(0.8, 1.7)), delta=1e-13)
        self.assertNotIn("−", joined["message"])

    def test_a_wrong_command_line_ends_with_2(self):
        self.refused(2, "info")
        self.refused(2, "eval", self.file)
        self.refused(2, "eval", self.file, "--at", "x")
        self.refused(2, "eval", self.file, "--at", 0, "--side", "above")
        self.refused(2, "apply", self.file)
        self.refused(2, "frobnicate", self.file)
        self.assertIn("'frobnicate' after 'insert-knot 0.5' is not an operation", self.refused(2, "apply", self.file, "insert-knot", "0.5", "frobnicate"))

    def test_apply_runs_operations_in_order(self):
        process = run("apply", self.file, "insert-knot", "0.5", "insert-knot", "0.5", "elevate", "1", "-o", self.output)
        self.assertEqual(process.returncode, 0, process.stderr)
        quarter, line = self.curves()
        self.assertEqual(quarter["degree"], 3)
        self.assertEqual(quarter["knots"], [0, 0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1, 1])
        self.assertEqual(line["points"], LINE["points"])

    def test_apply_split_leaves_two_curves(self):
        run("apply", self.file, "insert-knot", "0.5", "elevate", "1", "split", "0.25", "-o", self.output)
        names = [curve["name"] for curve in self.curves()]
        self.assertEqual(len(names), 3)
        self.assertEqual(len(set(names)), 3)

    def test_apply_reports_what_it_did(self):
        (inserted, moved) = answer("apply", self.file, "insert-knot", "0.25", "move-points", "1,", "-0.5", "1")
        self.assertEqual(inserted, {"operation": "insert-knot", "arguments": [0.25], "effect": "keeps",
                                    "message": "Inserted knot 0.25: multiplicity 1, C¹ there; the curve is unchanged"})
        self.assertEqual((moved["arguments"], moved["effect"]), ([[1], -0.5, 1], "changes"))
        self.assertGreater(moved["deviation"], 0.1)

    def test_apply_refuses_as_a_whole(self):
        error = self.refused_operation("insert-knot", "0.5", "insert-knot", "2")
        self.assertEqual(error, f"{self.file}: operation 2, insert-knot 2: the parameter 2 is outside the domain; it must be from 0 to 1\n")
        self.assertFalse(self.output.exists())

    def refused_operation(self, *operations):
        process = run("apply", self.file, *operations, "-o", self.output)
        self.assertEqual(process.returncode, 1)
        return process.stderr

    def test_apply_begins_with_the_curve_asked_for(self):
        run("apply", self.file, "--curve", "line", "insert-knot", "1", "-o", self.output)
        quarter, line = self.curves()
        self.assertEqual(len(quarter["points"]), 3)
        self.assertEqual(line["points"], [[0, 0], [1.5, 2], [3, 4]])

    def test_apply_explains_all_operations(self):
        text = run("apply", "--list").stdout
        for part in ("insert-knot [u]", "Keeps the shape.", "elevate [", "split [", "nearest <x> <y>", "Measures"):
            self.assertIn(part, text)
        for absent in ("quit", "toggle-grid", "pan-camera", "open"):
            self.assertNotIn(f"\n  {absent}", text)

    def test_check_lists_the_joints(self):
        start = {"name": "start", "degree": 1, "knots": [0, 0, 1, 1], "points": [[1, -4], [1, 0]]}
        end = {"name": "end", "degree": 1, "knots": [0, 0, 1, 2, 2], "points": [[-5, 1.25], [0, 1.25], [3, 2]]}
        file = write_document(self.folder / "path.json", start, QUARTER, end)
        first, corner = answer("check", "--joints", file)[0]["joints"]
        self.assertEqual(first["curves"], ["start", "quarter"])
        self.assertEqual((first["parameters"], first["at_ends"], first["point"]), ([1, 0], True, [1, 0]))
        self.assertEqual((first["level"], first["gap"], first["turn in degrees"]), (1, 0, 0))
        self.assertEqual(first["curvature before"], 0)
        self.assertAlmostEqual(first["curvature behind"], 1, 14)
        self.assertEqual((corner["curves"], corner["at_ends"], corner["level"]), (["end", "end"], False, 0))
        self.assertAlmostEqual(corner["turn in degrees"], math.degrees(math.atan2(0.75, 3)), 12)
        # The knot at (0, 1.25) is no end.
        self.assertEqual(len(answer("check", "--joints", "--within", 0.3, file)[0]["joints"]), 2)
        # Each end with the nearest one: 0, 1.41, 2.83, 4 and 5.006 apart; and the corner.
        joints = answer("check", "--joints", "--within", 5.2, file)[0]["joints"]
        self.assertEqual(sorted(round(joint["gap"], 3) for joint in joints), [0, 0, 1.414, 2.828, 4, 5.006])
        lines = run("check", "--joints", file).stdout.splitlines()
        self.assertEqual(lines[1], "2 joints: gaps 0, G⁰ 1, G¹ 1, G² 0, G³ 0")
        self.assertRegex(lines[2], "^  end of 'start' to start of 'quarter'\\t.*\\tlevel = 1\\tgap = 0\\tturn in degrees = .*\\tG¹$")
        self.assertRegex(lines[3], "^  u = 1 of 'end'\\t.*\\tlevel = 0\\tgap = 0\\tturn in degrees = 14\\.03.*\\tG⁰$")
        self.assertEqual(run("check", "--joints", "--within", "0", file).returncode, 2)

    def test_check_tells_every_file(self):
        broken = write_document(self.folder / "broken.json", {**LINE, "points": [[0, 0]]})
        process = run("check", self.file, broken)
        self.assertEqual(process.returncode, 1)
        self.assertEqual(process.stdout, f"{self.file}: valid, 2 curves\n")
        self.assertTrue(process.stderr.startswith(f"{broken}: /curves/0"))
        self.assertEqual(answer("check", self.file), [{"file": str(self.file), "valid": True}])

    def test_help_names_everything(self):
        text = run("--help-all").stdout
        for part in ("info", "eval", "apply", "new", "check", "- is standard input", "- is standard output", "-- ends the arguments", "--at", "--side", "--derivatives", "--json", "--list", "--output", "--version"):
            self.assertIn(part, text)
        self.assertEqual(run("--help").returncode, 0)

    def test_the_man_page_is_made_from_the_help(self):
        page = pathlib.Path(os.environ["BATTEN_MAN_PAGE"]).read_text().replace("\\-", "-")
        for part in (".SH SYNOPSIS", "insert-knot 0.5 elevate 1 split 0.25", "Run operations on an empty document", "derivatives", "Exit status"):
            self.assertIn(part, page)


if __name__ == "__main__":
    unittest.main()
