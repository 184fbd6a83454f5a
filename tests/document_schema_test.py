"""Checks every document that there is against the JSON Schema of documents, and that FORMAT.md and the schema name the same members."""

import json
import pathlib
import re
import sys
import unittest

import jsonschema

ROOT = pathlib.Path(sys.argv.pop(1))
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

    def test_example_of_the_format_fits(self):
        self.validator.validate(json.loads(re.search(r"```json\n(.*?)```", FORMAT, re.S).group(1)))

    def test_every_member_of_the_schema_is_told(self):
        for part in (SCHEMA, *SCHEMA["$defs"].values()):
            for name in part.get("properties", {}):
                self.assertRegex(FORMAT, rf'[`".]{name}["`]', name)


if __name__ == "__main__":
    unittest.main()
