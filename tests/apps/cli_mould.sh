# wirecut mould: halves whole on disk, their figures, options, what is refused and with which exit code.
. "$SOURCE_DIR/tests/apps/common.sh"
coarse="--stations 60 --nodes 41 --chord-tolerance 1"
path=$jobs/steady-300-60.json
design=$jobs/freeform-2.json

# figures MOULD.json: what every mould must say, and that volumes are those of the STL files beside it
figures() {
    python3 - "$@" <<'EOF' || fail "$called: not the figures that were expected"
import json, os, struct, sys
mould = json.load(open(sys.argv[1]))
folder = os.path.dirname(sys.argv[1])
assert mould["format"] == "wirecut-mould/1" and mould["job"], mould.keys()
total = mould["kerf_volume_mm3"]
for name in ("lower", "upper"):
    half = mould[name]
    assert half["closed"] is True and half["oriented"] is True and half["self_intersections"] == 0, half
    stl = [f for f in mould["files"] if f.endswith(name + ".stl")]
    assert len(stl) == 1, mould["files"]
    data = open(os.path.join(folder, stl[0]), "rb").read()
    count, = struct.unpack_from("<I", data, 80)
    assert count == half["triangles"], (count, half)
    volume = 0
    for k in range(count):
        a, b, c = (struct.unpack_from("<3f", data, 84 + 50 * k + 12 * i) for i in (1, 2, 3))
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    assert abs(volume / half["volume_mm3"] - 1) < 1e-5, (volume, half)
    total += half["volume_mm3"] - half["keys_mm3"]
assert abs(total / mould["block_volume_mm3"] - 1) < 1e-6 and mould["volume_error"] < 1e-6, mould
for name in mould["files"]:
    assert os.path.getsize(os.path.join(folder, name)) > 0, name
assert sorted(os.listdir(folder)) == sorted(mould["files"]), (os.listdir(folder), mould["files"])
EOF
}

# value FILE EXPRESSION: `m` is the mould
value() {
    python3 -c "import json, sys; m = json.load(open('$1')); sys.exit(0 if ($2) else 1)" || fail "$called: not so: $2"
}

# a cut that goes through
# shellcheck disable=SC2086 # the options are several words
run 0 mould "$path" -o a/b $coarse
no_result
no_leavings a
figures a/b/mould.json
value a/b/mould.json 'abs(m["lower"]["volume_mm3"] / 54e6 - 1) < 1e-3 and m["made_by"] == "index"'
value a/b/mould.json 'm["lower"]["exact_faces"] == 6 and m["prolonged_mm"]["exit"] == 0'
for word in "closed, 1 piece" "a/b" mould.json lower.step; do grep -q -- "$word" err || fail "$called: no $word in: $(cat err)"; done
head -c 13 a/b/lower.step | grep -q '^ISO-10303-21;' || fail "lower.step is no STEP file"
grep -q "MANIFOLD_SOLID_BREP" a/b/upper.step || fail "upper.step holds no solid"
grep -q "<html" a/b/report.html || fail "report.html is no page"

# a design goes through; with keys, a kerf by the heat, shrinkage and a label; the same bytes again in another locale
sed 's/"process":/"kerf": {"width_mm": 0.8, "per_J_m2_mm": 1.6e-4}, "process":/' "$design" >design.json
# shellcheck disable=SC2086
run 0 mould design.json -o c $coarse --keys pockets --key-radius 20 --key-height 10 --scale 1.02 --label panel_7
figures c/mould.json
value c/mould.json 'm["prolonged_mm"]["exit"] == 0 and m["kerf_mm"]["max"] > m["kerf_mm"]["min"] > 0.8'
value c/mould.json 'm["kerf_volume_mm3"] > 3e5 and m["lower"]["keys_mm3"] < 0 and m["asked"]["scale"] == 1.02'
value c/mould.json 'm["lower"]["box_mm"][1][:2] == [408, 918] and "panel_7-lower.step" in m["files"]'
grep -q "panel_7 lower" c/panel_7-lower.step || fail "the solid has no name"
(
    export OMP_NUM_THREADS=3 LC_ALL=de_DE.UTF-8
    # shellcheck disable=SC2086
    "$WIRECUT" mould design.json -o d $coarse --keys pockets --key-radius 20 --key-height 10 --scale 1.02 \
        --label panel_7 --quiet --json >json 2>err
) || fail "a second run: $(cat err)"
[ -s err ] && fail "--quiet is not quiet: $(cat err)"
diff -r c d >/dev/null || fail "two runs differ: $(diff -rq c d)"
cmp -s json d/mould.json || fail "--json is not mould.json"

# AP242 and the cut faces alone, where they are asked for; the IGES file of an earlier run goes
# shellcheck disable=SC2086
run 0 mould design.json -o h $coarse --step-schema ap242 --iges
figures h/mould.json
grep -q "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING" h/lower.step || fail "lower.step is not of AP242"
[ "$(grep -c '^     128 .*D *[0-9]*[13579]$' h/cut.igs)" -eq 2 ] || fail "cut.igs does not hold two surfaces"
# shellcheck disable=SC2086
run 0 mould "$design" -o h $coarse --iges
[ "$(grep -c '^     128 .*D *[0-9]*[13579]$' h/cut.igs)" -eq 1 ] || fail "cut.igs does not hold the one cut face"
# shellcheck disable=SC2086
run 0 mould "$design" -o h $coarse
[ -e h/cut.igs ] && fail "$called: cut.igs of an earlier run is still there"
grep -q AUTOMOTIVE_DESIGN h/lower.step || fail "lower.step is not of AP214"

# edges of a file in the place of the design's own, in another order and one run backwards: the same mould
python3 - "$design" <<'EOF' >edges.csv || fail "edges.csv"
import json, sys
job = json.load(open(sys.argv[1]))
print("x_mm,y_mm,z_mm,curve")
for k, edge in enumerate(("edge_b", "edge_a")):
    points = job["design"][edge]["points_mm"]
    for p in points[::-1] if k == 0 else points:
        print(*p, k, sep=",")
EOF
# shellcheck disable=SC2086
run 0 mould "$design" -o h $coarse --edges edges.csv
figures h/mould.json
grep -q "edges.csv" h/report.html || fail "report.html does not name the edges"
cp h/mould.json with_edges.json
# shellcheck disable=SC2086
run 0 mould "$design" -o h $coarse
python3 -c '
import json
a, b = json.load(open("with_edges.json")), json.load(open("h/mould.json"))
assert abs(a["lower"]["volume_mm3"] / b["lower"]["volume_mm3"] - 1) < 1e-9, (a["lower"], b["lower"])
' || fail "other edges, another mould"
sed '/,1$/d' edges.csv >one.csv
run 3 mould "$design" -o e --edges one.csv
one_line "one.csv: found 1 curve, expected two edges"
run 3 mould "$path" -o e --edges edges.csv
one_line "--edges: expected a design, found a path"
run 3 path "$design" --format csv -o e --edges none.step
one_line "none.step"
untouched e

# refused: nothing is written, the words say where
# a path that ends inside the block is continued straight as far as is allowed, and says so
python3 - "$path" <<'EOF' >short.json
import json, sys
job = json.load(open(sys.argv[1]))
for mount in ("mount_a_mm", "mount_b_mm"):
    job["path"][mount] = job["path"][mount][:-10]
json.dump(job, sys.stdout)
EOF
# shellcheck disable=SC2086
run 0 mould short.json -o short $coarse --prolong 200
grep -q "continued straight" err || fail "$called: does not say that the cut was continued: $(cat err)"
value short/mould.json 'm["prolonged_mm"]["exit"] > 1'
python3 - "$path" <<'EOF' >half.json
import json, sys
job = json.load(open(sys.argv[1]))
for mount in ("mount_a_mm", "mount_b_mm"):
    job["path"][mount] = job["path"][mount][:len(job["path"][mount]) // 2]
json.dump(job, sys.stdout)
EOF
# shellcheck disable=SC2086
run 3 mould half.json -o e $coarse --prolong 1
one_line "ends inside the block" "1200"
untouched e
sed 's/150\.0*\]/310]/g; s/, 150\]/, 310]/g' "$path" >above.json
# shellcheck disable=SC2086
run 3 mould above.json -o e $coarse
one_line "misses the block" "above"
untouched e
# shellcheck disable=SC2086
run 2 mould "$path" -o e $coarse --label ../x
one_line "--label"
untouched e
# shellcheck disable=SC2086
run 2 mould "$path" -o e $coarse --keys cones --key-radius 2 --key-height 20
one_line "--key-height"
run 3 mould none.json -o e
one_line "none.json"
run 3 mould "$path" -o e --stock none.stl
one_line "none.stl"

# walls and drafts that are asked for and not there: files, and 5
# shellcheck disable=SC2086
run 5 mould "$path" -o f $coarse --minimum-wall 151
grep -q "half: found a wall of 150 mm at (.*) mm, expected at least 151 mm" err || fail "$called: $(cat err)"
figures f/mould.json
# shellcheck disable=SC2086
run 5 mould "$design" -o f $coarse --minimum-draft 89
grep -q "draft" err || fail "$called: $(cat err)"
# shellcheck disable=SC2086
run 0 mould "$path" -o f $coarse --minimum-wall 149 --minimum-draft 3
value f/mould.json 'm["asked"]["draft_deg"] == 3'

# through top and bottom, and a stock: triangles alone, STEP files of an earlier run go
python3 - "$path" <<'EOF' >rising.json || fail "a rising path"
import json, sys
job = json.load(open(sys.argv[1]))
for m in "ab":
    p = job["path"][f"mount_{m}_mm"]
    job["path"][f"mount_{m}_mm"] = [[x, y, 150 + 0.4 * (y - 600)] for x, y, z in p]
json.dump(job, sys.stdout)
EOF
# shellcheck disable=SC2086
run 0 mould rising.json -o f $coarse
grep -q "no STEP files" err || fail "$called: does not say that there is no STEP: $(cat err)"
[ -e f/lower.step ] && fail "$called: lower.step of an earlier run is still there"
figures f/mould.json
value f/mould.json 'm["made_by"] == "booleans" and m["lower"]["exact_faces"] == 0 and m["lower"]["wall_mm"]["min"] is None'
python3 - <<'EOF' >stock.off || fail "a stock"
print("OFF\n5 6 0")
for p in ((20, 100, 20), (280, 100, 20), (280, 1000, 20), (20, 1000, 20), (150, 500, 280)): print(*p)
for t in ((0, 2, 1), (0, 3, 2), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)): print(3, *t)
EOF
# shellcheck disable=SC2086
run 0 mould "$path" -o g $coarse --stock stock.off
figures g/mould.json
value g/mould.json 'abs(m["block_volume_mm3"] / (260 * 900 * 260 / 3) - 1) < 1e-9 and m["lower"]["box_mm"][0][2] == 20'
sed '$d' stock.off | sed 's/5 6 0/5 5 0/' >open.off
# shellcheck disable=SC2086
run 3 mould "$path" -o g $coarse --stock open.off
one_line "not closed"
# halves that are registered to each other, a casting between them, colours and names of what they are, a layout for printing
# shellcheck disable=SC2086
run 0 mould "$design" -o l $coarse --keys lugs --key-radius 12 --key-height 10 --thickness 8 --layout print
figures l/mould.json
value l/mould.json 'm["lugs"] == 3 and m["asked"]["thickness_mm"] == 8 and abs(m["kerf_mm"]["max"] - 8) < 1e-9'
value l/mould.json 'm["lower"]["exact_faces"] == m["upper"]["exact_faces"] == 30 and m["volume_error"] < 1e-12'
grep -q "ADVANCED_FACE('cut face'" l/lower.step && grep -q COLOUR_RGB l/upper.step || fail "lower.step says not what it is"
python3 - l/mould.3mf <<'EOF2' || fail "mould.3mf"
import sys, zipfile, xml.etree.ElementTree as xml
ns = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
model = xml.fromstring(zipfile.ZipFile(sys.argv[1]).read("3D/3dmodel.model"))
names = [b.get("name") for b in model.iter(ns + "base")]
assert names == ["lower half", "cut face", "upper half", "cut face"], names
assert [o.get("name").split()[-1] for o in model.iter(ns + "object")] == ["lower", "upper"]
boxes = []
for item in model.iter(ns + "item"):
    m = [float(n) for n in item.get("transform").split()]
    mesh = next(o for o in model.iter(ns + "object") if o.get("id") == item.get("objectid"))
    points = [[float(v.get(k)) for k in "xyz"] for v in mesh.iter(ns + "vertex")]
    moved = [[sum(p[r] * m[3 * r + c] for r in range(3)) + m[9 + c] for c in range(3)] for p in points]
    boxes.append([[min(p[c] for p in moved), max(p[c] for p in moved)] for c in range(3)])
    assert any(t.get("p1") == "1" for t in mesh.iter(ns + "triangle")), "no cut face"
assert all(abs(b[2][0]) < 1e-9 and abs(b[1][0]) < 1e-9 for b in boxes), boxes
assert boxes[1][0][0] - boxes[0][0][1] > 5, boxes
EOF2
# shellcheck disable=SC2086
run 0 mould "$design" -o r $coarse --frame 15 --thickness 4
value r/mould.json 'abs(m["frame_volume_mm3"] / (300 * (430.4 * 930.4 - 400.4 * 900.4)) - 1) < 1e-9 and "frame.step" in m["files"]'
# shellcheck disable=SC2086
run 3 mould "$design" -o r $coarse --frame 15 --keys lugs
one_line "lugs and a frame"
# what falls short is named with its place, each
# shellcheck disable=SC2086
run 5 mould "$design" -o r $coarse --minimum-wall 200 --minimum-draft 89 -q
[ "$(grep -c 'at (.*) mm, expected at least' err)" = 4 ] || fail "not all are named: $(cat err)"
grep -q 'upper half.*: wall .* mm at (' r/report.html || fail "the page does not say where"

# a stock that the cut only touches, and one of bodies that share a face: the words say so
words="$SOURCE_DIR/../shared/found/geo/mould-words"
if [ -d "$words" ]; then
    python3 "$words/make.py"
    run 3 mould "$SOURCE_DIR/samples/jobs/steady-400-60.json" --stock touches.obj -o words -q --chord-tolerance 1
    one_line 'runs along a face of the stock'
    run 3 mould "$SOURCE_DIR/samples/jobs/steady-400-60.json" --stock step.obj -o words -q --chord-tolerance 1
    one_line 'runs along a face or through an edge of the stock near ('
    run 3 mould "$SOURCE_DIR/samples/jobs/steady-400-60.json" --stock shares.obj -o words -q --chord-tolerance 1
    one_line 'bodies that share a face or an edge, which are one body) near ('
else
    echo "note: no ../shared/found/geo/mould-words here"
fi
finish
