# Recordings and tables in other units, with other separators, with a slipped decimal point: named with the likely cause.
. "$SOURCE_DIR/tests/apps/common.sh"
job=$jobs/steady-300-60.json
run 0 control "$job" -o made --quiet
recording=made/recording.csv

# changed COLUMN EXPRESSION: the recording with a column x replaced
changed() {
    awk -F, -v OFS=, -v name="$1" '/^#/ { print; next } !column { for (i = 1; i <= NF; i++) if ($i == name) column = i; print; next }
        { x = $column; $column = sprintf("%.9g", '"$2"'); print }' "$recording" >changed.csv
}
said() { grep -q -- "$1" err || fail "$called: expected \"$1\" in: $(cat err)"; }

# as it was recorded: not a word
run 0 score "$job" "$recording" -o scored
grep -q warning err && fail "$called: doubts a good recording: $(cat err)"
said 'RMSE/range'
said 'bias (mm/s, N, deg)'

# clocks
for row in "x*1000:milliseconds" "x*1e6:microseconds" "x*1e9:nanoseconds" "x/60:minutes"; do
    changed time_s "${row%:*}"
    run 3 score "$job" changed.csv -o clock
    said "contradict each other"
    said "${row#*:}"
    untouched clock
done
changed time_s 'x*2'
run 0 score "$job" changed.csv -o scored; said 'a factor of 2'
changed time_s 'x/2'
run 0 score "$job" changed.csv -o scored; said 'a factor of 2'

# other units, signs and frames
changed speed_a_mm_s 'x*60'
run 3 score "$job" changed.csv -o scored; said 'mm/min'
changed tension_a_N 'x*101.97'
run 0 score "$job" changed.csv -o scored; said 'tension_a_N is .* grams'
changed tension_b_N '-x'
run 0 score "$job" changed.csv -o scored; said 'the sign is turned'
changed heat_W_per_m 'x/100'
run 0 score "$job" changed.csv -o scored; said 'W/cm'
changed a_z_mm 'x+700'
run 0 score "$job" changed.csv -o scored; said 'off the job.s path'
awk -F, -v OFS=, '/^#/ { print; next } !n { n = 1; for (i = 1; i <= NF; i++) if ($i ~ /^(alpha|beta)/) angle[i] = 1; print; next }
    { for (i in angle) $i *= 3.14159265 / 180; print }' "$recording" >changed.csv
run 0 score "$job" changed.csv -o scored; said 'look like radians'

# separators and headers of other programs
grep -v '^#' "$recording" | tr , ';' >changed.csv
run 0 score "$job" changed.csv -o scored --quiet
grep -v '^#' "$recording" | tr ,. ';,' >changed.csv
run 0 score "$job" changed.csv -o scored --quiet
grep -v '^#' "$recording" | tr , ' ' >changed.csv
run 0 score "$job" changed.csv -o scored --quiet
grep -v '^#' "$recording" | tr , '\t' >changed.csv
run 0 score "$job" changed.csv -o scored --quiet

# a log of another program: other names and units, no clock, no stations but positions
sed '0,/time_s/s/time_s/stamp/' "$recording" >changed.csv
run 3 score "$job" changed.csv -o none; said 'missing time_s'
run 0 score "$job" changed.csv -o scored --quiet --columns 'time_s=stamp'
run 3 score "$job" changed.csv -o none --columns 'time_s=clock'; said 'no column clock'
run 2 score "$job" changed.csv -o none --columns 'time=stamp'; said 'the name of a channel'
run 3 score "$job" "$recording" -o none --period 0.05; said 'found time_s and a constant period'
run 0 score "$job" changed.csv -o scored --quiet --period 0.05
sed '0,/,station,/s/,station,/,progress,/' "$recording" >changed.csv
run 0 score "$job" changed.csv -o scored --quiet
tr '\n' '\r' <"$recording" >changed.csv
run 0 score "$job" changed.csv -o scored --quiet
awk '/^#/ { print; next } !n { n = 1; print "," $0; next } { print k++ "," $0 }' "$recording" >changed.csv
run 0 score "$job" changed.csv -o scored --quiet
awk '/^#/ { print; next } !n { n = 1; print $0 ",load,load"; next } { print $0 ",1,2" }' "$recording" >changed.csv
run 0 score "$job" changed.csv -o scored --quiet
awk '/^#/ { print; next } !n { n = 1; print $0 ",time_s"; next } { print $0 ",1" }' "$recording" >changed.csv
run 3 score "$job" changed.csv -o none; said 'every column that is used named once'

# devices, endless inputs, files of a case that are none
for input in /dev/zero /dev/null; do
    run 3 calibrate "$input" -o device; one_line "$input"
    run 3 score "$job" "$input" -o device
    untouched device
done
mkdir case
cp "$job" case/job.json
mkdir outside && cp "$recording" outside/r.csv
printf '{"format": "wirecut-case/1", "name": "c", "cuts": [{"job": "job.json", "recording": "r.csv", "scan": null}], "calibration": null}' >case/case.json
mkfifo case/r.csv
run 3 score case/case.json -o none; said 'an ordinary file, not a pipe or a device'
rm case/r.csv
for target in /dev/zero "$PWD/outside/r.csv" ../outside/r.csv; do
    ln -sf "$target" case/r.csv
    run 3 score case/case.json -o none; said 'inside the case'
done
cp "$recording" case/real.csv
ln -sf real.csv case/r.csv
run 0 score case/case.json -o scored --quiet

# names are checked at the door, and are texts in tables
for verb in simulate mould control identify "path --format csv"; do
    sed 's/"name": *"[^"]*"/"name": "a\\nb"/' "$job" >bad.json
    # shellcheck disable=SC2086
    run 3 $verb bad.json -o none; one_line '$.name' 'without control characters'
    untouched none
done
cp "$recording" '=cmd|x.csv'
run 0 score "$job" '=cmd|x.csv' -o scored --quiet
sed -n 2p scored/residuals.csv | grep -q ",'=cmd|x.csv," || fail "a formula in residuals.csv: $(sed -n 2p scored/residuals.csv | head -c 60)"

# tables of test cuts: t_rad is of a user who had radians
printf 'heat_W_per_m,speed_mm_s,engaged_mm,tension_N,alpha_deg\n50,14.6,400,2.0,0.56\n60,17.6,400,2.0,0.56\n70,20.5,400,2.0,0.56\n85,24.9,400,2.0,0.56\n' >rad.csv
run 0 calibrate rad.csv -o rad; said 'these look like radians'
found=$SOURCE_DIR/../shared/found/rig
if [ -d "$found" ]; then
    run 0 calibrate "$found/calibration-slip-of-a-decimal/table.csv" -o slip
    said 'line 6 is an outlier: .* alpha_deg 5.42 instead of 54.2 would fit'
    grep -q -- '--noise' err && fail "$called: its advice leads away: $(cat err)"
    run 0 calibrate "$found/calibration-slip-of-a-decimal/tension.csv" -o slip; said 'line 6 is an outlier: .* tension_N 2.402 instead of 24.02 would fit'
    run 3 score "$found/time-in-milliseconds-is-scored/job.json" "$found/time-in-milliseconds-is-scored/recording.csv" -o ms
    said 'milliseconds'
else
    echo "note: ../shared/found is not there: its tables are not tried"
fi
finish
