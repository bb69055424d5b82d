"""MeshLib: half-edge meshes, boundary loops, and stitchHoles by dynamic programming."""

import numpy as np

from peers import Peer
from timing import Contender

mm = Peer("meshlib.mrmeshpy")
mn = Peer("meshlib.mrmeshnumpy", after="meshlib.mrmeshpy")

# Samples of a view for its alignment are so far apart, in its unit: some 3,000 a view.
SAMPLES_APART = 0.002

METRICS = {"complex": "getComplexStitchMetric", "edge-length": "getEdgeLengthStitchMetric"}


def build(mesh):
    return mn.meshFromFacesVerts(mesh.faces, mesh.points)


def loops(mesh):
    """From arrays to loops."""
    built = build(mesh)
    return built, mm.findRightBoundary(built.topology)


def holes(built, gap):
    return holes_at(built, len(gap.whole.points), gap.rims)


def holes_at(built, vertex_count, rims):
    """An edge of each of the two holes that are to be joined: the one that the rim's first vertices lie on."""
    on = [np.zeros(vertex_count, dtype=bool) for _ in rims]
    for mark, rim in zip(on, rims):
        mark[rim] = True
    edges = list(built.topology.findHoleRepresentiveEdges())
    return [next(e for e in edges if mark[built.topology.org(e).get()]) for mark in on]


def stitch(built, ends, metric):
    new = mm.FaceBitSet()
    options = mm.StitchHolesParams()
    options.metric = getattr(mm, METRICS[metric])(built)
    options.outNewFaces = new
    mm.stitchHoles(built, *ends, options)
    return built, new


def nicely(built, ends, edge):
    """Stitched with the default metric, subdivided to a length of edge, and smoothed."""
    settings = mm.StitchHolesNicelySettings()
    settings.triangulateParams.metric = mm.getComplexStitchMetric(built)
    settings.subdivideSettings.maxEdgeLen = edge
    settings.subdivideSettings.maxEdgeSplits = 1_000_000
    settings.smoothCurvature = True
    return built, mm.stitchHolesNicely(built, *ends, settings)


def fill(built, edge=None):
    """All holes filled with the default metric; with `edge` subdivided to that length and smoothed. The new faces."""
    new = mm.FaceBitSet()
    for hole in list(built.topology.findHoleRepresentiveEdges()):
        if edge is None:
            options = mm.FillHoleParams()
            options.outNewFaces = new
            mm.fillHole(built, hole, options)
        else:
            settings = mm.FillHoleNicelySettings()
            settings.subdivideSettings.maxEdgeLen = edge
            settings.subdivideSettings.maxEdgeSplits = 1_000_000
            new |= mm.fillHoleNicely(built, hole, settings)
    return new


def arrays(built):
    return mn.getNumpyVerts(built), mn.getNumpyFaces(built.topology)


def mesh(result):
    built, new = result
    points, faces = arrays(built)
    marks = np.zeros(len(faces), dtype=bool)
    bits = mn.getNumpyBitSet(new)
    marks[: len(bits)] = bits[: len(faces)]
    return points, np.concatenate([faces[~marks], faces[marks]]), int((~marks).sum())


def ready(gap):
    """Prepares the step alone: a fresh copy of the mesh, with the holes known."""
    kept = []

    def prepare():
        if not kept:
            kept.append(build(gap.whole))
            kept.append(holes(kept[0], gap))
        return mm.Mesh(kept[0]), kept[1]

    return prepare


def whole_contender(gap, metric):
    def work(_):
        built = build(gap.whole)
        result = stitch(built, holes(built, gap), metric)
        arrays(built)
        return result

    return Contender(f"meshlib-{metric}", work, lambda: mn.meshFromFacesVerts, mesh)


def step_contender(gap, metric):
    return Contender(f"meshlib-{metric}", lambda state: stitch(*state, metric), ready(gap), mesh)


def rows_contender(gap, edge):
    return Contender("meshlib-nicely", lambda state: nicely(*state, edge), ready(gap), mesh)


def aligned(views, poses):
    """All views at once, the first held."""
    objects, built = mm.Vector_MeshOrPointsXf_ObjId(), []
    for view, pose in zip(views, poses):
        mesh = mn.meshFromFacesVerts(view.faces, view.points)
        built.append(mesh)
        turn, shift = pose[:3, :3].tolist(), pose[:3, 3].tolist()
        rows = [mm.Vector3f(*row) for row in turn]
        objects.push_back(mm.MeshOrPointsXf(mm.MeshOrPoints(mesh), mm.AffineXf3f(mm.Matrix3f(*rows), mm.Vector3f(*shift))))
    sampling = mm.MultiwayICPSamplingParameters()
    sampling.samplingVoxelSize = SAMPLES_APART
    icp = mm.MultiwayICP(objects, sampling)
    how = mm.ICPProperties()
    how.method = mm.ICPMethod.PointToPlane
    how.iterLimit = 100
    icp.setParams(how)
    found = icp.calculateTransformationsFixFirst()
    poses = []
    for k in range(len(views)):
        pose = np.eye(4)
        own = found.vec_[k]
        pose[:3, :3] = [[row.x, row.y, row.z] for row in (own.A.x, own.A.y, own.A.z)]
        pose[:3, 3] = own.b.x, own.b.y, own.b.z
        poses.append(pose)
    return poses


def fused(pieces, face_count):
    """Fuses all pieces to one surface by voxels, with about this many faces."""
    points = np.concatenate([piece.points for piece in pieces])
    built = [mn.meshFromFacesVerts(piece.faces, piece.points) for piece in pieces]
    normals = np.concatenate([np.array(mn.toNumpyArray(mm.computePerVertNormals(mesh))) for mesh in built])
    cloud = mn.pointCloudFromPoints(points, normals)
    size = float(np.linalg.norm(np.ptp(points, axis=0)))
    voxel = size / 300
    for _ in range(2):
        how = mm.PointsToMeshParameters()
        # The sharpest that gives one part without debris; sigma = voxel is nearer, and leaves three.
        how.voxelSize, how.sigma, how.minWeight = voxel, 1.5 * voxel, 4.0
        mesh = mm.pointsToMeshFusion(cloud, how)
        made = mesh.topology.numValidFaces()
        voxel *= (made / face_count) ** 0.5
    mesh.pack()
    return arrays(mesh)
