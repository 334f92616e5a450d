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

# a design is its own path job to the last byte: positions, times and speeds of every file
run 0 simulate design/job-path.json -o way --nodes 31 --chord-tolerance 1 --quiet
for name in path.csv surface.stl surface.ply; do
    cmp -s "design/$name" "way/$name" || fail "$name of a design and of its path job differ"
done
[ -e way/job-path.json ] && fail "a path job has written itself"
python3 - design/path.csv <<'EOF' || fail "speeds in path.csv are not way over time"
import csv, math, sys
rows = list(csv.DictReader(open(sys.argv[1])))
assert rows[0]["phase"] == "approach" and rows[-1]["phase"] == "left", (rows[0]["phase"], rows[-1]["phase"])
for a, b in zip(rows, rows[1:]):
    dt = float(b["time_s"]) - float(a["time_s"])
    for m in "ab":
        way = math.dist([float(a[m + k]) for k in ("_x_mm", "_y_mm", "_z_mm")], [float(b[m + k]) for k in ("_x_mm", "_y_mm", "_z_mm")])
        assert abs(way / dt - float(b[f"speed_{m}_mm_s"])) < 1e-6 * (1 + way / dt), (b["station"], m)
EOF
python3 -c '
import json, sys
d = json.load(open(sys.argv[1]))["design"]
print(json.dumps({"curves": [d["edge_a"], d["edge_b"]]}))' "$jobs/freeform-1.json" >edges.json
run 0 simulate "$jobs/freeform-3.json" --edges edges.json -o edges --stations 21 --nodes 31 --chord-tolerance 1 --quiet
cmp -s edges/path.csv design/path.csv && fail "--edges changed nothing"
run 3 simulate "$job" --edges edges.json -o edges2
one_line '--edges' 'expected a design'

# inputs of users: what does not fit the block is refused with place and unit
found=$SOURCE_DIR/../shared/found/user
if [ -d "$found" ]; then
    for name in design-in-metres-of-block design-longer-than-block design-thicker-than-block outofblock metres; do
        run 3 simulate "$found/$name.json" -o user --quiet
        one_line design
        case $name in *metres*) grep -q 'they differ by 1000' err || fail "$name: no hint: $(cat err)" ;; esac
    done
else
    echo "skipped: no ../shared/found/user here"
fi

# a name that could speak to the terminal, in the job and in the folder
odd=$(printf 'odd \033[31m \303\266')
sed 's/"name": "[^"]*"/"name": "a\\"<b>"/' "$job" >"$odd.json"
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
