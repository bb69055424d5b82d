"""All filters on real meshes and curves: test_filters_real.py PROGRAM PLUGIN FOLDER DATA; GUSSET_DATA goes before DATA.

Tries each filter on possible inputs until it accepts them. Some results are compared with known facts of the files.
"""

import csv
import itertools
import json
import os
import pathlib
import re
import sys
import unittest

import meshes
from meshes import grid, read_obj, rims, write_obj

DONE, REFUSED = 0, 4


class Real(unittest.TestCase):
    host = data = None

    @classmethod
    def setUpClass(cls):
        # A hill as a sheet of quads, and outlines as lines.
        heights = [list(map(float, row)) for row in cls.table("grids/volcano_maunga_whau_61x87.csv")]
        cls.hill = cls.host.folder / "volcano.obj"
        write_obj(cls.hill, *grid(len(heights), len(heights[0]), lambda i, j: 0.1 * heights[i][j]))
        # A box around all meshes, and the box with a corner pulled out.
        corners = [(1000 * x, 1000 * y, 1000 * z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
        cls.boxes = [cls.host.folder / "box.obj", cls.host.folder / "pulled.obj"]
        sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
        write_obj(cls.boxes[0], corners, sides)
        write_obj(cls.boxes[1], [*corners[:7], (1500, 1200, 1100)], sides)
        levels = json.loads((cls.data / "carcass/foot_levels_y.json").read_text())["stations"]
        levels = [level["points"] for level in levels]
        rows = [[(j, i, 0.1 * height) for j, height in enumerate(row)] for i, row in enumerate(heights)]
        # Alone, two that face each other, two and more one above the other, and open ones.
        cls.outlines = [
            cls.curves("france", [cls.outline("country_France_0")]),
            cls.curves("italy", [cls.outline("country_Italy_0"), cls.outline("country_Italy_1")]),
            cls.curves("sole", levels[:2]),
            cls.curves("foot", levels),
            cls.curves("slopes", rows[::10], closed=False),
        ]

    @classmethod
    def table(cls, name):
        return list(csv.reader((cls.data / name).read_text().splitlines()))

    @classmethod
    def outline(cls, name):
        points = [(float(x), float(y), 0) for x, y, *_ in cls.table(f"outlines/{name}.csv")[1:]]
        return points[:-1] if points[0] == points[-1] else points

    @classmethod
    def curves(cls, name, curves, closed=True):
        starts = [0, *itertools.accumulate(map(len, curves))]
        lines = [[*range(start, end)] + [start] * closed for start, end in itertools.pairwise(starts)]
        path = cls.host.folder / f"{name}.obj"
        write_obj(path, itertools.chain(*curves), lines=lines)
        return path

    def candidates(self, name, kinds, needed):
        """Combinations of files that suit the kinds of a filter; pieces that belong together first."""
        meshes = ["lion.off", "hole_capsule.off", "human_proxy741.obj"]
        # The development of the lion takes as long as all other filters together.
        known = [self.data / f"meshes/{mesh}" for mesh in (meshes[::-1] if name == "develop" else meshes)]
        suited = {"mesh": [*known, self.hill], "curves": self.outlines}
        together = [[self.data / f"pairs/bunny_cut/{name}.off" for name in ("head", "body")],
                    [self.data / f"pairs/combustor/{name}.stl" for name in ("walls", "inlet", "outlet")]]
        if name == "lattice":
            return [(known[0], *self.boxes)]
        if name == "unite":
            return [self.boxes]
        whole = [pair[:len(kinds)] for pair in together if kinds == ["mesh"] * len(kinds) and 1 < len(kinds) and needed <= len(pair)]
        for count in range(len(kinds), needed - 1, -1):
            whole += itertools.product(*(suited[kind] for kind in kinds[:count]))
        return whole

    def check_output(self, path, kind):
        vertices, faces, lines = read_obj(path)
        self.assertTrue(all(abs(x) < 1e6 for vertex in vertices for x in vertex), path)
        shown = faces if kind == "mesh" else lines
        self.assertTrue(all(0 <= corner < len(vertices) for one in shown for corner in one), path)
        if kind == "mesh":
            self.assertTrue(faces and all(len(face) > 2 for face in faces), path)

    def test_every_filter(self):
        for name, (kinds, needed, outputs) in self.host.filters().items():
            with self.subTest(filter=name):
                files = [f"{name}-{k}.obj" for k, kind in enumerate(outputs) if kind != "text"]
                named = [word for file in files for word in ("-o", file)]
                for inputs in self.candidates(name, kinds, needed):
                    done = self.host("run", name, *inputs, *named)
                    self.assertIn(done.returncode, (DONE, REFUSED), done.stderr)
                    if done.returncode == DONE:
                        break
                    # A refusal says why.
                    self.assertRegex(done.stderr, rf"gusset: {name}: .+ \(status \d+")
                self.assertEqual(done.returncode, DONE, done.stderr)
                print(name, *(path.name for path in inputs), "->", *files)
                self.assertEqual("text" in outputs, done.stdout != "")
                for file, kind in zip(files, (kind for kind in outputs if kind != "text"), strict=True):
                    self.check_output(self.host.folder / file, kind)

    def run_on(self, name, *arguments):
        done = self.host("run", name, *arguments)
        self.assertEqual(done.returncode, DONE, done.stderr)
        return done.stdout

    def test_what_is_known_of_the_files(self):
        text = self.run_on("boundary_loops", self.data / "meshes/lion.off", "-o", "loops.obj")
        self.assertIn("5 boundary loops, 205 edges", text)
        _, _, lines = read_obj(self.host.folder / "loops.obj")
        self.assertEqual(sorted(len(line) - 1 for line in lines)[1:], [25, 25, 36, 115])
        self.assertEqual(sum(len(line) - 1 for line in lines), 205)

        self.run_on("fill", self.data / "meshes/lion.off", "-o", "filled.obj")
        vertices, faces, _ = read_obj(self.host.folder / "filled.obj")
        self.assertEqual((rims(faces), len(vertices)), (0, 7529))
        self.assertGreater(len(faces), 14859)

        pieces = [self.data / f"pairs/combustor/{name}.stl" for name in ("walls", "inlet", "outlet")]
        self.run_on("join", *pieces, "-o", "combustor.obj")
        _, faces, _ = read_obj(self.host.folder / "combustor.obj")
        self.assertEqual((len(faces), rims(faces)), (3456, 0))

        tiles = [self.data / f"cases/gap_tile_{name}.obj" for name in ("00", "01", "10", "11")]
        text = self.run_on("join", *tiles, "-p", "holes=fill", "-p", "keep=borders", "-o", "sheet.obj")
        self.assertIn("1 boundary loop left", text)
        self.assertEqual(rims(read_obj(self.host.folder / "sheet.obj")[1]), 60)

        halves = [self.data / f"pairs/bunny_cut/{name}.off" for name in ("head", "body")]
        before = sum(map(self.rim, halves))
        self.run_on("stitch", *halves, "-o", "bunny.obj")
        _, faces, _ = read_obj(self.host.folder / "bunny.obj")
        self.assertEqual(rims(faces), before - 178 - 190)

        self.run_on("weld", self.data / "meshes/boeing.off", "-p", "unused=remove", "-o", "boeing.obj")
        vertices, faces, _ = read_obj(self.host.folder / "boeing.obj")
        self.assertEqual((len(vertices), len(faces), rims(faces)), (1264, 2564, 0))

    def rim(self, path):
        """The number of edges of all boundary loops of a mesh."""
        return int(re.search(r"boundary loops?, (\d+) edges", self.run_on("boundary_loops", path))[1])


if __name__ == "__main__":
    Real.host = meshes.Program(*sys.argv[1:4])
    Real.data = pathlib.Path(os.environ.get("GUSSET_DATA", sys.argv[4])).resolve()
    if not (Real.data / "MANIFEST.md").exists():
        print(f"SKIPPED: no real meshes in {Real.data}; set GUSSET_DATA to the folder that has them")
        sys.exit(0)
    unittest.main(argv=sys.argv[:1])
