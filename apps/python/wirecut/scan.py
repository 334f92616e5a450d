"""Clouds beside faces: read, register, measure."""
from __future__ import annotations

import html
from typing import Any, Dict, Optional

import numpy as np

from ._core import (InputError, as_points, as_reals, check, ffi, fill, lib, new_error, path_of, points, text_of, threads_of,
                    view)
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
    """Deviations of a cloud from a face, point by point, and their figures."""

    def __init__(self, rows: np.ndarray, moved_mm: np.ndarray, matrix: np.ndarray) -> None:
        #: (n) [mm] signed: positive where material was left; NaN where a point does not count
        self.distance_mm = np.where(rows["place"] <= lib.WCUT_PLACE_BORDER, rows["distance"], np.nan)
        #: (n, 3) [mm] closest points of the face
        self.foot_mm = rows["foot"]
        #: (n) "inside", "border", "beyond", "ambiguous"
        self.place = np.array([text_of(lib.wcut_place_name(k)) for k in range(lib.WCUT_PLACE_COUNT)])[rows["place"]]
        #: (n, 3) [mm] the points as registered
        self.points_mm = moved_mm
        #: (4, 4) scan to block frame
        self.matrix = matrix

    @property
    def statistics(self) -> Dict[str, float]:
        """Figures of the points that count, in mm: mean, std, rms, mae, median, p01, p05, p95, p99, min, max, count."""
        values = np.ascontiguousarray(self.distance_mm[~np.isnan(self.distance_mm)])
        if not len(values):
            raise InputError("deviation: found no point over the face, expected some: another unit, or register='fit'?")
        out, result = ffi.new("wcut_histogram **"), ffi.new("wcut_statistics *")
        check(lib.wcut_histogram_create(0, ffi.NULL, out))
        histogram = ffi.gc(out[0], lib.wcut_histogram_destroy)
        check(lib.wcut_histogram_add(histogram, len(values), as_reals(values)))
        check(lib.wcut_histogram_eval(histogram, result))
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


def compare(reference: "History | Surface", cloud: Any, *, register: str = "none", threads: Optional[int] = None,
            **registration: Any) -> Deviation:
    """Deviations of a cloud, or of points (n, 3), from the cut face of a history (half a kerf below the wire, inside the
    block), or from a surface. register: "none" or "fit"; a best fit hides deviations that look like a motion.
    `registration`: options of wcut_registration_options, such as noise= and keep=."""
    array = points(cloud.points_mm if isinstance(cloud, Cloud) else cloud, "cloud")
    options = ffi.new("wcut_deviation_options *", lib.wcut_deviation_options_default())
    held = []
    if isinstance(reference, History):
        a, b, _ = reference.mounts_mm()
        out = ffi.new("wcut_face **")
        check(lib.wcut_face_create(reference._job._handle, reference._handle, as_points(a), as_points(b), 1e-3, out), None,
              "reference")
        face = ffi.gc(out[0], lib.wcut_face_destroy)
        held.append(face)
        surface, options.low, options.high = face.surface, face.low, face.high
    elif isinstance(reference, Surface):
        surface = reference._handle
    else:
        raise InputError(f"reference: found {type(reference).__name__}, expected a History or a Surface")
    projection_out = ffi.new("wcut_projection **")
    check(lib.wcut_projection_create(surface, projection_out), None, "reference")
    projection = ffi.gc(projection_out[0], lib.wcut_projection_destroy)

    # move the points where that is asked for
    workers, matrix = threads_of(threads), np.eye(4)
    if register == "fit":
        settings = ffi.new("wcut_registration_options *", lib.wcut_registration_options_default())
        fill(settings, registration, "compare")
        motion, error = ffi.new("wcut_registration *"), new_error()
        check(lib.wcut_registration_fit(projection, len(array), as_points(array), settings, workers, motion, error), error,
              "registration")
        array = array.copy()
        check(lib.wcut_registration_move(motion, len(array), as_points(array, True), ffi.NULL))
        matrix = np.array(list(motion.matrix)).reshape(4, 4)
    elif register != "none":
        raise InputError(f"register: found {register!r}, expected 'none' or 'fit'")
    elif registration:
        raise InputError(f"compare: found the option {sorted(registration)[0]!r}, which is for register='fit'")

    rows = np.zeros(len(array), _DEVIATION)
    target = ffi.from_buffer("wcut_deviation[]", rows, require_writable=True) if len(rows) else ffi.NULL
    check(lib.wcut_deviation_from_surface(projection, len(array), as_points(array), options, workers, target, ffi.NULL), None,
          "cloud")
    return Deviation(rows, array, matrix)
