"""Certificates, and what verify.py says of them: test_certificates.py PROGRAM PLUGIN FOLDER VERIFY [RESULTS].

Writes certificates for results of random meshes, all to be confirmed, and certificates with a lie of each kind, all to be refuted. RESULTS
is the number of results, 40 by default."""

import contextlib
import hashlib
import importlib.util
import io
import json
import math
import os
import pathlib
import random
import sys
import unittest

import meshes
from meshes import grid, tube, write_obj, write_off

DONE, USAGE = 0, 1
CONFIRMED, REFUTED, UNREADABLE = range(3)

CUBE = [(x, y, z) for x in (0, 2) for y in (0, 2) for z in (0, 2)]
CUBE_FACES = [[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]


def moved(points, scale, by):
    return [tuple(scale * x + shift for x, shift in zip(point, by)) for point in points]


def joined(*parts):
    """Parts side by side in one mesh."""
    points, faces = [], []
    for own_points, own_faces in parts:
        faces += [[v + len(points) for v in face] for face in own_faces]
        points += own_points
    return points, faces


def turned(faces):
    return [face[:1] + face[:0:-1] for face in faces]


def ball(rows, columns, radius=1.0, centre=(0, 0, 0)):
    """A closed ball of triangles and quads."""
    points = [(0, 0, -1)]
    for i in range(1, rows):
        polar = math.pi * i / rows
        points += [(math.sin(polar) * math.cos(math.tau * j / columns), math.sin(polar) * math.sin(math.tau * j / columns), -math.cos(polar))
                   for j in range(columns)]
    points.append((0, 0, 1))
    at = lambda i, j: 1 + (i - 1) * columns + j % columns
    faces = [[0, at(1, j + 1), at(1, j)] for j in range(columns)] + [[len(points) - 1, at(rows - 1, j), at(rows - 1, j + 1)] for j in range(columns)]
    faces += [[at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)] for i in range(1, rows - 1) for j in range(columns)]
    return moved(points, radius, centre), faces


def damaged(mesh, chance):
    """A mesh with defects: faces that lack, are there twice, are turned, or have a vertex of their own."""
    points, faces = list(mesh[0]), []
    for face in mesh[1]:
        kind = chance.random()
        if kind < 0.06:
            continue
        faces.append(turned([face])[0] if kind < 0.12 else list(face))
        if kind > 0.95:
            faces.append(faces[-1][1:] + faces[-1][:1])
        elif kind > 0.9:
            points.append(points[faces[-1][0]])
            faces[-1][0] = len(points) - 1
        elif kind > 0.88:
            faces.append([face[0], face[1], face[0]])
    return points, faces or [list(mesh[1][0])]


class Certificates(unittest.TestCase):
    program = verify = None
    results = 40

    def at(self, name):
        return self.program.folder / name

    def verified(self, *files):
        """The exit status of verify.py, and the claims that it confirms and refutes."""
        out = io.StringIO()
        # Names in certificates are relative to the folder of the program.
        os.chdir(self.program.folder)
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            status = self.verify.main([str(file) for file in files])
        lines = [line.split(": ") for line in out.getvalue().splitlines()]
        return status, {line[1] for line in lines if line[0] == "confirmed"}, {line[1] for line in lines if line[0] == "refuted"}, out.getvalue()

    def expect_confirmed(self, *files):
        status, confirmed, _, told = self.verified(*files)
        self.assertEqual(status, CONFIRMED, told)
        self.assertGreater(len(confirmed), 20)
        return confirmed

    def certified(self, inputs, result, name="stated.json"):
        """The certificate of some files."""
        done = self.program("certify", *inputs, result, "-o", name)
        self.assertEqual(done.returncode, DONE, done.stderr)
        return json.loads(self.at(name).read_text())

    def write_cubes(self):
        """A cube with a cavity, and an open input whose faces it mostly keeps."""
        hollow = joined((CUBE, CUBE_FACES), (moved(CUBE, 0.25, (0.5, 0.5, 0.5)), turned(CUBE_FACES)))
        write_obj(self.at("hollow.obj"), *hollow)
        write_obj(self.at("open.obj"), hollow[0] + [(0.1, 3, 0)], turned(hollow[1][:1]) + hollow[1][1:-1] + [[0, 1, 16]])
        return hollow

    def test_every_operation_writes_one(self):
        write_obj(self.at("low.obj"), *tube(9, 0, 1))
        write_off(self.at("high.off"), *tube(12, 1.5, 2.5))
        for name, inputs in (("fill", ["low.obj"]), ("repair", ["low.obj"]), ("stitch", ["low.obj", "high.off"]), ("join", ["low.obj", "high.off"]),
                             ("trim", ["low.obj", "high.off"])):
            for kind, options in (("obj", []), ("off", []), ("ply", []), ("ply", ["--text"]), ("stl", ["--lossy"]), ("stl", ["--text"])):
                done = self.program(name, *inputs, "-o", f"{name}.{kind}", "--certificate", f"{name}.json", *options)
                self.assertEqual(done.returncode, DONE, done.stderr)
                self.expect_confirmed(f"{name}.json")
        claims = json.loads(self.at("fill.json").read_text())["claims"]
        self.assertIs(claims["closed"] and claims["manifold"] and claims["outward"] and claims["no_intersecting_faces"], True)

    def test_both_ways_to_write_one_agree(self):
        write_obj(self.at("low.obj"), *tube(9, 0, 1))
        self.program.expect(self, DONE, "fill", "low.obj", "-o", "full.ply", "--certificate", "one.json")
        self.program.expect(self, DONE, "certify", "low.obj", "full.ply", "-o", "two.json", "--threads", "1")
        self.assertEqual(self.at("one.json").read_bytes(), self.at("two.json").read_bytes())
        self.assertEqual(self.program("certify", "low.obj", "full.ply").stdout, self.at("two.json").read_text())

    def test_words_that_are_refused(self):
        write_obj(self.at("low.obj"), *tube(9, 0, 1))
        self.program.expect(self, USAGE, "fill", "low.obj", "-o", "low.obj", "--certificate", "c.json", says="low.obj would be replaced")
        self.program.expect(self, USAGE, "fill", "low.obj", "-n", "--certificate", "c.json", says="name the result with -o")
        self.program.expect(self, USAGE, "fill", "low.obj", "-o", "-", "--to", "ply", "--certificate", "c.json", says="name files instead of -")
        self.program.expect(self, USAGE, "fill", "low.obj", "--out-dir", "more", "--certificate", "c.json", says="the result of one file")
        # No mesh is lost under a page or certificate.
        for words in (("fill", "low.obj", "-o", "full.obj", "--certificate", "low.obj"), ("fill", "low.obj", "-o", "full.obj", "--certificate", "full.obj"),
                      ("fill", "low.obj", "-o", "full.obj", "--html", "./full.obj"), ("certify", "low.obj", "low.obj", "-o", "low.obj")):
            self.program.expect(self, USAGE, *words, says="is a mesh of this command")
        self.program.expect(self, USAGE, "certify", "low.obj", "-o", "c.json", says="takes one or more inputs")

    def test_parts_of_polygons_have_three_corners(self):
        # A triangle cuts the quad, which a part with four corners would hide.
        write_obj(self.at("cut.obj"), [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0.5, 0.4, -1), (0.6, 0.5, 1), (0.4, 0.6, 1)], [(0, 1, 2, 3), (4, 5, 6)])
        stated = self.certified(["cut.obj"], "cut.obj")
        self.assertEqual(self.verified("stated.json")[0], CONFIRMED)
        self.assertIs(stated["claims"]["no_intersecting_faces"], False)
        for parts in ([[0, 1, 2, 3], [2]], [[0, 1, 2, 3], [7]], [[0, 1, 2], [0, 2, 9]]):
            lie = {**stated, "polygon_triangles": parts, "claims": {**stated["claims"], "no_intersecting_faces": True, "intersecting_pairs": 0}}
            self.at("lie.json").write_text(json.dumps(lie))
            status, _, refuted, _ = self.verified("lie.json")
            self.assertEqual((status, {"polygon_triangles", "no_intersecting_faces"} <= refuted), (REFUTED, True))

    def test_files_that_cannot_be_read(self):
        self.write_cubes()
        stated = self.certified(["open.obj"], "hollow.obj")
        self.assertEqual(self.verified("stated.json", "open.obj")[0], UNREADABLE)
        self.assertEqual(self.verified("stated.json", "open.obj", "missing.obj")[0], UNREADABLE)
        self.assertEqual(self.verified("open.obj")[0], UNREADABLE)
        for broken in ({**stated, "format": "another"}, {**stated, "claims": {}}, {**stated, "inputs": 3}):
            self.at("broken.json").write_text(json.dumps(broken))
            self.assertEqual(self.verified("broken.json")[0], UNREADABLE)

    def test_lies_in_the_certificate(self):
        """Each claim by itself, made larger or turned round."""
        self.write_cubes()
        stated = self.certified(["open.obj"], "hollow.obj")
        self.assertIs(stated["claims"]["outward"], True)
        self.assertEqual((stated["claims"]["kept_faces"], stated["claims"]["turned_faces"], stated["claims"]["lost_faces"]), (22, [[0]], [[23]]))
        self.expect_confirmed("stated.json")
        lies = [(claim, lambda claims, claim=claim: claims.update({claim: not claims[claim] if isinstance(claims[claim], bool) else claims[claim] + 1}))
                for claim, value in stated["claims"].items() if isinstance(value, (bool, int)) and claim != "outward"]
        lies += [(claim, lambda claims, claim=claim, value=value: claims.update({claim: value}))
                 for claim in ("turned_faces", "lost_faces") for value in ([[]], [[0, 23]], [[1]])]
        lies += [("farthest_vertex", lambda claims, key=key, value=value: claims["farthest_vertex"].update({key: value}))
                 for key, value in (("distance", 0.5), ("distance", 0), ("at", [0, 0, 0]), ("nearest", [2, 2, 2]), ("nearest", [0.3, 2, 0]))]
        lies.append(("farthest_vertex", lambda claims: claims.update(farthest_vertex=None)))
        self.assertGreaterEqual(len({claim for claim, _ in lies}), 20)
        for claim, tell in lies:
            lie = json.loads(json.dumps(stated))
            tell(lie["claims"])
            self.expect_refuted(lie, claim)
        for path, claim in ((("inputs", 0), "sha256 of open.obj"), (("result",), "sha256 of hollow.obj")):
            lie = json.loads(json.dumps(stated))
            about = lie
            for key in path:
                about = about[key]
            about["sha256"] = hashlib.sha256(b"").hexdigest()
            self.expect_refuted(lie, claim)
        lie = json.loads(json.dumps(stated))
        lie["inputs"][0]["faces"] += 1
        self.expect_refuted(lie, "faces of input 0")

    def expect_refuted(self, lie, claim):
        self.at("lie.json").write_text(json.dumps(lie))
        status, _, refuted, told = self.verified("lie.json")
        self.assertEqual(status, REFUTED, (claim, told))
        self.assertIn(claim, refuted, told)

    def test_lies_about_the_result(self):
        """The certificate of a sound result with the name and the hash of a bad one."""
        points, faces = self.write_cubes()
        sound = self.certified(["open.obj"], "hollow.obj")
        inner = faces[12:]
        cube, more = faces[:12], [tuple(x + 1 for x in point) for point in CUBE]
        bad = {
            "closed": (points, faces[:-1]),
            "boundary_edges": (points, faces[1:]),
            "non_manifold_edges": (points + [(3, 3, 3)], faces + [[0, 1, 16]]),
            # Two cubes that share a vertex.
            "non_manifold_vertices": (points + more[1:], faces + [[7 if v == 0 else v + 15 for v in face] for face in CUBE_FACES]),
            "manifold": (points + more[1:], faces + [[7 if v == 0 else v + 15 for v in face] for face in CUBE_FACES]),
            "oriented": (points, turned(faces[:1]) + faces[1:]),
            "orientation_conflicts": (points, faces[:-1] + turned(faces[-1:])),
            # The cavity is solid within solid; then all is inside out.
            "outward": (points, cube + turned(inner)),
            "no_intersecting_faces": (moved(points[:8], 1, (0, 0, 0)) + moved(points[8:], 1, (1.2, 0, 0)), faces),
            "intersecting_pairs": (points[:8] + moved(points[8:], 1, (-0.5, 0, 0)), faces),
            "degenerate_faces": (points, faces + [[0, 1, 0]]),
            "duplicate_faces": (points, faces + [faces[3][1:] + faces[3][:1]]),
            "collinear_triangles": (points + [(1, 0, 0)], [face for face in faces if face != [0, 4, 5]] + [[0, 16, 5], [16, 4, 5], [0, 4, 16]]),
            "vertices": (points[:8], cube),
            "components": (points[:8], cube),
            "faces": (points[:8], cube),
            "edges": (points[:8], cube),
            "kept_faces": (points, faces[:5] + faces[6:]),
            "new_faces": (points, faces + [[0, 9, 10]]),
            "lost_faces": (points, faces[:2] + faces[3:]),
            "turned_faces": (points, turned(faces[:1]) + faces[1:]),
            "farthest_vertex": (points + [(0.1, 2.9, 0)], faces + [[0, 1, 16]]),
        }
        for claim, mesh in bad.items():
            write_obj(self.at("bad.obj"), *mesh)
            lie = {**sound, "result": {**sound["result"], "file": "bad.obj", "sha256": hashlib.sha256(self.at("bad.obj").read_bytes()).hexdigest()}}
            self.expect_refuted(lie, claim)
            # The true certificate of the bad mesh.
            self.certified(["open.obj"], "bad.obj", "true.json")
            self.expect_confirmed("true.json")
        for mesh in ((points, turned(faces)), (points[:8], turned(cube))):
            write_obj(self.at("bad.obj"), *mesh)
            lie = {**sound, "result": {**sound["result"], "file": "bad.obj", "sha256": hashlib.sha256(self.at("bad.obj").read_bytes()).hexdigest()}}
            self.expect_refuted(lie, "outward")

    def test_nesting_that_vertices_do_not_decide(self):
        """A tetrahedron in a cube, with all its vertices at the cube's: the certificate may claim nothing that is false."""
        cube = [[0, 1, 3], [0, 3, 2], [4, 6, 5], [6, 7, 5], [0, 4, 5], [0, 5, 1], [2, 3, 6], [3, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 3], [5, 7, 3]]
        inner = [[0, 5, 3], [0, 3, 6], [0, 6, 5], [3, 5, 6]]
        for solid in (inner, turned(inner)):
            write_obj(self.at("nested.obj"), *joined((CUBE, cube), (CUBE, solid)))
            self.assertIs(self.certified(["nested.obj"], "nested.obj")["claims"]["outward"], False)
            self.expect_confirmed("stated.json")

    def test_triangles_of_polygons(self):
        write_obj(self.at("box.obj"), CUBE, [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
        stated = self.certified(["box.obj"], "box.obj")
        self.expect_confirmed("stated.json")
        self.assertEqual(len(stated["polygon_triangles"]), 12)
        for triangles in (stated["polygon_triangles"][1:], stated["polygon_triangles"][:-1], [[0, 1, 2]] + stated["polygon_triangles"][1:],
                          [triangle[::-1] for triangle in stated["polygon_triangles"]], stated["polygon_triangles"] + [[0, 1, 2]]):
            if triangles != stated["polygon_triangles"]:
                self.expect_refuted({**stated, "polygon_triangles": triangles}, "polygon_triangles")

    def test_random_results(self):
        """Operations on random meshes, most with defects."""
        chance = random.Random(7)
        confirmed = {}
        case = 0
        while sum(confirmed.values()) < self.results:
            case += 1
            name = ("repair", "fill", "stitch", "join", "trim", "repair", "certify")[case % 7]
            kind = chance.choice(("obj", "ply", "off", "stl"))
            inputs = self.random_inputs(name, chance)
            for k, mesh in enumerate(inputs):
                write_obj(self.at(f"piece{k}.obj"), *mesh)
            files = [f"piece{k}.obj" for k in range(len(inputs))]
            if name == "certify":
                # Any two meshes, also unsound ones.
                done = self.program("certify", *files, "-o", "random.json")
            else:
                lossy = ["--lossy"] if kind == "stl" else chance.choice(([], ["--text"]))
                done = self.program(name, *files, "-o", f"random.{kind}", "--certificate", "random.json", *lossy)
            if done.returncode == 4:
                continue  # The operation refuses these meshes.
            self.assertEqual(done.returncode, DONE, (case, done.stderr))
            status, _, _, told = self.verified("random.json")
            self.assertEqual(status, CONFIRMED, (case, name, told))
            confirmed[name] = confirmed.get(name, 0) + 1
        print(f"confirmed: {sum(confirmed.values())} results: {confirmed}", file=sys.stderr)

    def random_inputs(self, name, chance):
        count = chance.randint(3, 9)
        scale, shift = chance.choice((1, 1e-3, 1e3)), [chance.choice((0, 0.1, 100)) for _ in range(3)]
        placed = lambda mesh: (moved(mesh[0], scale, shift), mesh[1])
        if name in ("stitch", "join"):
            gap = chance.choice((0, 0.3))
            return [placed(tube(count, 0, 1)), placed(tube(count if gap == 0 else chance.randint(3, 9), 1 + gap, 2))]
        if name == "trim":
            sheet = grid(count, count, lambda i, j: 0.1 * ((i * j) % 3))
            return [placed(sheet), placed((moved(sheet[0], 1, (count / 2, 0.3, 0)), sheet[1]))]
        if name == "fill":
            points, faces = ball(count, count + 1)
            gone = set(chance.sample(range(len(faces)), 2))
            return [placed((points, [face for f, face in enumerate(faces) if f not in gone]))]
        if name == "certify":
            # A lattice has touching, coplanar and coincident faces.
            points = [tuple(chance.randint(0, 2) for _ in range(3)) for _ in range(12)]
            soup = [[chance.randrange(12) for _ in range(chance.choice((3, 3, 4)))] for _ in range(10)]
            result = soup[:6] + turned(soup[6:8]) + [[chance.randrange(12) for _ in range(3)]]
            return [placed((points, soup)), placed((points, result))]
        one = ball(count, count + 1)
        other = ball(chance.randint(3, 6), 5, chance.choice((0.4, 1.0)), (chance.choice((0, 0.7, 3)), 0.01, 0.02))
        other = other if chance.random() < 0.5 else (other[0], turned(other[1]))
        whole = one if chance.random() < 0.4 else joined(one, other)
        return [placed(damaged(whole, chance) if chance.random() < 0.7 else whole)]


if __name__ == "__main__":
    Certificates.program = meshes.Program(*(pathlib.Path(word).absolute() for word in sys.argv[1:4]))
    known = importlib.util.spec_from_file_location("verify", sys.argv[4])
    Certificates.verify = importlib.util.module_from_spec(known)
    known.loader.exec_module(Certificates.verify)
    Certificates.results = int(sys.argv[5]) if len(sys.argv) > 5 else Certificates.results
    unittest.main(argv=sys.argv[:1])
