# FreeCAD (OpenCASCADE) reads STEP and IGES: the same poles, valid closed solids of the right volume; and we read its.
# labels: exchange slow
. "$SOURCE_DIR/tests/exchange/exchange.sh"
need_module 'import sys; sys.path += ["/usr/lib/freecad-python3/lib"]; import FreeCAD' freecad-python3
/usr/bin/python3 "$SOURCE_DIR/tests/exchange/check_freecad.py" "$PWD"
/usr/bin/python3 "$SOURCE_DIR/tests/exchange/write_freecad.py" "$PWD"
"$READ_CURVES" freecad.txt freecad.step freecad.igs
"$READ_CURVES" wire.txt wire.igs
