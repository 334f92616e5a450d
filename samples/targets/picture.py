#!/usr/bin/env python3
"""Draw a saddle, the cut that wirecut design finds for it, and the deviation, as saddle.svg.

picture.py DIR: DIR is what `wirecut design saddle.ply ... -o DIR --formats obj` wrote, fed along +y."""
import json
import math
import os
import sys

from make import L, W, saddle

SIZE, GAP, SCALE = 300, 30, 0.42
STEPS_X, STEPS_Y = 20, 30
COLOURS = [(0, 79, 155), (57, 116, 179), (110, 153, 201), (163, 189, 219), (225, 225, 225), (215, 177, 159), (193, 133, 102), (167, 90, 46), (139, 44, 0)]


def colour(value, limit):
    """Blue below, grey at 0, orange above, as in the reports."""
    at = (max(-1.0, min(1.0, value / limit)) + 1) * (len(COLOURS) - 1) / 2
    low = min(int(at), len(COLOURS) - 2)
    return "#%02x%02x%02x" % tuple(round(a + (at - low) * (b - a)) for a, b in zip(COLOURS[low], COLOURS[low + 1]))


def project(x, y, z):
    """Seen from the entry, from the left and above; the heights twice as large."""
    u = (x - W / 2) * 0.85 + (y - L / 2) * 0.5
    v = (y - L / 2) * 0.42 - (x - W / 2) * 0.3 + (z - 150) * 2
    return SIZE / 2 + SCALE * u, SIZE / 2 - SCALE * v


def read_cut(path):
    """Vertices and triangles of the cut."""
    vertex, triangle = [], []
    with open(path, encoding="ascii") as file:
        for line in file:
            word = line.split()
            if word[:1] == ["v"]:
                vertex.append(tuple(map(float, word[1:4])))
            elif word[:1] == ["f"]:
                triangle.append([int(corner.split("/")[0]) - 1 for corner in word[1:4]])
    return vertex, triangle


def height_of_cut(vertex, triangle):
    """The cut's height at a place, from the triangle over it; None where there is none."""
    cells = {}
    for corner in triangle:
        xs, ys = [vertex[k][0] for k in corner], [vertex[k][1] for k in corner]
        for i in range(math.floor(min(xs) / 20), math.floor(max(xs) / 20) + 1):
            for j in range(math.floor(min(ys) / 20), math.floor(max(ys) / 20) + 1):
                cells.setdefault((i, j), []).append(corner)

    def height(x, y):
        for corner in cells.get((math.floor(x / 20), math.floor(y / 20)), []):
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (vertex[k] for k in corner)
            det = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
            if det == 0:
                continue
            s = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / det
            t = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / det
            if s >= -1e-9 and t >= -1e-9 and s + t <= 1 + 1e-9:
                return az + s * (bz - az) + t * (cz - az)
        return None

    return height


def sheet(height, fill, left):
    """A grid of a height as quadrilaterals, the far ones first."""
    out = []
    for j in reversed(range(STEPS_Y)):
        for i in range(STEPS_X):
            corner = [(W * (i + a) / STEPS_X, L * (j + b) / STEPS_Y) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            corner = [(min(max(x, 0.5), W - 0.5), min(max(y, 0.5), L - 0.5)) for x, y in corner]
            z = [height(x, y) for x, y in corner]
            if None in z:
                continue
            points = " ".join("%.1f,%.1f" % (left + px, py) for px, py in (project(x, y, h) for (x, y), h in zip(corner, z)))
            out.append('<polygon points="%s" fill="%s"/>' % (points, fill(corner, z)))
    return out


def main():
    folder = sys.argv[1]
    found = json.load(open(os.path.join(folder, "feasibility.json"), encoding="utf-8"))
    assert found["feed"] == "+y", "fed along +y"
    cut = height_of_cut(*read_cut(os.path.join(folder, "surface.obj")))
    limit = 0.3

    def off(corner, z):
        return colour(sum(h - saddle(x, y) for (x, y), h in zip(corner, z)) / 4, limit)

    columns = [
        ("target", sheet(saddle, lambda c, z: "#c9ced3", 0)),
        ("cut: %.2f mm rms, fed along +y" % found["face_mm"]["rms"], sheet(cut, lambda c, z: "#8fb7dd", SIZE + GAP)),
        ("deviation, cut above or below", sheet(cut, off, 2 * (SIZE + GAP))),
    ]
    width = 3 * SIZE + 2 * GAP
    out = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" font-family="sans-serif" font-size="13" fill="#222">' % (width, SIZE + 60)]
    out.append('<rect width="100%" height="100%" fill="#fff"/>')
    for k, (title, shapes) in enumerate(columns):
        out.append('<text x="%d" y="24" text-anchor="middle">%s</text>' % (k * (SIZE + GAP) + SIZE // 2, title))
        out.append('<g stroke="#5b6670" stroke-width="0.3">')
        out += shapes
        out.append("</g>")

    # the scale of the deviation
    left = 2 * (SIZE + GAP) + 50
    for k in range(40):
        out.append('<rect x="%d" y="%d" width="5" height="10" fill="%s"/>' % (left + 5 * k, SIZE + 20, colour((k - 19.5) / 19.5 * limit, limit)))
    for share, text in ((0, "-%g mm" % limit), (0.5, "0"), (1, "%g mm" % limit)):
        out.append('<text x="%d" y="%d" text-anchor="middle">%s</text>' % (left + 200 * share, SIZE + 46, text))
    out.append("</svg>")
    with open("saddle.svg", "w", encoding="ascii") as file:
        file.write("\n".join(out) + "\n")


if __name__ == "__main__":
    main()
