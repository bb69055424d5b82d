"""Filters of the plugin's table: how one is run, and what it gives."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import indices_of, pointer, points_of, reals_of
from ._call import Progress, under_way
from ._channels import carried
from ._library import ffi, lib, text
from ._records import lent
from .choices import Domain, Rule
from .errors import error
from .mesh import Mesh, fill_view, lent_mesh, of_one_precision

MESH, CURVES, TEXT = lib.GUSSET_KIND_MESH, lib.GUSSET_KIND_CURVES, lib.GUSSET_KIND_TEXT


class Curves:
    """Polylines: curve c has the points ``offsets[c]`` to ``offsets[c + 1] - 1``; ``closed`` has a byte for each.

    Args:
        points: (n, 3), or a sequence of such arrays, one a curve.
        offsets: where each curve begins, and the end of the last; None: one curve, or those of the sequence.
        closed: whether curves go on to their first points: of all or of each.
    """

    __slots__ = ("points", "offsets", "closed", "__weakref__")

    def __init__(self, points: Union[ArrayLike, Sequence[ArrayLike]], offsets: Optional[ArrayLike] = None, closed: Union[bool, ArrayLike] = False):
        if offsets is None and isinstance(points, (list, tuple)) and points and np.ndim(points[0]) == 2:
            arrays = [points_of(one) for one in points]
            self.points = np.concatenate(arrays)
            self.offsets = np.cumsum([0, *map(len, arrays)], dtype=np.uint32)
        else:
            self.points = points_of(points)  # type: ignore[arg-type]
            self.offsets = np.array([0, len(self.points)], np.uint32) if offsets is None else indices_of(offsets, "offsets")
        each = np.asarray(closed, np.uint8)
        self.closed: NDArray[np.uint8] = np.ascontiguousarray(np.broadcast_to(each, (max(len(self.offsets) - 1, 0),)))

    def require(self) -> None:
        """Checks again, because attributes may have been replaced since construction."""
        lists = [(self.offsets, np.uint32), (self.closed, np.uint8)]
        if any(not isinstance(one, np.ndarray) or one.dtype != dtype or one.ndim != 1 or not one.flags.c_contiguous for one, dtype in lists):
            raise ValueError("offsets and closed must be packed arrays, of unsigned 32-bit integers and of bytes")
        if len(self.offsets) == 0 or len(self.closed) != len(self.offsets) - 1:
            raise ValueError(f"{len(self.offsets)} offsets and {len(self.closed)} entries of closed: n curves need n + 1 and n")
        self.points = points_of(self.points)

    def __len__(self) -> int:
        return max(len(self.offsets) - 1, 0)

    def __getitem__(self, index: int) -> NDArray[Any]:
        if not -len(self) <= index < len(self):
            raise IndexError(f"curve {index} does not exist (there are {len(self)})")
        k = index % len(self)
        return self.points[self.offsets[k]:self.offsets[k + 1]]

    def __repr__(self) -> str:
        return f"<Curves: {len(self)} of {len(self.points)} points>"


class Report(str):
    """Lines of text; ``values`` has the numbers in it by their names: flags are bool, counts are int, angles are in radians."""

    values: dict[str, float]


class Outputs:
    """The outputs of a filter: a sequence. ``carry`` carries attributes of the inputs' elements over, if origins were requested."""

    def __init__(self, table: Any, handle: Any):
        self._table, self._handle = table, handle
        self._made = [self._output(k) for k in range(table.output_count(handle))]

    def __len__(self) -> int:
        return len(self._made)

    def __getitem__(self, index: int) -> Any:
        return self._made[index]

    def __iter__(self) -> Iterator[Any]:
        return iter(self._made)

    def _output(self, k: int) -> Any:
        kind = self._table.output_kind(self._handle, k)
        if kind == TEXT:
            return self._report(k)
        name = "gusset_plugin_mesh" if kind == MESH else "gusset_plugin_curves"
        view = ffi.new(f"struct {name} *")
        view.struct_size = ffi.sizeof(f"struct {name}")
        status = (self._table.output_mesh if kind == MESH else self._table.output_curves)(self._handle, k, view)
        if status != 0:
            raise error(status, "")
        if kind == MESH:
            return lent_mesh(view, self._handle)
        made = Curves.__new__(Curves)
        made.points = lent(view.points, (view.point_count, 3), np.float64, self._handle)
        made.offsets = lent(view.offsets, (view.curve_count + 1,), np.uint32, self._handle) if view.offsets else np.zeros(1, np.uint32)
        made.closed = lent(view.closed, (view.curve_count,), np.uint8, self._handle) if view.closed else np.zeros(view.curve_count, np.uint8)
        return made

    def _report(self, k: int) -> Report:
        said = Report(text(self._table.output_text(self._handle, k)))
        values = ffi.cast("struct gusset_plugin_values *", self._table.extension(b"values/1"))
        types: dict[int, Callable[[float], float]] = {lib.GUSSET_VALUE_FLAG: bool, lib.GUSSET_VALUE_COUNT: int}
        said.values = {}
        for n in range(values.count(self._handle, k)):
            kind = types.get(values.kind(self._handle, k, n), float)
            said.values[text(values.name(self._handle, k, n))] = kind(values.value(self._handle, k, n))
        return said

    @property
    def _attributes(self) -> Any:
        return ffi.cast("struct gusset_plugin_attributes *", self._table.extension(b"attributes/1"))

    def has_origins(self, index: int = 0) -> bool:
        """Whether output ``index`` tells where its elements come from."""
        return bool(self._attributes.has_origins(self._handle, index))

    def carry(self, values: Sequence[Optional[ArrayLike]], domain: Domain = "vertices", rule: Rule = "linear", *, index: int = 0) -> NDArray[Any]:
        """Values of the elements of output ``index``, from values of the inputs: one array for each input, or None."""
        mesh = self._made[index]
        count = {"vertices": mesh.vertex_count, "corners": len(mesh.corners), "faces": mesh.face_count}[domain]

        def apply(channel: Any, inputs: Any, input_count: int, out: Any, room: int) -> None:
            failure = ffi.new("struct gusset_failure *")
            failure.struct_size = ffi.sizeof("struct gusset_failure")
            status = self._attributes.apply(self._handle, index, ffi.NULL, channel, inputs, input_count, out, room, 0, failure)
            if status != 0:
                raise _failed(status, failure)

        return carried(apply, "gusset_plugin", values, count, domain, rule)


def _failed(status: int, failure: Any) -> Exception:
    of = failure.input if failure.input != 0xFFFFFFFF else 0
    return error(status, text(failure.message), failure.element, failure.index, failure.value, of)


class _Told:
    """The data of a host's callback during a run."""

    def __init__(self, progress: Optional[Progress]):
        self.progress = progress
        self.raised: Optional[BaseException] = None
        self.is_cancelled = False
        self.self = ffi.new_handle(self)
        self.callback = ffi.callback("int32_t(void *, double, const char *)", self.told, error=1, onerror=self.failed)

    def cancel(self) -> None:
        self.is_cancelled = True

    def told(self, user: Any, fraction: float, stage: Any) -> int:
        if self.progress is not None:
            self.progress(fraction, text(stage))
        return int(self.is_cancelled)

    def failed(self, kind: Any, exception: BaseException, traceback: Any) -> int:
        self.raised = exception
        return 1


class Filter:
    """A filter of the table; call it with its inputs and its parameters by keyword."""

    def __init__(self, table: Any, struct: Any):
        self._table, self._struct = table, struct
        self.id = text(struct.id)
        self.name = text(struct.name)
        self.script_name = text(struct.script_name)
        self.category = text(struct.category)
        self.help = text(struct.help)
        self.reference = text(struct.reference)
        self.params = [struct.param(struct, k) for k in range(struct.param_count)]
        self.param_ids = [text(one.id) for one in self.params]
        self.input_kinds = [struct.input_kinds[k] for k in range(struct.input_kind_count)]
        self.output_kinds = [struct.output_kinds[k] for k in range(struct.output_count)]

    def _inputs(self, given: Sequence[Any]) -> tuple[Any, list[Any]]:
        kept: list[Any] = []
        inputs = ffi.new("struct gusset_input[]", max(len(given), 1))
        kinds = [self.input_kinds[min(k, len(self.input_kinds) - 1)] if self.input_kinds else MESH for k in range(len(given))]
        meshes = iter(of_one_precision(one for one, kind in zip(given, kinds) if kind != CURVES))
        for k, (one, kind) in enumerate(zip(given, kinds)):
            if kind == CURVES:
                curves = one if isinstance(one, Curves) else Curves(one)
                curves.require()
                view = ffi.new("struct gusset_plugin_curves *")
                view.struct_size = ffi.sizeof("struct gusset_plugin_curves")
                view.points, view.point_stride = pointer(curves.points), curves.points.strides[0] if curves.points.size else 0
                view.point_count, view.curve_count = len(curves.points), len(curves)
                view.offsets, view.closed = pointer(curves.offsets), ffi.cast("uint8_t *", pointer(curves.closed))
                view.scalar = 1 if curves.points.dtype == np.float32 else 2
                kept += [curves, view]
            else:
                mesh = next(meshes)
                view = ffi.new("struct gusset_plugin_mesh *")
                fill_view(view, mesh)
                kept += [mesh, view]
            inputs[k].struct_size, inputs[k].view, inputs[k].kind = ffi.sizeof("struct gusset_input"), view, kind
        return inputs, kept

    def _values(self, inputs: Any, count: int, params: dict[str, Any]) -> Any:
        values = ffi.new("double[]", max(self._struct.value_count, 1))
        # Suggested values for the inputs; plain defaults if these are invalid, which run then reports.
        self._struct.suggest(self._struct, inputs, count, values)
        for name, value in params.items():
            if name not in self.param_ids:
                raise TypeError(f"{self.script_name} has no parameter {name!r}: there are {', '.join(self.param_ids) or 'none'}")
            param = self.params[self.param_ids.index(name)]
            if isinstance(value, str):
                words = choices_of(param)
                if value not in words:
                    raise ValueError(f"{name} is {value!r}: there are {', '.join(map(repr, words))}")
                value = words.index(value)
            numbers = reals_of(value).reshape(-1)
            if len(numbers) != param.arity:
                raise ValueError(f"{name} takes {param.arity} numbers, not {len(numbers)}")
            for k, number in enumerate(numbers.tolist()):
                values[param.first_value + k] = number
        return values

    def run(self, *given: Any, origins: bool = False, threads: int = 0, progress: Optional[Progress] = None, **params: Any) -> Outputs:
        """Runs it; with ``origins`` the outputs carry values over."""
        told = _Told(progress)
        host = ffi.new("struct gusset_host *")
        host.struct_size, host.user, host.progress = ffi.sizeof("struct gusset_host"), told.self, told.callback
        host.threads, host.origins = threads, int(origins)
        inputs, kept = self._inputs(given)
        values = self._values(inputs, len(given), params)
        made = ffi.new("struct gusset_outputs **")
        under_way.add(told)
        try:
            status = self._struct.run(self._struct, host, inputs, len(given), values, self._struct.value_count, made)
        finally:
            under_way.discard(told)
        outputs = ffi.gc(made[0], self._table.output_free) if made[0] else None
        del kept
        if told.raised is not None:
            raise told.raised
        if status != 0:
            failure = ffi.new("struct gusset_failure *")
            failure.struct_size = ffi.sizeof("struct gusset_failure")
            if outputs is None or self._table.output_failure(outputs, failure) != 0:
                raise error(status, "")
            raise _failed(status, failure)
        return Outputs(self._table, outputs)

    def __call__(self, *given: Any, threads: int = 0, progress: Optional[Progress] = None, **params: Any) -> Any:
        outputs = self.run(*given, threads=threads, progress=progress, **params)
        return outputs[0] if len(outputs) == 1 else tuple(outputs)

    def __reduce__(self) -> Any:
        return _by_name, (self.script_name,)

    def __repr__(self) -> str:
        return f"<filter {self.script_name}: {self.name}>"


def _by_name(name: str) -> Filter:
    return all_filters[name]


def word(label: str) -> str:
    """A label of a menu as a word for scripts."""
    kept = "".join(c if c.isalnum() else "_" for c in label.lower())
    return "_".join(part for part in kept.split("_") if part)


def choices_of(param: Any) -> list[str]:
    """The words for the choices of a parameter."""
    return [word(text(param.choices[k].label)) for k in range(param.choice_count)]


def table() -> Any:
    """The plugin's table."""
    found = lib.gusset_plugin_entry(lib.GUSSET_PLUGIN_ABI)
    if not found:
        raise ImportError(f"the library has no table of version {lib.GUSSET_PLUGIN_ABI}: install the library of this package")
    return found


def filters() -> list[Filter]:
    """All filters, in the order for menus."""
    tables = table()
    return [Filter(tables, tables.filter(k)) for k in range(tables.filter_count)]


#: By their names for scripts.
all_filters: dict[str, Filter] = {one.script_name: one for one in filters()}
