"""Force-adaptive speed control, one step at a time, and the motion of two robots."""
from __future__ import annotations

from typing import Any

import numpy as np

from ._core import InputError, as_points, check, ffi, field, fill, lib, new_error, path_of, text_of
from .history import History


class Controller:
    """The speed controller of a cut. `step` is called at every period of the loop; it allocates nothing."""

    def __init__(self, plan: History, **settings: Any) -> None:
        """The plan is the simulated cut; settings are those of wcut_control_settings: gain=, rate=, filter=, tension=."""
        chosen = ffi.new("wcut_control_settings *", lib.wcut_control_settings_default(plan._job._handle))
        fill(chosen, settings, "Controller")
        out, error = ffi.new("wcut_control **"), new_error()
        check(lib.wcut_control_create(chosen, plan._handle, out, error), error, "Controller")
        self._handle, self._plan = ffi.gc(out[0], lib.wcut_control_destroy), plan
        self._speed, self._view = ffi.new("double *"), ffi.new("wcut_control_view *")

    def step(self, time_s: float, station: float, tension_a_N: float, tension_b_N: float) -> float:
        """The speed to command [mm/s], of the faster mount."""
        check(lib.wcut_control_step(self._handle, time_s, station, tension_a_N, tension_b_N, self._speed), None, "step")
        return float(self._speed[0])

    @property
    def state(self) -> str:
        """"run", "hold", or a stop with its reason."""
        lib.wcut_control_look(self._handle, self._view)
        return text_of(lib.wcut_control_state_name(self._view.state))

    @property
    def correction(self) -> float:
        """The correction of the last step [1]."""
        lib.wcut_control_look(self._handle, self._view)
        return float(self._view.correction)


class RobotMotion:
    """Targets that two robots reach at the same moments."""

    def __init__(self, handle: Any, name: str) -> None:
        self._handle = ffi.gc(handle, lib.wcut_robot_motion_destroy)
        self._name = name

    def __len__(self) -> int:
        return int(self._handle.count)

    @property
    def time_s(self) -> np.ndarray:
        """Time of every target (n), a view."""
        return field(self._handle, self._handle.target, len(self), "wcut_robot_target", "time")

    @property
    def duration_s(self) -> float:
        return float(self._handle.duration)

    def positions_mm(self) -> "tuple[np.ndarray, np.ndarray]":
        """Positions of both tools (n, 3) in the block frame, copies."""
        t = self._handle.target
        return (np.array([[t[k].a.x, t[k].a.y, t[k].a.z] for k in range(len(self))]),
                np.array([[t[k].b.x, t[k].b.y, t[k].b.z] for k in range(len(self))]))

    def write(self, path: Any, format: str, robot: int = 0) -> None:
        """One robot's program: "urscript", "rapid", "krl"; or both robots in "csv" or "json"."""
        names = ffi.new("wcut_robot_names *", lib.wcut_robot_names_default())
        title = ffi.new("char[]", self._name.encode())
        names.title = title
        formats = {text_of(lib.wcut_robot_format_name(k)): k for k in range(lib.WCUT_ROBOT_FORMAT_JSON + 1)}
        if format not in formats:
            raise InputError(f"format: found {format!r}, expected one of {', '.join(formats)}")
        error = new_error()
        check(lib.wcut_robot_write(self._handle, names, formats[format], robot, path_of(path), error), error)


def robot_motion(history: History, **options: Any) -> RobotMotion:
    """The motion of two robots along a cut's path curves. Options are those of wcut_robot_options: chord_tolerance=,
    time_tolerance=, lead_in=, lead_out=, zone= in mm, angle_tolerance= in rad."""
    a, b, _ = history.mounts_mm()
    chosen = ffi.new("wcut_robot_options *", lib.wcut_robot_options_default())
    fill(chosen, options, "robot_motion")
    out, error = ffi.new("wcut_robot_motion **"), new_error()
    check(lib.wcut_robot_motion_create(history._handle, as_points(a), as_points(b), chosen, out, error), error,
          history._job.name)
    return RobotMotion(out[0], history._job.name)
