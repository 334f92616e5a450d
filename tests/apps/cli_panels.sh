# wirecut design --panels: as few panels as hold a tolerance, their places and joints, jobs that run; what is refused.
# labels: cli plain
. "$SOURCE_DIR/tests/apps/common.sh"
targets=$SOURCE_DIR/samples/targets
process="--process $jobs/freeform-1.json"

# panels: a division that holds, the places and joints, jobs that run
# shellcheck disable=SC2086
run 0 design "$targets/sphere.ply" --block 400,600,300 $process --stations 41 --nodes 21 --feed +y --panels 3 --tolerance 1 -o panels --json
python3 - <<'EOF' || fail "figures of panels"
import json, os
kept = json.load(open("panels/feasibility.json"))
count = kept["across"] * kept["along"]
assert kept["within"] and 2 <= count <= 3 and len(kept["panels"]) == count and len(kept["joints"]) == count - 1, kept
assert kept["panels"][0]["low_mm"] == [0, 0] and kept["panels"][-1]["high_mm"] == [400, 600], kept["panels"]
assert all(0 <= j["step_mm"]["rms"] <= j["step_mm"]["max"] and j["places"] > 20 for j in kept["joints"]), kept["joints"]
assert sorted(os.listdir("panels")) == sorted(kept["files"]), os.listdir("panels")
job = json.load(open("panels/panel-1-job.json"))
low, high = kept["panels"][0]["low_mm"], kept["panels"][0]["high_mm"]
assert sorted(job["block"]["size_mm"][:2]) == sorted([high[0] - low[0], high[1] - low[1]]), job["block"]
EOF
run 0 verify panels
run 0 simulate panels/panel-2-job.json -o panel-2 --chord-tolerance 2 --quiet
# shellcheck disable=SC2086
run 2 design "$targets/sphere.ply" --block 400,600,300 $process --panels 0 -o no
one_line "--panels"
# shellcheck disable=SC2086
run 2 design "$targets/sphere.ply" --block 400,600,300 $process --tolerance 0 -o no
one_line "--tolerance"
[ -e no ] && fail "a refused call left a folder"
finish
