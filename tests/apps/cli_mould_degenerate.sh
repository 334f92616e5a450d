# Cuts that divide nothing, or only just, through the command: a status and a word each, never an invalid solid.
. "$SOURCE_DIR/tests/apps/common.sh"

python3 - "$jobs/steady-300-60.json" <<'EOF_PYTHON' || fail "the jobs"
import json
import sys

job = json.load(open(sys.argv[1]))
W, L, H = job["block"]["size_mm"]


def write(name, place, length=None):
    """every mount at place(its x, y, the share of the path that is behind it)"""
    made = json.loads(json.dumps(job))
    if length:
        made["wire"]["length_mm"] = length
    for mount in ("mount_a_mm", "mount_b_mm"):
        was = job["path"][mount]
        made["path"][mount] = [list(place(x, y, k / (len(was) - 1))) for k, (x, y, _) in enumerate(was)]
    json.dump(made, open(name + ".json", "w"))


def back(x, y, t):  # through the block at z = 150, and behind it back over it at z = 220
    if t < 0.475:
        return x, -6 + (L + 126) * t / 0.475, 150
    if t < 0.525:
        return x, L + 120, 150 + 70 * (t - 0.475) / 0.05
    return x, L + 120 - (L + 250) * (t - 0.525) / 0.475, 220


write("above", lambda x, y, t: (x, y, H + 10))
write("below", lambda x, y, t: (x, y, -10))
write("beside", lambda x, y, t: (x + 2 * W, y, H / 2))
write("top", lambda x, y, t: (x, y, H))
write("bottom", lambda x, y, t: (x, y, 0))
write("near", lambda x, y, t: (x, y, H - 0.05))
write("edge_x", lambda x, y, t: (x, y, H - 0.1 * x), 466)
write("edge_y", lambda x, y, t: (x, y, H - 0.1 * y))
write("edge_far", lambda x, y, t: (x, y, 0.1 * (L - y)))
write("corner", lambda x, y, t: (x, y, H - 0.1 * x - 0.05 * y), 466)
write("short", lambda x, y, t: (x, y / 2, H / 2))
write("back", back)
write("twisted", lambda x, y, t: (x, y, 20 + (H - 40) * (t if x < W / 2 else 1 - t)), 535)
write("leaving", lambda x, y, t: (x, y, H / 2 + 0.4 * (y - L / 2)))
EOF_PYTHON

# refused NAME WORDS: bad input in one line that holds the words, and no file
refused() {
    # shellcheck disable=SC2086
    run 3 mould "$1.json" -o none $coarse
    one_line "$2"
    untouched none
}
coarse="--stations 100 --nodes 41"
refused above "misses the block: it passes above it, from z = 310"
refused below "misses the block: it passes below it, from z = -10"
refused beside "no contact with the block"
refused top "grazes the block's face z = 300 mm: 0 mm from it"
refused bottom "grazes the block's face z = 0 mm"
refused near "grazes the block's face z = 300 mm: 0.05 mm from it"
refused edge_x "runs along the block's edge x = 0, z = 300 mm"
refused edge_y "runs along the block's edge y = 0, z = 300 mm"
refused edge_far "runs along the block's edge y = 1200, z = 0 mm"
refused corner "runs through the block's corner (0, 0, 300) mm"
refused short "ends inside the block"
refused back "folds over itself"

# twisted by 61 deg: still a cut; steep out of the top: triangles alone, and both say so
# shellcheck disable=SC2086
run 0 mould twisted.json -o twisted $coarse
# shellcheck disable=SC2086
run 0 mould leaving.json -o leaving $coarse
grep -q "no STEP files: the halves are triangle meshes, because the cut leaves through top or bottom" err || fail "$called: not said that there is no STEP"
[ -e leaving/lower.step ] && fail "$called: wrote a STEP file"
grep -q '"step": "not written: made by booleans' leaving/mould.json || fail "mould.json does not say so"
# shellcheck disable=SC2086
run 5 mould leaving.json -o leaving $coarse --minimum-wall 1
grep -q "wall is not known" err || fail "$called: $(cat err)"
python3 - twisted/mould.json leaving/mould.json <<'EOF_PYTHON' || fail "a solid that is none"
import json
import sys

for name in sys.argv[1:]:
    mould = json.load(open(name))
    for half in (mould["lower"], mould["upper"]):
        assert half["closed"] and half["oriented"] and half["self_intersections"] == 0, half
    assert mould["volume_error"] < 1e-6
EOF_PYTHON

# the pull: along z, along the cut's own lean, and what is none
# shellcheck disable=SC2086
run 0 mould twisted.json -o twisted $coarse --json --quiet --pull 0,0,1
cp out along_z
# shellcheck disable=SC2086
run 0 mould twisted.json -o twisted $coarse --json --quiet --pull 1,0,0
python3 -c '
import json
z, x = json.load(open("along_z")), json.load(open("out"))
assert z["asked"]["pull"] == [0, 0, 1] and x["asked"]["pull"] == [1, 0, 0]
assert z["lower"]["undercut_mm2"] == 0 < x["lower"]["undercut_mm2"]
assert abs(x["lower"]["undercut_mm2"] - x["upper"]["undercut_mm2"]) < 1e-6 * x["lower"]["cut_area_mm2"]
' || fail "the pull"
for pull in 0,0,0 1,2 1,2,3,4 a,b,c 0,0,nan 1e9,0,0 ""; do
    run 2 mould twisted.json -o none --pull "$pull"
    one_line "--pull"
done
untouched none
finish
