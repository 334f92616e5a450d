#!/bin/sh
# Every test, on a bare Debian 12 as root or with sudo:  sh tests/run.sh [--quick]
#
# Installs the missing packages; then the dev build with its tests, format, static analysis, the tests once more under
# the address and undefined sanitizers, and short fuzzing. The last line says how many passed and failed; the exit code
# is 0 only where nothing failed. --quick: dev build and its tests alone. WCUT_FUZZ_SECONDS (10): time for each fuzzer.
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/packages.sh

LC_ALL=C.UTF-8
TZ=UTC
export LC_ALL TZ
unset CDPATH CFLAGS CXXFLAGS CPPFLAGS LDFLAGS MAKEFLAGS
jobs=$(nproc)
fuzz_seconds=${WCUT_FUZZ_SECONDS:-10}
passed=0
failed=0
causes=

quick=false
case "${1-}" in
    "") ;;
    --quick) quick=true ;;
    *) echo "usage: sh tests/run.sh [--quick]" >&2; exit 2 ;;
esac
case "$fuzz_seconds" in
    '' | *[!0-9]*) echo "WCUT_FUZZ_SECONDS=$fuzz_seconds: expected a whole number of seconds" >&2; exit 2 ;;
esac

heading() { printf '\n==== %s (%s s)\n' "$1" "$(($(date +%s) - started))"; }

fail() {
    failed=$((failed + $1))
    causes="$causes
  $2"
}

# step NAME COMMAND...: one check; a step that fails does not hide those after it
step() {
    name=$1
    shift
    heading "$name"
    if "$@"; then
        passed=$((passed + 1))
    else
        fail 1 "$name"
        return 1
    fi
}

configure_and_build() {
    cmake --preset "$1" >"build/$1.log" 2>&1 || { cat "build/$1.log"; return 1; }
    shift
    cmake --build "$@"
}

# run_tests PRESET: every test but the slow ones; ctest's own count is added, and its exit code has the last word
run_tests() {
    heading "tests, $1"
    log=build/ctest-$1.log
    { ctest --preset "$1" -LE slow -j "$jobs" --no-tests=error; echo $? >"$log.status"; } 2>&1 | tee "$log"
    total=$(sed -n 's/^[0-9]*% tests passed, [0-9]* tests failed out of \([0-9]*\)$/\1/p' "$log")
    broken=$(sed -n 's/^[0-9]*% tests passed, \([0-9]*\) tests failed out of [0-9]*$/\1/p' "$log")
    if [ -z "$total" ] || [ -z "$broken" ]; then
        fail 1 "tests, $1: ctest gave no count"
        return
    fi
    passed=$((passed + total - broken))
    if [ "$broken" -gt 0 ]; then
        fail "$broken" "tests, $1: $(sed -n 's/^\t *[0-9]* - \([^ ]*\) (.*/\1/p' "$log" | tr '\n' ' ')"
    elif [ "$(cat "$log.status")" -ne 0 ]; then
        fail 1 "tests, $1: ctest ended with $(cat "$log.status")"
    fi
}

sources() { find kernel io apps samples tests -type f \( "$@" \) | LC_ALL=C sort; }

check_format() {
    sources -name '*.[ch]' -o -name '*.cpp' -o -name '*.hpp' | xargs clang-format-14 --dry-run -Werror
}

# one source a call, as many at a time as there are cores; xargs ends with 123 where any call failed
check_tidy() {
    # shellcheck disable=SC2016 # for the inner shell
    sources -name '*.c' ! -path 'tests/fuzz/*' ! -path 'tests/install/*' |
        xargs -P "$jobs" -n 1 sh -c 'clang-tidy-14 -p build/dev --quiet "$0" 2>"build/tidy.$$" ||
            { cat "build/tidy.$$" >&2; exit 1; }; rm -f "build/tidy.$$"'
}

# objectIndex: a wcut_vec3 is read as three doubles by design
check_cppcheck() {
    mkdir -p build/cppcheck
    cppcheck --quiet -j "$jobs" --std=c11 --language=c --file-filter='*.c' --enable=warning,portability --inline-suppr --error-exitcode=1 \
        --suppress=missingIncludeSystem --suppress=objectIndex --cppcheck-build-dir=build/cppcheck \
        -I kernel/include -I kernel kernel io apps
}

# fuzz_one TARGET: new inputs go to the build, the committed corpus is only read, a finding stays for a debugger. Leaves
# its exit code beside its log, since as many run at a time as there are cores.
fuzz_one() {
    name=$(basename "$1")
    name=${name#fuzz_}
    found=build/fuzz/found/$name
    mkdir -p "build/fuzz/corpus/$name" "$found"
    set -- "$1" "build/fuzz/corpus/$name"
    [ ! -d "tests/fuzz/corpus/$name" ] || set -- "$@" "tests/fuzz/corpus/$name"
    "$@" -max_total_time="$fuzz_seconds" -timeout=10 -rss_limit_mb=2048 -artifact_prefix="$found/" \
        -print_final_stats=1 >"build/fuzz/$name.log" 2>&1
    echo $? >"build/fuzz/$name.status"
}

fuzz_all() {
    running=0
    for source in tests/fuzz/fuzz_*.c; do
        rm -f "build/fuzz/$(basename "$source" .c | sed 's/^fuzz_//').status"
        fuzz_one "build/fuzz/fuzz/$(basename "$source" .c)" &
        running=$((running + 1))
        [ $((running % jobs)) -ne 0 ] || wait
    done
    wait
}

# fuzz_said NAME: what became of it
fuzz_said() {
    if [ "$(cat "build/fuzz/$1.status" 2>/dev/null)" = 0 ]; then
        sed -n "s/^stat::number_of_executed_units: */$1: executions /p" "build/fuzz/$1.log"
    else
        tail -n 60 "build/fuzz/$1.log"
        return 1
    fi
}

started=$(date +%s)
mkdir -p build
install_packages tests/packages.txt build test || exit 1

if step "build, dev" configure_and_build dev --preset dev --target all bench; then
    run_tests dev
fi
if ! $quick; then
    step "format" check_format
    step "static analysis, clang-tidy" check_tidy
    step "static analysis, cppcheck" check_cppcheck
    if step "build, asan" configure_and_build asan --preset asan; then
        run_tests asan
    fi
    if step "build, fuzz" configure_and_build fuzz --preset fuzz; then
        heading "fuzzing, $fuzz_seconds s each"
        fuzz_all
        for source in tests/fuzz/fuzz_*.c; do
            name=$(basename "$source" .c | sed 's/^fuzz_//')
            step "fuzz $name" fuzz_said "$name"
        done
    fi
fi

heading "end"
[ -z "$causes" ] || echo "failed:$causes"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
