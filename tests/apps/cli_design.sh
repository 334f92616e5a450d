# wirecut design: a target's cut with everything that is written of it, the map alone, targets and words that are refused.
. "$SOURCE_DIR/tests/apps/common.sh"
targets=$SOURCE_DIR/samples/targets
process="--process $jobs/freeform-1.json"
quick="--stations 61 --nodes 31 --chord-tolerance 2 --feed +y"

# a saddle: the files, figures that agree, a job that simulates
# shellcheck disable=SC2086 # words
run 0 design "$targets/saddle.ply" --block 400,600,300 $process $quick --tolerance 1 -o saddle --json
for name in design.json job-path.json deviation.json feasibility.ply feasibility.png feasibility.json report.html summary.json surface.step; do
    [ -s "saddle/$name" ] || fail "$called: no $name"
done
python3 - <<'EOF' || fail "figures of a design"
import json
said, kept = json.load(open("out")), json.load(open("saddle/feasibility.json"))
assert said == kept, "--json is not feasibility.json"
assert kept["within"] and kept["design_mm"]["rms"] < 0.2 and kept["feed"] == "+y", kept
assert kept["rounds"][-1]["stations"] == 61 and kept["points"]["uncovered"] == 0, kept
found = json.load(open("saddle/deviation.json"))["found"]["distance_mm"] if "found" in json.load(open("saddle/deviation.json")) else json.load(open("saddle/deviation.json"))["distance_mm"]
assert abs(found["rms"] - kept["face_mm"]["rms"]) < 1e-9, (found, kept)
job = json.load(open("saddle/design.json"))
assert job["block"]["size_mm"] == [400, 600, 300] and job["name"] == "saddle.ply", job["name"]
EOF
run 0 verify saddle
run 0 simulate saddle/job-path.json -o again --chord-tolerance 2 --quiet
cmp -s saddle/path.csv again/path.csv || fail "the paths are not those of the job"

# the same bytes, whatever the threads
# shellcheck disable=SC2086
run 0 design "$targets/saddle.ply" --block 400,600,300 $process $quick --tolerance 1 -o threads --threads 3 --quiet
diff -r saddle threads >/dev/null || fail "threads change the result: $(diff -rq saddle threads)"

# the map alone; a sphere is refused as one cut
# shellcheck disable=SC2086
run 0 design "$targets/sphere.ply" --block 400,600,300 $process --feasibility-only -o map
python3 - <<'EOF' || fail "the map of a sphere"
import json
kept = json.load(open("map/feasibility.json"))
assert kept["domed_share"] > 0.99 and kept["not_followed"]["domed"] > 0.5 and "design_mm" not in kept, kept
EOF
[ -e map/design.json ] && fail "--feasibility-only wrote a design"
# shellcheck disable=SC2086
run 5 design "$targets/sphere.ply" --block 400,600,300 $process $quick -o sphere
grep -q "not held; the target is domed" err || fail "$called: no reason in: $(cat err)"

# the face of a cut as STEP and IGES, in metres there, one face or what is inside a border
cp saddle/surface.step face.step
python3 - <<'EOF'
import re
text = open("face.step", encoding="ascii").read()
assert ".MILLI." in text
open("metres.step", "w", encoding="ascii").write(re.sub(r"SI_UNIT\s*\(\s*\.MILLI\.", "SI_UNIT($", text))
EOF
# shellcheck disable=SC2086
run 0 design face.step --block 400,600,300 $process --feasibility-only --feed +y -o cad --json
python3 - <<'EOF' || fail "the map of the cut as a CAD face"
import json
kept = json.load(open("out"))
assert kept["predicted_mm"]["rms"] < 0.5 and kept["feed"] == "+y", kept
EOF
# shellcheck disable=SC2086
run 3 design metres.step --block 400,600,300 $process --feasibility-only -o no
one_line "the target fills" "not over the block"
# shellcheck disable=SC2086
run 3 design face.step --face 7 --block 400,600,300 $process --feasibility-only -o no
one_line "--face"
# shellcheck disable=SC2086
run 2 design face.step --unit inch --block 400,600,300 $process --feasibility-only -o no
one_line "--unit"
# shellcheck disable=SC2086
run 2 design "$targets/saddle.ply" --face 1 --block 400,600,300 $process --feasibility-only -o no
one_line "--face"

# heat and tension are those of the process job, unless options say otherwise
sed 's/"heat_W_per_m": *[0-9.]*/"heat_W_per_m": 71/' "$jobs/freeform-1.json" >hot.json
# shellcheck disable=SC2086
run 0 design "$targets/saddle.ply" --block 400,600,300 --process hot.json $quick --tolerance 1 -o hot --quiet
grep -q '"heat_W_per_m": 71' hot/design.json || fail "the heat is not that of the process job"

# what is refused, and nothing is left
# shellcheck disable=SC2086
run 3 design "$targets/saddle.ply" --block 400,600,300 $process --unit m -o no
one_line "the target fills" "differ by 1000"
# shellcheck disable=SC2086
run 3 design "$targets/saddle.ply" --block 400,600,100 $process -o no
one_line "not inside the block's height"
run 2 design "$targets/saddle.ply" --block 400,600 -o no
one_line "--block"
run 2 design "$targets/saddle.ply" --block 400,600,300 -o no
one_line "--process"
# shellcheck disable=SC2086
run 2 design "$targets/saddle.ply" --block 400,600,300 $process --place 1,2 -o no
one_line "--place"
python3 - <<'EOF'
# a sheet with a fin: an edge of three triangles
rows = [(x, y, 150) for y in range(0, 601, 100) for x in range(0, 401, 100)] + [(150, 300, 200)]
faces = [f for j in range(6) for i in range(4) for a in [5 * j + i + 1] for f in ((a, a + 1, a + 6), (a, a + 6, a + 5))]
faces.append((5 * 3 + 2, 5 * 3 + 3, len(rows)))
open("fin.obj", "w").write("".join("v %d %d %d\n" % p for p in rows) + "".join("f %d %d %d\n" % f for f in faces))
EOF
# shellcheck disable=SC2086
run 3 design fin.obj --block 400,600,300 $process -o no
one_line "three triangles or more"
echo "not a mesh" >bad.stl
# shellcheck disable=SC2086
run 3 design bad.stl --block 400,600,300 $process -o no
[ -e no ] && fail "a refused target left a folder"
finish
