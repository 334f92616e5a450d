# wirecut compare and mould on scans, meshes and CAD files of other programs, each with the right answer. They lie beside
# the repository, in ../shared/found; where that is absent the test is skipped.
. "$SOURCE_DIR/tests/apps/common.sh"
found=$SOURCE_DIR/../shared/found
if [ ! -d "$found/geo" ]; then
    echo "skipped: no $found/geo"
    exit 77
fi

# every folder has a test, here, in cli_mould (words) or in test_found_curves (curves of IGES and STEP): a new one fails
# here until it has
known="bytes-behind-the-last-element coff-as-scan csv-header-with-blanks csv-takes-nominal-for-measured gltf-with-bin-beside
    iges-spline-range-ignored iges-unit-by-name iges-utf8-name mesh-reference-has-no-unit mould-words pcd-compressed
    ply-header-with-cr poisson-off-by-millimetres ptx-and-pts-blocks reference-of-unread-format
    registration-gives-up-on-noise report-refuses-two-sided-mesh step-assembly-that-moves-nothing step-edges-in-pieces
    stl-ascii-taken-for-binary stl-ply-nan-of-microsoft __pycache__"
for path in "$found"/geo/*/; do
    case " $(echo $known) " in *" $(basename "$path") "*) ;; *) fail "no test of $path" ;; esac
done

# above FOLDER REFERENCE SCAN POINTS [OPTION...]: the points lie 0.25 mm above the plane, outside a tolerance of 0.1 mm
above() {
    folder=$found/geo/$1 reference=$2 scan=$3 points=$4
    shift 4
    run 5 compare "$folder/$reference" "$folder/$scan" -o above --tolerance 0.1 "$@"
    grep -q ": $points points compared, 0 outside" err || fail "$called: expected $points points: $(cat err)"
    grep -q 'as scanned  *mean +0.250, rms 0.250' err || fail "$called: expected a mean of 0.25: $(cat err)"
}

# asked FOLDER REFERENCE SCAN TEXT [OPTION...]: refused, one line that holds the text
asked() {
    folder=$found/geo/$1 reference=$2 scan=$3 text=$4
    shift 4
    run 3 compare "$folder/$reference" "$folder/$scan" -o asked "$@"
    one_line "$text"
    no_leavings asked
}

for scan in scan-0 scan-1 scan-2 scan-3 scan-4 feet; do
    above csv-takes-nominal-for-measured plane.stl $scan.csv 70
done
for scan in unit comma id name quotes; do above csv-header-with-blanks plane.stl $scan.csv 70; done
for unit in m inch cm; do
    above mesh-reference-has-no-unit plane-$unit.stl scan-$unit.xyz 70 --unit $unit
done
for name in blank feed tab upper capital mark comment; do
    above stl-ascii-taken-for-binary $name.stl scan.xyz 70
    run 0 compare "$found/geo/stl-ascii-taken-for-binary/$name.stl" "$found/geo/stl-ascii-taken-for-binary/$name.stl" -o same
    grep -q ': 6 points compared' err || fail "$called: expected 6 corners: $(cat err)"
done
for name in normal-f normal-e; do above stl-ply-nan-of-microsoft $name.stl scan.xyz 70; done
above stl-ply-nan-of-microsoft plane.stl normal.ply 70
for name in cr cr-ascii feed; do above ply-header-with-cr plane.stl $name.ply 70; done
for name in compressed columns; do above pcd-compressed plane.stl $name.pcd 70; done
for name in feed.ply page.pcd; do above bytes-behind-the-last-element plane.stl $name 70; done
for name in feed none-stated; do above bytes-behind-the-last-element $name.stl scan.xyz 70; done
for name in COFF NOFF none; do above coff-as-scan plane.stl $name.off 70; done
for name in unmoved.ptx moved.ptx blocks.pts; do above ptx-and-pts-blocks plane.stl $name 70; done
above report-refuses-two-sided-mesh twice.stl scan.xyz 70
run 5 compare "$found/geo/report-refuses-two-sided-mesh/two-sided.stl" \
    "$found/geo/report-refuses-two-sided-mesh/scan.xyz" -o sides --tolerance 0.1
grep -q 'the sign of deviations is unreliable' err || fail "$called: expected a warning of the sign: $(cat err)"
[ -s sides/report.html ] || fail "$called: expected a report"
above reference-of-unread-format plane scan.xyz 70
for name in plane.dxf plane.3mf; do
    asked reference-of-unread-format $name scan.xyz "expected a mesh: STL, PLY, OBJ, OFF or glTF"
done
asked gltf-with-bin-beside plane.gltf scan.xyz plane.bin

# a fit that ordinary noise does not stop
for seed in 0 1 2 3 4 5; do
    [ -e "$found/geo/registration-gives-up-on-noise/scan-$seed.xyz" ] || break
    run 0 compare "$found/geo/registration-gives-up-on-noise/box.obj" \
        "$found/geo/registration-gives-up-on-noise/scan-$seed.xyz" --register fit -o fit
done
if [ "$seed" = 0 ]; then
    mkdir noise
    (cd noise && python3 "$found/geo/registration-gives-up-on-noise/make.py") || fail "no noisy scans"
    for seed in 0 1 2; do run 0 compare noise/box.obj noise/scan-$seed.xyz --register fit -o fit; done
fi

# Poisson is not offered; the field is right
run 2 compare "$found/geo/poisson-off-by-millimetres/plane.stl" "$found/geo/coff-as-scan/COFF.off" -o none --reconstruct poisson
(cd . && python3 -c "
for i in range(196):
    for j in range(146): print(5 + 2 * i, 5 + 2 * j, 50.25)" >flat.xyz)
run 0 compare "$found/geo/poisson-off-by-millimetres/plane.stl" flat.xyz -o flat --reconstruct field --distance reconstruction
grep -q 'as scanned  *mean +0.250, rms 0.250' err || fail "$called: expected a mean of 0.25: $(cat err)"

# where nothing was compared: dashes and null, and a refusal where nothing is over the face at all
python3 - "$found/user/datum_far.csv" >far.xyz <<'EOF'
import sys
rows = [[float(c) for c in line.split(",")] for line in open(sys.argv[1]).read().split()[1:]]
o = rows[0][:3]
axis = lambda row, size: [(a - b) / size for a, b in zip(rows[row][:3], o)]
ex, ey, ez = axis(1, 400), axis(2, 900), axis(4, 80)
for i in range(60):
    for j in range(60):
        b = 5 + 6.6 * i, 5 + 15 * j, 150.3
        print("%.4f %.4f %.4f" % tuple(o[k] + b[0] * ex[k] + b[1] * ey[k] + b[2] * ez[k] for k in range(3)))
EOF
run 0 compare "$jobs/steady-400-60.json" far.xyz -o far --register datum --datum "$found/user/datum_far.csv"
grep -q 'as scanned  *mean –, rms –, max –' err || fail "$called: expected dashes: $(cat err)"
grep -q '"as_scanned": {"distance_mm": {"mean": null' far/deviation.json || fail "$called: expected null in deviation.json"
run 3 compare "$jobs/steady-400-60.json" far.xyz -o nowhere
one_line "none of them over the face"

finish
