"""The library that was built with this package, and its constants by name."""

from __future__ import annotations

from collections.abc import Iterable
from importlib import import_module
from typing import Any, Union

from . import choices

# Written when the wheel is built: see build_backend.py.
_native: Any = import_module("gusset_mesh._native")
ffi: Any = _native.ffi
lib: Any = _native.lib
#: The library of readers and writers of files, if they are not in `lib`.
files: Any = getattr(_native, "files", None)

#: Numbers of the interface's index and coordinate types.
F32, F64 = 1, 2


def constants(prefix: str) -> dict[str, int]:
    """Constants that begin with a prefix, by the rest of their names in lower case."""
    return {
        name.removeprefix(prefix).lower(): getattr(lib, name)
        for name in dir(lib)
        if name.startswith(prefix) and isinstance(getattr(lib, name), int)
    }


def one_of(words: dict[str, int], name: str, word: object) -> int:
    """The number of a word."""
    if not isinstance(word, str) or word not in words:
        raise ValueError(f"{name} is {word!r}: there are {', '.join(map(repr, words))}")
    return words[word]


def number_of(choice: str, name: str, word: object) -> int:
    """The number of a word of a choice: ``number_of("gusset_scheme", "scheme", "six_tap")``."""
    return one_of(choices.NUMBERS[choice], name, word)


def bits_of(words: dict[str, int], name: str, given: Union[str, Iterable[object]]) -> int:
    """The sum of the bits of a word or of several."""
    bits = 0
    for word in [given] if isinstance(given, str) else given:
        bits |= one_of(words, name, word)
    return bits


def text(pointer: Any) -> str:
    """The text at a pointer of the library; empty for NULL."""
    return str(ffi.string(pointer).decode("utf-8")) if pointer else ""


def holding(pointer: Any, *things: Any) -> Any:
    """A pointer that keeps things alive."""
    return ffi.gc(pointer, lambda _: things)


STATUSES = {number: name for name, number in constants("GUSSET_ERROR_").items()}
# Statuses of gusset_files.h, which would be other statuses of gusset.h, are negative.
STATUSES |= {-lib.GUSSET_FILES_BAD_ARGUMENT: "bad_argument", -lib.GUSSET_FILES_BAD_FILE: "bad_file"}
ELEMENTS = {number: name for name, number in choices.NUMBERS["gusset_element"].items()}
