# Outputs that cannot be written, interruption, readers that went away: said in one line, nothing torn, nothing lost.
. "$SOURCE_DIR/tests/apps/common.sh"
job=$jobs/steady-300-60.json
files="history.vtp surface.stl surface.obj surface.ply surface.glb path.csv surface.step report.html summary.json"

whole() { python3 "$SOURCE_DIR/tests/apps/whole.py" "$@" || fail "$called: results are not whole"; }

# equal FOLDER: every result in it is the one of the good run, byte for byte
equal() {
    for file in $files; do
        [ ! -f "$1/$file" ] || cmp -s "$1/$file" "good/$file" || fail "$called: $1/$file is torn"
    done
    no_leavings "$1"
}

# shellcheck disable=SC2086 # $small is words
run 0 simulate "$job" -o good $small
whole good

# ---- a folder that is none ----
echo text >file
ln -s nowhere/at/all dangling
long=$(printf '%0300d' 0)
# shellcheck disable=SC2086
for folder in file file/below /proc/wirecut dangling "$long" "$long$long$long$long$long$long$long$long$long$long$long$long$long$long"; do
    run 4 simulate "$job" -o "$folder" $small --json
    one_line "expected a folder"
    no_result
done
[ "$(cat file)" = text ] || fail "a file in the place of the folder was changed"
if [ "$(id -u)" -ne 0 ]; then
    mkdir closed
    chmod 555 closed
    # shellcheck disable=SC2086
    run 4 simulate "$job" -o closed $small; one_line "closed"
    untouched closed
fi

# ---- every output in turn: a folder stands in its place ----
for file in $files; do
    mkdir -p "taken/$file/in"
    # shellcheck disable=SC2086
    run 4 simulate "$job" -o taken $small --json
    one_line "taken/$file"
    no_result
    equal taken
    [ ! -f taken/summary.json ] || fail "$called: summary.json vouches for a run that did not finish"
    rm -r taken
done

# ---- every output in turn: a full disk of just too few pages ----
mkdir disk
if [ "$(id -u)" -eq 0 ] && mount -t tmpfs -o nr_blocks=16 none disk 2>/dev/null; then
    trap 'umount disk 2>/dev/null' EXIT
    pages=0
    for file in $files; do
        pages=$((pages + ($(wc -c <"good/$file") + 4095) / 4096))
        room=$((pages - 1))
        [ "$room" -gt 0 ] || room=1
        umount disk
        mount -t tmpfs -o nr_blocks=$room none disk
        # shellcheck disable=SC2086
        run 4 simulate "$job" -o disk $small --json
        one_line "disk/$file" "No space left"
        no_result
        equal disk
        [ ! -e "disk/$file" ] || fail "$called: disk/$file appeared on a full disk"
        [ ! -e disk/summary.json ] || fail "$called: summary.json on a full disk"
    done
    # an earlier run's file outlives a full disk
    umount disk
    mount -t tmpfs -o nr_blocks=$((pages - 1)) none disk
    echo earlier >disk/surface.stl
    dd if=/dev/zero of=disk/filler bs=4096 2>/dev/null
    # shellcheck disable=SC2086
    run 4 simulate "$job" -o disk $small; one_line "disk/history.vtp"
    [ "$(cat disk/surface.stl)" = earlier ] || fail "$called: an earlier result was lost"
    mount -o remount,ro disk
    # shellcheck disable=SC2086
    run 4 simulate "$job" -o disk $small; one_line "disk" "Read-only"
    umount disk
    trap - EXIT
else
    echo "note: no tmpfs may be mounted here; a full disk is tried by a limit of file size only"
fi

# ---- a limit of file size ----
for file in $files; do
    limit=$(($(wc -c <"good/$file") / 1024)) # blocks of 512 bytes: half the file
    [ "$limit" -gt 0 ] || limit=1
    code=0
    # shellcheck disable=SC2086
    (ulimit -f "$limit" && exec "$WIRECUT" simulate "$job" -o limited $small --json) >out 2>err || code=$?
    called="a limit of $limit blocks for $file"
    [ "$code" -eq 4 ] || fail "$called: exit code $code, expected 4"
    one_line "limited/" "File too large"
    no_result
    equal limited
    rm -r limited
done

# ---- standard output that nobody reads, standard error that is closed ----
cat >pipes.py <<'END'
import os, subprocess, sys
which, command = sys.argv[1], sys.argv[2:]
read, write = os.pipe()
os.close(read)  # the reader is gone before a word is said
with open("err", "wb") as err, open("out", "wb") as out:
    done = subprocess.run(command, stdout=write if which == "out" else out, stderr=write if which == "err" else err,
                          restore_signals=True)
sys.exit(done.returncode if done.returncode >= 0 else 128 - done.returncode)
END
code=0
# shellcheck disable=SC2086
python3 pipes.py out "$WIRECUT" simulate "$job" -o pipe $small --quiet --json || code=$?
called="standard output without a reader"
[ "$code" -eq 4 ] || fail "$called: exit code $code, expected 4"
one_line "standard output"
equal pipe
whole pipe
code=0
# shellcheck disable=SC2086
python3 pipes.py err "$WIRECUT" simulate "$job" -o mute $small || code=$?
called="standard error without a reader"
[ "$code" -eq 0 ] || fail "$called: exit code $code, expected 0"
whole mute
code=0
# shellcheck disable=SC2086
"$WIRECUT" simulate "$job" -o closed-streams $small <&- >&- 2>&- || code=$?
called="closed standard streams"
[ "$code" -eq 0 ] || fail "$called: exit code $code, expected 0"
whole closed-streams
equal closed-streams

# ---- interruption: what was cut up to there is on disk ----
for signal in SIGINT SIGTERM; do
    code=0
    python3 "$SOURCE_DIR/tests/apps/terminal.py" --interrupt $signal "$WIRECUT" \
        simulate "$job" -o "cut-$signal" --stations 20000 --chord-tolerance 5 --json || code=$?
    called="$signal"
    [ "$code" -eq 130 ] || fail "$called: exit code $code, expected 130: $(cat -v terminal)"
    grep -q "interrupted" terminal || fail "$called: nothing was said: $(cat -v terminal)"
    whole "cut-$signal" --partial
    no_leavings "cut-$signal"
    cmp -s out "cut-$signal/summary.json" || fail "$called: --json is not summary.json"
    python3 -c 'import json, sys; sys.exit(not 0 < json.load(open("out"))["stations"] < 20000)' || fail "$called: stations"
done
finish
