# What the command says about itself: help, version, JSON, man page, completion; and about a call that is wrong.
. "$SOURCE_DIR/tests/apps/common.sh"

# silent: the words go to one stream and not to the other
silent() { [ -s err ] && fail "$called: expected nothing on standard error, found: $(cat err)"; }

run 0 --version
silent
version=$(sed -n 's/^#define WCUT_VERSION "\(.*\)"$/\1/p' "$SOURCE_DIR/kernel/include/wirecut/version.h")
[ "$(cat out)" = "wirecut $version" ] || fail "--version says \"$(cat out)\", expected \"wirecut $version\""
run 0 -V
[ "$(cat out)" = "wirecut $version" ] || fail "-V says \"$(cat out)\""

run 0 --json-usage
silent
cp out usage.json
python3 - >names <<'END' || fail "--json-usage does not parse"
import json
usage = json.load(open("usage.json"))
assert usage["format"] == "wirecut-usage/1"
assert [entry["code"] for entry in usage["exit_codes"]] == [0, 1, 2, 3, 4, 5, 6, 130]
for verb in [usage["command"]] + usage["verbs"]:
    options = [option["name"] for option in verb["options"]]
    letters = [option["letter"] for option in verb["options"] if option["letter"]]
    assert len(set(options)) == len(options) and len(set(letters)) == len(letters), verb["name"]
    assert "help" in options, verb["name"]
    assert verb["name"] == "" or {"json", "quiet"} <= set(options), verb["name"]
    for option in options:
        print(verb["name"] or "-", option)
# a long option means the same in every verb: the same kind of value, the same letter
for option in {option["name"] for verb in usage["verbs"] for option in verb["options"]}:
    found = {(o["kind"], o["letter"]) for verb in usage["verbs"] for o in verb["options"] if o["name"] == option}
    if option == "output":  # where results go: a folder, or the one file of apply
        found = {letter for kind, letter in found if kind in ("folder", "text")}
    assert len(found) == 1, (option, found)
END

# every verb and every option of the table stands in help, man page and completion
run 0 --man
silent
cp out wirecut.1
run 0 --completion
silent
cp out completion
while read -r verb option; do
    if [ "$verb" = - ]; then run 0 --help; else run 0 "$verb" --help; fi
    silent
    grep -q -- "--$option" out || fail "$called: --$option is missing"
    awk 'length > 100 { exit 1 }' out || fail "$called: a line is longer than 100 characters"
    grep -qF -- "--$option" completion || fail "completion: --$option is missing"
    sed 's/\\-/-/g' wirecut.1 | grep -qF -- "--$option" || fail "man page: --$option is missing"
done <names
if command -v groff >/dev/null; then
    groff -man -ww -Tutf8 wirecut.1 2>&1 >page.txt | grep . && fail "groff complains about the man page"
fi

if command -v bash >/dev/null; then
    # complete WORD...: what bash offers for the last word
    complete_words() {
        bash -c 'source ./completion; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _wirecut; echo "${COMPREPLY[*]}"' - "$@"
    }
    case $(complete_words wirecut sim) in simulate) ;; *) fail "completion of sim: $(complete_words wirecut sim)" ;; esac
    case $(complete_words wirecut simulate --integrator he) in heun) ;; *) fail "completion of --integrator he" ;; esac
    case $(complete_words wirecut simulate --chord) in --chord-tolerance) ;; *) fail "completion of --chord" ;; esac
    touch "a job.json"
    case $(complete_words wirecut simulate "a j") in "a job.json") ;; *) fail "completion of a file's name" ;; esac
fi

# wrong calls: CODE 2, one line, the near word
job=$jobs/steady-300-60.json
run 2; one_line "--help"; no_result
run 2 simulat "$job"; one_line '"simulat"' "did you mean simulate"
run 2 frobnicate; one_line '"frobnicate"'
grep -q "did you mean" err && fail "frobnicate is near to nothing"
run 2 --vesion; one_line '"--vesion"' "did you mean --version"
run 2 simulate; one_line "JOB" "job file"
run 2 simulate "$job"; one_line "--output" "DIR"
run 2 simulate "" -o dir; one_line "not empty"
run 2 simulate "$job" "$job" -o dir; one_line "no more than 1"
run 2 simulate "$job" -o; one_line "--output: found nothing"
run 2 simulate "$job" -o ""; one_line "--output" "not empty"
run 2 simulate "$job" -o dir --statoins 30; one_line "--statoins" "did you mean --stations"
run 2 simulate "$job" -o dir --statoins=30; one_line '"--statoins"' "did you mean --stations"
run 2 simulate "$job" -o dir -z; one_line '"-z"'
run 2 simulate "$job" -o dir --quiet=yes; one_line "--quiet" "no value"
run 2 simulate "$job" -o dir --integrator euler; one_line '"euler"' "implicit|heun"
for nodes in 2 0 -5 2.5 1e3 many "" nan 99999999999999999999 0x10 " 12" 12x; do
    run 2 simulate "$job" -o dir --nodes "$nodes"; one_line "--nodes" "\"$nodes\"" "whole number from 3 to"
done
for stations in 1 -1 two; do
    run 2 simulate "$job" -o dir --stations "$stations"; one_line "--stations" "\"$stations\"" "from 2 to"
done
for tolerance in 0 -1 nan inf 1e400 1,5 0,1 0x1p3; do
    run 2 simulate "$job" -o dir --chord-tolerance "$tolerance"; one_line "--chord-tolerance" "\"$tolerance\""
done
untouched dir

# names cannot speak to the terminal: control characters, broken UTF-8 and reversed text are escaped, letters stay
run 2 "$(printf 'sim\033[31m\nul\r\377\342\200\256\302\205')"
one_line 'sim\x1b[31m\x0aul\x0d\xff\u202e\u0085'
run 3 simulate "$(printf 'Bl\303\266cke \033]0;x\007.json')" -o dir
one_line "$(printf 'Bl\303\266cke')" '\x1b]0;x\x07.json'
untouched dir

# operands and options in any order, POSIXLY_CORRECT or not; after -- everything is an operand
export POSIXLY_CORRECT=1
run 3 simulate missing.json -o dir; one_line "missing.json"
unset POSIXLY_CORRECT
run 3 simulate -o dir -- -job.json; one_line "-job.json"

# a result that does not arrive is not a success
if [ -c /dev/full ]; then
    code=0; "$WIRECUT" --help >/dev/full 2>err || code=$?
    called="--help >/dev/full"; [ "$code" -eq 4 ] || fail "$called: exit code $code, expected 4"; one_line "standard output"
fi
code=0; "$WIRECUT" --version >&- 2>err || code=$?
called="--version >&-"; [ "$code" -eq 4 ] || fail "$called: exit code $code, expected 4"; one_line "standard output"

# a file in the place of another one is called what it is, with the verb that takes it, in every verb alike
printf 'solid x\nfacet normal 0 0 1\nendsolid x\n' >a.stl
printf 'curve,x_mm,y_mm,z_mm\n0,0,0,1\n' >points.csv
printf 'ISO-10303-21;\nHEADER;\n' >a.step
job=$jobs/freeform-1.json
for verb in simulate mould control diagnose score 'path --format csv' 'identify'; do
    for file in a.stl points.csv a.step; do
        # shellcheck disable=SC2086 # a verb and its option
        code=0; "$WIRECUT" $verb $file -o words -q >out 2>err || code=$?
        called="wirecut $verb $file"
        [ "$code" -eq 3 ] || fail "$called: exit code $code, expected 3"
        grep -q "$file: found a .*, expected .*; .*compare" err || fail "$called: expected the kind and its verb: $(cat err)"
    done
done
for file in a.stl a.step "$job"; do
    run 3 calibrate "$file" -o words; one_line "expected a table (CSV)"
    run 3 compare "$job" "$jobs/../scans/freeform-4.ply" -o words --register datum --datum "$file"; one_line "$file: found a"
done
run 3 mould "$job" -o words --stock points.csv; one_line "points.csv: found a table of points, expected a mesh"
run 3 mould "$job" -o words --edges a.stl; one_line "a.stl: found a mesh (STL), expected curves"
run 3 compare "$job" "$job" -o words; one_line "found a job (JSON), expected PLY"
run 3 diagnose "$job" -o words; one_line '"wirecut-job/1", expected "wirecut-case/1"; simulate'
run 3 simulate "$job" --force-law "$job" -o words; one_line 'expected "wirecut-force-law/1"; simulate'
untouched words
finish
