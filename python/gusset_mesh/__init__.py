"""Joins and repairs polygon meshes; has nets of quads, smooth surfaces and outlines.

``join([a, b])`` makes one mesh of pieces. Meshes are numpy arrays, which the library reads in place. Results are arrays that the library lends.
Other threads run during a call, and Ctrl-C stops it. Bad input raises :class:`InputError` with the element at fault.
"""

from . import choices, filters
from ._handles import Handle, Origins, Result
from ._library import lib as _lib
from ._library import text as _text
from ._options import (
    AlignmentOptions, BoundaryOptions, ConcatenateOptions, ContourOptions, DevelopOptions, FillOptions, IntersectionOptions, JoinOptions,
    NearestOptions, NetMeshOptions, OffsetOptions, OrientOptions, OutlineOptions, SheetMeshOptions, StitchOptions, SurfaceOptions,
    TrimOptions, WeldOptions,
)
from ._plugin import Curves
from ._records import FlagArray, Record, RecordArray
from ._reports import (
    AlignedPiece, AlignedPieceArray, AlignmentView, BoundaryView, Chart, ChartArray, CheckView, CurveMeasures, CurveNearestPoint,
    CurveNearestPointArray, CurveView, Defect, DefectArray, DevelopReport, FillReport, Hole, HoleArray, JoinReport, Joint, LeftLoop,
    LoopView, NetMeasureReport, NetMeshReport, OrientReport, OriginsView, OutlineView, Overlap, OverlapArray, PieceMap, Place, PlaceArray,
    PlacesView, QualityReport, SewReport, SheetMeshReport, SheetReport, StitchReport, SurfaceHit, SurfaceHitArray, SurfaceHitsView,
    SurfaceNearestPoint, SurfaceNearestPointArray, SurfacePathsView, SurfacePlace, SurfacePlaceArray, SurfacePoint, SurfacePointArray,
    SurfaceReport, TrimmedPiece, TrimView, WeldReport,
)
from .errors import Cancelled, Error, InputError, OutOfMemory
from .joining import (
    Alignment, Boundary, Check, Development, Fill, Join, Orient, Sew, Stitch, Trim, Weld, align, boundary_loops, check, develop, fill,
    join, orient, sew, stitch, trim, weld,
)
from .mesh import Mesh, MeshLike, as_mesh
from .net import Net, NetMesh
from .outline import Curve, Outline, Places
from .surface import Sheet, SheetMesh, Surface, SurfaceHits, SurfacePaths

__version__ = _text(_lib.gusset_version())

__all__ = [
    "AlignedPiece", "AlignedPieceArray", "Alignment", "AlignmentOptions", "AlignmentView", "Boundary", "BoundaryOptions", "BoundaryView",
    "Cancelled", "Chart", "ChartArray", "Check", "CheckView", "ConcatenateOptions", "ContourOptions", "Curve", "CurveMeasures",
    "CurveNearestPoint", "CurveNearestPointArray", "CurveView", "Curves", "Defect", "DefectArray", "DevelopOptions", "DevelopReport",
    "Development", "Error", "Fill", "FillOptions", "FillReport", "FlagArray", "Handle", "Hole", "HoleArray", "InputError",
    "IntersectionOptions", "Join", "JoinOptions", "JoinReport", "Joint", "LeftLoop", "LoopView", "Mesh", "MeshLike", "NearestOptions",
    "Net", "NetMeasureReport", "NetMesh", "NetMeshOptions", "NetMeshReport", "OffsetOptions", "Orient", "OrientOptions", "OrientReport",
    "Origins", "OriginsView", "OutOfMemory", "Outline", "OutlineOptions", "OutlineView", "Overlap", "OverlapArray", "PieceMap", "Place",
    "PlaceArray", "Places", "PlacesView", "QualityReport", "Record", "RecordArray", "Result", "Sew", "SewReport", "Sheet", "SheetMesh",
    "SheetMeshOptions", "SheetMeshReport", "SheetReport", "Stitch", "StitchOptions", "StitchReport", "Surface", "SurfaceHit",
    "SurfaceHitArray", "SurfaceHits", "SurfaceHitsView", "SurfaceNearestPoint", "SurfaceNearestPointArray", "SurfaceOptions",
    "SurfacePaths", "SurfacePathsView", "SurfacePlace", "SurfacePlaceArray", "SurfacePoint", "SurfacePointArray", "SurfaceReport", "Trim",
    "TrimOptions", "TrimView", "TrimmedPiece", "Weld", "WeldOptions", "WeldReport", "align", "as_mesh", "boundary_loops", "check",
    "choices", "develop", "fill", "filters", "join", "orient", "sew", "stitch", "trim", "weld",
]
