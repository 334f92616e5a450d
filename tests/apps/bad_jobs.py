"""bad_jobs.py FOLDER: job files with one thing wrong in each; prints NAME|PLACE|EXPECTATION for cli_bad_input.sh.

PLACE and EXPECTATION are words that the one line of error must hold.
"""
import copy
import json
import os
import sys

folder = sys.argv[1]
good = {
    "format": "wirecut-job/1",
    "name": "bad",
    "block": {"size_mm": [300, 200, 100], "material": "EPS"},
    "wire": {"diameter_mm": 0.15, "material": "Kanthal A", "nodes": 21, "length_mm": 420.0},
    "process": {"heat_W_per_m": 60.0, "tension_N": 2.0, "force_law": {"a_N_per_mm": 0.1, "b_m2_per_J": 8.6e-4}},
    "path": {
        "mount_a_mm": [[-50, y, 50] for y in range(-10, 300, 10)],
        "mount_b_mm": [[350, y, 50] for y in range(-10, 300, 10)],
    },
}
design = copy.deepcopy(good)
del design["path"], design["wire"]["length_mm"]
design["design"] = {
    "edge_a": {"points_mm": [[0, 0, 50], [0, 100, 50], [0, 200, 50]]},
    "edge_b": {"points_mm": [[300, 0, 50], [300, 100, 60], [300, 200, 50]]},
    "stations": 21,
    "extra_length_mm": [[0.0, 5.0], [0.5, 20.0], [1.0, 5.0]],
    "clearance_mm": 80.0,
}
DELETE = object()


def write(name, text, place, expectation):
    with open(os.path.join(folder, name + ".json"), "wb") as file:
        file.write(text if isinstance(text, bytes) else text.encode("utf-8"))
    print(f"{name}|{place}|{expectation}")


def with_value(base, path, value):
    made = copy.deepcopy(base)
    at = made
    for key in path[:-1]:
        at = at[key]
    if value is DELETE:
        del at[path[-1]]
    else:
        at[path[-1]] = value
    return made


def bad(name, path, value, place, expectation, base=good):
    """The good job with one value changed; a string that begins with = stands in the file as it is."""
    raw = isinstance(value, str) and value.startswith("=")
    text = json.dumps(with_value(base, path, "@RAW@" if raw else value))
    write(name, text.replace('"@RAW@"', value[1:]) if raw else text, place, expectation)


# ---- not JSON -------------------------------------------------------------------------------------------------------
whole = json.dumps(good, indent=1)
write("empty", "", "empty.json", "expected")
write("truncated", whole[: len(whole) // 2], "truncated.json", "expected")
write("truncated-string", whole[: whole.index("Kanthal") + 3], "truncated-string.json", "expected")
write("not-json", "block: 300\n", "not-json.json", "expected")
write("comma", whole.replace('"bad",', '"bad"'), "comma.json", "line 4")
write("trailing", whole + "{}", "trailing.json", "expected")
write("double-key", whole.replace('"name": "bad"', '"name": "bad", "name": "worse"'), "double-key.json", "name")
write("not-utf8", whole.encode().replace(b"Kanthal", b"K\xffnthal"), "not-utf8.json", "0xff")
write("binary", bytes(range(256)), "binary.json", "expected")
write("list", "[1, 2, 3]", "list.json", "object")

# ---- numbers that are none ------------------------------------------------------------------------------------------
for name in ("NaN", "Infinity", "-Infinity", "1e400", "-1e400"):
    bad("heat-" + name, ["process", "heat_W_per_m"], "=" + name, f"heat-{name}.json", "expected")
    bad("mount-" + name, ["path", "mount_a_mm", 7, 1], "=" + name, f"mount-{name}.json", "expected")
bad("decimal-comma", ["process", "heat_W_per_m"], "=60,5", "decimal-comma.json", "expected")

# ---- wrong types, missing and unknown keys --------------------------------------------------------------------------
bad("no-format", ["format"], DELETE, "format", "wirecut-job/1")
bad("other-format", ["format"], "wirecut-job/9", "format", "wirecut-job/1")
bad("no-wire", ["wire"], DELETE, "wire", "expected")
bad("no-heat", ["process", "heat_W_per_m"], DELETE, "process.heat_W_per_m", "expected")
bad("text-heat", ["process", "heat_W_per_m"], "60", "process.heat_W_per_m", "number")
bad("null-block", ["block"], None, "block", "object")
bad("size-number", ["block", "size_mm"], 300, "block.size_mm", "[x, y, z]")
bad("size-of-two", ["block", "size_mm"], [300, 200], "block.size_mm", "[x, y, z]")
bad("nodes-real", ["wire", "nodes"], 21.5, "wire.nodes", "integer")
bad("nodes-text", ["wire", "nodes"], "many", "wire.nodes", "integer")
bad("nodes-true", ["wire", "nodes"], True, "wire.nodes", "integer")
bad("name-number", ["name"], 7, "name", "string")
bad("point-text", ["path", "mount_a_mm", 3], "here", "path.mount_a_mm[3]", "[x, y, z]")
bad("point-of-two", ["path", "mount_b_mm", 5], [1, 2], "path.mount_b_mm[5]", "[x, y, z]")
bad("point-null", ["path", "mount_b_mm", 5, 2], None, "path.mount_b_mm[5][2]", "number")
bad("unknown-wire", ["wire", "lenght_mm"], 400, "lenght_mm", "length_mm")
bad("unknown-process", ["process", "heat_W_per_mm"], 400, "heat_W_per_mm", "heat_W_per_m")
bad("unknown-top", ["blok"], {}, "blok", "block")
bad("unknown-far", ["colour"], "red", "colour", "expected")
bad("both-modes", ["design"], design["design"], "design", "path")
bad("no-mode", ["path"], DELETE, "path", "design")

# ---- numbers out of range -------------------------------------------------------------------------------------------
for value in (0, -1):
    bad(f"width{value}", ["block", "size_mm", 0], value, "block.size_mm[0]", "greater than 0")
    bad(f"height{value}", ["block", "size_mm", 2], value, "block.size_mm[2]", "greater than 0")
    bad(f"diameter{value}", ["wire", "diameter_mm"], value, "wire.diameter_mm", "greater than 0")
    bad(f"length{value}", ["wire", "length_mm"], value, "wire.length_mm", "greater than 0")
    bad(f"heat{value}", ["process", "heat_W_per_m"], value, "process.heat_W_per_m", "greater than 0")
    bad(f"tension{value}", ["process", "tension_N"], value, "process.tension_N", "greater than 0")
    bad(f"a{value}", ["process", "force_law", "a_N_per_mm"], value, "force_law.a_N_per_mm", "greater than 0")
    bad(f"b{value}", ["process", "force_law", "b_m2_per_J"], value, "force_law.b_m2_per_J", "greater than 0")
for value in (2, 1, 0, -3):
    bad(f"nodes{value}", ["wire", "nodes"], value, "wire.nodes", "3")
bad("nodes-huge", ["wire", "nodes"], 10**30, "nodes-huge.json", "expected")
bad("limits", ["limits"], {"speed_max_mm_s": 5.0, "speed_min_mm_s": 6.0}, "speed_min_mm_s", "less than")

# ---- geometry that cannot be cut ------------------------------------------------------------------------------------
bad("stations-unequal", ["path", "mount_b_mm"], good["path"]["mount_b_mm"][:-1], "path.mount_b_mm", "31 stations")
bad("one-station", ["path"], {"mount_a_mm": [[-50, 0, 50]], "mount_b_mm": [[350, 0, 50]]}, "mount_a_mm", "2")
bad("short-wire", ["wire", "length_mm"], 390.0, "station 0", "shorter than the distance of its ends (400 mm) by 10 mm")
bad("short-at-12", ["path", "mount_b_mm", 12, 0], 370.5, "station 12", "by 0.5 mm")
bad("no-contact", ["path"],
    {"mount_a_mm": [[-50, y, 500] for y in range(-10, 300, 10)],
     "mount_b_mm": [[350, y, 500] for y in range(-10, 300, 10)]}, "path", "no contact with the block")
bad("mount-in-block", ["path", "mount_a_mm"],
    [[-50 + 4 * j, 10 * j - 10, 50] for j in range(31)], "station 13: mount A", "inside the block")
bad("leap-through-block", ["path"],
    {"mount_a_mm": [[-50, -10, 50], [20, -10, 50], [20, 290, 50], [-50, 290, 50]],
     "mount_b_mm": [[350, -10, 50], [350, -5, 50], [350, 285, 50], [350, 290, 50]]},
    "station 2: mount A", "through the block")
bad("standing", ["path"],
    {"mount_a_mm": [[-50, 10, 50]] * 5, "mount_b_mm": [[350, 10, 50]] * 5}, "station 1", "moved")

# ---- design mode ----------------------------------------------------------------------------------------------------
bad("no-edge", ["design", "edge_b"], DELETE, "design.edge_b", "expected", design)
bad("edge-of-one", ["design", "edge_a", "points_mm"], [[0, 0, 50]], "design.edge_a.points_mm", "2", design)
bad("edge-twice", ["design", "edge_a", "points_mm", 1], [0, 0, 50], "design.edge_a", "coincide", design)
bad("few-stations", ["design", "stations"], 1, "design.stations", "2", design)
bad("extra-order", ["design", "extra_length_mm", 1, 0], 1.0, "design.extra_length_mm[2]", "increase", design)
bad("extra-negative", ["design", "extra_length_mm", 1, 1], -1.0, "design.extra_length_mm[1][1]", "at least 0", design)
bad("clearance", ["design", "clearance_mm"], -5.0, "design.clearance_mm", "at least 0", design)

with open(os.path.join(folder, "..", "good.json"), "w", encoding="utf-8") as file:
    json.dump(good, file)
with open(os.path.join(folder, "..", "good-design.json"), "w", encoding="utf-8") as file:
    json.dump(design, file)
