"""What a frame costs while very much is selected, shown or transformed, as a table in bench/README.md.

    python3 bench/selections.py build/release/app/batten [frames]

Needs Xvfb. The curves are spirals as in gestures.py; what each row does before its gesture is typed as in the palette. Each
row is profiled three times in turn; the least median counts, since other programs can only add to it.
"""

import json
import math
import pathlib
import sys
import tempfile

from gestures import README, ROUNDS, median_ms, spiral

START = "<!-- selections.py writes from here -->\n"
END = "<!-- selections.py writes to here -->\n"
COMBS = {"parameter": 1.0, "overlays": ["polygon", "curvature-comb", "curvature-plot"]}


def moved_spiral(index):
    curve = spiral(1_000)
    points = [[0.1 * (index % 10) + 0.3 * x, 0.3 * y] for x, y in curve["points"]]
    return {**curve, "name": f"spiral {index}", "points": points}


def documents():
    plain = {"format": "batten", "version": 1}
    return {
        "10,000 points": {**plain, "curves": [spiral(10_000)]},
        "10,000 points, comb and plot of curvature": {**plain, "curves": [spiral(10_000)], "view": COMBS},
        "50 curves of 1,000 points": {**plain, "curves": [moved_spiral(i) for i in range(50)]},
        "1,000,000 points": {**plain, "curves": [spiral(1_000_000)]},
    }


ROWS = [
    ("10,000 points", "drag", ()),
    ("10,000 points, comb and plot of curvature", "drag", ()),
    ("50 curves of 1,000 points", "drag", ()),
    ("50 curves of 1,000 points", "drag", ("select-all-curves",)),
    ("1,000,000 points", "hover", ("select-all",)),
    ("1,000,000 points", "drag", ("select-all",)),
    ("1,000,000 points", "hover", ("drawing-mode",)),
    ("1,000,000 points", "hover", ("set-tool transform", "select-all")),
    ("1,000,000 points", "drag", ("set-tool transform", "select-all")),
]


def table(medians):
    rows = [["curves", "before", "gesture", "milliseconds a frame"], ["---"] * 4]
    for row in ROWS:
        name, gesture, before = row
        typed = ", ".join(f"`{command}`" for command in before)
        rows.append([name, typed, f"`--{gesture}`", f"{medians[row]:.1f}"])
    return "".join(f"| {' | '.join(row)} |\n" for row in rows)


def put_into_readme(text):
    before, rest = README.read_text(encoding="utf-8").split(START)
    README.write_text(f"{before}{START}\n{text}\n{END}{rest.split(END)[1]}", encoding="utf-8")


def main():
    batten = sys.argv[1]
    frames = int(sys.argv[2]) if len(sys.argv) > 2 else 30
    medians = dict.fromkeys(ROWS, math.inf)
    with tempfile.TemporaryDirectory() as folder:
        paths = {name: pathlib.Path(folder) / f"{i}.json" for i, name in enumerate(documents())}
        for name, document in documents().items():
            paths[name].write_text(json.dumps(document))
        for _ in range(ROUNDS):
            for row in ROWS:
                name, gesture, before = row
                medians[row] = min(medians[row], median_ms(batten, paths[name], gesture, frames, before))
    result = table(medians)
    put_into_readme(result)
    print(result, end="")


if __name__ == "__main__":
    main()
