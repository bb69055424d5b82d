"""Structs of options from keywords."""

from __future__ import annotations

import operator
from collections.abc import Mapping
from typing import Any

import numpy as np

from ._arrays import indices_of, pointer, real, real_array, reals_of
from ._library import bits_of, ffi, holding, one_of
from ._options import FIELDS
from ._records import dtype_of, indices_struct


def _array(struct: Any, field: str, value: Any, shape: tuple[str, ...], kept: list[Any], lengths: Mapping[str, int]) -> None:
    """Sets an array of numbers or of structs, and the field that counts it."""
    ctype = dict(ffi.typeof(struct).item.fields)[field].type
    if ctype.kind == "struct":  # gusset_indices
        array = indices_of(value, field).reshape(-1)
        setattr(struct, field, indices_struct(array))
        kept.append(array)
        return
    item, counter, inner = ctype.item, shape[0], tuple(map(int, shape[1:]))
    if item.kind == "struct":
        made = ffi.new(f"{item.cname}[]", [one if isinstance(one, dict) else _fields(item, one) for one in value])
        count = len(made)
    else:
        dtype = dtype_of(item)
        numbers: Any = indices_of(value, field).reshape(-1) if dtype == np.uint32 else np.ascontiguousarray(real_array(value), dtype)
        if numbers.shape[1:] != inner or numbers.ndim == 0:
            raise ValueError(f"{field} have the shape {numbers.shape}, not ({', '.join(['n', *shape[1:]])})")
        made, count = ffi.cast(f"{item.cname} *", pointer(numbers)), len(numbers)
        kept.append(numbers)
    kept.append(made)
    setattr(struct, field, made)
    if hasattr(struct, counter):
        setattr(struct, counter, count)
    elif count != lengths.get(counter, 0):
        # An argument of the function counts the array.
        raise ValueError(f"{field} are {count}, not {lengths.get(counter, 0)}")


def _paths(value: Any) -> Any:
    """Paths as one list and the start of each; one path, or a sequence of paths."""
    items = list(value)
    if not items or np.ndim(items[0]) == 0:
        return items, None
    return np.concatenate([np.asarray(one) for one in items]), np.cumsum([0, *map(len, items)])


def _number(keyword: str, what: str, value: Any) -> Any:
    """Converts a number or a flag."""
    if what == "flag":
        if isinstance(value, (bool, np.bool_)) or (isinstance(value, (int, np.integer)) and value in (0, 1)):
            return int(value)
        raise TypeError(f"{keyword} is {value!r}: pass True or False")
    try:
        return real(value) if what == "float" and not isinstance(value, str) else operator.index(value)
    except TypeError:
        raise TypeError(f"{keyword} is {value!r}: pass {'a number' if what == 'float' else 'an integer'}") from None


def _fields(item: Any, value: Any) -> Any:
    """The first fields of a struct of numbers. A matrix fills the only field of a struct."""
    fields = [field for name, field in item.fields if name not in ("struct_size", "reserved")]
    if len(fields) == 1 and fields[0].type.kind == "array":
        return [reals_of(value).reshape(-1)[: fields[0].type.length].tolist()]
    return list(value)


def options(name: str, keywords: Mapping[str, Any], lengths: Mapping[str, int] = {}) -> Any:
    """Makes a struct of options; NULL for the defaults.

    Args:
        lengths: the arguments of the function that count arrays of the options, as ``{"loop_count": 2}``.

    Raises:
        TypeError: a keyword is unknown.
        ValueError: a word of a keyword is unknown.
    """
    if not keywords:
        return ffi.NULL
    fields = FIELDS[f"gusset_{name}"]
    struct = ffi.new(f"struct gusset_{name} *")
    struct.struct_size = ffi.sizeof(f"struct gusset_{name}")
    kept: list[Any] = []
    keywords = dict(keywords)
    if "cuts" in keywords and "cut_offsets" not in keywords and keywords["cuts"] is not None:
        keywords["cuts"], keywords["cut_offsets"] = _paths(keywords["cuts"])
    for keyword, value in keywords.items():
        if keyword not in fields:
            groups = [field for field in fields if fields[field][0] == "options" and keyword in _fields_of(struct, field)]
            known = " or ".join(f"{group}={{{keyword!r}: ...}}" for group in groups)
            raise TypeError(f"no option {keyword!r}: pass {known}" if known else f"no option {keyword!r}: there are {', '.join(fields)}")
        if value is None:
            continue
        kind, words, needs, shape = fields[keyword]
        if needs and needs[0] not in keywords:
            # A field that is read in one mode only selects this mode.
            setattr(struct, needs[0], fields[needs[0]].words.get(needs[1], 1))
        if kind == "choice":
            setattr(struct, keyword, one_of(words, keyword, value))
        elif kind == "bits":
            setattr(struct, keyword, bits_of(words, keyword, value))
        elif kind == "options":
            if not isinstance(value, Mapping):
                raise TypeError(f"{keyword} is {value!r}: pass a dictionary of options")
            inner = options(_struct_of(struct, keyword), value)
            kept.append(inner)
            setattr(struct, keyword, inner)
        elif kind == "array":
            _array(struct, keyword, value, shape, kept, lengths)
        else:
            try:
                setattr(struct, keyword, list(value) if kind == "row" else _number(keyword, kind, value))
            except (OverflowError, IndexError):
                raise ValueError(f"{keyword} is {value!r}, which is out of range") from None
    # The struct keeps alive what it points to.
    return holding(struct, kept) if kept else struct


def _fields_of(struct: Any, field: str) -> Any:
    """The options that a group of options has."""
    return FIELDS[f"gusset_{_struct_of(struct, field)}"]


def _struct_of(struct: Any, field: str) -> str:
    return str(dict(ffi.typeof(struct).item.fields)[field].type.item.cname).removeprefix("struct gusset_")
