"""Lessons as pages: every lesson of the program, and what is refused."""

import html.parser
import pathlib
import re
import tempfile
import unittest
import urllib.parse
import xml.dom.minidom

from program import run

LESSONS = pathlib.Path(__file__).resolve().parents[2] / "assets" / "lessons"


class Page(html.parser.HTMLParser):
    """The texts of a page by their elements, its pictures, and whether its elements are closed in order."""

    OPEN = {"meta", "img"}

    def __init__(self, text):
        super().__init__()
        self.stack, self.texts, self.pictures, self.wrong = [], {}, [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        if tag == "img":
            self.pictures.append(dict(attributes))
        if tag not in self.OPEN:
            self.stack.append(tag)

    def handle_endtag(self, tag):
        if not self.stack or self.stack.pop() != tag:
            self.wrong.append(tag)

    def handle_data(self, data):
        for tag in self.stack:
            self.texts[tag] = self.texts.get(tag, "") + data


class Handout(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def page(self, lesson):
        output = self.folder / "page.html"
        process = run("handout", lesson, "-o", output)
        self.assertEqual((process.returncode, process.stdout, process.stderr), (0, "", ""))
        return output.read_text()

    def test_every_lesson_makes_a_page(self):
        lessons = sorted(LESSONS.glob("*.json"))
        self.assertTrue(lessons)
        for lesson in lessons:
            with self.subTest(lesson=lesson.name):
                page = Page(self.page(lesson))
                self.assertEqual((page.wrong, page.stack), ([], []))
                for picture in page.pictures:
                    kind, _, data = picture["src"].partition(",")
                    self.assertEqual(kind, "data:image/svg+xml")
                    xml.dom.minidom.parseString(urllib.parse.unquote(data))

    def test_texts_and_figures_are_those_of_the_steps(self):
        text = self.page(LESSONS / "multiplicity-and-continuity.json")
        page = Page(text)
        self.assertIn("Multiplicity and continuity", page.texts["h1"])
        self.assertIn("p−m", page.texts["sup"])
        self.assertEqual(len(re.findall('class="step"', text)), 7)
        self.assertEqual(len(re.findall('class="task"', text)), 2)
        self.assertIn("Values and sum", page.texts["h3"], "cards are called as in the window")
        self.assertIn('<td colspan="5">', text, "verdicts stand above the columns of the jumps")
        self.assertEqual(len(re.findall('<div class="shown"><figure>', text)), 7, "cards stand beside the figure")
        self.assertNotIn("avoid-page", text, "a step may be longer than what is left of a page")
        self.assertEqual(len(page.pictures), 14, "curve and basis functions of each step")

    def test_markup_in_texts_is_text(self):
        lesson = self.folder / "odd.json"
        lesson.write_text('{"format": "batten-lesson", "version": 1, "title": "a < b & \\"c\\"", "text": "<script>", "steps": [{"text": "{braces}"}]}')
        text = self.page(lesson)
        self.assertNotIn("<script>", text)
        page = Page(text)
        self.assertEqual(page.texts["h1"].strip(), 'a < b & "c"')
        self.assertIn("{braces}", page.texts["p"])

    def test_standard_output_is_a_file_too(self):
        process = run("handout", LESSONS / "multiplicity-and-continuity.json", "-o", "-")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertTrue(process.stdout.startswith("<!DOCTYPE html>"))

    def test_what_is_no_lesson_is_refused(self):
        lesson = self.folder / "broken.json"
        lesson.write_text("{}")
        output = self.folder / "page.html"
        process = run("handout", lesson, "-o", output)
        self.assertEqual((process.returncode, process.stdout), (1, ""))
        self.assertIn('the member "format" is missing', process.stderr)
        process = run("handout", "", "-o", self.folder / "x.html")
        self.assertEqual((process.returncode, process.stdout, process.stderr.count("\n")), (1, "", 1))
        self.assertFalse(output.exists())
        process = run("handout", self.folder / "absent.json", "-o", output)
        self.assertEqual(process.returncode, 1)
        self.assertIn("absent.json", process.stderr)
        self.assertEqual(run("handout", lesson).returncode, 2)
        process = run("handout", lesson, "-o", lesson)
        self.assertEqual((process.returncode, process.stderr), (2, f"batten handout: -o: '{lesson}' is the lesson itself; the handout needs a name of its own\n"))
        self.assertEqual(lesson.read_text(), "{}")


if __name__ == "__main__":
    unittest.main()
