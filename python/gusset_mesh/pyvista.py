"""PyVista's meshes: conversions, and the accessor ``mesh.gusset``, whose results carry point and cell data along.

>>> import pyvista as pv
>>> ball = pv.Sphere().clip("z", invert=False)
>>> ball.gusset.fill().is_manifold
True
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Optional

import numpy as np
import pyvista as pv

from . import filters, joining
from ._plugin import MESH, Curves
from ._vtk import carry_arrays, from_polydata, surface_of
from .mesh import Mesh, as_mesh

__all__ = ["GussetAccessor", "from_polydata", "to_polydata"]


def to_polydata(mesh: Mesh) -> Any:
    """A PyVista mesh."""
    sizes = np.full(mesh.face_count, mesh.face_size) if mesh.offsets is None else np.diff(mesh.offsets)
    cells = np.empty(len(mesh.corners) + len(sizes), np.int64)
    heads = np.cumsum(sizes + 1) - sizes - 1
    isnt_head = np.ones(len(cells), bool)
    isnt_head[heads] = False
    cells[heads], cells[isnt_head] = sizes, mesh.corners
    return pv.PolyData(np.array(mesh.points), faces=cells)


def curves_of(given: Any) -> Any:
    """The lines of a PyVista mesh as curves, each closed if it ends where it began; all else as it is."""
    if not hasattr(given, "GetLines"):
        return given
    lines, points = np.asarray(given.lines), np.asarray(given.points)
    found, closed, at = [], [], 0
    while at < len(lines):
        line = lines[at + 1:at + 1 + lines[at]]
        closed.append(len(line) > 2 and line[0] == line[-1])
        found.append(points[line[:-1] if closed[-1] else line])
        at += 1 + int(lines[at])
    return Curves(found, closed=closed) if found else Curves(np.empty((0, 3)), [0])


class GussetAccessor:
    """``mesh.gusset``: what joins and mends, as methods of PyVista's meshes. Point and cell data go along."""

    def __init__(self, dataset: Any):
        self._dataset = dataset

    def _polydata(self, one: Any) -> Any:
        if hasattr(one, "GetPolys"):
            return one
        return surface_of(one) if hasattr(one, "extract_surface") else to_polydata(as_mesh(one))

    def _done(self, made: Any, inputs: Sequence[Any]) -> Any:
        return carry_arrays(made.carry, inputs, to_polydata(made.mesh))

    def _one(self, job: Callable[..., Any], **keywords: Any) -> Any:
        polydata = self._polydata(self._dataset)
        return self._done(job(from_polydata(polydata), **keywords), [polydata])

    def stitch(self, other: Any = None, **options: Any) -> Any:
        """Joins it with another mesh, or two loops of its own: see :func:`gusset_mesh.stitch`."""
        inputs = [self._polydata(one) for one in (self._dataset, other) if one is not None]
        return self._done(joining.stitch(*map(from_polydata, inputs), **options), inputs)

    def join(self, *others: Any, **options: Any) -> Any:
        """Joins it with other pieces: see :func:`gusset_mesh.join`."""
        inputs = [self._polydata(one) for one in (self._dataset, *others)]
        return self._done(joining.join([from_polydata(one) for one in inputs], **options), inputs)

    def fill(self, **options: Any) -> Any:
        """Fills its holes: see :func:`gusset_mesh.fill`."""
        return self._one(joining.fill, **options)

    def weld(self, **options: Any) -> Any:
        """Makes vertices that lie together one: see :func:`gusset_mesh.weld`."""
        return self._one(joining.weld, **options)

    def sew(self, **options: Any) -> Any:
        """Joins borders that lie together: see :func:`gusset_mesh.sew`."""
        return self._one(joining.sew, **options)

    def orient(self, **options: Any) -> Any:
        """Turns faces to run the same way: see :func:`gusset_mesh.orient`."""
        return self._one(joining.orient, **options)

    def check(self) -> joining.Check:
        """Checks the mesh: see :func:`gusset_mesh.check`."""
        return joining.check(from_polydata(self._polydata(self._dataset)))

    def boundary_loops(self) -> Any:
        """Its boundary loops as lines."""
        mesh = from_polydata(self._polydata(self._dataset))
        loops = joining.boundary_loops(mesh)
        lines = [np.concatenate([[len(loop.vertices) + 1], loop.vertices, loop.vertices[:1]]) for loop in loops]
        return pv.PolyData(np.array(mesh.points), lines=np.concatenate(lines) if lines else None)

    def __getattr__(self, name: str) -> Any:
        if name not in filters.all_filters:
            raise AttributeError(f"no {name}: there are the methods of this class, and the filters {', '.join(filters.all_filters)}")
        one = filters.all_filters[name]

        def run(*others: Any, threads: int = 0, progress: Optional[Any] = None, **params: Any) -> Any:
            inputs = [self._dataset, *others]
            meshes = [self._polydata(given) if kind == MESH else curves_of(given)
                      for given, kind in zip(inputs, one.input_kinds + one.input_kinds[-1:] * len(inputs))]
            outputs = one.run(*meshes, origins=True, threads=threads, progress=progress, **params)
            out = [self._of(outputs, k, meshes) for k in range(len(outputs))]
            return out[0] if len(out) == 1 else tuple(out)

        run.__doc__ = one.__doc__
        return run

    def _of(self, outputs: Any, index: int, inputs: Sequence[Any]) -> Any:
        made = outputs[index]
        if isinstance(made, Mesh):
            result = to_polydata(made)
            if not outputs.has_origins(index):
                return result
            return carry_arrays(lambda *given: outputs.carry(*given, index=index), inputs, result)
        if isinstance(made, Curves):
            lines = [np.array([b - a + bool(c), *range(a, b), *[a] * bool(c)])
                     for a, b, c in zip(made.offsets[:-1].astype(int), made.offsets[1:].astype(int), made.closed)]
            return pv.PolyData(np.array(made.points), lines=np.concatenate(lines) if lines else None)
        return made

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *filters.all_filters]


if hasattr(pv, "register_dataset_accessor"):
    pv.register_dataset_accessor("gusset", pv.DataSet)(GussetAccessor)
else:  # before PyVista 0.48
    setattr(pv.DataSet, "gusset", property(GussetAccessor))
