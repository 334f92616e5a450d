#!/usr/bin/python3
"""The same points and the same mesh through wirecut, Open3D and CloudCompare, one after the other, one thread each.

    bench_deviation.py BENCH_DEVIATION [POINTS]

CPU seconds and how far distances are apart. What is not installed is left out with a message; needs numpy.
"""
import os
import resource
import subprocess
import sys
import tempfile

try:
    import numpy
except ImportError:
    print("skipped: no numpy")
    sys.exit(0)


def child_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


OPEN3D = """
import sys, time
import numpy, open3d
mesh = open3d.t.io.read_triangle_mesh("mesh.ply")
points = numpy.asarray(open3d.io.read_point_cloud("points.ply").points, dtype=numpy.float32)
new_scene = open3d.t.geometry.RaycastingScene
threads = {"nthreads": 1} if "nthreads" in (new_scene.__init__.__doc__ or "") else {}
shortest = [float("inf")] * 2
for _ in range(3):
    begin = time.process_time()
    scene = new_scene(**threads)
    scene.add_triangles(mesh)
    scene.compute_distance(open3d.core.Tensor(points[:1]))
    ready = time.process_time()
    distance = scene.compute_distance(open3d.core.Tensor(points)).numpy()
    shortest = [min(shortest[0], ready - begin), min(shortest[1], time.process_time() - ready)]
print(*shortest)
distance.astype("f8").tofile("open3d.f64")
"""


def report(name, seconds, ours, found):
    off = numpy.abs(numpy.abs(ours) - numpy.abs(found))
    print("%-14s %8.2f s   apart from wirecut's: largest %.1e, 99 %% %.1e mm" % (name, seconds, off.max(), numpy.quantile(off, 0.99)))


def with_open3d(ours):
    done = subprocess.run([sys.executable, "-c", OPEN3D], capture_output=True, text=True, env={**os.environ, "OMP_NUM_THREADS": "1"})
    if done.returncode != 0:
        print("Open3D: skipped:", (done.stderr.strip().split("\n") or ["?"])[-1])
        return
    prepared, measured = (float(s) for s in done.stdout.split()[-2:])
    print("(Open3D: %.2f s to prepare, then)" % prepared)
    report("Open3D", measured, ours, numpy.fromfile("open3d.f64"))


def read_ply(path):
    """The scalar of a binary cloud of CloudCompare, by its last property."""
    data = open(path, "rb").read()
    head, body = data.split(b"end_header\n", 1)
    names = [l.split()[1:] for l in head.decode().split("\n") if l.startswith("property")]
    kind = {"float": "f4", "double": "f8", "uchar": "u1", "int": "i4"}
    rows = numpy.frombuffer(body, numpy.dtype([(n, "<" + kind[k]) for k, n in names]))
    return rows[names[-1][1]].astype("f8")


def with_cloudcompare(ours):
    command = ["CloudCompare", "-SILENT", "-AUTO_SAVE", "OFF", "-C_EXPORT_FMT", "PLY", "-O", "points.ply", "-O", "mesh.ply",
               "-C2M_DIST", "-MAX_TCOUNT", "1", "-SAVE_CLOUDS", "FILE", "cc.ply"]
    begin = child_seconds()
    try:
        done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "QT_QPA_PLATFORM": "offscreen"})
    except FileNotFoundError:
        print("CloudCompare: skipped: not installed")
        return
    seconds = child_seconds() - begin
    if not os.path.exists("cc.ply"):
        print("CloudCompare: skipped:", (done.stdout + done.stderr).strip()[-300:])
        return
    print("(CloudCompare's seconds are of the whole program, with reading and writing)")
    report("CloudCompare", seconds, ours, read_ply("cc.ply"))


def main(bench, count="1000000"):
    bench = os.path.abspath(bench)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        subprocess.run([bench, count, "."], check=True)
        both = numpy.fromfile("distances.f64").reshape(2, -1)
        with_open3d(both[1])
        with_cloudcompare(both[1])
        os.chdir("/")


main(*sys.argv[1:])
