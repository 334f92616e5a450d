# What the tests of the command share: run it, look at its exit code and its words, note what failed.
#
#   WIRECUT      the command          SOURCE_DIR   the repository
#
# A test sources this file in an empty folder of its own and ends with `finish`.
set -u
failed=0
jobs=$SOURCE_DIR/samples/jobs
small="--stations 40 --nodes 31 --chord-tolerance 1" # enough for every file, quick under sanitizers

fail() {
    echo "FAIL: $*"
    failed=1
}

# run CODE ARGUMENT...: the command with its words in `err` and its result in `out`; CODE is what it must end with
run() {
    wanted=$1
    shift
    called="wirecut $*"
    code=0
    "$WIRECUT" "$@" >out 2>err || code=$?
    [ "$code" -eq "$wanted" ] && return
    fail "$called: exit code $code, expected $wanted"
    sed 's/^/    /' err
}

# one_line TEXT...: `err` is a single line from wirecut that holds every TEXT
one_line() {
    [ "$(wc -l <err)" -eq 1 ] || fail "$called: $(wc -l <err) lines of error, expected 1: $(cat err)"
    grep -q '^wirecut: ' err || fail "$called: expected an error that begins with \"wirecut: \": $(cat err)"
    for text in "$@"; do
        grep -qF -- "$text" err || fail "$called: expected \"$text\" in: $(cat err)"
    done
}

no_result() {
    [ -s out ] && fail "$called: expected nothing on standard output, found: $(head -c 200 out)"
}

# no_leavings FOLDER: no temporary file is left in it
no_leavings() {
    left=$(find "$1" -name '*.part' -o -name '.*wirecut*' 2>/dev/null)
    [ -z "$left" ] || fail "$called: left behind: $left"
}

# untouched FOLDER: it is not there, or nothing is in it
untouched() {
    [ -e "$1" ] || return 0
    [ -z "$(ls -A "$1")" ] || fail "$called: expected nothing in $1, found: $(ls -A "$1")"
    rm -rf "$1" # so that one failure is not every later one's
}

finish() {
    [ "$failed" -eq 0 ] || exit 1
    exit 0
}
