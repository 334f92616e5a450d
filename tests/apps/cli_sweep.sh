# wirecut sweep: a study's table is the same however it is run, what is whole is not run again, what is wrong is refused.
. "$SOURCE_DIR/tests/apps/common.sh"
cat >study.json <<END
{"format": "wirecut-study/1", "name": "heat and tension", "verb": "simulate", "input": "$jobs/freeform-1.json",
 "options": {"stations": 20, "nodes": 15, "formats": "csv"},
 "parameters": {"/process/heat_W_per_m": [50, 60], "/process/tension_N": {"from": 1, "to": 3, "count": 3}},
 "figures": {"duration_s": "/duration_s", "verdict": "/feasibility/verdict"},
 "best": {"figure": "duration_s", "goal": "lowest"}}
END

# study FIND BY: the study with a change
study() {
    python3 - "$1" "$2" <<'END'
import sys
text = open("study.json").read()
assert sys.argv[1] in text, sys.argv[1]
open("changed.json", "w").write(text.replace(sys.argv[1], sys.argv[2]))
END
}

run 0 sweep study.json -o a -j 2
no_result
no_leavings a
grep -q '^6 of 6 cases: done$' err || fail "$called: no summary: $(cat err)"
run 0 verify a --quiet
run 0 sweep study.json -o b --quiet --json
cmp -s out b/sweep.json || fail "$called: not the summary on standard output"
cmp -s a/sweep.csv b/sweep.csv || fail "the table depends on the number of processes"

# each row is what the verb itself says of such a job
python3 - "$WIRECUT" "$jobs/freeform-1.json" <<'END' || fail "not the figures of the verb"
import csv, json, subprocess, sys
rows = list(csv.DictReader(open("a/sweep.csv")))
assert [r["case"] for r in rows] == list("012345") and {r["status"] for r in rows} == {"done"}, rows
job = json.load(open(sys.argv[2]))
for r in (rows[0], rows[4]):
    job["process"]["heat_W_per_m"] = float(r["/process/heat_W_per_m"])
    job["process"]["tension_N"] = float(r["/process/tension_N"])
    json.dump(job, open("job.json", "w"))
    subprocess.run([sys.argv[1], "simulate", "job.json", "-o", "one", "--stations", "20", "--nodes", "15", "--formats",
                    "csv", "--quiet"], check=True)
    said = json.load(open("one/summary.json"))
    assert float(r["duration_s"]) == said["duration_s"] and r["verdict"] == said["feasibility"]["verdict"], (r, said)
manifest = list(csv.DictReader(open("a/manifest.csv")))
assert [m["hash"] for m in manifest] == [r["hash"] for r in rows]
best = json.load(open("a/sweep.json"))["best"]["cases"]
assert best[0]["value"] == min(float(r["duration_s"]) for r in rows)
END

# what is whole stays; what was damaged is run again, and the table is the same
cp a/sweep.csv kept.csv
echo >>"$(ls a/cases/*/*/path.csv | head -n 1)"
rm "$(ls a/cases/*/*/summary.json | tail -n 1)"
run 0 sweep study.json -o a -j 2
grep -q '^2 cases run, 4 were whole$' err || fail "$called: expected two cases to be run: $(cat err)"
cmp -s a/sweep.csv kept.csv || fail "the table changed"

# a further value runs what is new; options are parameters, too
study '[50, 60]' '[50, 60, 70]'
run 0 sweep changed.json -o a --resume
grep -q '^3 cases run, 6 were whole$' err || fail "$called: expected three cases to be run: $(cat err)"
study '"/process/heat_W_per_m": [50, 60]' '"--nodes": [15, 17]'
run 0 sweep changed.json -o c --quiet
[ "$(cut -d, -f3 c/sweep.csv | sort -u | tr '\n' ' ')" = '--nodes 15 17 ' ] || fail "not the nodes that were asked for"
run 0 sweep c --status
run 0 sweep c --collect --quiet

# a case whose input is refused is a row
study '[50, 60]' '[-1, 60]'
run 0 sweep changed.json -o d
grep -q '^3 of 6 cases: refused$' err || fail "$called: expected three refused: $(cat err)"
grep -q 'heat_W_per_m: found -1' d/cases/*/*/case.json || fail "no last words of a refused case"

# tasks take their shares
study '"name"' '"x-note": 1, "name"'
run 0 sweep changed.json -o e --slurm-script --tasks 4 --quiet
grep -q '^#SBATCH --array=0-3$' e/sweep.sbatch || fail "no batch script for four tasks"
for task in 2 0 3; do run 0 sweep e --task $task --tasks 4 --quiet; done
run 1 sweep e --status --json
grep -q '"missing": 2' out || fail "$called: expected two missing: $(cat out)"
run 0 sweep e --task 1 --tasks 4 --quiet
run 0 sweep e --collect --quiet
cmp -s e/sweep.csv kept.csv || fail "the tasks' table is another one"

run 0 sweep study.json --dry-run --json
python3 -c "
import json
d = json.load(open('out'))
assert d['cases'] == 6 and d['total_s'] > d['case_s'] > 0 and d['disk_bytes'] > 6 * 4096, d" || fail "$called: $(cat out)"

# what is wrong is said before anything is run
refuse() { # FIND BY WORDS...
    study "$1" "$2"
    shift 2
    run 3 sweep changed.json -o bad --quiet
    grep -qF -- "$1" err || fail "$called: expected \"$1\" in: $(cat err)"
    untouched bad
}
refuse heat_W_per_m heat_W_pre_m 'the nearest is /process/heat_W_per_m'
refuse '[50, 60]' '{"from": 1, "to": 1000, "count": 400000}' 'not of 1200000'
refuse '"simulate"' '"simulat"' 'such as simulate'
refuse '"nodes"' '"nods"' 'did you mean --nodes'
refuse '"nodes": 15' '"nodes": 1' '--nodes: found "1"'
refuse '"nodes"' '"json"' '--json, which a sweep sets itself'
refuse freeform-1 freeform-9 freeform-9.json
study /duration_s /duration
run 3 sweep changed.json -o f -j 2
grep -q '^warning: figure duration_s: .*the nearest is /duration_s$' err || fail "$called: no warning: $(cat err)"
[ ! -e f/sweep.csv ] || fail "a table without a figure"
run 2 sweep study.json
one_line --output

# rows of numbers and texts: a case of recordings, whose files go with it into the folder of each run
cp -r "$SOURCE_DIR/tests/fault/small/cA" recorded
cp recorded/case.json untouched.json
recording=cut-1/recording.csv
mkdir recorded/more
head -n 40 "recorded/$recording" >recorded/more/short.csv
cat >rows.csv <<END
/cuts/0/recording,/name
$recording,"whole, as it was"
more/short.csv,short
END
cat >recorded.json <<END
{"format": "wirecut-study/1", "name": "recordings", "verb": "score", "input": "recorded/case.json", "combine": "rows",
 "rows": "rows.csv", "figures": {"samples": "/cuts/0/samples"}}
END
run 0 sweep recorded.json -o h -j 2 --quiet
cmp -s untouched.json recorded/case.json || fail "the study's own case was changed"
python3 - "$WIRECUT" recorded/case.json <<'END' || fail "not the figures of the recordings"
import csv, glob, json, os, subprocess, sys
rows = list(csv.DictReader(open("h/sweep.csv")))
assert [r["/name"] for r in rows] == ["whole, as it was", "short"], rows
subprocess.run([sys.argv[1], "score", sys.argv[2], "-o", "alone", "--quiet"], check=True)
whole = json.load(open("alone/score.json"))["cuts"][0]["samples"]
assert float(rows[0]["samples"]) == whole > float(rows[1]["samples"]) > 0, (rows, whole)
links = [os.stat(p).st_nlink for p in glob.glob("h/cases/*/*/input/**/*.csv", recursive=True)]
assert len(links) >= 2 and min(links) > 1, links
END

# a file that changes makes the cases of its study new; a name that no case may have is the failure of its own case
head -n 60 "recorded/$recording" >recorded/more/short.csv
run 0 sweep recorded.json -o h
grep -q '^2 cases run, 0 were whole$' err || fail "$called: expected two cases to be run: $(cat err)"
printf '../outside.csv,outside\n' >>rows.csv
run 0 sweep recorded.json -o h
grep -q '^1 of 3 cases: refused$' err || fail "$called: expected one refused: $(cat err)"
grep -lqF "a name inside the case's folder" h/cases/*/*/case.json || fail "no last words of a name outside"
printf ',\n' >>rows.csv
run 3 sweep recorded.json -o bad --quiet
one_line 'a value in every row of column'

# two sweeps in one folder: the second refuses, and names the first
rm -rf g
"$WIRECUT" sweep study.json -o g --quiet &
first=$!
for _ in $(seq 200); do [ -e g/plan.json ] && break; sleep 0.01; done
run 4 sweep study.json -o g
one_line 'another sweep runs there: process'
wait $first || fail "the first of two sweeps failed"
cmp -s g/sweep.csv kept.csv || fail "the first of two sweeps has another table"
finish
