# What the tests of ../shared/found/rig/diagnose-* share: a case made by one of them, and its diagnosis held against Python.
found=$SOURCE_DIR/../shared/found/rig cases=$SOURCE_DIR/../shared/cases/dev
if [ ! -d "$found/diagnose-excitation-that-was-not-cut" ] || [ ! -d "$cases/c17" ]; then
    echo "skipped: no ../shared/found/rig and ../shared/cases here"
    exit 77
fi

# make_case FOLDER CASE OUT ARGUMENT...
make_case() {
    maker=$found/$1/make.py source=$cases/$2
    shift 2
    python3 "$maker" "$source" "$@" || fail "$maker $*"
}

# diagnose_made CASE <<PYTHON: d is the diagnosis, v its verdict
diagnose_made() {
    run 0 diagnose "$1/case.json" -o "out-$1" --no-proof --threads 1 --quiet
    { echo 'import json, sys; d = json.load(open(sys.argv[1])); v = d["verdict"]'; cat; } >check.py
    python3 check.py "out-$1/diagnosis.json" || fail "$called: not what is expected"
}
