"""Checks every lesson, and the example of their README, against the JSON Schema of lessons, and that the schema refuses what the program does."""

import copy
import json
import pathlib
import re
import sys
import unittest

import jsonschema

ROOT = pathlib.Path(sys.argv.pop(1))
SCHEMA = json.loads((ROOT / "assets/lesson.schema.json").read_text())
LESSONS = ROOT / "assets/lessons"


class Lessons(unittest.TestCase):
    validator = jsonschema.Draft202012Validator(SCHEMA)

    def example(self):
        return json.loads(re.search(r"```json\n(.*?)```", (LESSONS / "README.md").read_text(), re.S).group(1))

    def test_schema_is_one(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)

    def test_lessons_fit(self):
        for path in sorted(LESSONS.glob("*.json")):
            with self.subTest(lesson=path.name):
                self.assertEqual([error.message for error in self.validator.iter_errors(json.loads(path.read_text()))], [])

    def test_example_of_the_readme_fits(self):
        self.validator.validate(self.example())

    def test_readme_names_every_check(self):
        names = [check["properties"]["check"]["const"] for check in SCHEMA["$defs"]["check"]["oneOf"]]
        rows = re.findall(r"^\| (`.*?) \|", (LESSONS / "README.md").read_text(), re.M)
        self.assertEqual(sorted(names), sorted(name for row in rows for name in re.findall(r"`([a-z-]+)`", row)))

    def test_order_names_lessons(self):
        names = (LESSONS / "order.txt").read_text().split()
        self.assertEqual(sorted(names), sorted(path.stem for path in LESSONS.glob("*.json")))

    def test_wrong_lessons_do_not_fit(self):
        def spoiled(change):
            lesson = copy.deepcopy(self.example())
            change(lesson)
            return lesson

        for change in (lambda lesson: lesson.pop("title"),
                       lambda lesson: lesson.update(version=2),
                       lambda lesson: lesson.update(steps=[]),
                       lambda lesson: lesson["steps"][0].update(color="red"),
                       lambda lesson: lesson["steps"][2].pop("checks"),
                       lambda lesson: lesson["steps"][2].pop("task"),
                       lambda lesson: lesson["steps"][2]["checks"][0].update(check="magic"),
                       lambda lesson: lesson["steps"][2]["checks"][0].pop("is"),
                       lambda lesson: lesson["steps"][1].update(do=["insert-knot"])):
            self.assertFalse(self.validator.is_valid(spoiled(change)))


if __name__ == "__main__":
    unittest.main()
