"""How the words of `apply` and `new` are divided into operations and their arguments."""

import json
import pathlib
import re
import tempfile
import unittest

from program import answer, run, write_document

# The circle of radius 9 meets the line x = y at 9/sqrt(2), the line y = x + 1 at (sqrt(161) - 1)/2, and y = 0 at 9.
CIRCLE_9 = ("circle", 0, 0, 9)


def words_of(text):
    return text.split(" ")


class Operations(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.empty = write_document(self.folder / "empty.json")
        self.output = self.folder / "out.json"

    def made(self, text, *more):
        """The curves after `new` with these operations."""
        process = run("new", *words_of(text), *more, "-o", self.output)
        self.assertEqual(process.returncode, 0, process.stderr)
        return json.loads(self.output.read_text())["curves"]

    def wrong_usage(self, *arguments):
        process = run(*arguments)
        self.assertEqual((process.returncode, process.stdout), (2, ""), process.stderr)
        return process.stderr

    def test_a_curve_is_meant_where_an_operation_has_its_name(self):
        results = answer("apply", self.empty, *words_of("line 0 0 20 20 circle 0 0 9 9 line 0 1 20 21 intersect circle"))
        self.assertEqual([result["operation"] for result in results], ["line", "circle", "line", "intersect"])
        self.assertEqual(results[-1]["arguments"], ["circle"])
        (meeting,) = results[-1]["findings"]
        x = (161**0.5 - 1) / 2
        self.assertAlmostEqual(meeting["point"][0], x, delta=1e-13)
        self.assertAlmostEqual(meeting["point"][1], x + 1, delta=1e-13)

    def test_without_such_a_curve_the_operation_is_meant(self):
        results = answer("new", *words_of("line 0 0 1 1 line 0 1 1 0 intersect circle 0 0 9"))
        self.assertEqual([result["operation"] for result in results], ["line", "line", "intersect", "circle"])
        self.assertEqual(results[2]["arguments"], ["line"])

    def test_a_choice_is_meant_where_an_operation_has_its_name(self):
        fair, faired = self.made("through-points 0,0,2,3,5,0,9,1 fair"), self.made("through-points 0,0,2,3,5,0,9,1 -- fair 0.1")
        self.assertEqual([curves[0]["degree"] for curves in (fair, faired)], [5, 3])

    def test_a_point_is_two_numbers_in_one_word(self):
        """The circle of 9 points about (1, -2) through (31, -2) is in the square from (-29, -32) to (31, 28)."""
        for center in ("1,-2", "1;-2", "1 -2"):
            [circle] = self.made(f"circle {center} 30")
            points = circle["points"]
            self.assertEqual([min(p[k] for p in points) for k in (0, 1)], [-29, -32], center)
            self.assertEqual([max(p[k] for p in points) for k in (0, 1)], [31, 28], center)
        [circle] = self.made("circle 0,0 2,5")
        self.assertEqual(max(p[0] for p in circle["points"]), 2.5)

    def test_a_point_that_is_needed_is_two_arguments(self):
        [circle] = self.made("circle 0 0 9 set-point 0 10,0.5")
        self.assertEqual(circle["points"][0], [10, 0.5])

    def test_a_mark_ends_the_arguments(self):
        curves = self.made("line 0 0 20 20 circle 0 0 9 line 0 1 20 21 intersect -- circle 5 5 2")
        self.assertEqual([curve["name"] for curve in curves], ["line", "circle", "line 2", "circle 2"])

    def test_an_operation_whose_curve_is_renamed_is_one_again(self):
        results = answer("new", *words_of("circle 0 0 9 line 0 0 20 0 rename-curve circle c intersect circle 0 0 2"))
        self.assertEqual([result["operation"] for result in results], ["circle", "line", "rename-curve", "intersect", "circle"])

    def test_what_is_needed_is_an_argument_whatever_it_is(self):
        for name in ("circle", "elevate", "info", "check", "new", "apply", "none", "0.5", "-x", "-"):
            (curve,) = self.made("line 0 0 1 1 rename-curve 0", name)
            self.assertEqual(curve["name"], name)
        process = run("new", *words_of("line 0 0 1 1 move-knot elevate 1"))
        self.assertEqual(process.returncode, 1)
        self.assertIn("move-knot elevate 1: index is the text 'elevate'; a whole number is needed", process.stderr)

    def test_what_is_needed_behind_a_mark_is_no_option(self):
        for words in (("--", "-o"), ("--", "--json"), ("--", "--help"), ("--", "--"), ("--other",)):
            (curve,) = self.made("line 0 0 1 1 rename-curve 0", *words)
            self.assertEqual(curve["name"], words[-1])

    def test_an_option_may_stand_where_nothing_is_needed(self):
        words = words_of("line 0 0 1 1 elevate -- insert-knot 0.5")
        for place in (0, 1, 5, 6, 7, len(words)):
            self.output.unlink(missing_ok=True)
            process = run("new", *words[:place], "-o", self.output, *words[place:])
            self.assertEqual(process.returncode, 0, process.stderr)
            self.assertEqual(json.loads(self.output.read_text())["curves"][0]["knots"], [0, 0, 0, 0.5, 1, 1, 1])
        self.assertIn("--frobnicate", self.wrong_usage("apply", self.empty, "line", "--frobnicate"))

    def test_a_file_may_begin_with_a_minus_sign_behind_a_mark(self):
        write_document(self.folder / "-x.json")
        process = run("apply", "--", "-x.json", *words_of("line 0 0 3 4 arc-length"), cwd=self.folder)
        self.assertEqual(process.returncode, 0, process.stderr)
        self.assertIn("5", process.stdout)

    def test_negative_numbers_are_no_options(self):
        (curve,) = self.made("line 0 0 1 1 select-all nudge -.5 -1e-1 set-point 0 -2 -.25")
        self.assertEqual(curve["points"], [[-2, -0.25], [0.5, 0.9]])

    def test_a_number_names_a_curve(self):
        for number, x in ((0, 9 / 2**0.5), (1, None), (2, 9)):
            process = run("new", *words_of("line 0 0 20 20"), *CIRCLE_9, *words_of("line 0 0 20 0 activate-curve 1 intersect"), number, "--json")
            if x is None:
                self.assertIn("'circle' is the active curve itself", process.stderr)
                continue
            result = json.loads(process.stdout)[-1]
            self.assertAlmostEqual(result["findings"][0]["point"][0], x, delta=1e-13)
            self.assertIn("circle meets line", result["message"])

    def test_a_number_names_the_curve_to_begin_with(self):
        self.made("line 0 0 1 1 line 0 0 3 4")
        self.assertEqual(run("eval", self.output, "--curve", 1, "--at", 0.5).stdout, "0.5\t1.5\t2\n")
        self.assertEqual(run("eval", self.output, "--curve", 0, "--at", 0.5).stdout, "0.5\t0.5\t0.5\n")
        self.assertIn("5", run("apply", self.output, "--curve", 1, "arc-length").stdout)
        self.assertIn("there is no curve '2'; there are 'line', 'line 2', with the numbers 0 to 1\n", run("eval", self.output, "--curve", 2, "--at", 0).stderr)

    def test_an_exact_name_comes_before_a_number(self):
        self.made("line 0 0 1 1 line 0 0 3 4 rename-curve 1 0")
        self.assertEqual(run("eval", self.output, "--curve", 0, "--at", 1).stdout, "1\t3\t4\n")
        process = run("apply", self.output, *words_of("activate-curve 0 evaluate 1"))
        self.assertIn("(3, 4)", process.stdout)

    def test_a_name_stands_where_a_number_of_a_curve_does(self):
        curves = self.made("line 0 0 1 1 circle 0 0 9 line 0 1 1 2 delete-curve circle rename-curve line chord")
        self.assertEqual([curve["name"] for curve in curves], ["chord", "line 2"])
        process = run("new", *words_of("line 0 0 1 1 activate-curve nobody"))
        self.assertEqual(process.returncode, 1)
        self.assertIn("n is the text 'nobody'; the number or name of a curve is needed", process.stderr)

    def test_an_unknown_word_is_named_with_what_could_stand_there(self):
        for words, part in (
            ("frobnicate", "'frobnicate' is not an operation; batten apply --list"),
            ("elevat 1", "'elevat' is not an operation; did you mean 'elevate'? batten apply --list"),
            ("line 0 0 1 1 insrt-knot 0.5", "'insrt-knot' is not an operation; did you mean 'insert-knot'? batten apply --list"),
            ("line 0 0 1 1 frobnicate", "'frobnicate' after 'line 0 0 1 1' is not an operation"),
            ("line 0 0 1 1 insert-knot frobnicate", "'frobnicate' after 'insert-knot' is neither an operation nor a value of u, for which a number is needed"),
            ("line 0 0 1 1 clamp strat", "'strat' after 'clamp' is neither an operation nor a value of end, for which start, end or both is needed"),
            ("line 0 0 1 1 line 0 1 1 1 intersect lin", "'lin' after 'intersect' is neither an operation nor a value of other, for which the name or number of a curve is needed"),
        ):
            self.assertIn(part, self.wrong_usage("new", *words_of(words)))

    def test_what_may_be_left_out_is_left_out_before_an_operation(self):
        (curve,) = self.made("line 0 0 1 1 elevate insert-knot 0.5 select-knot 3 set-knot 0.25 elevate 1")
        self.assertEqual(curve["knots"], [0, 0, 0, 0, 0.25, 0.25, 1, 1, 1, 1])

    def test_what_is_needed_and_not_given_is_named(self):
        needed = re.findall(r"^  ([a-z-]+) <(\w+)>", run("apply", "--list").stdout, re.MULTILINE)
        self.assertGreater(len(needed), 50)
        named = 0
        for name, field in needed:
            process = run("apply", self.empty, name)
            self.assertEqual((process.returncode, process.stdout, process.stderr.count("\n")), (1, "", 1), name)
            self.assertRegex(process.stderr, f": operation 1, {name}: .+\n$")
            named += f"{name}: {field} is missing: " in process.stderr
        self.assertGreaterEqual(named, 10, "others are refused first, since there is no curve")

    def test_a_refusal_is_one_line_whatever_is_refused(self):
        for word, shown in (("a\nb", "a?b"), ("\x1b[31m", "?[31m"), ("\u2028", "?"), ("\udcff", "?"), ("Кривая", "Кривая")):
            for words in (("info", word), ("apply", self.empty, word), ("apply", self.empty, "rename-curve", word), ("figure", self.empty, "-o", "x.svg", "--title", "t", "--show", word), (word,)):
                process = run(*words)
                self.assertIn(process.returncode, (1, 2), words)
                self.assertEqual((process.stdout, process.stderr.count("\n")), ("", 1), words)
                self.assertTrue(shown in process.stderr or "--show" in words, process.stderr)

    def test_an_empty_name_of_a_result_is_refused(self):
        for words in (("new", "circle"), ("apply", self.empty, "reverse"), ("convert", self.empty), ("handout", "x.json"), ("figure", self.empty)):
            self.assertEqual(self.wrong_usage(*words, "-o", ""), f"batten {words[0]}: -o: the name of the file is empty; - is standard output\n")

    def test_limits_are_told(self):
        line = ("new", "line", 0, 0, 1, 1)
        refused = run(*line, "rebuild", "1000000000", 3)
        self.assertIn("it must be from 2 to 100000", refused.stderr)
        union = run("new", "through-points", "1e200,0,0,1e200,-1e200,0,0,-1e200", "local", "chordal", "yes", "--", "union")
        self.assertNotIn("nan", union.stdout + union.stderr)

    def test_new_begins_with_nothing(self):
        (curve,) = self.made("line 0 0 3 4")
        self.assertEqual((curve["name"], curve["points"]), ("line", [[0, 0], [3, 4]]))
        self.assertEqual(run("new", "-o", self.output).returncode, 0)
        self.assertEqual(json.loads(self.output.read_text())["curves"], [])
        self.assertIn("at least one operation", self.wrong_usage("new"))
        self.assertIn("new document: operation 1, elevate", run("new", "elevate").stderr)

    def test_a_foreign_ending_is_refused_before_anything_is_done(self):
        for ending in ("ai", "AI", "txt", "geojson"):
            path = self.folder / f"wave.{ending}"
            error = self.wrong_usage("new", *words_of("line 0 0 1 1"), "-o", path)
            self.assertRegex(error, f"^batten new: 'wave.{ending}' ends in .{ending}, and curves are not written to such files; name it 'wave.json', or with .svg, .dxf, .* or .csv\n$")
            self.assertFalse(path.exists())
        for ending in ("pdf", "PNG", "tex"):
            error = self.wrong_usage("new", *words_of("line 0 0 1 1"), "-o", self.folder / f"wave.{ending}")
            self.assertRegex(error, f"^batten new: 'wave.{ending}' is a picture, as 'batten figure' writes it; a file with curves is 'wave.json'\n")
        for name in ("wave", "wave.JSON", "wave 1.5", "tmp.Yk3xQzA9bc"):
            self.assertEqual(run("new", *words_of("line 0 0 1 1"), "-o", self.folder / name).returncode, 0)
            self.assertTrue((self.folder / name).exists())


if __name__ == "__main__":
    unittest.main()
