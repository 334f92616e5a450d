# labels: cli oracle
# samples/jobs are what samples/make_jobs.py makes, all of them are cut to the end, and the steady ones as the parabola.
. "$SOURCE_DIR/tests/apps/common.sh"

python3 "$SOURCE_DIR/samples/make_jobs.py" made || fail "make_jobs.py"
diff -r made "$jobs" || fail "samples/jobs are not what samples/make_jobs.py makes"
[ "$(find "$jobs" -name '*.json' | wc -l)" -eq 17 ] || fail "17 sample jobs expected"

for job in "$jobs"/*.json; do
    name=$(basename "$job" .json)
    run 0 simulate "$job" -o "$name" --stations 60 --chord-tolerance 2 --quiet
    python3 "$SOURCE_DIR/tests/apps/whole.py" "$name" || fail "$name"
    case $name in
        steady-*) python3 "$SOURCE_DIR/tests/apps/steady.py" "$job" "$name" || fail "$name" ;;
    esac
    rm -rf "$name"
done
finish
