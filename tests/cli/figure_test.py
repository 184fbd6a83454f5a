"""Figures: what is on them and where, in every format; animations; what is refused; and every command of docs/figures.md."""

import json
import math
import os
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree
import zlib

from program import BINARY, run

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "assets" / "examples"
WAVE = EXAMPLES / "wave.json"
SVG = "{http://www.w3.org/2000/svg}"


def pixels(png):
    """Width, height and rows of (r, g, b, a) of a PNG of 8 bits."""
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
    data, at = b"", 8
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at : at + 8])
        body = png[at + 8 : at + 8 + length]
        at += 12 + length
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            data += body
    step = {2: 3, 6: 4}[color]
    assert depth == 8
    raw, rows, above = zlib.decompress(data), [], bytes(width * step)
    for y in range(height):
        kind, line = raw[y * (width * step + 1)], bytearray(raw[y * (width * step + 1) + 1 : (y + 1) * (width * step + 1)])
        for i in range(len(line)):
            left, upper, corner = line[i - step] if i >= step else 0, above[i], above[i - step] if i >= step else 0
            paeth = min((abs(upper - corner), 0, left), (abs(left - corner), 1, upper), (abs(left + upper - 2 * corner), 2, corner))[2]
            line[i] = (line[i] + (0, left, upper, (left + upper) // 2, paeth)[kind]) % 256
        above = bytes(line)
        rows.append([tuple(line[i : i + step]) + (255,) * (4 - step) for i in range(0, len(line), step)])
    return width, height, rows


def places_in(path):
    numbers = [float(n) for n in re.findall(r"-?[0-9.]+", path.get("d"))]
    return list(zip(numbers[::2], numbers[1::2]))


class Picture:
    """An SVG figure."""

    def __init__(self, file):
        self.root = xml.etree.ElementTree.parse(file).getroot()
        self.texts = ["".join(text.itertext()) for text in self.root.iter(SVG + "text")]
        self.lines = [path for path in self.root.iter(SVG + "path") if path.get("stroke-linejoin")]
        self.circles = list(self.root.iter(SVG + "circle"))

    def polygon(self):
        """The dashed line, of 6 and 5 pixels."""
        return places_in(next(line for line in self.lines if line.get("stroke-dasharray") == "6 5"))

    def circles_of(self, radius):
        return [(float(c.get("cx")), float(c.get("cy"))) for c in self.circles if float(c.get("r")) == radius]


    def places_of_circles(self):
        return [(c.get("cx"), c.get("cy"), c.get("r")) for c in self.circles]


def between(places):
    """Places a pixel or less from one another on the line through these."""
    for (a, b), (c, d) in zip(places, places[1:]):
        steps = int(max(abs(c - a), abs(d - b))) + 1
        yield from ((a + (c - a) * k / steps, b + (d - b) * k / steps) for k in range(steps))


def diamonds(picture):
    """The marks of the knots on the curve."""
    corners = (places_in(path) for path in picture.root.iter(SVG + "path") if path.get("d").endswith("Z") and path.get("fill") != "none")
    return [four for four in corners if len(four) == 4 and four[0][1] == four[2][1] and four[1][0] == four[3][0]]


class FigureTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def figure(self, name, *options, file=WAVE, told=""):
        output = self.folder / name
        process = run("figure", file, "-o", output, *options)
        self.assertEqual((process.returncode, process.stdout), (0, ""), options)
        if told is not None:
            self.assertEqual(process.stderr.replace(f"{output}: ", ""), told, options)
        return output

    def example(self, name):
        return EXAMPLES / f"{name}.json"

    def document(self, **members):
        """The wave with other members."""
        file = self.folder / "document.json"
        file.write_text(json.dumps({**json.loads(WAVE.read_text()), **members}))
        return file

    def refused(self, status, sentence, *options, file=WAVE, output="x.svg"):
        process = run("figure", file, "-o", output if output == "-" else self.folder / output, *options)
        self.assertEqual((process.returncode, process.stdout), (status, ""), options)
        self.assertIn(sentence, process.stderr)
        self.assertEqual(process.stderr.count("\n"), 1)
        self.assertEqual(list(self.folder.iterdir()), [])

    def needs(self, *programs):
        for program in programs:
            if shutil.which(program) is None:
                self.skipTest(f"{program} is not installed; scripts/setup figures installs it")


class Svg(FigureTest):
    def test_points_are_where_one_camera_shows_them(self):
        picture = Picture(self.figure("a.svg", "--show", "polygon,points", "--at", "2/5", "--size", "640x400"))
        self.assertEqual((picture.root.get("width"), picture.root.get("height")), ("640", "400"))
        points = json.loads(WAVE.read_text())["curves"][0]["points"]
        shown = picture.polygon()
        self.assertEqual(len(shown), len(points))
        # x' = s x + a, y' = -s y + b for all of them, with one s.
        s = (shown[-1][0] - shown[0][0]) / (points[-1][0] - points[0][0])
        a, b = shown[0][0] - s * points[0][0], shown[0][1] + s * points[0][1]
        for (x, y), place in zip(points, shown):
            self.assertAlmostEqual(place[0], s * x + a, delta=0.02)
            self.assertAlmostEqual(place[1], b - s * y, delta=0.02)
        # As large as it fits: the margin is the same left and right, or above and below, and nowhere less.
        left, right = min(x for x, _ in shown), 640 - max(x for x, _ in shown)
        above, below = min(y for _, y in shown), 400 - max(y for _, y in shown)
        self.assertTrue(abs(left - right) < 0.1 and abs(above - below) < 0.1)
        self.assertAlmostEqual(min(left, above), 56.0, delta=0.1)
        # The discs of the control points, and that of C(0.4), which `eval` tells.
        self.assertEqual([(round(x, 1), round(y, 1)) for x, y in sorted(picture.circles_of(6.5))], [(round(x, 1), round(y, 1)) for x, y in sorted(shown)])
        x, y = (float(n) for n in run("eval", WAVE, "--at", "0.4").stdout.split()[1:3])
        ((shown_x, shown_y),) = picture.circles_of(8.0)
        self.assertAlmostEqual(shown_x, s * x + a, delta=0.02)
        self.assertAlmostEqual(shown_y, b - s * y, delta=0.02)

    def test_shows_what_was_asked_for_and_nothing_else(self):
        bare = Picture(self.figure("a.svg", "--show", ""))
        self.assertEqual((len(bare.lines), bare.circles, bare.texts), (1, [], []))
        points = Picture(self.figure("a.svg", "--show", "points"))
        self.assertEqual((len(points.lines), len(points.circles_of(6.5)), points.texts), (1, 7, []))
        polygon = Picture(self.figure("a.svg", "--show", "polygon"))
        self.assertEqual((len(polygon.lines), polygon.circles, polygon.texts), (2, [], []))
        usual = Picture(self.figure("a.svg"))
        self.assertEqual((len(usual.lines), len(usual.circles_of(6.5))), (2, 7))
        self.assertEqual(sorted(usual.texts), ["P0", "P1", "P2", "P3", "P4", "P5", "P6", "· w 2"])
        legend = Picture(self.figure("a.svg", "--show", "deboor,legend"))
        self.assertIn("de Boor", legend.texts)
        self.assertNotIn("de Boor", Picture(self.figure("a.svg", "--show", "deboor")).texts)
        self.assertEqual(self.figure("a.svg", "--show", " points , deboor").read_bytes(), self.figure("b.svg", "--show", "points,construction").read_bytes())

    def test_labels_are_text_with_indices(self):
        root = Picture(self.figure("a.svg")).root
        first = next(text for text in root.iter(SVG + "text") if "".join(text.itertext()) == "P0")
        (index,) = first
        self.assertEqual((first.text, index.tag, index.text), ("P", SVG + "tspan", "0"))
        self.assertGreater(float(index.get("dy")), 0.0, "below the line")
        self.assertLess(float(index.get("font-size")), float(first.get("font-size")))

    def test_views(self):
        both = Picture(self.figure("a.svg", "--view", "both"))
        boxes = [[float(part.get(n)) for n in ("x", "y", "width", "height")] for part in both.root.findall(SVG + "svg")]
        self.assertEqual(boxes, [[0, 0, 800, 270], [0, 270, 800, 180]])
        self.assertIn("Basis functions Ni,3(u)", both.texts)
        self.assertEqual(both.texts.count("P0"), 1)
        basis = Picture(self.figure("a.svg", "--view", "basis"))
        self.assertIn("×4 clamped", basis.texts)
        self.assertNotIn("P0", basis.texts)
        self.assertFalse([text for text in basis.texts if text.startswith("u =")], "no parameter was asked for")
        self.assertIn("u = 0.400", Picture(self.figure("a.svg", "--view", "basis", "--at", "0.4")).texts)
        self.assertEqual(self.figure("a.svg", "--show", "basis").read_bytes(), self.figure("b.svg", "--show", "", "--view", "both").read_bytes())
        self.assertEqual(Picture(self.figure("a.svg", "--show", "basis-values")).root.get("height"), "450")
        self.assertEqual(len(Picture(self.figure("a.svg", "--show", "basis-values")).root.findall(SVG + "svg")), 2, "where it is seen")

    def test_the_lifted_view_shows_what_was_asked_for(self):
        circle = self.example("circle-nurbs")
        options = ("--view", "homogeneous", "--size", "600x500")
        bare = Picture(self.figure("a.svg", *options, "--show", "", file=circle))
        self.assertEqual((sorted(bare.texts), bare.circles_of(6.0)), (["O", "w = 1"], []))
        points = Picture(self.figure("a.svg", *options, "--show", "points", file=circle))
        self.assertEqual((len(points.circles_of(6.0)), len(points.circles_of(3.0))), (9, 9), "lifted and on the plane")
        usual = Picture(self.figure("a.svg", *options, file=circle))
        self.assertEqual(sorted(usual.texts), ["O"] + [f"P{i}" for i in range(9)] + ["w = 1"])
        dashed = lambda picture: sum(line.get("stroke-dasharray") is not None for line in picture.lines)
        self.assertEqual(dashed(points), 0)
        self.assertGreater(dashed(Picture(self.figure("a.svg", *options, "--show", "polygon", file=circle))), 1)

    def test_labels_have_a_place_or_are_told(self):
        file = self.folder / "a.svg"
        for size in ("300x200", "200x150", "120x80", "60x40"):
            process = run("figure", self.example("circle-nurbs"), "-o", file, "--size", size, "--show", "polygon,points,labels,knots")
            texts = Picture(file).texts
            told = [name[0] + str("₀₁₂₃₄₅₆₇₈₉".index(name[1])) for name in re.findall(r"[Pw][₀-₉]", process.stderr)]
            if "among them" not in process.stderr:
                for name in [f"P{i}" for i in range(9)]:
                    self.assertEqual(name in texts, name not in told, (size, name, process.stderr))
            if size in ("300x200", "200x150"):
                weights = sum(text.startswith("· w") for text in texts)
                self.assertEqual(weights + sum(name.startswith("w") for name in told), 4, "of four corners")
            if size == "300x200":
                self.assertEqual([name for name in told if name.startswith("P")], [])

    def test_labels_find_room_where_there_is_some(self):
        self.figure("a.svg", "--show", "polygon,points,labels,blossoms", "--at", "0.4", "--size", "640x360", file=self.example("cubic-de-boor"))
        self.figure("b.svg", "--show", "end-vertices,polygon,points,labels", "--size", "640x360", file=self.example("coons-open"))

    def test_names_stand_nearest_to_their_points(self):
        """Of a crowded polygon: what would be read as the name of another point is left out, and told."""
        points = [[math.cos(0.7 * i) * (3 + i % 3), math.sin(1.1 * i) * 2] for i in range(40)]
        curve = {"degree": 3, "knots": [0, 0, 0, *range(38), 37, 37, 37], "points": points}
        output = self.figure("a.svg", "--show", "points,labels", "--size", "500x300", file=self.document(curves=[curve]), told=None)
        picture = Picture(output)
        places = picture.circles_of(6.5)
        self.assertEqual(len(places), 40)
        named = 0
        for text in picture.root.iter(SVG + "text"):
            name = "".join(text.itertext())
            width, height = 8.0 + 5.5 * (len(name) - 1), 13.0
            x, y = float(text.get("x")), float(text.get("y")) - 0.36 * 13.0
            left = {"middle": x - 0.5 * width, "end": x - width}.get(text.get("text-anchor"), x)
            distances = [math.dist((px, py), (min(max(px, left), left + width), min(max(py, y - 0.5 * height), y + 0.5 * height))) for px, py in places]
            named += 1
            nearest, own = distances.index(min(distances)), int(name[1:])
            self.assertTrue(nearest == own or math.dist(places[nearest], places[own]) < 8.0, f"{name} is nearest to {nearest}")
        self.assertGreater(named, 8)

    def test_an_arrow_tells_the_direction(self):
        bare, arrow = (Picture(self.figure("a.svg", "--show", show)) for show in ("", "arrow"))
        self.assertEqual(len(arrow.lines) - len(bare.lines), 1)
        (back, tip, _) = places_in(arrow.lines[-1])
        (other,) = places_in(arrow.lines[-1])[2:]
        self.assertGreater(tip[0], (back[0] + other[0]) / 2, "the wave runs to the right")

    def test_numbers_of_the_axes(self):
        grid, rulers = (sorted(Picture(self.figure("a.svg", "--show", show)).texts) for show in ("grid", "rulers"))
        self.assertEqual(grid, sorted(["4", "2", "0", "−2", "−6", "−4", "−2", "0", "2", "4", "6", "8"]))
        self.assertEqual(grid, rulers)

    def test_pictures_and_guides_are_shown_where_they_are_asked_for(self):
        picture = self.folder / "ring.png"
        shutil.copy(ROOT / "tests" / "data" / "pictures" / "ring_gray.png", picture)
        document = self.document(
            pictures=[{"path": "ring.png", "width": 64, "height": 64, "position": [-3, -2], "scale": 0.0625, "rotation": 0, "opacity": 1, "visible": True, "locked": False}],
            guides=[{"point": [0, 1], "angle": 0}],
        )
        bare = Picture(self.figure("a.svg", file=document))
        both = Picture(self.figure("b.svg", "--show", "polygon,points,labels,pictures,guides", file=document))
        self.assertEqual(list(bare.root.iter(SVG + "image")), [])
        (image,) = both.root.iter(SVG + "image")
        (a, b, c, d, e, f) = (float(n) for n in re.findall(r"-?[0-9.e-]+", image.get("transform")))
        shown, points = both.polygon(), json.loads(WAVE.read_text())["curves"][0]["points"]
        s = (shown[-1][0] - shown[0][0]) / (points[-1][0] - points[0][0])
        # From (-3, 2), its upper left corner, on; a pixel is a sixteenth of a unit.
        for found, expected in zip((a, b, c, d, e, f), (s / 16, 0, 0, s / 16, shown[0][0] + s * (-3 - points[0][0]), shown[0][1] - s * (2 - points[0][1]))):
            self.assertAlmostEqual(found, expected, delta=0.02)
        (guide,) = [line for line in both.lines if line.get("stroke-dasharray") == "12 4"]
        self.assertAlmostEqual(places_in(guide)[0][1], shown[0][1] - s * (1 - points[0][1]), delta=0.02)
        width, height, rows = pixels(self.figure("c.png", "--show", "pictures", "--transparent", "--size", "640x640", file=document).read_bytes())
        self.assertGreater(sum(pixel[3] == 255 for row in rows for pixel in row), 10000, "it is opaque")
        self.figure("d.tex", "--show", "pictures", file=document, told="TikZ has no images, so the pictures are left out\n")

    def test_a_comb_is_on_the_page(self):
        for example in ("wave", "circle-nurbs", "bezier-cubic", "quadratic-double-knot", "knots-t4"):
            bare = Picture(self.figure("a.svg", "--show", "", file=self.example(example)))
            picture = Picture(self.figure("a.svg", "--show", "comb", file=self.example(example)))
            places = [place for line in picture.lines for place in places_in(line)]
            self.assertTrue(all(0 <= x <= 800 and 0 <= y <= 450 for x, y in places), example)
            extent = lambda drawn, axis: max(p[axis] for p in places_in(drawn)) - min(p[axis] for p in places_in(drawn))
            curves = [max(p.lines, key=lambda line: float(line.get("stroke-width"))) for p in (bare, picture)]
            self.assertGreater(extent(curves[1], 0), 0.4 * extent(curves[0], 0), example)

    def test_any_size_of_coordinates_looks_the_same(self):
        wave = json.loads(WAVE.read_text())["curves"][0]
        for power in (996, -500):
            scaled = {**wave, "points": [[x * 2.0**power, y * 2.0**power] for x, y in wave["points"]]}
            file = self.document(curves=[scaled], active=0)
            for (x, y), (a, b) in zip(Picture(self.figure("a.svg", file=file)).polygon(), Picture(self.figure("b.svg")).polygon()):
                self.assertAlmostEqual(x, a, delta=0.02)
                self.assertAlmostEqual(y, b, delta=0.02)
            process = run("figure", file, "-o", self.folder / "a.svg", "--show", "grid")
            self.assertIn(f"the curve is drawn 2^{-2 - power} times as large as it is", process.stderr)

    def test_a_curve_far_from_the_origin_looks_the_same(self):
        wave = json.loads(WAVE.read_text())["curves"][0]
        # Multiples of 1/4, which is the step of numbers from 2^50 on.
        wave = {**wave, "points": [[round(4 * x) / 4, round(4 * y) / 4] for x, y in wave["points"]]}
        expected = Picture(self.figure("b.svg", file=self.document(curves=[wave], active=0)))
        for x_power, y_power in ((50, 49), (50, None), (None, -50)):
            right, up = (math.copysign(2.0 ** abs(power), power) if power else 0.0 for power in (x_power, y_power))
            moved = {**wave, "points": [[x + right, y + up] for x, y in wave["points"]]}
            file = self.document(curves=[moved], active=0)
            found = Picture(self.figure("a.svg", file=file))
            for line, wanted in zip(found.lines, expected.lines, strict=True):
                for (x, y), (a, b) in zip(places_in(line), places_in(wanted), strict=True):
                    self.assertAlmostEqual(x, a, delta=0.02)
                    self.assertAlmostEqual(y, b, delta=0.02)
            process = run("figure", file, "-o", self.folder / "a.svg", "--show", "grid")
            self.assertIn("places on the figure are those of the drawn one", process.stderr)
            ((x, y),) = re.findall(r"the curve is drawn moved by \((.*), (.*)\), and", process.stderr)
            for place, distance in ((right, float(x)), (up, float(y))):
                self.assertLess(abs(place + distance), 8, "the curve comes to the origin")

    def test_the_longest_domain_has_a_place_for_every_value(self):
        file = self.folder / "long.json"
        self.assertEqual(run("new", "new-curve", "0,0,1,2,3,1,4,4", 3, "reparametrize", 1, "1.7e308", "-o", file).returncode, 0)
        for shown in ("basis", "speed-plot", "curvature-plot", "polygon,points,labels,knots,deboor"):
            figure = self.figure("long.svg", "--show", shown, "--view", "both", file=file, told=None)
            self.assertNotIn("nan", figure.read_text())
            self.assertNotIn("inf", figure.read_text())

    def test_titles_are_text_whatever_they_say(self):
        title = "a < b & \"c\" Кривая \\end{x} 50%"
        picture = Picture(self.figure("a.svg", "--title", title))
        self.assertEqual(picture.root.find(SVG + "title").text, title)
        self.assertIn(title, picture.texts)

    def test_formulas_of_titles_are_set(self):
        title = "From $\\alpha_i \\le \\frac{1}{6}$ to $\\sqrt{2}\\in\\mathbb{R}$"
        picture = Picture(self.figure("a.svg", "--title", title))
        self.assertIn("From αi ≤ ⅙ to √2 ∈ ℝ", picture.texts)
        self.assertIn(title, self.figure("a.tex", "--title", title).read_text())
        told = "\\vec stands in the title as it was typed: these figures set Greek letters, signs such as \\le or \\int, \\frac, \\sqrt, \\mathbb and \\text; LaTeX sets all commands of a TikZ figure\n"
        for name in ("a.svg", "a.png", "a.pdf"):
            self.figure(name, "--title", "$\\vec{a}$", told=told)
        self.figure("a.tex", "--title", "$\\vec{a}$")

    def test_long_titles_are_broken_into_lines_that_can_be_read(self):
        title = " ".join(["A knot comes in and cuts the corners of the polygon while the curve stays"] * 3)[:200]
        picture = Picture(self.figure("a.svg", "--title", title, "--size", "400x300"))
        lines = [text for text in picture.root.iter(SVG + "text") if text.get("font-weight") == "bold"]
        self.assertEqual(" ".join("".join(line.itertext()) for line in lines), title.strip())
        self.assertGreaterEqual(min(float(line.get("font-size")) for line in lines), 9.0)
        self.assertEqual(len({line.get("y") for line in lines}), len(lines))
        points = picture.circles_of(6.5)
        self.assertGreater(min(y for _, y in points), 18.0, "the picture below has its own box")

    def test_line_breaks_of_titles(self):
        self.assertLess({"two", "lines"}, set(Picture(self.figure("a.svg", "--title", "two\nlines")).texts))
        text = self.figure("a.tex", "--title", "two\n\nlines").read_text()
        self.assertIn("{{\\bfseries\\boldmath two}};", text)
        self.assertIn("{{\\bfseries\\boldmath lines}};", text)

    def test_titles_without_room_are_told(self):
        picture = Picture(self.figure("a.svg", "--title", "word " * 500, "--show", "polygon", told="there was no room for the title; a larger figure or a shorter title has it\n"))
        self.assertEqual(picture.texts, [])

    def test_themes(self):
        grounds = {theme: Picture(self.figure("a.svg", "--theme", theme)).root.find(f".//{SVG}rect").get("fill") for theme in ("light", "dark", "high-contrast")}
        self.assertEqual(len(set(grounds.values())), 3)
        self.assertEqual(grounds["high-contrast"], "#ffffff")
        self.assertIsNone(Picture(self.figure("a.svg", "--transparent")).root.find(f".//{SVG}rect"))

    def test_every_overlay_of_every_example_is_a_picture(self):
        (listed,) = re.findall(r"\): (points, .*)\n", run("figure", "--help").stdout)
        names = [name for name in re.findall(r"[a-z-]+", listed) if name != "or"]
        self.assertGreater(len(names), 45)
        for word in ("arrow", "guides", "pictures", "rulers"):
            self.assertIn(word, names)
        for word in ("quiz", "recurrence", "support"):
            self.assertNotIn(word, names)
        for example in sorted(EXAMPLES.glob("*.json")):
            file = self.figure("a.svg", "--show", ",".join(names), "--at", "0.5", "--view", "both", file=example, told=None)
            text = file.read_text()
            self.assertIsNone(re.search(r"nan|inf", re.sub(r"<text.*</text>", "", text)), example.name)
            Picture(file)

    def test_a_hundred_thousand_points_make_a_small_file(self):
        x = 1
        points = []
        for _ in range(100_000):
            x = x * 6364136223846793005 % 2**64
            points.append(f"{x >> 40} {x >> 16 & 0xFFFFFF}")
        table = self.folder / "points.txt"
        table.write_text("\n".join(points))
        document = self.folder / "dense.json"
        process = run("new", "new-curve", f"@{table}", "3", "-o", document)
        self.assertEqual(process.returncode, 0, process.stderr)
        told = "Showing 529 of 100000 points\nthere was no room for 1000 labels or more, among them P₁, P₂, P₃, P₄, P₅, P₆, P₇, P₈; a larger figure may have it\n"
        self.assertLess(self.figure("a.svg", file=document, told=told).stat().st_size, 1_000_000)

    def test_how_many_of_many_marks_are_drawn_is_told(self):
        n = 10_000
        knots = [0, 0, 0, *range(n - 2), n - 3, n - 3, n - 3]
        file = self.document(curves=[{"name": "many", "degree": 3, "knots": knots, "points": [[i, i % 2] for i in range(n)]}], active=0)
        process = run("figure", file, "-o", self.folder / "a.svg", "--show", "points")
        told = re.fullmatch(r".*: Showing (\d+) of 10000 points\n", process.stderr)
        self.assertTrue(told, process.stderr)
        self.assertEqual(int(told[1]), len(Picture(self.folder / "a.svg").circles_of(3)), "the ends are drawn over them once more")
        self.assertRegex(run("figure", file, "-o", self.folder / "b.svg", "--show", "comb").stderr, r": The comb has teeth at \d+ of 9997 spans\n")
        self.assertEqual(run("figure", file, "-o", self.folder / "c.svg", "--show", "polygon").stderr, "", "of which nothing is left out")

    def test_labels_of_small_figures_stay_off_the_curve(self):
        for example, at in (("wave", "0.4"), ("knots-t4", "2.5")):
            picture = Picture(self.figure("a.svg", "--show", "polygon,points,labels,knots,deboor", "--at", at, "--size", "300x200", file=self.example(example), told=None))
            curve = [place for line in picture.lines if float(line.get("stroke-width")) >= 3.0 for place in between(places_in(line))]
            self.assertGreater(len(curve), 100)
            (name,) = (text for text in picture.root.iter(SVG + "text") if "".join(text.itertext()).startswith("C("))
            x, y, size = (float(name.get(what)) for what in ("x", "y", "font-size"))
            width = 0.5 * size * len("".join(name.itertext()))
            left = x - width if name.get("text-anchor") == "end" else x
            for a, b in curve:
                self.assertFalse(left < a < left + width and y - 0.7 * size < b < y, f"{example}: the curve at {a}, {b}")

    def test_legends_cover_nothing(self):
        words = ("--show", "polygon,points,labels,deboor,legend", "--at", "0.4")
        for size in ("300x200", "800x450"):
            picture = Picture(self.figure("a.svg", *words, "--size", size, told=None))
            box = next(places_in(path) for path in picture.root.iter(SVG + "path") if path.get("d").endswith("Z") and len(places_in(path)) > 8)
            left, right, above, below = min(x for x, _ in box), max(x for x, _ in box), min(y for _, y in box), max(y for _, y in box)
            for x, y in picture.circles_of(6.5):
                self.assertFalse(left - 6.5 < x < right + 6.5 and above - 6.5 < y < below + 6.5, f"{size}: a point at {x}, {y}")
        self.figure("a.svg", *words, "--size", "300x120", told=None)
        process = run("figure", WAVE, "-o", self.folder / "a.svg", *words, "--size", "300x120")
        self.assertIn("there was no room for the legend; a larger figure may have it", process.stderr)

    def test_the_plane_of_the_lifted_curve_is_named_beside_the_points(self):
        picture = Picture(self.figure("a.svg", "--view", "homogeneous", "--size", "300x200", file=self.example("circle-nurbs"), told=None))
        places = {"".join(t.itertext()): (float(t.get("x")), float(t.get("y"))) for t in picture.root.iter(SVG + "text")}
        x, y = places.pop("w = 1")
        for name, (a, b) in places.items():
            self.assertTrue(abs(x - a) > 30 or abs(y - b) > 12, name)


class Pixels(FigureTest):
    def test_sizes_are_multiplied_by_the_scale(self):
        width, height, rows = pixels(self.figure("a.png", "--size", "200x100", "--scale", "2.5", "--show", "polygon").read_bytes())
        self.assertEqual((width, height, len(rows)), (500, 250, 250))
        self.assertEqual(rows[0][0], (251, 251, 253, 255), "the canvas of the light theme")

    def test_all_pixels_are_whole(self):
        width, height, rows = pixels(self.figure("a.png", "--size", "201x101", "--scale", "1.5", "--show", "polygon").read_bytes())
        self.assertEqual((width, height), (302, 152))
        self.assertEqual({rows[y][x] for x, y in ((301, 0), (301, 151), (0, 151))}, {(251, 251, 253, 255)})

    def test_grounds_can_be_left_out(self):
        width, height, rows = pixels(self.figure("a.png", "--size", "200x100", "--transparent", told=None).read_bytes())
        for x, y in ((0, 0), (width - 1, 0), (0, height - 1), (width - 1, height - 1)):
            self.assertEqual(rows[y][x][3], 0)
        self.assertTrue(any(pixel[3] == 255 for row in rows for pixel in row))

    def test_tiny_sizes_are_no_trouble(self):
        for view in ("curve", "homogeneous"):
            width, height, _ = pixels(self.figure("a.png", "--size", "1x1", "--view", view, "--title", "a", told=None).read_bytes())
            self.assertEqual((width, height), (1, 1))


class Papers(FigureTest):
    def test_plots_tell_of_the_parameter_where_it_is_asked_for(self):
        for parameter, count in (((), 0), (("--at", "0.5"), 1)):
            text = self.figure("a.svg", "--show", "speed-plot", *parameter, told=None).read_text()
            self.assertEqual((text.count("Speed |C′(u)|"), text.count("|C′| = ")), (1, count), parameter)

    def test_labels_of_a_pdf_can_be_found(self):
        self.needs("pdftotext")
        file = self.figure("a.pdf", "--title", "Ein Überblick")
        words = subprocess.run(["pdftotext", file, "-"], capture_output=True, text=True, check=True).stdout
        self.assertIn("Ein Überblick", words)
        self.assertEqual(sorted(set(re.findall(r"P\d", words))), [f"P{i}" for i in range(7)])

    def test_tikz_compiles(self):
        self.needs("pdflatex", "pdftotext")
        cases = [(example, "--show", "polygon,points,labels,knots,deboor,legend,comb,hull", "--at", "0.5", "--view", "both") for example in sorted(EXAMPLES.glob("*.json"))]
        cases.append((WAVE, "--title", "50% & $1 {x} \\end #_~^ <a> \"b\" Кривая ≤ é 1/6"))
        cases.append((WAVE, "--title", "A point $P_3$ on a curve-t3: ⅓ ⅔ x₁₂ ℝ ∫ 10⁻¹² C′² C²′ « § ⇒ Ψ η ½ | > a_b^c [1] {2}"))
        for number, (example, *options) in enumerate(cases):
            self.figure(f"{number}.tex", *options, file=example, told=None)
        pages = "\\newpage ".join(rf"\input{{{number}.tex}}" for number in range(len(cases)))
        (self.folder / "paper.tex").write_text(rf"\documentclass{{article}}\usepackage{{tikz}}\begin{{document}}{pages}\end{{document}}")
        process = subprocess.run(["pdflatex", "-interaction=batchmode", "-halt-on-error", "paper.tex"], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual(process.returncode, 0, (self.folder / "paper.log").read_text(errors="replace")[-2000:])
        words = subprocess.run(["pdftotext", self.folder / "paper.pdf", "-"], capture_output=True, text=True, check=True).stdout
        self.assertIn("50% & $1 {x}", words)
        self.assertIn("on a curve-t3", words)

    def test_a_dollar_is_a_letter_of_an_outline_font(self):
        self.needs("pdflatex", "pdffonts")
        self.figure("a.tex", "--show", "", "--title", "from $5 to $6")
        (self.folder / "paper.tex").write_text(r"\documentclass{article}\usepackage{tikz}\begin{document}\input{a.tex}\end{document}")
        process = subprocess.run(["pdflatex", "-interaction=batchmode", "paper.tex"], cwd=self.folder, capture_output=True, text=True, check=True)
        self.assertEqual(process.stderr, "", "a font is made")
        fonts = subprocess.run(["pdffonts", self.folder / "paper.pdf"], capture_output=True, text=True, check=True).stdout
        self.assertIn("Type 1", fonts)
        self.assertNotIn("Type 3", fonts)

    def test_what_LaTeX_cannot_write_is_told(self):
        self.figure("a.tex", "--title", "Кривая ⅓", told="LaTeX as it is installed cannot set К, р, и, в, а, я: question marks stand there until the paper defines \\battenletters\n")
        text = self.figure("b.tex", "--title", "A point on a curve, $P_3$").read_text()
        self.assertIn("A point on a curve, $P_3$", text)

    def test_letters_of_no_font_are_told(self):
        told = "no font of these figures has 曲, 線: boxes stand there; an SVG figure has them as text, for the fonts of what shows it\n"
        for name in ("a.png", "a.pdf"):
            self.figure(name, "--title", "曲線 Кривая ⅓ 曲", told=told)
        self.assertIn("曲線", self.figure("a.svg", "--title", "曲線").read_text())

    def test_indices_and_fractions_are_formulas(self):
        text = self.figure("a.tex", "--show", "points,labels,corner-cutting", "--at", "1/2", file=EXAMPLES / "coons-open.json").read_text()
        self.assertIn("$P_{0}$", text)
        # Half way through a uniform cubic's span u is inserted at 1/6, 1/2 and 5/6 of the legs.
        for fraction in ("\\frac{1}{6}", "\\frac{1}{2}", "\\frac{5}{6}"):
            self.assertIn(fraction, text)


class IdleWords(FigureTest):
    def line(self):
        return self.document(curves=[{"name": "line", "degree": 1, "knots": [0, 0, 1, 1], "points": [[0, 0], [1, 1]]}])

    def told(self, *options, file=WAVE, name="a.svg"):
        process = run("figure", file, "-o", self.folder / name, *options)
        self.assertEqual(process.returncode, 0)
        return process.stderr

    def test_what_the_curve_has_nothing_of_is_told(self):
        self.assertIn("--show: comb adds nothing to this figure: there is nothing of that kind, or it stands there already\n",
                      self.told("--show", "points, comb", file=self.line()))
        self.assertIn("--show: comb, pictures add nothing to this figure", self.told("--show", "points,comb,pictures", file=self.line()))

    def test_what_adds_something_is_not_told(self):
        self.assertEqual(self.told("--show", "polygon,points,labels,knots,comb"), "")
        self.assertEqual(self.told(file=self.line()), "", "nothing was asked for by name")

    def test_what_has_no_room_is_told_as_that(self):
        told = self.told("--size", "200x150", "--at", "0.4", "--show", "polygon,points,labels,knots,deboor,legend")
        self.assertIn("there was no room for the legend", told)
        self.assertNotIn("legend adds nothing", told)

    def test_of_an_animation_all_parts_count(self):
        self.assertEqual(self.told("--show", "points,deboor", "--animate", "u=0..1", "--frames", "2", name="%d.svg"), "")
        self.assertIn("--show: guides adds nothing", self.told("--show", "points,guides", "--animate", "u=0..1", "--frames", "2", name="%d.svg"))


class Animations(FigureTest):
    def test_a_parameter_runs(self):
        process = run("figure", WAVE, "--animate", "u=0..1", "--frames", "5", "-o", self.folder / "f-%03d.svg", "--show", "polygon")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        names = sorted(file.name for file in self.folder.iterdir())
        self.assertEqual(names, [f"f-{k:03}.svg" for k in range(5)])
        frames = [Picture(self.folder / name) for name in names]
        points = json.loads(WAVE.read_text())["curves"][0]["points"]
        shown = frames[0].polygon()
        s = (shown[-1][0] - shown[0][0]) / (points[-1][0] - points[0][0])
        for k, frame in enumerate(frames):
            self.assertEqual(frame.polygon(), shown, "the camera stands still")
            x = float(run("eval", WAVE, "--at", str(k / 4)).stdout.split()[1])
            ((place, _),) = frame.circles_of(8.0)
            self.assertAlmostEqual(place, shown[0][0] + s * (x - points[0][0]), delta=0.02)

    def sides(self, motion, name, place_of):
        """Per frame of 100, where the label whose text begins with `name` stands, seen from its point."""
        process = run("figure", WAVE, "--animate", motion, "--frames", "100", "-o", self.folder / "%02d.svg", "--show", "polygon,points,labels,knots,deboor")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        offsets = []
        for k in range(100):
            frame = Picture(self.folder / f"{k:02}.svg")
            text = next(t for t in frame.root.iter(SVG + "text") if "".join(t.itertext()).startswith(name))
            x, y = place_of(frame)
            offsets.append((text.get("text-anchor"), float(text.get("x")) - x, float(text.get("y")) - y))
        return offsets

    def jumps(self, offsets):
        return [k for k, (a, b) in enumerate(zip(offsets, offsets[1:]), 1) if a[0] != b[0] or math.dist(a[1:], b[1:]) > 3.0]

    def test_labels_stay_on_their_side_of_what_moves(self):
        parameter = lambda frame: frame.circles_of(8.0)[0]
        self.assertLessEqual(len(self.jumps(self.sides("u=0..1", "C(", parameter))), 3, "where it leaves P0, and where it comes to P6")
        self.assertEqual(self.jumps(self.sides("merge=4", "C(", parameter)), [])

    def test_labels_of_points_stand_still_while_a_parameter_runs(self):
        self.assertEqual(self.jumps(self.sides("u=0..1", "P3", lambda frame: (0.0, 0.0))), [])

    def test_a_frame_is_the_same_in_every_run_and_the_first_one_that_of_a_figure_at_rest(self):
        shown = ("--show", "polygon,points,labels,deboor")
        for name in ("a", "b"):
            run("figure", WAVE, "--animate", "u=0.3..0.7", "--frames", "9", "-o", self.folder / (name + "%d.svg"), *shown)
        for k in range(9):
            self.assertEqual((self.folder / f"a{k}.svg").read_text(), (self.folder / f"b{k}.svg").read_text())
        still = self.figure("still.svg", *shown, "--at", "0.3")
        self.assertEqual((self.folder / "a0.svg").read_text(), still.read_text())

    def test_a_knot_comes_in(self):
        process = run("figure", WAVE, "--animate", "insert=0.6", "--frames", "3", "-o", self.folder / "%d.svg", "--show", "polygon,points")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        before, halfway, after = (Picture(self.folder / f"{k}.svg").polygon() for k in range(3))
        self.assertEqual((len(before), len(halfway), len(after)), (7, 9, 8))
        # Of degree 3 two corners go: P3 and P4, each on its ways to the new points; those are after[3], [4] and [5].
        middle = lambda a, b: ((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)
        wanted = [middle(before[3], after[3]), middle(before[3], after[4]), middle(before[4], after[4]), middle(before[4], after[5])]
        for place, expected in zip(halfway[3:7], wanted):
            self.assertAlmostEqual(place[0], expected[0], delta=0.02)
            self.assertAlmostEqual(place[1], expected[1], delta=0.02)
        self.assertEqual(halfway[:3] + halfway[7:], before[:3] + before[5:])

    def test_a_knot_comes_in_with_all_that_was_asked_for(self):
        run("figure", WAVE, "--animate", "insert=0.6", "--frames", "4", "-o", self.folder / "%d.svg", "--show", "polygon,points,labels,knots")
        frames = [Picture(self.folder / f"{k}.svg") for k in range(4)]
        for k, frame in enumerate(frames):
            for i in range(7):
                self.assertIn(f"P{i}", frame.texts, f"frame {k}")
            self.assertEqual(len(frame.circles_of(6.5)), (7, 9, 9, 8)[k])
            rings = [c for c in frame.circles if c.get("stroke-dasharray")]
            self.assertEqual(len(rings), (1, 2, 2, 2)[k], "of the weight 2, and of those that it goes to")
            self.assertEqual(len(diamonds(frame)), 4, "of the knots inside, the new one from the first frame on")
            boxes = [p for p in frame.root.iter(SVG + "path") if p.get("d").endswith("Z") and p.get("fill") == "none"]
            self.assertEqual(len(boxes), 1, "around the first point")
        start = [next(text for text in frame.root.iter(SVG + "text") if "".join(text.itertext()) == "P0") for frame in frames]
        self.assertEqual(len({(text.get("x"), text.get("y")) for text in start}), 1, "it stands still")
        bare = run("figure", WAVE, "--animate", "insert=0.6", "--frames", "3", "-o", self.folder / "b%d.svg", "--show", "points")
        self.assertEqual(bare.stderr, "")
        halfway = Picture(self.folder / "b1.svg")
        self.assertEqual((halfway.texts, len(halfway.lines), len(halfway.circles_of(6.5))), ([], 1, 9))

    def test_a_knot_comes_in_among_many_as_it_looks_at_rest(self):
        n = 1000
        points = [[i / 10, 3 * math.sin(i / 50) + 2 * (i * i % 7) / 7] for i in range(n)]
        knots = [0, 0, 0, *range(n - 2), n - 3, n - 3, n - 3]
        file = self.document(curves=[{"name": "many", "degree": 3, "knots": knots, "points": points, "weights": [1] * n}], active=0)
        shown = ("--show", "polygon,points,labels,knots")
        process = run("figure", file, "--animate", "insert=500.5", "--frames", "5", "-o", self.folder / "%d.svg", *shown)
        self.assertIn("there was no room for 999 labels", process.stderr)
        after = self.folder / "after.json"
        self.assertEqual(run("apply", file, "insert-knot", "500.5", "-o", after).returncode, 0)
        at_rest = Picture(self.figure("rest.svg", *shown, file=after, told=None))
        frames = [Picture(self.folder / f"{k}.svg") for k in range(5)]
        self.assertEqual(frames[4].places_of_circles(), at_rest.places_of_circles())
        self.assertEqual(frames[4].texts, at_rest.texts)
        for k, frame in enumerate(frames):
            self.assertEqual(len(frame.circles_of(6.5)), 2, "the first and the last point")
            self.assertLess(len(frame.circles), n, "not all of the others")
            kinds = [item.tag.removeprefix(SVG) for item in frame.root.iter() if item in frame.circles or item in frame.lines or item.tag == SVG + "image"]
            curve = kinds.index("image")
            self.assertEqual((kinds[0], set(kinds[1:curve]), kinds[curve + 1:]), ("path", {"circle"}, ["circle", "circle"]),
                             "below the curve are the polygon and the small points, above it the first and the last one")

    def test_names_change_half_way(self):
        file = self.document(curves=[{"name": "b", "degree": 2, "knots": [0, 0, 0, 1, 2, 3, 3, 3], "points": [[0, 0], [2, 4], [6, 4], [8, 0], [12, 0]], "weights": [1, 1, 2, 1, 1]}], active=0)
        process = run("figure", file, "--animate", "insert=0.5", "--frames", "6", "-o", self.folder / "%d.svg", "--show", "polygon,points,labels,knots", "--size", "1000x600")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        shown = []
        for k in range(6):
            texts = [text for text in Picture(self.folder / f"{k}.svg").root.iter(SVG + "text")]
            shown.append({"".join(t.itertext()): float(t.get("fill-opacity", "1")) for t in texts})
        self.assertEqual(set(shown[0]), {"P0", "P1", "P2", "· w 2", "P3", "P4"})
        self.assertEqual(set(shown[5]), {"P0", "P1", "P2", "· w 1.25", "P3", "· w 2", "P4", "P5"})
        self.assertNotIn("P5", shown[2])
        self.assertAlmostEqual(shown[2]["P4"], 0.4, delta=0.01)
        self.assertAlmostEqual(shown[3]["P5"], 0.4, delta=0.01)
        self.assertEqual((shown[1]["P4"], shown[4]["P5"], shown[2]["P0"]), (1.0, 1.0, 1.0))

    def test_multiple_knots_stand_beside_their_points(self):
        run("figure", self.example("circle-nurbs"), "--animate", "insert=0.3", "--frames", "3", "-o", self.folder / "%d.svg", "--show", "points,knots")
        for k in range(3):
            frame = Picture(self.folder / f"{k}.svg")
            marks = diamonds(frame)
            self.assertEqual(len(marks), 7, f"frame {k}: three double knots and the new one")
            for four in marks:
                x, y = four[1][0], four[0][1]
                least = min((x - a) ** 2 + (y - b) ** 2 for a, b in frame.circles_of(6.5)) ** 0.5
                self.assertGreater(least, 8.0, f"frame {k}")

    def test_names_of_frames(self):
        process = run("figure", WAVE, "--animate", "u=0..1", "--frames", "2", "-o", self.folder / "p%%q-%02d.svg")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertEqual(sorted(file.name for file in self.folder.iterdir()), ["p%q-00.svg", "p%q-01.svg"])

    def test_movies_of_odd_sizes_have_the_ground_up_to_the_edge(self):
        self.needs("ffmpeg")
        output = self.folder / "a.mp4"
        process = run("figure", WAVE, "--animate", "u=0..1", "--frames", "2", "-o", output, "--size", "301x201", "--show", "polygon")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        subprocess.run(["ffmpeg", "-loglevel", "error", "-i", output, "-frames:v", "1", self.folder / "a.png"], check=True)
        width, height, rows = pixels((self.folder / "a.png").read_bytes())
        self.assertEqual((width, height), (302, 202))
        for x, y in ((301, 0), (301, 201), (0, 201)):
            self.assertGreater(min(rows[y][x][:3]), 240, "light")

    def test_knots_merge(self):
        process = run("figure", WAVE, "--animate", "merge=4", "--frames", "3", "-o", self.folder / "%d.svg", "--view", "basis")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        before, halfway, after = (Picture(self.folder / f"{k}.svg").texts for k in range(3))
        self.assertIn("0.25", before)
        self.assertIn("0.375", halfway)
        self.assertIn("×2 C1", after)

    def test_knots_that_have_no_room_for_their_values_are_told(self):
        process = run("figure", WAVE, "--animate", "merge=4", "--frames", "12", "-o", self.folder / "%d.svg", "--view", "both", "--size", "640x480")
        self.assertIn("there was no room for the label 0.5; a larger figure may have it", process.stderr)

    def test_movies(self):
        self.needs("ffmpeg", "ffprobe")
        temporary = self.folder / "temporary"
        temporary.mkdir()
        for name in ("a.gif", "a.mp4"):
            environment = dict(os.environ, TMPDIR=str(temporary))
            output = self.folder / name
            process = subprocess.run([BINARY, "figure", WAVE, "--animate", "u=0..1", "--frames", "7", "-o", output, "--size", "301x201", "--show", "polygon"], capture_output=True, text=True, check=False, env=environment)
            self.assertEqual((process.returncode, process.stderr), (0, ""))
            probe = subprocess.run(["ffprobe", "-v", "error", "-count_packets", "-show_entries", "stream=nb_read_packets,width,height", "-of", "csv=p=0", output], capture_output=True, text=True, check=True)
            width, height, frames = (int(n) for n in probe.stdout.strip().split(","))
            self.assertEqual((width, height, frames), (301, 201, 7) if name == "a.gif" else (302, 202, 7))
            self.assertEqual(list(temporary.iterdir()), [], "frames are removed")

    def test_movies_need_ffmpeg(self):
        process = subprocess.run([BINARY, "figure", WAVE, "--animate", "u=0..1", "-o", self.folder / "a.gif"], capture_output=True, text=True, check=False, env=dict(os.environ, PATH="/nowhere"))
        self.assertEqual(process.returncode, 1)
        self.assertIn("ffmpeg is not installed", process.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


class Refusals(FigureTest):
    def test_a_figure_does_not_replace_what_it_is_of(self):
        drawing = self.folder / "drawing.svg"
        self.assertEqual(run("convert", WAVE, "-o", drawing).returncode, 0)
        before = drawing.read_bytes()
        process = run("figure", drawing, "-o", self.folder / "." / "drawing.svg")
        self.assertEqual((process.returncode, process.stdout), (2, ""))
        self.assertEqual(process.stderr, f"batten figure: -o: '{drawing}' is the file that is drawn; the figure needs a name of its own\n")
        self.assertEqual(drawing.read_bytes(), before)

    def test_wrong_words(self):
        for sentence, options in (
            ("--show: there is nothing called 'foo' to show; 'batten figure --help' lists all that can be shown\n", ("--show", "points,foo")),
            ("nothing called 'polygn' to show; did you mean 'polygon'? ", ("--show", "polygn,knots")),
            ("nothing called 'debor' to show; did you mean 'deboor'? ", ("--show", "debor")),
            ("--show: a name is missing beside a comma of 'polygon,,knots'; names stand between commas, as in polygon,points,labels", ("--show", "polygon,,knots")),
            ("a name is missing beside a comma of 'polygon,'", ("--show", "polygon,")),
            ("a name is missing beside a comma of ' , '", ("--show", " , ")),
            ("--at: nan:", ("--at", "nan")),
            ("--at: 1e999:", ("--at", "1e999")),
            ("at most 10000 pixels", ("--size", "100000x100000")),
            ("'0x5' is no size", ("--size", "0x5")),
            ("'5' is no size", ("--size", "5")),
            ("'-5x5' is no size", ("--size=-5x5",)),
            ("--scale is for pixels", ("--scale", "2")),
            ("'foo' is no view of a figure; curve, basis, both or homogeneous are", ("--view", "foo")),
            ("'foo' is no theme", ("--theme", "foo")),
            ("'foo' is no motion", ("--animate", "foo")),
            ("'merge=1.5' is no motion", ("--animate", "merge=1.5")),
            ("has no place for the number of a frame", ("--animate", "u=0..1")),
            ("--frames: 0 is no whole number from 1 to 10000", ("--animate", "u=0..1", "--frames", "0")),
            ("--frames: 1.5 is no whole number from 1 to 10000", ("--animate", "u=0..1", "--frames", "1.5")),
            ("--rate: 1000 is no number from 0.1 to 100", ("--animate", "u=0..1", "--rate", "1000")),
            ("--frames: nothing moves; --animate says what does", ("--frames", "3")),
            ("--rate: nothing moves; --animate says what does", ("--rate", "3")),
            ("--at: the parameter is what moves; leave one of the two out", ("--animate", "u=0..1", "--at", "0.3")),
            ("--size: with these parts a figure needs a height of at least 240 pixels", ("--view", "both", "--size", "600x239")),
            ("--size: with these parts a figure needs a height of at least 204 pixels",
             ("--view", "basis", "--title", "N", "--size", "600x200")),
            ("--show: 'quiz' is seen in the window only", ("--show", "quiz")),
            ("--show: 'polygon' is not seen with --view basis, but with curve, both or homogeneous", ("--show", "polygon", "--view", "basis")),
            ("--show: 'speed-plot' is not seen with --view curve, but with basis or both", ("--show", "speed-plot", "--view", "curve")),
            ("--show: 'comb' is not seen with --view homogeneous, but with curve or both", ("--show", "comb", "--view", "homogeneous")),
            ("--show: 'legend' tells what the colors of 'deboor' mean, which is not shown", ("--show", "legend")),
            ("'doc' is no format", ("--format", "doc")),
        ):
            with self.subTest(options=options):
                self.refused(2, sentence, *options)
        self.refused(2, "'x.doc' has the ending of no figure".replace("x.doc", str(self.folder / "x.doc")), output="x.doc")
        self.refused(2, "a GIF or MP4 needs --animate", output="x.gif")
        self.refused(2, "--transparent: an MP4 has a ground; GIF and numbered PNG may have none", "--animate", "u=0..1", "--transparent", output="x.mp4")
        self.refused(2, "--rate: numbered frames have none; GIF and MP4 have one", "--animate", "u=0..1", "--rate", "10", output="%d.svg")
        self.refused(2, "--format is needed for standard output", output="-")
        self.refused(2, "--scale: nan is no number above 0", "--scale", "nan", output="x.png")
        self.refused(2, "x-%03d.png' is a pattern for the frames that --animate makes", output="x-%03d.png")
        self.refused(2, "%d-%d.svg' has 2 places for the number of a frame; one is needed", "--animate", "u=0..1", output="%d-%d.svg")

    def test_the_help_lists_all_that_can_be_shown(self):
        text = run("figure", "--help").stdout
        for name in ("polygon", "curvature-comb", "comb", "osculating-circle", "legend", "rulers"):
            self.assertIn(f" {name}", text.partition("--show")[2].partition("--at")[0])

    def test_nothing_is_shown_beside_the_curve(self):
        process = run("figure", WAVE, "-o", "-", "--format", "svg", "--show", "")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertNotIn("<text", process.stdout)

    def test_wrong_input(self):
        self.refused(1, "the parameter 1.5 is outside the domain; it must be from 0 to 1", "--at", "1.5")
        self.refused(1, "the parameter 2 is outside", "--animate", "u=0..2", output="%d.svg")
        self.refused(1, "there is no knot 99; the knots have the indices 0 to 10", "--animate", "merge=99", output="%d.svg")
        self.refused(1, "no knot is larger than knot 10", "--animate", "merge=10", output="%d.svg")
        self.refused(1, "no knot 0 can come in: there are 4 of them already, the most that there may be", "--animate", "insert=0", output="%d.svg")
        self.refused(1, "knot 4 cannot go to 0.5: 2 knots are there already, the most that there may be", "--animate", "merge=4", output="%d.svg", file=EXAMPLES / "circle-nurbs.json")
        self.refused(1, "there is no curve 'nix'", "--curve", "nix")
        self.refused(1, f"there is no folder {self.folder / 'nowhere'}\n", output="nowhere/x.svg")
        with tempfile.NamedTemporaryFile("w", suffix=".json") as empty:
            empty.write('{"format": "batten", "version": 1, "curves": []}')
            empty.flush()
            self.refused(1, "there is none; at least one is needed", file=empty.name)

    def test_standard_output(self):
        process = run("figure", WAVE, "-o", "-", "--format", "svg")
        self.assertEqual((process.returncode, process.stderr), (0, ""))
        self.assertTrue(process.stdout.startswith("<svg "))


class Guide(FigureTest):
    """docs/figures.md, as someone reads it who has the examples beside."""

    def test_every_command_does_what_it_says(self):
        page = (ROOT / "docs" / "figures.md").read_text()
        (self.folder / "assets").symlink_to(ROOT / "assets")
        (self.folder / "bin").mkdir()
        (self.folder / "bin" / "batten").symlink_to(BINARY)
        (paper,) = re.findall(r"```latex\n(.*?)```", page, re.S)
        (self.folder / "paper.tex").write_text(paper)
        environment = dict(os.environ, PATH=f"{self.folder / 'bin'}:{os.environ['PATH']}")
        commands = [line for block in re.findall(r"```sh\n(.*?)```", page, re.S) for line in block.splitlines()]
        self.assertGreaterEqual(len(commands), 10)
        self.assertEqual([command for command in commands if re.search(r'"[^"]*\$[^"]*"', command)], [], "a shell takes $x for a variable there")
        for command in commands:
            with self.subTest(command=command):
                words = shlex.split(command)
                output = words[words.index("-o", len(words) - words[::-1].index("figure")) + 1] if "figure" in words else "paper.pdf"
                needed = "ffmpeg" if output.endswith((".gif", ".mp4")) else words[0]
                if shutil.which(needed, path=environment["PATH"]) is None:
                    self.skipTest(f"{needed} is not installed; scripts/setup figures installs it")
                process = subprocess.run(["sh", "-c", command], cwd=self.folder, env=environment, capture_output=True, text=True, check=False)
                self.assertEqual((process.returncode, re.sub("circle 0 0 1: .*\n|merge[^:]*: there was no room for the label 0.5; .*\n", "", process.stderr)), (0, ""))
                made = output % 0 if "%" in output else output
                self.assertGreater((self.folder / made).stat().st_size, 100)
                if made == "paper.pdf":
                    self.assertNotIn("Overfull", (self.folder / "paper.log").read_text(errors="replace"), "it is wider than the page")


if __name__ == "__main__":
    unittest.main()
