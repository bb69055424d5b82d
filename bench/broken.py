"""Meshes with seeded defects. A case knows its clean original, the faces far from every defect, and whether its parts overlap.
`KINDS` has a function for each kind of defect. The coordinates of all cases are numbers of single precision, so that no peer rounds
them."""

from dataclasses import dataclass, field

import numpy as np

from meshes import Mesh

#: Faces with a corner within this many edges of a defect may change.
REACH = 3


@dataclass
class Case:
    name: str
    points: np.ndarray
    faces: np.ndarray
    truth: Mesh
    united: bool
    far: np.ndarray  # corners of the faces that must stay, as positions


def single(points):
    return np.asarray(points, dtype=np.float32).astype(np.float64)


@dataclass
class Work:
    """A mesh that gets defects. The vertices of the original come first and keep their numbers."""

    clean: Mesh
    judge: object
    rng: np.random.Generator
    united: bool = False
    points: np.ndarray = None
    faces: np.ndarray = None
    source: np.ndarray = None  # the face of the original, or -1
    origin: np.ndarray = None  # the vertex of the original, or -1
    touched: np.ndarray = None  # vertices of the original at defects
    hidden: np.ndarray = field(default=None)  # faces of the original that the union drops

    def __post_init__(self):
        self.points, self.faces = self.clean.points.copy(), self.clean.faces.astype(np.int64)
        self.source, self.origin = np.arange(len(self.faces)), np.arange(len(self.points))
        self.touched = np.zeros(len(self.points), dtype=bool)
        self.hidden = np.zeros(len(self.faces), dtype=bool)

    # --- changes ---
    def add_points(self, points, origin=None):
        first = len(self.points)
        self.points = np.concatenate([self.points, single(points).reshape(-1, 3)])
        count = len(self.points) - first
        self.origin = np.concatenate([self.origin, np.full(count, -1) if origin is None else origin])
        return np.arange(first, first + count)

    def add_faces(self, faces):
        faces = np.asarray(faces, dtype=np.int64).reshape(-1, 3)
        self.faces = np.concatenate([self.faces, faces])
        self.source = np.concatenate([self.source, np.full(len(faces), -1)])

    def remove(self, rows):
        keep = np.ones(len(self.faces), dtype=bool)
        keep[rows] = False
        self.faces, self.source = self.faces[keep], self.source[keep]

    def touch(self, vertices):
        origin = self.origin[np.asarray(vertices, dtype=np.int64).ravel()]
        self.touched[origin[origin >= 0]] = True

    def touch_pairs(self):
        """Touches the faces that intersect, by CGAL."""
        pairs = self.judge.pairs(self.points, self.faces)
        self.touch(self.faces[np.unique(pairs)] if len(pairs) else [])
        return pairs

    # --- places ---
    def near(self):
        """Vertices of the original within `REACH` edges of a defect."""
        near, faces = self.touched.copy(), self.clean.faces
        for _ in range(REACH):
            near[faces[near[faces].any(axis=1)]] = True
        return near

    def free_rows(self):
        """Rows of faces that are as in the original, and apart from earlier defects."""
        near = self.near()
        same = self.source >= 0
        rows = np.flatnonzero(same)
        fine = ~near[self.clean.faces[self.source[rows]]].any(axis=1) & ~self.hidden[self.source[rows]]
        return rows[fine]

    def some_rows(self, count):
        """Some free rows, no two of which are neighbours."""
        rows, chosen, taken = self.free_rows(), [], set()
        for row in self.rng.permutation(rows):
            corners = set(self.faces[row].tolist())
            if not corners & taken:
                chosen.append(row)
                ring = self.faces[np.isin(self.faces, list(corners)).any(axis=1)]
                taken |= set(ring.ravel().tolist())
                if len(chosen) == count:
                    break
        return np.array(chosen, dtype=np.int64)

    def places(self, count):
        """The rows of some faces, each when it is needed: rows move as faces are removed."""
        for source in self.source[self.some_rows(count)].tolist():
            yield int(np.flatnonzero(self.source == source)[0])

    def disc(self, size):
        """Rows of a connected set of free faces."""
        rows = self.free_rows()
        if not len(rows):
            return rows
        by_vertex = {}
        for row in rows:
            for v in self.faces[row]:
                by_vertex.setdefault(int(v), []).append(int(row))
        found, front = [int(self.rng.choice(rows))], 0
        seen = set(found)
        while front < len(found) < size:
            for v in self.faces[found[front]]:
                for row in by_vertex[int(v)]:
                    if row not in seen and len(found) < size:
                        seen.add(row)
                        found.append(row)
            front += 1
        return np.array(found)

    def opposite_row(self, a, b):
        """The row of the face that runs the edge from b to a."""
        ahead = ((self.faces == b) & (np.roll(self.faces, -1, axis=1) == a)).any(axis=1)
        return int(np.flatnonzero(ahead)[0])

    def normal(self, row):
        p, q, r = self.points[self.faces[row]]
        normal = np.cross(q - p, r - p)
        return normal / max(np.linalg.norm(normal), 1e-300)

    def edge(self, row):
        corners = self.points[self.faces[row]]
        return np.linalg.norm(corners - np.roll(corners, 1, axis=0), axis=1).mean()

    def finish(self, name):
        near = self.near()
        same = self.source >= 0
        far = self.faces[same][~near[self.clean.faces[self.source[same]]].any(axis=1) & ~self.hidden[self.source[same]]]
        order = self.rng.permutation(len(self.faces))
        return Case(name, self.points, self.faces[order].astype(np.uint32), self.clean, self.united, self.points[far])


# --- kinds ---
def holes(work):
    for size in work.rng.choice([1, 3, 8, 20, 50], size=4):
        rows = work.disc(min(int(size), max(1, len(work.clean.faces) // 60)))
        work.touch(work.faces[rows])
        work.remove(rows)


def gaps(work):
    """A cut along edges, whose one side is moved by a part of an edge."""
    rng = work.rng
    normal = rng.normal(size=3)
    heights = work.points[work.faces].mean(axis=1) @ normal
    above = heights > np.quantile(heights, rng.uniform(0.3, 0.7))
    shared = np.intersect1d(work.faces[above], work.faces[~above])
    ends = work.faces[np.isin(work.faces, shared).any(axis=1)]
    least = np.full(len(work.points), np.inf)
    for k in range(3):
        p, q = ends[:, k], ends[:, (k + 1) % 3]
        length = np.linalg.norm(work.points[p] - work.points[q], axis=1)
        np.minimum.at(least, p, length)
        np.minimum.at(least, q, length)
    share = rng.choice([0.02, 0.1, 0.2])
    offset = rng.normal(size=(len(shared), 3))
    offset *= (share * least[shared] / np.linalg.norm(offset, axis=1))[:, None]
    work.touch(shared)
    copies = work.add_points(work.points[shared] + offset, work.origin[shared])
    names = np.arange(len(work.points))
    names[shared] = copies
    moved = np.isin(work.faces, shared).any(axis=1)
    work.source[moved] = -1
    work.faces[above] = names[work.faces[above]]


def flips(work):
    """Faces turned over, alone and in patches, and doubled faces."""
    for size in (1, 1, 1, 10, 60):
        rows = work.disc(min(size, max(1, len(work.clean.faces) // 30)))
        work.touch(work.faces[rows])
        work.faces[rows] = work.faces[rows][:, ::-1]
        work.source[rows] = -1
    rows = work.some_rows(8)
    work.touch(work.faces[rows])
    work.add_faces(work.faces[rows[:4]])
    work.add_faces(work.faces[rows[4:]][:, ::-1])


def fins(work):
    """Faces on edges, outside and inside, and faces at single vertices."""
    for k, row in enumerate(work.some_rows(10)):
        a, b, _ = work.faces[row]
        work.touch(work.faces[row])
        side = work.normal(row) * work.edge(row) * work.rng.uniform(0.5, 2) * (1 if k % 3 else -1)
        middle = work.points[[a, b]].mean(axis=0)
        if k % 5 == 4:
            tips = work.add_points([middle + side, middle + 1.3 * side + 0.4 * (work.points[b] - work.points[a])])
            work.add_faces([[a, *tips]])
            continue
        tips = work.add_points([middle + side, middle + 1.6 * side + 0.3 * (work.points[b] - work.points[a])])
        work.add_faces([[b, a, tips[0]]])
        if k % 2:
            work.add_faces([[b, tips[0], tips[1]]])
    work.touch_pairs()


def folds(work):
    """Vertices moved by several edges."""
    for row in work.some_rows(int(work.rng.integers(3, 7))):
        v = work.faces[row][0]
        direction = work.rng.normal(size=3)
        length = work.edge(row) * work.rng.uniform(1, 4)
        ring = (work.faces == v).any(axis=1)
        work.touch(work.faces[ring])
        work.points[v] = single(work.points[v] + length * direction / np.linalg.norm(direction))
        work.source[ring] = -1
    work.touch_pairs()


def junctions(work):
    """Edges with vertices of only one of their faces."""
    for row in work.places(15):
        a, b, c = work.faces[row]
        work.touch([a, b, c])
        work.touch(work.faces[work.opposite_row(a, b)])
        count = int(work.rng.integers(1, 3))
        shares = np.sort(work.rng.uniform(0.2, 0.8, size=count))[:, None]
        middles = work.add_points(work.points[a] + shares * (work.points[b] - work.points[a]))
        work.remove([row])
        chain = [a, *middles, b]
        work.add_faces([[p, q, c] for p, q in zip(chain, chain[1:])])


def needles(work):
    """Triangles of small height: short sides, caps, caps beyond their side, and caps without area."""
    for k, row in enumerate(work.places(16)):
        a, b, c = work.faces[row]
        other = work.opposite_row(a, b)
        d = next(v for v in work.faces[other] if v not in (a, b))
        work.touch([a, b, c, d])
        p, q = work.points[[a, b]]
        if k % 4 == 0:  # A short side.
            m = work.add_points([p + 1e-5 * (q - p)])[0]
            new = [[a, m, c], [m, b, c], [b, m, d], [m, a, d]]
        else:
            if k % 4 == 1:
                middle = (p + q) / 2  # A cap without area, up to rounding.
            else:  # A cap within the face, or beyond its side.
                inwards = work.points[c] - (p + q) / 2
                middle = (p + q) / 2 + (1e-4 if k % 4 == 2 else -1e-4) * inwards
            m = work.add_points([middle])[0]
            new = [[a, m, c], [m, b, c], [a, b, m], [b, a, d]]
        work.remove([row, other])
        work.add_faces(new)
    work.touch_pairs()


def seams(work):
    """Vertices split along the borders of charts; all vertices of all faces in every third case."""
    rng = work.rng
    centres = work.points[work.faces].mean(axis=1)
    if rng.integers(3) == 0:
        chart = np.arange(len(work.faces))
    else:
        seeds = centres[rng.choice(len(centres), size=6, replace=False)]
        chart = np.linalg.norm(centres[:, None] - seeds[None], axis=2).argmin(axis=1)
    corners = work.faces.ravel()
    charts = np.repeat(chart, 3)
    _, first, names = np.unique(np.stack([corners, charts]), axis=1, return_index=True, return_inverse=True)
    kept = corners[first]
    work.points, work.origin = work.points[kept], work.origin[kept]
    work.faces = names.reshape(-1, 3)


def digits(work):
    """Coordinates of 6 significant digits, far enough from the origin that they matter."""
    faces = work.clean.faces
    corners = work.clean.points[faces]
    lengths = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).min(axis=1)
    step = np.quantile(lengths, 0.02) * work.rng.choice([0.2, 0.5, 1.0])
    size = np.ptp(work.clean.points, axis=0).max()
    # Between 100,000 and 999,999 steps from the origin.
    scale = 1.0 / step
    centre = 10 ** 5 * (1 + 0.1 * work.rng.random(3)) + np.ceil(size * scale)
    moved = (work.clean.points - work.clean.points.mean(axis=0)) * scale + centre
    work.clean = Mesh(moved, faces)
    work.points = np.array([[float(f"{x:.6g}") for x in p] for p in moved])
    triangle = work.points[work.faces]
    normals = np.cross(triangle[:, 1] - triangle[:, 0], triangle[:, 2] - triangle[:, 0])
    before = moved[work.faces]
    straight = np.cross(before[:, 1] - before[:, 0], before[:, 2] - before[:, 0])
    work.touch(work.faces[(normals * straight).sum(axis=1) <= 0])
    work.touch_pairs()
    if work.rng.integers(2):
        work.points, work.origin = work.points[work.faces.ravel()], work.origin[work.faces.ravel()]
        work.faces = np.arange(3 * len(work.faces)).reshape(-1, 3)


#: Defects of a single mesh. `parts.py` has the kinds of several parts.
LOCAL = {"holes": holes, "gaps": gaps, "flips": flips, "fins": fins, "folds": folds, "junctions": junctions, "needles": needles,
         "seams": seams, "digits": digits}
