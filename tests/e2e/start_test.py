"""Starts that fail: each says why in one sentence and ends with the status for it."""

import os
import subprocess
import unittest


def start(*arguments):
    environment = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return subprocess.run([os.environ["BATTEN_BINARY"], *arguments], env=environment, capture_output=True, text=True)


class StartTest(unittest.TestCase):
    def test_without_a_display(self):
        ended = start()
        self.assertEqual(ended.returncode, 1)
        self.assertEqual(ended.stderr.count("\n"), 1)
        self.assertTrue(ended.stderr.startswith("batten: no display can be opened: "), ended.stderr)

    def test_with_a_file_that_is_not_there(self):
        ended = start("nowhere.json")
        self.assertEqual(ended.returncode, 2)
        self.assertIn("nowhere.json", ended.stderr)

    def test_version_and_help_need_no_display(self):
        self.assertEqual(start("--version").returncode, 0)
        ended = start("--help")
        self.assertEqual(ended.returncode, 0)
        self.assertIn("--example", ended.stdout)


if __name__ == "__main__":
    unittest.main()
