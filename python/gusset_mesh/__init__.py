"""Joins and repairs polygon meshes; has nets of quads, smooth surfaces and outlines.

``join([a, b])`` makes one mesh of pieces. Meshes are numpy arrays, which the library reads in place. Results are arrays that the library lends.
Other threads run during a call, and Ctrl-C stops it. Bad input raises :class:`InputError` with the element at fault.
"""

from . import choices, fields, files, filters
from ._handles import Handle, Origins, Result
from ._library import lib as _lib
from ._library import text as _text
from ._options import (
    AlignmentOptions, BoundaryOptions, ConcatenateOptions, ContourOptions, DevelopOptions, FillOptions, IntersectionOptions, JoinOptions,
    NearestOptions, NetMeshOptions, OffsetOptions, OrientOptions, OutlineOptions, RepairOptions, SheetMeshOptions, StitchOptions,
    SurfaceOptions, TrimOptions, WeldOptions,
)
from ._options import (
    FacingOptions, FrameOptions, MeshSectionOptions, NetPrimitive, PlanariseOptions, SettleOptions, StreamOptions, StripOptions, WingedOptions,
)
from ._plugin import Curves
from ._records import FlagArray, Record, RecordArray
from ._reports import (
    AlignedPiece, AlignedPieceArray, AlignmentView, BoundaryView, CertificateView, Chart, ChartArray, CheckView, CurveMeasures, CurveNearestPoint,
    CurveNearestPointArray, CurveView, Defect, DefectArray, DevelopReport, FillReport, Hole, HoleArray, JoinReport, Joint, LeftLoop,
    LoopView, NetMeasureReport, NetMeshReport, OrientReport, OriginsView, OutlineView, Overlap, OverlapArray, PieceMap, Place, PlaceArray,
    PlacesView, QualityReport, RepairReport, SewReport, SheetMeshReport, SheetReport, StitchReport, SurfaceHit, SurfaceHitArray, SurfaceHitsView,
    SurfaceNearestPoint, SurfaceNearestPointArray, SurfacePathsView, SurfacePlace, SurfacePlaceArray, SurfacePoint, SurfacePointArray,
    SurfaceReport, TrimmedPiece, TrimView, WeldReport,
)
from ._reports import (
    Bridge, BridgeProperties, DistanceReport, FacingView, FrameView, GluingOccurrence, GluingOccurrenceArray, NearestAngleReport,
    NetAnalysisView, NetComplexView, NetFinding, NetFindingArray, NetGridView, NetGroupsView, NetPlanarityReport, NetValidationView,
    MeshSectionsView, OutlineCycle, OutlineCycleArray, OutlineHistory, OutlineReport, PlanariseReport, SceneEntryReport, SceneInstance, SceneInstanceArray, SceneReport, Seam, SeamArray,
    SectionPath, SectionPathArray, SettleReport,
    SheetMeasures, StreamReport, StripReport, SurfaceCell, SurfaceCellArray, SurfaceCellsView, SurfacePointsView, Transform, TransformArray,
    WingedEdge, WingedEdgeArray, WingedFacesView, WingedView,
)
from .analysing import NetAnalysis, NetComplex, NetValidation
from .certifying import Certificate, certify
from .curves import CurvePoints, CurveSpline
from .documents import Document, FileMesh
from .encoding import stream_inspect
from .errors import Cancelled, Error, InputError, OutOfMemory
from .fields import Field
from .files import read, save
from .frame import Frame
from .gluing import Gluing, LocalGluing, NetGroups, seam
from .joining import (
    Alignment, Boundary, Check, Development, Fill, Join, Orient, Repair, Sew, Stitch, Triangulation, Trim, Unite, Weld, align, boundary_loops,
    check, develop, fill, join, orient, repair, sew, stitch, triangulate, trim, unite, weld,
)
from .loops import Facing, Strip, facing, find_merge, meridians_index, strip
from .mesh import Mesh, MeshLike, as_mesh
from .net import Net, NetMesh
from .outline import Curve, Outline, Places, find_sections
from .querying import Line, Plane, SurfaceCells, SurfacePoints
from .reshaping import DecimatedNet, NetGrid
from .scene import Scene
from .sectioning import MeshSections, sections, sections_about_axis, sections_across, sections_by_planes
from .stream import StreamDecoder
from .surface import Sheet, SheetMesh, Surface, SurfaceHits, SurfacePaths
from .winged_edges import Winged, WingedFaces, winged, winged_faces

__version__ = _text(_lib.gusset_version())

__all__ = [
    "AlignedPiece", "AlignedPieceArray", "Alignment", "AlignmentOptions", "AlignmentView", "Boundary", "BoundaryOptions", "BoundaryView",
    "Cancelled", "Certificate", "CertificateView", "Chart", "ChartArray", "Check", "CheckView", "ConcatenateOptions", "ContourOptions", "Curve", "CurveMeasures",
    "CurveNearestPoint", "CurveNearestPointArray", "CurveView", "Curves", "Defect", "DefectArray", "DevelopOptions", "DevelopReport",
    "Development", "Error", "Fill", "FillOptions", "FillReport", "FlagArray", "Handle", "Hole", "HoleArray", "InputError",
    "IntersectionOptions", "Join", "JoinOptions", "JoinReport", "Joint", "LeftLoop", "LoopView", "Mesh", "MeshLike", "NearestOptions",
    "Net", "NetMeasureReport", "NetMesh", "NetMeshOptions", "NetMeshReport", "OffsetOptions", "Orient", "OrientOptions", "OrientReport",
    "Origins", "OriginsView", "OutOfMemory", "Outline", "OutlineOptions", "OutlineView", "Overlap", "OverlapArray", "PieceMap", "Place",
    "PlaceArray", "Places", "PlacesView", "QualityReport", "Record", "RecordArray", "Repair", "RepairOptions",
    "RepairReport", "Result", "Sew", "SewReport", "Sheet", "SheetMesh",
    "SheetMeshOptions", "SheetMeshReport", "SheetReport", "Stitch", "StitchOptions", "StitchReport", "Surface", "SurfaceHit",
    "SurfaceHitArray", "SurfaceHits", "SurfaceHitsView", "SurfaceNearestPoint", "SurfaceNearestPointArray", "SurfaceOptions",
    "SurfacePaths", "SurfacePathsView", "SurfacePlace", "SurfacePlaceArray", "SurfacePoint", "SurfacePointArray", "SurfaceReport",
    "Triangulation", "Trim", "TrimOptions", "TrimView", "TrimmedPiece", "Unite", "Weld", "WeldOptions", "WeldReport", "align", "as_mesh",
    "boundary_loops", "certify", "check", "choices", "develop", "fill", "filters", "join", "orient", "repair", "sew", "stitch", "triangulate", "trim", "unite", "weld",
]
__all__ += [
    "Bridge", "BridgeProperties", "CurvePoints", "CurveSpline", "DecimatedNet", "DistanceReport", "Document", "Facing", "FacingOptions",
    "FacingView", "Field", "FileMesh", "Frame", "FrameOptions", "FrameView", "Gluing", "GluingOccurrence", "GluingOccurrenceArray", "Line",
    "LocalGluing", "NearestAngleReport", "NetAnalysis", "NetAnalysisView", "NetComplex", "NetComplexView", "NetFinding", "NetFindingArray",
    "NetGrid", "NetGridView", "NetGroups", "NetGroupsView", "NetPlanarityReport", "NetPrimitive", "NetValidation", "NetValidationView",
    "OutlineCycle", "OutlineCycleArray", "OutlineHistory", "OutlineReport", "PlanariseOptions", "PlanariseReport", "Plane", "Scene", "SceneEntryReport", "SceneInstance", "SceneInstanceArray",
    "SceneReport", "Seam", "SeamArray", "SettleOptions", "SettleReport", "SheetMeasures", "StreamDecoder", "StreamOptions", "StreamReport",
    "Strip", "StripOptions", "StripReport", "SurfaceCell", "SurfaceCellArray", "SurfaceCells", "SurfaceCellsView", "SurfacePoints",
    "SurfacePointsView", "Transform", "TransformArray", "Winged", "WingedEdge", "WingedEdgeArray", "WingedFaces", "WingedFacesView",
    "WingedOptions", "WingedView", "facing", "fields", "files", "find_merge", "find_sections", "meridians_index", "read", "save", "seam",
    "stream_inspect", "strip", "winged", "winged_faces",
]
__all__ += [
    "MeshSectionOptions", "MeshSections", "MeshSectionsView", "SectionPath", "SectionPathArray", "sections", "sections_about_axis",
    "sections_across", "sections_by_planes",
]
