"""Arrays as the library reads them."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._library import F32, F64, ffi

SCALARS = {np.dtype(np.float32): F32, np.dtype(np.float64): F64}


def real_array(values: ArrayLike) -> NDArray[Any]:
    """Numbers as an array; the same array where it can be.

    Raises:
        ValueError: the numbers are complex. NumPy would drop the imaginary parts with no more than a warning.
    """
    array = np.asarray(values)
    if array.dtype.kind == "c":
        raise ValueError(f"the numbers are of the type {array.dtype}, not real")
    return array


def real(value: Any) -> float:
    """A real number: see :func:`real_array`."""
    return float(value if isinstance(value, (float, int, str)) else real_array(value))


def floats_of(values: ArrayLike) -> NDArray[Any]:
    """Real numbers as 32- or 64-bit floats; the same array where it can be."""
    array = real_array(values)
    return array if array.dtype in SCALARS else array.astype(np.float64)


def reals_of(values: ArrayLike) -> NDArray[np.float64]:
    """Real numbers as 64-bit floats; the same array where it can be."""
    return np.asarray(floats_of(values), np.float64)


def points_of(values: ArrayLike) -> NDArray[Any]:
    """Points as the library reads them: 32- or 64-bit floats, x, y, z together; the same array where it can be."""
    array = floats_of(values)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"points have the shape {array.shape}, not (n, 3)")
    rows, step = array.strides
    if array.size and (step != array.itemsize or rows < 3 * array.itemsize):
        array = np.ascontiguousarray(array)
    return array


def indices_of(values: ArrayLike, what: str = "indices") -> NDArray[np.uint32]:
    """Whole numbers as 32-bit ones without a sign, in a row; the same array where it can be."""
    array = np.asarray(values)
    if array.dtype == np.int32:
        # A negative one is too large then, which the library says with its place.
        array = array.view(np.uint32) if array.flags.c_contiguous else np.ascontiguousarray(array).view(np.uint32)
    elif array.dtype != np.uint32:
        if array.size and array.dtype.kind not in "iu":
            raise ValueError(f"{what} are of the type {array.dtype}, not whole numbers")
        if array.size and (array.min() < 0 or array.max() >= 2**32):
            bad = int(np.flatnonzero((array < 0) | (array >= 2**32))[0])
            raise ValueError(f"{what}: number {bad} is {array.flat[bad]}, not an index from 0 to 2^32 - 1")
        array = array.astype(np.uint32)
    return np.ascontiguousarray(array)


def pointer(array: Optional[NDArray[Any]]) -> Any:
    """Where an array is; NULL for none."""
    return ffi.NULL if array is None else ffi.cast("void *", array.__array_interface__["data"][0])
