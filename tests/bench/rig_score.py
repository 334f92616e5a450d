#!/usr/bin/python3
"""rig_score.py DIR ANSWERS.json: diagnoses of the second laboratory's cases (DIR/rNN/diagnosis.json) against their labels.
A null is right as `none`, or where an instrument is named that the rig has; an effect in another form where its family is
named and nothing beside it; an instrument by the kind of the verdict. Prints a line a case and the totals."""
import json, os, sys

INSTRUMENTS = {"angle_offset", "angle_gain", "tension_gain", "tension_zero", "tension_drift", "tension_delay", "clock_offset",
               "encoder_friction", "scan_offset", "scan_scale"}
# what a null's own rig may be called by, beside what its label accepts
CAUSES = {"tdelay": {"tension_delay", "clock_offset"}, "tdelay5": {"tension_delay", "clock_offset"}, "joint": {"encoder_friction"},
          "shift": {"scan_offset"}, "scanshift": {"scan_offset"}}


def judge(truth, verdict):
    """class of the case, and right, wrong (a false name) or abstained"""
    names = {e if isinstance(e, str) else e["name"] for e in verdict["effects"]}
    kind = verdict["kind"]
    if not truth["effects"]:
        allowed = set(truth["accept"]) | CAUSES.get(truth["variant"], set())
        right = kind == "none" or (bool(names) and names <= allowed)
        return "null", "right" if right else "wrong" if names - INSTRUMENTS else "abstained"
    if truth["kind"] == "instrument":
        return "instrument", "right" if kind == "instrument" else "wrong" if names - INSTRUMENTS else "abstained"
    family = set(truth["family"])
    if kind in ("none", "unknown"):
        return "form", "abstained"
    right = bool(names & family) and names <= family | set(truth["accept"])
    return "form", "right" if right else "wrong"


def main():
    folder, answers = sys.argv[1:]
    total = {}
    for truth in json.load(open(answers))["cases"]:
        path = os.path.join(folder, truth["case"], "diagnosis.json")
        if not os.path.exists(path):
            continue
        verdict = json.load(open(path))["verdict"]
        case, result = judge(truth, verdict)
        total.setdefault(case, {}).setdefault(result, []).append(truth["case"])
        print(f"{truth['case']} {result:9s} {truth['variant']}, {truth['form']}: {verdict['kind']} "
              f"{', '.join(e if isinstance(e, str) else e['name'] for e in verdict['effects'])} {verdict['confidence']:.2f}")
    for case, results in total.items():
        count = sum(len(x) for x in results.values())
        print(f"{case}: " + ", ".join(f"{k} {len(v)} of {count}" for k, v in sorted(results.items())))


if __name__ == "__main__":
    main()
