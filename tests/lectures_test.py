"""docs/lectures.md: every lesson, step, example, view and command that it names is there, every view and lesson is named, and the steps show the views."""

import json
import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(sys.argv.pop(1))
COMMANDS = ROOT / "app/editor/commands"
HEADING = ["in the notes", "lesson", "example", "views", "commands"]
MENUS_TITLE = "Views and their menus"


def names_in(cell):
    return re.findall(r"`([^`]+)`", cell)


def sections():
    """The rows of the tables by the title of their section, each as its cells."""
    found, title = {}, None
    for line in (ROOT / "docs/lectures.md").read_text().splitlines():
        if line.startswith("## "):
            title = line[3:]
        elif line.startswith("|") and not line.startswith("|---"):
            found.setdefault(title, []).append([cell.strip().replace("\\|", "|") for cell in re.split(r"(?<!\\)\|", line)[1:-1]])
    return found


def lesson_steps(cell):
    """The lessons that a cell names, each with the numbers of its steps."""
    for name, numbers in re.findall(r"`([^`]+)`((?: \d+(?:–\d+)?,?)*)", cell):
        ranges = [list(map(int, part.split("–"))) for part in re.findall(r"\d+(?:–\d+)?", numbers)]
        yield name, [step for bounds in ranges for step in range(bounds[0], bounds[-1] + 1)]


def views_by_step(name):
    """What each step of a lesson shows."""
    lesson = json.loads((ROOT / f"assets/lessons/{name}.json").read_text())
    shown = lesson.get("view", {}).get("overlays", [])
    result = []
    for step in lesson["steps"]:
        shown = step.get("view", {}).get("overlays", shown)
        result.append(set(shown))
    return result


def named(folder):
    return set((ROOT / folder / "order.txt").read_text().split())


def view_menus():
    """The menu of each view, from the sources of the program."""
    names = dict(re.findall(r"Named\{(\w+),\s*\"([a-z-]+)\"", (ROOT / "app/editor/state/overlay.h").read_text()))
    source = (COMMANDS / "overlay_commands.cpp").read_text()
    chapters = dict(re.findall(r"const char\* (\w+_views) = \"([^\"]+)\"", source))
    menus = {}
    for enumerator, rest in re.findall(r"\{(\w+), \"toggle-[a-z-]+\"(.*?)\}[,}]", source, re.S):
        chapter = re.search(r"\b(\w+_views)\b", rest)
        menus[names[enumerator]] = f"Watch > {chapters[chapter.group(1)]}" if chapter else "View"
    assert set(menus) == set(names.values()), set(names.values()) ^ set(menus)
    return menus


class Lectures(unittest.TestCase):
    chapters = {title: rows for title, rows in sections().items() if title != MENUS_TITLE}
    rows = [row for table in chapters.values() for row in table[1:]]

    def test_tables_have_one_heading(self):
        for title, table in self.chapters.items():
            self.assertEqual(table[0], HEADING, title)
        for row in self.rows:
            self.assertEqual(len(row), len(HEADING), row)

    def test_what_is_named_is_there(self):
        commands = "".join(path.read_text() for path in COMMANDS.glob("*.cpp"))
        for notes, lesson, example, views, command in self.rows:
            with self.subTest(row=notes):
                self.assertEqual([name for name, _ in lesson_steps(lesson) if name not in named("assets/lessons")], [])
                self.assertEqual(set(names_in(example)) - named("assets/examples"), set())
                self.assertEqual(set(names_in(views)) - set(view_menus()), set())
                self.assertEqual([name for name in names_in(command) if f'"{name}"' not in commands], [])
                self.assertTrue(names_in(lesson) or names_in(example) or names_in(command), "it is to be found somewhere")
                self.assertTrue(names_in(views))

    def test_steps_show_the_views(self):
        for notes, lesson, _, views, _ in self.rows:
            for name, steps in lesson_steps(lesson):
                shown = views_by_step(name)
                with self.subTest(row=notes):
                    self.assertTrue(steps)
                    self.assertLessEqual(max(steps), len(shown))
                    for step in steps:
                        self.assertTrue(set(names_in(views)) & shown[step - 1], f"step {step} shows {sorted(shown[step - 1])}")

    def test_nothing_is_left_out(self):
        self.assertEqual(set(view_menus()) - {name for row in self.rows for name in names_in(row[3])}, set())
        self.assertEqual(named("assets/lessons") - {name for row in self.rows for name in names_in(row[1])}, set())
        self.assertEqual(named("assets/examples") - {name for row in self.rows for name in names_in(row[2])}, set())

    def test_menus_are_those_of_the_views(self):
        told = {name: menu for names, menu in sections()[MENUS_TITLE][1:] for name in names_in(names)}
        self.assertEqual(told, view_menus())


if __name__ == "__main__":
    unittest.main()
