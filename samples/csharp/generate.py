#!/usr/bin/env python3
"""Make Native.cs, the declarations of the C library for C#, from its public headers.

    python3 samples/csharp/generate.py [--check] [--cc CC]

Every function, struct and enumerator is taken, none is written by hand. Structs are blittable: an array of Point3d, or of
any other struct of three doubles, passes as it is. --check compares with the file that is there.
"""
import os
import sys

import cffi

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "apps", "python"))
import generate  # noqa: E402  the same declarations as the Python package's

TARGET = os.path.join(HERE, "Native.cs")
PRIMITIVE = {"int": "int", "double": "double", "float": "float", "char": "byte", "unsigned char": "byte", "_Bool": "byte",
             "unsigned int": "uint", "long": "long", "unsigned long": "ulong", "unsigned long long": "ulong", "long long": "long",
             "int64_t": "long", "uint64_t": "ulong", "uint32_t": "uint", "int32_t": "int", "size_t": "UIntPtr", "short": "short",
             "unsigned short": "ushort", "signed char": "sbyte"}
RESERVED = {"base", "in", "out", "fixed", "object", "string", "ref", "params", "lock", "event", "is", "as", "checked", "operator"}


def name_of(name):
    return "@" + name if name in RESERVED else name


class Writer:
    def __init__(self):
        self.structs = {}
        self.enums = {}

    def type_of(self, ctype):
        """The C# type of a C type."""
        kind = ctype.kind
        if kind == "primitive":
            return PRIMITIVE[ctype.cname]
        if kind == "enum":
            self.enums[ctype.cname] = ctype
            return ctype.cname
        if kind == "void":
            return "void"
        if kind == "struct":
            if ctype.fields is None:
                return "void"
            self.structs.setdefault(ctype.cname, ctype)
            return ctype.cname
        if kind == "pointer":
            item = ctype.item
            return "IntPtr" if item.kind == "function" else self.type_of(item) + "*"
        if kind == "array":
            return self.type_of(ctype.item) + "*"
        if kind == "function":
            return "IntPtr"
        raise SystemExit(f"no C# type for {ctype.cname}")

    def members(self, ctype):
        """Lines of a struct's members."""
        for name, field in ctype.fields:
            kind = field.type
            if kind.kind != "array":
                yield f"    public {self.type_of(kind)} {name_of(name)};"
                continue
            count, item = 1, kind
            while item.kind == "array":
                count, item = count * item.length, item.item
            if item.kind == "primitive":
                yield f"    public fixed {self.type_of(item)} {name_of(name)}[{count}];"
            else:
                yield "    public " + self.type_of(item) + " " + ", ".join(f"{name}_{k}" for k in range(count)) + ";"

    def function(self, name, ctype):
        arguments = ", ".join(f"{self.type_of(a)} a{k}" for k, a in enumerate(ctype.args))
        return f'    [DllImport("wirecut-io")] public static extern {self.type_of(ctype.result)} {name}({arguments});'


def make(text):
    builder = cffi.FFI()
    builder.cdef(text)
    writer = Writer()
    functions = []
    for name in generate.declared_functions(text):
        functions.append(writer.function(name, function_type(builder, name)))
    structs, done = [], set()
    while len(done) < len(writer.structs):
        for name, ctype in list(writer.structs.items()):
            if name in done:
                continue
            done.add(name)
            structs.append((name, "\n".join(["[StructLayout(LayoutKind.Sequential)]", f"public unsafe struct {name}", "{",
                                             *writer.members(ctype), "}"])))
    enums = ["public enum " + name + " { " + ", ".join(f"{word} = {value}" for word, value in sorted(
        ctype.relements.items(), key=lambda item: item[1])) + " }" for name, ctype in sorted(writer.enums.items())]
    return "\n".join([
        "// Made by generate.py from the public headers: every function of libwirecut-io and libwirecut.",
        "using System;", "using System.Runtime.InteropServices;", "", *enums, "",
        *(text for _, text in sorted(structs)), "", "public static unsafe class Native", "{", *functions, "}", ""])


def function_type(builder, name):
    """The type of a declared function."""
    with builder._lock:
        return builder._get_cached_btype(builder._parser._declarations["function " + name][0])


if __name__ == "__main__":
    sys.exit(generate.run(__doc__, TARGET, make, "python3 samples/csharp/generate.py"))
