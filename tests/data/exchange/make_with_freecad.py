"""Writes the files of FreeCAD that stand beside this one: /usr/bin/python3 make_with_freecad.py FOLDER (Debian: freecad-python3)."""

import sys

sys.path.append("/usr/lib/freecad-python3/lib")
import FreeCAD  # noqa: E402
import Import  # noqa: E402,F401
import Part  # noqa: E402

V = FreeCAD.Vector
folder = sys.argv[1]


def spline(points, multiplicities, knots, degree, weights=None, periodic=False):
    curve = Part.BSplineCurve()
    curve.buildFromPolesMultsKnots(points, multiplicities, knots, periodic, degree, weights or [1.0] * len(points))
    return curve


points = [V(0, 0, 0), V(10, 25, 0), V(30, -5, 0), V(40, 20, 0), V(60, 0, 0)]
curves = {
    "spline": spline(points, [4, 1, 4], [0, 0.3, 1], 3),
    "weights": spline(points, [4, 1, 4], [0, 0.3, 1], 3, [1, 5, 0.5, 2, 1]),
    "periodic": spline(points, [1] * 6, [0, 1, 2, 3, 4, 5.5], 3, periodic=True),
    "double": spline(points, [3, 2, 3], [0, 0.5, 1], 2),
}
shapes = {name: curve.toShape() for name, curve in curves.items()}
shapes["line"] = Part.makeLine(V(1, 2, 0), V(4, 6, 0))
shapes["arc"] = Part.Arc(V(5, 0, 0), V(0, 5, 0), V(-5, 0, 0)).toShape()
shapes["circle"] = Part.makeCircle(2.5, V(1, 1, 0))
shapes["ellipse"] = Part.Ellipse(V(0, 0, 0), 6, 3).toShape()
shapes["raised"] = Part.makeLine(V(0, 0, 7), V(1, 1, 7))
shapes["upright"] = Part.makeCircle(2, V(0, 0, 0), V(1, 0, 0))
shapes["in space"] = spline([point + V(0, 0, i) for i, point in enumerate(points)], [4, 1, 4], [0, 0.3, 1], 3).toShape()
compound = Part.makeCompound(list(shapes.values()))
compound.exportStep(f"{folder}/freecad.step")
compound.exportIges(f"{folder}/freecad.igs")
Part.makeBox(10, 20, 30).exportStep(f"{folder}/freecad-box.step")
