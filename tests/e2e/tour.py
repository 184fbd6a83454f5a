"""A short tour of the editor on a virtual display: tour.py BINARY FOLDER [FILE...]. Leaves screenshots in FOLDER and prints their paths."""

import sys

from driver import Display, Editor


def play(editor):
    """Yields the screenshots, in order."""
    yield editor.screenshot("1-open")

    x, y = editor.point(2)
    editor.drag((x, y), (x + 60, y + 40), release=False)
    yield editor.screenshot("2-drag-a-point")
    editor.release()

    knots = editor.state()["strip_knots"]
    inner = [knot for knot in knots if knots[0]["x"] < knot["x"] < knots[-1]["x"]]
    if len(inner) > 1:
        editor.drag(editor.strip_knot(inner[0]["index"]), editor.strip_knot(inner[1]["index"]))
        yield editor.screenshot("3-merge-two-knots")

    cells = [name for name in editor.state()["widgets"] if name.startswith("cell 1 ")]
    if cells:
        editor.move(*editor.widget_center(cells[0]))
        yield editor.screenshot("4-read-the-construction")

    editor.key("t")
    editor.wait(lambda state: state["theme"] == "light" and state["is_settled"], "the light theme")
    yield editor.screenshot("5-light-theme")


def main():
    binary, folder, *files = sys.argv[1:]
    arguments = files or ["--example", "wave"]
    with Display() as display, Editor(binary, display, folder, arguments) as editor:
        for path in play(editor):
            print(path)


if __name__ == "__main__":
    main()
