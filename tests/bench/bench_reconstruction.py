"""Open3D's Poisson reconstruction for bench_reconstruction:  bench_reconstruction.py FOLDER DEPTH

FOLDER/points, FOLDER/normals (rows of three doubles) in, FOLDER/vertices and FOLDER/triangles out; prints CPU seconds on one thread."""
import sys
import time

import numpy
import open3d

folder, depth = sys.argv[1], int(sys.argv[2])
cloud = open3d.geometry.PointCloud()
cloud.points = open3d.utility.Vector3dVector(numpy.fromfile(folder + "/points").reshape(-1, 3))
cloud.normals = open3d.utility.Vector3dVector(numpy.fromfile(folder + "/normals").reshape(-1, 3))
start = time.process_time()
mesh, _ = open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(cloud, depth=depth, n_threads=1)
print(time.process_time() - start)
numpy.asarray(mesh.vertices).tofile(folder + "/vertices")
numpy.asarray(mesh.triangles).astype(numpy.int32).tofile(folder + "/triangles")
