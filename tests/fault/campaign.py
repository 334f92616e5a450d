"""campaign.py [--long] [--runs N] [--step K] [VERB...]: the command's results under faults, counted.

An earlier set of results, of an input A, lies in a folder. A run of an input B into it is killed, or a call of it fails.
Afterwards the folder holds one whole set under its voucher, A's or B's, and nothing else; whatever happened:

  lost    neither set is whole, also after `wirecut verify`, which finishes what a dead run began; of a sweep: the same
          command, given again, does not come to the table of a run without faults
  mixed   a voucher stands in the folder, and a file that it lists is not the one it lists
  crash   the command ended by a signal that was not ours
  untold  a run failed without a line that says why, or with an exit code that does not fit

Campaigns: a kill at every system call, a kill at random moments, every system call fails in turn, every allocation fails
in turn, a full disk (a tmpfs of just too few pages, where one may be mounted; else a limit of file size), files and a folder
without the right to write, two runs at once. Without --long: the quick verbs, and every k-th call; --step says which k.
--runs: of the calls of a verb so many at most, evenly spread, one of the error numbers at each.

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


def number(option):
    return int(sys.argv[sys.argv.index(option) + 1]) if option in sys.argv else None


STEP = number("--step") or (1 if LONG else 5)  # every k-th call
RUNS = number("--runs")
ERRORS = [errno.EIO, errno.ENOSPC, errno.EACCES, errno.EINTR, errno.ENOENT] if LONG else [errno.ENOSPC]

# one effect alone is looked for, which is quick: every other one is left out
EFFECTS = """wire_thermal_lag air_overheating end_cooling foam_density_gradient foam_inclusion tangential_drag wire_elongation
    mount_compliance rate_dependence wire_fouling empirical_force kerf_growth block_springback angle_offset tension_drift
    clock_offset tension_delay tension_zero angle_gain encoder_friction empirical_reading scan_offset scan_scale""".split()
WITHOUT = ["--no-proof", "--without", ",".join(EFFECTS)]
TARGET = [os.path.join(os.environ["SOURCE_DIR"], "samples/targets/bicubic.ply"), "--block", "400,600,300", "--process",
          os.path.join(os.environ["SOURCE_DIR"], "samples/jobs/freeform-1.json"), "--nodes", "31", "--chord-tolerance", "5",
          "--feed", "+y", "--tolerance", "50", "--stations"]
MADE = os.path.abspath("inputs")
PICTURE = [f"{MADE}/picture.png", "--points", f"{MADE}/points.csv", "--curves", "2", "--resolution"]
WORSE = ["cA/cut-1/job.json", "--with", f"{MADE}/improved.json", "--chord-tolerance"]

# verb: voucher, arguments of A, arguments of B
VERBS = {
    "calibrate": ("force_law.json", ["tA.csv"], ["tB.csv"]),
    "path": ("path.json", ["A.json", "--format", "urscript"], ["B.json", "--format", "urscript"]),
    "simulate": ("summary.json", ["A.json"], ["B.json", "--chord-tolerance", "1"]),
    "score": ("score.json", ["cA/case.json"], ["cA/case.json", "--settle", "1"]),
    "identify": ("identify.json", ["cA/cut-1/job.json", "--cuts", "2"], ["cA/cut-1/job.json", "--cuts", "3"]),
    "mould": ("mould.json", ["A.json", "--label", "a", "--chord-tolerance", "2"],
              ["B.json", "--label", "b", "--chord-tolerance", "1"]),
    "compare": ("deviation.json", ["A.json", "A.xyz"], ["B.json", "A.xyz"]),
    "control": ("control.json", ["cA/cut-1/job.json"], ["cA/cut-1/job.json", "--seed", "2"]),
    "compensate": ("compensation.json", [*WORSE, "5"], [*WORSE, "4"]),
    "sweep": ("sweep.json", [f"{MADE}/A.json"], [f"{MADE}/B.json"]),
    "overlay": ("overlay.json", ["A.json", *PICTURE, "8"], ["A.json", *PICTURE, "9"]),
    "diagnose": ("diagnosis.json", ["cA/case.json", *WITHOUT], ["cA/case.json", *WITHOUT, "--seed", "2"]),
    "design": ("summary.json", [*TARGET, "41"], [*TARGET, "43"]),
}
QUICK = ["calibrate", "path"]
counts = {}
worst = []


def make_inputs():
    """what is too plain to be kept in the repository"""
    os.makedirs(MADE, exist_ok=True)
    subprocess.run([sys.executable, os.path.join(os.environ["SOURCE_DIR"], "tests/photo/plain_png.py"), f"{MADE}/picture.png",
                    "160", "120"], check=True)
    with open(f"{MADE}/points.csv", "w", encoding="ascii") as file:
        file.write("u_px,v_px,x_mm,y_mm,z_mm\n25,100,0,0,300\n125,102,400,0,300\n120,15,400,900,300\n35,12,0,900,300\n")
    with open(f"{SMALL}/cA/cut-1/job.json", encoding="utf-8") as file:
        job = json.load(file)
    job["effects"] = [{"name": "wire_elongation", "strain_at_60W_2N": 0.004}]
    with open(f"{MADE}/improved.json", "w", encoding="utf-8") as file:
        json.dump(job, file)
    for name, heats in (("A", [70]), ("B", [70, 80])):
        with open(f"{MADE}/{name}.json", "w", encoding="utf-8") as file:
            json.dump({"format": "wirecut-study/1", "name": "faults", "verb": "simulate", "input": f"{SMALL}/A.json",
                       "options": {"stations": 20, "nodes": 15, "formats": "csv"},
                       "parameters": {"/process/heat_W_per_m": heats}, "figures": {"duration_s": "/duration_s"}}, file)


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


def spread(count, step):
    """every step-th of the calls 1 to count, or so many of them as --runs says"""
    if RUNS and count > RUNS:
        return [1 + (count - 1) * k // (RUNS - 1) for k in range(RUNS)]
    return list(range(1, count + 1, step))


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


def told(code, words):
    """a line that says why; verbs over many files say one of each, and what became of the whole"""
    lines = words.strip().split("\n")
    return code > 0 and lines[0].startswith("wirecut: ") and len(lines) <= 2


def told_of_sweep(code, words):
    """a case that failed has its words in its own folder; the run says how many did"""
    return code > 0 and bool(words.strip())


class Trial:
    """the good sets of a verb, and a folder to fail in"""

    told = staticmethod(told)

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

    def judge(self, campaign, place, must=None, folder=None):
        """must: the set that has to be there, 0 or 1; None: either"""
        folder = folder or self.folder
        add(campaign, "runs")
        if is_mixed(folder, self.voucher):
            add(campaign, "mixed", place)
        code, words = verify(folder)
        found = {name: digest for name, digest in contents(folder).items() if not name.startswith(".wirecut-")}
        if code != 0 or found not in self.good or (must is not None and found != self.good[must]):
            add(campaign, "lost", f"{place}: verify {code} {words.strip()}: {sorted(set(found) ^ set(self.good[0]))[:4]}")

    def go_on(self, campaign, place):
        """whoever comes next leaves nothing of a dead run behind"""
        code, words = run(command(self.verb, 1, self.folder))
        if code != 0 or contents(self.folder) != self.good[0]:
            add(campaign, "lost", f"{place}: the next run ends with {code} {words.strip()}, leaves {sorted(os.listdir(self.folder))}")


class SweepTrial(Trial):
    """a sweep's folder grows: what is right is its table, and that each set in it is whole"""

    told = staticmethod(told_of_sweep)

    def judge(self, campaign, place, must=None, folder=None):
        folder = folder or self.folder
        add(campaign, "runs")
        for where, _, files in os.walk(folder):
            if any(name in files and is_mixed(where, name) for name in ("plan.json", "sweep.json", "summary.json")):
                add(campaign, "mixed", f"{place}: {where}")
        if must == 1 and verify(folder)[0] != 0:
            add(campaign, "lost", f"{place}: done, but not whole")
        os.chmod(folder, 0o755)
        code, words = run(command(self.verb, 2, folder))
        left = [name for _, folders, files in os.walk(folder) for name in folders + files if name.startswith(".wirecut-")]
        tables = ("sweep.csv", "manifest.csv")
        if code != 0 or left or any(contents(folder).get(name) != self.good[1][name] for name in tables):
            add(campaign, "lost", f"{place}: the same command ends with {code} {words.strip()}, leaves {left}")

    def go_on(self, campaign, place):
        pass


def kill_at_every_call(trial, step):
    campaign = "kill at a system call"
    for n in spread(trial.calls("call"), step):
        trial.reset()
        code, words = run(command(trial.verb, 2, trial.folder), {"FAULT_AT": str(n), "FAULT_WHAT": "call", "FAULT_HOW": "kill"})
        place = f"{trial.verb}, call {n}"
        if code not in (-signal.SIGKILL, 0):
            add(campaign, "crash", f"{place}: ended with {code}: {words}")
        trial.judge(campaign, place)
        trial.go_on(campaign, place)


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
        trial.judge(campaign, f"{trial.verb}, kill {k}")


def every_call_fails(trial, step):
    campaign = "a system call fails"
    for k, n in enumerate(spread(trial.calls("call"), step)):
        for code_wanted in [ERRORS[k % len(ERRORS)]] if RUNS else ERRORS:
            trial.reset()
            code, words = run(command(trial.verb, 2, trial.folder),
                              {"FAULT_AT": str(n), "FAULT_WHAT": "call", "FAULT_HOW": str(code_wanted)})
            place = f"{trial.verb}, call {n}, {errno.errorcode[code_wanted]}"
            if code < 0:
                add(campaign, "crash", f"{place}: signal {-code}")
            if code != 0 and not trial.told(code, words):
                add(campaign, "untold", f"{place}: {code} {words}")
            trial.judge(campaign, place, 1 if code == 0 else None)


def every_allocation_fails(trial, step):
    campaign = "an allocation fails"
    for n in spread(trial.calls("memory"), step):
        trial.reset()
        code, words = run(command(trial.verb, 2, trial.folder), {"FAULT_AT": str(n), "FAULT_WHAT": "memory"})
        place = f"{trial.verb}, allocation {n}"
        if code < 0:
            add(campaign, "crash", f"{place}: signal {-code}: {words}")
        if code != 0 and not (told_of_sweep(code, words) if trial.verb == "sweep" else "memory" in words.lower()):
            add(campaign, "untold", f"{place}: {code} {words}")
        trial.judge(campaign, place, 1 if code == 0 else None)


def mount(folder, pages):
    os.makedirs(folder, exist_ok=True)
    return subprocess.run(["mount", "-t", "tmpfs", "-o", f"nr_blocks={pages}", "none", folder], stderr=subprocess.DEVNULL,
                          check=False).returncode == 0


def pages_of(folder, page=4096):
    return sum((os.path.getsize(os.path.join(where, name)) + page - 1) // page
               for where, _, files in os.walk(folder) for name in files)


def full_disk(trial, sizes):
    """a disk with room for the old set and a part of the new one"""
    campaign = "a full disk"
    size = [pages_of(f"good-{trial.verb}-{k}") for k in (1, 2)]
    folder = os.path.abspath(f"disk-{trial.verb}")
    for k in range(sizes):
        pages = size[0] + (size[1] + 6) * (k + 1) // (sizes + 1)
        if not mount(folder, pages):
            print("note: no tmpfs may be mounted here: a full disk is tried by a limit of file size alone")
            break
        try:
            shutil.copytree(f"good-{trial.verb}-1", folder, dirs_exist_ok=True)
            code, words = run(command(trial.verb, 2, folder))
            place = f"{trial.verb}, {pages} pages"
            if code < 0:
                add(campaign, "crash", f"{place}: signal {-code}")
            if code != 0 and not (trial.told(code, words) and code == 4 and "No space left" in words):
                add(campaign, "untold", f"{place}: {code} {words}")

            # a sweep goes on where there is room again
            if trial.verb == "sweep":
                subprocess.run(["mount", "-o", f"remount,nr_blocks={2 * sum(size) + 100}", folder], check=True)
            trial.judge(campaign, place, 1 if code == 0 else 0, folder)
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
        if code != 0 and not (trial.told(code, words) and code == 4):
            add(campaign, "untold", f"{place}: {code} {words}")
        trial.judge(campaign, place, 1 if code == 0 else 0)


def nobody():
    """root may write anywhere: the right is lost with the name"""
    if os.getuid() == 0:
        os.setgroups([])
        os.setgid(65534)
        os.setuid(65534)


def no_right_to_write(trial):
    """files of mode 0444, and a folder of mode 0555"""
    campaign = "no right to write"
    for mode, folder_mode in ((0o444, 0o755), (0o644, 0o555), (0o444, 0o555)):
        trial.reset()
        for where, folders, files in os.walk(trial.folder, topdown=False):
            for name in files:
                os.chmod(os.path.join(where, name), mode)
            os.chmod(where, folder_mode)
            for name in [*files, "."]:
                if os.getuid() == 0:
                    os.chown(os.path.join(where, name), 65534, 65534)
        code, words = run(command(trial.verb, 2, trial.folder), limit=nobody)
        place = f"{trial.verb}, files {mode:o}, folder {folder_mode:o}"
        if code < 0:
            add(campaign, "crash", f"{place}: signal {-code}")
        if code != 0 and not (trial.told(code, words) and code == 4):
            add(campaign, "untold", f"{place}: {code} {words}")
        if folder_mode == 0o555 and code == 0:
            add(campaign, "lost", f"{place}: done, though nothing could be written")
        for where, _, _ in os.walk(trial.folder):
            os.chmod(where, 0o755)
        trial.judge(campaign, place, 1 if code == 0 else 0)


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
        trial.judge(campaign, f"{trial.verb}, pair {k}")


def report():
    print(f"{'campaign':24} {'runs':>6} {'lost':>6} {'mixed':>6} {'crash':>6} {'untold':>6}")
    for campaign, figures in counts.items():
        print(f"{campaign:24}", *(f"{figures.get(what, 0):6}" for what in ("runs", "lost", "mixed", "crash", "untold")))
    print("\n".join(worst), flush=True)
    return sum(count for figures in counts.values() for what, count in figures.items() if what != "runs")


def main():
    verbs = [word for word in sys.argv[1:] if word in VERBS] or (list(VERBS) if LONG else QUICK)
    make_inputs()
    for verb in verbs:
        trial = SweepTrial(verb) if verb == "sweep" else Trial(verb)
        step = STEP if LONG or verb == QUICK[0] else 2 * STEP
        kill_at_every_call(trial, step)
        kill_at_random(trial, (RUNS or 200) if LONG else 10)
        every_call_fails(trial, step)
        memory = trial.calls("memory")
        every_allocation_fails(trial, max(1, memory // (1000 if LONG else 40)))
        full_disk(trial, min(RUNS or 12, 12) if LONG else 3)
        no_right_to_write(trial)
        two_at_once(trial, min(RUNS or 50, 50) if LONG else 5)
        print(f"{verb}: {trial.calls('call')} system calls, {memory} allocations", flush=True)
    sys.exit(report() > 0)


main()
