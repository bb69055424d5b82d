"""Repairs by gusset and its peers, each in a process of its own: reads the paths of a mesh and of its result from each line, and
writes the time. Peers run the functions that their manuals name for repair, in the order that solves most cases."""

import json
import os
import select
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

import gusset
import meshes
from meshes import Mesh
from peers import Peer

mm = Peer("meshlib.mrmeshpy")
mn = Peer("meshlib.mrmeshnumpy", after="meshlib.mrmeshpy")
pymeshfix = Peer("pymeshfix")
pymeshlab = Peer("pymeshlab")
trimesh = Peer("trimesh")
manifold3d = Peer("manifold3d")


def by_pymeshfix(mesh):
    fixer = pymeshfix.PyTMesh()
    fixer.set_quiet(True)
    fixer.load_array(mesh.points, mesh.faces.astype(np.int32))
    fixer.fill_small_boundaries()
    fixer.clean(max_iters=10, inner_loops=3)
    points, faces = fixer.return_arrays()
    return np.asarray(points), np.asarray(faces)


def by_meshlib(mesh):
    built = mn.meshFromFacesVerts(mesh.faces.astype(np.int32), mesh.points)
    diagonal = np.linalg.norm(np.ptp(mesh.points, axis=0))
    mm.uniteCloseVertices(built, 1e-6 * diagonal)
    mm.fixMultipleEdges(built)
    settings = mm.SelfIntersections.Settings()
    settings.method = mm.SelfIntersections.Settings.Method.CutAndFill
    for _ in range(2):
        mm.fillHoles(built, built.topology.findHoleRepresentiveEdges())
        mm.localFixSelfIntersections(built, settings)
    mm.fillHoles(built, built.topology.findHoleRepresentiveEdges())
    degeneracies = mm.FixMeshDegeneraciesParams()
    degeneracies.maxDeviation = 1e-5 * diagonal
    degeneracies.tinyEdgeLength = 1e-7 * diagonal
    mm.fixMeshDegeneracies(built, degeneracies)
    built.pack()
    return mn.getNumpyVerts(built), mn.getNumpyFaces(built.topology)


def by_pymeshlab(mesh):
    work = pymeshlab.MeshSet(verbose=False)
    work.add_mesh(pymeshlab.Mesh(mesh.points, mesh.faces.astype(np.int32)))
    steps = ("meshing_remove_duplicate_vertices", "meshing_remove_duplicate_faces", "meshing_remove_null_faces")
    manifold = ("meshing_repair_non_manifold_edges", "meshing_repair_non_manifold_vertices", "meshing_re_orient_faces_coherently")
    for name in (*steps, *manifold, "meshing_snap_mismatched_borders", *steps, *manifold, "meshing_close_holes", *manifold,
                 "meshing_close_holes", "meshing_re_orient_faces_by_geometry"):
        try:
            getattr(work, name)(**({"maxholesize": 10_000} if name == "meshing_close_holes" else {}))
        except Exception:  # A filter that refuses the mesh leaves it as it is.
            pass
    made = work.current_mesh()
    return made.vertex_matrix(), made.face_matrix()


def by_trimesh(mesh):
    made = trimesh.Trimesh(mesh.points, mesh.faces, process=False)
    made.merge_vertices()
    made.update_faces(made.unique_faces())
    made.update_faces(made.nondegenerate_faces())
    made.remove_unreferenced_vertices()
    made.fill_holes()
    made.fix_normals(multibody=True)
    return made.vertices, made.faces


def by_manifold(mesh):
    given = manifold3d.Mesh64(vert_properties=np.ascontiguousarray(mesh.points), tri_verts=np.ascontiguousarray(mesh.faces, dtype=np.uint64))
    given.merge()
    solid = manifold3d.Manifold(given)
    if solid.status() != manifold3d.Error.NoError:
        raise ValueError(f"{solid.status()}")
    parts = solid.decompose()
    made = manifold3d.Manifold.batch_boolean(parts, manifold3d.OpType.Add).to_mesh64()
    return made.vert_properties[:, :3], made.tri_verts


PEERS = {"pymeshfix": by_pymeshfix, "meshlib": by_meshlib, "pymeshlab": by_pymeshlab, "trimesh": by_trimesh, "manifold": by_manifold}


class Worker:
    """A contender in a process of its own, which starts anew if it dies or takes too long."""

    def __init__(self, command, patience):
        self.command, self.patience, self.child = command, patience, None

    def ask(self, line):
        """The answer to a line, or why there is none."""
        patience = self.patience
        if self.child is None:
            patience *= 4  # It also loads its library.
            self.child = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, bufsize=0)
        deadline, said, failed = time.monotonic() + patience, b"", f"not done in {patience:.0f} s"
        try:
            self.child.stdin.write(line.encode() + b"\n")
            while select.select([self.child.stdout], [], [], max(0.0, deadline - time.monotonic()))[0]:
                part = os.read(self.child.stdout.fileno(), 1 << 16)
                if not part:
                    failed = "died"
                    break
                said += part
                answers = [row for row in said.split(b"\n")[:-1] if row.startswith(b"{")]  # Peers print too.
                if answers:
                    return json.loads(answers[-1])
        except BrokenPipeError:
            failed = "died"
        self.close()
        return {"failed": failed}

    def close(self):
        if self.child is not None:
            self.child.kill()
            self.child.wait()
            self.child = None


def main():
    name, prefix = sys.argv[1:]
    if name == "gusset":
        library = gusset.Library(Path(prefix))
        work, arrays = library.repair, library.repaired
    else:
        work, arrays = PEERS[name], lambda made: made
    for line in sys.stdin:
        given, out = line.rstrip("\n").split("\t")
        mesh = meshes.read(given)
        mesh = Mesh(np.ascontiguousarray(mesh.points), np.ascontiguousarray(mesh.faces))
        try:
            start = time.perf_counter()
            made = work(mesh)
            spent = 1000 * (time.perf_counter() - start)
            points, faces = arrays(made)
            meshes.write(Mesh(np.asarray(points, dtype=np.float64), np.asarray(faces, dtype=np.uint32).reshape(-1, 3)), out)
            said = {"ms": spent}
        except Exception as error:  # Whatever a peer throws is its result.
            said = {"failed": f"{type(error).__name__}: {error}".splitlines()[0]}
        print("\n" + json.dumps(said), flush=True)


if __name__ == "__main__":
    main()
