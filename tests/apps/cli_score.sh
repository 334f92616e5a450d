# wirecut score: a job with recordings and cases, files whole, bad cuts reported and not fatal, equal bytes.
. "$SOURCE_DIR/tests/apps/common.sh"
job=$jobs/steady-300-60.json
sed 's/"nodes": *[0-9]*/"nodes": 31/' "$job" >small.json
run 0 simulate small.json -o plan --stations 600 --chord-tolerance 5 --quiet
python3 - <<'EOF' || fail "the fixture's job"
import csv, json
job = json.load(open("small.json"))
rows = list(csv.DictReader(open("plan/path.csv")))
job["path"] = {f"mount_{m}_mm": [[float(r[f"{m}_{x}_mm"]) for x in "xyz"] for r in rows] for m in "ab"}
json.dump(job, open("job.json", "w"))
EOF
for name in c1 c2; do
    python3 "$SOURCE_DIR/tests/apps/score_fixture.py" $name job.json plan/path.csv || fail "the fixture $name"
done

# whole SCORE.json CUTS SCORED: the figures that the fixture must have
whole() {
    python3 - "$@" <<'EOF' || fail "$called: not the scores that were expected"
import json, sys
score = json.load(open(sys.argv[1]))
assert score["format"] == "wirecut-score/1" and len(score["cuts"]) == int(sys.argv[2]), score["cuts"]
good = [c for c in score["cuts"] if "error" not in c]
assert len(good) == int(sys.argv[3]), good
for cut in good:
    planned, replayed = cut["planned"], cut["replayed"]
    assert set(planned) >= {"speed", "tension", "alpha", "beta", "speed_a_mm_s", "beta_b_deg"}, planned.keys()
    assert "speed" not in replayed and {"tension", "alpha", "beta"} <= set(replayed), replayed.keys()
    # noise of 0.01 in every channel, and what a step of the plan is rough by
    assert 0.009 < planned["tension"]["rmsd"] < 0.03 and abs(planned["tension"]["bias"]) < 0.01, planned["tension"]
    assert 0.009 < replayed["alpha"]["rmsd"] < 0.2, replayed["alpha"]
    assert replayed["tension"]["rmsd"] < 0.08, replayed["tension"]
    assert cut["replay"]["failed"] == 0 and 0 < cut["counted"] < cut["samples"], cut
EOF
}

# a job and its recordings
run 0 score job.json c1/recording.csv c2/recording.csv -o a/b
no_result
no_leavings a
whole a/b/score.json 2 2
[ "$(head -n 1 a/b/residuals.csv | cut -d, -f1-6)" = "case,cut,time_s,station,phase,counted" ] || fail "residuals.csv: $(head -n 1 a/b/residuals.csv)"
lines=$(cat c1/recording.csv c2/recording.csv | wc -l)
[ "$(wc -l <a/b/residuals.csv)" -eq $((lines - 1)) ] || fail "residuals.csv: $(wc -l <a/b/residuals.csv) lines of $lines"
grep -q "<html" a/b/report.html || fail "report.html is no page"
for word in NRMSD planned replayed "2 of 2" score.json; do grep -q "$word" err || fail "$called: no $word in: $(cat err)"; done
LC_ALL=C grep -q "$(printf '[\r\033]')" err && fail "$called: progress was written to a file"

# cases, and the same bytes whatever the threads and the locale
run 0 score c1/case.json c2/case.json -o cases
whole cases/score.json 4 4
grep -q '^c2 ' err || fail "$called: no row of c2 in: $(cat err)"
(
    export OMP_NUM_THREADS=3 LC_ALL=de_DE.UTF-8
    "$WIRECUT" score c1/case.json c2/case.json -o again --quiet --json >json 2>err
) || fail "a second run: $(cat err)"
[ -s err ] && fail "--quiet is not quiet: $(cat err)"
diff -r cases again >/dev/null || fail "two runs differ: $(diff -rq cases again)"
cmp -s json again/score.json || fail "--json is not score.json"

# options reach the run
run 0 score job.json c1/recording.csv -o options --window 0 --settle 3 --leave 0.5 --nodes 15 --quiet --json
python3 - <<'EOF' || fail "options: $(head -c 300 out)"
import json
o = json.load(open("out"))
assert o["options"]["window_s"] == 0 and o["options"]["settle_s"] == 3 and o["options"]["leave_s"] == 0.5, o["options"]
assert o["cuts"][0]["replay"]["motion_scatter"] == 0
t = o["cuts"][0]["time_s"]
assert abs(t["from"] - t["contact"] - 3) < 1e-9 and abs(t["leave"] - t["to"] - 0.5) < 1e-9, t
EOF

# a bad cut is reported and not fatal: a missing recording, a broken one, a station outside, a job that is none
head -n 30 c1/recording.csv >backwards.csv
sed -n 5p c1/recording.csv >>backwards.csv
sed '40s/,[0-9.]*,/,900,/' c1/recording.csv >outside.csv
run 3 score job.json none.csv c1/recording.csv backwards.csv outside.csv -o bad
whole bad/score.json 4 1
for text in "none.csv" "backwards.csv: line 31: time_s" "outside.csv: line 40: station: found 900" "1 of 4 cuts scored"; do
    grep -q "$text" err || fail "$called: expected \"$text\" in: $(cat err)"
done
mkdir c3
printf '{"format": "wirecut-case/1", "name": "c3", "cuts": [{"job": "job.json", "recording": "r.csv"}], "calibration": null}' >c3/case.json
run 3 score c3/case.json c1/case.json nowhere/case.json -o bad2 --quiet
whole bad2/score.json 3 2
grep -q 'nowhere/case.json' err || fail "$called: the missing case is not named: $(cat err)"
run 3 score job.json none.csv -o bad
whole bad/score.json 4 1 # the earlier results

# what is no input at all
run 3 score c1/recording.csv c1/recording.csv -o x
one_line "c1/recording.csv"
run 3 score none.json c1/recording.csv -o x
printf '{"format": "wirecut-scan/1"}' >odd.json
run 3 score odd.json -o x
one_line 'found "wirecut-scan/1"'
run 2 score job.json -o x
one_line "job without recordings"
run 2 score job.json c1/recording.csv
run 2 score job.json c1/recording.csv -o x --window -1
printf '{"format": "wirecut-case/1", "name": "up", "cuts": [{"job": "../job.json", "recording": "r.csv"}]}' >c3/up.json
run 3 score c3/up.json -o x
one_line "c3/up.json: \$.cuts[0].job"
run 3 score job.json c1/recording.csv -o x --motion position
grep -q "a_x_mm" err || fail "$called: $(cat err)"
untouched x

# outputs that cannot be written
run 4 score job.json c1/recording.csv -o job.json
run 4 score job.json c1/recording.csv -o /dev/null/x
finish
