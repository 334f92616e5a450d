# effects in a job: physics changes the cut, instruments do not, what cannot be is refused by name.
. "$SOURCE_DIR/tests/apps/common.sh"

# with NAME EFFECTS [JOB]: a sample job with these effects
with() {
    python3 -c 'import json, sys
job = json.load(open(sys.argv[2]))
job["effects"] = json.loads(sys.argv[3])
json.dump(job, open(sys.argv[1], "w"))' "$1.json" "${3:-$jobs/steady-400-60.json}" "$2"
}
# shellcheck disable=SC2086 # $small is words
simulate() { run "$1" simulate "$2.json" -o "$2" $small --quiet ${3:-}; }

with plain '[]'
with neutral '[{"name": "wire_thermal_lag", "time_constant_s": 0}, {"name": "wire_elongation", "strain_at_60W_2N": 0}]'
with instrument '[{"name": "tension_gain", "sensor": "a", "gain_error": 0.1}, {"name": "scan_scale", "scale": 1.01}]'
with lag '[{"name": "wire_thermal_lag", "time_constant_s": 0.6}]'
with mounts '[{"name": "mount_compliance", "mount": "both", "stiffness_N_per_mm": 2}]'
with slice '[{"name": "slice_softening", "sliding_ratio": 0.5}]'
for name in plain neutral instrument lag mounts slice; do simulate 0 $name; done
cmp -s plain/path.csv neutral/path.csv || fail "neutral effects change path.csv"
cmp -s plain/path.csv instrument/path.csv || fail "instruments change path.csv"
cmp -s plain/path.csv slice/path.csv && fail "softening by sliding changes nothing"
cmp -s plain/path.csv lag/path.csv && fail "a thermal lag changes nothing"
# what acts behind the wire is said not to show, in the summary and to whoever reads
python3 - <<'EOF' || fail "summary.json does not tell which effects show"
import json
of = lambda name: json.load(open(name + "/summary.json"))
assert "effects" not in of("plain") and "effects_not_shown" not in of("plain")
assert of("instrument")["effects_not_shown"] == ["tension_gain", "scan_scale"] and "effects" not in of("instrument")
assert of("lag")["effects"] == ["wire_thermal_lag"] and "effects_not_shown" not in of("lag")
EOF
# shellcheck disable=SC2086
run 0 simulate instrument.json -o loud $small
grep -q 'note: tension_gain acts on recordings' err && grep -q 'note: scan_scale acts on the scanned face' err ||
    fail "$called: effects that do not show are not named: $(cat err)"
# shellcheck disable=SC2086
run 0 simulate lag.json -o loud $small
grep -q 'note:' err && fail "$called: a note about an effect that shows: $(cat err)"
cut -d, -f4-9 plain/path.csv >way
cut -d, -f4-9 mounts/path.csv >way_of_mounts
cmp -s way way_of_mounts || fail "mounts that give way are led elsewhere"

simulate 3 lag "--integrator heun"
one_line 'effects[0]' wire_thermal_lag heun
with misspelt '[{"name": "wire_themal_lag", "time_constant_s": 0.6}]'
simulate 3 misspelt
one_line '$.effects[0].name' '"wire_thermal_lag"'
with design '[{"name": "mount_compliance", "mount": "both", "stiffness_N_per_mm": 2}]' "$jobs/freeform-1.json"
simulate 0 design # along the path that it became, between mounts

finish
