"""A block divided into two closed halves."""
from __future__ import annotations

from typing import Any

import numpy as np

from ._core import check, ffi, fill, lib, new_error, vector, view
from .geometry import Mesh, Surface


class Half:
    """One half of a mould: its mesh and what it measures."""

    def __init__(self, owner: Any, half: Any) -> None:
        self._owner, self._half = owner, half

    @property
    def mesh(self) -> Mesh:
        """The closed mesh, a copy."""
        m = self._half.mesh
        return Mesh.create(view(self._owner, m.vertex, (m.vertex_count, 3)),
                           view(self._owner, m.triangle, (m.triangle_count, 3), np.int32))

    @property
    def closed(self) -> bool:
        return bool(self._half.report.closed and self._half.report.oriented)

    @property
    def volume_mm3(self) -> float:
        return float(self._half.report.volume)

    @property
    def area_mm2(self) -> float:
        return float(self._half.report.area)

    def write(self, path: Any) -> None:
        """Write .stl, .obj, .ply or .glb, by the name's ending."""
        self.mesh.write(path)


class Mould:
    """Both halves."""

    def __init__(self, handle: Any) -> None:
        self._handle = ffi.gc(handle, lib.wcut_mould_destroy)

    @property
    def lower(self) -> Half:
        return Half(self._handle, self._handle.lower)

    @property
    def upper(self) -> Half:
        return Half(self._handle, self._handle.upper)

    @property
    def kerf_volume_mm3(self) -> float:
        return float(self._handle.kerf_volume)

    @property
    def block_volume_mm3(self) -> float:
        return float(self._handle.block_volume)

    @property
    def volume_error(self) -> float:
        """|lower + upper + kerf - block| over the block."""
        return float(self._handle.volume_error)

    def __repr__(self) -> str:
        return f"<Mould: lower half {self.lower.volume_mm3:.6g} mm3, upper half {self.upper.volume_mm3:.6g} mm3>"


def mould(surface: Surface, block_size_mm: Any, **options: Any) -> Mould:
    """Divide a block by a surface. Options are those of wcut_mould_options: kerf=, scale=, prolong=, chord_tolerance=,
    fit_tolerance=, wall_asked= in mm, draft_asked= in rad."""
    chosen = ffi.new("wcut_mould_options *", lib.wcut_mould_default())
    fill(chosen, options, "mould")
    out, error = ffi.new("wcut_mould **"), new_error()
    check(lib.wcut_mould_create(surface._handle, vector(block_size_mm, "block_size_mm"), chosen, out, error), error, "mould")
    return Mould(out[0])
