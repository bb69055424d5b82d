"""Attributes of meshes through the program and its formats, as another reader sees them: Assimp."""
import json
import math
import pathlib
import shutil
import struct
import subprocess
import sys
import unittest
import zlib
from xml.etree import ElementTree

import meshes
from meshes import read_obj, read_ply, tube

assimp = shutil.which("assimp")
if assimp is None:
    print("SKIPPED: Debian's assimp-utils is not there")
    sys.exit(0)

DONE = 0


def png(red, green, blue):
    """An image of one point."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", 1, 1, 8, 2, 0, 0, 0)) +
            chunk(b"IDAT", zlib.compress(bytes([0, red, green, blue]))) + chunk(b"IEND", b""))


def textured(path, shape, library, material, shift=0.0):
    """A tube whose texture runs once round it, with a seam: the first column has two pairs."""
    vertices, faces = shape
    around = len(vertices) // 2
    rows = [f"mtllib {library}"] + ["v " + " ".join(map(repr, map(float, vertex))) for vertex in vertices]
    rows += [f"vt {shift + k / around!r} {row}" for row in (0, 1) for k in range(around + 1)]
    rows.append(f"usemtl {material}")
    for f, face in enumerate(faces):
        column = [v % around + (around if v % around == 0 and f % around == around - 1 else 0) for v in face]
        pairs = [column[k] + (v // around) * (around + 1) for k, v in enumerate(face)]
        rows.append("f " + " ".join(f"{v + 1}/{pair + 1}" for v, pair in zip(face, pairs)))
    pathlib.Path(path).write_text("\n".join(rows) + "\n")


def seen_by_assimp(path):
    """The faces of a file: corners as (position, colour, texture pair), and the material's name, colour and image."""
    dump = pathlib.Path(path).with_suffix(".assxml")
    subprocess.run([assimp, "dump", str(path), str(dump)], check=True, capture_output=True)
    scene = ElementTree.parse(dump).getroot().find("Scene")
    found = []
    materials = [material_in(material) for material in scene.iter("Material")]
    for mesh in scene.iter("Mesh"):
        def rows(name, width, digits):
            values = mesh.find(name)
            if values is None:
                return None
            numbers = [round(float(word), digits) + 0.0 for word in values.text.split()]
            step = int(values.get("num_components"))
            return [tuple(numbers[k:k + width]) for k in range(0, len(numbers), step)]
        points, colours, pairs = rows("Positions", 3, 5), rows("Colors", 3, 3), rows("TextureCoords", 2, 5)
        for face in mesh.iter("Face"):
            corners = [(points[v], colours and colours[v], pairs and pairs[v]) for v in map(int, face.text.split())]
            found.append((corners, materials[int(mesh.get("material_index"))]))
    return found


def material_in(material):
    told = {}
    for value in material.iter("MatProperty"):
        told.setdefault(value.get("key"), value.text.strip())
    colour = told.get("$clr.base") or told.get("$clr.diffuse") or "1 1 1"
    return (told.get("?mat.name", "").strip('"'), tuple(round(float(word), 3) for word in colour.split()[:3]),
            told.get("$tex.file", "").strip('"'))


class Attributes(unittest.TestCase):
    program = None

    def at(self, name):
        return self.program.folder / name

    def expect(self, status, *arguments, says=""):
        return self.program.expect(self, status, *arguments, says=says)

    def lost(self, *arguments):
        report = json.loads(self.expect(DONE, *arguments, "--json").stdout)
        return [note for one in report["inputs"] for note in one["notes"]] + report["outputs"][0]["lost"]

    def two_scans(self):
        """Two pieces of which each has its own material of the same name, in folders of their own."""
        for name, low, high, colour, shift in (("red", 0, 1, (1, 0, 0), 0.0), ("blue", 1.5, 2.5, (0, 0, 1), 0.25)):
            folder = self.at(name)
            folder.mkdir(exist_ok=True)
            (folder / "skin of it.png").write_bytes(png(*(255 * c for c in colour)))
            (folder / "all.mtl").write_text("# of a scanner\nnewmtl scan\nKd {} {} {}\nNs 10\nmap_Kd -s 1 1 1 skin of it.png\n"
                                            .format(*colour))
            textured(folder / "part.obj", tube(12, low, high), "all.mtl", "scan", shift)

    def test_materials_of_pieces_stay_apart(self):
        self.two_scans()
        lost = self.lost("stitch", "red/part.obj", "blue/part.obj", "--rows", "none", "-o", "joined.obj")
        self.assertEqual(lost, [])
        library = self.at("joined.mtl").read_text()
        self.assertEqual(library, "newmtl scan\nKd 1 0 0\nNs 10\nmap_Kd -s 1 1 1 red/skin of it.png\n"
                                  "newmtl scan_2\nKd 0 0 1\nNs 10\nmap_Kd -s 1 1 1 blue/skin of it.png\n")
        found = seen_by_assimp(self.at("joined.obj"))
        # 12 quads of either tube, and 24 new triangles.
        names = [material[0] for _, material in found]
        self.assertEqual(len(found), 12 + 12 + 24)
        self.assertEqual(set(names), {"scan", "scan_2"})
        self.assertGreater(names.count("scan"), 12)
        self.assertGreater(names.count("scan_2"), 12)
        self.assertEqual({material for _, material in found},
                         {("scan", (1, 0, 0), "red/skin of it.png"), ("scan_2", (0, 0, 1), "blue/skin of it.png")})
        # All corners have pairs, and old ones the same as in the files that came in.
        now = {(point, pair) for corners, _ in found for point, _, pair in corners}
        for name in ("red", "blue"):
            was = {(point, pair) for corners, _ in seen_by_assimp(self.at(name) / "part.obj") for point, _, pair in corners}
            self.assertEqual(was - now, set())
        self.assertTrue(all(pair is not None for _, pair in now))

    def test_gltf_and_back(self):
        self.two_scans()
        lost = self.lost("stitch", "red/part.obj", "blue/part.obj", "--rows", "none", "-o", "joined.glb")
        self.assertTrue(all("its diffuse colour and image" in text or "single precision" in text for text in lost), lost)
        was = seen_by_assimp(self.at("red/part.obj")) + seen_by_assimp(self.at("blue/part.obj"))
        found = seen_by_assimp(self.at("joined.glb"))
        now = {(corner[0], corner[2]) for corners, _ in found for corner in corners}
        # glTF hangs images from above; Assimp turns them as OBJ has them.
        rounded = lambda corners: {(point, pair) for point, _, pair in corners}
        for corners, _ in was:
            self.assertEqual(rounded(corners) - now, set())
        # Through another glTF file of text, and back to OBJ: images are written beside.
        self.assertEqual(self.lost("convert", "joined.glb", "-o", "again.gltf"), [])
        self.assertEqual({material[0] for _, material in seen_by_assimp(self.at("again.gltf"))}, {"scan", "scan_2"})
        self.expect(DONE, "convert", "again.gltf", "-o", "back.obj")
        self.assertEqual({material for _, material in seen_by_assimp(self.at("back.obj"))},
                         {("scan", (1, 0, 0), "back_scan.png"), ("scan_2", (0, 0, 1), "back_scan_2.png")})
        self.assertEqual(self.at("back_scan.png").read_bytes(), png(255, 0, 0))
        # The text has the digits that give the same number in single precision.
        single = lambda points: [struct.unpack("3f", struct.pack("3f", *point)) for point in points]
        self.assertEqual(single(read_obj(self.at("back.obj"))[0]),
                         single(read_obj(self.at("red/part.obj"))[0] + read_obj(self.at("blue/part.obj"))[0]))

    def test_all_of_a_gltf_material_stays(self):
        material = {"name": "brass", "pbrMetallicRoughness": {"baseColorFactor": [0.5, 0.25, 0.125, 1.0], "metallicFactor": 0.75,
                                                              "roughnessFactor": 0.25, "baseColorTexture": {"index": 0}},
                    "normalTexture": {"index": 1, "scale": 0.5}, "emissiveFactor": [0.1, 0.2, 0.3], "doubleSided": True,
                    "extensions": {"KHR_materials_clearcoat": {"clearcoatFactor": 0.5, "clearcoatTexture": {"index": 1}}}}
        self.at("a.png").write_bytes(png(1, 2, 3))
        self.at("b.png").write_bytes(png(4, 5, 6))
        meshes.write_glb(self.at("brass.glb"), [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2)],
                         meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
                         materials=[material], textures=[{"source": 0, "sampler": 0}, {"source": 1}],
                         samplers=[{"magFilter": 9728}], images=[{"uri": "a.png"}, {"uri": "b.png"}],
                         extensionsUsed=["KHR_materials_clearcoat"])
        self.assertEqual(self.lost("fill", "brass.glb", "-o", "full.gltf"), [])
        model = json.loads(self.at("full.gltf").read_text())
        now = model["materials"]
        self.assertEqual(len(now), 1)
        texture = lambda place: model["images"][model["textures"][place]["source"]]
        view = lambda image: model["bufferViews"][image["bufferView"]]
        places = [now[0]["pbrMetallicRoughness"]["baseColorTexture"]["index"], now[0]["normalTexture"]["index"],
                  now[0]["extensions"]["KHR_materials_clearcoat"]["clearcoatTexture"]["index"]]
        self.assertEqual([texture(place)["mimeType"] for place in places], ["image/png"] * 3)
        self.assertEqual(len(model["images"]), 2)
        self.assertEqual([view(texture(place))["byteLength"] for place in places],
                         [len(png(1, 2, 3)), len(png(4, 5, 6)), len(png(4, 5, 6))])
        for place, key in ((0, "pbrMetallicRoughness"), (1, None)):
            (now[0][key] if key else now[0]).pop("baseColorTexture" if key else "normalTexture")
            (material[key] if key else material).pop("baseColorTexture" if key else "normalTexture")
        for one in (now[0], material):
            one["extensions"]["KHR_materials_clearcoat"].pop("clearcoatTexture")
        material["alphaMode"] = now[0].get("alphaMode", "OPAQUE")
        now[0].setdefault("alphaMode", "OPAQUE")
        self.assertEqual(now[0], material)
        # All four triangles have it, the new one, too.
        self.assertEqual(len(model["meshes"][0]["primitives"]), 1)
        self.assertEqual(model["accessors"][model["meshes"][0]["primitives"][0]["indices"]]["count"], 12)

    def test_files_that_are_not_as_they_should_be(self):
        self.at("odd").mkdir(exist_ok=True)
        vertices, faces = tube(6, 0, 1)
        backslash = chr(92)
        rows = ["mtllib a.mtl b.mtl", f"mtllib deeper{backslash}c.mtl"]
        rows += ["v " + " ".join(map(repr, vertex)) for vertex in vertices]
        for f, face in enumerate(faces):
            # A continued line.
            rows += [f"usemtl {'abcde'[f % 5]}", f"f {backslash}", " ".join(str(v + 1) for v in face)]
        self.at("odd/odd.obj").write_text("\n".join(rows) + "\n")
        self.at("odd/deeper").mkdir(exist_ok=True)
        for name, at, colour in (("a", "a", "1 0 0"), ("b", "b", "0 1 0"), ("c", "deeper/c", "0 0 1")):
            self.at(f"odd/{at}.mtl").write_text(f"newmtl {name}\nKd {colour}\nmap_Kd missing {name}.png\n")
        lost = self.lost("convert", "odd/odd.obj", "-o", "even.obj")
        self.assertEqual(lost, [])
        found = {material for _, material in seen_by_assimp(self.at("even.obj"))}
        self.assertTrue({("a", (1, 0, 0)), ("b", (0, 1, 0)), ("c", (0, 0, 1))} <= {one[:2] for one in found}, found)
        self.assertIn("map_Kd odd/missing a.png", self.at("even.mtl").read_text())
        # A missing image is reported, and other programs can read the file.
        lost = self.lost("convert", "odd/odd.obj", "-o", "even.gltf")
        self.assertEqual(sum("which is not there" in text for text in lost), 3, lost)
        self.assertEqual(len(seen_by_assimp(self.at("even.gltf"))), 12)
        self.assertNotIn("null", self.at("even.gltf").read_text())

    def test_what_gltf_has_beyond_is_told(self):
        self.at("my image.png").write_bytes(png(7, 8, 9))
        points, faces = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (0, 3, 2)]
        material = {"name": "m", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}},
                    "occlusionTexture": {"index": 0, "texCoord": 1}, "normalTexture": {"index": 1}}
        meshes.write_glb(self.at("rich.glb"), points, faces, pairs=[(0, 0)] * 4,
                         meshes=[{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 2, "TEXCOORD_1": 2, "_ID": 2},
                                                  "indices": 1, "material": 0}]}],
                         materials=[material], textures=[{"source": 0}, {"source": 1}],
                         images=[{"uri": "my%20image.png"}, {"uri": "gone.png"}])
        lost = self.lost("fill", "rich.glb", "-o", "rich.gltf")
        for what in ("TEXCOORD_1 is not read", "_ID is not read", "gone.png, which is not there", "other texture coordinates"):
            self.assertTrue(any(what in text for text in lost), (what, lost))
        model = json.loads(self.at("rich.gltf").read_text())
        self.assertEqual((len(model["images"]), len(model["textures"])), (1, 1))
        self.assertEqual(len(seen_by_assimp(self.at("rich.gltf"))), 4)
        self.expect(DONE, "convert", "rich.gltf", "-o", "again.obj")
        self.assertEqual(self.at("again_m.png").read_bytes(), png(7, 8, 9))

    def test_colours_through_ply(self):
        vertices, faces = tube(8, 0, 1)
        rows = [f"v {x!r} {y!r} {z!r} {k % 2} {k % 3 / 2} 0.25" for k, (x, y, z) in enumerate(vertices)]
        rows += ["f " + " ".join(str(v + 1) for v in face) for face in faces]
        self.at("shades.obj").write_text("\n".join(rows) + "\n")
        self.expect(DONE, "fill", "shades.obj", "-o", "shades.ply")
        was = {point: colour for corners, _ in seen_by_assimp(self.at("shades.obj")) for point, colour, _ in corners}
        now = {point: colour for corners, _ in seen_by_assimp(self.at("shades.ply")) for point, colour, _ in corners}
        self.assertEqual(set(was), set(now))
        for point, colour in was.items():
            for a, b in zip(colour, now[point]):
                # 256 steps.
                self.assertAlmostEqual(a, b, delta=0.0025)

    def test_numbers_of_a_scanner(self):
        head = ["ply", "format ascii 1.0", "element vertex 4", "property double x", "property double y", "property double z",
                "property float confidence", "property int label", "element face 3", "property list uchar int vertex_indices",
                "property uchar region", "end_header"]
        rows = ["0 0 0 nan 7", "1 0 0 0.5 8", "0 1 0 0.75 9", "0 0 1 1 -10", "3 0 2 1 4", "3 0 1 3 5", "3 0 3 2 6"]
        self.at("scan.ply").write_text("\n".join(head + rows) + "\n")
        self.assertEqual(self.lost("fill", "scan.ply", "-o", "filled.ply", "--text"), [])
        found = read_ply(self.at("filled.ply"))
        self.assertEqual([("nan" if math.isnan(row["confidence"]) else row["confidence"], row["label"]) for row in found["vertex"]], [("nan", 7), (0.5, 8), (0.75, 9), (1, -10)])
        self.assertEqual([row["region"] for row in found["face"]][:3], [4, 5, 6])
        self.assertIn(found["face"][3]["region"], (4, 5, 6))
        lost = self.lost("fill", "scan.ply", "-o", "filled.off")
        self.assertEqual(len(lost), 3, lost)

    def test_texture_seams_are_no_borders(self):
        # The tube of one index per vertex: its seam divides vertices, and only its rims are loops.
        around = 12
        points = [(math.cos(math.tau * (k % around) / around), math.sin(math.tau * (k % around) / around), row)
                  for row in (0.0, 1.0) for k in range(around + 1)]
        corner = lambda row, k: row * (around + 1) + k
        faces = [face for k in range(around)
                 for face in ((corner(0, k), corner(0, k + 1), corner(1, k + 1)), (corner(0, k), corner(1, k + 1), corner(1, k)))]
        meshes.write_glb(self.at("seam.glb"), points, faces, pairs=[(k / around, row) for row in (0, 1) for k in range(around + 1)])
        report = json.loads(self.expect(DONE, "run", "boundary_loops", "seam.glb", "-n", "--json").stdout)
        self.assertEqual(report["values"]["boundary_loops"], 2)
        # Filled, with the seam's vertices still apart.
        self.expect(DONE, "fill", "seam.glb", "-o", "full.glb")
        report = json.loads(self.expect(DONE, "check", "full.glb", "--json").stdout)
        self.assertEqual(report["values"]["boundary_edges"], 0)
        was, now = (seen_by_assimp(self.at(name)) for name in ("seam.glb", "full.glb"))
        key = lambda found: {(point, pair) for corners, _ in found for point, _, pair in corners}
        self.assertEqual(key(was) - key(now), set())


if __name__ == "__main__":
    Attributes.program = meshes.Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1])
