"""What is to be cut: block, wire, process, and the path or the design."""
from __future__ import annotations

import json
import os
import tempfile
from typing import Any, Dict, List, Optional

import numpy as np

from ._core import InputError, Error, check, ffi, lib, new_error, numbers, path_of, points, reals, text_of, vector, view



def _scalar(name: str, member: str) -> property:
    whole = name == "nodes"

    def read(self: "Job") -> Any:
        return getattr(self._handle, member)

    def write(self: "Job", value: Any) -> None:
        try:
            number = int(value) if whole else float(value)
            if whole and number != value:
                raise ValueError
        except (TypeError, ValueError, OverflowError):
            raise InputError(f"{name}: found {value!r}, expected a {'whole ' if whole else ''}number") from None
        try:
            setattr(self._handle, member, number)
        except OverflowError:
            raise InputError(f"{name}: found {value!r}, expected a smaller number") from None

    return property(read, write, doc=f"{name}, a plain number; checked when the job is simulated")


class Job:
    """A job. Plain attributes in the units of their names; `write` and `to_dict` give the file format wirecut-job/1."""

    def __init__(self, handle: Any, owner: Any = None) -> None:
        self._handle = ffi.gc(handle, lib.wcut_job_destroy) if owner is None else handle
        self._owner = owner  # keeps a borrowed job alive

    # ---- ways in ----

    @classmethod
    def read(cls, path: Any) -> "Job":
        """A job file. InputError names the key, what was found and what was expected."""
        out, error = ffi.new("wcut_job **"), new_error()
        check(lib.wcut_job_read(path_of(path), out, error), error)
        return cls(out[0])

    @classmethod
    def from_dict(cls, document: Dict[str, Any]) -> "Job":
        """A job from what a job file holds, as dictionaries and lists; arrays are taken too."""
        try:
            text = json.dumps(document, default=_plain, allow_nan=False)
        except (TypeError, ValueError) as cause:
            raise InputError(f"job: {cause}") from None
        return cls._from_text(text)

    @classmethod
    def _from_text(cls, text: str) -> "Job":
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "job.json")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            try:
                return cls.read(path)
            except Error as error:
                raise type(error)(str(error).replace(path, "job"), error.status) from None

    @classmethod
    def from_path(cls, name: str, block_size_mm: Any, mount_a_mm: Any, mount_b_mm: Any, wire_length_mm: float,
                  heat_W_per_m: float, tension_N: float, a_N_per_mm: float, b_m2_per_J: float, *,
                  wire_diameter_mm: float = 0.15, nodes: int = 121, **further: Any) -> "Job":
        """A cut between two path curves of mounts, (stations, 3) each. `further`: keys of the job file such as kerf=,
        limits=, effects=, excitation=."""
        return cls.from_dict({
            "format": "wirecut-job/1", "name": name, "block": {"size_mm": reals(block_size_mm, "block_size_mm")},
            "wire": {"diameter_mm": wire_diameter_mm, "nodes": nodes, "length_mm": wire_length_mm},
            "process": {"heat_W_per_m": heat_W_per_m, "tension_N": tension_N,
                        "force_law": {"a_N_per_mm": a_N_per_mm, "b_m2_per_J": b_m2_per_J}},
            "path": {"mount_a_mm": points(mount_a_mm, "mount_a_mm"), "mount_b_mm": points(mount_b_mm, "mount_b_mm")},
            **further})

    @classmethod
    def from_design(cls, name: str, block_size_mm: Any, edge_a_mm: Any, edge_b_mm: Any, extra_length_mm: Any,
                    heat_W_per_m: float, tension_N: float, a_N_per_mm: float, b_m2_per_J: float, *,
                    stations: int = 241, clearance_mm: float = 80.0, wire_diameter_mm: float = 0.15, nodes: int = 121,
                    **further: Any) -> "Job":
        """A cut whose wire runs on two edge curves through points (n, 3); extra_length_mm: rows of u and mm, (k, 2)."""
        return cls.from_dict({
            "format": "wirecut-job/1", "name": name, "block": {"size_mm": reals(block_size_mm, "block_size_mm")},
            "wire": {"diameter_mm": wire_diameter_mm, "nodes": nodes},
            "process": {"heat_W_per_m": heat_W_per_m, "tension_N": tension_N,
                        "force_law": {"a_N_per_mm": a_N_per_mm, "b_m2_per_J": b_m2_per_J}},
            "design": {"edge_a": {"points_mm": points(edge_a_mm, "edge_a_mm")},
                       "edge_b": {"points_mm": points(edge_b_mm, "edge_b_mm")}, "stations": stations,
                       "extra_length_mm": reals(extra_length_mm, "extra_length_mm", 2), "clearance_mm": clearance_mm},
            **further})

    # ---- ways out ----

    def write(self, path: Any) -> None:
        """Write the job file, whole or not at all."""
        error = new_error()
        check(lib.wcut_job_write(self._handle, path_of(path), error), error)

    def to_dict(self) -> Dict[str, Any]:
        """What the job file holds."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "job.json")
            self.write(path)
            with open(path, encoding="utf-8") as file:
                return dict(json.load(file))

    def copy(self) -> "Job":
        return Job.from_dict(self.to_dict())

    def __reduce__(self) -> Any:
        return Job.from_dict, (self.to_dict(),)

    # ---- attributes ----

    wire_diameter_mm = _scalar("wire_diameter_mm", "wire_diameter")
    wire_length_mm = _scalar("wire_length_mm", "wire_length")
    nodes = _scalar("nodes", "nodes")
    heat_W_per_m = _scalar("heat_W_per_m", "heat")
    tension_N = _scalar("tension_N", "tension")
    speed_max_mm_s = _scalar("speed_max_mm_s", "speed_max")
    speed_min_mm_s = _scalar("speed_min_mm_s", "speed_min")
    kerf_width_mm = _scalar("kerf_width_mm", "kerf_width")
    kerf_per_J_m2_mm = _scalar("kerf_per_J_m2_mm", "kerf_per_q")
    clearance_mm = _scalar("clearance_mm", "clearance")

    @property
    def name(self) -> str:
        return text_of(self._handle.name)

    @property
    def mode(self) -> str:
        """"path" or "design"."""
        return "path" if self._handle.mode == lib.WCUT_MODE_PATH else "design"

    @property
    def block_size_mm(self) -> np.ndarray:
        return numbers(self._handle.block_size)

    @block_size_mm.setter
    def block_size_mm(self, value: Any) -> None:
        self._handle.block_size = vector(value, "block_size_mm")

    @property
    def a_N_per_mm(self) -> float:
        """a of the force law F = a exp(-b Q_eff)."""
        return float(self._handle.force_law.a)

    @a_N_per_mm.setter
    def a_N_per_mm(self, value: float) -> None:
        self._handle.force_law.a = float(value)

    @property
    def b_m2_per_J(self) -> float:
        """b of the force law F = a exp(-b Q_eff)."""
        return float(self._handle.force_law.b)

    @b_m2_per_J.setter
    def b_m2_per_J(self, value: float) -> None:
        self._handle.force_law.b = float(value)

    @property
    def stations(self) -> int:
        return int(self._handle.stations)

    @stations.setter
    def stations(self, value: int) -> None:
        """Another number of stations: the paths are resampled."""
        check(lib.wcut_job_resample(self._handle, value), None, "stations")

    def _mount(self, which: str) -> Optional[np.ndarray]:
        pointer = getattr(self._handle, which)
        return view(self._handle, pointer, (self._handle.stations, 3)) if pointer else None

    def _set_mount(self, which: str, value: Any) -> None:
        pointer, array = getattr(self._handle, which), points(value, which + "_mm")
        if not pointer:
            raise InputError(f"{which}_mm: found a job in design mode, expected one in path mode")
        if len(array) != self.stations:
            raise InputError(f"{which}_mm: found {len(array)} stations, expected {self.stations}; Job.from_path makes a "
                             "job of another length")
        ffi.memmove(pointer, ffi.from_buffer(array), array.nbytes)

    @property
    def mount_a_mm(self) -> Optional[np.ndarray]:
        """Path of mount A (stations, 3), a read-only view; assign an array of the same shape to change it."""
        return self._mount("mount_a")

    @mount_a_mm.setter
    def mount_a_mm(self, value: Any) -> None:
        self._set_mount("mount_a", value)

    @property
    def mount_b_mm(self) -> Optional[np.ndarray]:
        """Path of mount B (stations, 3), a read-only view; assign an array of the same shape to change it."""
        return self._mount("mount_b")

    @mount_b_mm.setter
    def mount_b_mm(self, value: Any) -> None:
        self._set_mount("mount_b", value)

    @property
    def effects(self) -> List[Dict[str, Any]]:
        """The effects that are simulated beyond the plain model, as a job file names them."""
        return list(self.to_dict().get("effects", []))

    def with_effects(self, *effects: Dict[str, Any]) -> "Job":
        """A copy with these effects: job.with_effects({"name": "wire_thermal_lag", "time_constant_s": 0.5})."""
        document = self.to_dict()
        document["effects"] = list(effects)
        return Job.from_dict(document)

    def __repr__(self) -> str:
        return f"<Job {self.name!r}, {self.mode} mode, {self.stations} stations of {self.nodes} nodes>"


def _plain(value: Any) -> Any:
    if isinstance(value, np.ndarray):
        return value.tolist()
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"found {type(value).__name__}, expected numbers, texts, lists, dictionaries or arrays")
