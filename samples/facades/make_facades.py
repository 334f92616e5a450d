#!/usr/bin/env python3
"""Make the sample facades: four descriptions, the jobs they follow and the image that drives one of them."""
import json
import math
import struct
import zlib
from pathlib import Path

HERE = Path(__file__).parent


def write(name, document):
    (HERE / name).write_text(json.dumps(document, indent=2) + "\n")


def job(name, size, edge_a, edge_b, extra, overrun):
    """A design-mode job: heights of both edges at even steps of the feed."""
    width, length, _ = size

    def points(x, height):
        return {"points_mm": [[x, round(length * k / 16, 6), round(height(k / 16), 6)] for k in range(17)]}

    return {
        "format": "wirecut-job/1",
        "name": name,
        "block": {"size_mm": size, "material": "EPS 15 kg/m3"},
        "wire": {"diameter_mm": 0.2, "material": "Kanthal A", "nodes": 61},
        "process": {
            "heat_W_per_m": 65.0,
            "tension_N": 2.0,
            "force_law": {"a_N_per_mm": 0.1, "b_m2_per_J": 0.00086},
        },
        "kerf": {"width_mm": 0.8, "per_J_m2_mm": 1.6e-4},
        "design": {
            "edge_a": points(0, edge_a),
            "edge_b": points(width, edge_b),
            "stations": 161,
            "extra_length_mm": extra,
            "clearance_mm": 80.0,
            "overrun_mm": overrun,
        },
    }


def png(name, rows):
    """An 8 bit grey PNG."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    raw = b"".join(b"\0" + bytes(row) for row in rows)
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    (HERE / name).write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(raw, 9)) + chunk(b"IEND", b"")
    )


def main():
    # every field is driven on this block
    base = job("block 300", [300, 300, 160], lambda t: 80.0, lambda t: 80.0, [[0, 2.0], [1, 2.0]], 0)
    write("block-300.json", base)

    # two variants for a checkerboard: where one rises at its sides the other one falls, so that neighbours share the edge
    def bump(height):
        return lambda t: 80 + height * math.sin(math.pi * t) ** 4

    write("left.json", job("left", [300, 300, 160], bump(40), bump(-40), [[0, 0.5], [0.5, 4.0], [1, 0.5]], 20))
    write("right.json", job("right", [300, 300, 160], bump(-40), bump(40), [[0, 0.5], [0.5, 9.0], [1, 0.5]], 20))
    write(
        "checkerboard.json",
        {
            "format": "wirecut-facade/1",
            "name": "checkerboard of two variants",
            "lattice": {"kind": "plane", "rows": 6, "columns": 6},
            "joint_mm": 0,
            "match": "edge",
            "variants": [{"name": "left", "job": "left.json"}, {"name": "right", "job": "right.json"}],
            "deal": {"rule": "checkerboard"},
        },
    )

    # a wave that runs over 6 x 8 blocks: all of them are different
    write(
        "wave.json",
        {
            "format": "wirecut-facade/1",
            "name": "wave field",
            "lattice": {"kind": "plane", "rows": 6, "columns": 8},
            "joint_mm": 0,
            "match": "tangent",
            "match_move_mm": 12,
            "job": "block-300.json",
            "fields": {
                "wave": {
                    "kind": "sine",
                    "value": 80,
                    "amplitude": 30,
                    "period_mm": 1370,
                    "direction_deg": 35,
                    "phase_deg": 20,
                },
                "tilt": {"kind": "linear", "value": -10, "per_mm": [0.004, 0.006]},
                "slack": {
                    "kind": "attractor",
                    "value": 2,
                    "amplitude": 5,
                    "radius_mm": 700,
                    "curve_mm": [[0, 300], [1200, 900], [2400, 1500]],
                },
            },
            "design": {"height_mm": ["wave", "tilt"], "extra_length_mm": "slack"},
        },
    )

    # around a cylinder, with a period of three columns: equal elements are cut once
    write(
        "cylinder.json",
        {
            "format": "wirecut-facade/1",
            "name": "around a cylinder",
            "lattice": {"kind": "cylinder", "rows": 4, "columns": 12, "radius_mm": 2400},
            "joint_mm": 8,
            "match": "edge",
            "job": "block-300.json",
            "fields": {
                "rib": {"kind": "sine", "value": 80, "amplitude": 35, "period_mm": 924, "direction_deg": 0},
                "slack": {"kind": "constant", "value": 3},
            },
            "design": {"height_mm": "rib", "extra_length_mm": "slack"},
        },
    )

    # an image: two soft spots of light
    def light(u, v):
        spots = ((0.3, 0.35, 0.22, 1.0), (0.72, 0.65, 0.16, 0.8))
        return sum(a * math.exp(-((u - x) ** 2 + (v - y) ** 2) / r**2) for x, y, r, a in spots)

    png("light.png", [[min(255, round(230 * light((c + 0.5) / 48, 1 - (r + 0.5) / 36))) for c in range(48)] for r in range(36)])
    write(
        "image.json",
        {
            "format": "wirecut-facade/1",
            "name": "driven by an image",
            "lattice": {"kind": "plane", "rows": 3, "columns": 4},
            "joint_mm": 5,
            "match": "edge",
            "job": "block-300.json",
            "fields": {
                "light": {"kind": "image", "file": "light.png", "low": 45, "high": 120},
                "slack": {"kind": "constant", "value": 2},
            },
            "design": {"height_mm": "light", "extra_length_mm": "slack"},
        },
    )


if __name__ == "__main__":
    main()
