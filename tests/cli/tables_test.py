"""Tables of numbers in place of lists: @FILE, and @- for standard input."""

import json
import math
import os
import pathlib
import tempfile
import unittest

from program import answer, run, write_document

LINE = {"name": "line", "degree": 1, "knots": [0, 0, 2, 2], "points": [[0, 0], [3, 4]]}
CORNERS = [[0, 0], [4, 0], [4, 3]]


class Tables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = write_document(self.folder / "line.json", LINE)
        self.output = self.folder / "out.json"

    def table(self, text):
        path = self.folder / "table.csv"
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return f"@{path}"

    def made(self, *operations, **options):
        """The points of the curve that `new` makes."""
        process = run("new", *operations, "-o", self.output, **options)
        self.assertEqual(process.returncode, 0, process.stderr)
        return json.loads(self.output.read_text())["curves"][0]["points"]

    def refused(self, status, *arguments, **options):
        process = run(*arguments, **options)
        self.assertEqual((process.returncode, process.stdout), (status, ""), process.stderr)
        return process.stderr

    def test_points_stand_one_a_line(self):
        for text in ("0,0\n4,0\n4,3\n", "0 0\n4 0\n4 3", "0;0\r\n4;0\r\n4;3\r\n", "\ufeffx,y\n0,0\n4,0\n4,3", "# corners\n\n 0,0 # start\n+4 ,\t0,\n4., 3e0\n",
                     '"x","y"\n0,0\n4,0\n4,3', "x\ty\n0,0\t0,0\n4,0\t0,0\n4,0\t3,0\n",
                     "Length;Height\n0;0,0\n4,0;0\n4;3,0\n"):
            with self.subTest(text):
                self.assertEqual(self.made("polyline", self.table(text)), CORNERS)

    def test_points_come_from_standard_input(self):
        self.assertEqual(self.made("polyline", "@-", input="0,0\n4,0\n4,3\n"), CORNERS)

    def test_of_samples_of_two_curves_the_first_is_read(self):
        """As `convert` writes them: of a line from the origin to (3, 4) the points at u = 0, 1, 2."""
        both = write_document(self.folder / "both.json", LINE, {**LINE, "name": "other", "points": [[7, 7], [9, 9]]})
        samples = self.folder / "both.csv"
        self.assertEqual(run("convert", both, "-o", samples, "--samples", 3).returncode, 0)
        process = run("new", "polyline", f"@{samples}", "-o", self.output)
        self.assertEqual(process.returncode, 0)
        self.assertIn("both.csv: the points are those of the first curve; the rows of another one are left out: 3\n", process.stderr)
        self.assertEqual(json.loads(self.output.read_text())["curves"][0]["points"], [[0, 0], [1.5, 2], [3, 4]])

    def test_a_pipe_is_a_table_too(self):
        reader, writer = os.pipe()
        os.write(writer, b"0 0\n4 0\n4 3\n")
        os.close(writer)
        self.assertEqual(self.made("polyline", f"@/dev/fd/{reader}", pass_fds=(reader,)), CORNERS)
        os.close(reader)

    def test_numbers_and_indices_may_share_lines(self):
        refined = self.table("0.5 1\n1.5\n")
        self.assertEqual(len(json.loads(run("apply", self.file, "insert-knots", refined, "-o", "-").stdout)["curves"][0]["points"]), 5)
        (moved,) = answer("apply", self.file, "move-points", self.table("0\n1"), 1, 1)
        self.assertEqual(moved["arguments"], [[0, 1], 1, 1])

    def test_more_points_than_a_command_line_holds(self):
        count = 100000
        text = "".join(f"{math.cos(0.01 * i)!r},{0.001 * i!r}\n" for i in range(count))
        points = self.made("polyline", self.table(text))
        self.assertEqual(len(points), count)
        self.assertEqual(points[-1], [math.cos(0.01 * (count - 1)), 0.001 * (count - 1)])

    def test_parameters_of_eval_come_from_tables(self):
        rows = answer("eval", self.file, "--at", self.table("u\n0.5, 1\n1.5\n"), "--at", "1/4")
        self.assertEqual([row["u"] for row in rows], [0.5, 1, 1.5, 0.25])
        piped = run("eval", self.file, "--at", "@-", input="2\n")
        self.assertEqual((piped.returncode, piped.stdout), (0, "2\t3\t4\n"))
        self.assertIn("table.csv: line 2: 'x' cannot be read here; finite numbers with a decimal point are needed",
                      self.refused(1, "eval", self.file, "--at", self.table("1\nx\n")))
        for text, sentence in (("0\n1,,2\n", "line 2: ',' cannot be read here"), ("0\n1,5;2,5\n", "line 2: the numbers are separated in two ways"),
                               ("nan,nan\n0,0\n", "line 1: 'nan' cannot"), ("O.5,1\n", "line 1: 'O.5' cannot"), (b"0,0\n\x00\x01", "line 2: '?"),
                               (b"\xff\xfe0\x00", "line 1: '??0?"), ("0\n" + "9" * 400, "line 2: '" + "9" * 40 + "'")):
            self.assertIn(f"table.csv: {sentence}", self.refused(1, "eval", self.file, "--at", self.table(text)))
        self.assertIn("3 is outside the domain", self.refused(1, "eval", self.file, "--at", self.table("3")))

    def test_what_is_wrong_is_told_with_file_and_line(self):
        cases = (("0,0\n1,x\n", "line 2, column 2: 'x' is not a finite number; this table has decimal points"),
                 ("0,0\n1\n", "line 2, column 2: the line has one column"),
                 ("0,0\nnan,1\n", "line 2, column 1: 'nan' is not a finite number"), ("nan,nan\n0,0\n", "line 1, column 1: 'nan' is not a finite number"),
                 ("x\ty\n1,234,567\t2\n", "line 2, column 1: '1,234,567' has thousands separators, which are not read"), ("0,0\n1e999,0", "line 2, column 1: '1e999' is not a finite number"),
                 ("x,y\nlatitude,longitude\n", "no line with two numbers was found"), ("0,0\n1.2.3,4", "line 2, column 1: '1.2.3' is not"))
        for text, sentence in cases:
            with self.subTest(text):
                error = self.refused(1, "new", "polyline", self.table(text))
                self.assertTrue(error.startswith("new document: operation 1, polyline @"), error)
                self.assertIn(f"table.csv: {sentence}", error)

    def test_a_table_without_points_says_so(self):
        self.assertIn("no line with two numbers was found", self.refused(1, "new", "polyline", self.table("# nothing\n")))

    def test_tables_that_cannot_be_read_are_named(self):
        self.assertIn("none.csv: the file cannot be opened: No such file", self.refused(1, "new", "polyline", f"@{self.folder}/none.csv"))
        self.assertIn("this is a folder", self.refused(1, "new", "polyline", f"@{self.folder}"))
        closed = self.refused(1, "new", "polyline", "@-", stdin=None, preexec_fn=lambda: os.close(0))
        self.assertIn("standard input: the file cannot be read: Bad file descriptor", closed)

    def test_standard_input_is_read_once(self):
        text = self.file.read_text()
        for arguments in (("apply", "-", "insert-knots", "@-"), ("new", "polyline", "@-", "polyline", "@-"), ("eval", "-", "--at", "@-"),
                          ("eval", self.file, "--at", "@-", "--at", "@-")):
            with self.subTest(arguments):
                self.assertIn("standard input, -, can be read only once", self.refused(2, *arguments, input="0,0\n1,1\n" if arguments[0] == "new" else text))

    def test_only_lists_are_read_from_tables(self):
        answer("apply", self.file, "rename-curve", 0, "@-")
        self.assertIn("u is the text '@table'; a number is needed", self.refused(1, "apply", self.file, "insert-knot", "@table"))


if __name__ == "__main__":
    unittest.main()
