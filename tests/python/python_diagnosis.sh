# labels: slow
# samples/python/diagnosis.py reads a diagnosis and writes a job with what it names.
set -eu
export PYTHONPATH="$SOURCE_DIR/apps/python" LD_LIBRARY_PATH="$BUILD_DIR" PYTHONDONTWRITEBYTECODE=1
if ! /usr/bin/python3 -c 'import numpy, cffi'; then
    echo "skipped: /usr/bin/python3 has no numpy or no cffi (python3-numpy, python3-cffi)"
    exit 77
fi
/usr/bin/python3 "$SOURCE_DIR/samples/python/diagnosis.py" "$SOURCE_DIR/samples/concealed/one/case.json" out | tee said
grep -q wire_thermal_lag out/improved.json || { echo "out/improved.json does not name the lag"; exit 1; }
