# labels: cli plain
# recordings of a blade that no simulator made, where they are: sliding is named from five cuts and from no less telling set;
# a blade's job through every verb that makes sense for it, and refused with a reason by the others
. "$SOURCE_DIR/tests/apps/common.sh"

# ---- the simulator ----
run 0 simulate "$jobs/blade-1.json" -o cut --chord-tolerance 1 --quiet
python3 - <<'EOF' || fail "the sample blade's force is not law times engaged length"
import csv, math
rows = list(csv.DictReader(open("cut/path.csv")))
force = [float(r["tension_a_N"]) + float(r["tension_b_N"]) for r in rows]
# 0.3 N/mm on (220 - 30) mm / cos 15 deg, which slides by tan 15 deg of its advance
expected = 0.3 * 190 / math.cos(math.radians(15)) * math.cos(math.radians(15)) ** 2
assert abs(max(force) - expected) < 0.2, (max(force), expected)
assert force[50] < 0.8 * expected, force[50] # lifted
assert abs(float(rows[-1]["time_s"]) - 400 / 12) < 2.5, rows[-1]["time_s"]
EOF
for verb in control score; do
    if [ $verb = score ]; then set -- score "$jobs/blade-1.json" cut/path.csv -o none; else set -- control "$jobs/blade-1.json" -o none; fi
    "$WIRECUT" "$@" --quiet >out 2>err && fail "$verb takes a blade"
    [ -s err ] || fail "$verb refuses a blade without a reason"
done

# ---- real recordings ----
real=$SOURCE_DIR/../shared/real
if [ ! -r "$real/test1.csv" ]; then
    echo "../shared/real is not here: left out"
    finish
fi
case_of() {
    python3 "$SOURCE_DIR/samples/real/make_case.py" "$real" "$@" || fail "make_case.py $*"
}
case_of five
run 0 diagnose five/case.json -o five/found --quiet
python3 - <<'EOF' || fail "five recordings: another diagnosis than that of samples/real/README.md"
import json
d = json.load(open("five/found/diagnosis.json"))
assert d["verdict"]["kind"] == "physics" and d["verdict"]["effects"] == ["slice_softening"], d["verdict"]
assert not d["verdict"]["alternatives"] and d["verdict"]["confidence"] > 0.8
low, high = d["effects"][0]["parameters"]["sliding_ratio"]["ci95"]
assert 0.4 < low < 1 < high < 3, (low, high)
out = {m: c["force"]["rmse"] for m, c in d["fit"]["held_out"].items()}
assert out["after"] < 0.75 * out["recalibrated"] and out["after"] < out["black_box"] and out["after"] < out["before"], out
assert d["mismatch"][0]["cut"] == 3 and d["mismatch"][0]["share_of_misfit"] > 0.2
assert any("engaged length" in limit for limit in d["limits"])
EOF
grep -q 'Sliding along the edge' five/found/report.html || fail "the page does not say what was found"
[ -s five/found/job-improved.json ] || fail "no corrected job"

# two of equal strategy, and what is left when the sliding is taken out, name nothing
case_of alike test1 test10
case_of low test2 test5
mkdir still
python3 - "$real" <<'EOF' || fail "cannot take the sliding out"
import csv, sys
for k in (1, 2, 5, 8, 10):
    rows = list(csv.DictReader(open(f"{sys.argv[1]}/test{k}.csv")))
    ratio = lambda r: -float(r["v_z_mm_s"]) / float(r["v_y_mm_s"])
    base = sum(map(ratio, rows[:10])) / 10
    with open(f"still/test{k}.csv", "w", newline="") as file:
        out = csv.DictWriter(file, rows[0].keys())
        out.writeheader()
        out.writerows(r for r in rows if abs(ratio(r) - base) < 0.12 * base)
EOF
python3 "$SOURCE_DIR/samples/real/make_case.py" still without
for name in alike low without; do
    run 0 diagnose $name/case.json -o $name/found --quiet
    python3 -c "import json, sys
v = json.load(open('$name/found/diagnosis.json'))['verdict']
sys.exit(v['effects'] != [] or v['kind'] == 'physics')" || fail "$name: an effect is named"
done
finish
