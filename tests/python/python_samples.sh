# The scripts of samples/python run, and leave the files that they name.
set -eu
export PYTHONPATH="$SOURCE_DIR/apps/python" LD_LIBRARY_PATH="$BUILD_DIR" PYTHONDONTWRITEBYTECODE=1
python=/usr/bin/python3
if ! "$python" -c 'import numpy, cffi'; then
    echo "skipped: $python has no numpy or no cffi (python3-numpy, python3-cffi)"
    exit 77
fi
samples=$SOURCE_DIR/samples
"$python" "$samples/python/cut.py" "$samples/jobs/freeform-4.json" cut
"$python" "$samples/python/study.py" "$samples/jobs/steady-400-60.json" study
"$python" "$samples/python/scan.py" "$samples/jobs/freeform-4.json" "$samples/scans/freeform-4.ply" scan
"$python" "$samples/python/panels.py" panels | tee said
for file in cut/surface.step cut/surface.stl cut/path.csv study/study.csv scan/deviation.csv panels/panel-4.step; do
    [ -s "$file" ] || { echo "$file is missing or empty"; exit 1; }
done
awk '$1 == "joint:" { joints++; if ($6 > 1) far = 1 } END { exit joints != 3 || far }' said
