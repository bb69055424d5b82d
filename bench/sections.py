"""Sections of a mesh of a million faces by 1 and by 100 parallel planes: `make bench ONLY=section/`. From arrays to ordered polylines,
with nesting. Trimesh and VTK start from their own meshes, which are not timed. VTK's cutter leaves unordered segments."""

import numpy as np

from meshes import Mesh
from peers import Peer
from timing import Contender, by_turns
import vtk_peer

trimesh = Peer("trimesh")
COUNTS = 1, 100
ROWS = [f"section/{count}-1M/{peer}" for count in COUNTS for peer in ("cgal", "trimesh", "vtk")]
AROUND, ACROSS = 1000, 500


def wanted(only):
    return any(only in row for row in ROWS)


def solid():
    """A torus about z with bumps."""
    s, t = np.meshgrid(2 * np.pi * np.arange(AROUND) / AROUND, 2 * np.pi * np.arange(ACROSS) / ACROSS, indexing="ij")
    tube = 1 + 0.1 * np.sin(9 * s) * np.cos(7 * t)
    radius = 3 + tube * np.cos(t)
    points = np.stack([radius * np.cos(s), radius * np.sin(s), tube * np.sin(t)], axis=-1).reshape(-1, 3)
    number = np.arange(AROUND * ACROSS, dtype=np.uint32).reshape(AROUND, ACROSS)
    a, b, c, d = number, np.roll(number, -1, 0), np.roll(number, (-1, -1), (0, 1)), np.roll(number, -1, 1)
    faces = np.stack([np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)], axis=2).reshape(-1, 3)
    return Mesh(np.ascontiguousarray(points), np.ascontiguousarray(faces))


def heights(count):
    """The heights of planes, evenly over the middle of the solid; none at a vertex."""
    return -0.8 + 1.6 * (np.arange(count) + 0.5) / count + 1e-5 * np.sqrt(2)


def by_vtk(data, levels):
    vtk = vtk_peer.vtk
    plane = vtk.vtkPlane()
    plane.SetNormal(0, 0, 1)
    cutter = vtk.vtkCutter()
    cutter.SetCutFunction(plane)
    cutter.SetInputData(data)
    cutter.GenerateTrianglesOff()
    for k, level in enumerate(levels):
        cutter.SetValue(k, level)
    cutter.Update()
    return cutter.GetOutput()


def run(library, report, only):
    mesh = solid()
    for count in COUNTS:
        case, levels = f"section/{count}-1M", heights(count)
        if not any(only in f"{case}/{peer}" for peer in ("trimesh", "vtk")):
            continue
        built = trimesh.Trimesh(mesh.points, mesh.faces, process=False)
        outcomes = by_turns([
            Contender("gusset", lambda _: library.sections(mesh, levels)),
            Contender("trimesh", lambda _: built.section_multiplane([0, 0, 0], [0, 0, 1], levels)),
            Contender("vtk", lambda data: by_vtk(data, levels), lambda: vtk_peer.build(mesh)),
        ], runs=5, patience=60)
        mine = outcomes["gusset"]
        paths, points = library.section_counts(mine.result)
        same = {"trimesh": lambda result: sum(len(section.discrete) for section in result) == paths, "vtk": lambda result: result.GetNumberOfLines() == points}
        for name, is_same in same.items():
            theirs = outcomes[name]
            found = not theirs.failed and bool(is_same(theirs.result))
            report.add(case, name, mine, theirs, {"paths": paths, "points": points, "same_result": found})
