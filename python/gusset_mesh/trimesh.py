"""trimesh's meshes: conversions. Meshes of trimesh are taken as they are wherever a mesh is wanted.

>>> import trimesh
>>> from gusset_mesh import check
>>> check(trimesh.creation.icosphere()).is_closed
True
"""

from __future__ import annotations

from typing import Any

import numpy as np

from .mesh import Mesh, MeshLike, as_mesh

__all__ = ["from_trimesh", "to_trimesh"]


def from_trimesh(mesh: Any) -> Mesh:
    """The mesh, whose points are not copied."""
    return Mesh(np.asarray(mesh.vertices), np.asarray(mesh.faces))


def to_trimesh(mesh: MeshLike, **attributes: Any) -> Any:
    """A ``trimesh.Trimesh`` with these vertices and faces, none of them changed; polygons are cut into triangles.

    Args:
        attributes: what else ``trimesh.Trimesh`` takes, as ``vertex_colors`` that were carried along.
    """
    import trimesh
    given = as_mesh(mesh)
    return trimesh.Trimesh(np.array(given.points, np.float64), given.triangles().astype(np.int64), process=False, **attributes)
