#!/usr/bin/env python3
"""Make wirecut/_ffi.py, the declarations of the C library, from its public headers.

    python3 apps/python/generate.py [--check] [--cc CC]

Every function, type and enumerator of wirecut/wirecut.h is taken, none is written by hand. Needs a C preprocessor and
python3-cffi; the result needs cffi alone. --check compares with the file that is there and ends with 1 where it differs.
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile

import cffi

HERE = os.path.dirname(os.path.abspath(__file__))
HEADERS = os.path.join(HERE, "..", "..", "kernel", "include")
TARGET = os.path.join(HERE, "wirecut", "_ffi.py")

# C headers whose types cffi knows by itself
KNOWN_HEADERS = ["stddef.h", "stdint.h", "stdbool.h", "stdio.h", "math.h"]


def preprocess(compiler):
    """The text of the public headers, macros expanded, comments gone."""
    with tempfile.TemporaryDirectory() as empty:
        for name in KNOWN_HEADERS:
            open(os.path.join(empty, name), "w").close()
        text = subprocess.run(
            [compiler, "-E", "-P", "-nostdinc", "-I", empty, "-I", HEADERS, "-Dbool=_Bool",
             os.path.join(HEADERS, "wirecut", "wirecut.h")],
            check=True, stdout=subprocess.PIPE, text=True).stdout
    return re.sub(r'__attribute__\(\([^)]*\("[a-z]*"\)\)\)\s*', "", text)


def declared_functions(text):
    """Names of the functions that a text of declarations has."""
    return sorted(set(re.findall(r"\b(wcut_[a-z0-9_]+)\s*\([^;{]*\)\s*;", text)))


def made_for_python(text):
    """The text of wirecut/_ffi.py."""
    builder = cffi.FFI()
    builder.cdef(text)
    builder.set_source("wirecut._ffi", None)
    with tempfile.TemporaryDirectory() as folder:
        fresh = os.path.join(folder, "_ffi.py")
        builder.emit_python_code(fresh)
        with open(fresh, encoding="ascii") as file:
            return "# mypy: ignore-errors\n" + file.read()


def run(description, target, make, command):
    """Write what `make` gives for the declarations to the target, or with --check compare the two; gives an exit code."""
    parser = argparse.ArgumentParser(description=description.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    parser.add_argument("--cc", default="cc", help="the C compiler whose preprocessor is used")
    options = parser.parse_args()
    text = preprocess(options.cc)
    made = make(text)
    if not options.check:
        with open(target, "w", encoding="ascii") as file:
            file.write(made)
        print(f"{len(declared_functions(text))} functions")
        return 0
    with open(target, encoding="ascii") as file:
        if file.read() == made:
            return 0
    print(f"{target}: differs from the public headers: run {command}")
    return 1


if __name__ == "__main__":
    sys.exit(run(__doc__, TARGET, made_for_python, "python3 apps/python/generate.py"))
