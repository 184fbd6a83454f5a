"""Frames a second of the real window while the sample plays: frames.py BINARY. Runs on a virtual display of 1440 x 900."""

import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "tests" / "e2e"))

from driver import Display, Editor  # noqa: E402


def measure(editor, readings):
    """The next figures that the editor itself reports, one for each half second of playing."""
    editor.click_widget("play")
    figure = 0.0
    for _ in range(readings):
        figure = editor.wait(lambda state: state["frames_per_second"] != figure, "a new figure")["frames_per_second"]
        yield figure
    editor.click_widget("play")


def main():
    with tempfile.TemporaryDirectory() as folder, Display() as display:
        with Editor(sys.argv[1], display, folder, ["--example", "wave"]) as editor:
            print(" ".join(f"{figure:.1f}" for figure in measure(editor, 8)))


if __name__ == "__main__":
    main()
