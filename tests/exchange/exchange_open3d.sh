# Open3D reads the PLY, OBJ and STL halves watertight and oriented, of our volume; CloudCompare opens the PLY.
# labels: exchange slow
. "$SOURCE_DIR/tests/exchange/exchange.sh"
need_module 'import open3d' python3-open3d
/usr/bin/python3 - <<'PYTHON'
import json
import open3d

given = json.load(open("given.json"))
for half in ("lower", "upper"):
    for ending in ("ply", "obj", "stl"):  # of a GLB it leaves out the node that makes metres of millimetres
        mesh = open3d.io.read_triangle_mesh(f"{half}.{ending}")
        if ending == "stl":
            mesh.merge_close_vertices(1e-9)
        volume = mesh.get_volume() if mesh.is_watertight() else 0
        print(half, ending, len(mesh.triangles), "triangles, watertight", mesh.is_watertight(), "volume", volume)
        assert len(mesh.triangles) == given[half]["triangles"]
        assert mesh.is_watertight() and mesh.is_orientable() and mesh.is_edge_manifold(False)
        assert abs(volume / given[half]["volume"] - 1) < 1e-5
PYTHON
command -v CloudCompare >/dev/null || { echo "no CloudCompare here (Debian package cloudcompare)"; exit 0; }
QT_QPA_PLATFORM=offscreen LC_ALL=C timeout 120 CloudCompare -SILENT -O lower.ply -EXTRACT_VERTICES -NO_TIMESTAMP >log 2>&1 ||
    { cat log; exit 1; }
grep -q "$(value lower triangles) faces" log || { cat log; exit 1; }
