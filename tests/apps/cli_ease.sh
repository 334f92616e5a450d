# What a user types: help VERB, inputs in the wrong order, a narrow terminal, --force-law, --formats, names of effects.
. "$SOURCE_DIR/tests/apps/common.sh"
job=$jobs/steady-300-60.json

run 0 help simulate
cp out help
run 0 simulate --help
cmp -s out help || fail "help VERB is not VERB --help"
run 0 help
grep -q 'usage: wirecut VERB' out || fail "help without a verb"
run 2 help simulat; one_line 'did you mean simulate'
run 2 "$job" simulate; one_line 'the verb comes first: wirecut simulate'
run 2 score recording.csv "$job" -o order; one_line 'expected the job first'
run 2 compare scan.ply "$job" -o order; one_line 'expected the job first'
untouched order

# nothing is wider than a terminal of 66 columns
cat >narrow.py <<'EOF'
import fcntl, os, pty, struct, sys, termios
master, slave = pty.openpty()
fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 66, 0, 0))
if os.fork() == 0:
    os.dup2(slave, 1), os.dup2(slave, 2), os.close(master)
    os.environ["TERM"] = "xterm"
    os.execv(sys.argv[1], sys.argv[1:])
os.close(slave)
text = b""
while True:
    try:
        piece = os.read(master, 65536)
    except OSError:
        break
    if not piece:
        break
    text += piece
for line in text.decode().replace("\r", "\n").split("\n"):
    line = line.replace("\x1b[K", "")
    if len(line) > 66 and "usage:" not in line and (line.startswith("[") or "--help" in sys.argv):
        sys.exit(f"{len(line)} columns: {line}")
EOF
for verb in simulate compare mould; do
    python3 narrow.py "$WIRECUT" $verb --help || fail "$verb --help on 66 columns"
done
python3 narrow.py "$WIRECUT" simulate "$job" -o narrow --stations 400 || fail "the bar on 66 columns"

# the laws of a calibration
cat >law.json <<'EOF'
{"format": "wirecut-force-law/1", "process": {"force_law": {"a_N_per_mm": 0.2, "b_m2_per_J": 9e-4}, "tension_law": null}, "more": 1}
EOF
sed 's/"a_N_per_mm": *[-0-9.e]*, *"b_m2_per_J": *[-0-9.e]*}/"a_N_per_mm": 0.2, "b_m2_per_J": 9e-4}/' "$job" >same.json
for verb in simulate identify "path --format csv"; do
    # shellcheck disable=SC2086
    run 0 $verb "$job" -o by-option --force-law law.json --quiet
done
run 0 simulate "$job" -o plain --quiet
run 0 simulate "$job" -o by-option --force-law law.json --quiet
cmp -s plain/path.csv by-option/path.csv && fail "--force-law changes nothing"
run 3 simulate "$job" -o none --force-law "$job"; one_line '$.format' 'wirecut-force-law/1'
run 3 simulate "$job" -o none --force-law nowhere.json; one_line nowhere.json
untouched none

# the files that are asked for
# shellcheck disable=SC2086
run 0 simulate "$job" -o few --formats stl,step $small --quiet
[ "$(ls few | tr '\n' ' ')" = "report.html summary.json surface.step surface.stl " ] || fail "--formats: $(ls few)"
run 0 verify few --quiet
# shellcheck disable=SC2086
run 0 mould "$jobs/freeform-1.json" -o half --formats 3mf $small --quiet
[ "$(ls half | tr '\n' ' ')" = "lower.3mf mould.3mf mould.json report.html upper.3mf " ] || fail "--formats: $(ls half)"
run 2 simulate "$job" -o none --formats stl,dxf; one_line 'found "dxf"' 'stl,obj'

# the completion knows effects
run 0 --completion
grep -q 'wire_thermal_lag' out || fail "no names of effects in the completion"
finish
