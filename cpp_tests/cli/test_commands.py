"""The commands of the program, by what they print, write and return: test_commands.py PROGRAM PLUGIN FOLDER OTHER; the
plugin is found by the program itself, and OTHER is a plugin that has nothing of it."""

import json
import pathlib
import subprocess
import sys
import unittest

import meshes
from meshes import read_obj, read_ply, rims, tube, write_obj, write_off

DONE, USAGE, FILE, PLUGIN, REFUSED = range(5)


class Commands(unittest.TestCase):
    program = other = None

    def expect(self, status, *arguments, says=""):
        return self.program.expect(self, status, *arguments, says=says)

    def at(self, name):
        return self.program.folder / name

    def setUp(self):
        write_obj(self.at("low.obj"), *tube(12, 0, 1))
        write_obj(self.at("high.obj"), *tube(9, 1.5, 2))
        write_off(self.at("beside.off"), [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (1, 0, 0), (2, 0, 0), (2, 1, 0), (1, 1, 0)],
                  [[0, 1, 2, 3], [4, 5, 6, 7]])
        write_off(self.at("turned.off"), [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0), (2, 1, 0)],
                  [[0, 1, 2, 3], [1, 2, 5, 4]])

    def test_stitch(self):
        self.expect(DONE, "stitch", "low.obj", "high.obj", "-o", "joined.ply",
                    says="joined loops of 12 and 9 vertices by 21 faces, 0 interior rows")
        self.assertEqual(meshes.counts(self.at("joined.ply")), (42, 42))
        self.expect(DONE, "stitch", "low.obj", "high.obj", "--rows", "given-number", "--row-count=2", "--fairing", "Fair",
                    "-o", "rows.obj", says="2 interior rows")
        self.assertEqual(rims(read_obj(self.at("rows.obj"))[1]), 21)
        # A mesh with itself: both ends of a tube.
        self.expect(DONE, "stitch", "low.obj", "-o", "ring.off")
        self.assertEqual(rims(meshes.read_off(self.at("ring.off"))[1]), 0)

    def test_fill(self):
        self.expect(DONE, "fill", "low.obj", "-o", "filled.stl", says="filled 2 of 2 boundary loops by 20 faces and 0 new vertices")
        self.assertEqual(meshes.counts(self.at("filled.stl")), (24, 44))
        self.expect(DONE, "fill", "low.obj", "--keep", "the-longest", "-o", "one.obj", says="filled 1 of 2 boundary loops by 10 faces")

    def test_repair(self):
        points, faces = tube(12, 0, 1)
        write_obj(self.at("broken.obj"), points, [*faces, faces[0], faces[1][::-1]])
        self.expect(DONE, "repair", "broken.obj", "-o", "solid.off",
                    says="2 holes filled\n2 duplicate faces dropped\nvalid: closed, manifold, oriented, without intersecting faces\n")
        self.assertEqual(rims(meshes.read_off(self.at("solid.off"))[1]), 0)
        text = self.expect(DONE, "repair", "broken.obj", "--leave-holes", "-o", "open.off", says="not a valid solid: 24 boundary edges left\n").stdout
        self.assertNotIn("holes filled", text)

    def test_join(self):
        self.expect(DONE, "join", "low.obj", "high.obj", "--holes", "fill", "-o", "whole.glb",
                    says="2 holes filled, 0 boundary loops left")

    def test_a_list_of_scans_is_many_meshes(self):
        self.at("two.conf").write_text("bmesh low.obj 0 0 0 0 0 0 1\nbmesh high.obj 0 0 0.25 0 0 0 2\n")
        report = json.loads(self.expect(DONE, "join", "two.conf", "--json", "-o", "two.obj").stdout)
        self.assertEqual([one["file"].split(": ")[1] for one in report["inputs"]], ["low", "high"])
        self.assertEqual(rims(read_obj(self.at("two.obj"))[1]), 21)

    def test_weld_and_check_agree(self):
        self.expect(DONE, "check", "beside.off", says="8 vertices, 8 edges, 2 faces, 2 pieces, 2 walks round the boundary\n")
        self.expect(DONE, "weld", "beside.off", "-o", "welded.off", says="2 vertices welded, 1 edge sewn, 0 faces dropped\n")
        text = self.expect(DONE, "check", "welded.off", says="6 boundary edges: ").stdout
        self.assertIn("7 edges, 2 faces, 1 piece, 1 walk round the boundary\nnot closed, manifold, oriented\n", text)

    def test_orient(self):
        self.expect(DONE, "check", "turned.off", says="1 edge with inconsistently oriented faces: ")
        self.expect(DONE, "orient", "turned.off", "-o", "oriented.off", says="1 of 2 faces reversed, 1 piece\n")
        self.expect(DONE, "check", "oriented.off", says="manifold, oriented\n")

    def test_what_comes_out_needs_a_file(self):
        for command in ("stitch", "fill", "join", "weld", "orient"):
            done = self.expect(USAGE, command, "low.obj", says=f"{command} makes a mesh: name the file with -o")
            self.assertEqual(done.stdout, "")
            self.expect(DONE, command, "low.obj", "--dry-run")
        self.expect(USAGE, "run", "weld", "low.obj", says="run makes a mesh: name the file with -o")
        self.expect(USAGE, "run", "curve_resample", "low.obj", says="run makes curves: name the file with -o")
        self.expect(USAGE, "convert", "low.obj", says="convert writes one file, named with -o")
        self.expect(DONE, "run", "boundary_loops", "low.obj", says="2 boundary loops, 24 edges")
        before = sorted(self.program.folder.iterdir())
        self.expect(DONE, "weld", "low.obj", "-n", "-o", "never.off", says="0 vertices welded")
        self.assertEqual(sorted(self.program.folder.iterdir()), before)

    def test_wrong_words(self):
        self.expect(USAGE)
        self.expect(USAGE, "stitch")
        self.expect(USAGE, "stitch", "low.obj", "high.obj", "low.obj", "-o", "a.obj")
        self.expect(USAGE, "weld", "low.obj", "-o", "a.obj", "-o", "b.obj")
        self.expect(USAGE, "stitch", "low.obj", "high.obj", "--rows", "many", "-o", "a.obj",
                    says="[possible values: none, by-mean-edge, given-number]")
        self.expect(USAGE, "run", "stitch", "low.obj", "high.obj", "-p", "rows=by-mean-edgy", "-n",
                    says='parameter rows takes none, by-mean-edge or given-number, not "by-mean-edgy"; did you mean by-mean-edge?')
        self.expect(USAGE, "run", "stich", "low.obj", "-n", says="there is no filter stich; did you mean stitch?")
        self.expect(USAGE, "stich", "low.obj", says="stitch")
        self.expect(USAGE, "fill", "low.obj", "--loops", "2", "-o", "a.obj", says="--loops")
        self.expect(USAGE, "fill", "low.obj", "--threads", "few", "-o", "a.obj")
        self.expect(REFUSED, "weld", "low.obj", "--tolerance", "-2", "-o", "a.obj", says="parameter tolerance)")

    def test_json(self):
        def told(status, *arguments):
            return json.loads(self.expect(status, *arguments, "--json").stdout)

        found = told(DONE, "stitch", "low.obj", "high.obj", "--rows", "by-mean-edge", "-o", "joined.off")
        self.assertEqual(set(found), {"command", "filter", "inputs", "parameters", "outputs", "report", "values"})
        self.assertEqual((found["command"], found["filter"]), ("stitch", "stitch"))
        self.assertEqual(found["inputs"][1], {"file": "high.obj", "kind": "mesh", "vertices": 18, "faces": 9, "attributes": [], "notes": []})
        self.assertEqual((found["parameters"]["rows"], found["parameters"]["loop_a"]), ("by-mean-edge", -1))
        made = found["outputs"][0]
        self.assertEqual((made["vertices"], made["faces"]), meshes.counts(self.at("joined.off")))
        self.assertEqual((found["values"]["boundary_loops"], found["values"]["rim_vertices_a"]), (2, 12))
        self.assertTrue(found["report"][0].startswith("joined loops of 12 and 9 vertices"))
        check = told(DONE, "check", "low.obj")
        self.assertEqual({name: check["values"][name] for name in ("vertices", "pieces", "closed", "genus", "boundary_edges")},
                         {"vertices": 24, "pieces": 1, "closed": False, "genus": 0, "boundary_edges": 24})
        self.assertIs(check["values"]["closed"], False)
        self.assertIs(check["values"]["oriented"], True)
        filled = told(DONE, "fill", "low.obj", "--dry-run")
        self.assertIn(f"smallest angle {filled['values']['smallest_angle']:.2f} degrees", filled["report"][1])
        self.assertEqual(check["outputs"], [])
        wrong = told(REFUSED, "weld", "low.obj", "--tolerance", "-2", "-n")
        self.assertEqual((wrong["command"], wrong["error"]["exit"], wrong["error"]["parameter"]), ("weld", 4, "tolerance"))
        self.at("bad.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n")
        self.assertIn("bad.off:5: vertex 2", told(FILE, "check", "bad.off")["error"]["message"])
        listed = told(DONE, "filters")
        self.assertIn({"id": "weld", "name": "Weld vertices", "category": "Repair", "inputs": ["mesh"], "min_inputs": 1,
                       "max_inputs": 1, "outputs": ["mesh", "text"]}, listed)
        weld = told(DONE, "filters", "weld", "low.obj")
        self.assertEqual([param["id"] for param in weld["parameters"]], ["vertices", "tolerance", "collapse", "unused"])
        self.assertEqual(weld["parameters"][1]["suggested"], -1)
        self.assertEqual(told(DONE, "convert", "low.obj", "-o", "low.ply")["outputs"][0]["lost"], [])

    def test_colours_of_the_pieces_stay(self):
        def coloured(name, shape, colour):
            vertices, faces = shape
            rows = [" ".join(map(str, (*vertex, *colour))) for vertex in vertices]
            rows = [f"v {row}" for row in rows] + ["f " + " ".join(str(c + 1) for c in face) for face in faces]
            self.at(name).write_text("\n".join(rows) + "\n")

        coloured("red.obj", tube(12, 0, 1), (1, 0, 0))
        coloured("blue.obj", tube(9, 1.5, 2), (0, 0, 1))
        done = self.expect(DONE, "stitch", "red.obj", "blue.obj", "--rows", "given-number", "--row-count", "3", "-o",
                           "both.ply", "--text")
        self.assertEqual(done.stderr, "")
        colours = [(row["red"], row["green"], row["blue"]) for row in read_ply(self.at("both.ply"))["vertex"]]
        self.assertEqual(colours[:24] + colours[24:42], [(255, 0, 0)] * 24 + [(0, 0, 255)] * 18)
        # New rows are between.
        self.assertGreater(len(colours), 42)
        self.assertTrue(all(red + blue in (255, 256) and green == 0 for red, green, blue in colours[42:]), colours[42:])
        self.expect(DONE, "stitch", "red.obj", "high.obj", "-o", "half.ply",
                    says="half.ply: lost: no colours of vertices in high.obj: white is taken")

    def test_corners_keep_their_texture(self):
        # Two triangles at a seam: the edge that they share has other pairs on either side.
        self.at("seam.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 5 5\nvt 0 0\nvt .5 0\nvt .5 .5\nvt 1 0\nvt 1 1\n"
                                       "vt 0 1\nf 1/1 2/2 3/3\nf 1/4 3/5 4/6\n")
        self.expect(DONE, "weld", "seam.obj", "--unused", "remove", "-o", "kept.obj")
        text = self.at("kept.obj").read_text()
        pairs = [tuple(map(float, row.split()[1:])) for row in text.splitlines() if row.startswith("vt")]
        faces = [[int(corner.split("/")[1]) - 1 for corner in row.split()[1:]] for row in text.splitlines() if row[0] == "f"]
        self.assertEqual([[pairs[c] for c in face] for face in faces],
                         [[(0, 0), (0.5, 0), (0.5, 0.5)], [(1, 0), (1, 1), (0, 1)]])
        # New faces go on with the charts round them.
        self.expect(DONE, "fill", "seam.obj", "--keep", "none", "-o", "closed.obj")
        text = self.at("closed.obj").read_text()
        self.assertEqual([row.count("/") for row in text.splitlines() if row[0] == "f"], [3, 3, 3, 3])

    def test_moved_vertices_lose_their_normals(self):
        self.at("up.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n")
        shift = ("--plugin", self.other, "run", "shift", "up.obj", "-o")
        self.expect(DONE, *shift, "moved.obj", says="lost: normals, as vertices were moved")
        self.assertNotIn("vn", self.at("moved.obj").read_text())
        self.expect(DONE, *shift, "still.obj", "-p", "by=0")
        self.assertIn("vn 0 0 1", self.at("still.obj").read_text())
        self.at("turned.obj").write_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nvn 0 0 1\nvn 0 0 -1\n"
                                         "f 1//1 2//1 3//1 4//1\nf 2//2 3//2 6//2 5//2\n")
        self.expect(DONE, "orient", "turned.obj", "-o", "up2.obj")
        directions = {row for row in self.at("up2.obj").read_text().splitlines() if row.startswith("vn")}
        self.assertEqual(len(directions), 1)

    def test_any_plugin(self):
        plugin = ("--plugin", self.other)
        program = [self.program.program, *plugin]
        listed = subprocess.run([*program, "filters"], capture_output=True, text=True)
        self.assertEqual((listed.returncode, listed.stdout), (DONE, "shift  mesh  -> mesh, text  Test: Shift\n"))
        done = self.expect(DONE, *plugin, "run", "shift", "low.obj", "-p", "by=2", "-o", "shifted.obj", says="shifted 24 vertices")
        self.assertEqual(done.stderr, "")
        before, after = (read_obj(self.at(name))[0] for name in ("low.obj", "shifted.obj"))
        self.assertTrue(all(b[0] == a[0] + 2 for a, b in zip(before, after, strict=True)))
        self.expect(USAGE, *plugin, "weld", "low.obj", "-o", "a.obj", says="has no filter for weld")
        # No numbers by names, and no refusal of them.
        report = json.loads(self.expect(DONE, *plugin, "run", "shift", "low.obj", "-n", "--json").stdout)
        self.assertEqual((report["report"], "values" in report), (["shifted 24 vertices"], False))

    def test_without_a_library(self):
        plugin = ("--plugin", "./nowhere.so")
        self.expect(DONE, *plugin, "--help", says="Exit status")
        self.expect(DONE, *plugin, "--version", says="library: none")
        self.expect(PLUGIN, *plugin, "weld", "low.obj", "-o", "a.obj", says="nowhere.so")
        self.expect(PLUGIN, *plugin, "stitch", "low.obj", "high.obj", "--rows", "none", "-o", "a.obj", says="nowhere.so")
        self.expect(DONE, *plugin, "convert", "low.obj", "-o", "low.glb")


class Own(meshes.Program):
    """Without a word on where the library is."""

    def command(self, *arguments):
        return [self.program, *map(str, arguments)]


if __name__ == "__main__":
    Commands.program = Own(*sys.argv[1:4])
    Commands.other = pathlib.Path(sys.argv[4]).resolve()
    unittest.main(argv=sys.argv[:1])
