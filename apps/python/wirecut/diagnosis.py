"""What explains the difference between recordings, scans and simulation."""
from __future__ import annotations

import html
import json
from typing import Any, Dict, List, Optional

import numpy as np

from ._core import Progress, Reporter, check, failure, ffi, fill, free_text, lib, new_error, path_of, text_of


class Diagnosis:
    """A diagnosis: `document` is what diagnosis.json holds."""

    def __init__(self, document: Dict[str, Any]) -> None:
        #: the whole of diagnosis.json (FORMATS.md, Diagnosis)
        self.document = document

    @property
    def kind(self) -> str:
        """"physics", "instrument", "both", "none", "ambiguous" or "unknown"."""
        return str(self.document["verdict"]["kind"])

    @property
    def confidence(self) -> float:
        return float(self.document["verdict"]["confidence"])

    @property
    def sentence(self) -> str:
        """One sentence for a machine operator."""
        return str(self.document["verdict"]["sentence"])

    @property
    def effects(self) -> List[Dict[str, Any]]:
        """The effects that the verdict names, each with its parameters and intervals."""
        return [e for e in self.document["effects"] if e["present"]]

    def table(self, held_out: bool = False) -> np.ndarray:
        """RMSE over range of every model and channel: a structured array with the fields model and one a channel."""
        fit = self.document["fit"]["held_out"] if held_out else self.document["fit"]
        models = [m for m in ("before", "recalibrated", "after", "black_box") if isinstance(fit.get(m), dict) and fit[m]]
        channels = ["speed", "tension", "alpha", "beta", "scan"]
        rows = np.full(len(models), np.nan, [("model", "U16")] + [(c, "f8") for c in channels])
        for k, model in enumerate(models):
            rows[k]["model"] = model
            for channel in channels:
                value = (fit[model].get(channel) or {}).get("rmse_over_range")
                rows[k][channel] = np.nan if value is None else value
        return rows

    def __repr__(self) -> str:
        return f"<Diagnosis: {self.kind}, confidence {self.confidence:.2f}: {self.sentence}>"

    def _repr_html_(self) -> str:
        head = f"<p><b>{html.escape(self.kind)}</b>, confidence {self.confidence:.2f}. {html.escape(self.sentence)}</p>"
        rows = "".join(f"<tr><td>{html.escape(e['name'])}</td><td>{html.escape(key)}</td><td>{p['value']}</td><td>{p['ci95']}</td></tr>"
                       for e in self.effects for key, p in e["parameters"].items() if isinstance(p, dict))
        return head + (f"<table><tr><th>effect</th><th>parameter</th><th>value</th><th>95 %</th></tr>{rows}</table>" if rows else "")


def diagnose(case: Any, *, progress: Optional[Progress] = None, **options: Any) -> Diagnosis:
    """Diagnose a case, a case.json. progress(done, total) may end it by a true answer. Options are those of
    wcut_diagnosis_options: threads=, proof=, naive=, seed=.

    KeyboardInterrupt: `partial` holds the Diagnosis of what was found so far, where there is any.
    """
    out, error = ffi.new("wcut_case **"), new_error()
    check(lib.wcut_case_read(path_of(case), out, error), error)
    files = ffi.gc(out[0], lib.wcut_case_destroy)

    def read_recording(path: Any, out: Any, failure: Any) -> Any:
        return lib.wcut_recording_read(path, ffi.addressof(files, "format"), out, failure)

    # the files of every cut
    held: List[Any] = []
    cuts = ffi.new("wcut_diagnosis_cut[]", files.cuts)
    for k in range(files.cuts):
        for member, kind, reader, destroy in (("job", "wcut_job **", lib.wcut_job_read, lib.wcut_job_destroy),
                                              ("recording", "wcut_recording **", read_recording,
                                               lib.wcut_recording_destroy)):
            item = ffi.new(kind)
            check(reader(getattr(files.cut[k], member), item, error), error)
            held.append(ffi.gc(item[0], destroy))
            setattr(cuts[k], member, held[-1])
        if files.cut[k].scan:
            scan = ffi.new("wcut_cloud **")
            check(lib.wcut_cloud_read(files.cut[k].scan, ffi.NULL, scan, error), error)
            held.append(ffi.gc(scan[0], lib.wcut_cloud_destroy))
            cuts[k].scan = held[-1]
    tests, table = ffi.new("int *"), ffi.new("wcut_test_cut **")
    if files.calibration:
        check(lib.wcut_calibration_table_read(files.calibration, ffi.NULL, tests, table, error), error)
        held.append(ffi.gc(table[0], lib.wcut_test_cut_destroy))

    chosen = ffi.new("wcut_diagnosis_options *", lib.wcut_diagnosis_options_default())
    fill(chosen, options, "diagnose")
    reporter, result = Reporter(progress), ffi.new("wcut_diagnosis **")
    status = lib.wcut_diagnosis_create(files.cuts, cuts, tests[0], table[0], chosen, reporter.function, ffi.NULL, result, error)
    found = None
    if result[0]:
        handle, text = ffi.gc(result[0], lib.wcut_diagnosis_destroy), ffi.new("char **")
        check(lib.wcut_diagnosis_print(handle, files.name, text))
        try:
            found = Diagnosis(json.loads(text_of(text[0])))
        finally:
            free_text(text[0])
    if reporter.cause is not None:
        reporter.check()
    if status != lib.WCUT_OK:
        cause = failure(status, error, text_of(files.name))
        cause.partial = found  # type: ignore[attr-defined]
        raise cause
    assert found is not None
    return found
