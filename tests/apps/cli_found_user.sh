# Designs and tables of new users on which the command once said nothing, each with what is right; they lie beside the
# repository, in ../shared/found/user. Blocks that do not fit: cli_simulate; the curves themselves: test_found_curves; datums
# far away: cli_found_geo. Where they are absent the test is skipped.
# labels: cli plain
. "$SOURCE_DIR/tests/apps/common.sh"
user=$SOURCE_DIR/../shared/found/user
if [ ! -d "$user" ]; then
    echo "skipped: no $user"
    exit 77
fi
said() { grep -q -- "$1" err || fail "$called: expected \"$1\" in: $(cat err)"; }
known="datum_far.csv design-in-metres-of-block.json design-longer-than-block.json design-thicker-than-block.json
    edges_fc_gui.step extra200.json g1.csv g2.csv g3.csv g4.csv g5.json g6.json g7.json hightension.json loop.json
    metres.json outofblock.json swapped.json t_rad.csv"
for file in "$user"/*; do
    case " $(echo $known) " in *" $(basename "$file") "*) ;; *) fail "no test of $file" ;; esac
done

# speeds are way over time of the same file, and none is beyond the limit without a word
for name in extra200 hightension; do
    run 0 simulate "$user/$name.json" -o $name --formats csv
    python3 - $name/path.csv "$(grep -c 'speed of a mount' err)" <<'END' || fail "$name: speeds of the mounts"
import csv, math, sys
rows = [{k: v for k, v in r.items()} for r in csv.DictReader(open(sys.argv[1]))]
top = 0
for a, b in zip(rows, rows[1:]):
    dt = float(b["time_s"]) - float(a["time_s"])
    for m in "ab":
        way = math.dist(*([float(r[f"{m}_{k}_mm"]) for k in "xyz"] for r in (a, b)))
        assert abs(way / dt - float(b[f"speed_{m}_mm_s"])) < 1e-6 * (1 + way / dt), (b["station"], m)
        top = max(top, way / dt)
assert top <= 100 * (1 + 1e-9) or int(sys.argv[2]) > 0, top
END
done

# a wire at 145 to 165 deg, an edge that runs in a loop: infeasible, and why
run 0 simulate "$user/swapped.json" -o swapped --formats csv
said 'infeasible: the wire stands at 168.5 deg to its rest direction at station 251, more than 100: edges exchanged'
run 0 simulate "$user/loop.json" -o loop --formats csv
said 'infeasible: edge A runs in a loop'
run 3 simulate "$user/metres.json" -o metres
one_line 'design.extra_length_mm in the same unit' 'they differ by 1000'

# two edge curves as people write them down, for a mould
for name in edges_fc_gui.step g1.csv g2.csv g3.csv g4.csv g5.json g6.json g7.json; do
    run 0 mould "$jobs/freeform-1.json" --edges "$user/$name" -o mould --quiet --chord-tolerance 2 --stations 41 --formats stl
    python3 -c 'import json; m = json.load(open("mould/mould.json")); assert m["lower"]["volume_mm3"] > 1e6 and m["upper"]["volume_mm3"] > 1e6' ||
        fail "$called: no halves"
done

# radians in a column of degrees
run 0 calibrate "$user/t_rad.csv" -o rad
said 'alpha_deg is 0.56 or less in every cut: these look like radians'
finish
