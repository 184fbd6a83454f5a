"""Turns the times of scripts/bench into a table, and into plots of time against n:
report.py TIMES... [--readme FILE --plots FOLDER]; TIMES are files of Google Benchmark. Without options the table is printed."""

import argparse
import json
import pathlib
import re
import subprocess

OURS = ["Batten", "Batten_prepared"]
LIMITS = ["writing", "copying"]
PEERS = ["SISL", "OpenCASCADE", "OpenCASCADE_prepared", "Eigen", "GSL", "SciPy"]
# How many times faster than the best peer, plainly and prepared, and how many times the limit at most.
GOALS = {
    "sorted_samples": (None, 25, 2),
    "random_point": (2, 6, None),
    "random_point/n:100000": (2, 3, None),
    "derivatives": (1, 6, None),
    "basis": (2, 3, None),
    "insert_knot": (None, None, 1.5),
    "refine": (4, None, None),
    "bezier_pieces": (12, None, None),
    "elevate": (5, None, None),
    "nearest": (2, 20, None),
    "interpolate": (6, None, None),
}
OTHER_GOAL = (2, None, None)
BEGIN, END = "<!-- scripts/bench writes from here -->\n", "<!-- to here -->\n"


def read_times(files):
    """The least time of each library in seconds for one item, by work."""
    times = {}
    for file in files:
        for row in json.loads(pathlib.Path(file).read_text())["benchmarks"]:
            if row["run_type"] != "iteration":
                continue
            work, library = row["name"].split("/repeats:")[0].rsplit("/", 1)
            libraries = times.setdefault(work, {})
            libraries[library] = min(row["each"], libraries.get(library, float("inf")))
    return times


def in_units(seconds):
    if seconds is None:
        return ""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds * 1e9:.3g} ns"


def title(work):
    name, *parameters = work.split("/")
    given = dict(parameter.split(":") for parameter in parameters if ":" in parameter)
    parts = [name.replace("_", " ")]
    if given.get("rational") == "1":
        parts.append("rational")
    parts += [f"{letter} = {int(value):,}" for letter, value in given.items() if letter != "rational"]
    return ", ".join(parts)


def ratio(reached, goal, is_reached):
    if reached is None:
        return ""
    text = f"{reached:.2f}" if reached < 10 else f"{reached:.0f}"
    if goal is None:
        return text
    return f"{text} ({goal:g}{'' if is_reached else ', missed'})"


def table_row(work, times):
    goals = GOALS.get(work, GOALS.get(work.split("/")[0], OTHER_GOAL))
    best, fastest = min(((times[peer], peer) for peer in PEERS if peer in times), default=(None, ""))
    limit = next((times[name] for name in LIMITS if name in times), None)
    plain, prepared = (times.get(name) for name in OURS)

    def faster(own, goal):
        reached = best / own if best is not None and own is not None else None
        return ratio(reached, goal, goal is None or reached is None or reached >= goal)

    ours = min(own for own in (plain, prepared) if own is not None)
    over = ours / limit if limit is not None else None
    cells = [title(work), in_units(plain), in_units(prepared), in_units(best), fastest.replace("_", " "), in_units(limit)]
    cells += [faster(plain, goals[0]), faster(prepared, goals[1])]
    cells.append(ratio(over, goals[2], goals[2] is None or over is None or over <= goals[2]))
    return "| " + " | ".join(cells) + " |"


def place(work):
    """The works in the order of GOALS, then by name, and by growing numbers."""
    name, *parameters = work.split("/")
    order = list(GOALS).index(name) if name in GOALS else len(GOALS)
    numbers = dict(parameter.split(":") for parameter in parameters)
    return order, name, int(numbers.get("rational", 0)), int(numbers.get("p", 3)), int(numbers["n"])


def table(times):
    head = ["work", "Batten", "prepared", "best peer", "which", "limit", "peer / Batten", "peer / prepared", "ours / limit"]
    rows = [table_row(work, times[work]) for work in sorted(times, key=place) if any(name in times[work] for name in OURS)]
    return "\n".join(["| " + " | ".join(head) + " |", "|---|" + "---|" * (len(head) - 1), *rows]) + "\n"


def processor():
    names = re.findall(r"model name\s*: (.*)", pathlib.Path("/proc/cpuinfo").read_text())
    return names[0] if names else "unknown processor"


def write_readme(file, times):
    path = pathlib.Path(file)
    before, rest = path.read_text().split(BEGIN)
    after = rest.split(END)[1]
    path.write_text(f"{before}{BEGIN}\nOn one core of: {processor()}.\n\n{table(times)}\n{END}{after}")


def n_of(work):
    return int(re.search(r"n:(\d+)", work).group(1))


def plot(name, works, times, file):
    libraries = [library for library in OURS + PEERS + LIMITS if any(library in times[work] for work in works)]
    blocks = []
    for library in libraries:
        points = sorted((n_of(work), times[work][library]) for work in works if library in times[work])
        blocks.append("\n".join(f"{n} {seconds:.6g}" for n, seconds in points))
    curves = ", ".join(
        f"$data index {i} with linespoints lw {3 if library in OURS else 1.5} title '{library.replace('_', ' ')}'"
        for i, library in enumerate(libraries)
    )
    data = "\n\n\n".join(blocks)
    script = f"""set terminal svg size 640,420 font 'sans,13' background '#ffffff'
set output '{file}'
set title '{name.replace("_", " ")}'
set logscale xy
set xlabel 'n'
set ylabel 'seconds'
set format y '10^{{%T}}'
set format x '10^{{%T}}'
set grid
set key outside right
$data << END
{data}
END
plot {curves}
"""
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def write_plots(folder, times):
    families = {}
    for work in times:
        name = re.sub(r"/n:\d+", "", work)
        families.setdefault(name, []).append(work)
    path = pathlib.Path(folder)
    path.mkdir(parents=True, exist_ok=True)
    for name, works in families.items():
        if len(works) > 2:
            short = name.split("/")[0]
            plot(short, works, times, path / f"{short}.svg")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("times", nargs="+")
    parser.add_argument("--readme")
    parser.add_argument("--plots")
    arguments = parser.parse_args()
    times = read_times(arguments.times)
    if arguments.plots:
        write_plots(arguments.plots, times)
    if arguments.readme:
        write_readme(arguments.readme, times)
    else:
        print(table(times), end="")


if __name__ == "__main__":
    main()
