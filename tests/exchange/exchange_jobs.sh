# Moulds of sample jobs as the command writes them, plain and with kerf, keys, shrinkage and a label, under a locale with
# decimal commas: FreeCAD, gmsh, admesh and PrusaSlicer find closed solids of our volume, with nothing to mend.
# labels: exchange slow
set -eu
have() {
    command -v "$1" >/dev/null && return 0
    echo "left out: no $1 here"
    return 1
}
PYTHONPATH=/usr/lib/freecad-python3/lib
export PYTHONPATH
if ! /usr/bin/python3 -c 'import FreeCAD' 2>/dev/null; then
    echo "skipped: python has no FreeCAD here (Debian package freecad-python3)"
    exit 77
fi

# check FOLDER LABEL: everything in it, against its mould.json
check() {
    /usr/bin/python3 -B "$SOURCE_DIR/tests/exchange/check_mould.py" "$1" "$2"
    for half in lower upper; do
        triangles=$(/usr/bin/python3 -c "import json; print(json.load(open('$1/mould.json'))['$half']['triangles'])")
        if have admesh; then
            LC_ALL=C admesh "$1/$2$half.stl" >log 2>&1 || { cat log; exit 1; }
            grep -q "^Number of facets  *: *$triangles " log || { cat log; exit 1; }
            for fault in 'Total disconnected facets' 'Degenerate facets' 'Edges fixed' 'Facets removed' 'Facets added' \
                'Facets reversed' 'Backwards edges' 'Normals fixed'; do
                grep -q "^$fault  *: *0" log || { echo "$1/$2$half.stl: $fault"; cat log; exit 1; }
            done
            echo "ok      $1/$2$half.stl: admesh mends nothing of $triangles triangles"
        fi
        if have gmsh; then
            gmsh -0 "$1/$2$half.step" -o half.msh >log 2>&1 || { cat log; exit 1; }
            ! grep -qi '^error\|cannot\|fail' log || { cat log; exit 1; }
            grep -q "(3D)" log || { cat log; exit 1; }
            echo "ok      $1/$2$half.step: gmsh opens a solid"
        fi
    done
    if have prusa-slicer; then
        for file in "$2lower.stl" "$2upper.stl" "$2mould.3mf"; do
            prusa-slicer --info "$1/$file" >log 2>&1 || { cat log; exit 1; }
            [ "$(grep -c '^manifold = yes' log)" -eq "$(grep -c '^manifold' log)" ] || { cat log; exit 1; }
            ! grep -qi 'repair\|fixed' log || { cat log; exit 1; }
            echo "ok      $1/$file: PrusaSlicer finds $(grep -c '^manifold = yes' log) manifold, no repair"
        done
    fi
}

for job in freeform-1 freeform-4 steady-400-60; do
    file=$SOURCE_DIR/samples/jobs/$job.json
    sed 's/"process":/"kerf": {"width_mm": 0.8, "per_J_m2_mm": 1.6e-4}, "process":/' "$file" >kerf.json
    LC_ALL=de_DE.UTF-8 "$WIRECUT" mould "$file" -o "$job" --quiet
    LC_ALL=de_DE.UTF-8 "$WIRECUT" mould kerf.json -o "$job-cast" --quiet --keys cones --scale 1.02 --label panel_7
    LC_ALL=de_DE.UTF-8 "$WIRECUT" mould kerf.json -o "$job-pockets" --quiet --keys pockets --chord-tolerance 0.02
    check "$job" ""
    check "$job-cast" panel_7-
    check "$job-pockets" ""
done
