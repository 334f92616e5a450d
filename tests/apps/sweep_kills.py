"""Kill workers and the parent of a sweep at random, go on, and compare with an undisturbed run:

sweep_kills.py WIRECUT JOB KILLS CASES [SEED]

KILLS random workers are killed with SIGKILL, and once the parent; each run is begun again until every case is whole. In the
end no case was run to its end more than once, and sweep.csv has the bytes of the undisturbed run. Prints what was seen and
ends with 1 where it is not so.
"""
import collections
import json
import os
import pathlib
import random
import signal
import subprocess
import sys
import time

wirecut, job, kills, cases = sys.argv[1], sys.argv[2], int(sys.argv[3]), int(sys.argv[4])
random.seed(int(sys.argv[5]) if len(sys.argv) > 5 else 1)
half = cases // 2
json.dump({
    "format": "wirecut-study/1", "name": "kills", "verb": "simulate", "input": job,
    "options": {"stations": 40, "nodes": 31, "formats": "csv"},
    "parameters": {"/process/heat_W_per_m": {"from": 50, "to": 70, "count": half}, "/process/tension_N": [1.5, 2.5]},
    "figures": {"duration_s": "/duration_s", "verdict": "/feasibility/verdict"},
}, open("kills.json", "w"))


def workers(parent):
    try:
        with open(f"/proc/{parent}/task/{parent}/children") as file:
            return [int(word) for word in file.read().split()]
    except OSError:
        return []


def lives(process):
    """a process that nobody has asked for its end yet is none any more"""
    try:
        with open(f"/proc/{process}/stat") as file:
            return file.read().rsplit(")", 1)[1].split()[0] not in "ZX"
    except OSError:
        return False


def records(folder):
    """each case's record: a case that is run to its end once more gets another one"""
    found = {}
    for path in pathlib.Path(folder).glob("cases/*/*/case.json"):
        record = json.loads(path.read_text())
        if record["state"] == "done":
            found[path.parent.name] = path.stat().st_mtime_ns
    return found


subprocess.run([wirecut, "sweep", "kills.json", "-o", "calm", "-j", "2", "--quiet"], check=True)
killed, parents, runs, seen, again = 0, 0, 0, {}, collections.Counter()
while True:
    process = subprocess.Popen([wirecut, "sweep", "kills.json", "-o", "wild", "-j", "2", "--quiet", "--resume"],
                               stderr=subprocess.DEVNULL)
    runs += 1
    while process.poll() is None:
        time.sleep(random.uniform(0.01, 0.12))
        if killed < kills:
            for worker in random.sample(workers(process.pid), min(1, len(workers(process.pid)))):
                try:
                    os.kill(worker, signal.SIGKILL)
                    killed += 1
                except ProcessLookupError:
                    pass
        if parents == 0 and killed >= kills // 2:
            orphans = workers(process.pid)
            process.kill()
            process.wait()
            parents += 1
            deadline = time.time() + 20
            while any(map(lives, orphans)) and time.time() < deadline:
                time.sleep(0.05)
            alive = [w for w in orphans if lives(w)]
            if alive:
                sys.exit(f"workers outlived their parent: {alive}")
    now = records("wild")
    again.update(name for name, stamp in now.items() if seen.get(name, stamp) != stamp)
    seen = now
    if len(now) == cases and killed >= kills:
        break
    if runs > 200:
        sys.exit(f"{len(now)} of {cases} cases after {runs} runs, {killed} kills")
    if len(now) == cases:  # all whole before all kills: take one away
        victim = random.choice(sorted(now))
        for path in pathlib.Path("wild").glob(f"cases/*/{victim}/case.json"):
            path.unlink()
        del seen[victim]

if again:
    sys.exit(f"cases that were whole were run again: {dict(again)}")
if open("calm/sweep.csv", "rb").read() != open("wild/sweep.csv", "rb").read():
    sys.exit("sweep.csv differs from that of the undisturbed run")
left = [str(p) for p in pathlib.Path("wild").rglob("*wirecut-*")]
if left:
    sys.exit(f"left behind: {left[:3]}")
print(f"{killed} workers and {parents} parent killed in {runs} runs; {len(seen)} cases done once; sweep.csv equal, "
      f"{os.path.getsize('wild/sweep.csv')} bytes")
