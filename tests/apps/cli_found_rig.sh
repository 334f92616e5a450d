# Recordings, robot programs and calibrations on which the command was once wrong, each with what is right; they lie beside
# the repository, in ../shared/found/rig. Those of it that are not here: cli_path (approach, standing mount, speeds of KRL),
# cli_units (slipped decimal, clock), cli_found_diagnose (diagnose-*). Where they are absent the test is skipped.
# labels: cli plain
. "$SOURCE_DIR/tests/apps/common.sh"
rig=$SOURCE_DIR/../shared/found/rig
if [ ! -d "$rig" ]; then
    echo "skipped: no $rig"
    exit 77
fi
said() { grep -q -- "$1" err || fail "$called: expected \"$1\" in: $(cat err)"; }

# every folder has a test: a new one fails here until it has
known="approach-ignores-limits back-out-through-the-own-slot calibration-slip-of-a-decimal
    diagnose-excitation-that-was-not-cut diagnose-names-a-gain-for-an-offset hook-that-nobody-defined
    identification-program-without-excitation krl-arms-drift-by-printed-speed krl-not-initialised krl-speed-prints-zero
    log-that-is-not-comma-separated score-prints-what-is-blind-to-bias stale-start-signal standing-mount-does-not-turn
    time-in-milliseconds-is-scored"
for folder in "$rig"/*/; do
    case " $(echo $known) " in *" $(basename "$folder") "*) ;; *) fail "no test of $folder" ;; esac
done

# a path that turns back in its own slot: what it is, and where
run 6 simulate "$rig/back-out-through-the-own-slot/job.json" -o slot --quiet --formats csv
one_line 'the path turns back by 180 deg at station 59' 'the slot that it has cut'

# identification cuts are cut as their job says: other speeds than the plain job's, a hook at every heater step
plain=$rig/identification-program-without-excitation/job.json
run 0 identify "$plain" -o id --quiet
for format in urscript krl rapid csv json; do
    run 0 path id/identification-1.json --format $format -o dither
    said '3 sines on the speed are in the programs, 3 heater steps call a procedure'
    run 0 path "$plain" --format $format -o plain --quiet
    [ "$(cat dither/wirecut_a.* dither/robot.* 2>/dev/null | diff - "$(ls plain/wirecut_a.* plain/robot.* 2>/dev/null | head -n 1)" |
        grep -c '^<')" -gt 200 ] || fail "$format: the programs of both jobs are alike"
    rm -rf dither plain
done

# blanks and tabs between columns, old line ends, an index without a name, a column that is not used and stands twice are read
logs=$rig/log-that-is-not-comma-separated
for name in space tab cr index twice; do run 0 score "$logs/job.json" "$logs/$name.csv" -o "log-$name" --quiet; done

# units and signs to which NRMSD is blind are seen at once
bias=$rig/score-prints-what-is-blind-to-bias
run 0 score "$bias/job.json" "$bias/right.csv" "$bias/grams.csv" "$bias/minus.csv" -o bias
said 'grams.csv: warning: tension_a_N is 195.7 N in the mean, .* it looks like grams'
said 'minus.csv: warning: tension_b_N is -1.922 N in the mean: .* the sign is turned'
[ "$(grep -c 'RMSE/range' err)" -eq 4 ] && [ "$(grep -c 'bias (mm/s, N, deg)' err)" -eq 4 ] || fail "$called: no rows of three cuts and their mean"
grep -q 'right.csv: warning' err && fail "a good recording is doubted: $(cat err)"
python3 - <<'END' || fail "table of a recording in grams"
rows = [line.split() for line in open("err") if "RMSE/range" in line]
tension = [float(row[2]) for row in rows]
assert tension[0] < 0.2 and tension[1] > 10 and tension[2] > 10, tension
END

# programs of a cell: nothing moves before the start signal is down, hooks are said, KRL begins as a controller asks for
run 3 path "$rig/stale-start-signal/job.json" --format urscript -o early --quiet
one_line 'in the foam' '--lead-out clear'
for format in urscript krl rapid; do
    run 0 path "$rig/stale-start-signal/job.json" --format $format -o start-$format --quiet --lead-out clear
    run 0 path "$rig/hook-that-nobody-defined/job.json" --format $format -o hook-$format --quiet --lead-out clear
    run 0 path "$rig/hook-that-nobody-defined/job.json" --format $format -o none-$format --quiet --lead-out clear --wire-on none --wire-off none
    grep -q 'wire_o[nf]' none-$format/wirecut_[ab].* && fail "$format: a hook that is not wanted is called"
    grep -h 'wire_on' hook-$format/wirecut_a.* | head -n 1 | grep -q 'to be defined' || fail "$format: the hook is not in the head"
done
run 2 path "$rig/hook-that-nobody-defined/job.json" --format urscript -o no --lead-out clear --wire-on end
one_line '--wire-on' 'a word of'
python3 - <<'END' || fail "the start signal is not reset before the first motion"
import re
folder = {"script": "start-urscript", "src": "start-krl"}
motion = {"script": r"\bmove[ljp]\(", "src": r"^\s*(PTP (?!\$AXIS_ACT)|LIN )"}
reset = {"script": r"set_digital_out\(\d+, False\)", "src": r"\$OUT\[\d+\] ?= ?FALSE"}
for ending in motion:
    for side in "ab": # RAPID has no such signal: its two tasks meet by name
        lines = open(f"{folder[ending]}/wirecut_{side}.{ending}").read().split("\n")
        first = next(k for k, line in enumerate(lines) if re.search(motion[ending], line))
        assert any(re.search(reset[ending], line) for line in lines[:first]), (ending, side, lines[:first][-5:])
END
run 0 path "$rig/krl-not-initialised/job.json" --format krl -o krl --quiet --lead-out clear
for side in a b; do
    awk '/BAS *\(#INITMOV,0\)/ { ready = 1 } /^ *(PTP|LIN)/ { print ready, $1; exit }' krl/wirecut_$side.src | grep -q '^1 PTP' ||
        fail "KRL is not initialised, or its first motion is no PTP: $(grep -n -m 3 'PTP\|LIN\|BAS' krl/wirecut_$side.src)"
done

finish
