"""VTK and PyVista: structured grids. Arrays are handed over without a copy."""

import numpy as np

from peers import Peer
from vtk_peer import support, vtk

pyvista = Peer("pyvista")


def grid(points):
    height, width = points.shape[:2]
    data = vtk.vtkStructuredGrid()
    data.SetDimensions(width, height, 1)
    held = vtk.vtkPoints()
    held.SetData(support.numpy_to_vtk(points.reshape(-1, 3)))
    data.SetPoints(held)
    data._kept = points
    return data


def moved(data, matrix):
    transform = vtk.vtkTransform()
    transform.SetMatrix([*matrix, 0, 0, 0, 1])
    mover = vtk.vtkTransformFilter()
    mover.SetInputData(data)
    mover.SetTransform(transform)
    mover.Update()
    return mover.GetOutput()


def surface(data):
    """The cells as polygons, the input of the filter of normals."""
    shell = vtk.vtkDataSetSurfaceFilter()
    shell.SetInputData(data)
    shell.Update()
    return shell.GetOutput()


def normals(polygons):
    """Without splitting edges and without looking at the orientation, which is as it should be."""
    filter_ = vtk.vtkPolyDataNormals()
    filter_.SetInputData(polygons)
    filter_.SplittingOff()
    filter_.ConsistencyOff()
    filter_.ComputePointNormalsOn()
    filter_.Update()
    return filter_.GetOutput()


def normals_of(result):
    return support.vtk_to_numpy(result.GetPointData().GetNormals())


def points_of(result):
    return support.vtk_to_numpy(result.GetPoints().GetData())


def structured(points):
    return pyvista.wrap(grid(points))


def concatenated(a, b):
    return a.concatenate(b, axis=0)


def appended(a, b):
    """Both in one, coincident points merged."""
    append = vtk.vtkAppendFilter()
    append.AddInputData(a)
    append.AddInputData(b)
    append.MergePointsOn()
    append.Update()
    return append.GetOutput()


def cleaned(polygons):
    """Points that coincide become one."""
    clean = vtk.vtkStaticCleanPolyData()
    clean.SetInputData(polygons)
    clean.Update()
    return clean.GetOutput()


def halves(points):
    """A grid cut at its middle row, which both have."""
    middle = points.shape[0] // 2
    return np.ascontiguousarray(points[:middle + 1]), np.ascontiguousarray(points[middle:])


def kibibytes(data):
    return data.GetActualMemorySize()
