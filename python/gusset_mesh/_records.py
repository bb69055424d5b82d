"""Base classes of the structs in ``_reports``."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import Any, ClassVar, Generic, Optional, TypeVar, Union, overload

import numpy as np
from numpy.typing import NDArray

from . import choices
from ._library import ffi, lib, number_of
from .errors import error

_DTYPES = {
    "double": np.float64, "float": np.float32, "uint8_t": np.uint8, "uint16_t": np.uint16, "uint32_t": np.uint32,
    "uint64_t": np.uint64, "int32_t": np.int32, "int64_t": np.int64, "size_t": np.uintp, "int": np.intc,
}
_HIDDEN = {"struct_size", "reserved"}

R = TypeVar("R", bound="Record")
A = TypeVar("A", bound="RecordArray[Any]")
W = TypeVar("W", bound=str)


class _Lent:
    """Memory from which numpy makes an array that keeps the owner alive."""

    __slots__ = ("__array_interface__", "owner")

    def __init__(self, pointer: Any, shape: tuple[int, ...], dtype: np.dtype[Any], owner: object):
        address = int(ffi.cast("uintptr_t", pointer))
        self.__array_interface__ = {"data": (address, True), "shape": shape, "typestr": dtype.str, "version": 3}
        self.owner = owner


def lent(pointer: Any, shape: tuple[int, ...], dtype: Any, owner: object) -> NDArray[Any]:
    """A read-only array in the memory of the library, which lives as long as the array."""
    dtype = np.dtype(dtype)
    if not pointer or 0 in shape:
        return np.empty(shape, dtype)
    # The interface of arrays has no names of fields.
    array = np.asarray(_Lent(pointer, shape, dtype, owner))
    return array if dtype.names is None else array.view(dtype)


def indices_struct(array: NDArray[np.uint32]) -> Any:
    """Makes a gusset_indices of an array, which must stay alive."""
    return {"data": ffi.cast("uint32_t *", array.ctypes.data), "count": array.size}


def dtype_of(ctype: Any) -> np.dtype[Any]:
    """The numpy type of a C number, an array of numbers, or a struct of these, with its padding."""
    if ctype.kind == "primitive":
        return np.dtype(_DTYPES[ctype.cname])
    if ctype.kind == "array":
        item = dtype_of(ctype.item)  # which may be an array itself
        return np.dtype((item.base, (ctype.length, *item.shape)))
    fields = [(name, field) for name, field in ctype.fields if name not in _HIDDEN]
    return np.dtype({
        "names": [name for name, _ in fields],
        "formats": [dtype_of(field.type) for _, field in fields],
        "offsets": [field.offset for _, field in fields],
        "itemsize": ffi.sizeof(ctype),
    })


@lru_cache(maxsize=None)
def _table(choice: str) -> tuple[dict[int, str], NDArray[Any], NDArray[np.str_]]:
    """The words of a choice by number; the numbers in increasing order, and their words."""
    by_number = {number: name for name, number in choices.NUMBERS[choice].items()}
    rising = sorted(by_number)
    return by_number, np.array(rising, np.uint64), np.array([by_number[number] for number in rising])


def word(number: int, choice: str) -> Any:
    """The word for a number of a choice."""
    return _table(choice)[0][number]


def words(numbers: NDArray[Any], choice: str) -> NDArray[np.str_]:
    """The words for numbers of a choice."""
    _, rising, names = _table(choice)
    found: NDArray[np.str_] = names[np.searchsorted(rising, numbers)]
    return found


def flags(number: int, choice: str) -> frozenset[Any]:
    """The words for the bits of a number."""
    return frozenset(name for name, bit in choices.NUMBERS[choice].items() if number & bit and bit & (bit - 1) == 0)


class FlagArray(Generic[W]):
    """Sets of words, one for each element: ``flags["proven"]`` says for each whether the word is in its set."""

    __slots__ = ("numbers", "_choice")

    def __init__(self, numbers: NDArray[Any], choice: str):
        #: The sets as sums of constants.
        self.numbers = numbers
        self._choice = choice

    def __getitem__(self, name: W) -> NDArray[np.bool_]:
        found: NDArray[np.bool_] = (self.numbers & number_of(self._choice, "flag", name)) != 0
        return found

    def __len__(self) -> int:
        return len(self.numbers)

    def __repr__(self) -> str:
        return f"<FlagArray of {len(self)}: {', '.join(sorted(choices.NUMBERS[self._choice]))}>"


class Record:
    """A struct that the library filled, with a property for each field, named as in ``gusset.h``.

    Arrays are not copied, cannot be written to, and keep alive what they are read from.
    """

    __slots__ = ("_struct", "_owner")

    #: The struct's name in C, and the function that fills it from a handle.
    _NAME: ClassVar[str]
    _GETTER: ClassVar[str]

    def __init__(self, struct: Any, owner: object):
        self._struct = struct
        self._owner = owner

    @classmethod
    def new(cls: type[R], owner: object = None) -> R:
        """Makes a struct that a function fills: ``_struct`` points to it. The memory of its arrays belongs to ``owner``."""
        struct = ffi.new(f"struct {cls._NAME} *")
        struct.struct_size = ffi.sizeof(f"struct {cls._NAME}")
        return cls(struct, (struct, owner))

    @classmethod
    def read(cls: type[R], handle: Any, *arguments: Any) -> R:
        """Reads the struct of a handle.

        Its arrays keep the handle alive, not the object that has it: a cycle through an array would never be collected.
        """
        made = cls.new(handle)
        status = getattr(lib, cls._GETTER)(handle, *arguments, made._struct)
        if status != 0:
            raise error(status, "")
        return made

    def _array(self, name: str, *shape: int, part: Optional[int] = None) -> NDArray[Any]:
        """An array of numbers or of structs of numbers; ``part`` selects one of several arrays."""
        value = getattr(self._struct, name)
        if part is not None:
            value = value[part]
        ctype = ffi.typeof(value)
        if ctype.kind == "struct":  # gusset_indices
            flat = lent(value.data, (value.count,), np.uint32, self._owner)
            return flat.reshape(shape) if shape else flat
        if ctype.kind == "array":
            whole = dtype_of(ctype)
            return lent(ffi.addressof(value), whole.shape, whole.base, self._owner).reshape(shape or whole.shape)
        # An optional array that is missing is NULL.
        return lent(value, shape if value else (0, *shape[1:]), dtype_of(ctype.item), self._owner)

    def _list(self, kind: type[R], name: str, count: int) -> list[R]:
        """A list of structs that contain arrays."""
        first = getattr(self._struct, name)
        return [kind(first[k], self._owner) for k in range(count)]

    def __reduce__(self) -> Any:
        raise TypeError(f"a {type(self).__name__} stays in its process: send its numbers and arrays")

    def __repr__(self) -> str:
        def short(value: Any) -> str:
            if isinstance(value, np.ndarray) and value.size > 8:
                return f"<{'x'.join(map(str, value.shape))} {value.dtype.name}>"
            return f"<{len(value)} {type(value[0]).__name__}>" if isinstance(value, list) and len(value) > 2 else repr(value)

        names = [name for name, value in vars(type(self)).items() if isinstance(value, property)]
        return f"{type(self).__name__}({', '.join(f'{name}={short(getattr(self, name))}' for name in names)})"


class RecordArray(Generic[R]):
    """An array of structs of numbers. Each attribute is a field of all of them; ``array`` has the structs as numpy's records.

    ``holes[0].length`` is a number, ``holes.length`` an array of numbers, and ``holes[holes.length > 1]`` a selection of the structs.
    """

    __slots__ = ("array",)

    #: The class of its elements.
    RECORD: ClassVar[type[Record]]

    def __init__(self, array: NDArray[Any]):
        self.array = array

    @classmethod
    def zeros(cls: type[A], count: int) -> A:
        """Makes structs that a function fills."""
        return cls(np.zeros(count, dtype_of(ffi.typeof(f"struct {cls.RECORD._NAME}"))))

    def pointer(self) -> Any:
        """The address of packed structs."""
        return ffi.cast(f"struct {self.RECORD._NAME} *", self.array.ctypes.data)

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> NDArray[Any]:
        return np.array(self.array, dtype) if copy else np.asarray(self.array, dtype)

    def __len__(self) -> int:
        return len(self.array)

    @overload
    def __getitem__(self, index: Union[int, tuple[int, int]]) -> R: ...

    @overload
    def __getitem__(self: A, index: Union[slice, NDArray[Any]]) -> A: ...

    def __getitem__(self, index: Any) -> Any:
        found = self.array[(*(index if isinstance(index, tuple) else (index,)), ...)]
        if found.ndim:
            return type(self)(found)
        return self.RECORD(ffi.cast(f"struct {self.RECORD._NAME} *", found.ctypes.data), found)

    def __iter__(self) -> Iterator[R]:
        return (self[k] for k in range(len(self)))

    def __repr__(self) -> str:
        return f"<{type(self).__name__} of {'x'.join(map(str, self.array.shape))}>"
