"""Pictures of a simulated cut face, rendered by a program that shares nothing with the library.

    python3 render.py FACE.vtp OUT [--seed N] [--plain] [--width PX] [--height PX] [--noise LEVELS]
                                     [--rills MM,MM]

FACE.vtp is history.vtp of `wirecut simulate`. Writes OUT/photo.png (grey), OUT/points.csv with up to twelve points of the block
that are in the picture, their pixels with 0.1 px of noise, and OUT/truth.json with the camera. A ray a pixel is carried onto
the face; rills follow the wires, their heights are random along the feed; the light comes from a low angle. --plain: no rills,
uneven light.
"""
import argparse
import json
import re
import struct
import zlib
from pathlib import Path

import numpy as np


def read_wires(path):
    """stations x nodes x 3 [mm] of a history.vtp."""
    data = Path(path).read_bytes()
    head, body = data.split(b"<AppendedData", 1)
    body = body[body.index(b"_") + 1:]
    offset = int(re.search(rb'Name="position_mm"[^>]*offset="(\d+)"', head).group(1))
    lines = int(re.search(rb'NumberOfLines="(\d+)"', head).group(1))
    size = struct.unpack_from("<Q", body, offset)[0]
    points = np.frombuffer(body, "<f8", size // 8, offset + 8)
    return points.reshape(lines, -1, 3)


def face_of(wires, block, cell):
    """z and way of the feed on a grid of nodes: each wire at every x, then each column over y.

    The way of a wire is its y in the middle of the block: rills keep their spacing in mm.
    """
    x = np.arange(0, block[0] + cell / 2, cell)
    y = np.arange(0, block[1] + cell / 2, cell)
    at_y = np.array([np.interp(x, w[:, 0], w[:, 1]) for w in wires])
    at_z = np.array([np.interp(x, w[:, 0], w[:, 2]) for w in wires])
    z = np.empty((len(y), len(x)))
    way = np.empty_like(z)
    number = at_y[:, len(x) // 2]
    for k in range(len(x)):
        order = np.argsort(at_y[:, k])
        z[:, k] = np.interp(y, at_y[order, k], at_z[order, k])
        way[:, k] = np.interp(y, at_y[order, k], number[order])
    return x, y, z, way


def bilinear(grid, cell, x, y):
    u = np.clip(x / cell, 0, grid.shape[1] - 1.001)
    v = np.clip(y / cell, 0, grid.shape[0] - 1.001)
    i, j = u.astype(int), v.astype(int)
    fu, fv = u - i, v - j
    return ((1 - fv) * ((1 - fu) * grid[j, i] + fu * grid[j, i + 1])
            + fv * ((1 - fu) * grid[j + 1, i] + fu * grid[j + 1, i + 1]))


class Camera:
    def __init__(self, eye, target, focal, width, height, k1, k2, roll):
        forward = np.subtract(target, eye)
        forward /= np.linalg.norm(forward)
        right = np.cross(forward, [0, 0, 1.0])
        right /= np.linalg.norm(right)
        down = np.cross(forward, right)
        c, s = np.cos(roll), np.sin(roll)
        self.r = np.array([c * right + s * down, -s * right + c * down, forward])
        self.eye, self.focal, self.k1, self.k2 = np.array(eye, float), focal, k1, k2
        self.middle = np.array([(width - 1) / 2, (height - 1) / 2])

    def project(self, p):
        q = (np.asarray(p) - self.eye) @ self.r.T
        m = q[..., :2] / q[..., 2:]
        r2 = (m**2).sum(-1, keepdims=True)
        return self.middle + self.focal * m * (1 + self.k1 * r2 + self.k2 * r2**2)

    def rays(self, u, v):
        d = np.stack([u, v], -1)
        d = (d - self.middle) / self.focal
        m = d.copy()
        for _ in range(12):
            r2 = (m**2).sum(-1, keepdims=True)
            m = d / (1 + self.k1 * r2 + self.k2 * r2**2)
        return np.concatenate([m, np.ones(m.shape[:-1] + (1,))], -1) @ self.r


def write_png(path, grey):
    rows = np.insert(grey, 0, 0, axis=1).tobytes()

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", grey.shape[1], grey.shape[0], 8, 0, 0, 0, 0)
    Path(path).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows, 1))
                           + chunk(b"IEND", b""))


def shade(x, y, way, grad, rng, rills, plain):
    """brightness 0..1 of places with rills along the wires."""
    zx, zy, sx, sy = grad
    if plain:
        light = 0.35 + 0.3 * x / x.max() + 0.2 * (y / y.max())**2 + 0.1 * np.sin(x / 90) * np.cos(y / 130)
        return light
    # twelve waves along the feed with random phases, each with a slope of 0.01 to 0.03
    slope = np.zeros_like(way)
    for length in rng.uniform(*rills, 12):
        slope += 0.02 * rng.uniform(0.5, 1.5) * np.cos(2 * np.pi * way / length + rng.uniform(0, 2 * np.pi))
    nx, ny = -(zx + slope * sx), -(zy + slope * sy)
    length = np.sqrt(nx**2 + ny**2 + 1)
    light = np.array([0.25, -0.9, 0.35])
    light /= np.linalg.norm(light)
    return np.clip((nx * light[0] + ny * light[1] + light[2]) / length, 0, 1) * 0.7 + 0.1


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("face")
    parser.add_argument("out")
    parser.add_argument("--block", default="400,900,300")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--plain", action="store_true")
    parser.add_argument("--width", type=int, default=2400)
    parser.add_argument("--height", type=int, default=1800)
    parser.add_argument("--noise", type=float, default=1.5)
    parser.add_argument("--rills", default="1.2,4", help="shortest and longest wave, mm")
    parser.add_argument("--points", type=int, default=12)
    parser.add_argument("--pixel-noise", type=float, default=0.1)
    a = parser.parse_args()
    rng = np.random.default_rng(a.seed)
    block = [float(k) for k in a.block.split(",")]

    cell = 0.5
    wires = read_wires(a.face)
    x, y, z, way = face_of(wires, block, cell)
    zy, zx = np.gradient(z, cell)
    sy, sx = np.gradient(way, cell)

    # a camera above the block, some degrees off the vertical
    middle = np.array([block[0] / 2, block[1] / 2, z.mean()])
    eye = middle + np.array([rng.uniform(-200, 200), rng.uniform(-500, -300), 1400])
    focal = 0.85 * a.height / block[0] * 1400 * 0.75
    camera = Camera(eye, middle, min(focal, 0.8 * a.width / block[1] * 1400), a.width, a.height, rng.uniform(-0.12, 0.05),
                    rng.uniform(-0.02, 0.02), np.pi / 2 + rng.uniform(-0.2, 0.2))

    u, v = np.meshgrid(np.arange(a.width, dtype=float), np.arange(a.height, dtype=float))
    ray = camera.rays(u, v)
    place = camera.eye + ray * ((middle[2] - camera.eye[2]) / ray[..., 2:])
    for _ in range(30):
        height = bilinear(z, cell, place[..., 0], place[..., 1])
        place = camera.eye + ray * ((height - camera.eye[2]) / ray[..., 2])[..., None]
    px, py = place[..., 0], place[..., 1]
    inside = (px >= 0) & (px <= block[0]) & (py >= 0) & (py <= block[1])
    at = [bilinear(g, cell, px, py) for g in (way, zx, zy, sx, sy)]
    value = shade(px, py, at[0], at[1:], rng, [float(k) for k in a.rills.split(",")], a.plain)
    picture = np.where(inside, 30 + 190 * value, 12) + rng.normal(0, a.noise, value.shape) * (a.noise > 0)
    Path(a.out).mkdir(parents=True, exist_ok=True)
    write_png(Path(a.out) / "photo.png", np.clip(np.rint(picture), 0, 255).astype(np.uint8))

    # corners of the block, top and bottom of what is left, and marks on its sides
    w, l, h = block
    known = np.array([[0, 0, 0], [w, 0, 0], [w, l, 0], [0, l, 0], [0, 0, h], [w, 0, h], [w, l, h], [0, l, h], [w / 2, 0, h / 2],
                      [w / 2, l, h / 3], [0, l / 2, h / 2], [w, l / 2, h / 4]])[:a.points]
    pixel = camera.project(known) + rng.normal(0, a.pixel_noise, (len(known), 2)) * (a.pixel_noise > 0)
    seen = ((pixel >= 0) & (pixel <= [a.width - 1, a.height - 1])).all(1)
    pixel, known = pixel[seen], known[seen]
    rows = ["u_px,v_px,x_mm,y_mm,z_mm"] + [",".join(repr(float(k)) for k in (*p, *q)) for p, q in zip(pixel, known)]
    (Path(a.out) / "points.csv").write_text("\n".join(rows) + "\n")
    truth = {"focal_px": camera.focal, "k1": camera.k1, "k2": camera.k2, "centre_mm": camera.eye.tolist(),
             "rotation": camera.r.ravel().tolist(), "seed": a.seed}
    (Path(a.out) / "truth.json").write_text(json.dumps(truth, indent=1) + "\n")


if __name__ == "__main__":
    main()
