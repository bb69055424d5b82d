"""Structs of the library as Python objects: numbers, texts, arrays without a copy, and structs again."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._library import ffi, text
from .errors import error

_DTYPES = {
    "double": np.float64, "float": np.float32, "uint8_t": np.uint8, "uint16_t": np.uint16, "uint32_t": np.uint32,
    "uint64_t": np.uint64, "int32_t": np.int32, "int64_t": np.int64, "size_t": np.uintp, "int": np.intc,
}
_THIRD = (lambda s: (s.parents.count // 3, 3))
_PLACES = (lambda s: (s.point_count,))
#: The shapes of arrays that no field beside them counts, or whose elements have several numbers.
_SHAPES: dict[str, dict[str, Callable[[Any], tuple[int, ...]]]] = {
    "gusset_curve_form_view": {"points": lambda s: (s.point_count, 3), "on_curve": _PLACES},
    "gusset_curve_view": {"controls": lambda s: (s.control_count, 3)},
    "gusset_develop_report": {"stretches": lambda s: (s.face_charts.count, 2), "points": lambda s: (s.vertex_map.count, 2)},
    "gusset_fill_report": {"weights": _THIRD},
    "gusset_net_mesh_report": {"texture_coordinates": lambda s: (s.texture_count, 2)},
    "gusset_sheet_report": {"knots_u": lambda s: (s.rows + 1,), "knots_v": lambda s: (s.columns + 1,)},
    "gusset_frame_view": {
        **dict.fromkeys(("nodes", "across", "along"), lambda s: (s.rows, s.columns, 3)), "turned": lambda s: (s.rows,),
    },
    "gusset_loop_view": {"edge_flags": lambda s: (s.half_edges.count,)},
    "gusset_orient_report": {"turned": lambda s: (s.face_count,)},
    "gusset_origins_view": {"weights": lambda s: (s.sources.count,)},
    "gusset_outline_view": {
        "controls": lambda s: (s.control_count, 3), "starts": lambda s: (2 * s.outline_count + 2,),
        "parameters": _PLACES, "statuses": _PLACES,
    },
    "gusset_places_view": {"points": lambda s: (s.count, 3), "overlaps": lambda s: (s.overlap_count, 4)},
    "gusset_sheet_mesh_report": {"places": lambda s: (s.vertex_count,), "normals": lambda s: (s.vertex_count, 3)},
    "gusset_stitch_report": {"weights": _THIRD},
    "gusset_strip_report": {"weights": lambda s: (s.parents.count // 2,)},
    "gusset_surface_hits_view": {"ends": lambda s: (s.query_count + 1,), "on_curve": lambda s: (s.on_curve_count // 3, 3)},
    "gusset_surface_paths_view": {
        **dict.fromkeys(("closed", "levels"), lambda s: (s.path_count,)),
        **dict.fromkeys(("points", "normals"), lambda s: (s.point_count, 3)),
        **dict.fromkeys(("places", "others"), _PLACES),
    },
}
_HIDDEN = {"struct_size", "reserved"}
#: Of a net: its nodes have strides, and Net.nodes has them.
_UNTOLD = {"gusset_net_view": {"x", "y", "z"}}


class _Lent:
    """What numpy makes an array of that keeps what owns its memory."""

    __slots__ = ("__array_interface__", "owner")

    def __init__(self, pointer: Any, shape: tuple[int, ...], dtype: np.dtype[Any], owner: object):
        address = int(ffi.cast("uintptr_t", pointer))
        self.__array_interface__ = {"data": (address, True), "shape": shape, "typestr": dtype.str, "version": 3}
        self.owner = owner


def lent(pointer: Any, shape: tuple[int, ...], dtype: Any, owner: object) -> NDArray[Any]:
    """An array that reads the library's memory, which lives as long as the array; it cannot be written to."""
    dtype = np.dtype(dtype)
    if not pointer or 0 in shape:
        return np.empty(shape, dtype)
    # The names of fields do not go that way.
    array = np.asarray(_Lent(pointer, shape, dtype, owner))
    return array if dtype.names is None else array.view(dtype)


def indices(struct: Any, owner: object) -> NDArray[np.uint32]:
    """The numbers of a gusset_indices."""
    return lent(struct.data, (struct.count,), np.uint32, owner)


def indices_struct(array: NDArray[np.uint32]) -> Any:
    """A gusset_indices of an array, which must stay alive."""
    return {"data": ffi.cast("uint32_t *", array.ctypes.data), "count": array.size}


def dtype_of(ctype: Any) -> np.dtype[Any]:
    """The numpy type of a C type of numbers or of a struct of numbers, with its padding."""
    if ctype.kind == "enum":
        return np.dtype(np.uint32)
    if ctype.kind == "primitive":
        return np.dtype(_DTYPES[ctype.cname])
    if ctype.kind == "array":
        return np.dtype((dtype_of(ctype.item), (ctype.length,)))
    fields = [(name, field) for name, field in ctype.fields if name not in _HIDDEN]
    return np.dtype({
        "names": [name for name, _ in fields],
        "formats": [dtype_of(field.type) for _, field in fields],
        "offsets": [field.offset for _, field in fields],
        "itemsize": ffi.sizeof(ctype),
    })


def is_plain(ctype: Any) -> bool:
    """Whether numbers are all that is in it."""
    if ctype.kind == "array":
        return is_plain(ctype.item)
    if ctype.kind == "struct":
        return all(is_plain(field.type) for _, field in ctype.fields)
    return bool(ctype.kind in ("primitive", "enum"))


def _count(fields: dict[str, Any], name: str) -> str:
    """The field that counts the elements of an array."""
    for stem in (name, name.removesuffix("s"), name.removesuffix("ies") + "y", name.removesuffix("ces") + "x", name.rpartition("_")[2].removesuffix("s")):
        if f"{stem}_count" in fields:
            return f"{stem}_count"
    if "count" in fields:
        return "count"
    raise AttributeError(f"nothing counts {name}")


class Record:
    """A struct that the library filled: attributes are named as its fields are in ``gusset.h``.

    Arrays are not copied, cannot be written to, and keep what they are read from.
    """

    __slots__ = ("_struct", "_fields", "_owner", "_shapes")

    def __init__(self, struct: Any, owner: object = None):
        ctype = ffi.typeof(struct)
        self._struct = struct
        self._fields = dict(ctype.fields)
        self._owner = owner
        self._shapes = _SHAPES.get(ctype.cname.removeprefix("struct "), {})

    def __reduce__(self) -> Any:
        raise TypeError("a Record stays in its process: send its numbers and arrays")

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        field = self._fields.get(name)
        if field is None or name in _HIDDEN:
            raise AttributeError(f"no {name}; there are {', '.join(self)}")
        value, ctype = getattr(self._struct, name), field.type
        if ctype.kind == "primitive" or ctype.kind == "enum":
            return int(value) if ctype.kind == "enum" else value
        if ctype.kind == "array":
            if is_plain(ctype.item) and ctype.item.kind != "struct":
                return np.array(ffi.unpack(value, ctype.length) if ctype.item.kind != "array" else [list(row) for row in value])
            return [self._struct_field(one) for one in value]
        if ctype.kind == "struct":
            return self._struct_field(value)
        if ctype.item.cname == "char":
            return text(value)
        return self._array(name, value, ctype.item)

    def _struct_field(self, value: Any) -> Any:
        is_list = ffi.typeof(value).cname.startswith("struct gusset_indices")
        return indices(value, self._owner) if is_list else Record(value, self._owner)

    def _array(self, name: str, pointer: Any, item: Any) -> Any:
        shape = self._shapes[name](self._struct) if name in self._shapes else (getattr(self._struct, _count(self._fields, name)),)
        if is_plain(item):
            # NULL stands for none of what is optional.
            return lent(pointer, shape if pointer else (0, *shape[1:]), dtype_of(item), self._owner)
        return [Record(pointer[k], self._owner) for k in range(shape[0])]

    def __iter__(self) -> Iterator[str]:
        untold = _UNTOLD.get(ffi.typeof(self._struct).cname.removeprefix("struct "), set())
        return (name for name in self._fields if name not in _HIDDEN | untold)

    def __dir__(self) -> list[str]:
        return list(self)

    def __repr__(self) -> str:
        def short(value: Any) -> str:
            if isinstance(value, np.ndarray) and value.size > 8:
                return f"<{'x'.join(map(str, value.shape))} {value.dtype.name if value.dtype.names is None else 'records'}>"
            return f"<{len(value)} records>" if isinstance(value, list) and len(value) > 2 else repr(value)

        return f"Record({', '.join(f'{name}={short(getattr(self, name))}' for name in self)})"


def filled(function: Any, struct: str, handle: Any) -> Record:
    """What a function of a handle tells in a struct that has struct_size.

    Arrays keep the handle, not the object that has it: a ring through an array would never be collected.
    """
    made = ffi.new(f"struct {struct} *")
    made.struct_size = ffi.sizeof(f"struct {struct}")
    status = function(handle, made)
    if status != 0:
        raise error(status, "")
    return Record(made[0], (made, handle))
