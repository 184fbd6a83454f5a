"""The teaching views as docs/tour.md shows them: which example, which overlays, what is done, what is then on screen.

views.py BINARY [NAME...] takes the pictures of docs/tour, and of assets/screenshots where no NAME is given; see scripts/tour.
"""

import contextlib
import dataclasses
import json
import pathlib
import subprocess
import sys
import tempfile

from driver import Display, Editor

ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "assets" / "examples"
BASIC = ("polygon", "knots", "labels", "grid")
TOUR = ROOT / "docs" / "tour"
SCREENSHOTS = ROOT / "assets" / "screenshots"
PICTURE_SIZE = (1280, 720)
SCREENSHOT_SIZE = (1440, 900)
WITHOUT_CARD = ("hull", "construction", "bezier-pieces", "curvature-comb", "hodograph", "second-hodograph", "curvature-plot", "speed-plot", "other-polygons")


@dataclasses.dataclass(frozen=True)
class View:
    """One picture of the tour."""

    name: str
    example: str
    overlays: tuple = ()  # beside the basic ones
    says: tuple = ()  # texts of the canvas, the plot or the cards that it adds, or parts of them
    parameter: float | None = None
    notation: dict = dataclasses.field(default_factory=dict)
    commands: tuple = ()  # typed into the palette
    hover: str | None = None  # the widget, or the number of the control point, at which the pointer rests
    is_light: bool = False
    has_inspector: bool = False
    is_presented: bool = False

    def cards(self):
        return [overlay for overlay in self.overlays if overlay not in WITHOUT_CARD]

    def plain(self):
        """The same example without the view."""
        overlays = tuple(overlay for overlay in self.overlays if overlay == "construction")
        return dataclasses.replace(self, overlays=overlays, commands=(), hover=None)


CONSTRUCTION = (
    View("triangle", "cubic-de-boor", ("construction", "triangle"), ("7/15 P₂ + 8/15 P₃", "8/15 P_{3}", "P_{4}^{2}"),
         hover="card triangle cell 1 1"),
    View("triangle-rational", "conic-weight", ("construction", "triangle"), ("0.586 P₀ + 0.414 P₁", "1/2 w_{2}^{1} P_{2}^{1}"),
         hover="card triangle cell 2 0", is_light=True),
    View("halves", "bezier-cubic", ("construction", "halves"), ("P₀, P₁¹, P₂², C(u)", "C(u), P₃², P₃¹, P₃")),
    View("by-insertion", "cubic-de-boor", ("construction", "by-insertion"), ("C(u)", "P₃², P₄²"), is_light=True),
    View("blossoms", "cubic-de-boor", ("construction", "blossoms"), ("f(u_{3}, u_{4}, u)", "2/5 f(u₄, u, u)")),
)
INSERTION = (
    View("corner-cutting", "knot-insertion", ("corner-cutting",), ("α = 5/6", "α = 1/2", "α = 1/6", "Q₅ = 5/6 P₄ + 1/6 P₅"),
         is_light=True),
    View("polygon-distance", "wave", ("polygon-distance",), ("2.241", "0.0613")),
    View("bezier-points", "cubic-de-boor", ("bezier-pieces", "bezier-points"), ("b_{12}", "f(1/4, 1/4, 1/2)", "(−7/6, 3/2)"),
         is_light=True),
)
BASIS = (
    View("recurrence", "coons-open", ("recurrence",), ("235/384", "11/16"), hover="card recurrence cell 2 1"),
    View("basis-pieces", "coons-open", ("basis-pieces",), ("(3u³ − 6u² + 4)/6", "t³/6"), is_light=True),
    View("basis-values", "cubic-de-boor", ("basis-values", "basis-derivatives"), ("sum 1", "N_{3,3} = 202/375", "9/250")),
    View("rational-basis", "circle-nurbs", ("rational-basis",), ("0.2929", "0.4142"), is_light=True),
)
SHAPE = (
    View("continuity", "knots-t4", ("continuity",), ("C′(u−)", "C″(u+)", "(9/2, 15/2)", "130.6°"), parameter=2.0),
    View("curvature", "wave", ("curvature-comb", "curvature-marks", "curvature-plot", "speed-plot"),
         ("max κ = 1.23", "κ = 0", "|C′| = 19.65"), is_light=True),
    View("osculating-circle", "wave", ("osculating-circle", "tangent-normal"), ("ρ = 0.8189", "T", "N"), parameter=0.6),
    View("steps", "cubic-at-4-5", ("equal-steps", "equal-lengths"), ("1/10", "17.5586 = 10 × 1.75586"), is_light=True),
    View("hodographs", "cubic-de-boor", ("hodograph", "second-hodograph", "end-derivatives"),
         ("C′(0)", "C″(1)", "(18, 57)", "(216, −216)")),
    View("span-hulls", "quadratic-double-knot", ("hull", "span-hulls"), ("P₁, ..., P₃",), is_light=True),
    View("support", "knots-t1", ("support",), ("u = 0", "u = 5"), hover="4"),
    View("variation", "wave", ("variation",), ("1 ≤ 3",), commands=("put-line -5 3.9 5 -0.1",), is_light=True),
)
CUBICS = (
    View("cubic-conditions", "coons-open", ("cubic-conditions",), ("1/6 = 1/6",)),
    View("cubic-matrix", "coons-open", ("cubic-matrix",), ("9/128", "235/384"), is_light=True),
    View("anticentroids", "coons-closed", ("anticentroids",), ("S″", "2/3", "(−10/3, 2/3)")),
    View("ferguson", "coons-closed", ("ferguson",), ("Q_{0}′", "(−13/4, −1)"), is_light=True),
    View("joined-cubics", "coons-joined", ("joined-cubics", "other-polygons"), ("Q_{1}", "C″/2", "(−1, −10)")),
    View("end-vertices", "coons-open", ("end-vertices",), ("2 P_{0} − P_{1}", "triple", "(5 P₀ + P₁)/6"), is_light=True),
)
WEIGHTS = (
    View("farin-points", "wave", ("farin-points",), ("F_{5}", "1 : 2"), parameter=0.8),
    View("conic", "conic-weight", ("conic",), ("0.4142", "45°", "M", "X"), is_light=True),
    View("homogeneous", "circle-nurbs", ("homogeneous",), ("w = 1", "(√2/2, √2/2, √2/2)")),
)
QUESTIONS = (
    View("invariance", "wave", ("invariance",), ("M(C(u))",), commands=("show-map project",), is_light=True),
    View("knot-questions", "knots-t4", ("knot-questions",), ("15 − 3 − 1 = 11",)),
    View("quiz", "knots-t2", ("quiz",), ("(0, 0, 0, 0, 0, 1, 1, 1, 1, 1)",), commands=("knot-quiz 4",), is_light=True),
)
TEACHING = (
    View("notation", "cubic-de-boor", ("construction", "triangle"), ("V₂¹ = 7/15 V₂ + 8/15 V₃",), has_inspector=True,
         notation={"points": "V", "parameter": "t", "degree": "order", "triangles": "first", "numbers": "fractions"}),
    View("lesson", "wave", commands=("open-lesson multiplicity-and-continuity", "next-step", "next-step"), is_light=True),
    View("presenting", "cubic-de-boor", ("construction", "triangle"), ("P_{4}^{2}",), hover="card triangle cell 1 1",
         is_presented=True),
)
VIEWS = CONSTRUCTION + INSERTION + BASIS + SHAPE + CUBICS + WEIGHTS + QUESTIONS + TEACHING


def document(view):
    """The example's document with the view on."""
    content = json.loads((EXAMPLES / f"{view.example}.json").read_text())
    for member in ("title", "description"):
        content.pop(member, None)
    content["view"]["overlays"] = [*BASIC, *view.overlays]
    if view.parameter is not None:
        content["view"]["parameter"] = view.parameter
    if view.notation:
        content["view"]["notation"] = view.notation
    return content


def run_typed(editor, text):
    editor.key("ctrl+p")
    editor.wait(lambda state: state["dialog"] == "command-palette", "the palette")
    editor.type(text)
    editor.key("Return")
    editor.wait(lambda state: state["dialog"] == "none" and state["is_settled"], f"the end of '{text}'")


def rest_pointer(view, editor):
    """At what the view is about, else in a corner of the canvas."""
    state = editor.settle()
    if view.hover is None:
        place = state["canvas"]["x"] + 3, state["canvas"]["y"] + 3
    else:
        place = editor.point(int(view.hover)) if view.hover.isdigit() else editor.widget_center(view.hover)
    editor.move(*place)
    return editor.settle()


def present(editor, display):
    editor.key("F11")
    editor.wait(lambda state: state["canvas"]["width"] == display.size[0] and state["is_settled"], "the whole screen")


@contextlib.contextmanager
def shown(view, binary, display, artifacts):
    """The editor with the view on, after what is done in it."""
    width, height = display.size
    settings = {
        "window": {"x": 0, "y": 0, "width": width, "height": height},
        "theme": "light" if view.is_light else "dark",
        "inspector_is_open": view.has_inspector,
    }
    with tempfile.TemporaryDirectory(prefix="batten-view-") as folder:
        path = pathlib.Path(folder) / f"{view.example}.json"
        path.write_text(json.dumps(document(view)))
        with Editor(binary, display, artifacts, [path], settings=settings) as editor:
            for command in view.commands:
                run_typed(editor, command)
            if view.is_presented:
                present(editor, display)
            rest_pointer(view, editor)
            yield editor


def shrink(picture, colors=128):
    # A palette without dithering keeps the folder small, and the picture the same in every run.
    subprocess.run(["convert", picture, "+dither", "-colors", str(colors), "-strip", f"PNG8:{picture}"], check=True)


def take_picture(editor, name):
    picture = editor.screenshot(name)
    shrink(picture)
    print(picture)


def take_screenshots(binary):
    """Of the editor without views: a cell of the construction lit, and two knots merged."""
    view = View("dark", "wave", ("hull", "construction"), hover="cell 1 1", has_inspector=True)
    with Display(*SCREENSHOT_SIZE) as display:
        with shown(view, binary, display, SCREENSHOTS) as editor:
            take_picture(editor, "dark")
        with shown(dataclasses.replace(view, hover=None, is_light=True), binary, display, SCREENSHOTS) as editor:
            editor.drag(editor.strip_knot(5), editor.strip_knot(4))
            take_picture(editor, "light")


def main():
    binary, *names = sys.argv[1:]
    with Display(*PICTURE_SIZE) as display:
        for view in VIEWS:
            if not names or view.name in names:
                with shown(view, binary, display, TOUR) as editor:
                    take_picture(editor, view.name)
    if not names:
        take_screenshots(binary)


if __name__ == "__main__":
    main()
