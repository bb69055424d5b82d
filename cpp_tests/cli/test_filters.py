"""All filters by the program, `gusset run` and `gusset filters`: test_filters.py PROGRAM PLUGIN FOLDER"""

import math
import os
import signal
import subprocess
import sys
import unittest

import meshes
from meshes import grid, read_obj, read_off, write_obj, write_off

DONE, USAGE, FILE, PLUGIN, REFUSED, CANCELLED, MEMORY = range(7)

# Three faces at an edge, two of them turned against each other, a pentagon, a bow tie and a vertex that no face uses;
# coordinates that need all their digits.
SOUP = [(0, 0, 0), (1, 0, 0), (1 / 3, 1, 0), (0.1, -1.0000000000000002, 2e-17), (0.5, 0.5, 1), (9, 9, 9), (2, 0, 0),
        (2, 1, 0), (3, 1.1, 0), (3, -1, 0), (4, 4, 4), (5, 5, 4)]
SOUP_FACES = [[0, 1, 2], [0, 1, 3], [1, 0, 4], [1, 6, 7, 8, 9], [2, 10, 11]]


class Filters(unittest.TestCase):
    host = None

    def expect(self, status, *arguments, says=""):
        # Where no file is named nothing is to be written.
        dry = ("-n",) if arguments[:1] == ("run",) and "-o" not in arguments else ()
        return self.host.expect(self, status, *arguments, *dry, says=says)

    def at(self, name):
        return self.host.folder / name

    def setUp(self):
        write_obj(self.at("grid.obj"), *grid(9, 12, lambda i, j: math.sin(i) * math.cos(j)))

    def test_lists_and_describes_every_filter(self):
        filters = self.host.filters()
        self.assertGreater(len(filters), 10)
        self.assertEqual(filters["smooth_distance"], (["mesh", "mesh"], 2, ["mesh", "text"]))
        for name, (kinds, _, _) in filters.items():
            text = self.expect(DONE, "filters", name).stdout
            self.assertTrue(text.startswith(name + ": "))
            for heading in ("category", "script", "inputs", "outputs", "reference"):
                self.assertIn(f"\n  {heading}  ", text)
            if kinds == ["mesh"]:
                suggested = self.expect(DONE, "filters", name, "grid.obj").stdout
                self.assertEqual(suggested.count("\n      for these inputs: "), text.count("\n  -p "))
        self.expect(DONE, "filters", "weld", says="-p vertices=borders")
        self.expect(DONE, "filters", "smooth_silhouette", says="angle in degrees, from 0 to 180")
        self.expect(DONE, "--help", says="Exit status")
        self.expect(DONE, "run", "--help", says="--cancel-after")

    def test_values_as_described_are_accepted(self):
        for name, (kinds, needed, _) in self.host.filters().items():
            if kinds[:needed] not in ([], ["mesh"]):
                continue
            lines = self.host("filters", name).stdout.splitlines()
            values = [line.strip().removeprefix("-p ").replace('"', "") for line in lines if line.startswith("  -p ")]
            given = [word for value in values for word in ("-p", value)]
            done = self.host("run", name, *["grid.obj"] * needed, *given, "-n")
            self.assertIn(done.returncode, (DONE, REFUSED), done.stderr)
            self.assertNotIn("parameter", done.stderr)

    def test_soups_come_in_and_go_out_unchanged(self):
        write_obj(self.at("soup.obj"), SOUP, SOUP_FACES)
        write_off(self.at("soup.off"), SOUP, SOUP_FACES)
        still = ("-p", "amount=0", "-o")
        self.expect(DONE, "run", "deform", "soup.off", *still, "same.off")
        self.assertEqual(read_off(self.at("same.off")), ([tuple(map(float, p)) for p in SOUP], SOUP_FACES))
        self.expect(DONE, "run", "deform", "soup.off", *still, "same.ply")
        self.expect(DONE, "run", "deform", "same.ply", *still, "again.off")
        self.assertEqual(self.at("again.off").read_text(), self.at("same.off").read_text())
        self.expect(DONE, "run", "deform", "soup.obj", *still, "same.obj")
        vertices, faces, _ = read_obj(self.at("same.obj"))
        self.assertEqual(faces, SOUP_FACES)
        for got, given in zip(vertices, SOUP, strict=True):
            for a, b in zip(got, given):
                self.assertAlmostEqual(a, b, delta=4e-16 * max(1, abs(b)))
        self.expect(DONE, "run", "deform", "soup.off", *still, "soup.stl",
                    says="soup.stl: lost: 1 face of more than three corners: cut into triangles")
        write_off(self.at("two.off"), SOUP, SOUP_FACES[:2])
        self.expect(DONE, "run", "deform", "two.off", *still, "two.stl")
        self.expect(DONE, "run", "deform", "two.stl", *still, "two.obj")
        vertices, faces, _ = read_obj(self.at("two.obj"))
        self.assertEqual((len(vertices), faces), (4, [[0, 1, 2], [0, 1, 3]]))

    def test_curves_are_lines(self):
        self.expect(DONE, "run", "boundary_loops", "grid.obj", "-o", "rim.obj", says="1 boundary loop, 38 edges")
        vertices, faces, [line] = read_obj(self.at("rim.obj"))
        given = {(x, y) for x, y, _ in read_obj(self.at("grid.obj"))[0] if x in (0, 11) or y in (0, 8)}
        self.assertEqual({vertex[:2] for vertex in vertices}, given)
        self.assertEqual((faces, len(line), line[0], len(set(line))), ([], 39, line[-1], 38))
        ring = [(math.cos(0.1 * math.tau * k), math.sin(0.1 * math.tau * k), 0) for k in range(10)]
        write_obj(self.at("rings.obj"), ring, lines=[[*range(10), 0], [0, 3, 6], [7, 8, 9, 1]])
        self.expect(DONE, "run", "outline", "rings.obj", "-o", "smooth.obj")
        _, _, lines = read_obj(self.at("smooth.obj"))
        self.assertEqual([line[0] == line[-1] for line in lines], [True, False, False])
        self.expect(FILE, "run", "outline", "grid.obj", says="it has no polylines")
        self.expect(FILE, "run", "weld", "rings.obj", says="no faces")
        self.expect(FILE, "run", "boundary_loops", "grid.obj", "-o", "rim.off", says=".obj")

    def test_parameters(self):
        def shape(*given):
            self.expect(DONE, "run", "net_shape", *given, "-o", "shape.off")
            return self.at("shape.off").read_text()

        torus = shape("-p", "shape=Torus", "-p", "triangles=true")
        self.assertEqual(torus, shape("-p", "shape=6", "-p", "triangles=1", "--threads", "1"))
        self.assertEqual(torus, shape("-p", "shape=torus", "-p", "triangles=TRUE", "--threads", "3"))
        self.assertNotEqual(torus, shape("-p", "shape=Torus"))
        self.assertEqual({len(face) for face in read_off(self.at("shape.off"))[1]}, {4})
        directions = {"0,1,0": DONE, "0,1": USAGE, "0,1,0,": USAGE, "x,1,0": USAGE, "0,0,0": REFUSED}
        for direction, status in directions.items():
            self.expect(status, "run", "smooth_sections", "grid.obj", "-p", f"direction={direction}",
                        says="" if status == DONE else "direction")
        for wrong in ("tolerance", "=1", "tolerance=", "tolerance=wide", "tolerance=1,2", "vertices=some", "nothing=1"):
            self.expect(USAGE, "run", "weld", "grid.obj", "-p", wrong, says=wrong.split("=")[0])
        self.expect(USAGE, "run", "weld", "grid.obj", "-p", "tolerance=1", "-p", "tolerance=2", says="twice")

    def test_refusals_name_what_is_wrong(self):
        for wrong in ("-2", "nan", "inf", "-inf", "1e300"):
            self.expect(REFUSED, "run", "weld", "grid.obj", "-p", f"tolerance={wrong}", says="parameter tolerance)")
        self.expect(REFUSED, "run", "weld", "grid.obj", "-p", "vertices=2", says="parameter vertices)")
        self.expect(REFUSED, "run", "net_shape", "-p", "rows=5.5", says="parameter rows)")
        endless = [(0, 0, 0), (1, 0, 0), (0, math.nan, 0)]
        write_obj(self.at("lost.obj"), endless, [[0, 1, 2]])
        self.expect(REFUSED, "run", "weld", "lost.obj", says="input 1: lost.obj, vertex 2)")
        self.expect(REFUSED, "run", "join", "grid.obj", "lost.obj", says="input 2: lost.obj, vertex 2)")
        # The library names the piece that lacks a rim, but not the piece whose face is outside of every grid.
        self.expect(DONE, "run", "net_shape", "-o", "closed.obj")
        self.expect(REFUSED, "run", "stitch", "grid.obj", "closed.obj", says="input 2: closed.obj)")
        self.expect(REFUSED, "run", "stitch", "closed.obj", "grid.obj", says="input 1: closed.obj)")
        write_obj(self.at("soup.obj"), SOUP, SOUP_FACES)
        self.expect(REFUSED, "run", "smooth_surface", "soup.obj", says="input 1: soup.obj, face 0)")
        done = self.expect(REFUSED, "run", "smooth_distance", "grid.obj", "soup.obj", says="face 0)")
        self.assertNotIn(", input", done.stderr)
        self.expect(REFUSED, "filters", "weld", "lost.obj",
                    says="'gusset run weld ...' says why")

    def test_commands_that_are_wrong(self):
        self.expect(USAGE)
        self.expect(USAGE, "dance")
        self.expect(USAGE, "filters", "--all")
        self.expect(USAGE, "run")
        self.expect(USAGE, "run", "dance", "grid.obj", says="no filter dance")
        self.expect(USAGE, "filters", "dance", says="no filter dance")
        self.expect(USAGE, "run", "weld", says="takes 1 input, not 0")
        self.expect(USAGE, "run", "stitch", "grid.obj", "grid.obj", "grid.obj", says="takes 1 to 2 inputs, not 3")
        self.expect(USAGE, "run", "net_shape", "grid.obj", says="0 inputs, not 1")
        self.expect(USAGE, "run", "weld", "grid.obj", "-o", "a.obj", "-o", "b.obj", says="weld writes 1 file, and 2 are named")
        self.expect(USAGE, "run", "weld", "grid.obj", "--cancel-after", "-1")
        self.expect(USAGE, "run", "weld", "grid.obj", "--threads", "-1")

    def test_files_that_are_wrong(self):
        self.at("damaged.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n")
        self.at("damaged.obj").write_text("v 0 0 0\nf 0 1 2\n")
        self.at("empty.ply").write_text("")
        self.at("words.stl").write_text("no mesh at all\n")
        self.expect(FILE, "run", "weld", "nowhere.obj", says="nowhere.obj")
        self.expect(FILE, "run", "weld", ".", says=".")
        self.expect(FILE, "run", "weld", "mesh.blend", says="files with the extension .blend are not supported; convert it by Blender")
        for name in ("damaged.off", "damaged.obj", "empty.ply", "words.stl"):
            self.expect(FILE, "run", "weld", name, says=name)
        self.expect(FILE, "run", "weld", "grid.obj", "-o", "out.blend", says="out.blend")
        self.expect(FILE, "run", "weld", "grid.obj", "-o", "no/such/folder/out.obj", says="out.obj")
        self.expect(FILE, "run", "boundary_loops", "grid.obj", "-o", "no/such/folder/out.obj", says="out.obj")

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs a device that is full")
    def test_a_full_disk_is_told(self):
        for words in (["filters"], ["filters", "weld"], ["run", "boundary_loops", "grid.obj"]):
            with open("/dev/full", "w") as full:
                done = subprocess.run(self.host.command(*words), cwd=self.host.folder, text=True, stdout=full,
                                      stderr=subprocess.PIPE)
            self.assertEqual(done.returncode, FILE, done.stderr)
            self.assertIn("standard output", done.stderr)

    def test_lack_of_memory_is_told(self):
        # Two gigabytes where there is half of one.
        command = self.host.command("run", "net_shape", "-p", "shape=Sphere", "-p", "rows=9001", "-p", "columns=9001",
                                    "--threads", "1", "-n")
        done = subprocess.run(["sh", "-c", 'ulimit -v 600000 && exec "$@"', "sh", *command], cwd=self.host.folder,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, MEMORY, done.stderr)
        self.assertIn("memory", done.stderr)

    def test_plugins_that_are_none(self):
        for library in ("./nowhere.so", "libm.so.6"):
            done = subprocess.run([self.host.program, "--plugin", library, "filters"], capture_output=True, text=True)
            self.assertEqual(done.returncode, PLUGIN, done.stderr)
            self.assertIn(library, done.stderr)

    def test_links_nothing_of_the_plugin(self):
        needed = subprocess.run(["readelf", "-d", self.host.program], capture_output=True, text=True, check=True).stdout
        self.assertIn("NEEDED", needed)
        self.assertNotIn("gusset.so", needed)

    LONG = ("net_shape", "-p", "shape=Sphere", "-p", "rows=3001", "-p", "columns=3001")

    def test_cancel_after_a_while(self):
        done = self.expect(CANCELLED, "run", *self.LONG, "--cancel-after", "0", "-o", "never.off",
                           says="ms after the request")
        self.assertFalse(self.at("never.off").exists())
        self.assertEqual(done.stdout, "")
        # A run that is done first is done.
        self.expect(DONE, "run", "weld", "grid.obj", "--cancel-after", "250")

    def test_interrupt_cancels(self):
        run = subprocess.Popen(self.host.command("run", *self.LONG, "--progress", "-n"), cwd=self.host.folder, text=True,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertIn("%", run.stderr.readline())
        run.send_signal(signal.SIGINT)
        _, error = run.communicate(timeout=300)
        self.assertEqual(run.returncode, CANCELLED, error)
        self.assertTrue(error.endswith("gusset: cancelled\n"))

    def test_progress_only_rises(self):
        lines = self.expect(DONE, "run", "weld", "grid.obj", "--progress").stderr.splitlines()
        parts = [int(line.split("]")[1].split("%")[0]) for line in lines]
        self.assertEqual(parts, sorted(parts))
        self.assertGreater(len(parts), 2)
        self.assertEqual(self.expect(DONE, "run", "weld", "grid.obj").stderr, "")


if __name__ == "__main__":
    Filters.host = meshes.Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1])
