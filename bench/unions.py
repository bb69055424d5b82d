"""Unions of two solids, beside manifold3d: `make bench ONLY=unite`. Random balls, tori, boxes, cylinders and capsules in random places; a
quarter of the pairs are a solid and its copy, moved by 1 to 1e-9."""

import time

import numpy as np

from meshes import Mesh

CASES = 1000
PEER = "manifold3d"


def wanted(only):
    return only in f"unite/pairs/{PEER}"


def run(library, report):
    # The peer is loaded only if it is asked for.
    import manifold3d

    spent, worst, valid = np.zeros((CASES, 2)), 0.0, 0
    for number in range(CASES):
        random = np.random.default_rng([58, number])
        first = solid(random)
        shift = (random.random(3) - 0.5) * 10.0 ** -random.integers(10)
        second = solid(random) if number % 4 else Mesh(first.points + shift, first.faces)
        start = time.perf_counter()
        union = library.unite([first, second])
        spent[number, 0] = time.perf_counter() - start
        points, faces = library.filled(union)
        valid += library.is_valid(union)
        start = time.perf_counter()
        theirs = sum((manifold3d.Manifold(manifold3d.Mesh64(m.points, m.faces.astype(np.uint64))) for m in (first, second)),
                     manifold3d.Manifold())
        theirs = theirs.volume()
        spent[number, 1] = time.perf_counter() - start
        ours = volume(points, faces)
        worst = max(worst, abs(ours - theirs) / ours)
    mine, other = 1000 * np.median(spent, axis=0)
    report.add("unite/pairs", PEER, mine, other, {"cases": CASES, "valid": valid, "volume_difference": worst})


def volume(points, faces):
    a, b, c = (points[faces[:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def solid(random):
    import trimesh
    from trimesh import creation

    kind, size = random.integers(5), int(random.integers(4))
    made = (lambda: creation.icosphere(size), lambda: creation.torus(1, 0.2 + 0.3 * random.random(), 6 + 4 * size, 6 + 3 * size),
            lambda: creation.box(0.4 + 1.5 * random.random(3)), lambda: creation.cylinder(0.3 + random.random(), 1 + random.random(), 5 + 6 * size),
            lambda: creation.capsule(1, 0.4 + 0.3 * random.random(), count=[4 + 4 * size, 4 + 4 * size]))[kind]()
    place = trimesh.transformations.random_rotation_matrix(random.random(3))
    place[:3, 3] = random.random(3) - 0.5
    made.apply_transform(place)
    return Mesh(np.ascontiguousarray(made.vertices, dtype=np.float64), np.ascontiguousarray(made.faces, dtype=np.uint32))
