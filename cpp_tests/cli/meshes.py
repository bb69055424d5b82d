"""Shared by the tests of the program: runs it, and reads and writes files independently of it."""

import json
import math
import pathlib
import struct
import subprocess


class Program:
    """The program with a plugin, in a folder of its own."""

    def __init__(self, program, plugin, folder):
        self.program, self.plugin, self.folder = program, plugin, pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)

    def command(self, *arguments):
        return [self.program, "--plugin", self.plugin, *map(str, arguments)]

    def __call__(self, *arguments):
        return subprocess.run(self.command(*arguments), cwd=self.folder, capture_output=True, text=True, timeout=300)

    def expect(self, test, status, *arguments, says=""):
        """Runs it; what goes wrong must be said where errors go, and as much of it as `says`."""
        done = self(*arguments)
        test.assertEqual(done.returncode, status, f"{arguments}\n{done.stdout}{done.stderr}")
        test.assertIn(says, done.stderr if status else done.stdout + done.stderr)
        return done

    def filters(self):
        """For each id: the kinds of its inputs, the number needed, and the kinds of its outputs. Inputs of any number count three
        times."""
        found = {}
        for line in self("filters").stdout.splitlines():
            name, inputs, outputs, _ = [part.strip() for part in line.split("  ") if part.strip()]
            kinds = [] if inputs == "-" else inputs.rstrip(".").split(", ")
            # Inputs after a bracket are optional.
            needed = sum(kind != "-" and kind != "" for kind in inputs.split("[")[0].rstrip(".").split(", "))
            kinds = [kind.strip("[]") for kind in kinds]
            if inputs.endswith("..."):
                kinds += kinds[-1:] * (3 - len(kinds))
            found[name] = (kinds, needed, outputs.removeprefix("-> ").split(", "))
        return found


def read_obj(path):
    """Vertices, faces and lines, from 0."""
    vertices, faces, lines = [], [], []
    for line in pathlib.Path(path).read_text().splitlines():
        head, *rest = line.split() or [""]
        if head == "v":
            vertices.append(tuple(map(float, rest)))
        elif head in ("f", "l"):
            (faces if head == "f" else lines).append([int(corner.split("/")[0]) - 1 for corner in rest])
    return vertices, faces, lines


def write_obj(path, vertices, faces=(), lines=()):
    rows = ["v " + " ".join(map(repr, map(float, vertex))) for vertex in vertices]
    for head, all_of in (("f", faces), ("l", lines)):
        rows += [head + "".join(f" {corner + 1}" for corner in one) for one in all_of]
    pathlib.Path(path).write_text("\n".join(rows) + "\n")


def write_off(path, vertices, faces):
    rows = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    rows += [" ".join(map(repr, map(float, vertex))) for vertex in vertices]
    rows += [f"{len(face)} " + " ".join(map(str, face)) for face in faces]
    pathlib.Path(path).write_text("\n".join(rows) + "\n")


def read_off(path):
    numbers = iter(word for line in pathlib.Path(path).read_text().splitlines()[1:] if not line.startswith("#")
                   for word in line.split())
    counts = [int(next(numbers)) for _ in range(3)]
    vertices = [tuple(float(next(numbers)) for _ in range(3)) for _ in range(counts[0])]
    return vertices, [[int(next(numbers)) for _ in range(int(next(numbers)))] for _ in range(counts[1])]


def grid(rows, columns, height):
    """A sheet of quads in rows and columns; height(i, j) is z."""
    vertices = [(j, i, height(i, j)) for i in range(rows) for j in range(columns)]
    corner = lambda i, j: i * columns + j
    faces = [[corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)]
             for i in range(rows - 1) for j in range(columns - 1)]
    return vertices, faces


def tube(count, low, high):
    """An open tube of quads about the z axis."""
    vertices = [(math.cos(math.tau * k / count), math.sin(math.tau * k / count), z) for z in (low, high)
                for k in range(count)]
    faces = [[k, (k + 1) % count, count + (k + 1) % count, count + k] for k in range(count)]
    return vertices, faces


def rims(faces):
    """The number of edges that have one face."""
    count = {}
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            edge = (min(a, b), max(a, b))
            count[edge] = count.get(edge, 0) + 1
    return sum(1 for faces_there in count.values() if faces_there == 1)


def read_ply(path):
    """The elements of a PLY file of text: for each name its rows, each a list of numbers and of lists by property."""
    rows = iter(pathlib.Path(path).read_text().splitlines())
    elements, found = [], {}
    for row in rows:
        words = row.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append((words[-1], words[1] == "list"))
        elif words[0] == "end_header":
            break
    for name, count, properties in elements:
        found[name] = []
        for _ in range(count):
            numbers, values = iter(map(float, next(rows).split())), {}
            for known, is_list in properties:
                values[known] = [next(numbers) for _ in range(int(next(numbers)))] if is_list else next(numbers)
            found[name].append(values)
    return found


def counts(path):
    """Vertices and faces, told by the file itself; of an STL file, distinct positions and facets."""
    path = pathlib.Path(path)
    data = path.read_bytes()
    kind = path.suffix.lower()
    if kind == ".obj":
        vertices, faces, _ = read_obj(path)
        return len(vertices), len(faces)
    if kind == ".off":
        words = [row.split("#")[0] for row in data.decode().splitlines()]
        numbers = [int(word) for row in words for word in row.split()[:3] if word.isdigit()]
        return numbers[0], numbers[1]
    if kind == ".ply":
        header = data[:data.index(b"end_header")].decode().split("\n")
        told = dict(row.split()[1:] for row in header if row.startswith("element"))
        return int(told["vertex"]), int(told.get("face", 0))
    if kind == ".stl":
        count = struct.unpack_from("<I", data, 80)[0]
        assert len(data) == 84 + 50 * count, path
        corners = {struct.unpack_from("<3f", data, 84 + 50 * f + 12 + 12 * k) for f in range(count) for k in range(3)}
        return len({tuple(x + 0.0 for x in corner) for corner in corners}), count
    length = struct.unpack_from("<I", data, 12)[0]
    model = json.loads(data[20:20 + length] if kind == ".glb" else data)
    primitive = model["meshes"][0]["primitives"][0]
    accessors = model["accessors"]
    return accessors[primitive["attributes"]["POSITION"]]["count"], accessors[primitive["indices"]]["count"] // 3


def write_glb(path, positions, faces, node=None, extensions=(), pairs=(), **more):
    """Triangles in a binary glTF file. node: the node that shows them. pairs: texture coordinates of the vertices. more:
    changes to the whole."""
    blob = b"".join(struct.pack("<3f", *p) for p in positions) + b"".join(struct.pack("<3H", *f) for f in faces)
    blob += bytes(-len(blob) % 4) + b"".join(struct.pack("<2f", *pair) for pair in pairs)
    blob += bytes(-len(blob) % 4)
    split = 12 * len(positions)
    model = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, **(node or {})}],
             "buffers": [{"byteLength": len(blob)}],
             "bufferViews": [{"buffer": 0, "byteLength": split},
                             {"buffer": 0, "byteOffset": split, "byteLength": 6 * len(faces)}],
             "accessors": [{"bufferView": 0, "componentType": 5126, "count": len(positions), "type": "VEC3"},
                           {"bufferView": 1, "componentType": 5123, "count": 3 * len(faces), "type": "SCALAR"}],
             "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]}
    if pairs:
        model["bufferViews"].append({"buffer": 0, "byteOffset": len(blob) - 8 * len(pairs), "byteLength": 8 * len(pairs)})
        model["accessors"].append({"bufferView": 2, "componentType": 5126, "count": len(pairs), "type": "VEC2"})
        model["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 2
    if extensions:
        model["extensionsRequired"] = model["extensionsUsed"] = list(extensions)
    model.update(more)
    text = json.dumps(model).encode()
    text += b" " * (-len(text) % 4)
    head = struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(blob)) + struct.pack("<I4s", len(text), b"JSON")
    pathlib.Path(path).write_bytes(head + text + struct.pack("<I4s", len(blob), b"BIN\0") + blob)
