# Rows of ../shared/found/fault/README.md, each as it stands there: an earlier result outlives what goes wrong after it. The
# same and more, counted, at every system call: tests/fault. Where the folder is absent the test is skipped.
# labels: cli plain
. "$SOURCE_DIR/tests/apps/common.sh"
fault=$SOURCE_DIR/../shared/found/fault
if [ ! -d "$fault/small" ]; then
    echo "skipped: no $fault"
    exit 77
fi
here=$PWD
cp -r "$fault/small" small && chmod -R u+w small && cd small || exit 1
whole() { "$WIRECUT" verify "$1" -q || fail "$called: $1 is not whole"; }

# kept FOLDER: the set that was copied to FOLDER.kept is still there
keep() { rm -rf "$1.kept" && cp -r "$1" "$1.kept"; }
kept() { diff -r "$1" "$1.kept" >/dev/null || fail "$called: the earlier result in $1 changed: $(diff -rq "$1" "$1.kept")"; }

# a mistyped input
run 0 score cA/case.json -o "$here/typed" -q
keep "$here/typed"
run 3 score cA/cut-1/job.json typo.csv -o "$here/typed"
kept "$here/typed"
[ "$(ls "$here/typed" | wc -l)" -eq 3 ] || fail "expected three files: $(ls "$here/typed")"

# a limit of file size in a second run
run 0 calibrate tA.csv -o "$here/again" -q
keep "$here/again"
code=0
(ulimit -f 10 && exec "$WIRECUT" calibrate tB.csv -o "$here/again" -q) 2>err || code=$?
called="calibrate with ulimit -f 10"
[ "$code" -eq 4 ] || fail "$called: exit code $code, expected 4"
one_line 'File too large'
kept "$here/again"
whole "$here/again"

# two runs into one folder
both() {
    verb=$1 a=$2 b=$3
    shift 3
    # shellcheck disable=SC2086 # words
    { "$WIRECUT" $verb $a -o "$here/both-$verb" -q "$@" 2>"$here/1" & "$WIRECUT" $verb $b -o "$here/both-$verb" -q "$@" 2>"$here/2"; wait; }
    called="two runs of $verb"
    whole "$here/both-$verb"
    no_leavings "$here/both-$verb"
    cat "$here/1" "$here/2" >err
    [ ! -s err ] || one_line 'process'
}
both simulate A.json B.json --formats csv
both mould A.json B.json --formats stl
both score cA/case.json "cA/case.json --settle 1"
both compare "A.json A.xyz" "B.json A.xyz"
both calibrate tA.csv tB.csv
both path A.json B.json --format urscript

# endless tables: a device as such, as datums, as a link and as a pipe inside a case
endless() { (ulimit -v 4000000 && exec "$WIRECUT" "$@" -o "$here/endless") >out 2>err || code=$?; called="wirecut $*"; [ "$code" -eq 3 ] || fail "$called: exit code $code, expected 3: $(cat err)"; }
case $(nm -D "$WIRECUT" 2>/dev/null) in
    *__asan_init*) echo "note: a sanitizer needs more room than the limit: endless tables are tried without it" ;;
    *)
        for words in "calibrate /dev/zero" "score cA/cut-1/job.json /dev/zero" "compare A.json A.xyz --register datum --datum /dev/zero"; do
            # shellcheck disable=SC2086 # words
            code=0 && endless $words
            grep -q '/dev/zero: found a device' err || fail "$called: $(cat err)"
        done
        rm cA/cut-1/recording.csv && ln -s /dev/zero cA/cut-1/recording.csv
        code=0 && endless score cA/case.json
        rm cA/cut-1/recording.csv && mkfifo cA/cut-1/recording.csv
        code=0 && endless score cA/case.json
        rm cA/cut-1/recording.csv && cp "$fault/small/cA/cut-1/recording.csv" cA/cut-1/recording.csv
        untouched "$here/endless"
        ;;
esac

# a name with a line feed: every verb that takes a job refuses it at the door
run 0 mould A.json -o "$here/named" -q --formats stl
keep "$here/named"
for verb in mould simulate control identify "path --format urscript"; do
    # shellcheck disable=SC2086 # words
    run 3 $verb name-with-line-feed.json -o "$here/named"
    one_line '$.name' 'without control characters'
    kept "$here/named"
done
run 3 compare name-with-line-feed.json A.xyz -o "$here/named"
one_line '$.name' 'without control characters'
run 3 score name-with-line-feed.json cA/cut-1/recording.csv -o "$here/named"
kept "$here/named"

# killed between the programs of two robots: tests/fault kills path at every call; an unequal pair does not start, since
# each program carries the number of its run
run 0 path A.json --format urscript -o "$here/pair-a" -q
run 0 path B.json --format urscript -o "$here/pair-b" -q
ids() { grep -ho 'Run id [0-9a-f]*' "$here/$1/"*.script | sort -u; }
[ "$(ids pair-a | wc -l)" -eq 1 ] && [ "$(ids pair-b | wc -l)" -eq 1 ] || fail "programs of one run carry other numbers"
[ "$(ids pair-a)" != "$(ids pair-b)" ] || fail "two runs carry one number: $(ids pair-a)"
[ "$(grep -c 'programs of different runs' "$here/pair-b/wirecut_b.script")" -gt 0 ] || fail "an unequal pair is not refused"
cd "$here" || exit 1
finish
