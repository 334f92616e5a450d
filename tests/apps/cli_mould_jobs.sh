# Every job of the samples is divided into two valid solids, as it is and with kerf, keys and shrinkage.
# labels: cli slow
. "$SOURCE_DIR/tests/apps/common.sh"
for job in "$jobs"/*.json; do
    name=$(basename "$job" .json)
    sed 's/"process":/"kerf": {"width_mm": 0.8, "per_J_m2_mm": 1.6e-4}, "process":/' "$job" >kerf.json
    run 0 mould "$job" -o "$name" --quiet
    run 0 mould kerf.json -o "$name-kerf" --quiet --keys cones --scale 1.02 --label panel
    python3 - "$name" "$name-kerf" <<'EOF_PYTHON' || fail "$name: a half that is no solid"
import json
import os
import sys

for folder in sys.argv[1:]:
    mould = json.load(open(folder + "/mould.json"))
    for half in (mould["lower"], mould["upper"]):
        assert half["closed"] and half["oriented"] and half["self_intersections"] == 0 and half["pieces"] == 1, half
        assert half["exact_faces"] >= 6 and half["wall_mm"]["min"] > 0 and half["edge_deg"]["min"] > 45, half
    assert mould["volume_error"] < 1e-12 and mould["fit_error_mm"] <= 0.005 and mould["chord_error_mm"] <= 0.1, mould
    for file in mould["files"]:
        assert os.path.getsize(folder + "/" + file) > 0, file
    print(folder, "walls %.5g %.5g mm, edges %.4g deg, prolonged %s" % (
        mould["lower"]["wall_mm"]["min"], mould["upper"]["wall_mm"]["min"],
        min(mould["lower"]["edge_deg"]["min"], mould["upper"]["edge_deg"]["min"]), mould["prolonged_mm"]))
EOF_PYTHON
    rm -rf "$name" "$name-kerf"
done
finish
