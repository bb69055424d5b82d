"""VTK: feature edges and stripper for loops, the ruled surface for joins. Arrays are handed over without a copy."""

import numpy as np

from peers import Peer
from timing import Contender

vtk = Peer("vtk")
support = Peer("vtkmodules.util.numpy_support")


def points_of(mesh):
    points = vtk.vtkPoints()
    points.SetData(support.numpy_to_vtk(mesh.points))
    return points


def cells_of(offsets, corners, to_vtk):
    cells = vtk.vtkCellArray()
    cells.SetData(to_vtk(offsets), to_vtk(corners))
    return cells


def build(mesh):
    data = vtk.vtkPolyData()
    data.SetPoints(points_of(mesh))
    offsets = np.arange(0, mesh.faces.size + 1, 3, dtype=np.int32)
    data.SetPolys(cells_of(offsets, mesh.faces.view(np.int32).ravel(), support.numpy_to_vtk))
    data._kept = (mesh, offsets)
    return data


def loops(mesh):
    """From arrays to closed lines."""
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(build(mesh))
    edges.BoundaryEdgesOn()
    edges.FeatureEdgesOff()
    edges.NonManifoldEdgesOff()
    edges.ManifoldEdgesOff()
    edges.ColoringOff()
    lines = vtk.vtkStripper()
    lines.SetInputConnection(edges.GetOutputPort())
    lines.JoinContiguousSegmentsOn()
    lines.SetMaximumLength(2**30)
    lines.Update()
    return lines.GetOutput()


def lines_of(gap):
    """The two rims as closed lines on the points of the whole mesh. They run alike, so that the strip is oriented as the mesh. The
    ruled surface is empty unless indices are vtkIdTypes."""
    alike = gap.rims[0][::-1], gap.rims[1]
    closed = [np.append(rim, rim[0]).astype(np.int64) for rim in alike]
    corners = np.concatenate(closed)
    offsets = np.array([0, len(closed[0]), len(corners)], dtype=np.int64)
    data = vtk.vtkPolyData()
    data.SetPoints(points_of(gap.whole))
    data.SetLines(cells_of(offsets, corners, support.numpy_to_vtkIdTypeArray))
    data._kept = (gap, corners, offsets)
    return data


def ruled(data, orient):
    """The lines are joined by walking along both, each time by the shorter diagonal, wherever that leads: nothing is torn."""
    ruled = vtk.vtkRuledSurfaceFilter()
    ruled.SetInputData(data)
    ruled.SetRuledModeToPointWalk()
    ruled.SetOrientLoops(orient)
    ruled.SetDistanceFactor(1e9)
    ruled.SetCloseSurface(False)
    ruled.Update()
    return ruled.GetOutput()


def mesh_of(gap):
    def mesh(result):
        triangles = vtk.vtkTriangleFilter()
        triangles.SetInputData(result)
        triangles.PassLinesOff()
        triangles.PassVertsOff()
        triangles.Update()
        new = support.vtk_to_numpy(triangles.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)
        old = gap.whole.faces
        return gap.whole.points, np.concatenate([old, new.astype(np.uint32)]), len(old)

    return mesh


def step_contender(gap, orient):
    name = "vtk-ruled-oriented" if orient else "vtk-ruled"
    return Contender(name, lambda data: ruled(data, orient), lambda: lines_of(gap), mesh_of(gap))
