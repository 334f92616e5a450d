# wirecut diagnose on cases that lack something, one by one: it runs with what there is and says what could not be told.
# labels: cli slow
. "$SOURCE_DIR/tests/apps/common.sh"
python3 "$SOURCE_DIR/tests/apps/diagnose_fixture.py" case || fail "the fixture"
for k in 1 2 3; do
    run 0 control case/truth-$k.json -o loop --seed $k --tension-stop 40 --quiet
    mv loop/recording.csv case/recording-$k.csv
done
run 0 control case/truth-1.json -o loop --seed 9 --tension-stop 40 --quiet
mv loop/recording.csv case/recording-1-again.csv
run 0 simulate case/truth-2.json -o face --chord-tolerance 1 --quiet
mv face/surface.ply case/scan-2.ply
# steady test cuts of the true foam, 1 % of scatter in turn up and down
python3 - >case/table.csv <<'EOF'
import math
print("heat_W_per_m,speed_mm_s,engaged_mm,tension_N,alpha_deg")
for k, heat in enumerate((50, 50, 60, 60, 60, 70, 70, 70, 85, 85)):
    alpha, tension = (18, 27, 36)[k % 3], 2 * (1 + 0.01 * (-1) ** k)
    force = 2 * 2 * math.sin(math.radians(alpha)) / 300
    print(f"{heat},{1000 * heat * 9.1e-4 / math.log(0.09 / force):.2f},300,{tension},{alpha}")
EOF
awk -F, -v OFS=, '/^[0-9]/ { $2 *= 1.6 } 1' case/table.csv >case/other-foam.csv
python3 - <<'EOF' || fail "the bad recordings"
lines = open("case/recording-2.csv").read().split("\n")
head = next(i for i, line in enumerate(lines) if line.startswith("time_s"))
names = lines[head].split(",")
empty = [names.index(name) for name in ("beta_a_deg", "beta_b_deg")]
rows = [line.split(",") for line in lines[head + 1:] if line]
for row in rows:
    for i in empty:
        row[i] = ""
open("case/no-beta.csv", "w").write("\n".join(lines[:head + 1] + [",".join(row) for row in rows]) + "\n")
open("case/stopped.csv", "w").write("\n".join(lines[:head + 30]) + "\n")
EOF

# diagnosed CODE NAME TABLE CUT...: a case of cuts JOB:RECORDING:SCAN, diagnosed; whole files, whatever is missing
diagnosed() {
    code=$1 name=$2
    python3 - "$@" <<'EOF'
import json, sys
_, _, name, table, *cuts = sys.argv
parts = [dict(zip(("job", "recording", "scan"), (part or None for part in cut.split(":")))) for cut in cuts]
json.dump({"format": "wirecut-case/1", "name": name, "cuts": parts, "calibration": table or None}, open(f"case/{name}.json", "w"))
EOF
    run "$code" diagnose "case/$name.json" -o "$name" --no-proof --threads 2
    python3 - "$name" <<'EOF' || fail "$called: not a whole diagnosis"
import json, sys
d = json.load(open(sys.argv[1] + "/diagnosis.json"))
assert d["verdict"]["sentence"] and "interrupted" not in d and d["recalibrated"]["a_N_per_mm"]["value"] > 0
job = json.load(open(sys.argv[1] + "/job-improved.json"))
assert job["process"]["force_law"]["a_N_per_mm"] > 0
page = open(sys.argv[1] + "/report.html").read()
assert all(limit[:40] in page for limit in d["limits"]), "a limit is not on the page"
EOF
    no_leavings "$name"
}
# said TEXT...: every TEXT is among the limits of the last diagnosis; not_said TEXT: it is not
said() {
    for text in "$@"; do
        grep -qF "$text" "$name/diagnosis.json" || fail "$called: \"$text\" is not said: $(grep -A12 limits "$name/diagnosis.json")"
    done
}
not_said() {
    for text in "$@"; do
        grep -qF "$text" "$name/diagnosis.json" && fail "$called: \"$text\" is said"
    done
}
one=job-1.json:recording-1.csv: two=job-2.json:recording-2.csv:scan-2.ply three=job-3.json:recording-3.csv:

diagnosed 0 whole table.csv "$one" "$two" "$three"
not_said "is left out:" "With one cut" "Without a scan" "No cut has an excitation" "are empty" "one heat" "calibration table"

diagnosed 3 no-recording table.csv "$one" job-2.json:nowhere.csv: "$three"
grep -qF nowhere.csv err || fail "$called: the file is not named: $(cat err)"
said "Cut 2 is left out: it has no recording." "Without a scan"

diagnosed 0 no-scan table.csv "$one" job-2.json:recording-2.csv: "$three"
said "Without a scan kerf, springback and errors of the scanner cannot be determined."

diagnosed 0 empty-channels table.csv "$one" job-2.json:no-beta.csv:scan-2.ply "$three"
said "2 channels of the recordings are empty."

diagnosed 0 one-heat table.csv "$one" job-1.json:recording-1-again.csv:
said "All cuts have one heat" "No cut has an excitation"

diagnosed 0 one-cut "" "$three"
said "With one cut nothing can be held out" "one heat" "There is no calibration table"

diagnosed 0 other-foam other-foam.csv "$one" "$two" "$three"
said "The calibration table contradicts the cuts"

# a cut that was stopped before the wire was taut says nothing and costs the others nothing
diagnosed 0 stopped table.csv "$one" job-2.json:stopped.csv: "$three"
finish
