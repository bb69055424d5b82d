"""Polygons of VTK's and PyVista's datasets, as arrays."""

from __future__ import annotations

import inspect
from typing import Any

import numpy as np
from numpy.typing import NDArray


def numpy_of(array: Any) -> NDArray[Any]:
    from vtkmodules.util import numpy_support
    convert: Any = numpy_support.vtk_to_numpy
    found: NDArray[Any] = convert(array)
    return found


def polygons_of(polydata: Any) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """The points of a vtkPolyData, where each polygon begins among the corners, and the vertex at each corner.

    Raises:
        ValueError: it has triangle strips; ``triangulate()`` makes triangles of them.
    """
    if polydata.GetNumberOfStrips():
        raise ValueError("triangle strips are not polygons: call triangulate() first")
    polys = polydata.GetPolys()
    points = numpy_of(polydata.GetPoints().GetData()) if polydata.GetPoints() else np.empty((0, 3))
    return points, numpy_of(polys.GetOffsetsArray()), numpy_of(polys.GetConnectivityArray())


def surface_of(dataset: Any) -> Any:
    """Returns the surface of a dataset of PyVista that is not a polygon mesh. Newer versions warn unless the algorithm is named."""
    told = {"algorithm": "dataset_surface"} if "algorithm" in inspect.signature(dataset.extract_surface).parameters else {}
    return dataset.extract_surface(**told)
