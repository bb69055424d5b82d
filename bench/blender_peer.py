"""Blender as a module: bmesh.ops.bridge_loops. Meshes are built from arrays by its fastest way."""

import numpy as np

from peers import Peer
from timing import Contender

bpy = Peer("bpy")
bmesh = Peer("bmesh", after="bpy")


class Model:
    """A mesh that can be edited, and the edges of its two rims; freed with this object."""

    def __init__(self, gap):
        self.gap = gap
        mesh = bpy.data.meshes.new("gap")
        mesh.vertices.add(len(gap.whole.points))
        mesh.vertices.foreach_set("co", gap.whole.points.astype(np.float32).ravel())
        mesh.loops.add(gap.whole.faces.size)
        mesh.loops.foreach_set("vertex_index", gap.whole.faces.view(np.int32).ravel())
        mesh.polygons.add(len(gap.whole.faces))
        mesh.polygons.foreach_set("loop_start", np.arange(0, gap.whole.faces.size, 3, dtype=np.int32))
        mesh.update(calc_edges=True)
        self.bm = bmesh.new()
        self.bm.from_mesh(mesh)
        bpy.data.meshes.remove(mesh)
        on = set(np.concatenate(gap.rims).tolist())
        self.rims = [e for e in self.bm.edges if e.is_boundary and all(v.index in on for v in e.verts)]

    def bridge(self):
        self.faces = bmesh.ops.bridge_loops(self.bm, edges=self.rims)["faces"]
        return self

    def arrays(self):
        """Points, triangles, and the face of each triangle."""
        self.bm.faces.index_update()
        mesh = bpy.data.meshes.new("joined")
        self.bm.to_mesh(mesh)
        points = np.empty(3 * len(mesh.vertices), dtype=np.float32)
        mesh.vertices.foreach_get("co", points)
        mesh.calc_loop_triangles()
        triangles = np.empty(3 * len(mesh.loop_triangles), dtype=np.int32)
        mesh.loop_triangles.foreach_get("vertices", triangles)
        faces = np.empty(len(mesh.loop_triangles), dtype=np.int32)
        mesh.loop_triangles.foreach_get("polygon_index", faces)
        bpy.data.meshes.remove(mesh)
        return points.reshape(-1, 3).astype(np.float64), triangles.reshape(-1, 3), faces

    def __del__(self):
        if hasattr(self, "bm"):
            self.rims = self.faces = None
            self.bm.free()


def mesh(model):
    points, triangles, faces = model.arrays()
    new = np.isin(faces, [face.index for face in model.faces])
    return points, np.concatenate([triangles[~new], triangles[new]]), int((~new).sum())


def whole_contender(gap):
    def work(_):
        model = Model(gap).bridge()
        model.arrays()
        return model

    return Contender("blender", work, lambda: bmesh.new, mesh)


def step_contender(gap):
    return Contender("blender", Model.bridge, lambda: Model(gap), mesh)
