# Robot programs of a job: the files, the words about limits, --strict, and what is refused.
. "$SOURCE_DIR/tests/apps/common.sh"
job=$jobs/freeform-2.json

# wrote FORMAT FILE...: these and no others
wrote() {
    format=$1
    shift
    rm -rf made
    run 0 path "$job" --format "$format" -o made
    no_result
    no_leavings made
    [ -s made/path.json ] || fail "$called: no voucher"
    [ "$(ls made | grep -v '^path.json$' | tr '\n' ' ')" = "$* " ] || fail "$called: wrote $(ls made), expected $*"
    grep -q 'targets of 255 stations' err || fail "$called: no summary: $(cat err)"
}
wrote urscript wirecut_a.script wirecut_b.script
wrote rapid wirecut_a.mod wirecut_b.mod
wrote krl wirecut_a.src wirecut_b.src
wrote csv robot.csv
wrote json robot.json
python3 - made/robot.json <<'EOF' || fail "robot.json"
import json, sys
d = json.load(open(sys.argv[1]))
assert d["format"] == "wirecut-robot/1" and d["stations"] == 255 and 2 < len(d["targets"]) < 255
assert d["chord_error_mm"] <= 0.1 and d["targets"][0]["time_s"] == 0
assert abs(sum(t["duration_s"] for t in d["targets"]) - d["duration_s"]) < 1e-9
EOF

# 2 N on 0.15 mm are 113 MPa, which nickel-chromium bears at its temperature in air and Kanthal A does not: a warning, an
# error if asked; the verdict of simulate takes the same options
run 0 path "$job" --format csv -o made --strict
grep -q 'warning: stress' err && fail "a warning: $(cat err)"
kanthal='--cold-strength 725 --hot-strength 34'
run 0 path "$job" --format csv -o made $kanthal
grep -q 'warning: stress of the wire in air: 113' err || fail "no warning: $(cat err)"
run 0 simulate "$job" --nodes 31 --formats csv -o judged
grep -q '^feasible: ' err || fail "not feasible: $(cat err)"
run 0 simulate "$job" --nodes 31 --formats csv -o judged $kanthal
grep -q '^warning: infeasible: stress of the wire: 113' err || fail "feasible: $(cat err)"
run 5 path "$job" --format csv -o strict --strict $kanthal
one_line 'stress of the wire in air: 113' 'nothing was written'
untouched strict
run 0 path "$job" --format csv -o made --alpha 20
grep -q 'warning: alpha at mount A: .* limit 20 deg' err || fail "no warning of alpha: $(cat err)"

cp "$job" job
run 0 path "$job" --format rapid -o made --json --quiet --lead-in 20 --lead-out 30 --wire-on heater_on --tool-frame following
[ -s err ] && fail "--quiet spoke: $(cat err)"
python3 - <<'EOF' || fail "--json"
import json
d = json.load(open("out"))
assert d["format"] == "wirecut-path/1" and d["program"] == "rapid" and len(d["limits"]) == 10
assert d["files"] == ["wirecut_a.mod", "wirecut_b.mod", "path.json"] and len(d["sha256"]["wirecut_b.mod"]) == 64
# the design asks for 80 mm; what the curves between the stations keep is at most what the stations do
job = json.load(open("job"))
asked, size = job["design"]["clearance_mm"], job["block"]["size_mm"]
for c, mount in zip(d["clearance"], "AB"):
    p = c["at_mm"]
    off = sum(max(0, -x, x - s) ** 2 for x, s in zip(p, size)) ** 0.5
    assert c["mount"] == mount and abs(off - c["least_mm"]) < 2e-3, c
    assert asked - 1 < c["least_mm"] < asked + 1e-6 and 0 <= c["station"] <= 254, c
EOF
grep -q '^    heater_on;$' made/wirecut_a.mod || fail "the hook is not called"
grep -q '^ *heater_on;' made/wirecut_b.mod && fail "both robots switch the wire"

run 0 path "$jobs/steady-400-60.json" --format csv -o made
grep -q 'mount A: least distance from the block 60 mm, at station' err || fail "no clearance: $(cat err)"

# without -o into the folder it is called in
run 0 path "$job" --format krl --quiet
[ -s wirecut_a.src ] && [ -s wirecut_b.src ] || fail "no programs in the current folder"

# path mode, too; finer is more
run 0 path "$jobs/steady-400-60.json" --format csv -o coarse --chord-tolerance 1 --time-tolerance 10
run 0 path "$jobs/steady-400-60.json" --format csv -o fine --chord-tolerance 0.01 --time-tolerance 0.1
[ "$(wc -l <coarse/robot.csv)" -lt "$(wc -l <fine/robot.csv)" ] || fail "a finer tolerance, not more targets"

# what cells found: a standing mount turns, limits hold for the approach, no speed of 0, both sides start together
rig=$SOURCE_DIR/../shared/found/rig
if [ -d "$rig" ]; then
    swing=$rig/standing-mount-does-not-turn/job.json
    for format in urscript krl; do
        run 0 path "$swing" --format $format --tool-frame following -o turn-$format --quiet --lead-out clear
    done
    [ "$(grep -c 'movel' turn-urscript/wirecut_b.script)" -gt 5 ] || fail "the tool of the standing mount does not turn: urscript"
    [ "$(grep -c '^LIN' turn-krl/wirecut_b.src)" -gt 5 ] || fail "the tool of the standing mount does not turn: krl"
    grep -q 'BAS (#INITMOV,0)' turn-krl/wirecut_a.src && grep -q '^PTP' turn-krl/wirecut_a.src || fail "krl is not initialised"
    grep -q 'set_digital_out(1, False)' turn-urscript/wirecut_a.script || fail "the start signal is not reset"
    grep -q 'calls wire_on and wire_off, to be defined' turn-urscript/wirecut_b.script || fail "hooks are not in the head"

    run 0 path "$rig/approach-ignores-limits/job.json" --format urscript --speed 10 --acceleration 100 -o slow --quiet --lead-out clear
    grep -m 1 movel slow/wirecut_a.script | grep -q 'a=0.100000, v=0.010000' || fail "the approach ignores limits"
    run 0 path "$swing" --format rapid -o none --quiet --lead-out clear --wire-on none --wire-off none --preheat 3
    grep -q 'wire_o' none/wirecut_a.mod && fail "none is called all the same"
    grep -q 'WaitTime 3.000' none/wirecut_a.mod || fail "no preheat"

    run 0 path "$rig/krl-speed-prints-zero/job.json" --format krl -o zero --quiet --lead-out clear
    grep -q 'VEL.CP = 0\.0*$' zero/wirecut_b.src && fail "a speed is printed as 0"
    run 0 path "$rig/krl-arms-drift-by-printed-speed/job.json" --format krl -o drift --quiet --lead-out clear
    python3 - drift/wirecut_a.src drift/wirecut_b.src <<'EOF' || fail "the arms drift apart"
import math, re, sys
times = []
for name in sys.argv[1:]:
    place, speed, now, time = None, None, 0.0, []
    for line in open(name):
        if line.startswith("$VEL.CP"):
            speed = 1000 * float(line.split("=")[1])
        elif line.startswith("WAIT SEC") and place:
            now += float(line.split()[2])
        elif line.startswith("LIN"):
            p = [float(v) for v in re.findall(r"[XYZ] (-?[0-9.]+)", line)]
            if place:
                now += math.dist(p, place) / speed
            place = p
    times.append(now)
assert abs(times[0] - times[1]) < 0.01, times
EOF
else
    echo "skipped: no ../shared/found/rig here"
fi

rm -rf made
run 2 path "$job" -o made; one_line "--format"
run 2 path "$job" -o made --format gcode; one_line '"gcode"' 'urscript|rapid|krl|csv|json'
run 2 path "$job" -o made --format krl --sync-io 256; one_line "--sync-io"
run 2 path "$job" -o made --format krl --wire-on 'x();y'; one_line '--wire-on: found' 'expected a name of letters'
for word in 'urscript end' 'urscript if' 'rapid PROC' 'rapid MoveL' 'krl END' 'krl lin'; do
    run 2 path "$job" -o made --format ${word% *} --wire-off ${word#* }; one_line '--wire-off: found "'${word#* }'", a word of'
done
untouched made
run 2 path "$job" -o made --format krl --zone -1; one_line "--zone"
run 3 path nowhere.json -o made --format krl
run 4 path "$job" -o coarse/robot.csv/in --format krl
# a path that ends in the foam: refused with the way that would clear the block, and led out by that way
python3 -c 'import json, sys
job = json.load(open(sys.argv[1]))
for k in "ab":
    way = job["path"][f"mount_{k}_mm"]
    job["path"][f"mount_{k}_mm"] = way[:len(way) * 6 // 10]
json.dump(job, open("short.json", "w"))' "$jobs/steady-400-60.json"
run 3 path short.json --format csv -o inside --quiet
one_line 'station 184' 'in the foam' 'lead-out clear'
run 3 path short.json --format csv -o inside --quiet --lead-out 50
one_line 'would clear the block'
cp err refused
untouched inside
run 2 path short.json --format csv -o inside --quiet --lead-out clea
one_line 'or clear'
run 0 path short.json --format csv -o led --quiet --lead-out clear
python3 - <<'EOF' || fail "the wire is not led out of the block by the shortest way"
import csv
rows = list(csv.DictReader(open("led/robot.csv")))
before, last = rows[-2], rows[-1]
way = float(last["a_y_mm"]) - float(before["a_y_mm"])
refused = float(open("refused").read().split("a lead-out of ")[1].split(" mm")[0])
assert abs(way - refused) < 1 and last["station"] == "", (way, refused)

# the wire trails its mounts by the sag of the parabola; the block is 1200 mm long
assert 1201 < float(last["a_y_mm"]) < 1201 + 150, last
EOF

# an identification cut's programme: speeds follow its sines, heater steps call a procedure, in every format
python3 -c 'import json, sys
job = json.load(open(sys.argv[1]))
json.dump(job, open("plain.json", "w"))
job["excitation"] = {"speed": [{"amplitude": 0.06, "period_s": 3, "phase_rad": 1}],
                     "heat": [{"from_s": 11.3, "to_s": 18, "factor": 0.9}, {"from_s": 18, "to_s": 24.5, "factor": 1.1}]}
json.dump(job, open("excited.json", "w"))' "$jobs/steady-400-60.json"
for format in urscript rapid krl csv json; do
    run 0 path plain.json --format $format -o plain-$format --quiet --lead-out 300 --time-tolerance 0.005
    run 0 path excited.json --format $format -o excited-$format --lead-out 300
    grep -q 'excitation: 1 sines on the speed are in the programs, 2 heater steps call a procedure' err || fail "no word: $(cat err)"
done
python3 - <<'EOF' || fail "the programs do not follow the excitation"
import csv, json, math, re
calls = {"urscript": r"wire_heat\(([0-9.]+)\)", "krl": r"DO wire_heat \(([0-9.]+)\)", "rapid": r"wire_heat ([0-9.]+);"}
ends = {"urscript": "script", "krl": "src", "rapid": "mod"}
for name, call in calls.items():
    a, b = (open(f"excited-{name}/wirecut_{k}.{ends[name]}").read() for k in "ab")
    assert re.findall(call, a) == ["54.000", "66.000", "60.000"], (name, re.findall(call, a))
    assert not re.findall(call, b), name
rapid = open("excited-rapid/wirecut_a.mod").read()
assert len(re.findall(r'MoveLSync .*"wirecut_heat_\d+";', rapid)) == 3 and len(re.findall(r"PROC wirecut_heat_\d+\(\)", rapid)) == 3

# speed over that of the plain program at the same place is 1 + sum A sin(2 pi t / P + phase) once the wire is in
def rows(folder):
    return [{k: float(v or "nan") for k, v in r.items()} for r in csv.DictReader(open(folder + "/robot.csv"))]
plain, excited = rows("plain-csv"), rows("excited-csv")
def plain_speed(y):
    for p, q in zip(plain, plain[1:]):
        if p["a_y_mm"] < y <= q["a_y_mm"]:
            return q["speed_a_mm_s"]
begin = next(r["time_s"] for r in excited if r["station"] == 0)
pairs = []
for p, q in zip(excited, excited[1:]):
    y, t = (p["a_y_mm"] + q["a_y_mm"]) / 2, (p["time_s"] + q["time_s"]) / 2 - begin
    if not 250 < y < 1000 or not plain_speed(y):
        continue
    pace = 0.06 * math.sin(2 * math.pi * t / 3 + 1)
    pairs.append((q["speed_a_mm_s"] / plain_speed(y) - 1, pace))
slope = sum(a * b for a, b in pairs) / sum(b * b for _, b in pairs)
worst = max(abs(a - b) for a, b in pairs)
assert len(pairs) > 100 and abs(slope - 1) < 0.05 and worst < 0.02, (len(pairs), slope, worst)
heats = [(r["time_s"] - begin, r["heat_W_per_m"]) for r in excited if r["heat_W_per_m"] == r["heat_W_per_m"]]
assert [h for _, h in heats] == [54, 66, 60], heats
assert all(abs(t - w) < 0.021 for (t, _), w in zip(heats, (11.3, 18, 24.5))), heats
summary = json.load(open("excited-json/path.json"))
assert summary["sines"] == 1 and summary["heater_changes"] == 3, summary
EOF
run 2 path excited.json --format krl -o excited-krl --quiet --wire-heat none --lead-out 300
one_line 'expected a procedure to call'

# a sine that is shorter than the stations can follow is refused with the station
python3 -c 'import json
job = json.load(open("excited.json"))
job["excitation"]["speed"][0]["period_s"] = 0.5
json.dump(job, open("quick.json", "w"))'
run 3 path quick.json --format krl -o quick --lead-out 300 --quiet
one_line 'station' 'the path needs more stations'
finish
