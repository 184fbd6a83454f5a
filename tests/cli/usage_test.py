"""What the words of a command line may be: every refusal is one whole sentence that says what, where and what is allowed."""

import pathlib
import tempfile
import unittest

from program import run, write_document

LINE = {"name": "line", "degree": 1, "knots": [0, 0, 2, 2], "points": [[0, 0], [3, 4]]}
FILE_MEANING = "A curve file of Batten, or of the program that its ending names; - is standard input"
HAS_WINDOW = "profile" in run("--help").stdout
SUBCOMMANDS = ["info", "eval", "apply", "new", "convert", "check", "handout", "code", "figure"] + ["profile"] * HAS_WINDOW


class Usage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = write_document(self.folder / "line.json", LINE)

    def refused(self, *words):
        """The sentence, without the end of its line."""
        process = run(*words, cwd=self.folder)
        self.assertEqual((process.returncode, process.stdout, process.stderr.count("\n")), (2, "", 1), (words, process.stderr))
        self.assertEqual([path.name for path in self.folder.iterdir()], ["line.json"])
        return process.stderr.removesuffix("\n")

    def test_an_unknown_option_is_told_with_the_nearest(self):
        for name in SUBCOMMANDS:
            self.assertEqual(self.refused(name, "line.json", "--foo"),
                             f"batten {name}: there is no option '--foo'; 'batten {name} --help' explains those that there are")
            self.assertEqual(self.refused(name, "line.json", "--hlep=5"), f"batten {name}: there is no option '--hlep'; did you mean '--help'?")
        self.assertEqual(self.refused("figure", "line.json", "-o", "a.svg", "--titel", "x"), "batten figure: there is no option '--titel'; did you mean '--title'?")
        self.assertEqual(self.refused("figure", "line.json", "--transp"), "batten figure: there is no option '--transp'; did you mean '--transparent'?")
        self.assertEqual(self.refused("figure", "line.json", "-x"), "batten figure: there is no option '-x'; 'batten figure --help' explains those that there are")
        # Before what lacks by it.
        self.assertEqual(self.refused("convert", "line.json", "--ouput", "b.dxf"), "batten convert: there is no option '--ouput'; did you mean '--output'?")
        self.assertEqual(self.refused("--hlep"), "batten: there is no option '--hlep'; did you mean '--help'?")

    def test_what_is_missing_is_told_with_its_meaning(self):
        for name in ("info", "eval", "convert", "code", "figure"):
            self.assertEqual(self.refused(name), f"batten {name}: FILE is missing: {FILE_MEANING}")
        self.assertEqual(self.refused("check"), "batten check: FILE is missing: Curve files; - is standard input")
        self.assertEqual(self.refused("handout"), "batten handout: LESSON is missing: The file of a lesson")
        self.assertEqual(self.refused("convert", "line.json"), "batten convert: --output FILE is missing: Where the curves are written; - is standard output")
        self.assertIn("batten eval: --at U is missing: A parameter in the domain of the curve", self.refused("eval", "line.json"))
        self.assertIn("batten code: --as LANGUAGE is missing: The language: json, ", self.refused("code", "line.json"))

    def test_what_an_operation_lacks_is_not_sought_among_the_options(self):
        for words in (("mirror", "-o", "a.json"), ("mirror", "--json")):
            process = run("apply", "line.json", *words, cwd=self.folder)
            self.assertEqual((process.returncode, process.stderr),
                             (1, "line.json: operation 1, mirror: angle is missing: of the line in degrees; 0 turns upside down, 90 left to right\n"))
        self.assertEqual(run("apply", "line.json", "rename-curve", "0", "--", "-o", "-o", "-", cwd=self.folder).returncode, 0, "behind -- it is a name")

    def test_an_option_is_no_name_of_a_result(self):
        for words in (("apply", "line.json", "elevate", "1", "-o", "--json"), ("convert", "line.json", "-o", "--json"), ("new", "line", "-o", "-o")):
            self.assertRegex(self.refused(*words), f"^batten {words[0]}: -o: '(--json|-o)' is an option, not a file; './\\1' is a file of that name$")
        self.assertEqual(run("apply", "line.json", "elevate", "1", "-o", "./--json", cwd=self.folder).returncode, 0)
        self.assertTrue((self.folder / "--json").exists())

    def test_a_long_word_is_shortened(self):
        for words in (("apply", "line.json", "y" * 100_000), ("info", "y" * 100_000), ("y" * 100_000,), ("figure", "line.json", "--" + "y" * 100_000)):
            process = run(*words, cwd=self.folder)
            self.assertNotEqual(process.returncode, 0)
            self.assertIn("yyy...yyy", process.stderr)
            self.assertLess(len(process.stderr), 500)

    def test_a_result_is_not_put_in_the_place_of_a_device(self):
        for device in ("/dev/stdout", "/dev/null"):
            process = run("apply", "line.json", "elevate", "1", "-o", device, cwd=self.folder)
            self.assertEqual((process.returncode, process.stderr), (1, f"{device}: this is not an ordinary file, so it cannot be saved to\n"))

    def test_an_option_needs_its_value(self):
        self.assertEqual(self.refused("figure", "line.json", "-o", "a.svg", "--title"),
                         "batten figure: --title: nothing stands behind it; TEXT is needed: A title above the picture")
        for name in ("apply", "new", "convert", "handout", "figure"):
            for option in ("-o", "--output"):
                self.assertIn(f"batten {name}: --output: nothing stands behind it; FILE is needed: Where ", self.refused(name, "line.json", option))
        self.assertIn("--output: nothing stands behind it", self.refused("apply", "line.json", "elevate", "1", "-o"))
        self.assertIn("--curve: nothing stands behind it; NAME is needed", self.refused("apply", "line.json", "elevate", "1", "--curve"))
        self.assertIn("--at: nothing stands behind it; U is needed", self.refused("eval", "line.json", "--at"))
        self.assertIn("--to: nothing stands behind it; FORMAT is needed", self.refused("convert", "line.json", "-o", "a.dxf", "--to="))

    def test_an_option_is_given_once(self):
        self.assertEqual(self.refused("figure", "line.json", "-o", "a.svg", "-o", "b.svg"),
                         "batten figure: --output is given 2 times, the last time as 'b.svg'; it can be given once")
        self.assertIn("--curve is given 3 times", self.refused("eval", "line.json", "--at", 0, "--curve", 0, "--curve", 0, "--curve", "line"))
        self.assertIn("--output is given 2 times", self.refused("apply", "line.json", "-o", "a.json", "elevate", "1", "-o", "b.json"))

    def test_a_flag_has_no_value(self):
        for name in ("info", "check"):
            for value in ("5", "no", "abc"):
                self.assertEqual(self.refused(name, "line.json", f"--json={value}"), f"batten {name}: --json takes no value; it stands alone")

    def test_a_wrong_value_is_told_with_what_is_allowed(self):
        self.assertEqual(self.refused("convert", "line.json", "-o", "a.dxf", "--from", "dfx").partition("? possible are batten, svg, ")[0],
                         "batten convert: --from: 'dfx' is none of them; did you mean 'dxf'")
        self.assertEqual(self.refused("eval", "line.json", "--at", 0, "--side", "above"),
                         "batten eval: --side: 'above' is none of them; possible are left or right")
        self.assertEqual(self.refused("eval", "line.json", "--at", 0, "--derivatives", "two"),
                         "batten eval: --derivatives: two is no whole number from 0 to 25")
        self.assertEqual(self.refused("check", "line.json", "--within", "-1"), "batten check: --within: -1 is no length above 0")

    def test_a_word_too_many_is_named(self):
        for name in ("info", "eval", "convert", "code", "figure"):
            self.assertEqual(self.refused(name, "line.json", "other.json"), f"batten {name}: there is no place for 'other.json'; beside options one FILE is taken")
        self.assertIn("no place for 'other'; beside options one LESSON", self.refused("handout", "line.json", "other"))
        self.assertIn("batten eval: there is no place for '0.5'", self.refused("eval", "line.json", "--at", "0", "0.5"))
        self.assertIn("batten info: there is no place for 'eval'", self.refused("info", "line.json", "eval"))

    def test_an_unknown_subcommand_is_told_with_the_nearest(self):
        self.assertEqual(self.refused("figrue", "line.json"), "batten: 'figrue' is neither a file to open nor a subcommand; did you mean 'batten figure'?")
        self.assertIn("batten: 'nosuch' is neither a file to open nor a subcommand; a subcommand is info, eval, ", self.refused("nosuch"))

    @unittest.skipUnless(HAS_WINDOW, "for a build with a window")
    def test_no_document_gives_way_to_what_a_session_writes(self):
        before = self.file.read_bytes()
        lost = "'line.json' holds something else, which would be lost; name a file that is new, or the one of an earlier session"
        self.assertEqual(self.refused("line.json", "--session-log", "line.json"), f"batten: --session-log: {lost}")
        self.assertEqual(self.refused("--session-log", "line.json"), f"batten: --session-log: {lost}")
        self.assertEqual(self.refused("line.json", "--state-report", "./line.json"), f"batten: --state-report: {lost}".replace("'line", "'./line"))
        self.assertEqual(self.file.read_bytes(), before)

    @unittest.skipUnless(HAS_WINDOW, "for a build with a window")
    def test_words_for_the_window(self):
        self.assertEqual(self.refused("none.json"), "batten: there is no file none.json")
        self.assertEqual(self.refused("."), "batten: . is a folder; files with curves are opened")
        self.assertEqual(self.refused("--display-scale", "9"), "batten: --display-scale: 9 is no number from 0.5 to 4")
        self.assertEqual(self.refused("line.json", "info", "line.json"), "batten info: there is no place for 'line.json'; beside options one FILE is taken")
        self.assertEqual(self.refused("--example", "wave", "info", "line.json"), "batten info: --example is for the window, which 'batten info' does not open")
        self.assertEqual(self.refused("profile", "none.json", "--drag"), "batten profile: there is no file none.json")
        self.assertIn("batten profile: one gesture is needed: --drag, ", self.refused("profile", "line.json"))


if __name__ == "__main__":
    unittest.main()
