"""The C library, its errors as exceptions, and arrays that pass without a copy."""
from __future__ import annotations

import os
from typing import Any, Callable, Iterable, Optional

import numpy as np
from cffi import FFI

from . import _ffi

#: the declarations; Any, since their members are known at run time alone
ffi: Any = _ffi.ffi

SONAME = "libwirecut-io.so.0.1"


class Error(Exception):
    """A call that failed. `status` is the library's word for the kind of failure, "WCUT_BAD_FORMAT"; the text names
    place and expectation."""

    def __init__(self, message: str, status: str = "WCUT_BAD_ARGUMENT") -> None:
        super().__init__(message)
        self.status = status


class InputError(Error, ValueError):
    """An argument, a file or a job that breaks what is asked of it."""


class GeometryError(Error, ValueError):
    """The geometry is degenerate, or a linear system has no unique solution."""


class ConvergenceError(Error, ArithmeticError):
    """The iteration stopped before its tolerance. `partial` holds what was reached, or None."""

    partial: Any = None


class OutputError(Error, OSError):
    """A file is not wholly on disk; the target is as it was."""


class InternalError(Error, RuntimeError):
    """A defect of the library; please report it."""


_KIND = {
    "WCUT_BAD_ARGUMENT": InputError,
    "WCUT_NOT_FOUND": InputError,
    "WCUT_BAD_FORMAT": InputError,
    "WCUT_DEGENERATE": GeometryError,
    "WCUT_SINGULAR": GeometryError,
    "WCUT_NOT_CONVERGED": ConvergenceError,
    "WCUT_NOT_WRITTEN": OutputError,
    "WCUT_INTERNAL": InternalError,
}


def _load() -> Any:
    """The library beside this package in an installed tree, else the one that the system's loader finds."""
    here = os.path.dirname(os.path.abspath(__file__))
    prefix = here
    for _ in range(4):
        prefix = os.path.dirname(prefix)
        for folder in ("lib", os.path.join("lib", "x86_64-linux-gnu"), os.path.join("lib", "aarch64-linux-gnu"), "lib64"):
            path = os.path.join(prefix, folder, SONAME)
            if os.path.exists(path):
                return ffi.dlopen(path)
    try:
        return ffi.dlopen(SONAME)
    except OSError as cause:
        raise ImportError(f"{SONAME} is not found: install Wirecut, or name its folder in LD_LIBRARY_PATH") from cause


lib = _load()


def text_of(chars: Any) -> str:
    """A C string; "" for NULL."""
    return ffi.string(chars).decode("utf-8", "replace") if chars else ""


def name_of(kind: str, value: int) -> str:
    """The name of an enumerator, "WCUT_BAD_FORMAT"."""
    return str(ffi.string(ffi.cast(kind, value)))


def new_error() -> Any:
    return ffi.new("wcut_error *")


def failure(status: int, error: Any = None, place: str = "") -> BaseException:
    """The exception of a status."""
    name = name_of("wcut_status", status)
    text = text_of(error.text) if error is not None and error.text[0] != b"\0" else text_of(lib.wcut_status_text(status))
    message = f"{place}: {text}" if place and not text.startswith(place) else text
    if name == "WCUT_NO_MEMORY":
        return MemoryError(message)
    if name == "WCUT_INTERRUPTED":
        return KeyboardInterrupt(message)
    return _KIND.get(name, InternalError)(message, name)


def check(status: int, error: Any = None, place: str = "") -> None:
    """Raise where a call failed."""
    if status != lib.WCUT_OK:
        raise failure(status, error, place)


def path_of(path: Any) -> bytes:
    """A file's name as the C library takes it."""
    name = os.fsencode(os.fspath(path))
    if b"\0" in name:
        raise InputError("path: found a zero byte, expected a file's name")
    return name


_libc: Any = FFI()
_libc.cdef("void free(void *);")
_free = _libc.dlopen(None).free


def free_text(pointer: Any) -> None:
    """Free a text that the library says is the caller's, to free()."""
    _free(_libc.cast("void *", int(ffi.cast("uintptr_t", pointer))))


# ---- arrays ----------------------------------------------------------------------------------------------------------


class _Memory:
    """C memory as numpy sees it; keeps its owner alive as long as a view does."""

    def __init__(self, owner: Any, address: int, shape: tuple, dtype: Any, strides: Optional[tuple] = None) -> None:
        self.owner = owner
        self.__array_interface__ = {
            "version": 3,
            "data": (address, True),
            "shape": shape,
            "typestr": np.dtype(dtype).str,
            "strides": strides,
        }


def view(owner: Any, pointer: Any, shape: Iterable[int], dtype: Any = np.float64) -> np.ndarray:
    """C memory as a read-only array, without a copy."""
    shape = tuple(int(n) for n in shape)
    if 0 in shape or not pointer:
        return np.empty(shape, dtype)
    return np.asarray(_Memory(owner, int(ffi.cast("uintptr_t", pointer)), shape, dtype))


def field(owner: Any, rows: Any, count: int, ctype: str, name: str, dtype: Any = np.float64) -> np.ndarray:
    """A member of every struct of a C array as a read-only strided array, without a copy."""
    if count == 0:
        return np.empty(0, dtype)
    address = int(ffi.cast("uintptr_t", rows)) + ffi.offsetof(ctype, name)
    return np.asarray(_Memory(owner, address, (int(count),), dtype, (ffi.sizeof(ctype),)))


def reals(values: Any, name: str, dimensions: int = 1) -> np.ndarray:
    """Numbers as a contiguous array of doubles: as it is where it is one, else a copy. Refuses what is no array of
    finite numbers."""
    try:
        array = np.asarray(values)
        if array.dtype.kind not in "fiub":
            raise TypeError
        array = np.ascontiguousarray(array, np.float64)
    except (TypeError, ValueError):
        raise InputError(f"{name}: found {type(values).__name__}, expected numbers") from None
    if array.ndim != dimensions:
        raise InputError(f"{name}: found an array of {array.ndim} dimensions, expected {dimensions}")
    return array


def points(values: Any, name: str = "points") -> np.ndarray:
    """Points as a contiguous array (n, 3) of doubles; any number format and memory order is taken."""
    array = reals(values, name, 2)
    if array.shape[1] != 3:
        raise InputError(f"{name}: found the shape {array.shape}, expected (n, 3)")
    if len(array) > 2**31 - 1:
        raise InputError(f"{name}: found {len(array)} points, expected at most {2**31 - 1}")
    return array


def as_points(array: np.ndarray, writable: bool = False) -> Any:
    """The C pointer to an array of points, borrowed."""
    return ffi.cast("wcut_vec3 *", ffi.from_buffer("double[]", array, require_writable=writable)) if array.size else ffi.NULL


def as_reals(array: np.ndarray, writable: bool = False) -> Any:
    """The C pointer to an array of doubles, borrowed."""
    return ffi.from_buffer("double[]", array, require_writable=writable)


def vector(value: Any, name: str) -> Any:
    """A wcut_vec3 from three numbers."""
    array = reals(value, name)
    if array.shape != (3,):
        raise InputError(f"{name}: found {array.size} numbers, expected 3")
    return ffi.new("wcut_vec3 *", {"x": array[0], "y": array[1], "z": array[2]})[0]


def numbers(value: Any) -> np.ndarray:
    """A wcut_vec3 as an array of three numbers, a copy."""
    return np.array([value.x, value.y, value.z])


def threads_of(threads: Optional[int]) -> int:
    """How many threads a call may use: as many as there are processors unless said otherwise."""
    if threads is None:
        return min(os.cpu_count() or 1, 64)
    if not isinstance(threads, int) or not 1 <= threads <= 4096:
        raise InputError(f"threads: found {threads!r}, expected a whole number from 1 to 4096")
    return threads


# ---- options and progress --------------------------------------------------------------------------------------------


def fill(options: Any, values: dict, place: str) -> Any:
    """Set members of a C options struct by name; an unknown one is refused with the nearest."""
    known = {name: entry for name, entry in ffi.typeof(options).item.fields} if ffi.typeof(options).kind == "pointer" else {}
    for name, value in values.items():
        if name not in known:
            import difflib
            near = difflib.get_close_matches(name, list(known), 1)
            hint = f"; did you mean {near[0]}?" if near else ""
            raise InputError(f"{place}: found the option {name!r}, expected one of {', '.join(sorted(known))}{hint}")
        try:
            setattr(options, name, value)
        except (TypeError, OverflowError) as cause:
            raise InputError(f"{place}: {name}: found {value!r}: {cause}") from None
    return options


Progress = Callable[[int, int], Any]


class Reporter:
    """A C progress function that calls a Python one. Ctrl-C and exceptions end the call and are raised after it."""

    def __init__(self, progress: Optional[Progress]) -> None:
        self.cause: Optional[BaseException] = None

        def step(done: int, total: int, _context: Any) -> int:
            if self.cause is not None:
                return 1
            return 1 if progress is not None and progress(done, total) else 0

        def failed(_kind: Any, value: BaseException, _trace: Any) -> int:
            self.cause = value
            return 1

        self.function = ffi.callback("int(int, int, void *)", step, error=1, onerror=failed)

    def check(self) -> None:
        """Raise what stopped the call, if Python did."""
        if self.cause is not None:
            raise self.cause
