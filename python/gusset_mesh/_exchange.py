"""Converts numbers, arrays and structs for calls, and makes those that a call fills."""

from __future__ import annotations

import operator
from collections.abc import Sequence
from typing import Any, Optional, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import pointer, reals_of
from ._call import Progress, call
from ._library import ffi
from ._records import Record, RecordArray, dtype_of
from ._reports import PlaceArray

R = TypeVar("R", bound=Record)
A = TypeVar("A", bound=RecordArray[Any])
#: Places on a curve: of the library, or numbers ``segment + t``.
CurvePlaces = Union[PlaceArray, ArrayLike]

LINE = dtype_of(ffi.typeof("struct gusset_line"))


def vector(values: ArrayLike, name: str = "vector") -> list[float]:
    """Returns three numbers."""
    array = reals_of(values)
    if array.shape != (3,):
        raise ValueError(f"{name} has the shape {array.shape}, not (3,)")
    numbers: list[float] = array.tolist()
    return numbers


def index(value: Any, name: str, bits: int = 32) -> int:
    """Returns a whole number that fits an unsigned integer of C."""
    number = operator.index(value)
    if not 0 <= number < 2**bits:
        raise ValueError(f"{name} is {number}, which is not from 0 to 2^{bits} - 1")
    return number


def numbers(values: ArrayLike, shape: tuple[int, ...], name: str) -> NDArray[np.float64]:
    """Returns packed 64-bit floats of a shape, in which -1 is any length. Copies only if necessary."""
    array = np.ascontiguousarray(reals_of(values))
    if array.ndim != len(shape) or any(wanted not in (-1, got) for wanted, got in zip(shape, array.shape)):
        wanted_shape = ", ".join("n" if one < 0 else str(one) for one in shape)
        raise ValueError(f"{name} have the shape {array.shape}, not ({wanted_shape}{',' if len(shape) == 1 else ''})")
    return array


def curve_places(values: CurvePlaces) -> PlaceArray:
    """Returns places on a curve, packed."""
    if isinstance(values, PlaceArray):
        return PlaceArray(np.ascontiguousarray(values.array).reshape(-1))
    given = reals_of(values).reshape(-1)
    is_place = (given >= 0) & (given < 2**32)
    if not is_place.all():
        bad = int(np.flatnonzero(~is_place)[0])
        raise ValueError(f"place {bad} on the curve is {given[bad]}, not segment + t, from 0 to the number of segments")
    out = PlaceArray.zeros(given.size)
    out.array["segment"], out.array["t"] = np.floor(given), given - np.floor(given)
    return out


def lines_of(origins: ArrayLike, directions: ArrayLike, start: Any, end: Any) -> NDArray[Any]:
    """Makes lines, rays or segments from (n, 3) origins and directions, which are broadcast, and from a range of parameters."""
    starts, along = (np.atleast_2d(reals_of(one)) for one in (origins, directions))
    if starts.ndim != 2 or starts.shape[1] != 3 or along.ndim != 2 or along.shape[1] != 3:
        raise ValueError(f"origins and directions have the shapes {starts.shape} and {along.shape}, not (n, 3)")
    starts, along = np.broadcast_arrays(starts, along)
    lines = np.zeros(len(starts), LINE)
    lines["origin"], lines["direction"], lines["from"], lines["to"] = starts, along, start, end
    return lines


def sized(struct: str, **fields: Any) -> Any:
    """Makes a struct that begins with its size."""
    return ffi.new(f"struct {struct} *", {"struct_size": ffi.sizeof(f"struct {struct}"), **fields})


def answer(kind: type[R], function: Any, *arguments: Any, threads: int = 0, progress: Optional[Progress] = None) -> R:
    """Calls a function whose last argument is a report, and returns the report."""
    made = kind.new()
    call(function, *arguments, made._struct, threads=threads, progress=progress)
    return made


def listed(kind: type[A], function: Any, *arguments: Any) -> A:
    """Calls a function that lists structs: first for their number, then for the structs."""
    written = ffi.new("size_t *")
    call(function, *arguments, ffi.NULL, 0, written)
    out = kind.zeros(written[0])
    if len(out):
        call(function, *arguments, out.pointer(), len(out), written)
    return out


def handle_of(kind: str, given: Any) -> Any:
    """Returns the handle of an object of a kind."""
    handle = getattr(given, "_handle", None)
    if handle is None or ffi.typeof(handle) is not ffi.typeof(f"struct gusset_{kind} *"):
        raise TypeError(f"a {kind} is wanted, not a {type(given).__name__}")
    return handle


def handles_of(kind: str, given: Sequence[Any]) -> Any:
    """Makes an array of handles. The objects must outlive the array."""
    return ffi.new(f"struct gusset_{kind} *[]", [handle_of(kind, one) for one in given] or 1)
