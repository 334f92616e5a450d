# A job in closed loop: what is written and said, that the recording scores, and what is refused.
. "$SOURCE_DIR/tests/apps/common.sh"
job=$jobs/steady-400-60.json

run 0 control "$job" -o made --disturb law-a:1.25
no_result
grep -q '^with feedback: ' err || fail "no summary: $(cat err)"
grep -q '^plan alone: ' err || fail "no summary of the plan alone"
no_leavings made
python3 - made <<'EOF' || fail "control.json or recording.csv"
import csv, json, sys
d = json.load(open(sys.argv[1] + "/control.json"))
assert d["format"] == "wirecut-control/1" and d["disturbance"]["law_a"] == 1.25
assert d["files"] == ["recording.csv", "report.html", "control.json"]
with_feedback, alone = d["feedback"], d["plan_alone"]
assert with_feedback["complete"] and abs(with_feedback["steady"]["error_mean"]) < 0.05, with_feedback
assert abs(alone["steady"]["error_mean"] - 0.25) < 0.02, alone
rows = list(csv.DictReader(line for line in open(sys.argv[1] + "/recording.csv") if not line.startswith("#")))
assert len(rows) == with_feedback["samples"]
needed = "time_s station speed_a_mm_s speed_b_mm_s tension_a_N tension_b_N alpha_a_deg beta_a_deg alpha_b_deg " \
         "beta_b_deg speed_command_mm_s heat_W_per_m a_x_mm a_y_mm a_z_mm b_x_mm b_y_mm b_z_mm"
assert list(rows[0]) == needed.split(), list(rows[0])
steady = [float(r["tension_a_N"]) for r in rows if 100 < float(r["station"]) < 200]
assert abs(sum(steady) / len(steady) - 2) < 0.1
EOF

# the same bytes from the same seed, others from another
run 0 control "$job" -o again --disturb law-a:1.25 --json --quiet
[ -s err ] && fail "--quiet spoke: $(cat err)"
cmp -s out again/control.json || fail "--json is not the file"
for name in recording.csv control.json report.html; do
    cmp -s "made/$name" "again/$name" || fail "two runs, two $name"
done
run 0 control "$job" -o again --disturb law-a:1.25 --seed 2 --quiet
cmp -s made/recording.csv again/recording.csv && fail "two seeds, one recording"

# simulate -> control -> record -> score
run 0 control "$job" -o true
run 0 score "$job" true/recording.csv -o scored
python3 - scored/score.json <<'EOF' || fail "score.json"
import json, sys
cut = json.load(open(sys.argv[1]))["cuts"][0]
assert cut["replayed"]["tension"]["nrmsd"] < 0.1, cut["replayed"]["tension"]
assert cut["planned"]["alpha"]["nrmsd"] < 0.05, cut["planned"]["alpha"]
EOF

# the plan alone is recorded on request; a force that the law hides ends in a safe stop
run 0 control "$job" -o alone --no-feedback --quiet
grep -q '"recorded": "plan_alone"' alone/control.json || fail "not recorded with the plan alone"
run 5 control "$job" -o stopped --no-feedback --disturb law-b:0.75 --quiet
one_line 'safe stop: over-tension'
grep -q '"ended": "stop: over-tension"' stopped/control.json || fail "the stop is not in control.json"

# a design goes through its path curves
run 0 control "$jobs/freeform-2.json" -o design --disturb density:1.3,density-from:400,noise:0.05,delay:0.1 --quiet

# interrupted, it leaves the recording under a voucher that says it is a part
if command -v timeout >/dev/null; then
    code=0
    timeout -s INT 1 "$WIRECUT" control "$job" -o cut --period 0.002 --quiet 2>err || code=$?
    called="control, interrupted"
    [ -e cut/control.json ] && ! grep -q '"complete": false' cut/control.json && fail "$called: control.json says all of it is there"
    [ -e cut/report.html ] && fail "$called: report.html is there"
    no_leavings cut
fi

refused() {
    words=$1
    shift
    run 2 control "$job" -o refused "$@"
    one_line "$words"
    untouched refused
}
refused 'found "law-c:1"' --disturb law-c:1
refused 'did you mean law-a' --disturb lawa:1
refused 'law-a:NUMBER with a number from 0.01 to 100' --disturb law-a:-1
refused 'found "noise:nan"' --disturb noise:nan
refused 'found "noise:0x1"' --disturb noise:0x1
refused 'found "law-a"' --disturb law-a
refused 'found ""' --disturb law-a:1,,
refused '--period' --period 0
refused '--seed' --seed -1
run 3 control nowhere.json -o refused
run 3 control "$job" -o refused --tension-stop 1
one_line 'tension_stop: found 1'
run 2 control "$job"
run 4 control "$job" -o "made/recording.csv/in"
finish
