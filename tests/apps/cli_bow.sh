# A bow from the command line: its sample jobs, what simulate writes of them, one robot's programs, and every other verb; bad input.
. "$SOURCE_DIR/tests/apps/common.sh"
bow=$SOURCE_DIR/samples/bow

# the sample jobs are what their script makes
python3 "$SOURCE_DIR/samples/make_bow_jobs.py" again || fail "make_bow_jobs.py"
for name in ruled wing box; do
    cmp -s "$bow/$name.json" "again/$name.json" || fail "$name.json is not what make_bow_jobs.py makes"
done

# each is cut to its end, feasible, with the files of a bow
for name in ruled wing box; do
    run 0 simulate "$bow/$name.json" -o "$name" --formats csv
    grep -q '^feasible: ' err || fail "$name: $(cat err)"
    grep -q 'the wire bows by' err || fail "$name: no word of its bow: $(cat err)"
    [ "$(ls "$name" | tr '\n' ' ')" = 'bow.csv bow.json bow_map.csv feed_chart.csv path.csv report.html summary.json ' ] ||
        fail "$name: wrote $(ls "$name" | tr '\n' ' ')"
    no_leavings "$name"
done
grep -q 'Bow of the wire' ruled/report.html || fail "report.html has no section of the bow"
python3 - <<'EOT' || fail "files of a bow"
import csv, json
for name in ("ruled", "wing", "box"):
    d = json.load(open(f"{name}/bow.json"))
    rows = list(csv.DictReader(open(f"{name}/bow.csv")))
    assert d["format"] == "wirecut-bow/1" and d["stations"] == len(rows)
    assert abs(max(float(r["bow_mm"]) for r in rows) - d["bow"]["max_mm"]) < 1e-12
    force = max(sum(float(r[f"force_{c}_N"]) ** 2 for c in "xyz") ** 0.5 for r in rows)
    assert abs(force - d["force_max_N"]) < 1e-9 * force
    worst = max((abs(float(r["departure_mm"])) for r in csv.DictReader(open(f"{name}/bow_map.csv"))))
    assert abs(worst - abs(d["departure"]["max_mm"])) < 1e-12
    chart = list(csv.DictReader(open(f"{name}/feed_chart.csv")))
    assert len(chart) == 33 and all(float(r["feed_allowed_mm_s"]) <= float(r["feed_mm_s"]) for r in chart)
# plane faces stay plane however the wire bows; a twisted one does not
box, ruled = (json.load(open(f"{n}/bow.json"))["departure"]["max_mm"] for n in ("box", "ruled"))
assert abs(box) < 1e-3 < 0.05 < abs(ruled), (box, ruled)
# slower round the edge: the wire is straight there
rows = list(csv.DictReader(open("box/path.csv")))
bow = [float(r["bow_mm"]) for r in csv.DictReader(open("box/bow.csv"))]
slow = min(range(len(rows)), key=lambda j: float(rows[j]["speed_a_mm_s"]))
assert abs(float(rows[slow]["speed_a_mm_s"]) - 2) < 1e-6 and bow[slow + 20] < 0.1 * max(bow)
EOT

# one program for one robot, that waits for no other
programs() {
    run 0 path "$bow/wing.json" --format "$1" -o "$1"
    [ "$(ls "$1" | tr '\n' ' ')" = "$2" ] || fail "$called: wrote $(ls "$1" | tr '\n' ' '), expected $2"
}
programs urscript 'path.json wirecut.script '
programs rapid 'path.json wirecut.mod '
programs krl 'path.json wirecut.src '
programs csv 'path.json robot.csv '
programs json 'path.json robot.json '
for file in urscript/wirecut.script rapid/wirecut.mod krl/wirecut.src; do
    grep -qiE 'sync|digital|\$(in|out)\[|mount [AB]|run id' "$file" && fail "$file speaks of another robot"
    grep -q 'one arm that holds the wire by both ends' "$file" || fail "$file does not say what it is for"
done
python3 - <<'EOT' || fail "poses of one robot"
import csv, json, re
job = json.load(open("again/wing.json"))
pose = job["path"]["tool"]
targets = json.load(open("json/robot.json"))["targets"]
rows = list(csv.DictReader(open("csv/robot.csv")))
rapid = re.findall(r"MoveL \[\[([^\]]*)\],\[([^\]]*)\]", open("rapid/wirecut.mod").read())
assert len(targets) == len(rows) == len(rapid) > 10
for t, r, (at, turn) in zip(targets, rows, rapid):
    p = pose[t["station"]]
    assert max(abs(a - b) for a, b in zip(p, t["tool"]["at_mm"] + t["tool"]["frame_wxyz"])) < 1e-9
    assert max(abs(float(r[k]) - v) for k, v in zip(("x_mm", "y_mm", "z_mm"), p)) < 6e-4
    assert max(abs(float(a) - b) for a, b in zip((at + "," + turn).split(","), p)) < 6e-4
assert abs(targets[-1]["time_s"] - sum(t["duration_s"] for t in targets)) < 1e-9
EOT

# a mould divides the block along the face of a bow
run 0 mould "$bow/ruled.json" -o mould --formats stl
[ -s mould/mould.json ] || fail "no mould"

# its own path as a recording and its own surface as a scan come back as they are
run 0 score "$bow/ruled.json" ruled/path.csv -o score
python3 - <<'EOT' || fail "a bow does not come back as its own recording"
import json
for kind in ("planned", "replayed"):
    mean = json.load(open("score/score.json"))["mean"][kind]
    assert mean["tension"]["rmsd"] < (1e-6 if kind == "planned" else 0.05), (kind, mean["tension"])
EOT
run 0 simulate "$bow/ruled.json" -o scan --formats ply --quiet
run 0 compare "$bow/ruled.json" scan/surface.ply -o compare
python3 - <<'EOT' || fail "the face of a bow does not lie half a kerf below its wire"
import json
d = json.load(open("compare/deviation.json"))
assert abs(d["distance_mm"]["mean"] - 1.695 / 2) < 0.02, d["distance_mm"]
EOT

# verbs that make no sense for a bow say why, and write nothing
refuse() {
    reason=$1
    shift
    run 3 "$@" -o none
    one_line 'rig.kind: found bow, expected two_arms' "$reason"
    untouched none
}
refuse 'the loop holds the tension' control "$bow/ruled.json"
refuse 'varied by feed.profile' identify "$bow/ruled.json"
refuse 'moves the mounts against each other' compensate "$bow/ruled.json" --with "$bow/ruled.json"
refuse 'a design shapes a slack wire' design scan/surface.ply --block 400,300,200 --process "$bow/ruled.json"

# bad input
change() {
    sed "$1" "$bow/ruled.json" >bad.json
    cmp -s bad.json "$bow/ruled.json" && fail "nothing changed by $1"
    run 3 simulate bad.json -o bad
    shift
    one_line "$@"
    untouched bad
}
change 's/"stiffness_N_per_mm": 4/"stiffness_N_per_mm": 0.06/' 'found 0.06, expected more than 0.0692' 'buckles'
change 's/"pretension_N": 36/"pretension_N": 136/' 'found 136, expected at most 101.8 N' '810 MPa'
change 's/"speed_mm_s": 10/"speed_mm_s": 110/' 'found 110, expected a speed within the job'
change 's/"tool": \[\[200.0, -10.0, 100.0, 1.0/"tool": [[200.0, -10.0, 100.0, 1.1/' 'expected a rotation'
finish
