"""Curves, surfaces and meshes."""
from __future__ import annotations

from typing import Any, Iterable, NamedTuple, Optional, Sequence

import numpy as np

from ._core import InputError, as_points, as_reals, check, ffi, lib, new_error, path_of, points, reals, threads_of, view

_FOOT = np.dtype([("u", "f8"), ("v", "f8"), ("point_mm", "f8", 3), ("distance_mm", "f8"), ("height_mm", "f8"),
                  ("gap_mm", "f8"), ("beyond", "i4"), ("_", "i4")])
assert _FOOT.itemsize == ffi.sizeof("wcut_foot")


class Feet(NamedTuple):
    """Closest points of queries: arrays of the length of the queries."""

    u: np.ndarray
    v: np.ndarray
    point_mm: np.ndarray
    distance_mm: np.ndarray
    height_mm: np.ndarray
    beyond: np.ndarray


class Curve:
    """A B-spline curve, rational where it has weights. Lengths in mm."""

    def __init__(self, handle: Any) -> None:
        self._handle = ffi.gc(handle, lib.wcut_curve_destroy)

    @classmethod
    def create(cls, degree: int, knots: Any, control_mm: Any, weights: Any = None) -> "Curve":
        """A curve of its knots (count + degree + 1), control points (count, 3) and weights (count)."""
        control, knot = points(control_mm, "control_mm"), reals(knots, "knots")
        weight = None if weights is None else reals(weights, "weights")
        if len(knot) != len(control) + degree + 1:
            raise InputError(f"knots: found {len(knot)}, expected {len(control) + degree + 1}")
        if weight is not None and len(weight) != len(control):
            raise InputError(f"weights: found {len(weight)}, expected {len(control)}")
        out = ffi.new("wcut_curve **")
        check(lib.wcut_curve_create(degree, len(control), as_reals(knot), as_points(control),
                                    ffi.NULL if weight is None else as_reals(weight), out), None, "curve")
        return cls(out[0])

    @classmethod
    def interpolate(cls, points_mm: Any) -> "Curve":
        """The cubic through points (n, 3) at chord-length parameters over [0, 1]."""
        array = points(points_mm, "points_mm")
        out = ffi.new("wcut_curve **")
        check(lib.wcut_curve_interpolate(len(array), as_points(array), out), None, "points_mm")
        return cls(out[0])

    @classmethod
    def read(cls, path: Any) -> "list[Curve]":
        """The curves of a STEP, IGES, JSON or CSV file."""
        out, error = ffi.new("wcut_curve_set **"), new_error()
        check(lib.wcut_curve_set_read(path_of(path), ffi.NULL, out, error), error)
        found = out[0]
        curves = []
        for k in range(found.count):
            curves.append(cls(found.curve[k]))
            found.curve[k] = ffi.NULL
        lib.wcut_curve_set_destroy(found)
        return curves

    @property
    def degree(self) -> int:
        return int(self._handle.degree)

    @property
    def knots(self) -> np.ndarray:
        c = self._handle
        return view(c, c.knots, (c.control_count + c.degree + 1,))

    @property
    def control_mm(self) -> np.ndarray:
        """Control points (count, 3)."""
        return view(self._handle, self._handle.control, (self._handle.control_count, 3))

    @property
    def weights(self) -> Optional[np.ndarray]:
        """Weights (count), or None."""
        c = self._handle
        return view(c, c.weights, (c.control_count,)) if c.weights else None

    @property
    def domain(self) -> "tuple[float, float]":
        first, last = ffi.new("double *"), ffi.new("double *")
        lib.wcut_curve_domain(self._handle, first, last)
        return first[0], last[0]

    @property
    def length_mm(self) -> float:
        length = ffi.new("double *")
        check(lib.wcut_curve_length(self._handle, *self.domain, length), None, "curve")
        return float(length[0])

    def evaluate(self, u: Any, order: int = 0) -> np.ndarray:
        """Points (n, 3) at parameters (n), or with their derivatives (n, order + 1, 3)."""
        at = reals(np.atleast_1d(u), "u")
        out = np.empty((len(at), order + 1, 3))
        for k, parameter in enumerate(at):
            check(lib.wcut_curve_eval(self._handle, parameter, order, as_points(out[k], True)), None, "u")
        return out[:, 0] if order == 0 else out

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        return np.array(self.control_mm, dtype)

    def __repr__(self) -> str:
        return f"<Curve of degree {self.degree}, {len(self.control_mm)} control points, {self.length_mm:.6g} mm>"


class Mesh:
    """Shared vertices and triangles."""

    def __init__(self, handle: Any) -> None:
        self._handle = ffi.gc(handle, lib.wcut_mesh_destroy)

    @classmethod
    def create(cls, vertices_mm: Any, triangles: Any) -> "Mesh":
        """A mesh of vertices (n, 3) and triangles (m, 3) of their indices; both are copied."""
        vertex, corner = points(vertices_mm, "vertices_mm"), np.asarray(triangles)
        if corner.ndim != 2 or corner.shape[1] != 3 or corner.dtype.kind not in "iu":
            raise InputError(f"triangles: found {corner.dtype} of shape {corner.shape}, expected whole numbers (m, 3)")
        if corner.size and (corner.min() < 0 or corner.max() >= len(vertex)):
            raise InputError(f"triangles: found indices from {corner.min()} to {corner.max()}, expected 0 to {len(vertex) - 1}")
        out = ffi.new("wcut_mesh **")
        check(lib.wcut_mesh_create(len(vertex), len(corner), 0, out), None, "mesh")
        mesh = cls(out[0])
        ffi.memmove(mesh._handle.vertex, ffi.from_buffer(vertex), vertex.nbytes)
        corner = np.ascontiguousarray(corner, np.int32)
        ffi.memmove(mesh._handle.triangle, ffi.from_buffer(corner), corner.nbytes)
        return mesh

    @classmethod
    def read(cls, path: Any) -> "Mesh":
        """An STL, PLY, OBJ, OFF or glTF file."""
        out, error = ffi.new("wcut_mesh **"), new_error()
        check(lib.wcut_mesh_read(path_of(path), ffi.NULL, out, ffi.NULL, error), error)
        return cls(out[0])

    @property
    def vertices_mm(self) -> np.ndarray:
        """Vertices (n, 3), a view."""
        return view(self._handle, self._handle.vertex, (self._handle.vertex_count, 3))

    @property
    def triangles(self) -> np.ndarray:
        """Indices of corners (m, 3), a view."""
        return view(self._handle, self._handle.triangle, (self._handle.triangle_count, 3), np.int32)

    @property
    def normals(self) -> Optional[np.ndarray]:
        """Unit normals (n, 3), a view, or None."""
        m = self._handle
        return view(m, m.normal, (m.vertex_count, 3)) if m.normal else None

    @property
    def uv(self) -> Optional[np.ndarray]:
        """Surface parameters (n, 2), a view, or None."""
        m = self._handle
        return view(m, m.uv, (m.vertex_count, 2)) if m.uv else None

    @property
    def volume_mm3(self) -> float:
        """The volume that the triangles enclose, positive where they face outwards."""
        corner = self.vertices_mm[self.triangles]
        return float(np.einsum("ij,ij->i", corner[:, 0], np.cross(corner[:, 1], corner[:, 2])).sum() / 6)

    def write(self, path: Any) -> None:
        """Write .stl, .obj, .ply or .glb, by the name's ending."""
        error, name = new_error(), path_of(path)
        writers = {b".stl": lib.wcut_mesh_write_stl, b".obj": lib.wcut_mesh_write_obj, b".glb": lib.wcut_mesh_write_glb}
        ending = name[name.rfind(b"."):].lower()
        if ending == b".ply":
            check(lib.wcut_mesh_write_ply(self._handle, b"value", name, error), error)
        elif ending in writers:
            check(writers[ending](self._handle, name, error), error)
        else:
            raise InputError(f"{path}: expected a name that ends in .stl, .obj, .ply or .glb")

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        return np.array(self.vertices_mm, dtype)

    def __repr__(self) -> str:
        return f"<Mesh of {self._handle.vertex_count} vertices, {self._handle.triangle_count} triangles>"


class Surface:
    """A tensor-product B-spline surface, rational where it has weights. Lengths in mm."""

    def __init__(self, handle: Any, parameters: Optional[np.ndarray] = None) -> None:
        self._handle = ffi.gc(handle, lib.wcut_surface_destroy)
        self._projection: Any = None
        #: v of each station of a loft, or None
        self.station_v = parameters

    @classmethod
    def create(cls, degree_u: int, degree_v: int, knots_u: Any, knots_v: Any, control_mm: Any,
               weights: Any = None) -> "Surface":
        """A surface of its control points (count_v, count_u, 3); knots count + degree + 1 each; weights (count_v,
        count_u)."""
        control = reals(control_mm, "control_mm", 3)
        if control.shape[2] != 3:
            raise InputError(f"control_mm: found the shape {control.shape}, expected (count_v, count_u, 3)")
        count_v, count_u = control.shape[:2]
        knot = reals(knots_u, "knots_u"), reals(knots_v, "knots_v")
        for name, array, count, degree in (("knots_u", knot[0], count_u, degree_u), ("knots_v", knot[1], count_v, degree_v)):
            if len(array) != count + degree + 1:
                raise InputError(f"{name}: found {len(array)}, expected {count + degree + 1}")
        weight = None if weights is None else reals(weights, "weights", 2)
        if weight is not None and weight.shape != (count_v, count_u):
            raise InputError(f"weights: found the shape {weight.shape}, expected {(count_v, count_u)}")
        out = ffi.new("wcut_surface **")
        check(lib.wcut_surface_create(degree_u, degree_v, count_u, count_v, as_reals(knot[0]), as_reals(knot[1]),
                                      as_points(control), ffi.NULL if weight is None else as_reals(weight), out), None,
              "surface")
        return cls(out[0])

    @classmethod
    def loft(cls, position_mm: Any, merge_mm: float = 1e-3) -> "Surface":
        """The bicubic surface through every station's nodes (stations, nodes, 3)."""
        array = reals(position_mm, "position_mm", 3)
        if array.shape[2] != 3:
            raise InputError(f"position_mm: found the shape {array.shape}, expected (stations, nodes, 3)")
        out, parameter = ffi.new("wcut_surface **"), np.empty(array.shape[0])
        check(lib.wcut_surface_loft(array.shape[0], array.shape[1], as_points(array), merge_mm, out,
                                    as_reals(parameter, True), ffi.NULL), None, "position_mm")
        return cls(out[0], parameter)

    @property
    def degrees(self) -> "tuple[int, int]":
        return int(self._handle.degree_u), int(self._handle.degree_v)

    @property
    def knots(self) -> "tuple[np.ndarray, np.ndarray]":
        s = self._handle
        return (view(s, s.knots_u, (s.count_u + s.degree_u + 1,)), view(s, s.knots_v, (s.count_v + s.degree_v + 1,)))

    @property
    def control_mm(self) -> np.ndarray:
        """Control points (count_v, count_u, 3), a view."""
        s = self._handle
        return view(s, s.control, (s.count_v, s.count_u, 3))

    @property
    def weights(self) -> Optional[np.ndarray]:
        """Weights (count_v, count_u), a view, or None."""
        s = self._handle
        return view(s, s.weights, (s.count_v, s.count_u)) if s.weights else None

    @property
    def domain(self) -> "tuple[tuple[float, float], tuple[float, float]]":
        """((u first, u last), (v first, v last))."""
        first, last = ffi.new("double[2]"), ffi.new("double[2]")
        lib.wcut_surface_domain(self._handle, first, last)
        return (first[0], last[0]), (first[1], last[1])

    def evaluate(self, u: Any, v: Any) -> np.ndarray:
        """Points (len(v), len(u), 3) on the grid of parameters."""
        along, across = reals(np.atleast_1d(u), "u"), reals(np.atleast_1d(v), "v")
        out = np.empty((len(across), len(along), 3))
        check(lib.wcut_surface_eval_grid(self._handle, len(along), as_reals(along), len(across), as_reals(across),
                                         as_points(out, True)), None, "u, v")
        return out

    def derivatives(self, u: float, v: float, order: int = 1) -> np.ndarray:
        """d^(k+l) S / du^k dv^l at [k, l] of an array (order + 1, order + 1, 3)."""
        if not 0 <= order <= 3:
            raise InputError(f"order: found {order}, expected 0 to 3")
        out = np.empty((order + 1, order + 1, 3))
        check(lib.wcut_surface_eval(self._handle, u, v, order, as_points(out, True)), None, "u, v")
        return out

    def normals(self, u: Any, v: Any) -> np.ndarray:
        """Unit normals S_u x S_v (len(v), len(u), 3) on the grid of parameters; zero where the surface has none."""
        along, across = np.atleast_1d(u), np.atleast_1d(v)
        out = np.zeros((len(across), len(along), 3))
        for j, q in enumerate(across):
            for i, p in enumerate(along):
                d = self.derivatives(float(p), float(q))
                n = np.cross(d[1, 0], d[0, 1])
                size = float(np.linalg.norm(n))
                out[j, i] = n / size if size > 0 else 0
        return out

    def curvature(self, u: float, v: float) -> "tuple[float, float]":
        """Principal curvatures [1/mm], the larger first."""
        larger, smaller = ffi.new("double *"), ffi.new("double *")
        check(lib.wcut_surface_curvature(self._handle, u, v, larger, smaller), None, "u, v")
        return float(larger[0]), float(smaller[0])

    def closest(self, points_mm: Any, threads: Optional[int] = None) -> Feet:
        """The closest points of the surface for queries (n, 3), each proven; the queries are not copied where they are
        contiguous doubles."""
        query = points(points_mm, "points_mm")
        if self._projection is None:
            out = ffi.new("wcut_projection **")
            check(lib.wcut_projection_create(self._handle, out), None, "surface")
            self._projection = ffi.gc(out[0], lib.wcut_projection_destroy)
        foot = np.empty(len(query), _FOOT)
        target = ffi.from_buffer("wcut_foot[]", foot, require_writable=True) if len(query) else ffi.NULL
        check(lib.wcut_projection_locate(self._projection, len(query), as_points(query), threads_of(threads), target), None,
              "points_mm")
        return Feet(foot["u"], foot["v"], foot["point_mm"], foot["distance_mm"], foot["height_mm"],
                    foot["beyond"].astype(bool))

    def tessellate(self, chord_tolerance_mm: float = 0.1) -> Mesh:
        """Triangles no further from the surface than a tolerance, with normals and uv."""
        out = ffi.new("wcut_mesh **")
        check(lib.wcut_surface_tessellate(self._handle, chord_tolerance_mm, out, ffi.NULL), None, "chord_tolerance_mm")
        return Mesh(out[0])

    def offset(self, distance_mm: float, tolerance_mm: float = 0.01) -> "Surface":
        """The surface at a distance along the normal, to a verified tolerance."""
        out = ffi.new("wcut_surface **")
        check(lib.wcut_surface_offset(self._handle, distance_mm, tolerance_mm, out, ffi.NULL), None, "offset")
        return Surface(out[0])

    def write(self, path: Any, name: str = "surface") -> None:
        """Write .step, .stp, .iges or .igs, by the name's ending."""
        write_shapes([self], path, [name])

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        return np.array(self.control_mm, dtype)

    def __repr__(self) -> str:
        s = self._handle
        return f"<Surface of degrees {s.degree_u} x {s.degree_v}, {s.count_u} x {s.count_v} control points>"


def write_shapes(shapes: "Iterable[Surface | Curve]", path: Any, names: "Optional[Sequence[str]]" = None) -> None:
    """Surfaces and curves into one STEP or IGES file, by the name's ending."""
    items = list(shapes)
    labels = [f"shape {k + 1}" for k in range(len(items))] if names is None else list(names)
    if len(labels) != len(items):
        raise InputError(f"names: found {len(labels)}, expected {len(items)}")
    held = [ffi.new("char[]", label.encode()) for label in labels]
    shape = ffi.new("wcut_shape[]", max(len(items), 1))
    for k, item in enumerate(items):
        shape[k].name = held[k]
        if isinstance(item, Surface):
            shape[k].surface = item._handle
        elif isinstance(item, Curve):
            shape[k].curve = item._handle
        else:
            raise InputError(f"shapes: found {type(item).__name__}, expected Surface or Curve")
    error, name = new_error(), path_of(path)
    ending = name[name.rfind(b"."):].lower()
    if ending in (b".step", b".stp"):
        check(lib.wcut_step_write(len(items), shape, lib.WCUT_STEP_SCHEMA_AP214, name, error), error)
    elif ending in (b".iges", b".igs"):
        check(lib.wcut_iges_write(len(items), shape, name, error), error)
    else:
        raise InputError(f"{path}: expected a name that ends in .step, .stp, .iges or .igs")
