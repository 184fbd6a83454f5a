"""What the views cost: views.py BINARY [POINTS]. Drags a control point of a curve of 50 points, or so many, with no overlay and with all of them, and prints
the processor time of a frame: the least of three medians, for other programs only add to it."""

import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def overlays():
    """The names of all overlays, as files have them."""
    return re.findall(r'Named\{\w+, "([a-z-]+)"', (ROOT / "app/editor/state/overlay.h").read_text())


def document(shown, weights, count=50):
    degree = 3
    spans = count - degree
    turns = [50 * i / count for i in range(count)]
    points = [[(6 + 0.12 * t) * math.cos(t / 4), (4 + 0.08 * t) * math.sin(t / 4)] for t in turns]
    knots = [0] * (degree + 1) + [i / spans for i in range(1, spans)] + [1] * (degree + 1)
    curve = {"name": "spiral", "degree": degree, "knots": knots, "points": points, "weights": weights(count)}
    return {"format": "batten", "version": 1, "curves": [curve], "view": {"parameter": 0.4, "overlays": shown}}


def frame_ms(binary, folder, shown, weights, count):
    path = pathlib.Path(folder) / "spiral.json"
    path.write_text(json.dumps(document(shown, weights, count)))
    words = [binary, "profile", path, "--drag", "--frames", "120", "--json"]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)["frame_ms"]["median"]


def main():
    binary = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 50
    with tempfile.TemporaryDirectory() as folder:
        for name, weights in (("polynomial", lambda n: [1] * n), ("rational", lambda n: [1 + 0.5 * (i % 3) for i in range(n)])):
            times = [[frame_ms(binary, folder, shown, weights, count) for shown in ([], overlays())] for _ in range(3)]
            bare, all_shown = (min(column) for column in zip(*times))
            print(f"{name}: {bare:.1f} ms with none, {all_shown:.1f} ms with all of {len(overlays())}: {all_shown / bare:.1f} times")


if __name__ == "__main__":
    main()
