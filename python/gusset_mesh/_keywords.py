"""Structs of options from keywords."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ._library import ffi, holding
from ._options import FIELDS
from ._records import indices_struct
from .mesh import indices_of, pointer


def _array(struct: Any, field: str, value: Any, kept: list[Any]) -> None:
    """An array of numbers or of structs, and how many there are."""
    ctype = dict(ffi.typeof(struct).item.fields)[field].type
    if ctype.kind == "struct":  # gusset_indices
        array = indices_of(value, field).reshape(-1)
        setattr(struct, field, indices_struct(array))
        kept.append(array)
        return
    item = ctype.item
    if item.kind == "struct":
        made = ffi.new(f"{item.cname}[]", [one if isinstance(one, dict) else _fields(item, one) for one in value])
        count = len(made)
    else:
        dtype = {"double": np.float64, "uint32_t": np.uint32, "uint8_t": np.uint8}[item.cname]
        array = indices_of(value, field).reshape(-1) if dtype == np.uint32 else np.ascontiguousarray(value, dtype)
        made, count = ffi.cast(f"{item.cname} *", pointer(array)), len(array)
        kept.append(array)
    kept.append(made)
    setattr(struct, field, made)
    name = next((f"{stem}_count" for stem in (field.removesuffix("s"), field) if hasattr(struct, f"{stem}_count")), None)
    if name:
        setattr(struct, name, count)


def _fields(item: Any, value: Any) -> Any:
    """What a struct of numbers begins with: a matrix fills the array that it has."""
    fields = [field for name, field in item.fields if name not in ("struct_size", "reserved")]
    if len(fields) == 1 and fields[0].type.kind == "array":
        return [np.asarray(value, np.float64).reshape(-1)[: fields[0].type.length].tolist()]
    return list(value)


def options(name: str, keywords: Mapping[str, Any]) -> Any:
    """A struct of options; NULL for the defaults.

    Raises:
        TypeError: there is no such keyword.
        ValueError: a keyword has no such word.
    """
    if not keywords:
        return ffi.NULL
    fields = FIELDS[f"gusset_{name}"]
    struct = ffi.new(f"struct gusset_{name} *")
    struct.struct_size = ffi.sizeof(f"struct gusset_{name}")
    kept: list[Any] = []
    for keyword, value in keywords.items():
        if keyword not in fields:
            raise TypeError(f"no option {keyword!r}: there are {', '.join(fields)}")
        if value is None:
            continue
        what, words, needs = fields[keyword]
        if needs and needs[0] not in keywords:
            # A length that is read in one mode only asks for that mode.
            setattr(struct, needs[0], fields[needs[0]][1].get(needs[1], 1))
        if what == "choice":
            if value not in words:
                raise ValueError(f"{keyword} is {value!r}: there are {', '.join(map(repr, words))}")
            setattr(struct, keyword, words[value])
        elif what.startswith("options:"):
            inner = options(_struct_of(struct, keyword), value)
            kept.append(inner)
            setattr(struct, keyword, inner)
        elif what == "array":
            _array(struct, keyword, value, kept)
        elif what == "row":
            setattr(struct, keyword, list(value))
        else:
            setattr(struct, keyword, bool(value) if what == "flag" else value)
    # What the struct points to lives as long as it does.
    return holding(struct, kept) if kept else struct


def _struct_of(struct: Any, field: str) -> str:
    return str(dict(ffi.typeof(struct).item.fields)[field].type.item.cname).removeprefix("struct gusset_")
