"""What the views cost: views.py BINARY. Drags a control point of a curve of 50 points with no overlay and with all of them, and prints the processor time of a frame."""

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


def document(shown, weights):
    count, degree = 50, 3
    spans = count - degree
    points = [[(6 + 0.12 * i) * math.cos(i / 4), (4 + 0.08 * i) * math.sin(i / 4)] for i in range(count)]
    knots = [0] * (degree + 1) + [i / spans for i in range(1, spans)] + [1] * (degree + 1)
    curve = {"name": "spiral", "degree": degree, "knots": knots, "points": points, "weights": weights(count)}
    return {"format": "batten", "version": 1, "curves": [curve], "view": {"parameter": 0.4, "overlays": shown}}


def frame_ms(binary, folder, shown, weights):
    path = pathlib.Path(folder) / "spiral.json"
    path.write_text(json.dumps(document(shown, weights)))
    words = [binary, "profile", path, "--drag", "--frames", "120", "--json"]
    return json.loads(subprocess.run(words, check=True, capture_output=True, text=True).stdout)["frame_ms"]["median"]


def main():
    binary = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        for name, weights in (("polynomial", lambda n: [1] * n), ("rational", lambda n: [1 + 0.5 * (i % 3) for i in range(n)])):
            bare, all_shown = (frame_ms(binary, folder, shown, weights) for shown in ([], overlays()))
            print(f"{name}: {bare:.1f} ms with none, {all_shown:.1f} ms with all of {len(overlays())}: {all_shown / bare:.1f} times")


if __name__ == "__main__":
    main()
