# wirecut diagnose on recordings on which it once named the wrong thing, in ../shared/found/rig: what is said of each
# there. Two of them here, their neighbours in cli_found_diagnose_more. Where they are absent the test is skipped.
# labels: cli plain
. "$SOURCE_DIR/tests/apps/common.sh"
. "$SOURCE_DIR/tests/apps/found_diagnose.sh"

# four of six jobs name an excitation that nobody cut, and the set power is not recorded
make_case diagnose-excitation-that-was-not-cut c17 case-1 noheat
diagnose_made case-1 <<'EOF'
assert v["kind"] == "none" and v["effects"] == [], v
assert "cuts 1, 2, 4 and 6 do not follow the job's excitation" in v["sentence"], v["sentence"]
assert [c["name"] for c in d["contradictions"]] == ["excitation_not_followed"], d["contradictions"]
EOF

# a tension sensor whose zero is off is no gain
make_case diagnose-names-a-gain-for-an-offset c17 case-2 tension_a_N 0.3
diagnose_made case-2 <<'EOF'
assert v["kind"] == "instrument" and v["effects"] == ["tension_zero"], v
p = d["effects"][0]["parameters"]
assert p["sensor"] == "a" and abs(p["offset_N"]["value"] - 0.3) < 0.02, p
assert p["offset_N"]["ci95"][0] < 0.3 < p["offset_N"]["ci95"][1], p
EOF
finish
