"""A failure: a status of the library, with the offending element."""

from __future__ import annotations

from typing import Any

from ._library import ELEMENTS, STATUSES, ffi, lib, text

__all__ = ["Cancelled", "Error", "InputError", "OutOfMemory"]


class Error(Exception):
    """A call of the library failed; nothing has changed.

    Attributes:
        status: the number of the status, as in ``gusset.h``; if it is negative, -status is a status of ``gusset_files.h``.
        name: its name in lower case, as ``"index_out_of_range"``.
        element: what ``index`` counts, as ``"vertex"`` or ``"face"``; ``"none"`` if nothing.
        index: the first element at fault, or None.
        value: its value where it has one, or None.
        input: the number of the mesh or loop that it belongs to, from 0.
    """

    def __init__(self, message: str, status: int, element: int = 0, index: int = 0, value: float = 0.0, input: int = 0):
        super().__init__(message)
        self.status = status
        self.name = STATUSES.get(status, str(status))
        self.element = ELEMENTS.get(element, str(element))
        self.index = index if element else None
        self.value = value if element else None
        self.input = input
        self._given = (message, status, element, index, value, input)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), self._given


class InputError(Error, ValueError):
    """The input cannot be used; names its first offending element."""


class OutOfMemory(Error, MemoryError):
    """Memory ran out."""


class Cancelled(Error):
    """The call was cancelled."""


def error(status: int, message: str, element: int = 0, index: int = 0, value: float = 0.0, input: int = 0) -> Error:
    """The exception for a status."""
    kind: type[Error] = InputError
    if status == lib.GUSSET_ERROR_OUT_OF_MEMORY:
        kind = OutOfMemory
    elif status == lib.GUSSET_ERROR_CANCELLED:
        kind = Cancelled
    elif status == lib.GUSSET_ERROR_PANIC:
        kind = Error
    return kind(message or text(lib.gusset_status_text(status)), status, element, index, value, input)


def reported(status: int, context: object) -> Error:
    """The exception for a status of a call with a context."""
    report = ffi.new("struct gusset_error_report *")
    report.struct_size = ffi.sizeof("struct gusset_error_report")
    if lib.gusset_context_get_report(context, report) != 0 or report.status != status:
        return error(status, "")
    message = text(lib.gusset_context_get_message(context))
    return error(status, message, report.element, report.index, report.value, report.input)
