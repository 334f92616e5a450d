# Every example of kernel/FORMATS.md is what it says: inputs are read by their verbs, outputs have the keys that are written.
. "$SOURCE_DIR/tests/apps/common.sh"
document=$SOURCE_DIR/kernel/FORMATS.md
examples=$SOURCE_DIR/tests/apps/format_examples.py

mkdir given
count=$(python3 "$examples" write "$document" given) || fail "no examples"
[ "$count" -ge 20 ] || fail "$count examples, expected 20 or more"
tested=0

# same EXAMPLE RESULT: an output's example beside what the program wrote
same() {
    python3 "$examples" compare "$document" "given/$1" "$2" >found || fail "$(cat found)"
    tested=$((tested + 1))
}
# read NAME...: these inputs were read by the command that has just run
read_in() { tested=$((tested + $#)); }

cd given || exit 1
run 0 simulate job.json -o ../path --quiet
read_in job.json
run 0 simulate design.json -o ../design --quiet
read_in design.json
run 0 simulate bow.json -o ../bow --quiet
read_in bow.json
run 0 path design.json --edges curves.json --format csv -o ../curves --quiet
run 0 path design.json --edges curves.csv --format csv -o ../curves --quiet
read_in curves.json curves.csv
run 0 mould design.json -o ../mould --quiet
run 0 control job.json -o ../control --quiet
# a job with an excitation has no programs, nor has a path that ends in the foam: the design has
run 0 path design.json --format json -o ../robot --quiet
run 0 path design.json --format csv -o ../robot-csv --quiet --json
cp out ../path.json
run 0 identify job.json -o ../identify --quiet --json
cp out ../identification.json
run 0 simulate ../identify/identification-2.json -o ../again --quiet
run 0 calibrate table.csv -o ../calibrate --quiet
run 0 score case.json -o ../score --quiet
run 0 score job.json recording.csv -o ../score --quiet --settle 0 --leave 0
run 0 score case.json -o ../score --quiet --settle 0 --leave 0
read_in case.json recording.csv table.csv
run 0 compare job.json scan.xyz -o ../compare --register datum --datum datums.csv --reconstruct field --tolerance 5 --quiet
read_in scan.xyz datums.csv
run 0 compare job.json scan.xyz -o ../zoned --zones zones.json --quiet
read_in zones.json
python3 "$SOURCE_DIR/tests/photo/plain_png.py" photo.png 640 480
run 0 overlay job.json photo.png --points points.csv -o ../overlay --patch 50 --curves 2 --resolution 1 --quiet
read_in points.csv
run 0 verify ../identify --quiet --json
cp out ../verification.json
run 0 sweep study.json -o ../sweep --quiet
read_in study.json
# the wire of the example is too thin for its tension: the elements are cut, and said to be infeasible
run 6 facade wave.json -o ../facade --thickness 12 --formats csv -j 2 --quiet
read_in wave.json
# the one that takes a diagnosis: test_rig_prior reads the sample, which it is
cmp -s rig.json "$SOURCE_DIR/samples/rig.json" || fail "rig.json of the document is not samples/rig.json"
read_in rig.json
# from a target to a cut, and a machine that does what the job says
run 0 design "$SOURCE_DIR/samples/targets/saddle.ply" --block 400,600,300 --process job.json --stations 61 --nodes 31 --feed +y --tolerance 1 \
    --chord-tolerance 2 -o ../nearest --quiet
run 0 compensate job.json --with job.json --chord-tolerance 2 -o ../compensate --quiet
run 0 --json-usage
cp out ../usage.json
cd ..

same summary.json design/summary.json
same path.csv design/path.csv
same mould.json mould/mould.json
same control.json control/control.json
same robot.json robot/robot.json
same robot.csv robot-csv/robot.csv
same path.json path.json
same identification.json identification.json
same voucher.json identification.json
same verification.json verification.json
same force_law.json calibrate/force_law.json
same score.json score/score.json
same residuals.csv score/residuals.csv
same deviation.json compare/deviation.json
same zones.csv compare/zones.csv
same sections.csv zoned/sections.csv
same facade-result.json facade/facade.json
same element-result.json "$(ls facade/cases/*/*/element.json | head -n 1)"
same sweep.json sweep/sweep.json
same sweep-case.json "$(ls sweep/cases/*/*/case.json | head -n 1)"
same overlay.json overlay/overlay.json
same rills.csv overlay/rills.csv
same feasibility.json nearest/feasibility.json
same compensation.json compensate/compensation.json
same usage.json usage.json

# an input that has a key too many, or lacks one, is noticed: the examples are read, not passed over
for key in nodes tension_N mount_b_mm; do
    sed "s/\"$key\"/\"${key}s\"/" given/job.json >bad.json
    run 3 simulate bad.json -o bad --quiet
done
# so is an example of an output that has another key
sed 's/"duration_s"/"duration"/' given/summary.json >given/bad.json
python3 "$examples" compare "$document" given/bad.json design/summary.json >found && fail "not noticed: another key"
grep -q 'duration: in the example, but the program does not write it' found || fail "not named: $(cat found)"
printf '{"unknown_key": 1}' >unknown.json
python3 "$examples" compare "$document" unknown.json unknown.json >found && fail "not noticed: a key without a row"

# diagnosis.json is the one that takes minutes: test_diagnosis_write compares it
[ "$tested" -eq $((count - 1)) ] || fail "$tested examples tested of $count, expected all but diagnosis.json"
finish
