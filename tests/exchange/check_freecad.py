"""What FreeCAD (OpenCASCADE) reads from our STEP and IGES files, against given.json: check_freecad.py FOLDER"""
import json
import os
import sys

sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
import FreeCAD  # noqa: E402, F401 (Part needs it)
import Part  # noqa: E402

folder = sys.argv[1]
given = json.load(open(os.path.join(folder, "given.json")))
failed = 0


def expect(true, words):
    global failed
    print(("ok      " if true else "BROKEN  ") + words)
    failed += not true


def read(name):
    return Part.read(os.path.join(folder, name))


def surface_poles(surface):
    """in our order: rows along u, one row for each pole of v"""
    poles, weights = surface.getPoles(), surface.getWeights()
    return ([tuple(poles[i][j]) for j in range(len(poles[0])) for i in range(len(poles))],
            [weights[i][j] for j in range(len(poles[0])) for i in range(len(poles))])


def largest_gap(found, expected):
    if len(found) != len(expected):
        return float("inf")
    return max(abs(a - b) for p, q in zip(found, expected) for a, b in zip(p, q))


def check_poles(name, what, found, weights):
    expected = given[what]
    gap = largest_gap(found, expected["poles"])
    expect(gap <= 1e-9, f"{name}: {what}: {len(found)} poles, largest gap {gap:.1e} mm")
    if expected["weights"]:
        gap = max(abs(a - b) for a, b in zip(weights, expected["weights"]))
        expect(gap <= 1e-12, f"{name}: {what}: weights, largest gap {gap:.1e}")


def spline_of(face):
    surface = face.Surface
    return surface if isinstance(surface, Part.BSplineSurface) else surface.toBSpline()


def check_shapes(name):
    shape = read(name)
    for what, pole_count in (("loft", len(given["loft"]["poles"])), ("cylinder", 18)):
        splines = [spline_of(f) for f in shape.Faces if isinstance(f.Surface, Part.BSplineSurface)]
        splines = [s for s in splines if s.NbUPoles * s.NbVPoles == pole_count]
        expect(len(splines) == 1, f"{name}: {what}: {len(splines)} face")
        if len(splines) == 1:
            check_poles(name, what, *surface_poles(splines[0]))
    curves = [e.Curve for e in shape.Edges if isinstance(e.Curve, Part.BSplineCurve)]
    for what in ("curve", "arc"):
        same = [c for c in curves if c.NbPoles == len(given[what]["poles"])
                and largest_gap([tuple(p) for p in c.getPoles()], given[what]["poles"]) <= 1e-9]
        expect(len(same) >= 1, f"{name}: {what}: {len(same)} of {len(curves)} spline edges")
        if same:
            check_poles(name, what, [tuple(p) for p in same[0].getPoles()], same[0].getWeights())


def check_solids(name, volumes):
    shape = read(name)
    expect(len(shape.Solids) == len(volumes), f"{name}: {len(shape.Solids)} solids")
    for (what, volume), solid in zip(volumes.items(), shape.Solids):
        expect(solid.isValid() and solid.isClosed(), f"{name}: {what}: valid and closed")
        solid.check(True)  # raises where OpenCASCADE's analyser finds a fault
        error = abs(solid.Volume / volume - 1)
        expect(error < 1e-9, f"{name}: {what}: volume {solid.Volume:.6f} mm3, relative error {error:.1e}")
        expect(all(e.Tolerance <= 1e-6 for e in solid.Edges + solid.Vertexes),
               f"{name}: {what}: edges and vertices within {max(e.Tolerance for e in solid.Edges + solid.Vertexes):.1e} mm")


for name in ("parts.step", "parts-242.step", "parts.igs"):
    check_shapes(name)
patch = read("patch.step")
expect(len(patch.Faces) == 1 and len(patch.Edges) == 4 and len(patch.Vertexes) == 4, "patch.step: 4 edges, 4 vertices")
check_poles("patch.step", "patch", *surface_poles(patch.Faces[0].Surface))
for name in ("solids.step", "solids-242.step"):
    check_solids(name, given["volume"])
for name, volumes in given.get("mould", {}).items():
    check_solids(name, volumes)
sys.exit(1 if failed else 0)
