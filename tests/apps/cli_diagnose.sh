# wirecut diagnose: whole files, the same bytes on any number of threads, cuts without what they need, interruption.
# labels: cli slow
. "$SOURCE_DIR/tests/apps/common.sh"
python3 "$SOURCE_DIR/tests/apps/diagnose_fixture.py" case || fail "the fixture"
for k in 1 2 3; do
    run 0 control case/truth-$k.json -o loop --seed $k --tension-stop 40 --quiet
    mv loop/recording.csv case/recording-$k.csv
done
cat >case/calibration.csv <<'EOF'
heat_W_per_m,speed_mm_s,engaged_mm,tension_N,alpha_deg
50,15.2,300,2.02,22
60,18.1,300,1.97,22
60,21.3,300,2.01,35
85,26.0,300,2.0,22
EOF

# case_of FILE CALIBRATION CUT...: a case file; a cut is JOB:RECORDING:SCAN
case_of() {
    file=$1 table=$2 between=
    shift 2
    printf '{"format": "wirecut-case/1", "name": "small", "cuts": [' >"$file"
    for cut in "$@"; do
        scan=${cut##*:} rest=${cut%:*}
        [ -z "$scan" ] && scan=null || scan="\"$scan\""
        printf '%s{"job": "%s", "recording": "%s", "scan": %s}' "$between" "${rest%%:*}" "${rest#*:}" "$scan" >>"$file"
        between=', '
    done
    [ "$table" = null ] || table="\"$table\""
    printf '], "calibration": %s}\n' "$table" >>"$file"
}
# whole FOLDER CUTS [unproven]: files that parse, numbers that are probabilities, effects that are known
whole() {
    python3 - "$@" <<'EOF' || fail "$called: not the diagnosis that was expected"
import json, os, sys
folder = sys.argv[1]
d = json.load(open(folder + "/diagnosis.json"))
assert d["format"] == "wirecut-diagnosis/1" and d["case"] == "small", d["case"]
v = d["verdict"]
assert v["kind"] in ("none", "physics", "instrument", "both", "ambiguous", "unknown"), v
assert 0 <= v["confidence"] <= 1 and v["sentence"], v
assert bool(v["effects"]) == (v["kind"] in ("physics", "instrument", "both")), v
for e in d["effects"]:
    assert 0 <= e["confidence"] <= 1 and e["parameters"], e
for m in d["mismatch"]:
    assert 0 <= m["cut"] < int(sys.argv[2]) and m["time_s"][0] <= m["time_s"][1] and 0 <= m["p_value"] <= 1, m
assert d["recalibrated"]["a_N_per_mm"]["value"] > 0, d["recalibrated"]
assert (d["next_experiment"] is None) == (not os.path.exists(folder + "/next-experiment.json"))
for model in ("before", "recalibrated", "after"):
    assert bool(d["fit"][model]) == (len(sys.argv) < 4), d["fit"]
assert open(folder + "/report.html").read(200).startswith("<!doctype html>")
if d["correction"] is None: # withheld with a word
    assert d["withheld"] and not os.path.exists(folder + "/job-improved.json")
    sys.exit(0)
job = json.load(open(folder + "/job-improved.json"))
assert job["format"] == "wirecut-job/1" and job["process"]["force_law"] != {"a_N_per_mm": 0.1, "b_m2_per_J": 8.6e-4}
EOF
    no_leavings "$1"
}

case_of case/case.json calibration.csv job-1.json:recording-1.csv: job-2.json:recording-2.csv: job-3.json:recording-3.csv:
run 0 diagnose case/case.json -o a --threads 1
whole a 3
grep -q '^verdict ' out && grep -q '^RMSE over range' out || fail "$called: no table: $(cat out)"
grep -q 'in a: .*diagnosis.json' err || fail "$called: files are not named: $(cat err)"
run 0 diagnose case/case.json -o b --threads 2 --quiet --json
[ -s err ] && fail "$called: expected no words with --quiet: $(cat err)"
cmp -s out b/diagnosis.json || fail "$called: --json is not diagnosis.json"
run 0 diagnose case/case.json -o c --threads 3 --quiet
diff -r a b >differ || fail "one thread and two differ: $(head -c 300 differ)"
diff -r a c >differ || fail "one thread and three differ: $(head -c 300 differ)"
# what was found goes into any job: the first cut's is job-improved.json, another keeps its path and loses its excitation
run 0 apply a/diagnosis.json case/job-1.json -o applied-1.json
run 0 apply a/diagnosis.json case/job-2.json -o applied-2.json --json
python3 - <<'EOF' || fail "$called: not the jobs that were expected"
import json
a, b, c = (json.load(open(name)) for name in ("applied-1.json", "a/job-improved.json", "applied-2.json"))
assert a == b, "applied to the first cut's job is not job-improved.json"
assert c["process"]["force_law"] == a["process"]["force_law"] and c["path"] == json.load(open("case/job-2.json"))["path"]
assert "excitation" not in c
EOF
run 3 apply a/diagnosis.json case/case.json -o no.json
run 3 apply case/job-1.json case/job-1.json -o no.json
one_line '$.format' '"wirecut-diagnosis/1"'
run 4 apply a/diagnosis.json case/job-1.json -o nowhere/no.json
run 0 simulate a/job-improved.json -o improved --stations 40 --chord-tolerance 1 --quiet

# with what there is: it is said, the rest is diagnosed, and the exit code tells
sed 's/,tension_b_N,/,x_tension_b,/' case/recording-1.csv >case/no-channel.csv
awk -F, -v OFS=, '/^[0-9]/ { $7 = $8 = "" } 1' case/recording-2.csv >case/no-alpha.csv
case_of case/bad.json missing.csv job-1.json:nowhere.csv: job-1.json:no-channel.csv: job-1.json:recording-1.csv:none.ply \
    job-2.json:no-alpha.csv: none.json:recording-3.csv:
run 3 diagnose case/bad.json -o bad --no-proof
for text in nowhere.csv no-channel.csv none.ply none.json missing.csv; do
    grep -qF "$text" err || fail "$called: $text is not named: $(cat err)"
done
whole bad 5 unproven
case_of case/one.json null job-3.json:recording-3.csv:
run 0 diagnose case/one.json -o one --no-proof --without wire_thermal_lag,clock_offset --quiet
whole one 1 unproven
grep -q '"effects": \["wire_thermal_lag"\]' one/diagnosis.json && fail "an effect that was left out is named"

# an earlier next experiment does not stay beside another diagnosis
cp a/job-improved.json one/next-experiment.json
run 0 diagnose case/one.json -o one --no-proof --quiet
whole one 1 unproven

# stop SIGNAL STEP: the signal in that step of a diagnosis, which ends with 130 and says where it was
stop() {
    called="diagnose, $1 in step $2"
    code=0
    python3 "$SOURCE_DIR/tests/apps/terminal.py" --interrupt "$1" --after "$2" "$WIRECUT" \
        diagnose case/case.json -o cut --threads 2 || code=$?
    [ "$code" -eq 130 ] || fail "$called: exit code $code, expected 130: $(tail -c 300 terminal)"
    grep -q 'stopped on request while' terminal || fail "$called: nothing said: $(tail -c 300 terminal)"
    no_leavings cut
}
# marked STAGE: files that say that it was cut short, and where
marked() {
    python3 - "$1" <<'EOF' || fail "$called: not marked as cut short"
import json, sys
d = json.load(open("cut/diagnosis.json"))
assert d["interrupted"] is True and d["stopped"] == "while " + sys.argv[1], (d["interrupted"], d["stopped"])
assert "Stopped on request while " + sys.argv[1] in d["verdict"]["sentence"], d["verdict"]
page = open("cut/report.html").read()
assert "Stopped on request while " + sys.argv[1] in page
import os
if d["correction"] is None: # an unknown verdict: withheld
    assert d["withheld"] and not os.path.exists("cut/job-improved.json")
else:
    assert json.load(open("cut/job-improved.json"))["format"] == "wirecut-job/1"
EOF
    rm -rf cut
}
stop SIGINT 2
grep -q 'before anything was found' terminal || fail "$called: $(tail -c 300 terminal)"
untouched cut
stop SIGTERM 6
grep -q '"confidence": 0[,}]' cut/diagnosis.json || fail "$called: confidence in a verdict that was not reached"
marked "effects were fitted one by one"
# the proof is three steps before the last, however many the search has
stop SIGINT -3
marked "the forward proof was run"

# what cannot be
run 2 diagnose case/case.json -o x --without wire_termal_lag
one_line wire_termal_lag "did you mean wire_thermal_lag"
case_of case/none.json null job-1.json:nowhere.csv:
run 3 diagnose case/none.json -o x
grep -q 'no cut with a job and a recording' err || fail "$called: $(cat err)"
run 3 diagnose nowhere.json -o x
one_line nowhere.json
untouched x
finish
