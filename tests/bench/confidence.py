#!/usr/bin/python3
"""confidence.py DIR ANSWERS.json [DIR ANSWERS.json ..]: how often verdicts are right, as kernel/explain/confidence.c has it.
DIR holds a folder with a diagnosis.json for each case of ANSWERS. Prints the coefficients of a ridge-penalised logistic regression for
each class of verdict, the Brier score with each set of cases left out in turn, and the reliability by decile. Needs numpy."""
import json, math, os, sys

import numpy as np

from rig_score import judge


def names_of(effects):
    return [e if isinstance(e, str) else e["name"] for e in effects]


def is_right(truth, verdict):
    if "variant" in truth:
        return judge(truth, verdict)[1] == "right"
    kind = verdict["kind"]
    if truth["kind"] in ("none", "unknown"):
        return kind == truth["kind"]
    return kind == truth["kind"] and set(names_of(verdict["effects"])) == {e["name"] for e in truth["effects"]}


def cases_of(folder, answers, number):
    for truth in json.load(open(answers))["cases"]:
        path = os.path.join(folder, truth["case"], "diagnosis.json")
        if not os.path.exists(path):
            continue
        diagnosis = json.load(open(path))
        kind = diagnosis["verdict"]["kind"]
        group = kind if kind in ("none", "unknown", "ambiguous") else "named"
        yield group, diagnosis["verdict"]["confidence_by"], is_right(truth, diagnosis["verdict"]), number


def fit(cases, ridge=1.0):
    x = np.array([[1, c[1]] for c in cases], float)
    y = np.array([c[2] for c in cases], float)
    penalty = np.diag([0.1, ridge])
    w = np.zeros(2)
    for _ in range(50):
        p = 1 / (1 + np.exp(-x @ w))
        hessian = (x * (p * (1 - p))[:, None]).T @ x + penalty
        w -= np.linalg.solve(hessian, x.T @ (p - y) + penalty @ w)
    return w


def main():
    pairs = list(zip(sys.argv[1::2], sys.argv[2::2]))
    cases = [c for k, (folder, answers) in enumerate(pairs) for c in cases_of(folder, answers, k)]
    said = []
    for group in ("none", "unknown", "named"):
        own = [c for c in cases if c[0] == group]
        if not own:
            continue
        w = fit(own)
        print(f"{group}: {len(own)} cases, right {sum(c[2] for c in own)}, first {w[0]:.2f}, second {w[1]:.2f}")
        for c in own:
            others = [o for o in own if o[3] != c[3]] or own
            v = fit(others)
            said.append((1 / (1 + math.exp(-v[0] - v[1] * c[1])), c[2]))
    said += [(0.5, c[2]) for c in cases if c[0] == "ambiguous"]
    print(f"{len(said)} cases, Brier score, each set left out: {np.mean([(p - y) ** 2 for p, y in said]):.3f}")
    for low in range(10):
        row = [s for s in said if low <= 10 * s[0] < low + 1]
        if row:
            print(f"said {low / 10:.1f} to {low / 10 + 0.1:.1f}: {len(row)} cases, right {np.mean([s[1] for s in row]):.2f}, "
                  f"mean said {np.mean([s[0] for s in row]):.2f}")


if __name__ == "__main__":
    main()
