"""Curves as FreeCAD (OpenCASCADE) writes them, with where they begin, are in the middle and end: write_freecad.py FOLDER"""
import json
import os
import sys

sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
import FreeCAD  # noqa: E402
import Part  # noqa: E402

folder = sys.argv[1]
V = FreeCAD.Vector
spline = Part.BSplineCurve()
spline.interpolate([V(0, 0, 100), V(3.1, 200.7, 130), V(-2, 400, 90), V(0, 600, 100)])
rational = Part.BSplineCurve()
rational.buildFromPolesMultsKnots([V(400, 0, 100), V(400, 300, 200), V(400, 600, 100)], [3, 3], [0, 1], False, 2,
                                  [1, 0.5, 1])
edges = [
    spline.toShape(),
    rational.toShape(),
    Part.LineSegment(V(1, 2, 3), V(40, 50, 60)).toShape(),
    Part.Arc(V(10, 0, 5), V(0, 10, 5), V(-10, 0, 5)).toShape(),
    spline.toShape(spline.FirstParameter + 0.2, spline.LastParameter - 0.3),
]
shape = Part.makeCompound(edges)
shape.exportStep(os.path.join(folder, "freecad.step"))
shape.exportIges(os.path.join(folder, "freecad.igs"))
with open(os.path.join(folder, "freecad.txt"), "w") as file:
    for e in edges:
        ends = [e.valueAt(e.FirstParameter), e.valueAt(e.LastParameter)]
        file.write(" ".join(repr(x) for p in ends for x in p) + f" {e.Length!r}\n")
