#!/bin/sh
# Three sealed cases: diagnose each, then open its answer.  sh samples/concealed/run.sh [DIR]
#
# Results go to DIR, out/concealed by default. The command is $WIRECUT, or wirecut on the path, or that of a build.
set -eu
unset CDPATH
here=$(cd "$(dirname "$0")" && pwd)
out=${1:-out/concealed}
if [ -z "${WIRECUT:-}" ]; then
    WIRECUT=$(command -v wirecut || true)
    for build in release dev; do
        [ -n "$WIRECUT" ] || [ ! -x "$here/../../build/$build/wirecut" ] || WIRECUT=$here/../../build/$build/wirecut
    done
fi
[ -n "$WIRECUT" ] || { echo "no wirecut: build it, sh samples/demo.sh does" >&2; exit 1; }
mkdir -p "$out"

for name in one two three; do
    echo "== case $name, sealed: what is measured is not what the job predicts. The diagnosis:"
    "$WIRECUT" diagnose "$here/$name/case.json" -o "$out/$name"
    answer=$out/$name/answer.json
    base64 -d "$here/answers/$name.sealed" >"$answer"
    hash=$(sha256sum "$answer" | cut -d ' ' -f 1)
    grep -q "$name.*$hash" "$here/README.md" || {
        echo "$name: the answer's hash is $hash, which is not the one in README.md" >&2
        exit 1
    }
    echo "-- the answer, opened, its hash that of README.md:"
    cat "$answer"
    echo
done
echo "Pages to look at: $out/one/report.html, $out/two/report.html, $out/three/report.html"
