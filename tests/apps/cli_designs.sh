# A design where a path job is expected: control, score, identify and diagnose take it, and give what they give for the path
# job that wirecut simulate makes of it. And a force law of a file in a diagnosis.
# labels: cli plain
. "$SOURCE_DIR/tests/apps/common.sh"
cp "$jobs/freeform-2.json" design.json
run 0 simulate design.json -o plan --quiet
[ -s plan/job-path.json ] || fail "no job-path.json"

# the same loop, the same recording
run 0 control design.json -o loop-design --disturb noise:0.02 --quiet
run 0 control plan/job-path.json -o loop-path --disturb noise:0.02 --quiet
cmp -s loop-design/recording.csv loop-path/recording.csv || fail "control: a design and its path job differ"

# the same figures
run 0 score design.json loop-design/recording.csv -o score-design --quiet
run 0 score plan/job-path.json loop-design/recording.csv -o score-path --quiet
python3 - <<'EOF' || fail "score: a design and its path job differ"
import json
a, b = (json.load(open(f"score-{k}/score.json"))["cuts"][0] for k in ("design", "path"))
assert a["replayed"] == b["replayed"] and a["replayed"]["tension"]["rmsd"] > 0, a["replayed"]
assert a["planned"] == b["planned"], (a["planned"], b["planned"])
EOF

# the same identification cut
run 0 identify design.json -o id-design --cuts 1 --quiet
run 0 identify plan/job-path.json -o id-path --cuts 1 --quiet
python3 - <<'EOF' || fail "identify: a design and its path job differ"
import json
a, b = (json.load(open(f"id-{k}/identification-1.json")) for k in ("design", "path"))
assert a["path"] == b["path"] and a["excitation"] == b["excitation"] and a["wire"] == b["wire"]
EOF

# a case of designs, under the force law of a file
run 0 calibrate "$SOURCE_DIR/samples/calibration/table.csv" -o cal --quiet
for job in design.json plan/job-path.json; do
    printf '{"format": "wirecut-case/1", "name": "one", "cuts": [{"job": "%s", "recording": "loop-design/recording.csv", "scan": null}], "calibration": null}\n' $job >case.json
    run 0 diagnose case.json -o "found-$(basename $job .json)" --no-proof --threads 1 --quiet --force-law cal/force_law.json
done
python3 - <<'EOF' || fail "diagnose: a design and its path job differ, or the force law was not taken"
import json
a, b = (json.load(open(f"found-{k}/diagnosis.json")) for k in ("design", "job-path"))
assert a["verdict"] == b["verdict"] and a["recalibrated"] == b["recalibrated"], (a["verdict"], b["verdict"])
law = json.load(open("cal/force_law.json"))["force_law"]
assert a["recalibrated"]["a_N_per_mm"]["job"] == law["a_N_per_mm"], (a["recalibrated"], law)
assert a["recalibrated"]["b_m2_per_J"]["job"] == law["b_m2_per_J"], (a["recalibrated"], law)
EOF

# what an ordinary cell knows of itself changes nothing; a cell that knows more is believed
printf '{"format": "wirecut-case/1", "name": "one", "cuts": [{"job": "plan/job-path.json", "recording": "loop-design/recording.csv", "scan": null}], "calibration": null}\n' >case.json
run 0 diagnose case.json -o usual --no-proof --threads 1 --quiet --force-law cal/force_law.json --rig "$SOURCE_DIR/samples/rig.json"
python3 - <<'EOF' || fail "samples/rig.json is not the default"
import json
a, b = (json.load(open(f"{k}/diagnosis.json")) for k in ("usual", "found-job-path"))
changed = [k for k in a if k not in ("files", "sha256") and a[k] != b[k]]
assert not changed, changed
EOF
printf '{"format": "wirecut-rig/1", "scatter": {"wire_length_mm": 0}}\n' >bad.json
run 3 diagnose case.json -o bad --quiet --rig bad.json
one_line 'bad.json: $.scatter.wire_length_mm' 'found 0'
printf '{"format": "wirecut-rig/1", "scatter": {"wire_lenght_mm": 1}}\n' >bad.json
run 3 diagnose case.json -o bad --quiet --rig bad.json
one_line 'wire_lenght_mm'

# a design that cannot be cut is refused with its name
python3 -c 'import json
job = json.load(open("design.json"))
job["design"]["extra_length_mm"] = [[0, 0], [1, 0]]
json.dump(job, open("straight.json", "w"))'
run 3 control straight.json -o none --quiet
one_line straight.json 'no contact'
finish
