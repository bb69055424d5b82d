"""Loads the plugin into ParaView and runs its filters: pvpython try.py build/paraview/lib/Gusset/Gusset.so"""

import sys

from paraview import servermanager
from paraview.simple import (
    Cylinder,
    FeatureEdges,
    GroupDatasets,
    LoadPlugin,
    UpdatePipeline,
)

LoadPlugin(sys.argv[1], remote=False, ns=globals())


def open_edges(source):
    """How many edges have one face, in all blocks of a source."""
    edges = FeatureEdges(Input=source, FeatureEdges=0, NonManifoldEdges=0, BoundaryEdges=1, ManifoldEdges=0)
    UpdatePipeline(proxy=edges)
    return edges.GetDataInformation().GetNumberOfCells()


def expect(what, holds):
    print("ok  " if holds else "FAIL", what)
    failures.append(what) if not holds else None


failures = []
tube = Cylinder(Capping=0, Resolution=24)
expect("a tube is open", open_edges(tube) == 48)
filled = GussetFill(Input=tube, Refine=1, Fair=1)
UpdatePipeline(proxy=filled)
expect("filled it is closed", open_edges(filled) == 0)
normals = filled.PointData.GetArray("Normals")
expect("its normals are carried", normals is not None and normals.GetNumberOfComponents() == 3)

upper = Cylinder(Capping=0, Resolution=24, Center=[0.0, 1.2, 0.0])
for kind in ("vtkMultiBlockDataSet", "vtkPartitionedDataSet", "vtkPartitionedDataSetCollection"):
    both = GroupDatasets(Input=[tube, upper], OutputType=kind)
    each = GussetFill(Input=both)
    UpdatePipeline(proxy=each)
    expect(f"each of a {kind} is filled", open_edges(both) == 96 and open_edges(each) == 0)
    types = [source.GetDataInformation().GetCompositeDataSetType() for source in (both, each)]
    expect(f"and it is still a {kind}", types[0] == types[1])

joined = GussetAssemble(Input=[tube, upper], Finish="Blend")
UpdatePipeline(proxy=joined)
expect("two connections are joined", open_edges(joined) == 48)
closed = GussetAssemble(Input=both, FillHoles=1)
UpdatePipeline(proxy=closed)
expect("blocks are joined and closed", open_edges(closed) == 0)
stitched = GussetStitch(Input=tube, Second=upper, Rows=2)
UpdatePipeline(proxy=stitched)
expect("two inputs are stitched", open_edges(stitched) == 48)
within = GussetStitch(Input=tube)
UpdatePipeline(proxy=within)
expect("one input is stitched", open_edges(within) == 0)
before = within.GetDataInformation().GetNumberOfPoints()
within.Rows = 3
UpdatePipeline(proxy=within)
expect("an option that changes is heeded", within.GetDataInformation().GetNumberOfPoints() > before)

print(servermanager.vtkSMProxyManager.GetParaViewSourceVersion())
sys.exit(1 if failures else 0)
