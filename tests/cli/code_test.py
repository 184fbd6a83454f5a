"""Curves as text for programs: what Python, C++ and TeX make of it, against what the program evaluates."""

import json
import math
import pathlib
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time
import unittest

from program import answer, run, write_document

PARAMETERS = 33


def bits(values):
    return [struct.pack("d", value) for value in values]


def bezier(points, t):
    while len(points) > 1:
        points = [tuple((1 - t) * a + t * b for a, b in zip(p, q)) for p, q in zip(points, points[1:])]
    return points[0]


def clamped(degree, inner=()):
    return [0.0] * (degree + 1) + list(inner) + [1.0] * (degree + 1)


CURVES = {
    "cubic": {"degree": 3, "knots": clamped(3), "points": [[0, 0], [1, 2], [3, 2], [4, 0]]},
    "line": {"degree": 1, "knots": [0, 0, 1 / 3, 1, 1], "points": [[0, 0], [1 / 6, 2], [-4 / 3, 0.1]]},
    "unclamped quadratic": {"degree": 2, "knots": [0, 1, 2, 3, 4, 5, 6], "points": [[0, 0], [2, 0], [2, 2], [6, 2]]},
    "unequal weights": {"degree": 3, "knots": clamped(3, [0.25, 0.5, 0.5]), "weights": [1, 20, 0.05, 3, 1, 7, 2],
                        "points": [[0, 0], [1, 3], [2, -3], [3, 4], [5, 0], [6, 2], [4, 5]]},
    "periodic": {"degree": 3, "knots": [0, 1, 2, 3, 4.5], "points": [[0, 0], [2, 0], [2, 2], [0.1, 2]], "periodic": True},
    "periodic with weights": {"degree": 2, "knots": [0, 1, 2, 3.5], "points": [[0, 0], [2, 0], [1, 2]],
                              "weights": [1, 2, 3], "periodic": True},
    "full multiplicity": {"degree": 2, "knots": clamped(2, [0.5, 0.5]), "points": [[0, 0], [1, 1], [2, 0], [3, -1], [4, 0]]},
    "degree 25": {"degree": 25, "knots": clamped(25), "points": [[i, i * 7 % 5] for i in range(26)]},
    "far away": {"degree": 3, "knots": clamped(3), "points": [[1e6, 1e6], [1e6 + 1, 1e6 + 2], [1e6 + 3, 1e6], [1e6 + 4, 1e6]]},
    "huge": {"degree": 3, "knots": clamped(3), "points": [[0, 0], [1e200, 2e200], [3e200, 2e200], [4e200, 0]]},
    "tiny": {"degree": 3, "knots": clamped(3), "points": [[-0.0, 0], [1e-300, 2e-300], [3e-300, 2e-300], [4e-300, -0.0]]},
    "two\nlines % \\ */ ?? 'quoted' # ü": {"degree": 2, "knots": clamped(2), "points": [[0, 0], [1, 1], [2, 0]]},
}


def python_with_scipy():
    """An interpreter that has SciPy: this one or that of the system."""
    for python in (sys.executable, "/usr/bin/python3"):
        if shutil.which(python) and subprocess.run([python, "-c", "import scipy"], capture_output=True, check=False).returncode == 0:
            return python
    return None


class Code(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.file = self.folder / "in.json"

    def each(self, check):
        for number, (name, members) in enumerate(CURVES.items()):
            with self.subTest(name):
                write_document(self.file, {"name": name, **members})
                check(number, members)

    def code(self, language, *options):
        process = run("code", self.file, "--as", language, *options)
        self.assertEqual(process.returncode, 0, process.stderr)
        return process.stdout

    def evaluated(self):
        """Parameters of the whole domain and the points there."""
        lower, upper = answer("info", self.file)["curves"][0]["domain"]
        parameters = [lower + (upper - lower) * k / (PARAMETERS - 1) for k in range(PARAMETERS)]
        rows = answer("eval", self.file, *(word for u in parameters for word in ("--at", repr(u))))
        return parameters, [row["point"] for row in rows]

    def check_points(self, found, expected, members, relative=1e-12):
        size = max(abs(value) for point in members["points"] for value in point)
        for a, b in zip(found, expected, strict=True):
            for x, y in zip(a, b, strict=True):
                self.assertLessEqual(abs(x - y), relative * size)

    def test_python_draws_the_curve(self):
        python = python_with_scipy()
        if python is None:
            self.skipTest("Python has no SciPy here")

        def check(_, members):
            parameters, points = self.evaluated()
            text = self.code("python") + f"""
import json
print(json.dumps([points.tolist(), [curve(u).tolist() for u in {parameters}]]))
"""
            process = subprocess.run([python, "-c", text], capture_output=True, text=True, check=True)
            control_points, found = json.loads(process.stdout)
            self.assertEqual(bits(value for point in control_points[: len(members["points"])] for value in point),
                             bits(float(value) for point in members["points"] for value in point))
            self.check_points(found, points, members, relative=1e-11)

        self.each(check)

    def test_cpp_draws_the_curve(self):
        compiler = shutil.which("c++")
        if compiler is None:
            self.skipTest("there is no compiler called c++")
        source, program = self.folder / "main.cpp", self.folder / "main"
        expected, main, text = [], [], "#include <cstdio>\n"

        def check(number, members):
            nonlocal text
            parameters, points = self.evaluated()
            expected.append((members, points))
            code = self.code("cpp")
            text += re.sub(r"#include <(\w+)>\n", "", f"namespace n{number} {{\n{code}}}\n")
            main.extend(f"print(n{number}::point_at({u!r}));" for u in parameters)

        self.each(check)
        print_point = 'void print(std::array<double, 2> p) { std::printf("%.17g %.17g\\n", p[0], p[1]); }\n'
        source.write_text("#include <array>\n#include <cstddef>\n" + text + print_point +
                          "int main() {\n" + "\n".join(main) + "\n}\n")
        subprocess.run([compiler, "-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror", source, "-o",
                        program], check=True)
        printed = subprocess.run([program], check=True, capture_output=True, text=True).stdout.split("\n")
        for members, points in expected:
            found = [[float(word) for word in printed.pop(0).split()] for _ in points]
            self.check_points(found, points, members, relative=1e-11)

    def test_matlab_has_the_same_numbers(self):
        def check(_, members):
            text = self.code("matlab")
            data = text[text.index("\nknots"):].replace(" ...\n", "")
            lists = {name: re.findall(r"[-+.\de]+", values) for name, values in re.findall(r"(\w+) = \[(.*?)\];", data)}
            count = len(members["points"])
            if not members.get("periodic"):
                self.assertEqual(bits(map(float, lists["knots"])), bits(map(float, members["knots"])))
            x = list(map(float, lists["points"]))
            self.assertEqual(bits(x[:count]), bits(float(point[0]) for point in members["points"]))
            rows = len(x) // 2
            self.assertEqual(bits(x[rows:rows + count]), bits(float(point[1]) for point in members["points"]))
            self.assertEqual(rows + members["degree"] + 1, len(lists["knots"]))
            self.assertEqual("weights" in lists, "weights" in members)
            self.assertIn("rsmak" if "weights" in members else "spmak", text)

        self.each(check)

    def test_svg_path_is_on_the_curve(self):
        def check(_, members):
            words = self.code("svg-path").split()
            size = max(abs(value) for point in members["points"] for value in point)
            pieces, here = [], None
            while words:
                letter = words.pop(0)
                if letter == "Z":
                    self.assertEqual(words, [])
                    break
                count = {"M": 1, "L": 1, "Q": 2, "C": 3}[letter]
                points = [(float(words.pop(0)), -float(words.pop(0))) for _ in range(count)]
                if letter != "M":
                    pieces.append([here, *points])
                here = points[-1]
            _, expected = self.evaluated()
            drawn = [bezier(piece, k / 64) for piece in pieces for k in range(65)]
            for point in expected:
                nearest = min(range(len(drawn)), key=lambda k: math.dist(drawn[k], point))
                piece, t = pieces[nearest // 65], (nearest % 65) / 64
                for step in (1 / 64 / 4 ** k for k in range(1, 16)):
                    places = [min(max(t + j * step, 0.0), 1.0) for j in range(-4, 5)]
                    t = min(places, key=lambda place: math.dist(bezier(piece, place), point))
                self.assertLessEqual(math.dist(bezier(piece, t), point), 1e-5 * size + 1e-12 * size)

        self.each(check)

    def test_svg_path_of_a_cubic_has_its_points(self):
        write_document(self.file, CURVES["cubic"])
        self.assertEqual(self.code("svg-path"), "M 0 0 C 1 -2 3 -2 4 0\n")
        write_document(self.file, CURVES["unclamped quadratic"])
        self.assertEqual(self.code("svg-path"), "M 1 0 Q 2 0 2 -1 Q 2 -2 4 -2\n")
        write_document(self.file, {**CURVES["line"], "points": [[0, 0], [1, 2], [0, 0]]})
        self.assertEqual(self.code("svg-path"), "M 0 0 L 1 -2 L 0 0 Z\n")

    def test_what_is_closed_is_closed_in_drawings(self):
        w = math.sqrt(0.5)
        write_document(self.file, {"degree": 2, "knots": [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4], "weights": [1, w, 1, w, 1, w, 1, w, 1],
                                   "points": [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1], [1, 0]]})
        text = self.code("svg-path")
        self.assertEqual(text, "M 1 0 A 1 1 0 0 0 0 -1 A 1 1 0 0 0 -1 0 A 1 1 0 0 0 0 1 A 1 1 0 0 0 1 0 Z\n")
        self.assertIn(f' d="{text.strip()}"', run("convert", self.file, "--to", "svg", "-o", "-").stdout)
        self.assertTrue(self.code("tikz").endswith(".. cycle;\n"))
        # Its last point is rounded otherwise than its first one.
        write_document(self.file, {"degree": 3, "knots": [0, 1, 2, 3, 4], "periodic": True,
                                   "points": [[1, 0], [2.5, 1], [1, 2], [-1, 1.1]]})
        for language, end in (("svg-path", " Z\n"), ("tikz", ".. cycle;\n")):
            self.assertTrue(self.code(language).endswith(end))

    def test_json_is_the_curve(self):
        def check(_, members):
            process = run("code", self.file, "--as", "json")
            copy = json.loads(process.stdout)["curves"][0]
            self.assertEqual(copy["name"], json.loads(self.file.read_text())["curves"][0]["name"])
            for member in ("degree", "knots", "points"):
                self.assertEqual(copy[member], members[member])

        self.each(check)

    def test_tikz_of_a_cubic_has_its_points(self):
        write_document(self.file, {"name": "wave", **CURVES["cubic"]})
        self.assertEqual(self.code("tikz"),
                         "% 'wave': a B-spline curve of degree 3 over [0, 1]\n"
                         "\\draw (0,0)\n  .. controls (1,2) and (3,2) .. (4,0);\n")

    def test_latex_has_small_fractions(self):
        write_document(self.file, {"name": "l", **CURVES["line"]})
        text = self.code("latex")
        self.assertIn("  1 & \\tfrac{1}{6} & 2 \\\\\n  2 & -\\tfrac{4}{3} & 0.1 \\\\\n", text)
        self.assertIn("$p = 1$, $U = (0,\\allowbreak 0,\\allowbreak \\tfrac{1}{3},\\allowbreak 1,\\allowbreak 1)$", text)
        write_document(self.file, {"name": "t", **CURVES["tiny"]})
        self.assertIn("  3 & 4 \\cdot 10^{-300} & 0 \\\\\n", self.code("latex"), "a paper has one zero")

    def test_tex_compiles_both(self):
        if shutil.which("pdflatex") is None:
            self.skipTest("there is no pdflatex here")
        body = ""

        def check(_, __):
            nonlocal body
            body += self.code("latex") + "\n\\begin{tikzpicture}\n" + self.code("tikz") + "\\end{tikzpicture}\n\\clearpage\n"

        self.each(check)
        (self.folder / "t.tex").write_text("\\documentclass{article}\\usepackage{amsmath,tikz}\\begin{document}\n" + body +
                                           "\\end{document}\n")
        process = subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "t.tex"], cwd=self.folder,
                                 capture_output=True, text=True, check=False, timeout=120)
        self.assertEqual(process.returncode, 0, process.stdout[-2000:])

    def test_all_of_a_long_table_is_on_the_pages(self):
        for program in ("pdflatex", "pdftotext"):
            if shutil.which(program) is None:
                self.skipTest(f"there is no {program} here")
        count = 200
        write_document(self.file, {"degree": 3, "knots": list(range(count + 4)), "weights": [1 + i % 2 for i in range(count)],
                                   "points": [[i, -i / 7 if i >= 100 else -i] for i in range(count)]})
        for letters in ("10pt", "12pt"):
            (self.folder / "t.tex").write_text(f"\\documentclass[{letters}]{{article}}\\usepackage{{amsmath}}\\begin{{document}}\n" + self.code("latex") +
                                               "\\end{document}\n")
            process = subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "t.tex"], cwd=self.folder,
                                     capture_output=True, text=True, check=False, timeout=120)
            self.assertEqual(process.returncode, 0, process.stdout[-2000:])
            self.assertNotIn("Overfull", process.stdout)
            self.assertLessEqual(int(re.search(r"\((\d+) pages", process.stdout).group(1)), 8, "two of the fifteen tables on a page, and the knots")
            shown = subprocess.run(["pdftotext", "-layout", "t.pdf", "-"], cwd=self.folder, capture_output=True, text=True, check=True).stdout
            indices = {int(line.split()[0]) for line in shown.splitlines() if line.split()[:1] and line.split()[0].isdigit() and len(line.split()) > 2}
            self.assertLessEqual(set(range(100)), indices, "whose lines have no fractions")

    def test_ten_thousand_points_take_no_time(self):
        count = 10000
        write_document(self.file, {"degree": 3, "knots": list(range(count + 4)),
                                   "points": [[i * 0.01, math.sin(i * 0.05)] for i in range(count)],
                                   "weights": [1 + i % 3 * 0.5 for i in range(count)]})
        for language in ("json", "latex", "tikz", "svg-path", "cpp", "python", "matlab"):
            start = time.monotonic()
            self.code(language)
            self.assertLess(time.monotonic() - start, 30)

    def test_a_curve_is_chosen_by_name(self):
        write_document(self.file, {"name": "a", **CURVES["cubic"]}, {"name": "b", **CURVES["unclamped quadratic"]})
        self.assertIn("'b'", self.code("python", "--curve", "b"))
        self.assertIn("'a'", self.code("python", "--curve", "0"))

    def test_what_is_wrong_is_told(self):
        write_document(self.file, CURVES["cubic"])
        self.assertEqual(run("code", self.file, "--as", "fortran").returncode, 2)
        self.assertEqual(run("code", self.file).returncode, 2)
        self.assertEqual(run("code", self.folder / "absent.json", "--as", "cpp").returncode, 1)
        self.assertEqual(run("code", self.file, "--as", "cpp", "--curve", "z").returncode, 1)
        write_document(self.file, {"name": "w", "degree": 4, "knots": clamped(4), "points": [[0, 0], [1, 1], [2, 0], [3, 1], [4, 0]],
                                   "weights": [1e-300, 1, 1e300, 1, 1e-300]})
        process = run("code", self.file, "--as", "tikz")
        self.assertIn(process.returncode, (0, 1))
        self.assertEqual("nan" in process.stdout or "inf" in process.stdout, False)


if __name__ == "__main__":
    unittest.main()
