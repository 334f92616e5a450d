"""Interchange with COMPAS by its JSON data format; compas itself is not needed."""
from __future__ import annotations

import json
import uuid
from typing import Any, Dict, List, Union

import numpy as np

from ._core import InputError
from .geometry import Curve, Mesh, Surface

Shape = Union[Mesh, Curve, Surface]
_SPACE = uuid.UUID("7b0a4a5e-5d0c-4f3a-9a39-8e0c6b1f2d10")


def _knots(values: Any) -> "tuple[List[float], List[int]]":
    """Distinct knots and how often each stands there."""
    knots: List[float] = []
    count: List[int] = []
    for value in np.asarray(values).tolist():
        if knots and value == knots[-1]:
            count[-1] += 1
        else:
            knots.append(value)
            count.append(1)
    return knots, count


def to_compas(shape: Shape) -> Dict[str, Any]:
    """A mesh, curve or surface as COMPAS' JSON data: {"dtype", "data", "guid"}. The same shape gives the same text."""
    if isinstance(shape, Mesh):
        data: Dict[str, Any] = {
            "attributes": {}, "default_vertex_attributes": {"x": 0.0, "y": 0.0, "z": 0.0}, "default_edge_attributes": {},
            "default_face_attributes": {},
            "vertex": {str(k): {"x": x, "y": y, "z": z} for k, (x, y, z) in enumerate(shape.vertices_mm.tolist())},
            "face": {str(k): corners for k, corners in enumerate(shape.triangles.tolist())}, "facedata": {}, "edgedata": {},
            "max_vertex": len(shape.vertices_mm) - 1, "max_face": len(shape.triangles) - 1}
        dtype = "compas.datastructures/Mesh"
    elif isinstance(shape, Curve):
        knots, count = _knots(shape.knots)
        weights = np.ones(len(shape.control_mm)) if shape.weights is None else shape.weights
        data = {"points": shape.control_mm.tolist(), "weights": weights.tolist(), "knots": knots, "multiplicities": count,
                "degree": shape.degree, "is_periodic": False}
        dtype = "compas.geometry/NurbsCurve"
    elif isinstance(shape, Surface):
        (u, v), (degree_u, degree_v) = shape.knots, shape.degrees
        knots_u, count_u = _knots(u)
        knots_v, count_v = _knots(v)
        # COMPAS: rows of points along u, one for each control point of u
        control = np.swapaxes(shape.control_mm, 0, 1)
        weights = np.ones(control.shape[:2]) if shape.weights is None else shape.weights.T
        data = {"points": control.tolist(), "weights": weights.tolist(), "knots_u": knots_u, "knots_v": knots_v,
                "mults_u": count_u, "mults_v": count_v, "degree_u": degree_u, "degree_v": degree_v,
                "is_periodic_u": False, "is_periodic_v": False}
        dtype = "compas.geometry/NurbsSurface"
    else:
        raise InputError(f"to_compas: found {type(shape).__name__}, expected Mesh, Curve or Surface")
    return {"dtype": dtype, "data": data, "guid": str(uuid.uuid5(_SPACE, dtype + json.dumps(data)))}


def _repeat(knots: Any, count: Any) -> np.ndarray:
    return np.repeat(np.asarray(knots, float), np.asarray(count, int))


def from_compas(document: Dict[str, Any]) -> Shape:
    """A mesh, NURBS curve or NURBS surface of COMPAS' JSON data."""
    try:
        dtype, data = document["dtype"], document["data"]
        kind = dtype.rsplit("/", 1)[-1]
        if kind == "Mesh":
            keys = sorted(data["vertex"], key=int)
            index = {int(key): k for k, key in enumerate(keys)}
            vertices = [[data["vertex"][key][axis] for axis in "xyz"] for key in keys]
            triangles = []
            for corners in data["face"].values():
                face = [index[int(corner)] for corner in corners]
                triangles += [[face[0], face[k], face[k + 1]] for k in range(1, len(face) - 1)]
            return Mesh.create(vertices, np.array(triangles, int).reshape(-1, 3))
        if kind == "NurbsCurve":
            weights = np.asarray(data["weights"], float)
            return Curve.create(data["degree"], _repeat(data["knots"], data["multiplicities"]), data["points"],
                                None if np.all(weights == 1) else weights)
        if kind == "NurbsSurface":
            weights = np.asarray(data["weights"], float).T
            return Surface.create(data["degree_u"], data["degree_v"], _repeat(data["knots_u"], data["mults_u"]),
                                  _repeat(data["knots_v"], data["mults_v"]), np.swapaxes(np.asarray(data["points"], float), 0, 1),
                                  None if np.all(weights == 1) else weights)
    except (KeyError, TypeError, ValueError, AttributeError) as cause:
        if isinstance(cause, InputError):
            raise
        raise InputError(f"from_compas: {type(cause).__name__}: {cause}") from None
    raise InputError(f"from_compas: found {dtype!r}, expected a Mesh, a NurbsCurve or a NurbsSurface")
