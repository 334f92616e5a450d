#!/bin/sh
# Every test, on a bare Debian 12 as root or with sudo:  sh tests/run.sh [--quick | --nightly]
#
# Installs the missing packages; then the dev build with its tests, format, static analysis of what changed, the tests
# once more under the address and undefined sanitizers, and short fuzzing. A table says what each step cost; the last line
# how many passed, failed and were skipped. The exit code is 0 only where nothing failed.
#   --quick    dev build and its tests alone
#   --nightly  clang-tidy of every source; the slow tests, too; the tests labelled `plain` under sanitizers, too. Where
#              clang-tidy finds nothing in a clean checkout, tests/analysed.txt then names this commit: commit it.
# A test is `plain` where it is long and only its numbers are new: under sanitizers shorter ones run the same code, and
# tests/hostile every public function.
# WCUT_FUZZ_SECONDS (5): time for each fuzzer. WCUT_BASE: clang-tidy looks at what changed since this commit (else the one
# that tests/analysed.txt names, else the last tag; where the checkout has none of these, at everything).
set -u
cd "$(dirname "$0")/.." || exit 1
. tests/packages.sh

LC_ALL=C.UTF-8
TZ=UTC
export LC_ALL TZ
unset CDPATH CFLAGS CXXFLAGS CPPFLAGS LDFLAGS MAKEFLAGS
jobs=$(nproc)
fuzz_seconds=${WCUT_FUZZ_SECONDS:-5}
passed=0
failed=0
skipped=0
causes=
costs=

quick=false
nightly=false
case "${1-}" in
    "") ;;
    --quick) quick=true ;;
    --nightly) nightly=true ;;
    *) echo "usage: sh tests/run.sh [--quick | --nightly]" >&2; exit 2 ;;
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

# the adapters have the same command line in every preset: a compiler cache compiles them once
use_cache() {
    command -v ccache >/dev/null || return 0
    CMAKE_C_COMPILER_LAUNCHER=ccache
    CMAKE_CXX_COMPILER_LAUNCHER=ccache
    CCACHE_BASEDIR=$PWD
    CCACHE_NOHASHDIR=1
    export CMAKE_C_COMPILER_LAUNCHER CMAKE_CXX_COMPILER_LAUNCHER CCACHE_BASEDIR CCACHE_NOHASHDIR
}

# cost NAME BEGIN: what a step took, for the table at the end
cost() {
    costs="$costs$(printf '%6d s  %s' "$(($(date +%s) - $2))" "$1")
"
}

# step NAME COMMAND...: one check; a step that fails does not hide those after it
step() {
    name=$1
    begun=$(date +%s)
    shift
    heading "$name"
    if "$@"; then
        passed=$((passed + 1))
        cost "$name" "$begun"
    else
        cost "$name (failed)" "$begun"
        fail 1 "$name"
        return 1
    fi
}

configure_and_build() {
    cmake --preset "$1" >"build/$1.log" 2>&1 || { cat "build/$1.log"; return 1; }
    shift
    cmake --build "$@"
}

# run_tests PRESET WITHOUT: every test but those with such a label; ctest's own count is added, and its exit code has the
# last word. A test that found nothing to test is no test that passed.
run_tests() {
    heading "tests, $1"
    begun=$(date +%s)
    log=build/ctest-$1.log
    { ctest --preset "$1" -LE "$2" -j "$jobs" --no-tests=error; echo $? >"$log.status"; } 2>&1 | tee "$log"
    total=$(sed -n 's/^[0-9]*% tests passed, [0-9]* tests failed out of \([0-9]*\)$/\1/p' "$log")
    broken=$(sed -n 's/^[0-9]*% tests passed, \([0-9]*\) tests failed out of [0-9]*$/\1/p' "$log")
    if [ -z "$total" ] || [ -z "$broken" ]; then
        fail 1 "tests, $1: ctest gave no count"
        return
    fi
    empty=$(grep -c '\*\*\*Skipped' "$log")
    cost "tests, $1" "$begun"
    passed=$((passed + total - broken - empty))
    skipped=$((skipped + empty))
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

# the commit since which clang-tidy looks; nothing: at everything
tidy_base() {
    $nightly && return 0
    head=$(git rev-parse -q --verify HEAD 2>/dev/null) || return 0
    for base in "${WCUT_BASE-}" "$(cat tests/analysed.txt 2>/dev/null)" "$(git describe --tags --abbrev=0 2>/dev/null)"; do
        base=$(git rev-parse -q --verify "$base^{commit}" 2>/dev/null) || continue
        # only a commit of this history says what changed since
        git merge-base --is-ancestor "$base" "$head" 2>/dev/null || continue
        echo "$base"
        return 0
    done
}

# C sources to look at: those that changed, and one that includes each header that changed
tidy_sources() {
    base=$(tidy_base)
    if [ -z "$base" ] || ! git diff --quiet "$base" -- .clang-tidy; then
        sources -name '*.c'
    else
        git diff --name-only --diff-filter=d "$base" -- '*.c' '*.h' | while read -r file; do
            case "$file" in
                *.c) echo "$file" ;;
                *) grep -rlE --include='*.c' "^#include [<\"](.*/)?$(basename "$file")[>\"]" kernel io apps | LC_ALL=C sort | head -n 1 ;;
            esac
        done
    fi | grep -v -e '^tests/fuzz/' -e '^tests/install/' -e '^tests/bench/peers/' -e '^tests/fault/shim' | LC_ALL=C sort -u
}

# one source a call, as many at a time as there are cores; xargs ends with 123 where any call failed
check_tidy() {
    tidy_sources >build/tidy.list
    echo "$(wc -l <build/tidy.list) sources"
    # shellcheck disable=SC2016 # for the inner shell
    <build/tidy.list xargs -r -P "$jobs" -n 1 sh -c 'clang-tidy-14 -p build/dev --quiet "$0" 2>"build/tidy.$$" ||
            { cat "build/tidy.$$" >&2; exit 1; }; rm -f "build/tidy.$$"' || return 1

    # every source of a clean checkout was looked at: what changes from here on is enough next time
    if $nightly && [ -z "$(git status --porcelain)" ]; then git rev-parse HEAD >tests/analysed.txt; fi
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

# fuzz_result NAME: a check like a step, without a cost of its own
fuzz_result() {
    if fuzz_said "$1"; then passed=$((passed + 1)); else fail 1 "fuzz $1"; fi
}

started=$(date +%s)
mkdir -p build
begun=$started
install_packages tests/packages.txt build test || exit 1
cost "packages" "$begun"
use_cache

if step "build, dev" configure_and_build dev --preset dev --target all bench; then
    if $nightly; then run_tests dev none; else run_tests dev slow; fi
fi
if ! $quick; then
    step "format" check_format
    step "static analysis, clang-tidy" check_tidy
    step "static analysis, cppcheck" check_cppcheck
    if step "build, asan" configure_and_build asan --preset asan; then
        if $nightly; then run_tests asan slow; else run_tests asan 'slow|plain'; fi
    fi
    if step "build, fuzz" configure_and_build fuzz --preset fuzz; then
        heading "fuzzing, $fuzz_seconds s each"
        begun=$(date +%s)
        fuzz_all
        cost "fuzzing, $fuzz_seconds s each" "$begun"
        for source in tests/fuzz/fuzz_*.c; do
            name=$(basename "$source" .c | sed 's/^fuzz_//')
            fuzz_result "$name"
        done
    fi
fi

heading "end"
printf '%s' "$costs"
[ -z "$causes" ] || echo "failed:$causes"
echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ]
