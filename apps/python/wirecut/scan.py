"""Clouds beside faces: read, register, measure."""
from __future__ import annotations

import html
import json
import os
import warnings
from typing import Any, Callable, Dict, Optional

import numpy as np

from ._core import (InputError, Progress, Reporter, as_points, check, ffi, fill, free_text, lib, new_error, path_of, points,
                    reals, text_of, threads_of, view)
from .geometry import Surface
from .history import History

_DEVIATION = np.dtype([("distance", "f8"), ("foot", "f8", 3), ("u", "f8"), ("v", "f8"), ("triangle", "i4"), ("place", "u4")])
assert _DEVIATION.itemsize == ffi.sizeof("wcut_deviation")


class Cloud:
    """Points of a scan."""

    def __init__(self, points_mm: Any, normals: Any = None) -> None:
        #: (n, 3) [mm]
        self.points_mm = points(points_mm, "points_mm")
        #: (n, 3), or None
        self.normals = None if normals is None else points(normals, "normals")

    @classmethod
    def read(cls, path: Any, unit: str = "mm") -> "Cloud":
        """A cloud file; unit: mm, cm, m or inch."""
        units = {"mm": lib.WCUT_LENGTH_UNIT_MM, "cm": lib.WCUT_LENGTH_UNIT_CM, "m": lib.WCUT_LENGTH_UNIT_M,
                 "inch": lib.WCUT_LENGTH_UNIT_INCH}
        if unit not in units:
            raise InputError(f"unit: found {unit!r}, expected mm, cm, m or inch")
        options = ffi.new("wcut_cloud_options *", lib.wcut_cloud_options_default())
        options.unit = units[unit]
        out, error = ffi.new("wcut_cloud **"), new_error()
        check(lib.wcut_cloud_read(path_of(path), options, out, error), error)
        handle = ffi.gc(out[0], lib.wcut_cloud_destroy)
        normals = view(handle, handle.normal, (handle.count, 3)) if handle.normal else None
        return cls(view(handle, handle.point, (handle.count, 3)), normals)

    def __len__(self) -> int:
        return len(self.points_mm)

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        return np.array(self.points_mm, dtype)

    def __repr__(self) -> str:
        return f"<Cloud of {len(self)} points>"


class Deviation:
    """A scan beside a face: every point, and what deviation.json says of them."""

    def __init__(self, handle: Any, held: Any, document: Dict[str, Any]) -> None:
        self._handle, self._held = handle, held
        page = handle.page
        #: what deviation.json holds: figures, bands, zones, worst areas, registration, datums
        self.document = document
        #: (n) [mm] signed: positive where material was left; NaN where a point does not count
        self.distance_mm = view(handle, page.deviation, (page.points,))
        #: (n, 3) [mm] the points as registered
        self.points_mm = view(handle, page.point, (page.points, 3))
        #: (n, 3) [mm] closest points of the face
        rows = view(handle, handle.row, (page.points,), _DEVIATION).view(_DEVIATION)
        self.foot_mm = rows["foot"]
        #: (n) "inside", "border", "beyond", "ambiguous"
        self.place = np.array([text_of(lib.wcut_place_name(k)) for k in range(lib.WCUT_PLACE_COUNT)])[rows["place"]]
        #: (4, 4) scan to block frame
        self.matrix = np.array(list(handle.compared.registration.matrix)).reshape(4, 4)
        #: whether as much as the gate asks is within the tolerance; True without a gate
        self.within = bool(handle.compared.within)
        #: whether the registration converged; True without one
        self.converged = bool(handle.compared.registration.converged) or self.matrix.tolist() == np.eye(4).tolist()

    @property
    def statistics(self) -> Dict[str, float]:
        """Figures of the points that count, in mm: mean, std, rms, mae, median, p01, p05, p95, p99, min, max, count."""
        result = self._handle.compared.found.statistics
        return {name: getattr(result, name)
                for name in ("count", "mean", "std", "rms", "mae", "median", "p01", "p05", "p95", "p99", "min", "max")}

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        return np.array(self.distance_mm, dtype)

    def __repr__(self) -> str:
        s = self.statistics
        return f"<Deviation of {s['count']} points: mean {s['mean']:+.4g}, rms {s['rms']:.4g} mm>"

    def _repr_html_(self) -> str:
        body = "".join(f"<tr><th style='text-align:left'>{html.escape(k)}</th><td>{v:.4g}</td></tr>"
                       for k, v in self.statistics.items())
        return f"<table><caption>deviation, mm</caption>{body}</table>"


def _reference_of(reference: Any, held: list) -> Any:
    """The C reference of a history, a surface, a mesh or a file."""
    out = ffi.new("wcut_compare_reference *")
    if isinstance(reference, History):
        out.setup, out.history = reference._setup, reference._handle
    elif isinstance(reference, Surface):
        out.surface = reference._handle
    elif isinstance(reference, (str, os.PathLike)):
        held.append(ffi.new("char[]", path_of(reference)))
        out.path = held[-1]
    else:
        raise InputError(f"reference: found {type(reference).__name__}, expected a History, a Surface or a file's name")
    held.append(reference)
    return out


def _scans_of(scan: Any, held: list) -> Any:
    """The C scans of a cloud, points, a file, or a list of files."""
    if isinstance(scan, (str, os.PathLike)):
        scan = [scan]
    if isinstance(scan, (list, tuple)) and scan and all(isinstance(s, (str, os.PathLike)) for s in scan):
        out = ffi.new("wcut_compare_scan[]", len(scan))
        for k, name in enumerate(scan):
            held.append(ffi.new("char[]", path_of(name)))
            out[k].path = held[-1]
        return out
    array = points(scan.points_mm if isinstance(scan, Cloud) else scan, "scan")
    if not len(array):
        raise InputError("scan: found no point, expected some")
    held.append(array)
    out = ffi.new("wcut_compare_scan[]", 1)
    out[0].count, out[0].point = len(array), as_points(array)
    return out


_METHOD = {"none": "WCUT_REGISTRATION_METHOD_NONE", "datum": "WCUT_REGISTRATION_METHOD_DATUM",
           "fit": "WCUT_REGISTRATION_METHOD_FIT"}
_DISTANCE = {"surface": "WCUT_COMPARE_DISTANCE_SURFACE", "mesh": "WCUT_COMPARE_DISTANCE_MESH",
             "reconstruction": "WCUT_COMPARE_DISTANCE_RECONSTRUCTION"}


def _word(words: Dict[str, str], value: Any, name: str) -> int:
    if value not in words:
        raise InputError(f"{name}: found {value!r}, expected one of {', '.join(words)}")
    return int(getattr(lib, words[value]))


def _options_of(values: Dict[str, Any], registers: bool, held: list) -> Any:
    """The C options from keywords: members of wcut_compare_options, and of wcut_registration_options where there is one."""
    out = ffi.new("wcut_compare_options *", lib.wcut_compare_options_default())
    own = {name for name, _ in ffi.typeof("wcut_compare_options").fields} - {"clean", "registration", "method", "bands", "feet"}
    motion = {k: v for k, v in values.items() if k not in own}
    for name, value in values.items():
        if name in motion:
            continue
        if name == "band":
            tolerances = reals(value, "band")
            if len(tolerances) >= lib.WCUT_BANDS_MAX:
                raise InputError(f"band: found {len(tolerances)} tolerances, expected at most {lib.WCUT_BANDS_MAX - 1}")
            out.bands, out.band[0:len(tolerances)] = len(tolerances), list(tolerances)
        elif isinstance(value, (str, os.PathLike)):
            held.append(ffi.new("char[]", path_of(value)))
            fill(out, {name: held[-1]}, "compare")
        else:
            fill(out, {name: value}, "compare")
    if motion and not registers:
        raise InputError(f"compare: found the option {sorted(motion)[0]!r}, which is for a registration, or for none of both")
    fill(ffi.addressof(out, "registration"), motion, "compare")
    return out


def compare(reference: "History | Surface | str | os.PathLike", scan: Any, *, register: str = "none",
            distance: str = "surface", datums: Any = None, output: Any = None, warn: Optional[Callable[[str], Any]] = None,
            progress: Optional[Progress] = None, threads: Optional[int] = None, clean: Optional[Dict[str, Any]] = None,
            **options: Any) -> Deviation:
    """A scan beside a face: registration, every point's deviation, figures, zones, worst areas.

    reference: a History (the face is half a kerf below the wire, inside the block), a Surface, or the file of a job or a
    mesh. scan: a Cloud, points (n, 3), a cloud file, or a list of them. register: "none", "datum" (by the file `datums`) or
    "fit"; a best fit hides deviations that look like a motion. output: a folder for the files of `wirecut compare`.
    warn: called with each doubt; None: Python's warnings. clean: members of wcut_clean_options. Further options: members
    of wcut_compare_options, such as tolerance=, share=, reconstruct=, and of wcut_registration_options, such as noise=."""
    held: list = []
    c_reference, c_scan = _reference_of(reference, held), _scans_of(scan, held)
    c_options = _options_of(options, register != "none", held)
    c_options.method, c_options.distance = _word(_METHOD, register, "register"), _word(_DISTANCE, distance, "distance")
    c_options.feet, c_options.threads = True, threads_of(threads)
    if clean is not None:
        fill(ffi.addressof(c_options, "clean"), clean, "clean")
    if datums is not None:
        held.append(ffi.new("char[]", path_of(datums)))
        c_options.datums = held[-1]
    if len(c_scan) == 1 and not c_scan[0].path and c_options.hold == 0:
        c_options.hold = max(c_scan[0].count, 500000)  # points in memory are all kept

    # who watches
    reporter = Reporter(progress)
    say = warn if warn is not None else (lambda text: warnings.warn(text, stacklevel=3))

    def failed(_kind: Any, value: BaseException, _trace: Any) -> None:
        reporter.cause = value  # raised when the call has ended

    step = ffi.callback("int(wcut_compare_stage, int, int, void *)",
                        lambda _stage, done, total, context: reporter.function(done, total, context), error=1, onerror=failed)
    tell = ffi.callback("void(char *, void *)", lambda text, _context: say(text_of(text)), onerror=failed)
    watch = ffi.new("wcut_compare_watch *", {"progress": step, "warn": ffi.cast("void(*)(const char *, void *)", tell)})

    # the set of files, if one is wanted
    error, results = new_error(), ffi.NULL
    if output is not None:
        names, made = ffi.new("char *[]", lib.WCUT_COMPARE_FILES_MAX), ffi.new("wcut_results **")
        count = lib.wcut_compare_files(ffi.NULL, names)
        check(lib.wcut_results_create(path_of(output), count, names, made, error), error)
        results = ffi.gc(made[0], lib.wcut_results_destroy)

    out = ffi.new("wcut_compare_result **")
    status = lib.wcut_compare_run(c_reference, len(c_scan), c_scan, c_options, results, watch, out, error)
    reporter.check()
    check(status, error)
    handle = ffi.gc(out[0], lib.wcut_compare_destroy)
    text = ffi.new("char **")
    if output is not None:
        check(lib.wcut_compare_write(handle, results, text, error), error)
    else:
        check(lib.wcut_deviation_print(ffi.addressof(handle.compared), text))
    document = json.loads(text_of(text[0]))
    free_text(text[0])
    return Deviation(handle, held, document)
