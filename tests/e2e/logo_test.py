"""A logo traced from a picture that the test makes of known shapes, as docs/drawing/logo.md tells."""

import itertools
import json
import math
import struct
import unittest
import zlib

import spline
from session import SessionTest

WIDTH, HEIGHT = 320, 240  # of the picture, in pixels
SUBPIXELS = 8  # each way, of a pixel at an edge
INK, PAPER = 30, 250
DISC = (130.3, 119.6, 96.4)  # x and y of the center and the radius, in pixels, y upward
STAR = [(130.3 + radius * math.cos(math.radians(90 + 36 * k)), 119.6 + radius * math.sin(math.radians(90 + 36 * k)))
        for k, radius in zip(range(10), itertools.cycle((68.0, 30.0)))]
# A half disc, beside: two corners, where the arc meets the straight side.
HALF = (242.5, 119.6, 52.7)


def circle(x, y, radius, start=0, end=360, count=720):
    angles = [math.radians(start + (end - start) * k / count) for k in range(count + 1)]
    return [(x + radius * math.cos(angle), y + radius * math.sin(angle)) for angle in angles]


# The outlines that are meant, and their corners.
TRUTH = {
    "disc": (circle(*DISC), []),
    "star": (STAR + STAR[:1], STAR),
    "half disc": (circle(*HALF, -90, 90) + circle(*HALF, -90, 90)[:1], [(HALF[0], HALF[1] - HALF[2]), (HALF[0], HALF[1] + HALF[2])]),
}


def is_in_star(x, y):
    crossings = 0
    for (x0, y0), (x1, y1) in zip(STAR, STAR[1:] + STAR[:1]):
        if (y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0):
            crossings += 1
    return crossings % 2 == 1


def is_ink(x, y):
    if math.dist((x, y), DISC[:2]) < DISC[2]:
        return not is_in_star(x, y)
    return x > HALF[0] and math.dist((x, y), HALF[:2]) < HALF[2]


def shade(column, row):
    """Of a pixel: how much of it is ink. Only where its corners differ it must be looked at closely."""
    left, bottom = column, HEIGHT - 1 - row
    corners = {is_ink(left + dx, bottom + dy) for dx in (-0.5, 0.5, 1.5) for dy in (-0.5, 0.5, 1.5)}
    if len(corners) == 1:
        return INK if corners.pop() else PAPER
    places = [(k + 0.5) / SUBPIXELS for k in range(SUBPIXELS)]
    covered = sum(is_ink(left + dx, bottom + dy) for dx in places for dy in places) / SUBPIXELS**2
    return round(covered * INK + (1 - covered) * PAPER)


def png():
    rows = b"".join(b"\0" + bytes(shade(column, row) for column in range(WIDTH)) for row in range(HEIGHT))
    chunks = ((b"IHDR", struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 0, 0, 0, 0)), (b"IDAT", zlib.compress(rows)), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)) for name, data in chunks)


class LogoTest(SessionTest):
    page = "logo"

    def test_a_logo_is_traced(self):
        picture = self.folder / "logo.png"
        picture.write_bytes(png())
        self.begin()
        self.choose("file", "choose-picture")
        self.type_path("open-picture", picture)
        self.editor.wait(lambda state: "picture 0 opacity" in state["widgets"] and state["is_settled"], "the picture")
        self.scale()
        self.trace()
        curves = self.save()
        self.finish()
        self.check(curves, *json.loads(self.path.read_text())["pictures"])
        self.assert_told()
        self.undo_all()

    def scale(self):
        """By the left and the right edge of the disc, which are 96.4 mm apart."""
        width = float(self.editor.settle()["widgets"]["picture 0 width"]["value"])
        edges = [self.place((DISC[0] + side * DISC[2] - WIDTH / 2) * width / WIDTH, (DISC[1] - HEIGHT / 2) * width / WIDTH) for side in (-1, 1)]
        self.editor.click_widget("picture 0 measure")
        for edge in edges:
            self.editor.click(*edge)
        self.wait_for_form()
        self.picture("scale")
        self.fill("length", "96.4")
        self.apply()
        self.editor.key("f")

    def trace(self):
        self.choose("make", "trace-picture")
        self.wait_for_form()
        self.picture("tracing")
        self.apply()

    def finish(self):
        self.editor.click_widget("picture 0 visible")
        self.run_typed("toggle-even-odd-fill")
        self.picture("traced")

    def check(self, curves, picture):
        """In pixels of the picture, as the file places it."""
        scale, (left, bottom) = picture["scale"], picture["position"]
        self.assertAlmostEqual(scale, 0.5, delta=0.01)
        in_pixels = [{**curve, "points": [[(x - left) / scale, (y - bottom) / scale] for x, y in curve["points"]]} for curve in curves]
        self.assertEqual(len(in_pixels), len(TRUTH))
        for name, (outline, corners) in TRUTH.items():
            # The curve that is meant is the one whose beginning is nearest to this outline.
            curve = min(in_pixels, key=lambda curve: spline.distance_to_polyline(spline.samples(curve)[0], outline))
            drawn = spline.samples(curve, 20)
            self.assert_found(f"{name}: gap where the curve closes, pixels", math.dist(drawn[0], drawn[-1]), 1e-9)
            self.assert_found(f"{name}: farthest point of the curve from the truth, pixels",
                              max(spline.distance_to_polyline(p, outline) for p in drawn), 0.5)
            self.assert_found(f"{name}: farthest point of the truth from the curve, pixels",
                              max(spline.distance_to_polyline(p, drawn) for p in outline), 0.5)
            self.assert_found(f"{name}: control points", len(curve["points"]), 12)
            found = [spline.point_at(curve, u) for u, _, turn, _ in spline.jumps(curve) if abs(turn) > math.radians(10)]
            self.assertEqual(len(found), len(corners), name)
            if corners:
                self.assert_found(f"{name}: farthest corner from that of the truth, pixels",
                                  max(min(math.dist(corner, place) for place in found) for corner in corners), 0.5)


if __name__ == "__main__":
    unittest.main()
