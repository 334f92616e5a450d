# wirecut sweep --slurm with a real Slurm: munged, slurmctld and slurmd of this test alone, in its own folder. A task is killed
# on purpose; submitting again runs what it lost; the table is that of a local sweep.
# labels: cli slow
. "$SOURCE_DIR/tests/apps/common.sh"
for program in sbatch squeue scancel slurmctld slurmd munged; do
    command -v $program >/dev/null || { echo "skipped: no $program (Debian: slurm-wlm munge)"; exit 77; }
done
[ "$(id -u)" -eq 0 ] || { echo "skipped: slurmd needs root"; exit 77; }

# a socket's name is at most 107 bytes long: not in the build's folder
base=$(mktemp -d /tmp/wirecut-slurm-XXXXXX)
host=$(hostname -s)
SLURM_CONF=$base/slurm.conf
export SLURM_CONF
mkdir "$base/state" "$base/spool"
chmod 755 "$base"
dd if=/dev/urandom of="$base/munge.key" bs=1024 count=1 2>/dev/null
chmod 400 "$base/munge.key"
port=$((20000 + $$ % 20000))
cat >"$SLURM_CONF" <<END
ClusterName=wirecut
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$base/munge.sock
CredType=cred/munge
SlurmctldPort=$port
SlurmdPort=$((port + 1))
StateSaveLocation=$base/state
SlurmdSpoolDir=$base/spool
SlurmctldPidFile=$base/slurmctld.pid
SlurmdPidFile=$base/slurmd.pid
SlurmctldLogFile=$base/slurmctld.log
SlurmdLogFile=$base/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
ReturnToService=2
MinJobAge=300
NodeName=$host NodeAddr=127.0.0.1 CPUs=4 RealMemory=2000 State=UNKNOWN
PartitionName=short Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END

# what this test started, by the numbers that the daemons wrote
stop_slurm() {
    scancel --user=root 2>/dev/null
    for daemon in slurmd slurmctld munged; do
        [ ! -s "$base/$daemon.pid" ] || kill "$(cat "$base/$daemon.pid")" 2>/dev/null
    done
    sleep 1
    rm -rf "$base"
}
trap stop_slurm EXIT
munged --force --key-file="$base/munge.key" --socket="$base/munge.sock" --pid-file="$base/munged.pid" \
    --log-file="$base/munged.log" --seed-file="$base/munge.seed" || { cat "$base/munged.log"; exit 1; }
slurmctld -f "$SLURM_CONF" || exit 1
slurmd -f "$SLURM_CONF" -N "$host" || exit 1
for _ in $(seq 60); do [ "$(sinfo -h -o %t 2>/dev/null)" = idle ] && break; sleep 1; done
[ "$(sinfo -h -o %t)" = idle ] || { sinfo; tail -n 20 "$base"/*.log; exit 1; }

# drained JOB: wait until none of its tasks is in the queue
drained() {
    for _ in $(seq 600); do [ -z "$(squeue -h -j "$1" 2>/dev/null)" ] && return; sleep 0.5; done
    fail "job $1 is still in the queue: $(squeue)"
}

cat >study.json <<END
{"format": "wirecut-study/1", "name": "slurm", "verb": "simulate", "input": "$jobs/freeform-1.json",
 "options": {"nodes": 121, "formats": "csv"},
 "parameters": {"/process/heat_W_per_m": {"from": 50, "to": 70, "count": 8}, "/process/tension_N": [1.5, 2, 2.5]},
 "figures": {"duration_s": "/duration_s", "verdict": "/feasibility/verdict"}}
END
run 0 sweep study.json -o local -j 2 --quiet

run 0 sweep study.json -o there --slurm --tasks 4 --partition short --time 0:10:00 --memory 200M --quiet
job=$(sed -n 's/^Submitted batch job //p' out)
[ -n "$job" ] || fail "$called: no job: $(cat out)"

# a running task is killed on purpose, with what it runs
task=
for _ in $(seq 200); do
    task=$(squeue -h -r -j "$job" -t RUNNING -o %i 2>/dev/null | head -n 1)
    [ -n "$task" ] && break
    sleep 0.1
done
[ -n "$task" ] || fail "no task was seen running"
scancel --signal=KILL --full "$task"
drained "$job"
run 1 sweep there --status --json
grep -q '"missing": [1-9]\|"crashed": [1-9]' out || fail "nothing was lost by the task that was killed: $(cat out)"
lost=$(python3 -c "import json; d = json.load(open('out')); print(d['cases'] - d['done'])")

# the same command again: what was whole stays
find there/cases -name case.json -newer there/plan.json | sort >whole
stamp=$(xargs stat -c '%n %Y' <whole | sort)
run 0 sweep study.json -o there --slurm --tasks 4 --quiet
drained "$(sed -n 's/^Submitted batch job //p' out)"
run 0 sweep there --status
[ "$(xargs stat -c '%n %Y' <whole | sort)" = "$stamp" ] || fail "a case that was whole was run again"
run 0 sweep there --collect --quiet
cmp -s there/sweep.csv local/sweep.csv || fail "the table of Slurm is another one"
echo "job $job: task $task killed, $lost of 24 cases lost and run again"
finish
