# What help calls the default of a number is the default of the library's own options.
set -eu
export PYTHONPATH="$SOURCE_DIR/apps/python" LD_LIBRARY_PATH="$BUILD_DIR" PYTHONDONTWRITEBYTECODE=1
python=/usr/bin/python3
if ! "$python" -c 'import numpy, cffi'; then
    echo "skipped: $python has no numpy or no cffi (python3-numpy, python3-cffi)"
    exit 77
fi
"$BUILD_DIR/wirecut" --json-usage >usage.json
"$python" - <<'END'
import json
import math
import re

from wirecut._core import ffi, lib

job = ffi.new("wcut_job *")
mould, robot, names = lib.wcut_mould_default(), lib.wcut_robot_options_default(), lib.wcut_robot_names_default()
limits, score = lib.wcut_robot_limits_default(job), lib.wcut_comparison_options_default()
compare, cut, mesh = lib.wcut_compare_options_default(), lib.wcut_cut_options_default(), lib.wcut_mesh_read_options_default()
calibration = lib.wcut_calibration_options_default()
control, rig = lib.wcut_control_settings_default(job), lib.wcut_rig_options_default(job)
expected = {
    "simulate": {"chord-tolerance": mould.chord_tolerance},
    "mould": {"chord-tolerance": mould.chord_tolerance, "fit-tolerance": mould.fit_tolerance, "scale": mould.scale,
              "minimum-wall": mould.wall_asked, "prolong": mould.prolong},
    "path": {"chord-tolerance": robot.chord_tolerance, "time-tolerance": robot.time_tolerance,
             "lead-in": robot.lead_in, "lead-out": robot.lead_out, "zone": robot.zone, "sync-io": names.sync_io,
             "acceleration": limits.acceleration, "alpha": math.degrees(limits.alpha),
             "beta": math.degrees(limits.beta), "preheat": names.preheat},
    "compare": {"share": 100 * compare.share, "chord-tolerance": compare.chord_tolerance},
    "control": {"gain": control.gain, "integral": control.rate, "filter": control.filter,
                "acceleration": control.acceleration, "period": rig.period, "seed": rig.seed},
    "score": {"window": score.replay.window, "settle": score.settle, "leave": score.leave},
    "diagnose": {"seed": lib.wcut_diagnosis_options_default().seed},
}
usage = {verb["name"]: {option["name"]: option for option in verb["options"]}
         for verb in json.load(open("usage.json"))["verbs"]}
for verb, options in expected.items():
    for name, value in options.items():
        found = usage[verb][name]["default"]
        assert found is not None, (verb, name)
        assert math.isclose(float(found), value, rel_tol=1e-11), (verb, name, found, value)

# words: of a choice the one at the library's place, and texts as they are
place = {
    "simulate": {"integrator": cut.integrator},
    "mould": {"stock-unit": mesh.unit, "keys": int(mould.key_count > 0)},
    "path": {"tool-frame": robot.frame},
    "score": {"motion": score.replay.motion},
    "calibrate": {"noise": calibration.noise},
    "compare": {"unit": compare.unit, "register": compare.method, "distance": compare.distance,
                "reconstruct": int(compare.reconstruct)},
}
text = {
    "path": {"wire-on": ffi.string(names.wire_on).decode(), "wire-off": ffi.string(names.wire_off).decode()},
    "compare": {"bands": ",".join(f"{compare.band[k]:g}" for k in range(compare.bands))},
    "mould": {"pull": f"{mould.pull.x:g},{mould.pull.y:g},{mould.pull.z:g}"},
}
for verb, options in place.items():
    for name, at in options.items():
        option = usage[verb][name]
        assert option["default"] == option["value"].split("|")[at], (verb, name, option["default"], at)
for verb, options in text.items():
    for name, words in options.items():
        assert usage[verb][name]["default"] == words, (verb, name, usage[verb][name]["default"], words)

# what no option struct holds, since it depends on the job or on the scan, stands in the sentence: the numbers are the library's
job.tension = 2
control = lib.wcut_control_settings_default(job)
sentence = {
    ("control", "tension-stop"): [control.tension_stop / job.tension],
    ("control", "disturb"): [rig.law_a, rig.delay, rig.noise_tension, math.degrees(rig.noise_angle), rig.noise_speed,
                             rig.noise_position],
}
for (verb, name), numbers in sentence.items():
    told = [float(n) for n in re.findall(r"[0-9]+(?:\.[0-9]+)?", usage[verb][name]["help"])]
    for number in numbers:
        assert any(math.isclose(number, t) for t in told), (verb, name, number, told)

# a default that the table knows is not told a second time by the sentence
for verb, options in usage.items():
    for name, option in options.items():
        told = re.search(r"default [0-9]", option["help"])
        assert not (option["default"] and told), (verb, name, option["help"])
END
