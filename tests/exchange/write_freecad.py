"""Curves as FreeCAD (OpenCASCADE) writes them, and what they are: a line each with ends and length. write_freecad.py FOLDER

freecad.step, freecad.igs: an edge each. wire.igs, wire.step: one edge of a mould as a CAD system has it, of lines, arcs
and a spline end to end, turned in space: IGES writes it as a composite curve with transformations. edges.step,
edges.igs: a spline and an arc for samples/mould.c."""
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
    Part.Ellipse(V(5, 6, 7), 30, 10).toShape(0.3, 2.9),
    Part.Circle(V(7, 8, 9), V(1, 2, 2), 25).toShape(0.5, 4),
]


def write(name, shape, expected):
    shape.exportStep(os.path.join(folder, name + ".step"))
    shape.exportIges(os.path.join(folder, name + ".igs"))
    with open(os.path.join(folder, name + ".txt"), "w") as file:
        for ends, length in expected:
            file.write(" ".join(repr(x) for p in ends for x in p) + f" {length!r}\n")


def ends_of(edge):
    return [edge.valueAt(edge.FirstParameter), edge.valueAt(edge.LastParameter)]


write("freecad", Part.makeCompound(edges), [(ends_of(e), e.Length) for e in edges])
bend = Part.BSplineCurve()
bend.interpolate([V(0, 400, 100), V(5, 480, 130), V(-2, 560, 90), V(0, 600, 100)])
parts = [
    Part.LineSegment(V(0, 0, 100), V(0, 150, 100)).toShape(),
    Part.Arc(V(0, 150, 100), V(0, 200, 120), V(0, 250, 100)).toShape(),
    Part.LineSegment(V(0, 250, 100), V(0, 400, 100)).toShape(),
    bend.toShape(),
]
wire = Part.Wire(parts)
wire.Placement = FreeCAD.Placement(V(10, 20, 30), FreeCAD.Rotation(V(1, 2, 3), 40))
ends = [wire.Placement.multVec(V(0, 0, 100)), wire.Placement.multVec(V(0, 600, 100))]
write("wire", wire, [(ends, wire.Length)])
edge = Part.BSplineCurve()
edge.interpolate([V(0, 0, 150), V(0, 250, 195), V(0, 500, 160), V(0, 900, 130)])
pair = [edge.toShape(), Part.Arc(V(400, 0, 140), V(400, 450, 190), V(400, 900, 140)).toShape()]
write("edges", Part.makeCompound(pair), [(ends_of(e), e.Length) for e in pair])
