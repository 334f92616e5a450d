# Bad input: exit code 3, one clear line with place and expectation, nothing on standard output, no folder made.
. "$SOURCE_DIR/tests/apps/common.sh"
mkdir bad
python3 "$SOURCE_DIR/tests/apps/bad_jobs.py" bad >table || fail "bad_jobs.py"
[ "$(wc -l <table)" -ge 79 ] || fail "the table of bad jobs has $(wc -l <table) lines"

while IFS='|' read -r name place expectation; do
    run 3 simulate "bad/$name.json" -o dir --json
    one_line "bad/$name.json" "$place" "$expectation"
    no_result
    untouched dir
done <table

# the job that they were made from is good: it is the one thing changed that is refused
for good in good good-design; do
    run 0 simulate $good.json -o "out-$good" --quiet --chord-tolerance 5
    [ -s err ] && fail "$called: expected no words, found: $(cat err)"
done

# a job may come through a pipe
cat good.json | "$WIRECUT" simulate /dev/stdin -o piped --quiet --chord-tolerance 5 || fail "a job through a pipe"
cmp -s out-good/history.vtp piped/history.vtp || fail "a piped job is cut otherwise"

# a folder that held results before keeps them when the input is bad
cp -r out-good before
run 3 simulate bad/short-wire.json -o out-good
diff -r before out-good >/dev/null || fail "bad input changed the results of an earlier run"

# files that cannot be read
run 3 simulate missing.json -o dir; one_line "missing.json"; no_result
run 3 simulate bad -o dir; one_line "bad"; no_result
run 3 simulate missing/job.json -o dir; one_line "missing/job.json"; no_result
run 3 simulate good.json/job.json -o dir; one_line "good.json/job.json"; no_result
run 3 simulate /dev/null -o dir; one_line "/dev/null"; no_result
ln -s loop loop
run 3 simulate loop -o dir; one_line "loop"; no_result
if [ "$(id -u)" -ne 0 ]; then
    cp good.json closed.json
    chmod 000 closed.json
    run 3 simulate closed.json -o dir; one_line "closed.json"; no_result
fi
untouched dir
finish
