"""campaign.py [--long] [--step K] [VERB...]: the command's results under faults, counted.

An earlier set of results, of an input A, lies in a folder. A run of an input B into it is killed, or a call of it fails.
Afterwards the folder holds one whole set under its voucher, A's or B's, and nothing else; whatever happened:

  lost    neither set is whole, also after `wirecut verify`, which finishes what a dead run began
  mixed   a voucher stands in the folder, and a file that it lists is not the one it lists
  crash   the command ended by a signal that was not ours
  untold  a run failed without a line that says why, or with an exit code that does not fit

Campaigns: a kill at every system call, a kill at random moments, every system call fails in turn, every allocation fails
in turn, a full disk (a tmpfs of just too few pages, where one may be mounted; else a limit of file size), two runs at
once. Without --long: the quick verbs, and every k-th call; --step says which k.

  WIRECUT      the command       FAULT_SHIM   shim.c as a library      SOURCE_DIR   the repository
"""
import errno
import hashlib
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time

WIRECUT, SHIM = os.environ["WIRECUT"], os.environ["FAULT_SHIM"]
SMALL = os.path.join(os.environ["SOURCE_DIR"], "tests/fault/small")
LONG = "--long" in sys.argv
GIVEN = int(sys.argv[sys.argv.index("--step") + 1]) if "--step" in sys.argv else None
STEP = GIVEN or (1 if LONG else 5)  # every k-th call
ERRORS = [errno.EIO, errno.ENOSPC, errno.EACCES, errno.EINTR, errno.ENOENT] if LONG else [errno.ENOSPC]

# verb: voucher, arguments of A, arguments of B
VERBS = {
    "calibrate": ("force_law.json", ["tA.csv"], ["tB.csv"]),
    "path": ("path.json", ["A.json", "--format", "urscript"], ["B.json", "--format", "urscript"]),
    "simulate": ("summary.json", ["A.json"], ["B.json", "--chord-tolerance", "1"]),
    "score": ("score.json", ["cA/case.json"], ["cA/case.json", "--settle", "1"]),
    "identify": ("identify.json", ["cA/cut-1/job.json", "--cuts", "2"], ["cA/cut-1/job.json", "--cuts", "3"]),
    "mould": ("mould.json", ["A.json", "--label", "a"], ["B.json", "--label", "b", "--chord-tolerance", "1"]),
    "compare": ("deviation.json", ["A.json", "A.xyz"], ["B.json", "A.xyz"]),
    "diagnose": ("diagnosis.json", ["cA/case.json", "--no-proof"], ["cA/case.json", "--no-proof", "--seed", "2"]),
    "control": ("control.json", ["cA/cut-1/job.json"], ["cA/cut-1/job.json", "--seed", "2"]),
}
QUICK = ["calibrate", "path"]
counts = {}
worst = []


def add(campaign, what, place=None):
    counts.setdefault(campaign, {}).setdefault(what, 0)
    counts[campaign][what] += 1
    if place and len(worst) < 40:
        worst.append(f"{campaign}: {what}: {place}")


def contents(folder):
    """name: SHA-256, or what it is"""
    found = {}
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        if os.path.isfile(path):
            with open(path, "rb") as file:
                found[name] = hashlib.sha256(file.read()).hexdigest()
        else:
            found[name] = "folder"
    return found


def command(verb, which, folder):
    return [WIRECUT, verb, *VERBS[verb][which], "-o", folder, "-q"]


def run(arguments, fault=None, limit=None):
    """exit code (negative: a signal) and the words"""
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    if fault:
        environment.update(fault, LD_PRELOAD=SHIM)
    done = subprocess.run(arguments, cwd=SMALL, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                          preexec_fn=limit, timeout=300)
    return done.returncode, done.stderr.decode("utf-8", "replace")


def verify(folder):
    return run([WIRECUT, "verify", folder, "-q"])


def is_mixed(folder, voucher):
    """by our own eyes, before anything is put right"""
    path = os.path.join(folder, voucher)
    if not os.path.exists(path):
        return False
    with open(path, encoding="utf-8") as file:
        listed = json.load(file)["sha256"]
    found = contents(folder)
    return any(found.get(name) != digest for name, digest in listed.items())


def judge(campaign, place, folder, voucher, sets, must=None):
    """sets: the contents that are right; must: the one that has to be there"""
    add(campaign, "runs")
    if is_mixed(folder, voucher):
        add(campaign, "mixed", place)
    code, words = verify(folder)
    found = {name: digest for name, digest in contents(folder).items() if not name.startswith(".wirecut-")}
    if code != 0 or found not in sets or (must is not None and found != must):
        add(campaign, "lost", f"{place}: verify {code} {words.strip()}: {sorted(set(found) ^ set(sets[0]))[:4]}")


def told(code, words):
    return code > 0 and words.startswith("wirecut: ") and words.count("\n") == 1


class Trial:
    """the good sets of a verb, and a folder to fail in"""

    def __init__(self, verb):
        self.verb, self.voucher = verb, VERBS[verb][0]
        self.good = []
        for which in (1, 2):
            folder = f"good-{verb}-{which}"
            code, words = run(command(verb, which, os.path.abspath(folder)))
            if code != 0:
                sys.exit(f"{verb}: a run without faults ends with {code}: {words}")
            self.good.append(contents(folder))
        if self.good[0] == self.good[1]:
            sys.exit(f"{verb}: both inputs have the same results, which shows nothing")
        self.folder = os.path.abspath(f"try-{verb}")

    def reset(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        shutil.copytree(f"good-{self.verb}-1", self.folder)

    def calls(self, what):
        self.reset()
        code, words = run(command(self.verb, 2, self.folder), {"FAULT_COUNT": os.path.abspath("count"), "FAULT_WHAT": what})
        if code != 0:
            sys.exit(f"{self.verb}: under the shim, without a fault, it ends with {code}: {words}")
        with open("count", encoding="ascii") as file:
            count = int(file.read())
        if count < 10:
            sys.exit(f"{self.verb}: the shim counts {count} calls: it does not stand before the C library")
        return count


def kill_at_every_call(trial, step):
    campaign = "kill at a system call"
    for n in range(1, trial.calls("call") + 1, step):
        trial.reset()
        code, words = run(command(trial.verb, 2, trial.folder), {"FAULT_AT": str(n), "FAULT_WHAT": "call", "FAULT_HOW": "kill"})
        place = f"{trial.verb}, call {n}"
        if code not in (-signal.SIGKILL, 0):
            add(campaign, "crash", f"{place}: ended with {code}: {words}")
        judge(campaign, place, trial.folder, trial.voucher, trial.good)

        # whoever comes next leaves nothing of it behind
        code, words = run(command(trial.verb, 1, trial.folder))
        if code != 0 or contents(trial.folder) != trial.good[0]:
            add(campaign, "lost", f"{place}: the next run ends with {code} {words.strip()}, leaves {sorted(os.listdir(trial.folder))}")


def kill_at_random(trial, runs):
    campaign = "kill at random"
    dice = random.Random(1)
    trial.reset()
    begun = time.monotonic()
    run(command(trial.verb, 2, trial.folder))
    length = time.monotonic() - begun
    for k in range(runs):
        trial.reset()
        process = subprocess.Popen(command(trial.verb, 2, trial.folder), cwd=SMALL, stderr=subprocess.DEVNULL)
        time.sleep(dice.random() * length)
        process.kill()
        process.wait()
        judge(campaign, f"{trial.verb}, kill {k}", trial.folder, trial.voucher, trial.good)


def every_call_fails(trial, step):
    campaign = "a system call fails"
    for n in range(1, trial.calls("call") + 1, step):
        for code_wanted in ERRORS:
            trial.reset()
            code, words = run(command(trial.verb, 2, trial.folder),
                              {"FAULT_AT": str(n), "FAULT_WHAT": "call", "FAULT_HOW": str(code_wanted)})
            place = f"{trial.verb}, call {n}, {errno.errorcode[code_wanted]}"
            if code < 0:
                add(campaign, "crash", f"{place}: signal {-code}")
            if code != 0 and not told(code, words):
                add(campaign, "untold", f"{place}: {code} {words}")
            judge(campaign, place, trial.folder, trial.voucher, trial.good, trial.good[1] if code == 0 else None)


def every_allocation_fails(trial, step):
    campaign = "an allocation fails"
    for n in range(1, trial.calls("memory") + 1, step):
        trial.reset()
        code, words = run(command(trial.verb, 2, trial.folder), {"FAULT_AT": str(n), "FAULT_WHAT": "memory"})
        place = f"{trial.verb}, allocation {n}"
        if code < 0:
            add(campaign, "crash", f"{place}: signal {-code}: {words}")
        if code != 0 and "memory" not in words.lower():
            add(campaign, "untold", f"{place}: {code} {words}")
        judge(campaign, place, trial.folder, trial.voucher, trial.good, trial.good[1] if code == 0 else None)


def mount(folder, pages):
    os.makedirs(folder, exist_ok=True)
    return subprocess.run(["mount", "-t", "tmpfs", "-o", f"nr_blocks={pages}", "none", folder], stderr=subprocess.DEVNULL,
                          check=False).returncode == 0


def full_disk(trial, sizes):
    """a disk with room for the old set and a part of the new one"""
    campaign = "a full disk"
    page = 4096
    size = [sum((os.path.getsize(f"good-{trial.verb}-{k}/{name}") + page - 1) // page for name in trial.good[k - 1])
            for k in (1, 2)]
    folder = os.path.abspath(f"disk-{trial.verb}")
    for k in range(sizes):
        pages = size[0] + (size[1] + 6) * (k + 1) // (sizes + 1)
        if not mount(folder, pages):
            print("note: no tmpfs may be mounted here: a full disk is tried by a limit of file size alone")
            break
        try:
            for name in trial.good[0]:
                shutil.copy(f"good-{trial.verb}-1/{name}", folder)
            code, words = run(command(trial.verb, 2, folder))
            place = f"{trial.verb}, {pages} pages"
            if code < 0:
                add(campaign, "crash", f"{place}: signal {-code}")
            if code != 0 and not (told(code, words) and code == 4 and "No space left" in words):
                add(campaign, "untold", f"{place}: {code} {words}")
            judge(campaign, place, folder, trial.voucher, trial.good, trial.good[1 if code == 0 else 0])
        finally:
            subprocess.run(["umount", folder], check=True)
    for k in range(sizes):
        limit = 1000 + 200000 * k
        trial.reset()
        code, words = run(command(trial.verb, 2, trial.folder),
                          limit=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
        place = f"{trial.verb}, files up to {limit} bytes"
        if code < 0:
            add(campaign, "crash", f"{place}: signal {-code}")
        if code != 0 and not (told(code, words) and code == 4):
            add(campaign, "untold", f"{place}: {code} {words}")
        judge(campaign, place, trial.folder, trial.voucher, trial.good, trial.good[1 if code == 0 else 0])


def two_at_once(trial, runs):
    campaign = "two runs at once"
    for k in range(runs):
        trial.reset()
        both = [subprocess.Popen(command(trial.verb, which, trial.folder), cwd=SMALL, stderr=subprocess.PIPE) for which in (1, 2)]
        for process in both:
            words = process.communicate()[1].decode()
            if process.returncode < 0:
                add(campaign, "crash", f"{trial.verb}, pair {k}: signal {-process.returncode}")
            elif process.returncode not in (0, 4) or (process.returncode == 4 and "process" not in words):
                add(campaign, "untold", f"{trial.verb}, pair {k}: {process.returncode} {words}")
        judge(campaign, f"{trial.verb}, pair {k}", trial.folder, trial.voucher, trial.good)


def main():
    verbs = [word for word in sys.argv[1:] if word in VERBS] or (list(VERBS) if LONG else QUICK)
    for verb in verbs:
        trial = Trial(verb)
        kill_at_every_call(trial, STEP if LONG or verb == QUICK[0] else 2 * STEP)
        kill_at_random(trial, 200 if LONG else 10)
        every_call_fails(trial, STEP if LONG or verb == QUICK[0] else 2 * STEP)
        memory = trial.calls("memory")
        every_allocation_fails(trial, max(1, memory // (1000 if LONG else 40)))
        full_disk(trial, 12 if LONG else 3)
        two_at_once(trial, 50 if LONG else 5)
    bad = 0
    print(f"{'campaign':24} {'runs':>6} {'lost':>6} {'mixed':>6} {'crash':>6} {'untold':>6}")
    for campaign, figures in counts.items():
        print(f"{campaign:24}", *(f"{figures.get(what, 0):6}" for what in ("runs", "lost", "mixed", "crash", "untold")))
        bad += sum(count for what, count in figures.items() if what != "runs")
    print("\n".join(worst))
    sys.exit(bad > 0)


main()
