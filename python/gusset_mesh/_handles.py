"""Handles of the library, with their reports and the origins of their elements."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any, Generic, Optional, TypeVar

from numpy.typing import ArrayLike, NDArray

from ._call import Progress, call
from ._channels import carried
from ._library import ffi, lib, number_of
from ._records import Record
from ._reports import OriginsView
from .choices import Domain, Rule
from .errors import error
from .mesh import Mesh, lent_mesh

R = TypeVar("R", bound=Record)


def create(
    kind: str, *arguments: Any, threads: int = 0, progress: Optional[Progress] = None, name: Optional[str] = None, is_short: bool = False
) -> Any:
    """Calls ``gusset_<name>_create`` with a context and these arguments, and returns the new handle."""
    return _made(kind, f"gusset_{name or kind}_create", arguments, threads, progress, is_short)


def result(function: str, *arguments: Any, threads: int = 0, progress: Optional[Progress] = None, is_short: bool = False) -> Any:
    """Calls ``gusset_<function>``, which makes a mesh, and returns the new ``gusset_result``."""
    return _made("result", f"gusset_{function}", arguments, threads, progress, is_short)


def _made(kind: str, function: str, arguments: Any, threads: int, progress: Optional[Progress], is_short: bool) -> Any:
    made = ffi.new(f"struct gusset_{kind} **")
    call(getattr(lib, function), *arguments, made, threads=threads, progress=progress, is_short=is_short)
    return ffi.gc(made[0], getattr(lib, f"gusset_{kind}_destroy"))


class Handle:
    """Owns a handle, which is destroyed once nothing refers to it."""

    def __init__(self, handle: Any):
        self._handle = handle

    def __reduce__(self) -> Any:
        raise TypeError(f"a {type(self).__name__} stays in its process: send its mesh or its arrays")


class Reported(Handle, Generic[R]):
    """A handle with a report."""

    #: The class of the report.
    REPORT: type[R]

    @cached_property
    def report(self) -> R:
        """The report or view of the handle in ``gusset.h``: numbers, words and arrays."""
        return self.REPORT.read(self._handle)


class Origins(Handle):
    """The origins of the elements of a result: their sources in the inputs, with weights."""

    def view(self, domain: Domain) -> OriginsView:
        """The origins of vertices, corners or faces."""
        return OriginsView.read(self._handle, number_of("gusset_domain", "domain", domain))

    def carry(
        self, values: Sequence[Optional[ArrayLike]], domain: Domain = "vertices", rule: Rule = "linear", *, max_influences: int = 0
    ) -> NDArray[Any]:
        """Carries values of elements over from the inputs to the result. ``values`` has an array, or None, for each input."""
        count = len(self.view(domain).offsets) - 1

        def apply(channel: Any, inputs: Any, input_count: int, out: Any, room: int) -> None:
            call(lib.gusset_attributes_apply, self._handle, channel, inputs, input_count, out, room, 0)

        return carried(apply, "gusset", values, count, domain, rule, max_influences)


class Result(Reported[R]):
    """A mesh that an operation made, with a report and the origins of its elements."""

    def _lent_mesh(self, function: Any) -> Mesh:
        view = ffi.new("struct gusset_mesh_view *")
        view.struct_size = ffi.sizeof("struct gusset_mesh_view")
        status = function(self._handle, view)
        if status != 0:
            raise error(status, "")
        return lent_mesh(view, self._handle)

    @cached_property
    def mesh(self) -> Mesh:
        """The mesh. Its arrays belong to the result, and cannot be written to."""
        return self._lent_mesh(lib.gusset_result_get_mesh)

    @cached_property
    def origins(self) -> Origins:
        """The origins of its vertices, corners and faces."""
        return Origins(create("origins", self._handle, name="result_origins"))

    def carry(
        self, values: Any, domain: Domain = "vertices", rule: Rule = "linear", *, max_influences: int = 0
    ) -> NDArray[Any]:
        """Carries values of elements over from the inputs to the result. ``values`` is a list with an array for each input, or one array.

        An element with one source gets the source's value, bit for bit. Elements with several sources mix their values by ``rule``.
        """
        given = values if isinstance(values, (list, tuple)) else [values]
        return self.origins.carry(given, domain, rule, max_influences=max_influences)

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.mesh.vertex_count} vertices, {self.mesh.face_count} faces>"
