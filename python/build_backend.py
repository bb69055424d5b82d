"""Builds the wheel by maturin, after writing the declarations of the headers where maturin looks for them: target/header.h."""

import os
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent


def declarations(header):
    """The declarations of a header in C99, for cffi, which has no preprocessor: constants, types and functions."""
    kept, taken = [], []
    for line in header.splitlines():
        if line.startswith("#"):
            directive = line[1:].split()[0]
            # Nothing is defined: it is C, of no compiler, on no system.
            if directive in ("if", "ifdef", "ifndef"):
                taken.append(directive == "ifndef")
            elif directive == "else":
                taken[-1] = not taken[-1]
            elif directive == "endif":
                taken.pop()
            elif all(taken) and re.fullmatch(r"#define GUSSET_\w+ -?\d+", line):
                kept.append(line)
        elif all(taken) and not line.lstrip().startswith("///"):
            kept.append(re.sub(r"\bGUSSET_(FILES_|PLUGIN_)?(API|MUST_USE)\b", "", line))
    return "\n".join(kept) + "\n"


def all_declarations():
    include = ROOT / "include"
    parts = re.findall(r'#include "(gusset/\w+\.h)"', (include / "gusset.h").read_text("utf-8"))
    parts.remove("gusset/views.h")  # functions with bodies
    return "".join(declarations((include / name).read_text("utf-8")) for name in [*parts, "gusset_plugin.h", "gusset_files.h"])


def prepare():
    target = pathlib.Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    target.mkdir(parents=True, exist_ok=True)
    (target / "header.h").write_text(all_declarations(), "utf-8")


def build_wheel(*arguments, **keywords):
    import maturin
    prepare()
    return maturin.build_wheel(*arguments, **keywords)


def build_editable(*arguments, **keywords):
    import maturin
    prepare()
    return maturin.build_editable(*arguments, **keywords)


def __getattr__(name):
    import maturin
    return getattr(maturin, name)


def native(library, folder, files_library=None):
    """Writes the package _native as maturin does, for a library that is built already.

    If the library was built without the feature `files`, readers and writers of files come from files_library.
    """
    import cffi
    from cffi import recompiler
    libraries = {"lib": library, **({"files": files_library} if files_library else {})}
    folder = pathlib.Path(folder) / "_native"
    folder.mkdir(parents=True, exist_ok=True)
    ffi = cffi.FFI()
    ffi.cdef(all_declarations())
    recompiler.make_py_source(ffi, "ffi", str(folder / "ffi.py"))
    opened = "".join(f"{name} = ffi.dlopen({str(pathlib.Path(path).absolute())!r})\n" for name, path in libraries.items())
    (folder / "__init__.py").write_text(f"from .ffi import ffi\n\n{opened}", "utf-8")


if __name__ == "__main__":
    import sys
    native(*sys.argv[1:])
