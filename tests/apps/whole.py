"""whole.py FOLDER [--partial]: every result of `wirecut simulate` in FOLDER is there, whole and consistent.

--partial: a cut that ended early; the surface is there where two stations are.
"""
import csv
import json
import math
import os
import struct
import sys
import xml.etree.ElementTree as ElementTree

SURFACE = ["surface.stl", "surface.obj", "surface.ply", "surface.glb", "path.csv", "surface.step"]
COLUMNS = ("station,time_s,phase,a_x_mm,a_y_mm,a_z_mm,b_x_mm,b_y_mm,b_z_mm,speed_a_mm_s,speed_b_mm_s,tension_a_N,"
           "tension_b_N,alpha_a_deg,beta_a_deg,alpha_b_deg,beta_b_deg").split(",")
folder, partial = sys.argv[1], "--partial" in sys.argv


def expect(condition, text):
    if not condition:
        sys.exit(f"{folder}: {text}")


def read(name):
    with open(os.path.join(folder, name), "rb") as file:
        return file.read()


def check_stl():
    data = read("surface.stl")
    (count,) = struct.unpack_from("<I", data, 80)
    expect(len(data) == 84 + 50 * count and count > 0, f"surface.stl: {len(data)} bytes for {count} triangles")
    expect(not data.startswith(b"solid") and b"mm" in data[:80], "surface.stl: the header does not say mm")
    for k in range(0, count, max(1, count // 100)):
        numbers = struct.unpack_from("<12f", data, 84 + 50 * k)
        expect(all(map(math.isfinite, numbers)), f"surface.stl: triangle {k} is not finite")
    return count


def check_obj(triangles):
    lines = read("surface.obj").decode("ascii").split("\n")
    expect(lines[-1] == "", "surface.obj: the last line does not end")
    vertices = sum(line.startswith("v ") for line in lines)
    faces = [line for line in lines if line.startswith("f ")]
    expect(len(faces) == triangles, f"surface.obj: {len(faces)} faces, surface.stl has {triangles}")
    expect(any("mm" in line or "millimet" in line for line in lines if line.startswith("#")), "surface.obj: no unit")
    highest = max(int(corner.split("/")[0]) for line in faces for corner in line.split()[1:])
    expect(highest == vertices, f"surface.obj: faces name vertex {highest} of {vertices}")
    return vertices


def check_ply(vertices, triangles):
    data = read("surface.ply")
    end = data.index(b"end_header\n") + len(b"end_header\n")
    header = data[:end].decode("ascii").split("\n")
    expect(f"element vertex {vertices}" in header and f"element face {triangles}" in header, "surface.ply: counts")
    expect(any("red" in line for line in header), "surface.ply: no vertex colour")
    expect(any("force" in line for line in header if line.startswith("property")), "surface.ply: no force")
    size = {"double": 8, "float": 4, "uchar": 1, "int": 4, "uint": 4, "uint8": 1, "int32": 4, "float64": 8}
    vertex, element = 0, ""
    for line in header:
        words = line.split()
        if words[:1] == ["element"]:
            element = words[1]
        elif words[:1] == ["property"] and element == "vertex":
            vertex += size[words[1]]
    expect(len(data) == end + vertices * vertex + triangles * 13, f"surface.ply: {len(data)} bytes")


def check_glb():
    data = read("surface.glb")
    magic, version, length = struct.unpack_from("<4sII", data)
    expect(magic == b"glTF" and version == 2 and length == len(data), "surface.glb: header")
    size, kind = struct.unpack_from("<I4s", data, 12)
    expect(kind == b"JSON", "surface.glb: first chunk")
    expect(json.loads(data[20:20 + size])["meshes"], "surface.glb: no mesh")


def check_step():
    text = read("surface.step").decode("ascii")
    expect(text.startswith("ISO-10303-21;\n") and text.endswith("END-ISO-10303-21;\n"), "surface.step: not whole")
    expect("(.MILLI.,.METRE.)" in text, "surface.step: no millimetres")
    expect(text.count("B_SPLINE_SURFACE_WITH_KNOTS(") == 1, "surface.step: no surface")
    for mount in "AB":
        expect(f"PRODUCT('path of mount {mount}'" in text, f"surface.step: no path of mount {mount}")


def check_vtp(stations, nodes):
    data = read("history.vtp")
    start = data.index(b"<AppendedData")
    first = data.index(b"_", start) + 1
    last = data.rindex(b"</AppendedData>")
    tree = ElementTree.fromstring(data[:first - 1] + data[last:])
    piece = tree.find("PolyData/Piece")
    expect(int(piece.get("NumberOfPoints")) == stations * nodes, "history.vtp: points")
    expect(int(piece.get("NumberOfLines")) == stations, "history.vtp: lines")
    for array in tree.iter("DataArray"):
        (size,) = struct.unpack_from("<Q", data, first + int(array.get("offset")))
        expect(first + int(array.get("offset")) + 8 + size <= last, f"history.vtp: {array.get('Name')} is cut off")
    points = next(piece.find("Points").iter("DataArray"))
    values = struct.unpack_from(f"<{3 * stations * nodes}d", data, first + int(points.get("offset")) + 8)
    expect(all(map(math.isfinite, values)), "history.vtp: a position is not finite")


def check_csv(stations):
    rows = list(csv.reader(line for line in read("path.csv").decode("utf-8").splitlines() if line[:1] != "#"))
    expect(rows[0] == COLUMNS, f"path.csv: columns {rows[0]}")
    expect(len(rows) == stations + 1, f"path.csv: {len(rows) - 1} rows for {stations} stations")
    for row in rows[1:]:
        expect(row[2] in ("approach", "entry", "steady", "exit", "left"), f"path.csv: phase {row[2]}")
        expect(all(math.isfinite(float(text)) for k, text in enumerate(row) if k != 2), f"path.csv: {row}")
    times = [float(row[1]) for row in rows[1:]]
    expect(all(a < b for a, b in zip(times, times[1:])), "path.csv: time does not increase")


summary = json.loads(read("summary.json"))
expect(summary["format"] == "wirecut-summary/1", "summary.json: format")
for key in "job integrator stations nodes duration_s speed_mm_s alpha_deg force_N_per_mm residual iterations".split():
    expect(key in summary, f"summary.json: no {key}")
files = sorted(summary["files"])
expect(files == sorted(name for name in os.listdir(folder)), f"summary.json lists {files}, there are {os.listdir(folder)}")
stations, nodes = summary["stations"], summary["nodes"]
expect(stations >= 2 or partial, "summary.json: stations")
check_vtp(stations, nodes)
if stations >= 2:
    expect(set(SURFACE) < set(files), f"summary.json: files {files}")
    triangles = check_stl()
    check_ply(check_obj(triangles), triangles)
    check_glb()
    check_step()
    check_csv(stations)
