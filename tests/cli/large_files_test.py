"""Files of many points: what they cost in memory, and that the numbers are the same behind them.
Called with a number of points, and perhaps "long", it writes such a file for bench/README.md."""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from program import BINARY, environment, run

COUNT = 300000


def peak_memory(*arguments):
    """The most memory, in bytes, that the program took; it must end with 0."""
    process = subprocess.Popen([BINARY, *(str(argument) for argument in arguments)], env=environment(), stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise AssertionError(f"{arguments} ended with {process.returncode}")
    return usage.ru_maxrss * 1024


class LargeFiles(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.points = [[i + math.sin(i), math.cos(i)] for i in range(COUNT)]
        cls.curve = {"name": "long", "degree": 3, "knots": [0.0] * 4 + [i + 0.5 + 0.1 * math.sin(i) for i in range(COUNT - 4)] + [float(COUNT)] * 4,
                     "points": cls.points, "weights": [2 + math.cos(i) for i in range(COUNT)], "kind": "custom"}
        cls.file = cls.folder / "long.json"
        cls.file.write_text(json.dumps({"format": "batten", "version": 1, "curves": [cls.curve]}))

    @unittest.skipIf(os.environ["BATTEN_SANITIZED"] == "1", "the sanitizers take memory of their own")
    def test_reading_takes_at_most_four_times_the_memory_of_the_numbers(self):
        small = self.folder / "small.json"
        small.write_text('{"format": "batten", "version": 1}')
        numbers = 8 * sum(len(self.curve[name]) * (2 if name == "points" else 1) for name in ("knots", "points", "weights"))
        self.assertLess(peak_memory("check", self.file) - peak_memory("check", small), 4 * numbers)
        for info in (["info"], ["info", "--json"]):
            self.assertLess(peak_memory(*info, self.file) - peak_memory(*info, small), 4 * numbers)

    def test_every_number_comes_back(self):
        output = self.folder / "out.json"
        process = run("apply", self.file, "rename-curve", 0, "same", "-o", output)
        self.assertEqual(process.returncode, 0, process.stderr)
        (curve,) = json.loads(output.read_text())["curves"]
        for name in ("degree", "knots", "points", "weights"):
            self.assertEqual(curve[name], self.curve[name], name)

    def test_a_file_that_is_cut_is_refused_where_it_ends(self):
        text = self.file.read_bytes()
        cut = self.folder / "cut.json"
        cut.write_bytes(text[: len(text) // 2])
        process = run("check", cut)
        self.assertEqual((process.returncode, process.stdout), (1, ""))
        self.assertIn("cut.json: line 1, column", process.stderr)


def write_large(count, is_long):
    """Numbers of all their digits, or of few."""
    noise = (lambda i: i * 7919 % 1000 * 0.000123456789) if is_long else (lambda i: 0)
    knots = [0] * 3 + [i + noise(i) for i in range(count - 2)]
    points = ",".join(f"[{i + 7 * noise(i)},{9 * noise(3 * i)}]" if is_long else f"[{i % 1000},{i * 7919 % 10}]" for i in range(count))
    weights = ', "weights": [%s]' % ",".join(str(1 + i % 2) for i in range(count)) if is_long else ""
    print('{"format": "batten", "version": 1, "curves": [{"degree": 3, "knots": %s, "points": [%s]%s}]}'
          % (json.dumps(knots + knots[-1:] * 3), points, weights))


if __name__ == "__main__":
    if sys.argv[1:2] and sys.argv[1].isdigit():
        write_large(int(sys.argv[1]), "long" in sys.argv)
    else:
        unittest.main()
