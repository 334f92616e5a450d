# A table of test cuts to force_law.json: what is written, what is said, and what is refused.
. "$SOURCE_DIR/tests/apps/common.sh"

header=heat_W_per_m,speed_mm_s,engaged_mm,tension_N,alpha_deg
cat >table.csv <<EOF
$header
71,38.2,500,32.937,9.35
85,81.8,300,55.211,6.37
66,29.4,400,35.904,5.04
77,46.1,500,71.546,5.29
66,30.6,400,31.430,6.32
66,38.6,400,44.028,6.24
51,27.6,500,48.738,6.43
86,104.8,500,125.914,5.33
EOF

run 0 calibrate table.csv -o made
no_result
grep -q 'force law: a = ' err || fail "no summary: $(cat err)"
grep -q 'V0 = ' err || fail "no reference speed"
python3 - made/force_law.json <<'EOF' || fail "force_law.json"
import json, sys
d = json.load(open(sys.argv[1]))
law = d["force_law"]
assert d["process"]["force_law"] == {k: law[k] for k in ("a_N_per_mm", "b_m2_per_J")}
assert law["a_N_per_mm"] > 0 and law["standard_error"]["a_N_per_mm"] > 0 and len(law["covariance"]) == 2
assert len(d["residuals"]) == 8 and law["range_J_per_m2"][0] < law["range_J_per_m2"][1]
EOF

run 0 calibrate table.csv -o again --json --quiet
cmp -s out made/force_law.json || fail "--json is not the file"
[ -s err ] && fail "--quiet spoke: $(cat err)"
cmp -s made/force_law.json again/force_law.json || fail "two runs, two results"

# an outlier hardly counts, and is named
sed '$s/125.914/300/' table.csv >outlier.csv
run 0 calibrate outlier.csv -o robust --robust
grep -q 'line 9 is an outlier' err || fail "the outlier is not named: $(cat err)"

# too little is said
printf '%s\n60,30,400,20,5\n60,30.3,400,20.4,5\n60,30.6,400,20.9,12\n60,30.9,400,21.2,5\n' $header >narrow.csv
run 0 calibrate narrow.csv -o narrow
for words in 'do not tell a from b' 'one heat' 'more than 10 deg'; do
    grep -q "$words" err || fail "not said: $words: $(cat err)"
done

refused() {
    run 3 calibrate broken.csv -o broken
    one_line "$@"
    no_result
    [ -e broken/force_law.json ] && fail "a result of a refused table"
}
printf '%s\n60,30,400,20,5\n60,30,400,21,5\n30,15,400,20,5\n' $header >broken.csv
refused 'broken.csv' 'one level of Q_eff (2000 J/m^2)'
printf 'heat_W_per_m,speed_m_s,engaged_mm,tension_N,alpha_deg\n60,30,400,20,5\n' >broken.csv
refused 'missing speed_mm_s (found speed_m_s'
printf '%s\n60,30,400,20,"5,5"\n' $header >broken.csv
refused 'line 2, column 14 (alpha_deg): found 5,5, expected a decimal point'
printf '%s\n' $header >broken.csv
refused 'found 0 test cuts'
run 3 calibrate table.csv -o broken --weights mass
one_line 'mass: found no such column'
run 3 calibrate table.csv -o broken --reference-force 5
one_line 'reference force: found 5'
run 3 calibrate nowhere.csv -o broken
run 2 calibrate table.csv
run 4 calibrate table.csv -o table.csv/in
finish
