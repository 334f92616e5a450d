"""A cut from its first station to its last."""
from __future__ import annotations

import html
from typing import Any, Optional

import numpy as np

from ._core import (InputError, Progress, Reporter, as_points, check, failure, ffi, field, fill, lib,
                    new_error, path_of, text_of, view)
from .geometry import Surface
from .job import Job

_ROW = "wcut_history_row"


class History:
    """What a simulation gives. Arrays are read-only views of the library's memory."""

    def __init__(self, handle: Any, setup: Any) -> None:
        self._handle = ffi.gc(handle, lib.wcut_history_destroy)
        self._setup = setup
        self._job = Job(ffi.cast("wcut_job *", lib.wcut_setup_job(setup)), setup)
        self._mounts: "Optional[tuple[np.ndarray, np.ndarray, float]]" = None

    def _row(self, name: str, dtype: Any = np.float64) -> np.ndarray:
        return field(self._handle, self._handle.row, self.stations, _ROW, name, dtype)

    @property
    def job(self) -> Job:
        """The job that was simulated, a copy."""
        return self._job.copy()

    @property
    def stations(self) -> int:
        """Stations that were reached."""
        return int(self._handle.stations)

    @property
    def nodes(self) -> int:
        return int(self._handle.nodes)

    @property
    def position_mm(self) -> np.ndarray:
        """Nodes of the wire (stations, nodes, 3), from mount A to mount B."""
        return view(self._handle, self._handle.position, (self.stations, self.nodes, 3))

    @property
    def force_N(self) -> np.ndarray:
        """Force of the foam on the nodes (stations, nodes, 3)."""
        return view(self._handle, self._handle.force, (self.stations, self.nodes, 3))

    @property
    def force_N_per_mm(self) -> np.ndarray:
        """Force across the wire per engaged length (stations, nodes)."""
        return view(self._handle, self._handle.force_line, (self.stations, self.nodes))

    @property
    def speed_mm_s(self) -> np.ndarray:
        """Speed of the nodes (stations, nodes)."""
        return view(self._handle, self._handle.speed, (self.stations, self.nodes))

    @property
    def tension_N(self) -> np.ndarray:
        """Tension of the edges (stations, nodes - 1)."""
        return view(self._handle, self._handle.tension, (self.stations, self.nodes - 1))

    @property
    def time_s(self) -> np.ndarray:
        """Time of every station (stations)."""
        return self._row("time")

    @property
    def mount_speed_mm_s(self) -> np.ndarray:
        """Speeds of mounts A and B (stations, 2), a copy."""
        return np.column_stack([self._row("speed_a"), self._row("speed_b")])

    @property
    def mount_tension_N(self) -> np.ndarray:
        """Tensions at mounts A and B (stations, 2), a copy."""
        return np.column_stack([self._row("tension_a"), self._row("tension_b")])

    @property
    def angles_deg(self) -> np.ndarray:
        """alpha and beta at A, alpha and beta at B (stations, 4), a copy."""
        return np.degrees(np.column_stack([self._row(n) for n in ("alpha_a", "beta_a", "alpha_b", "beta_b")]))

    @property
    def engaged_mm(self) -> np.ndarray:
        """Length of wire in the foam (stations)."""
        return self._row("engaged_length")

    @property
    def phase(self) -> np.ndarray:
        """Phase of every station, a text each: "approach", "entry", "steady", "exit", "left"."""
        names = [text_of(lib.wcut_phase_name(k)) for k in range(lib.WCUT_PHASE_LEFT + 1)]
        return np.array(names)[self._row("phase", np.uint32)]

    def surface(self, merge_mm: float = 1e-3) -> Surface:
        """The exact surface through the wire of every station."""
        return Surface.loft(self.position_mm, merge_mm)

    def mounts_mm(self) -> "tuple[np.ndarray, np.ndarray, float]":
        """Path curves of mounts A and B (stations, 3) each, and the wire's length between them."""
        if self._mounts is None:
            a, b = np.empty((self.stations, 3)), np.empty((self.stations, 3))
            length, error = ffi.new("double *"), new_error()
            check(lib.wcut_history_path(self._setup, self._handle, as_points(a, True), as_points(b, True), length, error),
                  error)
            self._mounts = a, b, float(length[0])
        return self._mounts

    def write_csv(self, path: Any) -> None:
        """path.csv: a row a station."""
        a, b, _ = self.mounts_mm()
        error = new_error()
        check(lib.wcut_history_write_csv(self._handle, as_points(a), as_points(b), path_of(path), error), error)

    def write_vtp(self, path: Any) -> None:
        """history.vtp for ParaView."""
        error = new_error()
        check(lib.wcut_history_write_vtp(self._handle, path_of(path), error), error)

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray:
        return np.array(self.position_mm, dtype)

    def __len__(self) -> int:
        return self.stations

    def __repr__(self) -> str:
        return f"<History of {self._job.name!r}: {self.stations} stations of {self.nodes} nodes, {self.time_s[-1]:.4g} s>"

    def _repr_html_(self) -> str:
        angles = np.abs(self.angles_deg).max(axis=0)
        rows = [("stations", f"{self.stations} of {self._handle.planned}"), ("nodes", str(self.nodes)),
                ("duration", f"{self.time_s[-1]:.4g} s"),
                ("speed of the mounts, largest", f"{self.mount_speed_mm_s.max():.4g} mm/s"),
                ("force, largest", f"{self.force_N_per_mm.max():.4g} N/mm"),
                ("alpha, largest", f"{max(angles[0], angles[2]):.4g} deg"),
                ("beta, largest", f"{max(angles[1], angles[3]):.4g} deg")]
        body = "".join(f"<tr><th style='text-align:left'>{html.escape(k)}</th><td>{html.escape(v)}</td></tr>" for k, v in rows)
        return f"<table><caption>{html.escape(self._job.name)}</caption>{body}</table>"


def simulate(job: Job, *, progress: Optional[Progress] = None, **options: Any) -> History:
    """Cut a job in simulation.

    progress(station, stations) is called after every station; a true answer stops the run. Options are those of
    wcut_cut_options: tolerance=, max_iterations=, max_halvings=, integrator= ("implicit" or "heun").

    ConvergenceError, KeyboardInterrupt: `partial` holds the History of the stations that were reached.
    """
    if not isinstance(job, Job):
        raise InputError(f"job: found {type(job).__name__}, expected a Job")
    chosen = ffi.new("wcut_cut_options *", lib.wcut_cut_options_default())
    if "integrator" in options:
        named = {"implicit": lib.WCUT_INTEGRATOR_IMPLICIT, "heun": lib.WCUT_INTEGRATOR_HEUN}
        word = options.pop("integrator")
        if word not in named:
            raise InputError(f"integrator: found {word!r}, expected 'implicit' or 'heun'")
        chosen.integrator = named[word]
    fill(chosen, options, "simulate")
    setup_out, history_out, error = ffi.new("wcut_setup **"), ffi.new("wcut_history **"), new_error()
    check(lib.wcut_setup_create(job._handle, chosen, setup_out, error), error, job.name)
    setup = ffi.gc(setup_out[0], lib.wcut_setup_destroy)
    reporter = Reporter(progress)
    status = lib.wcut_setup_run(setup, reporter.function, ffi.NULL, history_out, error)
    history = History(history_out[0], setup) if history_out[0] else None
    if reporter.cause is not None:
        reporter.check()
    if status != lib.WCUT_OK:
        cause = failure(status, error, job.name)
        cause.partial = history  # type: ignore[attr-defined]
        raise cause
    assert history is not None
    return history
