#!/bin/sh
# Coverage by room:  sh tests/coverage.sh [CTEST ARGUMENT...]  (without arguments every test but the slow ones)
#
# Builds the preset `coverage`, runs the tests, and prints for every room of kernel, io and apps the lines and branches and
# how many of them ran; build/coverage/files.csv has the figures of each file. C alone: the C++ adapters are compiled as in
# the other presets.
set -eu
cd "$(dirname "$0")/.."
. tests/packages.sh
install_packages tests/packages.txt build test coverage
mkdir -p build
cmake --preset coverage >build/coverage.log
cmake --build --preset coverage
find build/coverage -name '*.gcda' -exec rm -f {} +
[ $# -gt 0 ] || set -- -LE slow
ctest --test-dir build/coverage -j "$(nproc)" "$@" || echo "some tests failed: the figures are of what ran"

gcovr --root . --object-directory build/coverage --filter 'kernel/' --filter 'io/' --filter 'apps/' --exclude-throw-branches \
    --gcov-ignore-parse-errors --csv build/coverage/files.csv
awk -F, '
NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next }
{
    count = split($at["filename"], part, "/")
    room = count > 2 ? part[1] "/" part[2] : part[1]
    lines[room] += $at["line_total"]
    ran[room] += $at["line_covered"]
    branches[room] += $at["branch_total"]
    taken[room] += $at["branch_covered"]
    lines["all"] += $at["line_total"]
    ran["all"] += $at["line_covered"]
    branches["all"] += $at["branch_total"]
    taken["all"] += $at["branch_covered"]
}
END {
    printf "%-16s %7s %7s %9s %7s\n", "room", "lines", "ran", "branches", "taken"
    for (room in lines)
        printf "%-16s %7d %6.1f%% %9d %6.1f%%\n", room, lines[room], 100 * ran[room] / lines[room], branches[room],
            branches[room] ? 100 * taken[room] / branches[room] : 100 | "LC_ALL=C sort"
}' build/coverage/files.csv
