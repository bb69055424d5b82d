"""What the tests of gusset-host share: running it, and reading and writing its files without its help."""

import pathlib
import subprocess


class Host:
    """The program with a plugin, in a folder of its own."""

    def __init__(self, program, plugin, folder):
        self.program, self.plugin, self.folder = program, plugin, pathlib.Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)

    def command(self, *arguments):
        return [self.program, "--plugin", self.plugin, *map(str, arguments)]

    def __call__(self, *arguments):
        return subprocess.run(self.command(*arguments), cwd=self.folder, capture_output=True, text=True, timeout=300)

    def filters(self):
        """For each id the kinds of its inputs, how many of them it needs, and the kinds of its outputs; three of those
        inputs that may be any number."""
        found = {}
        for line in self("list").stdout.splitlines():
            name, inputs, outputs, _ = [part.strip() for part in line.split("  ") if part.strip()]
            kinds = [] if inputs == "-" else inputs.rstrip(".").split(", ")
            # What comes after a bracket may be left out.
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


def rims(faces):
    """The number of edges that have one face."""
    count = {}
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            edge = (min(a, b), max(a, b))
            count[edge] = count.get(edge, 0) + 1
    return sum(1 for faces_there in count.values() if faces_there == 1)
