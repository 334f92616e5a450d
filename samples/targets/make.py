#!/usr/bin/env python3
"""Make the sample targets for a block of 400 x 600 x 300 mm: meshes over the block, and a cloud as a scanner gives it."""
import math
import random
import struct

W, L = 400.0, 600.0
COLUMNS, ROWS = 49, 71


def saddle(x, y):
    return 150 + 4e-4 * ((x - W / 2) ** 2 - (y - L / 2) ** 2)


def enneper(x, y):
    """Enneper's surface of size 900 mm, its parameters solved for the place."""
    size = 900.0
    px, py = (x - W / 2) / size, (y - L / 2) / size
    u, v = px, py
    for _ in range(60):
        f = u - u**3 / 3 + u * v * v - px
        g = v - v**3 / 3 + v * u * u - py
        a, b, d = 1 - u * u + v * v, 2 * u * v, 1 - v * v + u * u
        det = a * d - b * b
        u, v = u - (f * d - g * b) / det, v - (g * a - f * b) / det
    return 150 + size * (u * u - v * v)


def torus(x, y):
    """The inner side of a torus about the x axis of the middle: radii 700 mm and 900 mm."""
    r = 700 + 900 - math.sqrt(900**2 - (y - L / 2) ** 2)
    return 150 - 700 + math.sqrt(r * r - (x - W / 2) ** 2)


def sphere(x, y):
    """A cap of a sphere of 1000 mm: domed everywhere, so that no wire lies in it."""
    return 200 - 1000 + math.sqrt(1000**2 - (x - W / 2) ** 2 - (y - L / 2) ** 2)


def bicubic(x, y):
    """A bicubic patch over random heights: saddle-shaped here and domed there."""
    generator = random.Random(1)
    height = [[generator.uniform(-30, 30) for _ in range(4)] for _ in range(4)]

    def bernstein(t):
        s = 1 - t
        return (s**3, 3 * s * s * t, 3 * s * t * t, t**3)

    bx, by = bernstein(x / W), bernstein(y / L)
    return 150 + sum(by[j] * bx[i] * height[j][i] for j in range(4) for i in range(4))


def write_mesh(name, height):
    """Binary PLY of a grid that reaches 40 mm beyond the block's sides in x and 50 mm in y."""
    with open(name, "wb") as file:
        faces = 2 * (COLUMNS - 1) * (ROWS - 1)
        file.write(
            b"ply\nformat binary_little_endian 1.0\ncomment in millimetres\nelement vertex %d\nproperty float x\n"
            b"property float y\nproperty float z\nelement face %d\nproperty list uchar int vertex_indices\nend_header\n"
            % (COLUMNS * ROWS, faces)
        )
        for j in range(ROWS):
            for i in range(COLUMNS):
                x, y = -40 + (W + 80) * i / (COLUMNS - 1), -50 + (L + 100) * j / (ROWS - 1)
                file.write(struct.pack("<3f", x, y, height(x, y)))
        for j in range(ROWS - 1):
            for i in range(COLUMNS - 1):
                a = j * COLUMNS + i
                b = a + COLUMNS
                file.write(struct.pack("<B3i", 3, a, a + 1, b + 1) + struct.pack("<B3i", 3, a, b + 1, b))


def write_cloud(name, height):
    """5000 points with 0.2 mm of noise, a hole of 100 mm and 1 % strays at 5 to 15 mm."""
    generator = random.Random(2)
    with open(name, "w", encoding="ascii") as file:
        count = 0
        while count < 5000:
            x, y = generator.uniform(0, W), generator.uniform(0, L)
            if math.hypot(x - 150, y - 350) < 50:
                continue
            z = height(x, y) + generator.gauss(0, 0.2)
            if generator.random() < 0.01:
                z += generator.choice((-1, 1)) * generator.uniform(5, 15)
            file.write(f"{x:.3f} {y:.3f} {z:.3f}\n")
            count += 1


if __name__ == "__main__":
    for shape in (saddle, enneper, torus, sphere, bicubic):
        write_mesh(f"{shape.__name__}.ply", shape)
    write_cloud("saddle-scan.xyz", saddle)
