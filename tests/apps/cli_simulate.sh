# wirecut simulate: every file whole, the result alone on standard output, progress for terminals only, equal bytes.
. "$SOURCE_DIR/tests/apps/common.sh"
job=$jobs/steady-300-60.json

whole() { python3 "$SOURCE_DIR/tests/apps/whole.py" "$@" || fail "$called: results are not whole"; }

# shellcheck disable=SC2086 # $small is words
run 0 simulate "$job" -o a/b/c $small
no_result
whole a/b/c
no_leavings a
# no progress into a pipe or a file: no carriage return, no escape
LC_ALL=C grep -q "$(printf '[\r\033]')" err && fail "$called: progress was written to a file"
for word in 40 summary.json a/b/c; do grep -q "$word" err || fail "$called: the summary does not mention $word: $(cat err)"; done

# the same bytes again, whatever the threads, the locale, the folder or what was in it
mkdir -p again
echo old >again/path.csv
echo old >again/summary.json
(
    export OMP_NUM_THREADS=3 LC_ALL=de_DE.UTF-8
    # shellcheck disable=SC2086
    "$WIRECUT" simulate "$job" -o again $small --quiet --json >json 2>err
) || fail "a second run: $(cat err)"
[ -s err ] && fail "--quiet is not quiet: $(cat err)"
diff -r a/b/c again >/dev/null || fail "two runs of one job differ: $(diff -rq a/b/c again)"

# --json: the summary, and nothing else
cmp -s json again/summary.json || fail "--json is not summary.json: $(cat json)"
python3 -c 'import json; s = json.load(open("json")); assert s["stations"] == 40 and s["nodes"] == 31, s' || fail "--json"
[ "$(LC_ALL=de_DE.UTF-8 locale decimal_point 2>/dev/null)" = , ] ||
    echo "note: no locale de_DE here, decimal commas not tried"

# options reach the run
# shellcheck disable=SC2086
run 0 simulate "$job" -o heun $small --integrator heun --stations 12 --json
python3 -c 'import json; s = json.load(open("out")); assert s["integrator"] == "heun" and s["stations"] == 12, s' ||
    fail "--integrator heun --stations 12"
# shellcheck disable=SC2086
run 0 simulate "$job" -o fine $small --chord-tolerance 0.05
[ "$(wc -c <fine/surface.stl)" -gt "$(wc -c <a/b/c/surface.stl)" ] || fail "--chord-tolerance does not refine"
run 0 simulate "$jobs/freeform-3.json" -o design --stations 41 --nodes 31 --chord-tolerance 1 --quiet
whole design

# a name that could speak to the terminal, in the job and in the folder
odd=$(printf 'odd \033[31m \303\266')
sed 's/"name": "[^"]*"/"name": "a\\u001b[31m\\n\\"<b>"/' "$job" >"$odd.json"
# shellcheck disable=SC2086
run 0 simulate "$odd.json" -o "$odd" $small
LC_ALL=C grep -q "$(printf '\033')" err && fail "$called: a control character reached standard error"
whole "$odd"

# a cut that cannot be solved to its end: station and cause, and everything up to there; heun is unstable where stations
# lie close, at some counts so much that no shape is left
ended=0
for stations in 500 600 700 800; do
    code=0
    "$WIRECUT" simulate "$jobs/steady-400-60.json" -o stopped --stations $stations --integrator heun --json --quiet \
        --chord-tolerance 5 >out 2>err || code=$?
    called="heun at $stations stations"
    case $code in
        0) ;;
        6)
            ended=1
            one_line "steady-400-60.json: station" "heun"
            whole stopped --partial
            cmp -s out stopped/summary.json || fail "$called: --json is not summary.json"
            python3 -c 'import json; s = json.load(open("out")); assert s["stations"] < int("'$stations'")' || fail "$called"
            ;;
        *) fail "$called: exit code $code" ;;
    esac
done
[ "$ended" -eq 1 ] || fail "no run of heun ended early: exit code 6 was not tried"

# on a terminal: a bar, taken away at the end; none where the user or the terminal does not want it
on_terminal() {
    code=0
    # shellcheck disable=SC2086
    python3 "$SOURCE_DIR/tests/apps/terminal.py" "$@" simulate "$job" -o seen --stations 500 --chord-tolerance 5 $more || code=$?
    called="$* on a terminal"
    [ "$code" -eq 0 ] || fail "$called: exit code $code"
}
has_bar() { LC_ALL=C grep -q "$(printf '\r')\[[#.]*\] [0-9]*/500 stations" terminal; }
more=
on_terminal "$WIRECUT"
has_bar || fail "$called: no progress: $(cat -v terminal)"
tail -n 1 terminal | LC_ALL=C grep -q '\[#' && fail "$called: the bar is left on the screen"
on_terminal --environment TERM=dumb "$WIRECUT"
has_bar && fail "$called: progress where TERM=dumb"
on_terminal --environment NO_COLOR=1 "$WIRECUT"
has_bar && fail "$called: progress in spite of NO_COLOR"
more=--quiet
on_terminal "$WIRECUT"
[ -s terminal ] && fail "$called: --quiet says $(cat -v terminal)"
finish
