# VTK, as ParaView has it, reads history.vtp to the last bit, and the STL, PLY and OBJ halves closed, in millimetres.
# labels: exchange slow
. "$SOURCE_DIR/tests/exchange/exchange.sh"
need_module 'import vtk' python3-vtk9
LC_ALL=de_DE.UTF-8 "$WIRECUT" simulate "$SOURCE_DIR/samples/jobs/freeform-4.json" -o out --quiet
/usr/bin/python3 - <<'PYTHON'
import csv
import json
import vtk

reader = vtk.vtkXMLPolyDataReader()
reader.SetFileName("out/history.vtp")
reader.Update()
history, summary = reader.GetOutput(), json.load(open("out/summary.json"))
assert history.GetNumberOfLines() == summary["stations"], history.GetNumberOfLines()
assert history.GetNumberOfPoints() == summary["stations"] * summary["nodes"]
assert history.GetPoints().GetDataType() == vtk.VTK_DOUBLE
arrays = [history.GetPointData().GetArrayName(k) for k in range(history.GetPointData().GetNumberOfArrays())]
print("history.vtp:", history.GetNumberOfLines(), "stations,", arrays)
assert arrays

given = json.load(open("given.json"))
for half in ("lower", "upper"):
    for ending, kind in (("stl", vtk.vtkSTLReader), ("ply", vtk.vtkPLYReader), ("obj", vtk.vtkOBJReader)):
        reader = kind()
        reader.SetFileName(f"{half}.{ending}")
        reader.Update()
        mesh = reader.GetOutput()
        edges = vtk.vtkFeatureEdges()
        edges.SetInputData(mesh)
        edges.FeatureEdgesOff()
        edges.ManifoldEdgesOff()
        edges.BoundaryEdgesOn()
        edges.NonManifoldEdgesOn()
        edges.Update()
        mass = vtk.vtkMassProperties()
        mass.SetInputData(mesh)
        mass.Update()
        box = mesh.GetBounds()
        print(half, ending, mesh.GetNumberOfCells(), "triangles,", edges.GetOutput().GetNumberOfCells(),
              "open or branching edges, volume", mass.GetVolume())
        assert mesh.GetNumberOfCells() == given[half]["triangles"]
        assert mesh.GetNumberOfPoints() == given[half]["vertices"]
        assert edges.GetOutput().GetNumberOfCells() == 0
        assert abs(mass.GetVolume() / given[half]["volume"] - 1) < 1e-5
        assert abs(box[1] - 400) < 1e-4 and abs(box[3] - 600) < 1e-4
PYTHON
