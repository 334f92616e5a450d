"""What FreeCAD (OpenCASCADE) finds in the STEP halves that wirecut mould wrote: check_mould.py FOLDER LABEL"""
import json
import os
import sys

import FreeCAD  # noqa: F401 (Part needs it)
import Part
from freecad_faults import find_faults

folder, label = sys.argv[1:]
mould = json.load(open(os.path.join(folder, "mould.json")))
failed = 0


def expect(true, words):
    global failed
    print(("ok      " if true else "BROKEN  ") + folder + ": " + words)
    failed += not true


total = 0
for half in ("lower", "upper"):
    name, given = label + half + ".step", mould[half]
    shape = Part.read(os.path.join(folder, name))
    expect(len(shape.Solids) == 1, f"{name}: {len(shape.Solids)} solid, {len(shape.Faces)} faces")
    solid = shape.Solids[0]
    faults = find_faults(solid)
    expect(solid.isValid() and solid.isClosed() and not faults, f"{name}: valid and closed, {sorted(faults) or 'no faults'}")
    expect(len(solid.Faces) == given["exact_faces"], f"{name}: {given['exact_faces']} faces")
    # triangles are within their chord tolerance of the exact faces
    error = abs(solid.Volume / given["volume_mm3"] - 1)
    expect(error < 1e-4, f"{name}: volume {solid.Volume:.3f} mm3, the triangles' differs by {error:.1e}")
    # the faces that are not cut end at vertices: their box is that of the triangles, in millimetres
    corner = [v.Point for v in solid.Vertexes]
    low, high = given["box_mm"]
    gap = max(max(abs(max(p[k] for p in corner) - high[k]), abs(min(p[k] for p in corner) - low[k])) for k in (0, 1))
    expect(gap < 1e-6, f"{name}: {high[0]:.9g} x {high[1]:.9g} mm to {gap:.1e}")
    total += solid.Volume
if mould["kerf_mm"]["max"] == 0:
    keys = mould["lower"]["keys_mm3"] + mould["upper"]["keys_mm3"]
    error = abs(total / (mould["block_volume_mm3"] + keys) - 1)
    expect(error < 1e-6, f"both halves are the block to {error:.1e}")
sys.exit(1 if failed else 0)
