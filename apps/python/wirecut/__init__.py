"""Wirecut: spatial hot-wire cutting in simulation.

    import wirecut
    job = wirecut.Job.read("job.json")
    job.heat_W_per_m = 65
    history = wirecut.simulate(job)
    history.surface().write("surface.step")

Units: mm, N, s, W/m, deg; names say which. Arrays that the library owns are read-only views; what a function takes is
converted where it must be and refused by name where it cannot. Failures are exceptions with status and place.
"""
from ._core import (ConvergenceError, Error, GeometryError, InputError, InternalError, OutputError, lib as _lib, text_of as
                    _text_of)
from .compas import from_compas, to_compas
from .control import Controller, RobotMotion, robot_motion
from .diagnosis import Diagnosis, diagnose
from .geometry import Curve, Feet, Mesh, Surface, write_shapes
from .history import History, simulate
from .job import Job
from .mould import Half, Mould, mould
from .photo import Overlay, overlay
from .recording import ForceLaw, Recording, Score, calibrate, score
from .scan import Cloud, Deviation, compare

__version__ = _text_of(_lib.wcut_version_text())

__all__ = [
    "Cloud", "Controller", "ConvergenceError", "Curve", "Deviation", "Diagnosis", "Error", "Feet", "ForceLaw",
    "GeometryError", "Half", "History", "InputError", "InternalError", "Job", "Mesh", "Mould", "OutputError", "Overlay",
    "Recording", "RobotMotion", "Score", "Surface", "calibrate", "compare", "diagnose", "from_compas", "mould",
    "overlay", "robot_motion", "score", "simulate", "to_compas", "write_shapes",
]
