# The C# sample: its declarations are those of the headers; built with mono, it simulates and writes a surface.
set -eu
python=/usr/bin/python3
if ! "$python" -c 'import cffi'; then
    echo "skipped: $python has no cffi (python3-cffi)"
    exit 77
fi
PYTHONDONTWRITEBYTECODE=1 "$python" "$SOURCE_DIR/samples/csharp/generate.py" --check --cc "$CC"
if ! command -v mcs >/dev/null || ! command -v mono >/dev/null; then
    echo "skipped: mono is not installed (mono-mcs, mono-runtime)"
    exit 77
fi
mcs -unsafe -nowarn:0649 "$SOURCE_DIR/samples/csharp/Cut.cs" "$SOURCE_DIR/samples/csharp/Native.cs" -out:cut.exe
export LD_LIBRARY_PATH="$BUILD_DIR"
mono cut.exe "$SOURCE_DIR/samples/jobs/freeform-4.json" out
[ -s out/surface.step ] || { echo "out/surface.step is missing or empty"; exit 1; }
if mono cut.exe nothing.json out 2>said; then
    echo "a job that is not there was cut"
    exit 1
fi
grep -q '^nothing.json: ' said
