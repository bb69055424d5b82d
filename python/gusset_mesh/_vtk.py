"""The arrays of the points and cells of meshes of VTK."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._polydata import numpy_of, surface_of
from .choices import Domain, Rule
from .errors import InputError
from .mesh import from_polydata

__all__ = ["carry_arrays", "from_polydata", "surface_of"]


def _rule(name: str, values: NDArray[Any]) -> Rule:
    """How values are mixed: directions as such, numbers of things never, all else linearly."""
    if name.lower().startswith("normal") and values.ndim == 2 and values.shape[1] == 3 and values.dtype.kind == "f":
        return "normal"
    return "linear" if values.dtype.kind == "f" or values.dtype == np.uint8 else "nearest"


def _arrays(polydata: Any, domain: Domain) -> dict[str, NDArray[Any]]:
    """The arrays of points, or of the cells that are polygons, by name."""
    if domain == "vertices":
        data, first, count = polydata.GetPointData(), 0, polydata.GetNumberOfPoints()
    else:
        # Vertices and lines are cells too, and come first.
        first, count = polydata.GetNumberOfVerts() + polydata.GetNumberOfLines(), polydata.GetNumberOfPolys()
        data = polydata.GetCellData()
    # PyVista knows which of the arrays are of truth values: VTK has none.
    named = getattr(polydata, "point_data" if domain == "vertices" else "cell_data", {})
    found = {}
    for k in range(data.GetNumberOfArrays()):
        array = data.GetArray(k)
        if array is not None and array.GetName():
            name, values = array.GetName(), numpy_of(array)[first:first + count]
            is_truth = name in named and getattr(named[name], "dtype", None) == bool
            found[name] = values.astype(bool) if is_truth else values
    return found


def carry_arrays(carry: Callable[..., NDArray[Any]], inputs: Sequence[Any], result: Any) -> Any:
    """Gives a result the point and cell data of what it was made of."""
    domains: tuple[Domain, Domain] = ("vertices", "faces")
    for domain in domains:
        given = [_arrays(one, domain) for one in inputs]
        for name in dict.fromkeys(name for arrays in given for name in arrays):
            values = [arrays.get(name) for arrays in given]
            shapes = {one.shape[1:] for one in values if one is not None}
            kinds = np.result_type(*(one.dtype for one in values if one is not None))
            if len(shapes) != 1 or kinds.kind not in "iufb":
                continue  # one name for different things
            first = next(one for one in values if one is not None)
            rule = _rule(name, first)
            if kinds.kind == "f" and any(one is not None and not np.isfinite(one).all() for one in values):
                rule = "nearest"  # what is missing cannot be mixed
            try:
                made = carry(values, domain, rule)
            except InputError as error:
                warnings.warn(f"{name} is not carried along: {error}", stacklevel=3)
                continue
            (result.point_data if domain == "vertices" else result.cell_data)[name] = made
    return result
