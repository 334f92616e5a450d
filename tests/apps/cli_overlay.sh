# A photograph beside the simulation: pictures rendered by another program, read with their sign and size; what is refused.
# labels: cli plain
. "$SOURCE_DIR/tests/apps/common.sh"
photo=$SOURCE_DIR/tests/photo
job=$jobs/freeform-1.json
python=
for candidate in python3 /usr/bin/python3; do
    [ -n "$python" ] || { $candidate -c 'import numpy' 2>/dev/null && python=$candidate; }
done

# ---- what needs no rendered picture ----

python3 "$photo/plain_png.py" plain.png 640 480
printf 'u_px,v_px,x_mm,y_mm,z_mm\n100,400,0,0,300\n500,410,400,0,300\n480,60,400,900,300\n140,50,0,900,300\n' >four.csv
run 0 overlay "$job" plain.png --points four.csv -o plain --resolution 2 --curves 3
grep -q 'nothing readable' err || fail "a picture without rills: $(cat err)"
for name in rectified.png rectified.pgw overlay.png overlay.svg overlay-photo.png details.png rills.csv report.html overlay.json; do
    [ -s "plain/$name" ] || fail "no $name"
done
run 0 verify plain --quiet
run 0 overlay "$job" plain.png --corners 100,400,500,410,480,60,140,50 -o corners --resolution 2 --curves 3 --json --quiet
cmp -s out corners/overlay.json || fail "--json is not the file"
cmp -s plain/rills.csv corners/rills.csv || fail "four corners are not those four points"

# refused: nothing, both, a list of seven, points outside, interchanged, mirrored, no picture, half a picture
run 2 overlay "$job" plain.png -o bad
one_line "--points" "--corners"
run 2 overlay "$job" plain.png --corners 1,2,3,4,5,6,7 -o bad
one_line "eight numbers"
sed 's/500,410/5000,410/' four.csv >outside.csv
run 3 overlay "$job" plain.png --points outside.csv -o bad
one_line "outside.csv" "point 2" "640 x 480"
printf 'u_px,v_px,x_mm,y_mm,z_mm\n100,400,0,900,300\n500,410,400,900,300\n480,60,400,0,300\n140,50,0,0,300\n' >mirrored.csv
run 3 overlay "$job" plain.png --points mirrored.csv -o bad
one_line "mirrored"
run 3 overlay "$job" four.csv --points four.csv -o bad
one_line "four.csv" "PNG or JPEG"
head -c 300 plain.png >half.png
run 3 overlay "$job" half.png --points four.csv -o bad
one_line "half.png" "PNG"
untouched bad

# ---- rendered pictures ----

if [ -z "$python" ]; then
    echo "skipped: rendered pictures need python3-numpy"
    [ "$failed" -eq 0 ] && exit 77
    finish
fi
small_picture="--width 1600 --height 1200 --rills 2.5,8"

# a cut as simulated, one with a wire that is 6 mm longer, a face without rills
run 0 simulate "$job" -o as --quiet --formats vtp
cp as/job-path.json as.json
python3 - as.json longer.json <<'EOF'
import json, sys
job = json.load(open(sys.argv[1]))
job["wire"]["length_mm"] += 6
json.dump(job, open(sys.argv[2], "w"))
EOF
run 0 simulate longer.json -o longer --quiet --formats vtp
# shellcheck disable=SC2086 # several words
{
    "$python" "$photo/render.py" as/history.vtp null --seed 3 $small_picture || fail "no picture"
    "$python" "$photo/render.py" longer/history.vtp long --seed 4 $small_picture || fail "no picture"
    "$python" "$photo/render.py" as/history.vtp light --seed 5 --plain $small_picture || fail "no picture"
}
for name in null long light; do
    run 0 overlay as.json $name/photo.png --points $name/points.csv -o "of-$name" --quiet
done
"$python" - <<'EOF' || fail "camera, null or light"
import json
null, light = json.load(open("of-null/overlay.json")), json.load(open("of-light/overlay.json"))
truth = json.load(open("null/truth.json"))
camera = null["camera"]
assert abs(camera["focal_px"] / truth["focal_px"] - 1) < 0.005, camera["focal_px"]
assert camera["rms_px"] < 0.3
away = sum((a - b) ** 2 for a, b in zip(camera["centre_mm"], truth["centre_mm"])) ** 0.5
assert away < 8, away
assert null["rills"]["readable_share"] > 0.5 and null["curves_that_differ"] == 0, null["rills"]
assert abs(null["rills"]["phases"]["steady"]["median_deg"]) < 0.5
assert light["rills"]["readable"] == 0, light["rills"]
EOF
"$python" "$photo/check_shape.py" of-long/overlay.json as/history.vtp longer/history.vtp >shape || fail "another shape: $(cat shape)"
finish
