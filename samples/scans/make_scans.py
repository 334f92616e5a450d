#!/usr/bin/env python3
"""Make the two scans of this folder from surfaces that `wirecut simulate` wrote, with everything in them known.

    wirecut simulate samples/jobs/steady-400-60.json -o steady --chord-tolerance 0.005
    wirecut simulate samples/jobs/freeform-4.json -o freeform --chord-tolerance 0.005
    python3 samples/scans/make_scans.py steady/surface.ply freeform/surface.ply samples/scans

Points are drawn evenly over the surface's triangles within the block and moved along the triangle's normal.
"""
import math
import random
import struct
import sys


def read_surface(path):
    """Vertices and triangles of a surface.ply of wirecut."""
    data = open(path, "rb").read()
    head, body = data.split(b"end_header\n", 1)
    lines = head.decode().split("\n")
    vertices = int(next(l for l in lines if l.startswith("element vertex")).split()[2])
    faces = int(next(l for l in lines if l.startswith("element face")).split()[2])
    size = {"double": 8, "uchar": 1, "float": 4, "int": 4}
    stride = sum(size[l.split()[1]] for l in lines if l.startswith("property") and "list" not in l)
    vertex = [struct.unpack_from("<3d", body, k * stride) for k in range(vertices)]
    face = [struct.unpack_from("<3i", body, vertices * stride + 13 * k + 1) for k in range(faces)]
    return vertex, face


def sub(a, b):
    return [a[k] - b[k] for k in range(3)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def draw(surface, block, count, offset, rng):
    """Points evenly over the surface in the block, each moved along the normal by offset(x, y)."""
    vertex, face = surface
    total, sums = 0.0, []
    for f in face:
        a, b, c = (vertex[i] for i in f)
        total += math.hypot(*cross(sub(b, a), sub(c, a))) / 2
        sums.append(total)
    points = []
    while len(points) < count:
        at, low, high = rng.random() * total, 0, len(sums) - 1
        while low < high:
            middle = (low + high) // 2
            low, high = (low, middle) if sums[middle] >= at else (middle + 1, high)
        a, b, c = (vertex[i] for i in face[low])
        s, t = sorted((rng.random(), rng.random()))
        p = [s * a[k] + (t - s) * b[k] + (1 - t) * c[k] for k in range(3)]
        if not (0.5 < p[0] < block[0] - 0.5 and 0.5 < p[1] < block[1] - 0.5 and 0 < p[2] < block[2]):
            continue
        n = cross(sub(b, a), sub(c, a))
        by = offset(p[0], p[1])
        if by is not None:
            points.append([p[k] + by * n[k] / math.hypot(*n) for k in range(3)])
    return points


def main(steady, freeform, folder):
    rng = random.Random(1)
    # half a kerf of 1.2 mm, noise of 0.05 mm: nothing else
    points = draw(read_surface(steady), (400, 1200, 300), 4000, lambda x, y: -0.6 + rng.gauss(0, 0.05), rng)
    with open(f"{folder}/steady-400-60.xyz", "w") as f:
        f.writelines("%.3f %.3f %.3f\n" % tuple(p) for p in points)

    # half a kerf of 1 mm, a bump of 2 mm and 25 mm radius about (300, 250), a hole of 60 mm about (120, 600), noise
    def bumped(x, y):
        if math.hypot(x - 120, y - 600) < 30:
            return None
        return -0.5 + 2 * math.exp(-((x - 300) ** 2 + (y - 250) ** 2) / (2 * 25**2)) + rng.gauss(0, 0.1)

    points = draw(read_surface(freeform), (400, 900, 300), 8000, bumped, rng)
    with open(f"{folder}/freeform-4.ply", "wb") as f:
        f.write(b"ply\nformat binary_little_endian 1.0\ncomment units: mm\nelement vertex %d\n" % len(points))
        f.write(b"property float x\nproperty float y\nproperty float z\nend_header\n")
        f.writelines(struct.pack("<3f", *p) for p in points)


main(*sys.argv[1:])
