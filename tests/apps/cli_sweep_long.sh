# wirecut sweep under 50 kills of workers and one of the parent; 10,000 cases in memory that 100 cases need, too.
# labels: cli slow
. "$SOURCE_DIR/tests/apps/common.sh"
python3 "$SOURCE_DIR/tests/apps/sweep_kills.py" "$WIRECUT" "$jobs/freeform-1.json" 50 200 || fail "see above"

# the memory of the parent: its children are waited for, so that theirs is told apart
cat >memory.py <<'END'
import json, subprocess, sys
wirecut = sys.argv[1]
job = {"format": "wirecut-job/1", "name": "small path", "block": {"size_mm": [200, 300, 100]},
       "wire": {"diameter_mm": 0.15, "nodes": 21, "length_mm": 270},
       "process": {"heat_W_per_m": 60, "tension_N": 2, "force_law": {"a_N_per_mm": 0.1, "b_m2_per_J": 8.6e-4}},
       "path": {"mount_a_mm": [[-30, -5, 50], [-30, 305, 50]], "mount_b_mm": [[230, -5, 50], [230, 305, 50]]}}
json.dump(job, open("job.json", "w"))
peak = {}
for cases in (100, 10000):
    json.dump({"format": "wirecut-study/1", "name": "many", "verb": "identify", "input": "job.json", "options": {"cuts": 1},
               "parameters": {"/process/heat_W_per_m": {"from": 50, "to": 70, "count": cases}},
               "figures": {"format": "/format"}}, open("many.json", "w"))
    process = subprocess.Popen([wirecut, "sweep", "many.json", "-o", f"many{cases}", "-j", "2", "--quiet"])
    while process.poll() is None:
        try:
            for line in open(f"/proc/{process.pid}/status"):
                if line.startswith("VmHWM:"):
                    peak[cases] = int(line.split()[1])
        except OSError:
            pass
        try:
            process.wait(0.2)
        except subprocess.TimeoutExpired:
            pass
    assert process.returncode == 0, process.returncode
    assert sum(1 for _ in open(f"many{cases}/sweep.csv")) == cases + 1
print(f"VmHWM: {peak[100]} kB with 100 cases, {peak[10000]} kB with 10,000")
assert peak[10000] < peak[100] + 32 * 1024
END
python3 memory.py "$WIRECUT" || fail "memory, see above"
finish
