"""Certificates: facts about a result that ``verify.py`` checks without the library."""

from __future__ import annotations

import hashlib
import json
import os
import pathlib
from collections.abc import Iterable, Sequence
from typing import Any, Optional, Union

import numpy as np

from ._call import Progress
from ._handles import Reported, create
from ._library import ffi, lib
from ._reports import CertificateView
from .mesh import Mesh, MeshLike, as_mesh, view_of, views_of

__all__ = ["Certificate", "certify"]

_FORMAT = "gusset certificate 1"
_Path = Union[str, "os.PathLike[str]"]


class Certificate(Reported[CertificateView]):
    """Facts about a result and the meshes that it was made from; ``report`` has the numbers and lists."""

    REPORT = CertificateView

    def __init__(self, handle: Any, pieces: Sequence[Mesh], result: Mesh):
        super().__init__(handle)
        self._pieces, self._result = pieces, result

    @property
    def holds(self) -> bool:
        """The result bounds a solid: closed, manifold, oriented, facing outwards, without intersecting faces."""
        facts = self.report
        return bool(facts.closed and facts.outward) and facts.non_manifold_vertices == 0

    def claims(self) -> dict[str, Any]:
        """The claims of the certificate, as ``verify.py`` reads them."""
        facts = self.report
        counts = ("boundary_edges", "non_manifold_edges", "non_manifold_vertices", "orientation_conflicts", "degenerate_faces",
                  "duplicate_faces", "collinear_triangles", "intersecting_pairs", "kept_faces", "new_faces")
        return {
            "vertices": facts.vertex_count, "edges": facts.edge_count, "faces": facts.face_count, "components": facts.component_count,
            "closed": facts.closed, "manifold": facts.non_manifold_vertices == 0, "oriented": facts.orientation_conflicts == 0,
            "outward": facts.outward, "no_intersecting_faces": facts.intersecting_pairs == 0,
            **{name: getattr(facts, name) for name in counts},
            "turned_faces": self._by_piece(facts.turned_faces), "lost_faces": self._by_piece(facts.lost_faces),
            "farthest_vertex": self._farthest(),
        }

    def to_dict(self, files: Iterable[_Path], result_file: _Path) -> dict[str, Any]:
        """The certificate with the names and hashes of files that hold the same meshes.

        Args:
            files: a file for each of the inputs.
            result_file: the file of the result. A format in single precision holds other positions than a result in double precision.
        """
        named = [(path, mesh) for path, mesh in zip(files, self._pieces)]
        if len(named) != len(self._pieces):
            raise ValueError(f"{len(self._pieces)} inputs need as many files, not {len(named)}")
        return {
            "format": _FORMAT, "library": f"gusset {ffi.string(lib.gusset_version()).decode()}",
            "inputs": [_described(path, mesh) for path, mesh in named], "result": _described(result_file, self._result),
            "claims": self.claims(), "polygon_triangles": np.reshape(self.report.polygon_triangles, (-1, 3)).tolist(),
        }

    def to_json(self, files: Iterable[_Path], result_file: _Path) -> str:
        """The text of a certificate: see :meth:`to_dict`."""
        return json.dumps(self.to_dict(files, result_file), indent=2) + "\n"

    def _by_piece(self, pairs: Any) -> list[list[int]]:
        pairs = np.reshape(pairs, (-1, 2))
        return [pairs[pairs[:, 0] == piece, 1].tolist() for piece in range(len(self._pieces))]

    def _farthest(self) -> Optional[dict[str, Any]]:
        facts = self.report
        if facts.farthest_piece >= len(self._pieces):
            return None
        at = self._pieces[facts.farthest_piece].points[facts.farthest_vertex]
        return {"distance": facts.farthest_distance, "at": [float(x) for x in at],
                "nearest": [float(x) for x in self._result.points[facts.nearest_vertex]]}

    def __repr__(self) -> str:
        facts = self.report
        return f"<Certificate: {facts.kept_faces} faces kept, {np.size(facts.lost_faces) // 2} lost, {facts.new_faces} new>"


def _described(path: _Path, mesh: Mesh) -> dict[str, Any]:
    return {"file": os.fspath(path), "sha256": hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest(), "faces": mesh.face_count}


def certify(inputs: Iterable[MeshLike], result: MeshLike, *, threads: int = 0, progress: Optional[Progress] = None) -> Certificate:
    """States facts about a result and the meshes that it was made from. ``verify.py`` confirms or refutes them without the library.

    >>> points = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    >>> closed = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    >>> made = certify([(points, closed[1:])], (points, closed))
    >>> made, made.holds
    (<Certificate: 3 faces kept, 0 lost, 1 new>, True)
    """
    pieces, made = [as_mesh(piece) for piece in inputs], as_mesh(result)
    handle = create("certificate", views_of(pieces), len(pieces), view_of(made), threads=threads, progress=progress)
    return Certificate(handle, pieces, made)
