# The Python package: its declarations are those of the headers, its tests, its types where mypy is there.
set -eu
export PYTHONPATH="$SOURCE_DIR/apps/python" LD_LIBRARY_PATH="$BUILD_DIR" PYTHONDONTWRITEBYTECODE=1
python=/usr/bin/python3
if ! "$python" -c 'import numpy, cffi'; then
    echo "skipped: $python has no numpy or no cffi (python3-numpy, python3-cffi)"
    exit 77
fi
"$python" "$SOURCE_DIR/apps/python/generate.py" --check --cc "$CC" >generated || { cat generated; exit 1; }
"$python" "$SOURCE_DIR/tests/python/test_package.py"
if command -v mypy >/dev/null; then
    mypy --python-executable "$python" --ignore-missing-imports --cache-dir=mypy-cache "$SOURCE_DIR/apps/python/wirecut" |
        cut -c1-300
else
    echo "types not checked: mypy is not installed"
fi
