# wirecut compare: scans with a known truth, registration, gates, meshes, streams, bad scans; files whole, equal bytes.
. "$SOURCE_DIR/tests/apps/common.sh"
steady=$jobs/steady-400-60.json
scan=$SOURCE_DIR/samples/scans/steady-400-60.xyz
bumped=$SOURCE_DIR/samples/scans/freeform-4.ply

# look DEVIATION.json CODE: python that must hold of the result `d`
look() {
    python3 - "$@" <<'EOF' || fail "$called: not what was expected: $2"
import json, sys
d = json.load(open(sys.argv[1]))
near = lambda a, b, by: abs(a - b) <= by
assert d["format"] == "wirecut-deviation/1"
p = d["points"]
assert p["read"] == p["removed"] + p["outside"] + p["ambiguous"] + p["used"] or d["distance"] == "reconstruction", p
assert eval(sys.argv[2]), {k: v for k, v in d.items() if k not in ("zones", "registration", "as_scanned")}
EOF
}

# the kerf of a clean scan, in every file
run 0 compare "$steady" "$scan" -o a/b
no_result
no_leavings a
for name in deviation.ply deviation_mesh.ply deviation_mesh.obj zones.csv report.html deviation.json; do
    [ -s "a/b/$name" ] || fail "$called: no $name"
    grep -q "$name" err || fail "$called: $name is not named"
done
look a/b/deviation.json 'near(d["kerf_offset_mm"], -0.6, 0.003) and near(d["noise_rms_mm"], 0.05, 0.003) and d["form_rms_mm"] < 0.02'
look a/b/deviation.json 'near(d["kerf_mm"]["by_scan"], 1.2, 0.006) and p["used"] == 4000 and p["outside"] == 0'
look a/b/deviation.json 'd["registration"]["method"] == "none" and d["as_scanned"]["distance_mm"] == d["distance_mm"]'
look a/b/deviation.json 'len(d["scans"][0]["sha256"]) == 64 and {z["name"] for z in d["zones"]} >= {"entry", "steady", "exit", "patch 1 1"}'
look a/b/deviation.json '"time_since_entry" in d["correlation"] and len(d["worst"]) == 10 and d["hausdorff_face_to_scan_mm"] > 1'
LC_ALL=C grep -q "$(printf '[\r\033]')" err && fail "$called: progress was written to a file"

# the same bytes whatever the threads and the locale
(
    export LC_ALL=de_DE.UTF-8
    "$WIRECUT" compare "$steady" "$scan" -o again --quiet --json --threads 3 >json 2>err
) || fail "a second run: $(cat err)"
[ -s err ] && fail "--quiet is not quiet: $(cat err)"
diff -r a/b again >/dev/null || fail "two runs differ: $(diff -rq a/b again)"
cmp -s json again/deviation.json || fail "--json is not deviation.json"

# a bump is the worst area, a hole is unmeasured, and a registration hides a kerf but is always shown beside
run 0 compare "$jobs/freeform-4.json" "$bumped" -o bump --register fit --dof tz:free --quiet
look bump/deviation.json 'near(d["registration"]["parameters"]["tz_mm"]["value"], 0.48, 0.06) and d["registration"]["free"] == 1'
look bump/deviation.json 'abs(d["kerf_offset_mm"]) < 0.05 and near(d["as_scanned"]["kerf_offset_mm"], -0.48, 0.02)'
look bump/deviation.json 'near(d["worst"][0]["place_mm"][0], 300, 8) and near(d["worst"][0]["place_mm"][1], 250, 8) and d["worst"][0]["mean_mm"] > 0.5'
look bump/deviation.json '100 < d["unmeasured_mm2"] < 3.2 * 30**2'

# the gate
run 5 compare "$steady" "$scan" -o gate --tolerance 0.5 --quiet
look gate/deviation.json 'd["gate"]["within"] is False and near(d["gate"]["share"], 0.95, 1e-12)'
run 0 compare "$steady" "$scan" -o gate --tolerance 0.8 --bands 0.1,0.8 --quiet
look gate/deviation.json 'd["gate"]["within"] is True and [b["tolerance_mm"] for b in d["bands"]] == [0.1, 0.8]'

# distances to triangles, and to a mesh from a file: within the chord tolerance of those to the surface
run 0 compare "$steady" "$scan" -o mesh --distance mesh --quiet
look mesh/deviation.json 'd["distance"] == "mesh" and near(d["kerf_offset_mm"], -0.6, 0.01)'
run 0 simulate "$steady" -o surface --chord-tolerance 0.05 --quiet
for name in surface.stl surface.ply surface.obj; do
    run 0 compare "surface/$name" "$scan" -o mesh --quiet
    look mesh/deviation.json 'd["reference"].startswith("surface/") and near(d["kerf_offset_mm"], -0.6, 0.02) and "kerf_mm" not in d'
done
[ -e mesh/deviation_mesh.ply ] || fail "no coloured mesh of a mesh"

# beside a mesh, too: a fit, a reconstruction with both directions, the area without points
run 0 compare surface/surface.ply "$scan" -o mesh --register fit --dof tz:free --quiet
look mesh/deviation.json 'near(d["registration"]["parameters"]["tz_mm"]["value"], 0.6, 0.1) and abs(d["kerf_offset_mm"]) < 0.02'
run 0 compare surface/surface.ply "$scan" -o mesh --reconstruct field --quiet
look mesh/deviation.json 'near(d["reconstruction"]["scan_to_face_mm"]["mean"], -0.6, 0.02) and near(d["reconstruction"]["face_to_scan_mm"]["mean"], -0.6, 0.02)'
look mesh/deviation.json 'd["unmeasured_mm2"] >= 0 and d["reconstruction"]["vertices"] > 1000'
run 0 compare surface/surface.ply "$scan" -o mesh --distance reconstruction --quiet
look mesh/deviation.json 'd["distance"] == "reconstruction" and near(d["kerf_offset_mm"], -0.6, 0.02)'
printf 'OFF\n4 4 0\n0 0 0\n400 0 0\n0 1200 0\n0 0 300\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n' >solid.off
# zones with a tolerance each and sections along lines
cat >zones.json <<'EOF'
{"format": "wirecut-zones/1",
 "zones": [{"name": "inlet", "box_mm": [[0, 0, 0], [400, 300, 300]], "tolerance_mm": 0.8},
           {"name": "rim", "polygon_mm": [[50, 400], [350, 400], [200, 900]], "tolerance_mm": 0.3, "share_percent": 90},
           {"name": "outlet", "box_mm": [[0, 1000, 0], [400, 1200, 300]]}],
 "sections": [{"name": "B-B", "line_mm": [[200, 0], [200, 1200]], "width_mm": 20, "step_mm": 20}]}
EOF
run 5 compare "$steady" "$scan" -o zoned --zones zones.json --part "Panel 7"
grep -q 'zones: 1 of 2 within their tolerance; FAILED: rim' err || fail "$called: expected the verdicts: $(cat err)"
look zoned/deviation.json '[z["passed"] for z in d["user_zones"]] == [True, False, None] and d["zones_file"] == "zones.json"'
look zoned/deviation.json 'near(d["user_zones"][0]["mean_mm"], -0.6, 0.01) and near(d["sections"][0]["rms_mm"], 0.6, 0.02)'
grep -q '^rim,user,.*,0.3,0.9,0,fail$' zoned/zones.csv || fail "zones.csv: expected the verdict of rim: $(grep rim zoned/zones.csv)"
[ "$(grep -c '^B-B,' zoned/sections.csv)" -eq 60 ] || fail "sections.csv: expected 60 steps"
grep -q 'zones of the customer' zoned/report.html || fail "report.html: expected the zones"
sed 's/0.3, "share/0.9, "share/' zones.json >wide.json
run 0 compare "$steady" "$scan" -o zoned --zones wide.json --quiet
run 3 compare "$steady" "$scan" -o zoned2 --zones "$steady"; one_line '"wirecut-job/1", expected "wirecut-zones/1"'
untouched zoned2

# a face of a CAD file: exact, trimmed, one of several, in its own unit
run 0 compare surface/surface.step "$scan" -o cad --register fit --dof tz:free --quiet
look cad/deviation.json 'd["distance"] == "surface" and near(d["registration"]["parameters"]["tz_mm"]["value"], 0.6, 0.1)'
run 0 compare surface/surface.step "$scan" -o cad --reconstruct field --quiet
look cad/deviation.json 'near(d["kerf_offset_mm"], -0.6, 0.02)'
run 2 compare surface/surface.step "$scan" -o cad2 --reference-unit m; one_line "which states its unit"
run 3 compare "$steady" "$scan" -o cad2 --face 1; one_line "--face: expected a CAD file"
run 0 mould "$steady" -o half --formats step,stl --chord-tolerance 1 --quiet
run 3 compare half/lower.step "$scan" -o cad2; one_line "found 6 faces" "--face NAME or number"
run 3 compare half/lower.step "$scan" -o cad2 --face 9; one_line "found 6 faces"
run 0 compare half/lower.step "$scan" -o cad --face 1 --quiet
look cad/deviation.json 'd["distance"] == "surface"'
untouched cad2
run 3 compare solid.off "$scan" -o mesh --reconstruct field --quiet
one_line "solid.off" "expected an open sheet over a plane"
run 0 compare solid.off "$scan" -o mesh
grep -q "the triangles face" err && fail "$called: a closed mesh faces no way: $(cat err)"
run 0 compare surface/surface.ply "$scan" -o mesh --flip
grep -q "warning: the triangles faced up" err || fail "$called: no warning of a mesh turned wrongly"
look mesh/deviation.json 'near(d["kerf_offset_mm"], 0.6, 0.02)'

# more points than are to be held are streamed, to the same figures
run 0 compare "$steady" "$scan" -o streamed --hold 1000 --quiet
cmp -s streamed/deviation.ply a/b/deviation.ply || fail "a streamed scan leaves another deviation.ply"
python3 - <<'EOF' || fail "a streamed scan gives other figures"
import json
a, b = (json.load(open(f"{n}/deviation.json")) for n in ("a/b", "streamed"))
for d in (a, b): del d["sha256"]
same = [k for k in a if not k.startswith(("hausdorff_face", "face_to_scan"))]
assert all(a[k] == b[k] for k in same), [k for k in same if a[k] != b[k]]
EOF

# two files are one scan; cleaning is counted
head -n 2000 "$scan" >first.xyz
tail -n +2001 "$scan" >second.xyz
run 0 compare "$steady" first.xyz second.xyz -o two --quiet
look two/deviation.json 'len(d["scans"]) == 2 and p["read"] == 4000'
{ cat "$scan"; head -n 10 "$scan"; printf '200 600 260\n'; } >dirty.xyz
run 0 compare "$steady" dirty.xyz -o clean --duplicates --outliers 6 --quiet
look clean/deviation.json 'p["removed_as"]["duplicate"] == 10 and p["removed_as"]["outlier"] >= 1 and d["distance_mm"]["max"] < 1'
run 0 compare "$steady" dirty.xyz -o clean --thin 20 --quiet
look clean/deviation.json '1000 < p["removed_as"]["thinned"] < 3500'

# normals of the points, upwards, and of the reconstruction
run 0 compare "$steady" "$scan" -o normals --normals 16 --reconstruct field --quiet
python3 - <<'EOF' || fail "$called: normals are not what they should be"
import struct
for name in "deviation", "reconstruction":
    data = open(f"normals/{name}.ply", "rb").read()
    head, body = data.split(b"end_header\n", 1)
    size = {"double": 8, "uchar": 1}
    row = [l.split()[1:] for l in head.decode().split("\n") if l.startswith("property") and "list" not in l]
    at = {n: sum(size[t] for t, _ in row[:k]) for k, (_, n) in enumerate(row)}
    for k in range(1000):
        x, y, z = struct.unpack_from("<3d", body, k * sum(size[t] for t, _ in row) + at["nx"])
        assert z > 0.5 and abs(x * x + y * y + z * z - 1) < 1e-9, (name, k, x, y, z)
EOF
run 3 compare "$steady" "$scan" -o normals --normals 16 --hold 1000 --quiet
one_line "normals: found 4000 points"

# the vertices of a mesh are a scan, too
awk '{ print "v", $0 } END { print "f 1 2 3" }' "$scan" >scan.obj
{ printf 'OFF\n4000 1 0\n'; cat "$scan"; echo 3 0 1 2; } >scan.off
for name in scan.obj scan.off; do
    run 0 compare "$steady" $name -o vertices --quiet
    look vertices/deviation.json 'p["used"] == 4000 and near(d["kerf_offset_mm"], -0.6, 0.003)'
done

# datums: three points of the scan that are 2 mm off along y
awk '{ printf "%s %s %s\n", $1, $2 + 2, $3 }' "$scan" >moved.xyz
printf 'scan_x_mm,scan_y_mm,scan_z_mm,block_x_mm,block_y_mm,block_z_mm\n0,2,0,0,0,0\n400,2,0,400,0,0\n0,1202,0,0,1200,0\n0,2,300,0,0,300\n' >datum.csv
run 0 compare "$steady" moved.xyz -o datum --register datum --datum datum.csv --quiet
look datum/deviation.json 'near(d["registration"]["parameters"]["ty_mm"]["value"], -2, 1e-6) and near(d["kerf_offset_mm"], -0.6, 0.003)'

# reconstruction
run 0 compare "$steady" "$scan" -o made --reconstruct field --distance reconstruction --quiet
look made/deviation.json 'd["distance"] == "reconstruction" and near(d["kerf_offset_mm"], -0.6, 0.02) and d["reconstruction"]["vertices"] > 1000'
[ -s made/reconstruction.stl ] || fail "no reconstruction.stl"
run 0 compare "$steady" "$scan" -o made --quiet
[ -e made/reconstruction.stl ] && fail "an earlier run's reconstruction lies beside another result"

# units
awk '{ printf "%s %s %s\n", $1 / 1000, $2 / 1000, $3 / 1000 }' "$scan" >metres.xyz
run 0 compare "$steady" metres.xyz -o units
grep -q "warning: .* multiplied by 1000 it would fit" err || fail "$called: no warning of the unit: $(cat err)"
run 0 compare "$steady" metres.xyz -o units --unit m --quiet
look units/deviation.json 'near(d["kerf_offset_mm"], -0.6, 0.003)'
awk '{ printf "%s %s %s\n", $1 * 1000, $2 * 1000, $3 * 1000 }' "$scan" >micrometres.xyz
run 0 compare "$steady" micrometres.xyz -o units --unit um --quiet
look units/deviation.json 'near(d["kerf_offset_mm"], -0.6, 0.003)'
grep -q '"unit of the scan","text":"um"' units/report.html || fail "$called: the page does not name the unit"

# names of files are text, not markup
cp "$scan" '</script><script>window.broken=1<'"'"'.xyz' 2>/dev/null || cp "$scan" 'broken.xyz'
hostile=$(ls | grep broken)
run 0 compare "$steady" "./$hostile" -o hostile --quiet
grep -q '<script>window.broken' hostile/report.html && fail "a scan's name is markup in the report"

# wrong calls
run 2 compare "$steady" -o bad
one_line "SCAN is missing"
run 2 compare "$steady" "$scan" -o bad --bands 0.5,,1
one_line "--bands"
run 2 compare "$steady" "$scan" -o bad --dof tx:0.2 --register none
one_line "--dof"
for list in tx:0.2, q:1 tx:-1 tx:0.2mmm rz:0.1rd; do
    run 2 compare "$steady" "$scan" -o bad --register fit --dof "$list"
    one_line "--dof"
done
run 2 compare "$steady" "$scan" -o bad --register datum
one_line "--datum"
run 2 compare surface/surface.stl "$scan" -o bad --reconstruct solid
run 3 compare broken.json "$scan" -o bad
finish
