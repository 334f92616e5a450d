"""What FreeCAD (OpenCASCADE) reads from our STEP and IGES files, against given.json: check_freecad.py FOLDER"""
import json
import os
import sys

sys.path += ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/lib"]
import FreeCAD  # noqa: E402, F401 (Part needs it)
import Part  # noqa: E402
from freecad_faults import find_faults  # noqa: E402

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


def check_pieces(name, what, splines):
    """Every pole and weight of ours is in a piece, and the pieces have no others: OpenCASCADE cuts what it reads from
    IGES where a knot makes it continuous in position alone; at such a knot nothing moves."""
    expected = {(*p, w) for p, w in zip(given[what]["poles"], given[what]["weights"])}
    found = set()
    for poles, weights in splines:
        found |= {(*p, w) for p, w in zip(poles, weights)}
    missing = [e for e in expected if not any(max(abs(a - b) for a, b in zip(e, f)) <= 1e-9 for f in found)]
    expect(not missing, f"{name}: {what}: {len(missing)} of {len(expected)} poles missing in {len(splines)} pieces")


def check_iges(name):
    shape = read(name)
    faces = [f.Surface for f in shape.Faces if isinstance(f.Surface, Part.BSplineSurface)]
    loft = [s for s in faces if s.NbUPoles * s.NbVPoles == len(given["loft"]["poles"])]
    expect(len(loft) == 1, f"{name}: loft: {len(loft)} face")
    check_poles(name, "loft", *surface_poles(loft[0]))
    check_pieces(name, "cylinder", [surface_poles(s) for s in faces if s.NbUPoles * s.NbVPoles < 19])
    curves = [e.Curve for e in shape.Edges if isinstance(e.Curve, Part.BSplineCurve)]
    curve = [c for c in curves if c.NbPoles == len(given["curve"]["poles"])]
    expect(len(curve) == 1, f"{name}: curve: {len(curve)} edge")
    check_poles(name, "curve", [tuple(p) for p in curve[0].getPoles()], curve[0].getWeights())
    check_pieces(name, "arc", [([tuple(p) for p in c.getPoles()], c.getWeights()) for c in curves if c.isRational()])


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


def check_solids(name, volumes, tolerance):
    shape = read(name)
    expect(len(shape.Solids) == len(volumes), f"{name}: {len(shape.Solids)} solids")
    for (what, volume), solid in zip(volumes.items(), shape.Solids):
        expect(solid.isValid() and solid.isClosed(), f"{name}: {what}: valid and closed, {len(solid.Faces)} faces")
        faults = find_faults(solid)
        expect(not faults, f"{name}: {what}: the analyser finds {sorted(faults) or 'nothing'}")
        error = abs(solid.Volume / volume - 1)
        expect(error < tolerance, f"{name}: {what}: volume {solid.Volume:.6f} mm3, relative error {error:.1e}")
        slack = max(e.Tolerance for e in solid.Edges + solid.Vertexes)
        expect(slack <= 1e-6, f"{name}: {what}: edges and vertices within {slack:.1e} mm")
    return sum(s.Volume for s in shape.Solids)


for name in ("parts.step", "parts-242.step"):
    check_shapes(name)
check_iges("parts.igs")
patch = read("patch.step")
expect(len(patch.Faces) == 1 and len(patch.Edges) == 4 and len(patch.Vertexes) == 4, "patch.step: 4 edges, 4 vertices")
check_poles("patch.step", "patch", *surface_poles(patch.Faces[0].Surface))
for name in ("solids.step", "solids-242.step"):
    check_solids(name, given["volume"], 1e-9)
# triangles are within 0.1 mm of the exact faces; the exact halves and their keys make up the block
total = check_solids("mould.step", {half: given[half]["volume"] for half in ("lower", "upper")}, 1e-4)
error = abs(total / (given["mould"]["block"] + given["mould"]["keys"]) - 1)
expect(error < 1e-6, f"mould.step: both halves less their keys are the block, relative error {error:.1e}")
sys.exit(1 if failed else 0)
