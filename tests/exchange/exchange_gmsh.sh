# gmsh reads the STEP files, names the halves, and meshes their faces within the block.
# labels: exchange slow
. "$SOURCE_DIR/tests/exchange/exchange.sh"
need gmsh gmsh
# its exit code says little, so that its words are read
gmsh -2 -clmax 40 -format msh22 mould.step -o mould.msh >log 2>&1 || { cat log; exit 1; }
cat log
! grep -qi '^error\|cannot\|fail' log
grep -q "lower' (3D)" log
grep -q "upper' (3D)" log
gmsh -0 parts.step -o parts.msh >log 2>&1 || { cat log; exit 1; }
! grep -qi '^error' log
/usr/bin/python3 - <<'PYTHON'
text = open("mould.msh").read()
nodes = text.split("$Nodes\n")[1].split("$EndNodes")[0].split("\n")[1:-1]
point = [[float(x) for x in line.split()[1:4]] for line in nodes]
low, high = [min(p[k] for p in point) for k in range(3)], [max(p[k] for p in point) for k in range(3)]
print(len(point), "nodes from", low, "to", high)
# the block [0, 400] x [0, 600] x [0, 200] with a cone of 12 on either flat face: millimetres arrive as millimetres
for found, expected in zip(low + high, [0, 0, -12, 400, 600, 212]):
    assert abs(found - expected) < 1e-6, (found, expected)
PYTHON
