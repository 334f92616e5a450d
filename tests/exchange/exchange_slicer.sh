# PrusaSlicer finds both halves manifold, of one part and of our size and volume: STL, OBJ and 3MF with its unit.
# labels: exchange slow
. "$SOURCE_DIR/tests/exchange/exchange.sh"
need prusa-slicer prusa-slicer
for file in lower.stl upper.stl lower.obj upper.obj mould.3mf; do
    prusa-slicer --info "$file" >"$file.log" 2>&1 || { cat "$file.log"; exit 1; }
done
/usr/bin/python3 - <<'PYTHON'
import json
given = json.load(open("given.json"))


def parts(name):
    found = []
    for line in open(name + ".log"):
        if line.startswith("[" + name + "]"):
            found.append({})
        elif " = " in line and found:
            key, value = line.split(" = ")
            found[-1][key.strip()] = value.strip()
    return found


for name, halves in (("lower.stl", ["lower"]), ("upper.stl", ["upper"]), ("lower.obj", ["lower"]),
                     ("upper.obj", ["upper"]), ("mould.3mf", ["lower", "upper"])):
    found = parts(name)
    assert len(found) == len(halves), (name, found)
    for half, part in zip(halves, found):
        print(name, half, part)
        assert part["manifold"] == "yes" and part["number_of_parts"] == "1", (name, half)
        assert int(part["number_of_facets"]) == given[half]["triangles"]
        assert not any("repair" in key or "fixed" in key for key in part), (name, part)
        assert abs(float(part["volume"]) / given[half]["volume"] - 1) < 1e-5
        for k, axis in enumerate("xyz"):
            assert abs(float(part["min_" + axis]) - given[half]["low"][k]) < 1e-4
            assert abs(float(part["max_" + axis]) - given[half]["high"][k]) < 1e-4
PYTHON
