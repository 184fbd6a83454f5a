"""What a frame of each gesture costs by the number of control points, as a table in bench/README.md.

    python3 bench/gestures.py build/release/app/batten [frames]

Needs Xvfb. The curve is a spiral of five turns, cubic and clamped uniform, wholly in view. Each gesture is profiled three
times in turn; the least median counts, since other programs can only add to it.
"""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

GESTURES = ["drag", "drag-knot", "insert-knot", "hover", "pan", "zoom", "play"]
COUNTS = [10, 1_000, 100_000, 1_000_000]
ROUNDS = 3
TURNS = 5
README = pathlib.Path(__file__).parent / "README.md"
START = "<!-- gestures.py writes from here -->\n"
END = "<!-- gestures.py writes to here -->\n"


def spiral(count):
    points = []
    for i in range(count):
        share = math.sqrt(i / (count - 1))
        angle = 2.0 * math.pi * TURNS * share
        points.append([share * math.cos(angle), share * math.sin(angle)])
    inner = range(1, count - 3)
    knots = [0] * 4 + list(inner) + [count - 3] * 4
    return {"name": "spiral", "degree": 3, "knots": knots, "points": points, "kind": "clamped-uniform"}


def median_ms(batten, path, gesture, frames, before=()):
    command = ["xvfb-run", "-a", "-s", "-screen 0 1440x900x24", batten, "profile", str(path), f"--{gesture}"]
    command += ["--frames", str(frames), "--json"]
    for typed in before:
        command += ["--do", typed]
    environment = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1"}
    run = subprocess.run(command, env=environment, check=True, capture_output=True, text=True)
    return json.loads(run.stdout)["frame_ms"]["median"]


def cell(ms, ms_of_few):
    return f"{ms:.1f} ({ms / ms_of_few:.1f})"


def table(medians):
    header = ["gesture"] + [f"n = {count:,}" for count in COUNTS]
    rows = [header, ["---"] * len(header)]
    for gesture in GESTURES:
        few = medians[gesture, COUNTS[0]]
        rows.append([f"`--{gesture}`"] + [cell(medians[gesture, count], few) for count in COUNTS])
    return "".join(f"| {' | '.join(row)} |\n" for row in rows)


def put_into_readme(text):
    readme = README.read_text(encoding="utf-8")
    before, rest = readme.split(START)
    after = rest.split(END)[1]
    README.write_text(f"{before}{START}\n{text}\n{END}{after}", encoding="utf-8")


def main():
    batten = sys.argv[1]
    frames = int(sys.argv[2]) if len(sys.argv) > 2 else 60
    medians = {}
    with tempfile.TemporaryDirectory() as folder:
        for count in COUNTS:
            path = pathlib.Path(folder) / f"spiral_{count}.json"
            path.write_text(json.dumps({"format": "batten", "version": 1, "curves": [spiral(count)]}))
        for _ in range(ROUNDS):
            for gesture in GESTURES:
                for count in COUNTS:
                    path = pathlib.Path(folder) / f"spiral_{count}.json"
                    ms = median_ms(batten, path, gesture, frames)
                    medians[gesture, count] = min(ms, medians.get((gesture, count), math.inf))
    result = table(medians)
    put_into_readme(result)
    print(result, end="")


if __name__ == "__main__":
    main()
