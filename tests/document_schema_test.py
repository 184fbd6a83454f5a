"""Checks every document that there is, and random ones that the program writes, against the JSON Schema of documents, and that FORMAT.md and the schema name the same members."""

import json
import pathlib
import re
import subprocess
import sys
import unittest

import jsonschema

ROOT = pathlib.Path(sys.argv.pop(1))
PRINT_DOCUMENTS = sys.argv.pop(1)
SCHEMA = json.loads((ROOT / "assets/batten.schema.json").read_text())
FORMAT = (ROOT / "core/document/FORMAT.md").read_text()
DOCUMENTS = [path for pattern in ("assets/examples/*.json", "tests/data/versions/*.json", "tests/data/sessions/*.json", "docs/**/*.json") for path in ROOT.glob(pattern)]


class DocumentSchema(unittest.TestCase):
    validator = jsonschema.Draft202012Validator(SCHEMA)

    def test_schema_is_one(self):
        jsonschema.Draft202012Validator.check_schema(SCHEMA)

    def test_documents_fit(self):
        count = 0
        for path in DOCUMENTS:
            document = json.loads(path.read_text())
            if not isinstance(document, dict) or document.get("format") != "batten":
                continue
            count += 1
            with self.subTest(document=path.name):
                self.assertEqual([f"{error.json_path}: {error.message}" for error in self.validator.iter_errors(document)], [])
        self.assertGreater(count, 30)

    def test_random_documents_fit(self):
        count = 300
        documents = json.loads(subprocess.run([PRINT_DOCUMENTS, str(count)], capture_output=True, check=True, timeout=120).stdout)
        self.assertEqual(len(documents), count)
        for document in documents:
            errors = [f"{error.json_path}: {error.message}" for error in self.validator.iter_errors(document)]
            self.assertEqual(errors, [], json.dumps(document)[:2000])
        written = {name for document in documents for name in document}
        self.assertEqual(set(SCHEMA["properties"]) - written, set(), "members that no document had")
        curves = [curve for document in documents for curve in document.get("curves", [])]
        self.assertEqual(set(SCHEMA["$defs"]["curve"]["properties"]) - {name for curve in curves for name in curve}, set())

    def test_example_of_the_format_fits(self):
        self.validator.validate(json.loads(re.search(r"```json\n(.*?)```", FORMAT, re.S).group(1)))

    def test_every_member_of_the_schema_is_told(self):
        for part in (SCHEMA, *SCHEMA["$defs"].values()):
            for name in part.get("properties", {}):
                self.assertRegex(FORMAT, rf'[`".]{name}["`]', name)


if __name__ == "__main__":
    unittest.main()
