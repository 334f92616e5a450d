# FreeCAD (OpenCASCADE) reads STEP and IGES: the same poles, valid closed solids of the right volume; and we read its.
# labels: exchange slow
. "$SOURCE_DIR/tests/exchange/exchange.sh"
need_module 'import sys; sys.path += ["/usr/lib/freecad-python3/lib"]; import FreeCAD' freecad-python3
/usr/bin/python3 -B "$SOURCE_DIR/tests/exchange/check_freecad.py" "$PWD"
/usr/bin/python3 "$SOURCE_DIR/tests/exchange/write_freecad.py" "$PWD"
"$READ_CURVES" freecad.txt freecad.step freecad.igs
"$READ_CURVES" wire.txt wire.igs
for edges in edges.step edges.igs; do # two edges drawn there become a mould that is read there
    "$SAMPLE_MOULD" "$SOURCE_DIR/samples/jobs" "$edges-out" "$edges"
    PYTHONPATH=/usr/lib/freecad-python3/lib /usr/bin/python3 -c '
import sys, FreeCAD, Part
for solid in Part.read(sys.argv[1]).Solids:
    print(sys.argv[1], solid.isValid(), solid.isClosed(), len(solid.Faces), solid.Volume)
    assert solid.isValid() and solid.isClosed() and 40e6 < solid.Volume < 70e6
assert len(Part.read(sys.argv[1]).Solids) == 2' "$edges-out/mould.step"
done
