"""An evenly grey picture:  python3 plain_png.py OUT.png WIDTH HEIGHT"""
import struct
import sys
import zlib


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


path, width, height = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
rows = (b"\0" + b"\x80" * width) * height
open(path, "wb").write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
