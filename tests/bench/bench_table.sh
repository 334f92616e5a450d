# What this library takes beside its peers, all in one run on this machine, as the table of kernel/MEASURED.md:
#
#   ninja bench_table            or  sh tests/bench/bench_table.sh BUILD/tests      after  ninja bench_table_programs
#
# The table goes to standard output, what each program reached to standard error. CPU time on one core, the least of
# several runs. SISL and Open CASCADE (packages of purpose `bench` in tests/packages.txt) take part where they were
# installed when the build was configured, manifold where npm can install it. It ends with 1 where two programs did not
# work on the same input.
set -eu
LC_ALL=C
export LC_ALL OMP_NUM_THREADS=1
here=$(cd "$(dirname "$0")" && pwd)
programs=$1
work=$(mktemp -d "$programs/bench_table.XXXXXX")
trap 'rm -rf "$work"' EXIT

# run PROGRAM ARGUMENT...: its lines of four columns; Open CASCADE prints words between them
run() {
    if [ ! -x "$1" ]; then
        echo "left out: $(basename "$1") was not built, its library is not installed" >&2
        return 0
    fi
    echo "running $(basename "$1")" >&2
    "$@" >"$work/out" || { cat "$work/out" >&2; exit 1; }
    awk -F '\t' 'NF == 4' "$work/out" >>"$work/results"
}
for peer in wirecut sisl occt; do run "$programs/peers/surface_$peer"; done
run "$programs/bench_exchange" "$work"
run "$programs/peers/exchange_occt" "$work"
run "$programs/bench_mould" "$work"
if (cd "$work" && npm install --silent --no-audit --no-fund manifold-3d@3.5.4) >"$work/npm" 2>&1; then
    (cd "$work" && node "$here/bench_mould.mjs" "$work") >>"$work/results"
else
    echo "left out: npm gives no manifold-3d here" >&2
fi
awk -F '\t' -f "$here/bench_table.awk" "$work/results"
