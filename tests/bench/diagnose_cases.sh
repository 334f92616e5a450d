#!/bin/sh
# Every case of a folder through `wirecut diagnose`, and their score:
#   sh tests/bench/diagnose_cases.sh WIRECUT CASES OUT [SCORER ANSWERS]
# CASES holds a folder a case, each with a case.json; OUT gets a folder a case. As many cases at a time as there are
# cores, one thread each; a line a case says its CPU seconds and its exit code. SCORER is a Python program called with
# OUT and ANSWERS (by $PYTHON, or python3). Further options of the verb, such as --naive, stand in WCUT_DIAGNOSE.
set -u
[ $# -eq 3 ] || [ $# -eq 5 ] || { echo "usage: sh $0 WIRECUT CASES OUT [SCORER ANSWERS]" >&2; exit 2; }
wirecut=$1
out=$3
mkdir -p "$out" || exit 1

# shellcheck disable=SC2016 # for the inner shell
find "$2" -mindepth 2 -maxdepth 2 -name case.json | LC_ALL=C sort |
    WIRECUT=$wirecut OUT=$out xargs -P "$(nproc)" -n 1 bash -c '
        name=$(basename "$(dirname "$0")")
        TIMEFORMAT="$name %U s"
        # the options of the caller are words of their own
        time "$WIRECUT" diagnose "$0" -o "$OUT/$name" --quiet --threads 1 ${WCUT_DIAGNOSE-} 2>"$OUT/$name.log"
        code=$?
        [ $code -eq 0 ] || { echo "$name ended with $code: $(head -n 1 "$OUT/$name.log")"; exit 1; }'
status=$?
[ $# -eq 3 ] || "${PYTHON:-python3}" "$4" "$out" "$5" || status=1
exit $status
