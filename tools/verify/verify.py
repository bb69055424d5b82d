#!/usr/bin/env python3
"""Confirms or refutes the claims of a certificate of gusset. Shares no code with the library.

    verify.py CERTIFICATE [INPUT... RESULT]

Without names of files, takes the names in the certificate: as they are, else beside the certificate. Reads OBJ, PLY, STL and OFF.
Prints a line for each claim. Exit status: 0 all confirmed, 1 a claim is refuted, 2 a file cannot be read.

Coordinates of files are binary fractions. Multiplied by a power of two they become integers, and all decisions are exact. A face is the
cycle of its corners. Polygons are judged as the triangles that the certificate gives for them. These are checked to split the polygon.
"""

import bisect
import collections
import fractions
import hashlib
import itertools
import json
import pathlib
import struct
import sys

FORMAT = "gusset certificate 1"
#: The claimed distance of the farthest vertex is rounded by at most this part of it.
DISTANCE_ROUNDING = fractions.Fraction(1, 1 << 40)
CONFIRMED, REFUTED, UNREADABLE = range(3)


class Unreadable(Exception):
    """A file cannot be read."""


# Reading


def read_mesh(data, name):
    """Returns the points as tuples of floats, and the faces as tuples of vertices."""
    kind = pathlib.PurePath(name).suffix.lower()
    readers = {".obj": read_obj, ".ply": read_ply, ".stl": read_stl, ".off": read_off}
    if kind not in readers:
        raise Unreadable(f"{name}: only OBJ, PLY, STL and OFF files are read")
    try:
        points, faces = readers[kind](data)
    except (ValueError, IndexError, KeyError, StopIteration, struct.error) as error:
        raise Unreadable(f"{name}: not a sound {kind[1:].upper()} file ({error!r})") from error
    faces = [tuple(face) for face in faces if len(face) >= 3]
    if not faces or not all(0 <= v < len(points) for face in faces for v in face):
        raise Unreadable(f"{name}: it has no faces, or a face names a vertex that does not exist")
    return points, faces


def text(data):
    """Returns the text of a file with the line ends of Unix."""
    return data.decode("ascii", "replace").replace("\r\n", "\n").replace("\r", "\n")


def read_obj(data):
    points, faces = [], []
    for line in text(data).replace("\\\n", " ").split("\n"):
        words = line.split("#")[0].split()
        if words and words[0].lower() == "v":
            points.append(tuple(map(float, words[1:4])))
        elif words and words[0].lower() == "f":
            numbers = [int(word.split("/")[0]) for word in words[1:]]
            faces.append([number - 1 if number > 0 else len(points) + number for number in numbers])
    return points, faces


def read_off(data):
    lines = [line.split("#")[0].split() for line in text(data).split("\n")]
    lines = collections.deque(words for words in lines if words)
    head = lines[0][0]
    if head not in ("OFF", "COFF", "NOFF", "CNOFF", "NCOFF", "STOFF") or "BINARY" in lines[0]:
        raise ValueError(f"{head} is not supported")
    del lines[0][0]
    if not lines[0]:
        lines.popleft()
    counts = [int(word) for word in lines.popleft()[:2]]
    points = [tuple(map(float, lines.popleft()[:3])) for _ in range(counts[0])]
    rows = [lines.popleft() for _ in range(counts[1])]
    return points, [[int(word) for word in row[1:1 + int(row[0])]] for row in rows]


def read_stl(data):
    """Merges corners at equal positions, because STL files have no vertices. -0 equals 0."""
    if len(data) >= 84 and len(data) == 84 + 50 * int.from_bytes(data[80:84], "little"):
        facets = [[row[0:3], row[3:6], row[6:9]] for row in struct.iter_unpack("<12x9f2x", data[84:])]
    else:
        words = iter(data.decode("utf-8", "replace").lower().split())
        facets = []
        for word in words:
            if word == "loop":
                facets.append([])
            elif word == "vertex":
                facets[-1].append(tuple(float(next(words)) for _ in range(3)))
    numbers = {}
    faces = [[numbers.setdefault(tuple(point), len(numbers)) for point in facet] for facet in facets]
    return list(numbers), faces


PLY_TYPES = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H", "uint16": "H",
             "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f", "double": "d", "float64": "d"}


def read_ply(data):
    end = data.index(b"end_header")
    body = data.index(b"\n", end) + 1
    header = [line.split() for line in data[:end].decode("utf-8", "replace").splitlines()]
    encoding = next(words[1] for words in header if words[:1] == ["format"])
    elements = []
    for words in header:
        if words[:1] == ["element"]:
            elements.append((words[1], int(words[2]), []))
        elif words[:1] == ["property"]:
            elements[-1][2].append((words[-1], [PLY_TYPES[word] for word in words[1:-1] if word != "list"]))
    read = ply_text_rows(data[body:]) if encoding == "ascii" else ply_binary_rows(data, body, "<" if "little" in encoding else ">")
    points, faces = [], []
    for name, count, properties in elements:
        for _ in range(count):
            row = read(properties)
            if name == "vertex":
                points.append((row["x"], row["y"], row["z"]))
            elif name == "face":
                faces.append(row["vertex_indices"] if "vertex_indices" in row else row["vertex_index"])
    return points, faces


def ply_text_rows(data):
    """Returns a function that reads the next row."""
    words = iter(data.split())

    def number(kind):
        value = float(next(words)) if kind in "fd" else int(next(words))
        return struct.unpack("f", struct.pack("f", value))[0] if kind == "f" else value

    return lambda properties: {name: number(kinds[0]) if len(kinds) == 1 else [number(kinds[1]) for _ in range(number(kinds[0]))]
                               for name, kinds in properties}


def ply_binary_rows(data, place, order):
    """Returns a function that reads the next row."""
    def numbers(kind, count=1):
        nonlocal place
        found = struct.unpack_from(f"{order}{count}{kind}", data, place)
        place += struct.calcsize(f"{order}{count}{kind}")
        return found

    return lambda properties: {name: numbers(kinds[0])[0] if len(kinds) == 1 else list(numbers(kinds[1], numbers(kinds[0])[0]))
                               for name, kinds in properties}


def scaled(meshes):
    """Replaces the coordinates of all meshes by integers. Returns the meshes and the factor. Points that no face uses are None."""
    used = [[False] * len(points) for points, _ in meshes]
    for flags, (_, faces) in zip(used, meshes):
        for v in itertools.chain.from_iterable(faces):
            flags[v] = True
    ratios = [[tuple(x.as_integer_ratio() for x in point) if flag else None for point, flag in zip(points, flags)]
              for flags, (points, _) in zip(used, meshes)]
    factor = max(ratio[1] for mesh in ratios for point in mesh if point for ratio in point)
    whole = [[point and tuple(top * (factor // bottom) for top, bottom in point) for point in mesh] for mesh in ratios]
    return [(points, faces) for points, (_, faces) in zip(whole, meshes)], factor


# Exact vectors


def sub(a, b):
    return a[0] - b[0], a[1] - b[1], a[2] - b[2]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


# Topology


class Sets:
    """Disjoint sets."""

    def __init__(self, count):
        self.parent = list(range(count))

    def find(self, a):
        while self.parent[a] != a:
            self.parent[a] = self.parent[self.parent[a]]
            a = self.parent[a]
        return a

    def union(self, a, b):
        self.parent[self.find(a)] = self.find(b)


class Topology:
    """Edges, fans and components. Half-edges between equal vertices do not count, nor do faces with fewer than three others."""

    def __init__(self, faces):
        self.start, self.end, self.next, self.face = [], [], [], []
        self.edges = collections.defaultdict(list)
        for f, face in enumerate(faces):
            sides = [(a, b) for a, b in zip(face, face[1:] + face[:1]) if a != b]
            if len(sides) < 3:
                continue
            first = len(self.start)
            for k, (a, b) in enumerate(sides):
                self.edges[min(a, b), max(a, b)].append(first + k)
                self.start.append(a)
                self.end.append(b)
                self.next.append(first + (k + 1) % len(sides))
                self.face.append(f)
        self.components = Sets(len(faces))
        for sharing in self.edges.values():
            for h in sharing[1:]:
                self.components.union(self.face[sharing[0]], self.face[h])
        self.boundary = [edge for edge, sharing in self.edges.items() if len(sharing) == 1]
        self.crowded = [edge for edge, sharing in self.edges.items() if len(sharing) > 2]
        self.conflicts = [edge for edge, sharing in self.edges.items()
                          if len(sharing) == 2 and self.start[sharing[0]] == self.start[sharing[1]]]
        self.singular = sorted(set(itertools.chain.from_iterable(self.crowded)) | self.vertices_of_several_fans())

    def vertices_of_several_fans(self):
        """Faces are in one fan if they follow each other across edges with exactly two faces."""
        corners = Sets(len(self.start))
        for sharing in self.edges.values():
            if len(sharing) == 2:
                g, h = sharing
                if self.start[g] == self.start[h]:
                    corners.union(g, h)
                    corners.union(self.next[g], self.next[h])
                else:
                    corners.union(g, self.next[h])
                    corners.union(self.next[g], h)
        fans = collections.Counter(self.start[h] for h in range(len(self.start)) if corners.find(h) == h)
        return {v for v, count in fans.items() if count > 1}


def cycle_and_direction(items):
    """Returns the smallest rotation of a cycle in both directions, and whether it runs backwards."""
    def smallest(cycle):
        least = min(cycle)
        return min(cycle[k:] + cycle[:k] for k, item in enumerate(cycle) if item == least)

    forwards, backwards = smallest(tuple(items)), smallest(tuple(reversed(items)))
    return min(forwards, backwards), backwards < forwards


# Intersections


def half_spaces(triangle):
    """Returns the half-spaces (normal, offset), normal . x >= offset, whose intersection is the triangle, which may be degenerate."""
    a, b, c = triangle
    normal = cross(sub(b, a), sub(c, a))
    if any(normal):
        sides = [(cross(normal, sub(q, p)), p) for p, q in ((a, b), (b, c), (c, a))]
        flat = [normal]
    else:
        a, b = max(((a, b), (b, c), (c, a)), key=lambda ends: dot(sub(*ends), sub(*ends)))
        along = sub(b, a)
        sides = [(along, a), (sub(a, b), b)]
        flat = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
        if any(along):
            first = max((cross(along, axis) for axis in flat), key=lambda v: dot(v, v))
            flat = [first, cross(along, first)]
    flat = [(normal, a) for normal in flat]
    both = flat + [(tuple(-x for x in normal), a) for normal, a in flat]
    return [(normal, dot(normal, point)) for normal, point in both + sides]


def is_separated(bounds, other, shared):
    """Returns whether a half-space around one triangle meets the other in common corners only, or not at all."""
    for normal, offset in bounds:
        places = [dot(normal, point) - offset for point in other]
        if all(place < 0 or (place == 0 and point in shared) for place, point in zip(places, other)):
            return True
    return False


def clip(polygon, normal, offset):
    """Returns the part of a convex polygon in a half-space."""
    kept = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        at_p, at_q = dot(normal, p) - offset, dot(normal, q) - offset
        if at_p >= 0:
            kept.append(p)
        if at_p * at_q < 0:
            part = fractions.Fraction(at_p, 1) / (at_p - at_q)
            kept.append(tuple(x + (y - x) * part for x, y in zip(p, q)))
    return kept


def triangles_meet(p, p_bounds, q, q_bounds):
    """Returns whether two triangles have a common point outside of their common corners and the edge between two of these."""
    shared = set(p) & set(q)
    if len(shared) > 2:
        return True
    if is_separated(p_bounds, q, shared) or is_separated(q_bounds, p, shared):
        return False
    common = list(p)
    for normal, offset in q_bounds:
        common = clip(common, normal, offset)
    if len(shared) < 2:
        return any(point not in shared for point in common)
    a, b = shared
    along = sub(b, a)
    return any(any(cross(along, sub(x, a))) or not 0 <= dot(along, sub(x, a)) <= dot(along, along) for x in common)


def pairs_of_overlapping_boxes(boxes):
    """Yields pairs of places whose boxes overlap; may repeat a pair. Splits along the widest axis while that separates boxes."""
    small = 24
    parts = [list(range(len(boxes)))]
    while parts:
        part = parts.pop()
        if len(part) > small:
            low, high = [[pick(boxes[k][side][axis] for k in part) for axis in range(3)] for side, pick in ((0, min), (1, max))]
            axis = max(range(3), key=lambda axis: high[axis] - low[axis])
            middle = sorted(boxes[k][0][axis] + boxes[k][1][axis] for k in part)[len(part) // 2]
            left = [k for k in part if 2 * boxes[k][0][axis] <= middle]
            right = [k for k in part if 2 * boxes[k][1][axis] >= middle]
            if max(len(left), len(right)) < 0.8 * len(part):
                parts += [left, right]
                continue
        for i, k in enumerate(part):
            (ax, ay, az), (bx, by, bz) = boxes[k]
            for j in part[i + 1:]:
                (cx, cy, cz), (dx, dy, dz) = boxes[j]
                if ax <= dx and cx <= bx and ay <= dy and cy <= by and az <= dz and cz <= bz:
                    yield (k, j) if k < j else (j, k)


def intersecting_faces(triangles, owners):
    """Returns the pairs of faces whose triangles meet."""
    boxes = [(tuple(map(min, *t)), tuple(map(max, *t))) for t in triangles]
    bounds = [half_spaces(t) for t in triangles]
    found, seen = set(), set()
    for k, j in pairs_of_overlapping_boxes(boxes):
        pair = owners[k], owners[j]
        if pair[0] != pair[1] and pair not in found and (k, j) not in seen:
            seen.add((k, j))
            if triangles_meet(triangles[k], bounds[k], triangles[j], bounds[j]):
                found.add(pair)
    return found


# Nesting


def is_left(a, b, p):
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0


def is_above(triangle, p):
    """Returns whether a triangle lies above a point. The point moves by an infinitesimal along x, so that it is below no edge."""
    inside = False
    for a, b in zip(triangle, triangle[1:] + triangle[:1]):
        low, high = (a, b) if a[1] <= b[1] else (b, a)
        if low[1] <= p[1] < high[1] and is_left(low, high, p):
            inside = not inside
    if not inside:
        return False
    normal = cross(sub(triangle[1], triangle[0]), sub(triangle[2], triangle[0]))
    return dot(normal, sub(p, triangle[0])) * normal[2] < 0


def first_wrong_component(triangles, components):
    """Returns a triangle of a component that faces the wrong side, or None. No triangles may meet."""
    groups = collections.defaultdict(list)
    for triangle, component in zip(triangles, components):
        # Three times as large, so that centroids are integers.
        groups[component].append(tuple(tuple(3 * x for x in point) for point in triangle))
    for component, own in groups.items():
        volume = sum(dot(a, cross(b, c)) for a, b, c in own)
        solid = next((t for t in own if any(cross(sub(t[1], t[0]), sub(t[2], t[0])))), own[0])
        centroid = tuple(sum(xs) // 3 for xs in zip(*solid))
        others = itertools.chain.from_iterable(group for key, group in groups.items() if key != component)
        depth = sum(is_above(triangle, centroid) for triangle in others)
        if volume == 0 or (volume < 0) != (depth % 2 == 1):
            return tuple(tuple(x // 3 for x in point) for point in own[0])
    return None


# Moves


def nearest_squared(point, targets, enough):
    """Returns the squared distance to the nearest of some points, sorted. Stops early once it is at most `enough`."""
    place = bisect.bisect_left(targets, point)
    best = None
    left, right = place - 1, place
    while left >= 0 or right < len(targets):
        go_left = right == len(targets) or (left >= 0 and point[0] - targets[left][0] <= targets[right][0] - point[0])
        target = targets[left] if go_left else targets[right]
        left, right = (left - 1, right) if go_left else (left, right + 1)
        gap = sub(target, point)
        if best is not None and gap[0] ** 2 >= best:
            break
        squared = dot(gap, gap)
        best = squared if best is None else min(best, squared)
        if best <= enough:
            break
    return best


# Claims


class Verifier:
    """Compares the claims of a certificate with the files."""

    def __init__(self, certificate, files):
        self.certificate, self.claims = certificate, certificate["claims"]
        self.is_refuted = False
        data = [pathlib.Path(file).read_bytes() for file in files]
        stated = [*certificate["inputs"], certificate["result"]]
        for file, content, about in zip(files, data, stated):
            self.judge(f"sha256 of {file}", about["sha256"], hashlib.sha256(content).hexdigest())
        meshes, self.factor = scaled([read_mesh(content, file) for file, content in zip(files, data)])
        self.inputs, (self.points, self.faces) = meshes[:-1], meshes[-1]

    def judge(self, claim, stated, found, place=""):
        is_confirmed = type(stated) is type(found) and stated == found
        self.tell(claim, "" if is_confirmed else f"the certificate says {shortened(stated)}, the files {shortened(found)}{place}")

    def tell(self, claim, objection):
        print(f"refuted: {claim}: {objection}" if objection else f"confirmed: {claim}")
        self.is_refuted |= bool(objection)

    def shown(self, point):
        return "(" + " ".join(repr(float(fractions.Fraction(x, self.factor))) for x in point) + ")"

    def edge(self, edges):
        return f"; an edge: {self.shown(self.points[edges[0][0]])} {self.shown(self.points[edges[0][1]])}" if edges else ""

    def verify(self):
        topology = Topology(self.faces)
        triangles, owners = self.triangles()
        self.verify_topology(topology)
        self.verify_faces()
        corners = [tuple(self.points[v] for v in triangle) for triangle in triangles]
        flat = [t for t in corners if not any(cross(sub(t[1], t[0]), sub(t[2], t[0])))]
        self.judge("collinear_triangles", self.claims["collinear_triangles"], len(flat), f"; at {self.shown(flat[0][0])}" if flat else "")
        pairs = intersecting_faces(corners, owners)
        place = f"; faces {sorted(pairs)[0]}" if pairs else ""
        self.judge("no_intersecting_faces", self.claims["no_intersecting_faces"], not pairs, place)
        self.judge("intersecting_pairs", self.claims["intersecting_pairs"], len(pairs), place)
        self.verify_outward(topology, corners, owners, pairs)
        self.verify_matches()
        self.verify_farthest()

    def triangles(self):
        """Returns the triangles with three different vertices, and the face of each."""
        given = iter(self.certificate["polygon_triangles"])
        triangles, owners, start, objection = [], [], 0, ""
        for f, face in enumerate(self.faces):
            n = len(face)
            split = [(0, 1, 2)] if n == 3 else [tuple(h - start for h in next(given, (-1,) * 3)) for _ in range(n - 2)]
            sides = collections.Counter((a, b) for t in split for a, b in zip(t, t[1:] + t[:1]))
            border = {(k, (k + 1) % n) for k in range(n)}
            inner = set(sides) - border
            sound = all(len(t) == 3 and all(isinstance(k, int) and 0 <= k < n for k in t) for t in split)
            if not sound or max(sides.values()) > 1 or not border <= set(sides) or not all((b, a) in inner for a, b in inner):
                objection = objection or f"its triangles do not split face {f}"
                split = [(0, k, k + 1) for k in range(1, n - 1)]
            for triangle in split:
                vertices = tuple(face[k] for k in triangle)
                if len(set(vertices)) == 3:
                    triangles.append(vertices)
                    owners.append(f)
            start += n
        if next(given, None) is not None:
            objection = objection or "it has more triangles than the polygons"
        self.tell("polygon_triangles", objection)
        return triangles, owners

    def verify_topology(self, topology):
        claims, faces = self.claims, self.faces
        self.judge("vertices", claims["vertices"], len(set(itertools.chain.from_iterable(faces))))
        self.judge("edges", claims["edges"], len(topology.edges))
        self.judge("components", claims["components"], len({topology.components.find(f) for f in range(len(faces))}))
        for claim, found in (("boundary_edges", topology.boundary), ("non_manifold_edges", topology.crowded),
                             ("orientation_conflicts", topology.conflicts)):
            self.judge(claim, claims[claim], len(found), self.edge(found))
        at = f"; at {self.shown(self.points[topology.singular[0]])}" if topology.singular else ""
        self.judge("non_manifold_vertices", claims["non_manifold_vertices"], len(topology.singular), at)
        is_closed = bool(topology.edges) and not topology.boundary and not topology.crowded
        self.judge("closed", claims["closed"], is_closed, self.edge(topology.boundary + topology.crowded))
        self.judge("manifold", claims["manifold"], not topology.singular, at)
        self.judge("oriented", claims["oriented"], not topology.conflicts, self.edge(topology.conflicts))

    def verify_faces(self):
        faces = self.faces
        self.judge("faces", self.claims["faces"], len(faces))
        repeating = [f for f, face in enumerate(faces) if len(set(face)) < len(face)]
        self.judge("degenerate_faces", self.claims["degenerate_faces"], len(repeating), f"; face {repeating[0]}" if repeating else "")
        first, duplicates = {}, []
        for f, face in enumerate(faces):
            if len(set(face)) == len(face) and first.setdefault(cycle_and_direction(face)[0], f) != f:
                duplicates.append(f)
        self.judge("duplicate_faces", self.claims["duplicate_faces"], len(duplicates), f"; face {duplicates[0]}" if duplicates else "")

    def verify_outward(self, topology, corners, owners, pairs):
        """A certificate need not claim this, because rounding may leave it undecided."""
        if self.claims["outward"] is False:
            print("not claimed: outward")
            return
        if topology.boundary or topology.crowded or topology.conflicts or pairs or not topology.edges:
            self.judge("outward", self.claims["outward"], False, "; the result does not bound a solid")
            return
        wrong = first_wrong_component(corners, [topology.components.find(f) for f in owners])
        self.judge("outward", self.claims["outward"], wrong is None, f"; the component at {self.shown(wrong[0])}" if wrong else "")

    def verify_matches(self):
        """Each result face answers for at most one input face: in order, first one of its direction, else a reversed one."""
        free = collections.Counter(cycle_and_direction([self.points[v] for v in face]) for face in self.faces)
        kept, waiting = 0, []
        for p, (points, faces) in enumerate(self.inputs):
            self.judge(f"faces of input {p}", self.certificate["inputs"][p]["faces"], len(faces))
            for f, face in enumerate(faces):
                key = cycle_and_direction([points[v] for v in face])
                if free[key]:
                    free[key] -= 1
                    kept += 1
                else:
                    waiting.append((p, f, (key[0], not key[1])))
        turned, lost = [[[] for _ in self.inputs] for _ in range(2)]
        for p, f, key in waiting:
            (turned if free[key] else lost)[p].append(f)
            free[key] -= bool(free[key])
        self.judge("kept_faces", self.claims["kept_faces"], kept)
        self.judge("new_faces", self.claims["new_faces"], sum(free.values()))
        self.judge("turned_faces", self.claims["turned_faces"], turned)
        self.judge("lost_faces", self.claims["lost_faces"], lost)

    def verify_farthest(self):
        """The largest distance of an input vertex from the nearest result vertex, where faces use both."""
        stated = self.claims["farthest_vertex"]
        targets = sorted({point for point in self.points if point is not None})
        moved = {point for points, _ in self.inputs for point in points if point is not None} - set(targets)
        if stated is None:
            self.tell("farthest_vertex", f"the result lacks the input vertex {self.shown(min(moved))}" if moved else "")
            return
        at, to = (tuple(fractions.Fraction(x) * self.factor for x in stated[end]) for end in ("at", "nearest"))
        if at not in moved or to not in set(targets):
            self.tell("farthest_vertex", f"no vertices move from {stated['at']} to {stated['nearest']}")
            return
        # Vertices closer than the stated one need no exact search.
        largest, place = nearest_squared(at, targets, -1), at
        gap = sub(at, to)
        for point in moved:
            squared = nearest_squared(point, targets, largest)
            if squared > largest:
                largest, place = squared, point
        distance = fractions.Fraction(stated["distance"]) * self.factor
        bounds = [(distance * (1 + sign * DISTANCE_ROUNDING)) ** 2 for sign in (-1, 1)]
        is_right = all(bounds[0] <= squared <= bounds[1] for squared in (largest, dot(gap, gap)))
        at_most = float(fractions.Fraction(largest) / self.factor ** 2) ** 0.5
        self.tell("farthest_vertex", "" if is_right else f"the certificate says {stated['distance']!r}, the files {at_most!r}; at {self.shown(place)}")


def shortened(value):
    text = json.dumps(value)
    return text if len(text) <= 60 else text[:57] + "..."


def main(words):
    if not words or words[0].startswith("-"):
        print(__doc__.strip())
        return CONFIRMED if words[:1] in (["-h"], ["--help"]) else UNREADABLE
    try:
        path = pathlib.Path(words[0])
        certificate = json.loads(path.read_text("utf-8"))
        if certificate.get("format") != FORMAT:
            raise Unreadable(f"{path}: not a certificate of the format {FORMAT!r}")
        stated = [about["file"] for about in [*certificate["inputs"], certificate["result"]]]
        beside = [name if pathlib.Path(name).exists() else path.parent / pathlib.Path(name).name for name in stated]
        files = words[1:] or [str(name) for name in beside]
        if len(files) != len(stated):
            raise Unreadable(f"{path}: the certificate is about {len(stated)} files, and {len(files)} are named")
        verifier = Verifier(certificate, files)
        verifier.verify()
    except (Unreadable, OSError, json.JSONDecodeError, RecursionError, UnicodeDecodeError) as error:
        print(f"verify.py: {error}", file=sys.stderr)
        return UNREADABLE
    except (AttributeError, IndexError, KeyError, TypeError, ValueError, OverflowError) as error:
        print(f"verify.py: {words[0]}: not a sound certificate ({error!r})", file=sys.stderr)
        return UNREADABLE
    return REFUTED if verifier.is_refuted else CONFIRMED


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
