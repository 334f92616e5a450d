#!/bin/sh
# The main job, on a bare Debian 12 as root or with sudo:  sh samples/demo.sh [JOB.json]
#
# Installs what the build needs, builds library and command, simulates one job and says which files it gave in out/demo.
set -eu
case "${1-}" in
    -*) echo "usage: sh samples/demo.sh [JOB.json]" >&2; exit 2 ;;
esac
unset CDPATH CFLAGS CXXFLAGS CPPFLAGS LDFLAGS
here=$(cd "$(dirname "$0")/.." && pwd)
job=${1:-"$here/samples/jobs/steady-400-60.json"}
[ -f "$job" ] || { echo "$job: no such job file" >&2; exit 3; }
job=$(cd "$(dirname "$job")" && pwd)/$(basename "$job")
cd "$here"
. tests/packages.sh

install_packages tests/packages.txt build
mkdir -p build
echo "Building the library and the command (build/release) ..."
{ cmake --preset release && cmake --build --preset release; } >build/release.log 2>&1 || {
    cat build/release.log >&2
    echo "The build failed; its words are above." >&2
    exit 1
}

echo "Simulating $job ..."
out=out/demo
rm -rf "$out"
mkdir -p "$out"
status=0
build/release/wirecut simulate "$job" -o "$out" || status=$?
if [ "$status" -ne 0 ]; then
    echo "wirecut simulate ended with exit code $status." >&2
    exit "$status"
fi

# what_is FILE: what a reader can do with it
what_is() {
    case "$1" in
        history.vtp) echo "every station of the wire, with forces, speeds and tension; opens in ParaView" ;;
        surface.stl) echo "the cut surface as triangles, binary STL" ;;
        surface.obj) echo "the cut surface as OBJ, with normals" ;;
        surface.ply) echo "the cut surface with the force magnitude as colour and as a number" ;;
        surface.glb) echo "the cut surface for a viewer in the browser" ;;
        surface.step) echo "the cut surface and the path curves, exactly, for CAD" ;;
        path.csv) echo "the robot path: both mounts' positions, speeds, angles and tensions, a row a station" ;;
        report.html) echo "everything on one page: open it in any browser" ;;
        summary.json) echo "how the run went: stations, iterations, residuals, files" ;;
        *) echo "also written" ;;
    esac
}
echo
echo "In $here/$out, lengths in millimetres:"
for file in "$out"/*; do
    [ -s "$file" ] || { echo "$file is empty or was not written" >&2; exit 1; }
    name=$(basename "$file")
    printf '  %-13s %9d bytes   %s\n' "$name" "$(wc -c <"$file")" "$(what_is "$name")"
done
echo "Built and simulated with one command; again: build/release/wirecut simulate $job -o DIR"
