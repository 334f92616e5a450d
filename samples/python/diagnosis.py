"""A diagnosis read and acted upon:  python3 diagnosis.py CASE.json DIR"""
import json
import os
import sys

import wirecut

case_file, folder = sys.argv[1:3]
os.makedirs(folder, exist_ok=True)
found = wirecut.diagnose(case_file, threads=2)
print(found.sentence)
print(found.table())

# what the verdict names goes into the next job
with open(case_file, encoding="utf-8") as file:
    first = json.load(file)["cuts"][0]["job"]
job = wirecut.Job.read(os.path.join(os.path.dirname(case_file), first))
effects = []
for effect in found.effects:
    parameters = {key: p["value"] for key, p in effect["parameters"].items() if isinstance(p, dict)}
    words = {key: p for key, p in effect["parameters"].items() if isinstance(p, str)}
    effects.append({"name": effect["name"], **words, **parameters})
improved = job.with_effects(*effects)
improved.write(os.path.join(folder, "improved.json"))
print(f"{len(effects)} effects in {folder}/improved.json")
