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
EOF
run 0 verify out-1
grep -q "is removed" err && fail "$called: verify repeats the words of compensate"

# the same bytes, whatever the threads
run 0 compensate job.json --with improved.json -o out-2 --chord-tolerance 2 --threads 3 --quiet
diff -r out-1 out-2 >/dev/null || fail "threads change the result: $(diff -rq out-1 out-2)"

# what is refused
run 3 compensate job.json --with other.json -o no
one_line "other paths"
echo '{"format": "wirecut-case/1"}' >case.json
run 3 compensate job.json --with case.json -o no
run 2 compensate job.json -o no
one_line "--with"
[ -e no ] && fail "a refused compensation left a folder"
finish
