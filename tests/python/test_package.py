"""The Python package: every noun once, wrong input by name, views that outlive their owner, threads and Ctrl-C."""
import gc
import json
import os
import pickle
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import unittest
import zlib

import numpy as np

import wirecut

SAMPLES = os.path.join(os.environ["SOURCE_DIR"], "samples")


def planar_job(stations=41, nodes=31, **further):
    """A straight cut through 300 mm of foam."""
    y = np.linspace(-20, 320, stations)
    z = np.full(stations, 100.0)
    a = np.column_stack([np.full(stations, -60.0), y, z])
    b = np.column_stack([np.full(stations, 360.0), y, z])
    return wirecut.Job.from_path("planar", [300, 300, 200], a, b, 445.0, 60.0, 2.0, 0.02, 1.2e-3, nodes=nodes, **further)


class Jobs(unittest.TestCase):
    def test_a_job_survives_file_dictionary_and_pickle(self):
        job = wirecut.Job.read(os.path.join(SAMPLES, "jobs", "freeform-4.json"))
        again = wirecut.Job.from_dict(job.to_dict())
        self.assertEqual(again.to_dict(), job.to_dict())
        self.assertEqual(pickle.loads(pickle.dumps(job)).to_dict(), job.to_dict())
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "job.json")
            job.write(path)
            self.assertEqual(wirecut.Job.read(path).to_dict(), job.to_dict())

    def test_attributes_are_the_job_file_s_numbers(self):
        job = planar_job()
        job.heat_W_per_m = 55
        job.a_N_per_mm = 0.015
        job.block_size_mm = (300, 310, 200)
        document = job.to_dict()
        self.assertEqual(document["process"]["heat_W_per_m"], 55)
        self.assertEqual(document["process"]["force_law"]["a_N_per_mm"], 0.015)
        self.assertEqual(document["block"]["size_mm"], [300, 310, 200])
        self.assertEqual(job.mount_a_mm.shape, (41, 3))
        job.mount_a_mm = job.mount_a_mm + [0, 0, 5]
        self.assertTrue(np.all(job.mount_a_mm[:, 2] == 105))
        job.stations = 81
        self.assertEqual(job.mount_a_mm.shape, (81, 3))

    def test_what_is_wrong_is_named(self):
        with self.assertRaisesRegex(wirecut.InputError, r"no-such-job.json: .*No such file") as caught:
            wirecut.Job.read("no-such-job.json")
        self.assertEqual(caught.exception.status, "WCUT_NOT_FOUND")
        document = planar_job().to_dict()
        document["process"]["heat_W_per_metre"] = 60
        with self.assertRaisesRegex(wirecut.InputError, r"process.*heat_W_per_metre"):
            wirecut.Job.from_dict(document)
        job = planar_job()
        with self.assertRaisesRegex(wirecut.InputError, "nodes: found 2.5"):
            job.nodes = 2.5
        with self.assertRaisesRegex(wirecut.InputError, "found 7 stations, expected 41"):
            job.mount_a_mm = np.zeros((7, 3))
        with self.assertRaisesRegex(wirecut.InputError, "found str, expected a Job"):
            wirecut.simulate("job.json")
        with self.assertRaisesRegex(wirecut.InputError, "'tolerence'.*did you mean tolerance"):
            wirecut.simulate(job, tolerence=1e-9)


class Simulations(unittest.TestCase):
    def test_a_steady_cut_is_the_parabola_of_the_closed_form(self):
        # w = 300, wire 445 less 2 x 60 mm of free ends; checked by its own force balance: k sin(alpha) = F w / 2
        history = wirecut.simulate(planar_job(81, 61))
        middle = np.flatnonzero(history.phase == "steady")
        self.assertGreater(len(middle), 5)
        k = middle[len(middle) // 2]
        force = history.force_N[k, :, 1].sum()
        pull = 2 * 2.0 * np.sin(np.radians(history.angles_deg[k, 0]))
        self.assertAlmostEqual(abs(force) / pull, 1, delta=1e-6)

    def test_shapes_and_views(self):
        history = wirecut.simulate(planar_job())
        m, n = history.stations, history.nodes
        self.assertEqual(history.position_mm.shape, (m, n, 3))
        self.assertEqual(history.tension_N.shape, (m, n - 1))
        self.assertEqual(history.time_s.shape, (m,))
        self.assertFalse(history.position_mm.flags.writeable)
        self.assertFalse(history.position_mm.flags.owndata)
        self.assertEqual(np.asarray(history).shape, (m, n, 3))
        self.assertIn("planar", history._repr_html_())

    def test_a_view_outlives_its_history(self):
        history = wirecut.simulate(planar_job())
        kept = history.position_mm
        before = kept.copy()
        del history
        gc.collect()
        others = [wirecut.simulate(planar_job()) for _ in range(3)]
        self.assertTrue(np.array_equal(kept, before))
        self.assertEqual(len(others), 3)

    def test_progress_stops_and_exceptions_come_through(self):
        seen = []
        with self.assertRaises(KeyboardInterrupt) as caught:
            wirecut.simulate(planar_job(), progress=lambda done, total: seen.append(done) or done >= 5)
        self.assertIsInstance(caught.exception.partial, wirecut.History)
        self.assertGreaterEqual(caught.exception.partial.stations, 5)

        def fail(done, total):
            raise ValueError("of the caller")

        with self.assertRaisesRegex(ValueError, "of the caller"):
            wirecut.simulate(planar_job(), progress=fail)

    def test_four_threads_give_what_one_gives(self):
        alone = wirecut.simulate(planar_job()).position_mm
        found = [None] * 4

        def run(k):
            found[k] = wirecut.simulate(planar_job()).position_mm.copy()

        threads = [threading.Thread(target=run, args=(k,)) for k in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for array in found:
            self.assertTrue(np.array_equal(array, alone))

    def test_ctrl_c_ends_a_long_call(self):
        code = ("import os, signal, threading, wirecut, sys\n"
                "sys.path.insert(0, os.environ['SOURCE_DIR'] + '/tests/python')\n"
                "from test_package import planar_job\n"
                "threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()\n"
                "try:\n    wirecut.simulate(planar_job(100000, 301))\nexcept KeyboardInterrupt:\n    print('interrupted')\n")
        result = subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True, timeout=120)
        self.assertEqual(result.stdout.strip(), "interrupted")


class Geometry(unittest.TestCase):
    def setUp(self):
        x, y = np.meshgrid(np.linspace(0, 100, 21), np.linspace(0, 200, 31))
        self.surface = wirecut.Surface.loft(np.dstack([x, y, 10 * np.sin(x / 30) * np.cos(y / 40)]))

    def test_points_on_the_surface_are_their_own_feet(self):
        grid = self.surface.evaluate(np.linspace(0.1, 0.9, 5), np.linspace(0.1, 0.9, 7)).reshape(-1, 3)
        feet = self.surface.closest(grid, threads=1)
        self.assertLess(feet.distance_mm.max(), 1e-9)
        self.assertFalse(feet.beyond.any())

    def test_any_format_and_order_of_numbers_is_taken(self):
        base = np.ascontiguousarray(self.surface.evaluate([0.25, 0.5], [0.25, 0.75]).reshape(-1, 3) + [0, 0, 1])
        expected = self.surface.closest(base, threads=1).distance_mm
        for array in (np.asfortranarray(base), base[::-1][::-1], base.tolist(), np.repeat(base, 2, axis=0)[::2]):
            self.assertTrue(np.array_equal(self.surface.closest(array, threads=1).distance_mm, expected))
        self.assertTrue(np.allclose(self.surface.closest(base.astype(np.float32), threads=1).distance_mm, expected, atol=1e-4))

    def test_wrong_shapes_and_types_are_refused_by_name(self):
        for value, text in ((np.zeros((4, 2)), r"points_mm: found the shape \(4, 2\)"), (np.zeros(3), "of 1 dimensions"),
                            ("points", "points_mm"), ([[1, 2], [3]], "points_mm"), (np.zeros((2, 3), complex), "expected numbers"),
                            (None, "expected numbers")):
            with self.assertRaisesRegex(wirecut.InputError, text):
                self.surface.closest(value)
        with self.assertRaises(wirecut.InputError):
            self.surface.closest([[np.nan, 0, 0]])
        with self.assertRaisesRegex(wirecut.InputError, "threads: found 0"):
            self.surface.closest([[0, 0, 0]], threads=0)
        with self.assertRaisesRegex(wirecut.InputError, "triangles"):
            wirecut.Mesh.create(np.zeros((3, 3)), [[0, 1, 3]])

    def test_mesh_files_and_step_come_back(self):
        mesh = self.surface.tessellate(0.5)
        with tempfile.TemporaryDirectory() as folder:
            for ending in ("stl", "obj", "ply"):
                path = os.path.join(folder, "a." + ending)
                mesh.write(path)
                self.assertEqual(len(wirecut.Mesh.read(path).triangles), len(mesh.triangles))
            curve = wirecut.Curve.interpolate([[0, 0, 0], [1, 2, 0], [3, 3, 1], [5, 1, 2]])
            wirecut.write_shapes([self.surface, curve], os.path.join(folder, "a.step"))
            back = wirecut.Curve.read(os.path.join(folder, "a.step"))
            self.assertEqual(len(back), 1)
            self.assertTrue(np.array_equal(back[0].control_mm, curve.control_mm))
            with self.assertRaisesRegex(wirecut.InputError, "expected a name that ends in"):
                mesh.write(os.path.join(folder, "a.xyz"))
            with self.assertRaises(wirecut.OutputError):
                mesh.write(os.path.join(folder, "nowhere", "a.stl"))

    def test_compas_data_comes_back_unchanged(self):
        curve = wirecut.Curve.interpolate([[0, 0, 0], [1, 2, 0], [3, 3, 1], [5, 1, 2], [6, 0, 0]])
        for shape in (self.surface, curve, self.surface.tessellate(1.0)):
            document = json.loads(json.dumps(wirecut.to_compas(shape)))
            back = wirecut.from_compas(document)
            self.assertTrue(np.array_equal(np.asarray(back), np.asarray(shape)))
            self.assertEqual(wirecut.to_compas(back), wirecut.to_compas(shape))
        with self.assertRaises(wirecut.InputError):
            wirecut.from_compas({"dtype": "compas.geometry/Box", "data": {}})

    def test_halves_make_the_block(self):
        job = wirecut.Job.read(os.path.join(SAMPLES, "jobs", "freeform-4.json"))
        mould = wirecut.mould(wirecut.simulate(job).surface(), job.block_size_mm, prolong=60)
        self.assertTrue(mould.lower.closed and mould.upper.closed)
        total = mould.lower.volume_mm3 + mould.upper.volume_mm3 + mould.kerf_volume_mm3
        self.assertAlmostEqual(total / np.prod(job.block_size_mm), 1, delta=1e-9)
        self.assertAlmostEqual(mould.lower.mesh.volume_mm3 / mould.lower.volume_mm3, 1, delta=1e-9)


def chunk(kind, data):
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def write_grey(path, grey):
    """An 8 bit grey PNG of an array (rows, columns)."""
    head = struct.pack(">IIBBBBB", grey.shape[1], grey.shape[0], 8, 0, 0, 0, 0)
    rows = b"".join(b"\0" + row.tobytes() for row in grey.astype(np.uint8))
    with open(path, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


class Photographs(unittest.TestCase):
    def test_a_camera_above_a_flat_face_reads_no_rills_of_an_even_picture(self):
        history = wirecut.simulate(planar_job())

        # 800 mm above the middle, looking down: u along x, v against y
        places = np.array([[x, y, z] for z in (100, 160) for x in (0, 300) for y in (0, 300)], float)
        depth = 900 - places[:, 2]
        u = 319.5 + 700 * (places[:, 0] - 150) / depth
        v = 239.5 - 700 * (places[:, 1] - 150) / depth
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "photo.png")
            write_grey(path, np.full((480, 640), 128))
            seen = wirecut.overlay(history, path, np.column_stack([u, v, places]), patch=60, curves=2)
            self.assertEqual(seen.camera, "full")
            self.assertAlmostEqual(seen.focal_px, 700, delta=0.1)
            self.assertLess(seen.reprojection_rms_px, 0.01)
            self.assertGreater(seen.covered_share, 0.99)
            self.assertEqual(seen.rectified.shape[2], 4)
            self.assertFalse(seen.readable.any())
            self.assertTrue(np.isnan(seen.angle_deg).all() and seen.angle_deg.shape == (5, 5))
            seen.write_rills(os.path.join(folder, "rills.csv"))
            with open(os.path.join(folder, "rills.csv")) as lines:
                self.assertIn(len(lines.readlines()), range(2, 27))
            with self.assertRaises(wirecut.InputError):
                wirecut.overlay(history, path, places)
            with self.assertRaises(wirecut.InputError):
                wirecut.overlay(history, os.path.join(folder, "none.png"), np.column_stack([u, v, places]))


class Measurements(unittest.TestCase):
    def test_a_scan_beside_its_simulation(self):
        job = wirecut.Job.read(os.path.join(SAMPLES, "jobs", "freeform-4.json"))
        history = wirecut.simulate(job)
        cloud = wirecut.Cloud.read(os.path.join(SAMPLES, "scans", "freeform-4.ply"))
        deviation = wirecut.compare(history, cloud, threads=1)
        self.assertEqual(len(deviation.distance_mm), len(cloud))
        self.assertLess(deviation.statistics["rms"], 2)
        moved = wirecut.compare(history.surface(), history.position_mm[20:60, 10:-10].reshape(-1, 3) + [0, 0, 0.25], threads=1)
        self.assertAlmostEqual(np.nanmean(moved.distance_mm), 0.25, delta=0.08)
        with self.assertRaisesRegex(wirecut.InputError, "register: found 'best'"):
            wirecut.compare(history, cloud, register="best")
        with self.assertRaisesRegex(wirecut.InputError, "'noise', which is for a registration"):
            wirecut.compare(history, cloud, noise=0.1)
        with self.assertRaisesRegex(wirecut.InputError, "share: found 2, expected 0 to 1"):
            wirecut.compare(history, cloud, share=2)
        with self.assertRaisesRegex(wirecut.InputError, "datums: expected a file and the method datum together"):
            wirecut.compare(history, cloud, register="datum")

    def test_a_comparison_is_that_of_the_command(self):
        job = os.path.join(SAMPLES, "jobs", "freeform-4.json")
        scan = os.path.join(SAMPLES, "scans", "freeform-4.ply")
        with tempfile.TemporaryDirectory() as folder:
            whole = wirecut.compare(job, scan, register="fit", tolerance=0.5, share=0.5, band=[0.1, 2], threads=2,
                                    output=folder)
            files = sorted(os.listdir(folder))
            self.assertEqual(sorted(whole.document["files"]), files)
            with open(os.path.join(folder, "deviation.json"), encoding="utf-8") as file:
                self.assertEqual(json.load(file), whole.document)
        history = wirecut.simulate(wirecut.Job.read(job))
        points = wirecut.Cloud.read(scan).points_mm
        same = wirecut.compare(history, points, register="fit", tolerance=0.5, share=0.5, band=[0.1, 2])
        self.assertEqual(same.statistics, whole.statistics)
        self.assertTrue(np.array_equal(same.distance_mm, whole.distance_mm, equal_nan=True))
        self.assertTrue(np.array_equal(same.matrix, whole.matrix))
        self.assertEqual(same.within, whole.within)
        self.assertEqual(same.document["registration"], whole.document["registration"])
        self.assertEqual(same.document["zones"], whole.document["zones"])

    def test_a_comparison_is_watched_and_warns(self):
        history = wirecut.simulate(wirecut.Job.read(os.path.join(SAMPLES, "jobs", "steady-400-60.json")))
        points = history.position_mm[20:60, 10:-10].reshape(-1, 3)
        seen, said = [], []
        wirecut.compare(history, points, progress=lambda done, total: seen.append((done, total)) and None, warn=said.append)
        self.assertEqual(seen[0], (len(points), 0))
        self.assertEqual(seen[-1], (len(points) - 1, len(points)))
        self.assertEqual(said, [])
        with self.assertRaises(KeyboardInterrupt):
            wirecut.compare(history, points, progress=lambda done, total: True)
        with self.assertRaisesRegex(wirecut.InputError, "none of them over the face"):
            wirecut.compare(history, points * 1000 + 5000, warn=said.append)
        self.assertEqual(len(said), 1)
        self.assertRegex(said[0], "times as large as the face")

        def stop(text):
            raise RuntimeError(text)
        with self.assertRaisesRegex(RuntimeError, "times as large"):
            wirecut.compare(history, points * 1000 + 5000, warn=stop)

    def test_a_table_gives_a_law(self):
        law = wirecut.calibrate(os.path.join(SAMPLES, "calibration", "table.csv"))
        self.assertTrue(law.a_interval[0] < law.a_N_per_mm < law.a_interval[1])

    def test_recordings_and_scores(self):
        folder = os.path.join(SAMPLES, "concealed", "one", "cut-1")
        recording = wirecut.Recording.read(os.path.join(folder, "recording.csv"))
        self.assertEqual(len(recording["time_s"]), len(recording))
        with self.assertRaisesRegex(KeyError, "expected one of"):
            recording["temperature"]
        scores = wirecut.score(wirecut.Job.read(os.path.join(folder, "job.json")), recording)
        self.assertIn("tension", scores["replayed"])
        self.assertGreater(scores["replayed"]["tension"].samples, 10)

    def test_a_controller_runs_at_the_plan_s_pace(self):
        history = wirecut.simulate(planar_job())
        controller = wirecut.Controller(history)
        speeds = [controller.step(0.01 * k, 0.0, 0.0, 0.0) for k in range(20)]
        self.assertEqual(controller.state, "run")
        self.assertTrue(all(b >= a for a, b in zip(speeds, speeds[1:])))
        motion = wirecut.robot_motion(history)
        self.assertEqual(motion.positions_mm()[0].shape, (len(motion), 3))
        with tempfile.TemporaryDirectory() as folder:
            motion.write(os.path.join(folder, "a.script"), "urscript")
            with self.assertRaisesRegex(wirecut.InputError, "format: found 'gcode'"):
                motion.write(os.path.join(folder, "a.g"), "gcode")

    def test_a_diagnosis_can_be_stopped(self):
        with self.assertRaises(KeyboardInterrupt):
            wirecut.diagnose(os.path.join(SAMPLES, "concealed", "one", "case.json"), progress=lambda done, total: True, threads=1)
        with self.assertRaisesRegex(wirecut.InputError, "no-case.json"):
            wirecut.diagnose("no-case.json")


if __name__ == "__main__":
    unittest.main()
