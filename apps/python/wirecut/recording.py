"""Recordings, their scores, and the calibration of the force law."""
from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np

from ._core import check, ffi, fill, lib, new_error, path_of, text_of, view
from .job import Job

_ANGLES = ("alpha_a_deg", "beta_a_deg", "alpha_b_deg", "beta_b_deg")


class Recording:
    """What the sensors of a cut recorded. Channels by their column's name, angles in deg; a missing sample is NaN."""

    def __init__(self, handle: Any) -> None:
        self._handle = ffi.gc(handle, lib.wcut_recording_destroy)

    @classmethod
    def read(cls, path: Any, columns: str = "", period: float = 0.0) -> "Recording":
        """A recording file; columns: which of its columns the channels are, "time_s=timestamp,force_x_N=Fx*0.001";
        period [s]: constant time between rows of a file without a clock."""
        out, error = ffi.new("wcut_recording **"), new_error()
        named = ffi.new("wcut_recording_format *")
        check(lib.wcut_recording_format_parse(columns.encode(), named, error), error)
        named.period = period
        try:
            check(lib.wcut_recording_read(path_of(path), named, out, error), error)
        finally:
            lib.wcut_recording_format_clear(named)
        return cls(out[0])

    @property
    def channels(self) -> List[str]:
        """Names of the channels that the file has."""
        return [text_of(lib.wcut_channel_name(k)) for k in range(lib.WCUT_CHANNEL_COUNT) if self._handle.channel[k].name]

    def __getitem__(self, name: str) -> np.ndarray:
        for k in range(lib.WCUT_CHANNEL_COUNT):
            column = self._handle.channel[k]
            if text_of(lib.wcut_channel_name(k)) == name and column.name:
                value = np.array(view(self._handle, column.value, (self._handle.samples,)))
                if column.present:
                    value[view(self._handle, column.present, (self._handle.samples,), np.uint8) == 0] = np.nan
                return np.degrees(value) if name in _ANGLES else value
        raise KeyError(f"{name}: expected one of {', '.join(self.channels)}")

    def __len__(self) -> int:
        return int(self._handle.samples)

    def __repr__(self) -> str:
        return f"<Recording of {len(self)} samples: {', '.join(self.channels)}>"


class Score(NamedTuple):
    """How far a prediction is from a recording, in the channel's unit: rmsd about the bias, rmse with it; nrmsd and
    rmse_over_range over the range of the measured values."""

    samples: int
    bias: float
    rmsd: float
    nrmsd: float
    rmse_over_range: float


def score(job: Job, recording: Recording, **options: Any) -> Dict[str, Dict[str, Score]]:
    """A recording beside its two predictions: {"planned": {channel: Score}, "replayed": {channel: Score}}. Planned knows
    the job, replayed knows the recorded motion. Options: settle=, leave= in s, tolerance=."""
    chosen = ffi.new("wcut_comparison_options *", lib.wcut_comparison_options_default())
    fill(chosen, options, "score")
    out, error = ffi.new("wcut_comparison **"), new_error()
    check(lib.wcut_comparison_create(job._handle, recording._handle, chosen, out, error), error, job.name)
    found = ffi.gc(out[0], lib.wcut_comparison_destroy)
    result: Dict[str, Dict[str, Score]] = {}
    for name, scores in (("planned", found.planned_score), ("replayed", found.replayed_score)):
        result[name] = {}
        for k in range(lib.WCUT_SCORED_COUNT):
            one = scores.of[k][lib.WCUT_PART_ALL]
            if one.count:
                unit = 180 / np.pi if text_of(lib.wcut_scored_unit(k)) == "deg" else 1
                result[name][text_of(lib.wcut_scored_name(k))] = Score(one.count, one.bias * unit, one.rmsd * unit, one.nrmsd,
                                                                       one.rmse_over_range)
    return result


class ForceLaw(NamedTuple):
    """F = a exp(-b Q_eff) with standard errors and 95 % intervals."""

    a_N_per_mm: float
    b_m2_per_J: float
    a_error: float
    b_error: float
    a_interval: Tuple[float, float]
    b_interval: Tuple[float, float]
    separable: bool
    q_eff_range_J_per_m2: Tuple[float, float]


def calibrate(table: Any, weight: Optional[str] = None, **options: Any) -> ForceLaw:
    """The force law of a calibration table, a CSV file. Options are those of wcut_calibration_options."""
    count, cuts, error = ffi.new("int *"), ffi.new("wcut_test_cut **"), new_error()
    column = ffi.NULL if weight is None else weight.encode()
    check(lib.wcut_calibration_table_read(path_of(table), column, count, cuts, error), error)
    held = ffi.gc(cuts[0], lib.wcut_test_cut_destroy)
    chosen = ffi.new("wcut_calibration_options *", lib.wcut_calibration_options_default())
    fill(chosen, options, "calibrate")
    fit, point = ffi.new("wcut_calibration *"), ffi.new("wcut_calibration_point[]", max(count[0], 1))
    check(lib.wcut_calibration_fit(count[0], held, chosen, fit, point, error), error, str(table))
    law = fit.force
    return ForceLaw(law.a, law.b, law.standard_error[0], law.standard_error[1], (law.low[0], law.high[0]),
                    (law.low[1], law.high[1]), bool(fit.separable), (fit.q_eff_low, fit.q_eff_high))
