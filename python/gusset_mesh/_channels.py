"""Values of the elements of several inputs, as the library takes them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Optional

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import pointer
from ._library import ffi, number_of
from .choices import NUMBERS, Domain, Rule

_TYPES = {np.dtype(f"{word[0]}{int(word[1:]) // 8}"): number for word, number in NUMBERS["gusset_value_type"].items()}
#: Other types go the way of these, which hold them exactly; whole numbers up to 2^53.
_BY_WAY_OF = {"i": np.float64, "u": np.float64, "f": np.float64, "b": np.uint8}


def carried(
    apply: Callable[[Any, Any, int, Any, int], None], struct: str, values: Sequence[Optional[ArrayLike]], count: int, domain: Domain,
    rule: Rule, max_influences: int = 0
) -> NDArray[Any]:
    """The values of ``count`` elements of a result.

    Args:
        apply: takes a channel, the inputs' values and their number, room for the result and the number of its elements.
        struct: what the structs' names begin with: the plugin's are the same as the library's.
        values: one array for each input, or None.
    """
    arrays = [None if one is None else np.asarray(one) for one in values]
    given = [one for one in arrays if one is not None]
    if not given:
        raise ValueError("no input has values: give an array for at least one")
    dtype, shape = np.result_type(*given), given[0].shape[1:]
    if any(one.shape[1:] != shape for one in given):
        raise ValueError(f"values of the inputs have the shapes {', '.join(str(one.shape) for one in given)}: all but the first number must agree")
    if dtype not in _TYPES and dtype.kind not in _BY_WAY_OF:
        raise ValueError(f"values have the type {dtype}, which cannot be mixed: convert them to numbers")
    numbers = [number_of("gusset_domain", "domain", domain), number_of("gusset_rule", "rule", rule)]
    if rule == "nearest" and dtype.itemsize == 8 and dtype not in _TYPES and dtype.kind in "iu":
        # Nothing is mixed: the halves of a wide number go along as two.
        halves = [None if one is None else np.ascontiguousarray(one, dtype).view(np.uint32).reshape(len(one), -1) for one in arrays]
        out = carried(apply, struct, halves, count, domain, rule)
        return out.view(dtype).reshape(count, *shape)
    used = dtype if dtype in _TYPES else np.dtype(_BY_WAY_OF[dtype.kind])
    packed = [None if one is None else np.ascontiguousarray(one, used) for one in arrays]
    if dtype.kind in "iu" and used == np.float64 and any(one is not None and one.size and np.abs(one).max() > 2**53 for one in packed):
        raise ValueError("whole numbers beyond 2^53 cannot be mixed: carry them by the rule 'nearest'")
    inputs = ffi.new(f"struct {struct}_channel_values[]", max(len(packed), 1))
    for k, one in enumerate(packed):
        if one is not None:
            inputs[k].values, inputs[k].count = pointer(one), len(one)
    channel = ffi.new(f"struct {struct}_channel *")
    channel.struct_size = ffi.sizeof(f"struct {struct}_channel")
    channel.domain, channel.value_type, channel.rule = numbers[0], _TYPES[used], numbers[1]
    channel.components = int(np.prod(shape, dtype=np.int64))
    channel.max_influences = max_influences
    out = np.zeros((count, *shape), used)
    apply(channel, inputs, len(packed), pointer(out), count)
    if dtype == used:
        return out
    return np.rint(out).astype(dtype) if dtype.kind in "iu" else out.astype(dtype)
