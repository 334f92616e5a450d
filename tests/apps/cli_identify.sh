# wirecut identify: jobs with excitation that other verbs take, the same bytes for the same seed, what cannot be refused.
. "$SOURCE_DIR/tests/apps/common.sh"
sed 's/"nodes": *[0-9]*/"nodes": 31/' "$jobs/steady-300-60.json" >job.json

run 0 identify job.json -o a
no_result
no_leavings a
grep -q 'identification-2.json: .*backwards: speed varied by up to' err || fail "$called: no summary: $(cat err)"
run 0 identify job.json -o b --quiet --json
[ -s err ] && fail "$called: expected no words with --quiet: $(cat err)"
python3 - <<'EOF' || fail "$called: not the jobs that were expected"
import json
said = json.load(open("out"))
made = ["identification-1.json", "identification-2.json"]
assert said["format"] == "wirecut-identification/1" and said["files"] == made + ["identify.json"], said
plain = json.load(open("job.json"))
for k, name in enumerate(made):
    job = json.load(open("b/" + name))
    e = job["excitation"]
    assert len(e["speed"]) == 3 and all(3 <= s["period_s"] <= 12 and 0 < s["amplitude"] <= 0.055 for s in e["speed"]), e
    assert e["heat"] and all(6 <= h["to_s"] - h["from_s"] <= 14 and abs(abs(h["factor"] - 1) - 0.1) < 1e-9 for h in e["heat"]), e
    path = plain["path"]["mount_a_mm"]
    assert job["path"]["mount_a_mm"] == (path[::-1] if k else path)
EOF
for k in 1 2; do cmp -s a/identification-$k.json b/identification-$k.json || fail "identification-$k.json differs"; done
run 0 identify job.json -o c --seed 2 --quiet
cmp -s a/identification-1.json c/identification-1.json && fail "another seed makes the same cut"

# the loop runs such a cut; fewer cuts leave none of an earlier run
run 0 control a/identification-1.json -o loop --quiet
awk -F, 'NR > 2 && $12 != 60 { n++ } END { exit !(n > 20) }' loop/recording.csv || fail "no heater steps in the recording"
run 0 identify job.json -o a --cuts 1 --quiet
[ -e a/identification-2.json ] && fail "a cut of an earlier run was left"

run 2 identify job.json -o d --cuts 9
one_line cuts
run 3 identify missing.json -o d
one_line missing.json
untouched d

# a design is cut along the path that it becomes
run 0 identify "$jobs/freeform-1.json" -o design --quiet
grep -q '"path"' design/identification-1.json || fail "no path in the cut of a design"
finish
