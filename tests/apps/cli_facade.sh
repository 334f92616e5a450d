# wirecut facade: equal elements are cut once, what is whole is not run again, one that cannot be cut stops no other, and
# the files hold every element where it stands.
. "$SOURCE_DIR/tests/apps/common.sh"
samples=$SOURCE_DIR/samples/facades
for name in left right block-300; do
    python3 - "$samples/$name.json" <<'END' >"$name.json"
import json, sys
job = json.load(open(sys.argv[1]))
job["wire"]["nodes"], job["design"]["stations"] = 31, 61
print(json.dumps(job))
END
done
cat >board.json <<'END'
{"format": "wirecut-facade/1", "name": "board", "lattice": {"kind": "plane", "rows": 3, "columns": 4},
 "variants": [{"name": "left", "job": "left.json"}, {"name": "right", "job": "right.json"}],
 "deal": {"rule": "checkerboard"}}
END

# 12 placements of 2 elements; the same again runs none
run 0 facade board.json -o board -j 2 --thickness 10 --moulds
no_result
no_leavings board/cases
grep -q '^12 placements, 2 distinct; 2 run now, 0 were whole$' err || fail "$called: $(cat err)"
run 0 verify board --quiet
for file in panel.stl panel.step lower.stl upper.step mould.json job-path.json path.csv report.html input.json; do
    [ "$(ls board/cases/*/*/$file | wc -l)" -eq 2 ] || fail "not two $file"
done
cp board/facade.csv kept.csv
run 0 facade board.json -o board -j 2 --thickness 10 --moulds --json
grep -q '^12 placements, 2 distinct; 0 run now, 2 were whole$' err || fail "$called: $(cat err)"
cmp -s out board/facade.json || fail "$called: not the document on standard output"
cmp -s board/facade.csv kept.csv || fail "the table changed"

# a damaged one is run again, alone
rm "$(ls board/cases/*/*/panel.stl | head -n 1)"
run 0 facade board.json -o board --thickness 10 --moulds
grep -q '^12 placements, 2 distinct; 1 run now, 1 were whole$' err || fail "$called: $(cat err)"

# the input of an element runs by itself and has the same result
run 0 facade --element "$(ls board/cases/*/*/input.json | head -n 1)" -o one --quiet
python3 - "$(ls board/cases/*/*/element.json | head -n 1)" <<'END' || fail "the element by itself is another one"
import json, sys
one, other = json.load(open("one/element.json")), json.load(open(sys.argv[1]))
assert one["face"] == other["face"] and one["panel"] == other["panel"] and one["summary"] == other["summary"]
END

# every file against every other: places of nodes and parts, weights, shared edges
python3 - <<'END' || fail "the files do not agree"
import csv, json, re, struct
data = json.load(open("board/facade.json"))
rows = list(csv.DictReader(open("board/facade.csv")))
assert data["placements"] == len(rows) == len(data["elements"]) == 12 and data["distinct"] == 2 and data["feasible"] == 12
assert len(data["joints"]) == 17 and data["joint"]["gap_max_mm"] == 0 and data["joint"]["step_max_mm"] < 0.2
assert {r["variant"] for r in rows} == {"left", "right"} and {r["verdict"] for r in rows} == {"feasible"}
for row in rows:
    assert abs(float(row["foam_lower_mm3"]) + float(row["foam_upper_mm3"]) - 300 * 300 * 160) < 1
    assert abs(float(row["panel_kg"]) - float(row["panel_mm3"]) * 2000e-9) < 1e-9
    assert 1 < float(row["panel_mm3"]) / (300 * 300 * 10) < 1.3

# glTF: chunks as long as they say, accessors inside their views, indices inside the mesh, a node for each element
glb = open("board/facade.glb", "rb").read()
magic, version, length, json_length, kind = struct.unpack("<5I", glb[:20])
assert (magic, version, length, kind) == (0x46546C67, 2, len(glb), 0x4E4F534A) and json_length % 4 == 0
scene = json.loads(glb[20:20 + json_length])
binary = glb[28 + json_length:]
assert len(binary) == scene["buffers"][0]["byteLength"] and len(scene["meshes"]) == 2
size = {5123: 2, 5126: 4}
for a in scene["accessors"]:
    view = scene["bufferViews"][a["bufferView"]]
    n = a["count"] * {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[a["type"]]
    assert view["byteOffset"] % 4 == 0 and view["byteOffset"] + n * size[a["componentType"]] <= len(binary)
    if "min" in a:
        v = struct.unpack_from("<%d%s" % (n, "H" if a["componentType"] == 5123 else "f"), binary, view["byteOffset"])
        k = len(a["min"])
        assert [min(v[i::k]) for i in range(k)] == a["min"] and [max(v[i::k]) for i in range(k)] == a["max"]
nodes = [n for n in scene["nodes"] if "mesh" in n]
assert scene["nodes"][0]["children"] == list(range(1, 13)) and len(nodes) == 12
for node, element in zip(nodes, data["elements"]):
    m = node.get("matrix", [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1])
    assert m[12:15] == element["origin_mm"] and m[0:3] == element["x_axis"] and m[8:11] == element["z_axis"]

# STEP: two parts, twelve occurrences, each set where its element is
step = open("board/facade.step").read()
assert step.count("NEXT_ASSEMBLY_USAGE_OCCURRENCE(") == 12 and step.count("B_SPLINE_SURFACE_WITH_KNOTS(") == 2
item = dict(re.findall(r"#(\d+)=([^;]*);", step))
point = lambda n: [float(x) for x in re.search(r"\('',\(([^)]*)\)", item[n]).group(1).split(",")]
places = [re.match(r"ITEM_DEFINED_TRANSFORMATION\('','',#\d+,#(\d+)\)", v).group(1) for v in item.values() if v.startswith("ITEM_DEFINED")]
for at, element in zip(places, data["elements"]):
    axis = re.match(r"AXIS2_PLACEMENT_3D\('',#(\d+),#(\d+),#(\d+)\)", item[at]).groups()
    assert [point(n) for n in axis] == [element["origin_mm"], element["z_axis"], element["x_axis"]]
END

# one that cannot be cut is named and stops no other
sed 's/"extra_length_mm": \[\[0, 0.5\]/"extra_length_mm": [[0, 400]/' right.json >wrong.json
cmp -s right.json wrong.json && fail "nothing was made wrong"
cat >mixed.json <<'END'
{"format": "wirecut-facade/1", "name": "mixed", "lattice": {"kind": "plane", "rows": 1, "columns": 2}, "match": "none",
 "elements": [{"row": 0, "column": 0, "job": "left.json"}, {"row": 0, "column": 1, "job": "wrong.json"}]}
END
run 6 facade mixed.json -o mixed -j 2
grep -q '^element 1 (row 0, column 1): ' err || fail "$called: the element is not named: $(cat err)"
grep -q 'wirecut: 1 of 2 elements cannot be made as described; the others are on disk' err || fail "$called: $(cat err)"
for file in facade.glb facade.step facade.csv report.html facade.json; do
    [ -s "mixed/$file" ] || fail "$called: no $file"
done

# a panel that folds is refused with the place; the cut is there all the same
run 6 facade board.json -o thick -j 2 --thickness 150
grep -q 'panel of 150 mm: .*(.*) mm' err || fail "$called: no place: $(cat err)"
[ -s "$(ls thick/cases/*/*/path.csv | head -n 1)" ] || fail "$called: no path"

# fields: an image, a table, turned and turned over; every edge shared
python3 - "$samples" <<'END'
import json, shutil, sys
shutil.copy(sys.argv[1] + "/light.png", "light.png")
open("table.csv", "w").write("a,b,c\n60,80,70\n90,75,85\n")
fields = {"light": {"kind": "image", "file": "light.png", "low": 0, "high": 20}, "table": {"kind": "grid", "file": "table.csv"},
          "slack": {"kind": "constant", "value": 2}}
json.dump({"format": "wirecut-facade/1", "name": "fields", "lattice": {"kind": "plane", "rows": 1, "columns": 3}, "joint_mm": 4,
           "job": "block-300.json", "fields": fields, "design": {"height_mm": ["light", "table"], "extra_length_mm": "slack"},
           "elements": [{"row": 0, "column": 0}, {"row": 0, "column": 1, "turn_deg": 90}, {"row": 0, "column": 2, "mirrored": True}]},
          open("fields.json", "w"))
END
run 0 facade fields.json -o fields -j 2 --formats csv --quiet
python3 - <<'END' || fail "not the edges of the fields"
import json
data = json.load(open("fields/facade.json"))
assert data["distinct"] == 3 and data["joint"]["gap_max_mm"] == 0
assert [e["panel_half"] for e in data["elements"]] == ["lower", "lower", "upper"]
assert [j["opening_mm"] for j in data["joints"]] == [{"min": 4, "max": 4}] * 2 or all(abs(j["opening_mm"]["max"] - 4) < 1e-9 for j in data["joints"])
END

sed 's/wrong/left/' mixed.json >twice.json

# what is wrong is said with its place before anything is written
refuse() {
    python3 - "$1" "$2" "$3" <<'END'
import sys
text = open(sys.argv[1]).read()
assert sys.argv[2] in text, sys.argv[2]
open("changed.json", "w").write(text.replace(sys.argv[2], sys.argv[3]))
END
    run 3 facade changed.json -o refused
    one_line "$4"
    untouched refused
}
refuse board.json checkerboard random '$.deal.seed: '
refuse board.json '"plane"' '"plan"' '$.lattice.kind: found "plan"'
refuse board.json left.json none.json 'none.json'
refuse board.json '"rows": 3' '"rows": 0' '$.lattice.rows: found 0'
refuse board.json '"name": "right"' '"name": "right", "turn_deg": 45' 'expected 0, 90, 180 or 270'
refuse mixed.json '"column": 1' '"column": 0' 'elements 0 and 1 claim the cell in row 0, column 0'
refuse twice.json '"none"' '"edge"' 'their edges are'
refuse fields.json '"value": 2' '"value": -2' 'expected 0 or more'
refuse fields.json '"high": 20' '"high": 900' 'the field leaves the block: an edge of height'
refuse fields.json '"slack": {' '"slack": {"radius_mm": 3, ' 'radius_mm'
refuse fields.json '"extra_length_mm": "slack"' '"extra_length_mm": "slak"' '$.design.extra_length_mm: '
run 2 facade board.json
finish
