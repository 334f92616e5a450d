# The neighbours of cli_found_diagnose: other cases, other columns, other signs, both kinds at once.
# labels: cli slow
. "$SOURCE_DIR/tests/apps/common.sh"
. "$SOURCE_DIR/tests/apps/found_diagnose.sh"

# with the set power recorded, and in another case with other identification cuts
make_case diagnose-excitation-that-was-not-cut c17 heat
diagnose_made heat <<'EOF'
assert v["kind"] == "none" and "do not follow the job's excitation" in v["sentence"], v
EOF
make_case diagnose-excitation-that-was-not-cut c34 other noheat
diagnose_made other <<'EOF'
assert v["kind"] == "none" and "follow the job's excitation" in v["sentence"], v
EOF

# zeros of either sensor, of both, of either sign
zero() {
    make_case diagnose-names-a-gain-for-an-offset "$1" "zero-$1-$2" "$2" "$3"
    diagnose_made "zero-$1-$2" <<EOF
assert v["kind"] == "instrument" and v["effects"] == ["tension_zero"], v
for e in d["effects"]:
    assert "tension_" + e["parameters"]["sensor"] + "_N" in "$2".split(","), e
    assert abs(e["parameters"]["offset_N"]["value"] - $3) < 0.025, e
assert len(d["effects"]) == len("$2".split(",")), d["effects"]
EOF
}
zero c34 tension_a_N 0.3
zero c21 tension_b_N -0.2
zero c26 tension_a_N 0.15
zero c17 tension_a_N,tension_b_N 0.4

# both kinds in one case
make_case diagnose-excitation-that-was-not-cut c17 both-1 noheat
python3 "$found/diagnose-names-a-gain-for-an-offset/make.py" both-1 both tension_b_N 0.25 || fail "both"
diagnose_made both <<'EOF'
assert v["kind"] == "instrument" and v["effects"] == ["tension_zero"], v
assert [c["name"] for c in d["contradictions"]] == ["excitation_not_followed", "tension_zero"], d["contradictions"]
EOF
finish
