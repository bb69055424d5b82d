"""Formats of files, from each to each: test_formats.py PROGRAM PLUGIN FOLDER DATA; GUSSET_DATA goes before DATA. Converts meshes
made here, and all real ones if available: counts stay, and attributes stay or their loss is reported."""

import json
import os
import pathlib
import re
import struct
import sys
import unittest

import meshes
from meshes import grid, read_obj, read_off, read_ply, write_glb, write_obj, write_off

DONE, USAGE, FILE = range(3)
FORMATS = ("obj", "ply", "stl", "off", "gltf", "glb")

# A triangle, a quad and a concave pentagon around a vertex. Coordinates need all digits, except in
# single precision, an unused vertex, and two vertices in one place.
POINTS = [(0, 0, 0), (1, 0, 0), (0.5, 1, 0), (-1, 0, 0.25), (-1, 1, 0.25), (0, 2, 0), (0.25, 1.5, 0), (9, 9, 9), (-1, 0, 0.25)]
FACES = [[0, 1, 2], [8, 0, 2, 4], [2, 6, 5, 3, 4]]
COLOURS = [(255, 0, 0, 255), (0, 128, 255, 255), (1, 2, 3, 128), (200, 100, 50, 255), (17, 34, 51, 0), (255, 255, 255, 255),
           (0, 0, 0, 255), (90, 80, 70, 60), (1, 1, 1, 255)]
NORMALS = [(0, 0, 1), (1, 0, 0), (0, 1, 0), (0, -1, 0), (0.5, 0.5, -0.5), (0, 0, -1), (1, 0, 0), (0, 0, 1), (0, 1, 0)]
PAIRS = [(0, 0), (1, 0), (0.5, 0.75), (0.25, 0.125), (0, 1), (1, 1), (0.5, 0.5), (0, 0), (0.125, 0.25)]


def write_rich(path, textures="vertices"):
    """All that a PLY file can say of a mesh."""
    head = ["ply", "format ascii 1.0", "comment TextureFile stone.png", f"element vertex {len(POINTS)}"]
    head += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    head += [f"property uchar {name}" for name in ("red", "green", "blue", "alpha")]
    head += ["property float s", "property float t"] if textures == "vertices" else []
    head += ["property float quality", f"element face {len(FACES)}", "property list uchar int vertex_indices"]
    head += [f"property uchar {name}" for name in ("red", "green", "blue")]
    head += ["property list uchar float texcoord"] if textures == "corners" else []
    head += ["end_header"]
    rows = [(*point, *normal, *colour, *(pair if textures == "vertices" else ()), 7)
            for point, normal, colour, pair in zip(POINTS, NORMALS, COLOURS, PAIRS)]
    for f, face in enumerate(FACES):
        corners = [x for k in range(len(face)) for x in (k / 8, f / 4)] if textures == "corners" else []
        rows.append((len(face), *face, 10 * f, 20, 30, *([len(corners), *corners] if corners else [])))
    pathlib.Path(path).write_text("\n".join(head + [" ".join(map(str, row)) for row in rows]) + "\n")


class Formats(unittest.TestCase):
    program = data = None

    def expect(self, status, *arguments, says=""):
        return self.program.expect(self, status, *arguments, says=says)

    def at(self, name):
        return self.program.folder / name

    def convert(self, a, b, *options):
        """The report on the way from a to b; its losses are those on the standard error."""
        done = self.expect(DONE, "convert", a, "-o", b, "--json", *options)
        report = json.loads(done.stdout)
        found = report["inputs"][0]
        lost = report["outputs"][0]["lost"]
        self.assertEqual(done.stderr.splitlines(), [f"gusset: {a}: note: {note}" for note in found["notes"]] + [f"gusset: {b}: lost: {what}" for what in lost])
        return found, found["notes"] + lost

    def test_each_to_each(self):
        write_rich(self.at("rich.ply"))
        for a in FORMATS:
            _, first = self.convert("rich.ply", f"a.{a}")
            for b in FORMATS:
                with self.subTest(a=a, b=b):
                    held, lost = self.convert(f"a.{a}", f"b.{b}", "--text")
                    again, _ = self.convert(f"b.{b}", "end.ply", "--text")
                    if not any("corners: cut" in text for text in lost):
                        self.assertEqual(again["faces"], held["faces"])
                    if b != "stl":
                        self.assertEqual(again["vertices"], held["vertices"])
                    # A lost attribute was reported.
                    for name in set(held["attributes"]) - set(again["attributes"]):
                        self.assertTrue(any(name.removesuffix(" of vertices").removesuffix(" of corners") in text for text in lost), (name, lost))
                    self.assertEqual(set(again["attributes"]) - set(held["attributes"]), set())

    def test_attributes_come_through_unchanged(self):
        for textures, able in (("vertices", "obj ply off gltf glb"), ("corners", "obj ply gltf glb")):
            write_rich(self.at("rich.ply"), textures)
            self.convert("rich.ply", "plain.ply", "--text")
            whole = read_ply(self.at("plain.ply"))
            for kind in able.split():
                _, lost = self.convert("rich.ply", f"way.{kind}")
                self.assertEqual(any("quality of vertices" in text for text in lost), kind != "ply", lost)
                # The image is a material, except in PLY files.
                self.assertEqual(any("materials" in text for text in lost), kind == "off", lost)
                self.convert(f"way.{kind}", "back.ply", "--text")
                back = read_ply(self.at("back.ply"))
                no_opacity = any("opacity" in text for text in lost)
                self.assertEqual(len(back["face"]), len(FACES))
                for now, was in zip(back["vertex"], whole["vertex"], strict=True):
                    # OBJ files have normals and textures at corners: none where no face is.
                    unused = kind == "obj" and was["x"] == 9
                    for name, value in was.items():
                        if not (name == "alpha" and no_opacity) and not (unused and name in ("nx", "ny", "nz", "s", "t")) \
                                and (name != "quality" or kind == "ply"):
                            self.assertEqual(now[name], value, (kind, textures, name))
                for now, was in zip(back["face"], whole["face"], strict=True):
                    self.assertEqual(*(self.turned(face["vertex_indices"], face.get("texcoord")) for face in (now, was)))
                    if "red" in now:
                        self.assertEqual([now[c] for c in ("red", "green", "blue")], [was[c] for c in ("red", "green", "blue")])
                    else:
                        self.assertTrue(any("colours of faces" in text for text in lost), lost)

    @staticmethod
    def turned(face, pairs):
        """Corners with their pairs, from the least one on."""
        corners = [(v, *(pairs[2 * k:2 * k + 2] if pairs else ())) for k, v in enumerate(face)]
        first = corners.index(min(corners))
        return corners[first:] + corners[:first]

    def test_digits(self):
        points = [(1 / 3, 0.1, -1.0000000000000002), (1e-300, 2e17, 3), (0.1, 0.7, 1e22)]
        write_off(self.at("digits.off"), points, [[0, 1, 2]])
        for kind in ("obj", "ply", "off"):
            _, lost = self.convert("digits.off", f"digits2.{kind}")
            self.assertEqual(lost, [])
            self.convert(f"digits2.{kind}", "digits3.off")
            self.assertEqual(read_off(self.at("digits3.off"))[0], points)
        for kind in ("stl", "glb", "gltf"):
            _, lost = self.convert("digits.off", f"digits2.{kind}")
            self.assertIn("single precision", lost[0])
        self.assertEqual(self.convert("digits.off", "digits2.stl", "--text")[1], [])

    def test_colours_of_other_kinds(self):
        def vertices(name):
            self.convert(name, "end.ply", "--text")
            return [tuple(row.get(c) for c in ("red", "green", "blue", "alpha")) for row in read_ply(self.at("end.ply"))["vertex"]]

        head = "3 1 0\n"
        tail = "3 0 1 2\n"
        # As MeshLab writes it: steps of colours before normals, which need not be of length 1.
        self.at("nc.off").write_text("NCOFF\n" + head + "0 0 0 255 0 0 255 0 0 2.5\n1 0 0 0 255 0 255 0 0.5 2\n0 1 0 0 0 255 255 0 0 1\n" + tail)
        self.assertEqual(vertices("nc.off"), [(255, 0, 0, None), (0, 255, 0, None), (0, 0, 255, None)])
        self.assertEqual([row["nz"] for row in read_ply(self.at("end.ply"))["vertex"]], [2.5, 2, 1])
        # As Geomview has it: normals first; and parts from 0 to 1.
        self.at("cn.off").write_text("CNOFF\n" + head + "0 0 0 0 0 1 1 0 0 1\n1 0 0 0 0 1 0 1 0 1\n0 1 0 0 0 1 0 0 .2 .6\n" + tail)
        self.assertEqual(vertices("cn.off"), [(255, 0, 0, 255), (0, 255, 0, 255), (0, 0, 51, 153)])
        self.at("c.off").write_text("COFF\n# none\n" + head + "0 0 0 9 8 7\n1 0 0 6 5 4 # green\n0 1 0 3 2 255\n" + tail)
        self.assertEqual(vertices("c.off"), [(9, 8, 7, None), (6, 5, 4, None), (3, 2, 255, None)])
        self.at("bare.off").write_text("3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 128 0\n")
        self.assertEqual(vertices("bare.off"), [(None,) * 4] * 3)
        self.assertEqual([read_ply(self.at("end.ply"))["face"][0][c] for c in ("red", "green", "blue")], [255, 128, 0])

    def test_binary_ply_of_either_order(self):
        write_rich(self.at("rich.ply"), "corners")
        self.convert("rich.ply", "text.ply", "--text")
        self.convert("rich.ply", "little.ply")
        self.convert("little.ply", "again.ply", "--text")
        self.assertEqual(self.at("again.ply").read_text(), self.at("text.ply").read_text())
        points = [(0.5, 1, 2), (3, 4, 5), (6, 7, 8)]
        for order, name in (("<", "little"), (">", "big")):
            head = f"ply\nformat binary_{name}_endian 1.0\nelement vertex 3\nproperty double x\nproperty float y\nproperty short z\n"
            head += "element face 1\nproperty list ushort uint vertex_index\nelement edge 1\nproperty int a\nend_header\n"
            body = b"".join(struct.pack(order + "dfh", *point) for point in points)
            self.at("order.ply").write_bytes(head.encode() + body + struct.pack(order + "H3Ii", 3, 0, 1, 2, 5))
            _, lost = self.convert("order.ply", "order.off")
            self.assertEqual(lost, ['the element "edge" of 1 row is left out'])
            self.assertEqual(read_off(self.at("order.off")), (points, [[0, 1, 2]]))

    def test_scenes_of_gltf(self):
        points, faces = [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]
        write_glb(self.at("moved.glb"), points, faces, {"translation": [1, 2, 3], "scale": [2, 2, -2]})
        self.convert("moved.glb", "moved.off")
        # A mirror turns faces over.
        self.assertEqual(read_off(self.at("moved.off")), ([(1, 2, 3), (3, 2, 3), (1, 4, 3)], [[0, 2, 1]]))
        turn = {"rotation": [0, 0, 0.5**0.5, 0.5**0.5]}
        twice = [{"children": [1], **turn}, {"mesh": 0, "translation": [1, 0, 0]}, {"mesh": 0}]
        write_glb(self.at("twice.glb"), points, faces, nodes=twice, scenes=[{"nodes": [0, 2]}])
        self.convert("twice.glb", "twice.off")
        found, corners = read_off(self.at("twice.off"))
        self.assertEqual(corners, [[0, 1, 2], [3, 4, 5]])
        for got, wanted in zip(found, [(0, 1, 0), (0, 2, 0), (-1, 1, 0), *points], strict=True):
            for a, b in zip(got, wanted):
                self.assertAlmostEqual(a, b, delta=1e-15)
        write_glb(self.at("packed.glb"), points, faces, extensions=["KHR_draco_mesh_compression"])
        self.expect(FILE, "convert", "packed.glb", "-o", "a.off", says="the file requires the extension KHR_draco_mesh_compression, which is not read; decompress it by gltf-transform")
        write_glb(self.at("lost.glb"), points, [(0, 1, 7)])
        self.expect(FILE, "convert", "lost.glb", "-o", "a.off",
                    says="lost.glb: mesh 0, primitive 0, face 0, corner 2: vertex 7 does not exist (the mesh has 3)")
        write_glb(self.at("circle.glb"), points, faces, nodes=[{"children": [0]}])
        self.expect(FILE, "convert", "circle.glb", "-o", "a.off", says="circle.glb: node 0 is its own ancestor")
        self.at("short.glb").write_bytes(self.at("moved.glb").read_bytes()[:60])
        self.expect(FILE, "convert", "short.glb", "-o", "a.off", says="short.glb: ")

    def test_triangles_are_cut_as_the_polygon_is(self):
        # An arrow head: a fan from two of its corners folds over.
        arrow = [(0, 0, 0), (2, -1, 0), (1, 0, 0), (2, 1, 0)]
        for first in range(4):
            write_off(self.at("arrow.off"), arrow, [[(first + k) % 4 for k in range(4)]])
            self.convert("arrow.off", "arrow.stl", "--text")
            normals = [row.split()[-1] for row in self.at("arrow.stl").read_text().splitlines() if "normal" in row]
            self.assertEqual(normals, ["1", "1"])

    def range_image(self, name, rows=9, columns=12, obj_info=True):
        """A plane with a step to another behind it, without a corner: the existing cells, and the cells of the step."""
        missing = {(0, 0), (4, 6)}
        seen = [(i, j) for i in range(rows) for j in range(columns) if (i, j) not in missing]
        depth = lambda i, j: 0 if j < 8 else -20
        head = ["ply", "format ascii 1.0"] + ([f"obj_info num_cols {columns}", f"obj_info num_rows {rows}"] if obj_info else [])
        head += [f"element vertex {len(seen)}", "property float x", "property float y", "property float z"]
        head += [f"element range_grid {rows * columns}", "property list uchar int vertex_indices", "end_header"]
        points = [f"{j} {i} {depth(i, j)}" for i, j in seen]
        grid = [f"1 {seen.index((i, j))}" if (i, j) in seen else "0" for i in range(rows) for j in range(columns)]
        self.at(name).write_text("\n".join(head + points + grid) + "\n")
        # Two triangles a cell, one for those with a missing corner, none across the step.
        return 2 * (rows - 1) * (columns - 2) - 1 - 4

    def test_range_images_become_meshes(self):
        faces = self.range_image("range.ply")
        held, _ = self.convert("range.ply", "range.off")
        self.assertEqual(held["faces"], faces)
        self.assertTrue(all(face for face in read_off(self.at("range.off"))[1]))
        self.range_image("unsized.ply", obj_info=False)
        self.expect(FILE, "check", "unsized.ply", says="it has no faces")
        text = self.at("range.ply").read_text()
        self.at("beyond.ply").write_text(text[: text.rindex("1 ")] + "1 999\n")
        self.expect(FILE, "check", "beyond.ply", says="vertex 999 does not exist")

    def test_lists_of_scans_place_them(self):
        self.range_image("one.ply")
        self.range_image("two.ply")
        half = 0.5 ** 0.5
        self.at("all.conf").write_text(f"camera 0 0 0 0 0 0 1\nbmesh one.ply 0 0 0 0 0 0 1\nbmesh two.ply 100 0 0 0 0 {half} {half}\n")
        self.expect(DONE, "run", "align", "all.conf", "-o", "both.off")
        points = read_off(self.at("both.off"))[0]
        count = len(points) // 2
        for (x, y, z), (u, v, w) in zip(points[:count], points[count:]):
            # The quaternion turns the axes by a quarter, and so the points back by one.
            self.assertAlmostEqual(u, 100 + y, places=5)
            self.assertAlmostEqual(v, -x, places=5)
            self.assertAlmostEqual(w, z, places=5)
        for text, says in (("", "the list names no scans"), ("bmesh one.ply 0 0 0 0 0 0 0\n", "1: the quaternion has length 0"),
                           ("bmesh one.ply 0 0 0 0 x 0 1\n", '1: "bmesh" needs'), ("bmesh one.ply 0 0 0\n", '1: "bmesh" needs'),
                           ("bmesh none.ply 0 0 0 0 0 0 1\n", "1: none.ply: the file does not exist")):
            self.at("wrong.conf").write_text(text)
            self.expect(FILE, "run", "align", "wrong.conf", "-o", "both.off", says=says)

    def test_what_is_wrong_is_pointed_at(self):
        wrong = {
            "a.off": ("OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", '4: vertex 1: "x" is not a number'),
            "b.off": ("OFF\n3 1 0\n0 0 0\n1 0 0\n", "5: vertex 2: the file ends before its numbers"),
            "c.off": ("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "6: face 0, corner 2: vertex 3 does not exist (the mesh has 3)"),
            "d.off": ("OFF BINARY\n", "byte 11: counts: the file ends"),
            "e.off": ("solid\n", '1: the file begins with "solid", not with OFF'),
            "f.off": ("", "1: the file is empty"),
            "g.off": ("COFF\n1 1 0\n0 0 0 1\n", "3: vertex 0: 1 number follows its position"),
            "a.obj": ("v 0 0 0\nv 1 0 0\n\nv 1 one 0\n", '4: vertex 2: "one" is not a number'),
            "b.obj": ("v 0 0\n", "1: vertex 0: it has 2 coordinates instead of 3"),
            "c.obj": ("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 5\n", "5: face 1, corner 2: vertex 5 does not exist (the mesh has 3)"),
            "d.obj": ("v 0 0 0\nf 0 1 2\n", "2: face 0, corner 0: vertex 0 does not exist (vertices count from 1)"),
            "g.obj": ("v 0 0 0\n", "it has no faces"),
            "a.ply": ("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nend_header\n1 2\n", "the vertices lack the properties x, y and z"),
            "b.ply": ("ply\nformat ascii 2\nelement point\n", "3: an element needs a name and a count"),
            "c.ply": ("", '1: the first line is not "ply"'),
            "d.ply": ("ply\nformat ascii 1.0\nelement vertex 1\nproperty long x\n", '4: "long" is not a type: use uchar'),
            "e.ply": ("ply\nformat binary_little_endian 1.0\nelement vertex 9\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
                      + "ab", "the file ends in vertex 0; the header announces 9"),
            "f.ply": ("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
                      "property list uchar int vertex_indices\nend_header\n0 0 0\n3 0 0 1\n", "11: face 0, corner 2: vertex 1 does not exist (the mesh has 1)"),
            "a.stl": ("no mesh at all\n", '1: the file does not begin with "solid", and is too short for a binary STL file'),
            "b.stl": ("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n", '6: facet 0: "endloop" where "vertex" must be'),
            "c.stl": ("x" * 80 + "\x02\0\0\0" + "y" * 60, "facet 1: the file ends; its header announces 2 facets"),
            "a.gltf": ("{}", "a.gltf: "),
            "b.gltf": ("[1, 2", "b.gltf: "),
        }
        for name, (text, says) in wrong.items():
            with self.subTest(file=name):
                self.at(name).write_bytes(text.encode("latin-1"))
                self.expect(FILE, "check", name, says=says if says.startswith(name) else f"{name}:")
                self.expect(FILE, "check", name, says=says)
        self.expect(FILE, "check", "nowhere.ply", says="nowhere.ply: the file does not exist")
        self.at("folder.ply").mkdir(exist_ok=True)
        self.expect(FILE, "check", "folder.ply", says="folder.ply: the folder has no mesh files")
        write_off(self.at("fine.off"), POINTS, FACES)
        for kind in FORMATS:
            self.expect(FILE, "convert", "fine.off", "-o", f"no/such/folder/a.{kind}", says=f"no/such/folder/a.{kind}: ")
        if os.path.exists("/dev/full"):
            for kind in FORMATS:
                self.at(f"full.{kind}").unlink(missing_ok=True)
                self.at(f"full.{kind}").symlink_to("/dev/full")
                self.expect(FILE, "convert", "fine.off", "-o", f"full.{kind}", says=f"full.{kind}: ")

    def test_all_real_meshes(self):
        folder = pathlib.Path(self.data) / "meshes"
        if not folder.is_dir():
            print(f"SKIPPED: no real meshes in {self.data}; set GUSSET_DATA to the folder that has them")
            return
        known = {f".{kind}" for kind in FORMATS}
        tried = 0
        for file in sorted(folder.iterdir()):
            if file.suffix == ".conf":
                continue
            if file.suffix.lower() not in known:
                self.expect(FILE, "check", file, says="meshes are in")
                continue
            vertices, faces = meshes.counts(file)
            if faces == 0 and b"element range_grid" in file.read_bytes()[:4096]:
                self.expect(DONE, "check", file)
                continue
            if faces == 0:
                self.expect(FILE, "check", file, says=f"it has no faces, only {vertices} points")
                continue
            for kind in FORMATS:
                with self.subTest(file=file.name, kind=kind):
                    held, lost = self.convert(file, f"real.{kind}")
                    self.assertEqual((held["vertices"], held["faces"]), (vertices, faces))
                    again, _ = self.convert(f"real.{kind}", "end.ply")
                    gone = set(held["attributes"]) - set(again["attributes"])
                    self.assertTrue(all(any(name.split(" of ")[0] in text for text in lost) for name in gone), (gone, lost))
                    cut = [int(text.split()[0]) for text in lost if "cut into triangles" in text]
                    fewer = sum(int(found[1]) for text in lost
                                if (found := re.search(r"(\d+) (?:vertex|vertices)(?: that no face uses| and others)", text)))
                    # Single precision may make more of them one; that is counted too.
                    self.assertEqual(again["vertices"], vertices - fewer)
                    self.assertEqual(again["faces"] > faces, bool(cut))
                    if not cut:
                        self.assertEqual(again["faces"], faces)
                    tried += 1
        print(f"{tried} conversions of real meshes")
        self.assertGreater(tried, 100)


if __name__ == "__main__":
    Formats.program = meshes.Program(*sys.argv[1:4])
    Formats.data = os.environ.get("GUSSET_DATA", sys.argv[4])
    unittest.main(argv=sys.argv[:1])
