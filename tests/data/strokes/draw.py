#!/usr/bin/env python3
"""Draws strokes with the pencil in the real window: draw.py BINARY FOLDER [SEED] writes NAME_window.csv, the samples that the program
received by its log, in pixels of the window, NAME_window_truth.csv, and prints the rows for strokes.csv.

A hand follows a curve of make.py: slow at the ends and in bends, with a tremor of 8 to 12 Hz, an event every 8 ms, whole pixels.
"""
import json
import math
import pathlib
import random
import sys
import tempfile

import make

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "e2e"))
from driver import Display, Editor  # noqa: E402

STORED = ("letter_s", "ellipse", "spiral", "waves", "loop", "polygon", "retraced", "part_of_circle")
SIZE = (1280, 960)
EVENT_SECONDS = 0.008
TREMOR_PIXELS = 0.5


def at_arc_length(truth, s):
    return truth[max(0, min(len(truth) - 1, round(s / make.HALF)))]


def speed(truth, s):
    """Pixels a second: by the power law of two thirds, v = g kappa^(-1/3), and slow at the ends."""
    a, b, c = (at_arc_length(truth, s + d) for d in (-6, 0, 6))
    bend = abs(math.remainder(math.atan2(c[1] - b[1], c[0] - b[0]) - math.atan2(b[1] - a[1], b[0] - a[0]), 2 * math.pi)) / 6
    end = make.HALF * (len(truth) - 1)
    return min(900, 170 * max(bend, 1e-3) ** (-1 / 3), 60 + 9 * s, 60 + 9 * (end - s))


def hand(truth, r):
    """Whole pixels, one for each event."""
    waves = [(r.uniform(8, 12), r.uniform(0, 6.3), r.uniform(0, 6.3)) for _ in range(3)]
    s, time, places = 0.0, 0.0, []
    end = make.HALF * (len(truth) - 1)
    while True:
        x, y = at_arc_length(truth, s)
        for hertz, p, q in waves:
            x += TREMOR_PIXELS * math.sin(2 * math.pi * hertz * time + p) / math.sqrt(3)
            y += TREMOR_PIXELS * math.sin(2 * math.pi * hertz * time + q) / math.sqrt(3)
        places.append((round(x), round(y)))
        if s >= end:
            return places
        s = min(end, s + speed(truth, s) * EVENT_SECONDS)
        time += EVENT_SECONDS


def shifted(truth):
    """In the middle of the canvas."""
    lower, upper = ([f(p[k] for p in truth) for k in (0, 1)] for f in (min, max))
    return [(x + round(600 - (lower[0] + upper[0]) / 2), y + round(460 - (lower[1] + upper[1]) / 2)) for x, y in truth]


def received(log, state):
    """The samples of the stroke that was logged last, in pixels of the window."""
    line = [line for line in log.read_text().splitlines() if "fit-stroke" in line][-1]
    _, numbers, *_ = json.loads(line)
    return [(round(state["origin"]["x"] + state["zoom"] * x, 6), round(state["origin"]["y"] - state["zoom"] * y, 6))
            for x, y in zip(numbers[::2], numbers[1::2])]


def draw(editor, places):
    editor.key("d")
    editor.move(*places[0])
    editor.press()
    editor.xdotool(*(word for x, y in places[1:] for word in ("mousemove", x, y, "sleep", EVENT_SECONDS)))
    editor.release()
    editor.wait(lambda state: state["undo_label"] == "Draw stroke" and state["is_settled"], "the stroke")


def main():
    binary, folder, *seed = sys.argv[1:]
    folder = pathlib.Path(folder)
    settings = {"window": {"x": 0, "y": 0, "width": SIZE[0], "height": SIZE[1]}, "inspector_is_open": False}
    for shape in make.SHAPES if seed else STORED:
        r = random.Random(f"{shape} window {seed[0] if seed else 'stored'}")
        truth, corners, inflections, closed = make.SHAPES[shape](r)
        truth = shifted(truth)
        with tempfile.TemporaryDirectory() as files, Display(*SIZE) as display:
            empty, log = pathlib.Path(files) / "empty.json", pathlib.Path(files) / "log"
            empty.write_text(json.dumps({"format": "batten", "version": 1, "curves": []}))
            with Editor(binary, display, files, ["--session-log", log, empty], settings=settings) as editor:
                editor.key("F4")
                draw(editor, hand(truth, r))
                samples = received(log, editor.settle())
        for file, points in ((f"{shape}_window", samples), (f"{shape}_window_truth", truth)):
            (folder / f"{file}.csv").write_text("".join(f"{x:.6g},{y:.6g}\n" for x, y in points))
        print(f"{shape}_window,{corners},{inflections},{int(closed)}", flush=True)


if __name__ == "__main__":
    main()
