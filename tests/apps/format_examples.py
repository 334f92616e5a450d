"""The examples of kernel/FORMATS.md:

format_examples.py write DOCUMENT FOLDER            every fenced block with a file name, "```json job.json", to a file
format_examples.py compare DOCUMENT EXAMPLE RESULT  an example beside what the program wrote

compare: every key of the example is in the result at the same place with a value of the same kind, and every key of the
result stands in backticks in the document. Keys that depend on the input (names of channels, zones, effects) may be
fewer in the example. Of a CSV the headers are the same. Prints what is wrong and ends with 1.
"""
import csv
import json
import pathlib
import re
import sys


def blocks(document):
    return re.findall(r"^```(?:json|csv|text) (\S+)\n(.*?)^```", document, re.S | re.M)


def kind(value):
    if isinstance(value, bool):
        return "true or false"
    return {dict: "object", list: "array", str: "text", int: "number", float: "number"}[type(value)]


def compare(example, result, place, faults):
    """the example's keys and kinds are those of the result; null stands for any kind"""
    if example is None or result is None:
        return
    if kind(example) != kind(result):
        faults.append(f"{place}: the example has {kind(example)}, the program writes {kind(result)}")
    elif isinstance(example, dict):
        for key, value in example.items():
            if key not in result:
                faults.append(f"{place}.{key}: in the example, but the program does not write it")
            else:
                compare(value, result[key], f"{place}.{key}", faults)
    elif isinstance(example, list) and example and result:
        compare(example[0], result[0], f"{place}[0]", faults)


def keys_of(value):
    if isinstance(value, dict):
        return set(value) | set().union(*(keys_of(v) for v in value.values()))
    if isinstance(value, list):
        return set().union(*(keys_of(v) for v in value))
    return set()


def documented(document):
    outside = re.sub(r"^```.*?^```", "", document, flags=re.S | re.M)
    return set(re.findall(r"\w+", " ".join(re.findall(r"`([^`\n]*)`", outside))))


def main():
    document = pathlib.Path(sys.argv[2]).read_text()
    if sys.argv[1] == "write":
        folder = pathlib.Path(sys.argv[3])
        for name, body in blocks(document):
            (folder / name).write_text(body)
        print(len(blocks(document)))
        return 0
    example, result, faults = pathlib.Path(sys.argv[3]), pathlib.Path(sys.argv[4]), []
    if example.suffix == ".csv":
        heads = [next(csv.reader(line for line in open(path) if not line.startswith("#"))) for path in (example, result)]
        if heads[0] != heads[1]:
            faults.append(f"{example.name}: the example has the columns {heads[0]}, the program writes {heads[1]}")
    else:
        given, written = json.loads(example.read_text()), json.loads(result.read_text())
        compare(given, written, example.name, faults)
        if isinstance(written, dict) and isinstance(written.get("sha256"), dict):
            written["sha256"] = {}  # its keys are names of files
        for key in sorted(keys_of(written) - documented(document)):
            faults.append(f"{example.name}: the program writes \"{key}\", which stands in no backticks in FORMATS.md: "
                          "add its row and put it into the example")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


sys.exit(main())
