"""A photograph of a cut face beside the simulated wire."""
from __future__ import annotations

from typing import Any

import numpy as np

from ._core import InputError, check, ffi, field, fill, lib, new_error, path_of, reals, view
from .history import History

_PATCH = "wcut_rill_patch"
_KIND = {"WCUT_CAMERA_KIND_PLANE": "plane", "WCUT_CAMERA_KIND_PINHOLE": "pinhole", "WCUT_CAMERA_KIND_FULL": "full"}


class Overlay:
    """What a photograph says of a cut. Arrays are read-only views of the library's memory."""

    def __init__(self, handle: Any, camera: Any, report: Any) -> None:
        self._handle = ffi.gc(handle, lib.wcut_overlay_destroy)
        self._camera, self._report = camera, report

    def _patch(self, name: str, dtype: Any = np.float64) -> np.ndarray:
        shape = (self._handle.rows, self._handle.columns)
        return field(self._handle, self._handle.patch, shape[0] * shape[1], _PATCH, name, dtype).reshape(shape)

    @property
    def camera(self) -> str:
        """What the points told: "full", "pinhole" or "plane"."""
        return _KIND[ffi.string(ffi.cast("wcut_camera_kind", self._camera.kind))]

    @property
    def focal_px(self) -> float:
        return float(self._camera.focal)

    @property
    def reprojection_rms_px(self) -> float:
        """How far the points are from where the camera sees their places."""
        return float(self._report.rms)

    @property
    def mm_per_px(self) -> float:
        """Size of a pixel of the rectified picture."""
        return float(self._handle.resolution)

    @property
    def covered_share(self) -> float:
        """Share of the face that the picture shows."""
        return float(self._handle.covered)

    @property
    def rectified(self) -> np.ndarray:
        """The picture seen from above (rows, columns, 4), its first row at the block's end; opacity 0 where hidden."""
        p = self._handle.rectified
        return view(self._handle, p.pixel, (p.height, p.width, p.channels), np.uint8)

    @property
    def readable(self) -> np.ndarray:
        """Whether rills were read (rows, columns) of patches, row 0 at the block's entry."""
        return np.array([self._handle.patch[k].readable for k in range(self._handle.rows * self._handle.columns)],
                        bool).reshape(self._handle.rows, self._handle.columns)

    @property
    def angle_deg(self) -> np.ndarray:
        """Rill minus wire (rows, columns), a copy; NaN where nothing is readable."""
        return np.where(self.readable, np.degrees(self._patch("angle")), np.nan)

    @property
    def sigma_deg(self) -> np.ndarray:
        """Standard deviation of the angle (rows, columns), a copy; NaN where nothing is readable."""
        return np.where(self.readable, np.degrees(self._patch("sigma")), np.nan)

    @property
    def curves(self) -> int:
        """Wires that were compared."""
        return int(self._handle.curve_count)

    @property
    def differing(self) -> int:
        """Wires with a deviation beyond four of its standard deviations."""
        return int(self._handle.differing)

    def write_rills(self, path: Any) -> None:
        """Write rills.csv, a row a patch."""
        error = new_error()
        check(lib.wcut_rills_write(self._handle, path_of(path), error), error, "rills")

    def __repr__(self) -> str:
        return f"<Overlay: {int(self._handle.readable)} patches readable, {self.differing} of {self.curves} wires differ>"


def overlay(history: History, photo: Any, points: Any, **options: Any) -> Overlay:
    """Lay a photograph over a simulated cut. photo: a PNG or JPEG file; points: rows u_px, v_px, x_mm, y_mm, z_mm, 4 or 5
    of one plane or 6 and more at different heights. Options are those of wcut_overlay_options: upper=, resolution= and
    patch= in mm, curves=, threads=."""
    if not isinstance(history, History):
        raise InputError(f"history: found {type(history).__name__}, expected a History")
    rows = reals(points, "points", 2)
    if rows.shape[1] != 5:
        raise InputError(f"points: found shape {rows.shape}, expected rows of u_px, v_px, x_mm, y_mm, z_mm")
    chosen = ffi.new("wcut_overlay_options *", lib.wcut_overlay_options_default())
    fill(chosen, options, "overlay")

    # the picture, then the camera that its points tell
    picture_out, error = ffi.new("wcut_picture **"), new_error()
    check(lib.wcut_picture_read(path_of(photo), picture_out, ffi.NULL, error), error, "photo")
    picture = ffi.gc(picture_out[0], lib.wcut_picture_destroy)
    point = ffi.new("wcut_photo_point[]", [{"u": u, "v": v, "place": {"x": x, "y": y, "z": z}} for u, v, x, y, z in rows])
    camera, report = ffi.new("wcut_camera *"), ffi.new("wcut_camera_report *")
    check(lib.wcut_camera_fit(len(rows), point, picture.width, picture.height, ffi.NULL, camera, report, ffi.NULL, ffi.NULL,
                              error), error, "points")

    # the rills against the wire
    out, block = ffi.new("wcut_overlay **"), history._job._handle.block_size
    check(lib.wcut_overlay_create(block, history._handle, camera, report, picture, chosen, ffi.NULL, ffi.NULL, out, error),
          error, "overlay")
    return Overlay(out[0], camera, report)
