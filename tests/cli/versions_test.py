"""Files of older versions hold what they say: every member comes back with its value."""

import json
import os
import pathlib
import tempfile
import unittest

from program import run

VERSIONS = pathlib.Path(os.environ["BATTEN_GOLDEN"]).parent / "versions"


class Versions(unittest.TestCase):
    def rewritten(self, path):
        """The file as this version writes it."""
        # What an operation that changes nothing leaves; without a curve there is none.
        with tempfile.TemporaryDirectory() as folder:
            output = pathlib.Path(folder) / "out.json"
            name = json.loads(path.read_text())["curves"][0]["name"]
            process = run("apply", path, "rename-curve", 0, name, "-o", output)
            self.assertEqual(process.returncode, 0, process.stderr)
            return json.loads(output.read_text())

    def test_every_member_comes_back(self):
        paths = sorted(VERSIONS.glob("*.json"))
        self.assertGreater(len(paths), 5)
        for path in paths:
            with self.subTest(path=path.name):
                old, new = json.loads(path.read_text()), self.rewritten(path)
                self.assertEqual(len(new["curves"]), len(old["curves"]))
                for before, after in zip(old.pop("curves"), new.pop("curves")):
                    for name in ("degree", "knots", "points"):
                        self.assertEqual(after[name], before[name], f"{before['name']}: {name}")
                    self.assertEqual(after["weights"], before.get("weights", [1] * len(before["points"])))
                    self.assertEqual(after["periodic"], before.get("periodic", False))
                    for name in set(before) - {"degree", "knots", "points", "weights", "periodic"}:
                        self.assertEqual(after.get(name), before[name], f"{before['name']}: {name}")
                self.assert_comes_back(old, new)

    def assert_comes_back(self, old, new):
        for name, value in old.items():
            if name == "pictures":  # whose paths are told from the folder of the file
                for before, after in zip(value, new[name]):
                    self.assertEqual({**after, "path": ""}, {**before, "path": ""})
                    self.assertEqual(pathlib.Path(after["path"]).name, before["path"])
            else:
                self.assertEqual(new.get(name), value, name)


if __name__ == "__main__":
    unittest.main()
