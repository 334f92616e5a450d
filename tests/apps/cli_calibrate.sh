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

# the page: whole, the same again, with the table's hash, both laws and every cut, and no place outside
cmp -s made/report.html again/report.html || fail "two runs, two pages"
[ "$(head -c 15 made/report.html)" = '<!doctype html>' ] || fail "report.html has no head"
[ "$(tail -n 1 made/report.html)" = '</html>' ] || fail "report.html has no end"
if grep -oE '(src|href)="?(https?:)?//[^"]*' made/report.html; then fail "report.html names a place outside"; fi
python3 - made table.csv <<'EOF' || fail "report.html does not say what force_law.json says"
import hashlib, json, re, sys
text = open(sys.argv[1] + "/report.html", encoding="utf-8").read()
page = json.loads(re.search(r'id="report">(.*?)</script>', text, re.S).group(1))
law = json.load(open(sys.argv[1] + "/force_law.json"))
assert page["sources"][0]["sha256"] == hashlib.sha256(open(sys.argv[2], "rb").read()).hexdigest()
titles = [section["title"] for section in page["sections"]]
assert [t for t in titles if t.endswith("law")] == ["Force law", "Tension law"], titles
for name, title in (("force_law", "Force law"), ("tension_law", "Tension law")):
    section = page["sections"][titles.index(title)]
    assert len(section["charts"]) == 5 and all(c["axes"][0]["label"] and c["label"] for c in section["charts"])
    band = section["charts"][0]["series"][0]
    assert "low" in band and "high" in band
    assert [t["title"] for t in section["tables"]] == ["Parameters", "Correlation", "Every cut"]
    assert section["tables"][2]["rows"] == len(law["residuals"]) == 8
    assert "p = %.2g" % law[name]["lack_of_fit"]["p"] in section["note"], section["note"]
verdict = re.search(r'class="verdict">(.*?)</p>', text).group(1)
low, high = law["force_law"]["interval"]["a_N_per_mm"]
assert "a = %.4g N/mm" % law["force_law"]["a_N_per_mm"] in verdict, verdict
assert "%.4g to %.4g" % (low, high) in verdict and verdict.endswith("."), verdict
labels = [fact["label"] for fact in page["facts"]]
assert any(label.startswith("force law, b (95 %") for label in labels) and "validated Q_eff" in labels, labels
EOF
if command -v node >/dev/null 2>&1; then
    status=0
    node "$SOURCE_DIR/tests/report/browser.mjs" made/report.html || status=$?
    [ "$status" -eq 0 ] || [ "$status" -eq 77 ] || fail "the page is wrong in a browser"
else
    echo "skipped: the page was not opened, for want of node"
fi

# the sample: as its script makes it, and the law it was made from is within the intervals
python3 "$SOURCE_DIR/samples/calibration/make_table.py" | cmp -s - "$SOURCE_DIR/samples/calibration/table.csv" ||
    fail "samples/calibration/table.csv is not what make_table.py makes"
run 0 calibrate "$SOURCE_DIR/samples/calibration/table.csv" -o sample
grep -q warning err && fail "the sample has a warning: $(cat err)"
[ -s sample/report.html ] || fail "no report.html of the sample"
python3 - sample/force_law.json <<'EOF' || fail "the sample's law is not found again"
import json, sys
law = json.load(open(sys.argv[1]))
truth = {"force_law": {"a_N_per_mm": 0.1, "b_m2_per_J": 8.6e-4},
         "tension_law": {"a_N_per_mm": 0.35, "b_m2_per_J": 8.6e-4, "c_N_per_mm": 0.002}}
for name, values in truth.items():
    for key, value in values.items():
        low, high = law[name]["interval"][key]
        assert low <= value <= high, (name, key, low, high)
    assert law[name]["lack_of_fit"]["against"] == "replicates" and law[name]["lack_of_fit"]["p"] > 0.05
EOF

# an outlier hardly counts, and is named
sed '$s/125.914/300/' table.csv >outlier.csv
run 0 calibrate outlier.csv -o robust --robust
grep -q 'line 9 is an outlier' err || fail "the outlier is not named: $(cat err)"
for words in 'line 9 is an outlier' 'has almost no weight"' '"Warnings"'; do
    grep -q "$words" robust/report.html || fail "the page does not say: $words"
done

# too little is said
printf '%s\n60,30,400,20,5\n60,30.3,400,20.4,5\n60,30.6,400,20.9,12\n60,30.9,400,21.2,5\n' $header >narrow.csv
run 0 calibrate narrow.csv -o narrow
for words in 'do not separate a from b' 'one heat' 'more than 10 deg'; do
    grep -q "$words" err || fail "not said: $words: $(cat err)"
    grep -q "$words" narrow/report.html || fail "the page does not say: $words"
done
grep -q 'Residuals over the speed' narrow/report.html || fail "no chart over the speed"
grep -q 'Residuals over the heat' narrow/report.html && fail "a chart over one heat"

refused() {
    run 3 calibrate broken.csv -o broken
    one_line "$@"
    no_result
    [ -e broken/force_law.json ] || [ -e broken/report.html ] && fail "a result of a refused table"
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

# a page that cannot be written is said, and the earlier law stays
mkdir -p taken/report.html
cp made/force_law.json taken
run 4 calibrate table.csv -o taken
cmp -s taken/force_law.json made/force_law.json || fail "$called: the law of an earlier run is lost"
no_leavings taken
finish
