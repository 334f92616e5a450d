# wirecut compensate: a wire that gets longer is compensated, files and figures agree, what is no machine is refused.
. "$SOURCE_DIR/tests/apps/common.sh"

# a curved cut, and the same on a machine whose wire gets longer by heat and whose angles are read with an offset
python3 - <<'EOF'
import json, math
stations = 61
a = [[-80, -120 + 15 * j, 150 + 25 * math.sin(0.08 * j)] for j in range(stations)]
b = [[480, -120 + 15 * j, 150 + 20 * math.sin(0.06 * j + 1)] for j in range(stations)]
job = {"format": "wirecut-job/1", "name": "curved", "block": {"size_mm": [400, 600, 300]},
       "wire": {"diameter_mm": 0.15, "nodes": 31, "length_mm": 640},
       "process": {"heat_W_per_m": 65, "tension_N": 2, "force_law": {"a_N_per_mm": 0.1, "b_m2_per_J": 8.6e-4}},
       "path": {"mount_a_mm": a, "mount_b_mm": b}}
json.dump(job, open("job.json", "w"))
job["effects"] = [{"name": "wire_elongation", "strain_at_60W_2N": 0.004}, {"name": "angle_offset", "channel": "alpha_a_deg", "offset_deg": 1}]
json.dump(job, open("improved.json", "w"))
job["path"]["mount_a_mm"] = a[:-1]
job["path"]["mount_b_mm"] = b[:-1]
json.dump(job, open("other.json", "w"))
EOF
run 0 compensate job.json --with improved.json -o out-1 --chord-tolerance 2 --json
python3 - <<'EOF' || fail "figures of a compensation"
import json
said, kept = json.load(open("out")), json.load(open("out-1/compensation.json"))
assert said == kept, "--json is not compensation.json"
assert kept["removed"] > 0.8 and kept["worth_it"] and kept["target"] is None, kept
assert kept["after_mm"]["rms"] < kept["before_mm"]["rms"] and kept["smaller_mm"]["after_rms"] < kept["smaller_mm"]["before_rms"], kept
job = json.load(open("out-1/job-corrected.json"))
assert [e["name"] for e in job["effects"]] == ["wire_elongation"], job["effects"]
assert len(job["path"]["mount_a_mm"]) == 61
assert kept["ends"] == "spread" and kept["spread"] == 0.1 and kept["branch_station"] is None, kept
assert [e["name"] for e in kept["effects"]] == ["wire_elongation"], kept["effects"]
assert abs(kept["effects"][0]["moves_mm"] - kept["before_mm"]["rms"]) < 1e-9, kept["effects"]
page = open("out-1/report.html").read()
assert "What it is worth" in page and "wire_elongation" in page
EOF
run 0 verify out-1
grep -q "is removed" err && fail "$called: verify repeats the words of compensate"

# the same bytes, whatever the threads
run 0 compensate job.json --with improved.json -o out-2 --chord-tolerance 2 --threads 3 --quiet
diff -r out-1 out-2 >/dev/null || fail "threads change the result: $(diff -rq out-1 out-2)"

# a diagnosis: the gain at the ends of its interval; an effect that hardly moves the face is not worth it
python3 - <<'EOF'
import json
effects = [{"name": "wire_elongation", "strain_at_60W_2N": 0.004}, {"name": "end_cooling", "amplitude": 0.001, "length_mm": 20}]
found = {"format": "wirecut-diagnosis/1",
         "correction": {"a_N_per_mm": 0.1, "b_m2_per_J": 8.6e-4, "length_change_mm": 0, "kerf": None, "effects": effects},
         "effects": [{"name": "wire_elongation", "parameters": {"strain_at_60W_2N": {"value": 0.004, "ci95": [0.002, 0.006]}}}]}
json.dump(found, open("diagnosis.json", "w"))
found["effects"][0]["parameters"]["strain_at_60W_2N"]["ci95"] = [0.002, "much"]
json.dump(found, open("no-interval.json", "w"))
EOF
run 0 compensate job.json --with diagnosis.json -o out-3 --chord-tolerance 2
grep -q "ends of the effects' 95 % intervals" err || fail "$called: no interval in: $(cat err)"
grep -q "end_cooling alone moves the face" err || fail "$called: no effect that is not worth it in: $(cat err)"
python3 - <<'EOF' || fail "figures at the ends of an interval"
import json
kept = json.load(open("out-3/compensation.json"))
assert kept["ends"] == "ci95" and "spread" not in kept, kept
assert kept["smaller_mm"]["before_rms"] < 0.7 * kept["before_mm"]["rms"] < 0.7 * kept["larger_mm"]["before_rms"], kept
assert [e["worth_it"] for e in kept["effects"]] == [True, False], kept["effects"]
EOF
run 3 compensate job.json --with no-interval.json -o no
one_line "ci95" "interval"

# what is refused
run 3 compensate job.json --with other.json -o no
one_line "other paths"
echo '{"format": "wirecut-case/1"}' >case.json
run 3 compensate job.json --with case.json -o no
sed 's/"nodes": 31/"nodes": -1/' improved.json >bad.json
run 3 compensate job.json --with bad.json -o no
one_line "bad.json" '$.wire.nodes'
run 2 compensate job.json -o no
one_line "--with"
run 3 compensate job.json --with improved.json --force-law any.json -o no
one_line "any.json"
"$WIRECUT" calibrate "$SOURCE_DIR/samples/calibration/table.csv" -o law -q || fail "no force law"
run 2 compensate job.json --with improved.json --force-law law/force_law.json -o no
one_line "--force-law" "machine's law"
[ -e no ] && fail "a refused compensation left a folder"
finish
