# The report of a simulated cut: one whole file, the same bytes again, and in a browser without a word on its console.
. "$SOURCE_DIR/tests/apps/common.sh"
job=$jobs/steady-300-60.json

run 0 simulate "$job" -o first --stations 40 --nodes 41
run 0 simulate "$job" -o second --stations 40 --nodes 41
cmp first/report.html second/report.html || fail "$called: the same cut gave another page"
[ "$(head -c 15 first/report.html)" = '<!doctype html>' ] || fail "$called: report.html has no head"
[ "$(tail -n 1 first/report.html)" = '</html>' ] || fail "$called: report.html has no end"
sha256sum "$job" | cut -d' ' -f1 | grep -qFf - first/report.html || fail "$called: report.html does not hold the job's hash"
if grep -oE '(src|href)="?(https?:)?//[^"]*' first/report.html; then fail "$called: report.html names a place outside"; fi

# what a job calls itself is text
sed 's|"name": *"[^"]*"|"name": "</script><script>alert(1)</script>"|' "$job" >hostile.json
run 0 simulate hostile.json -o hostile --stations 40 --nodes 41
[ "$(grep -c '<script>alert' hostile/report.html)" -eq 0 ] || fail "$called: a job's name became a script"
grep -q '&lt;/script&gt;&lt;script&gt;alert(1)' hostile/report.html || fail "$called: a job's name is not shown"

if command -v node >/dev/null 2>&1; then
    status=0
    node "$SOURCE_DIR/tests/report/browser.mjs" first/report.html || status=$?
    [ "$status" -eq 0 ] || [ "$status" -eq 77 ] || fail "$called: the page is wrong in a browser"
else
    echo "skipped: the page was not opened, for want of node"
fi
finish
