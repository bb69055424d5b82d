"""The demo on shapes of ours: test_demo.py PROGRAM FOLDER"""

import json
import math
import pathlib
import re
import subprocess
import sys
import unittest

RED, BLUE = (200, 40, 30), (30, 60, 210)


def rings(heights, sides):
    """Rings of a unit sphere, a point where one is at a pole, and the triangles between them, seen from outside."""
    points, faces, rows = [], [], []
    for height in heights:
        radius = math.sqrt(1 - height * height)
        count = 1 if radius < 1e-9 else sides
        rows.append(range(len(points), len(points) + count))
        points += [(radius * math.cos(math.tau * k / count), height, radius * math.sin(math.tau * k / count)) for k in range(count)]
    for low, high in zip(rows, rows[1:]):
        for k in range(sides):
            a, b = low[k % len(low)], low[(k + 1) % len(low)]
            c, d = high[k % len(high)], high[(k + 1) % len(high)]
            if a != b:
                faces.append((a, d, b) if c == d else (a, c, b))
            if c != d:
                faces.append((b, c, d) if a != b else (a, c, d))
    return points, faces


def write_ply(path, points, faces, vertex_colour=None, face_colour=None):
    channels = "property uchar red\nproperty uchar green\nproperty uchar blue\n"
    lines = ["ply\nformat ascii 1.0", f"element vertex {len(points)}", "property float x\nproperty float y\nproperty float z"]
    lines += [channels.rstrip()] if vertex_colour else []
    lines += [f"element face {len(faces)}", "property list uchar int vertex_indices"] + ([channels.rstrip()] if face_colour else [])
    lines += ["end_header"]
    lines += [" ".join(map(str, [*point, *(vertex_colour or ())])) for point in points]
    lines += [" ".join(map(str, [3, *face, *(face_colour or ())])) for face in faces]
    path.write_text("\n".join(lines) + "\n")


class Demo(unittest.TestCase):
    program = folder = None

    def run_demo(self, name, *arguments, status=0):
        out = self.folder / name
        out.mkdir(parents=True, exist_ok=True)
        done = subprocess.run([self.program, *map(str, arguments), "--out", out], capture_output=True, text=True)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return out, done.stdout + done.stderr

    def halves(self, **colours):
        paths = []
        for side, heights in (("left", [0.3 + 0.7 * k / 8 for k in range(9)]), ("right", [-1 + 0.7 * k / 7 for k in range(8)])):
            paths.append(self.folder / f"{side}.ply")
            write_ply(paths[-1], *rings(heights, 40 if side == "left" else 31), **{key: value[side] for key, value in colours.items()})
        return "--left", paths[0], "--right", paths[1]

    def test_a_band_is_joined_near_the_sphere_that_it_was(self):
        points, faces = rings([math.sin(math.pi * (k / 48 - 0.5)) for k in range(49)], 96)
        sphere = self.folder / "sphere.ply"
        write_ply(sphere, points, faces)
        out, said = self.run_demo("cut", "--mesh", sphere, "--point", 0, 0.2, 0, "--normal", 0, 1, 0, "--width", 0.25)
        self.assertIn("good:", said)
        self.assertRegex(said, r"rims of 96 and 96 vertices")
        for what, most in (("mean", 2), ("largest", 4)):
            share = float(re.search(what + r" +distance \S+: (\S+) % of the gap", said)[1])
            self.assertGreater(share, 0)
            self.assertLess(share, most)
        removed = (out / "removed.obj").read_text()
        count = int(re.search(r"a band of (\d+) faces", said)[1])
        self.assertEqual(removed.count("\nf "), count)
        show = json.loads((out / "showcase.json").read_text())[0]
        self.assertEqual([state["name"] for state in show["states"]], ["Pieces", "Joined", "Original"])
        self.assertIn("% of the gap", show["text"])

    def test_colours_of_vertices_are_kept(self):
        out, _ = self.run_demo("vertices", *self.halves(vertex_colour={"left": RED, "right": BLUE}))
        for name in ("before", "after"):
            head, _, body = (out / f"{name}.ply").read_text().partition("end_header\n")
            count = int(re.search(r"element vertex (\d+)", head)[1])
            self.assertEqual(re.findall(r"property \w+ (\w+)\n", head)[:6], ["x", "y", "z", "red", "green", "blue"])
            seen = {tuple(map(int, line.split()[3:6])) for line in body.splitlines()[:count]}
            self.assertLessEqual({RED, BLUE}, seen)
            # Between the rims, and nowhere else, colours are between theirs.
            self.assertEqual(len(seen) > 2, name == "after")
        show = json.loads((out / "showcase.json").read_text())[0]
        self.assertIn("vertexColours", show["bodies"][0])

    def test_colours_of_faces_are_kept(self):
        out, _ = self.run_demo("faces", *self.halves(face_colour={"left": RED, "right": BLUE}))
        materials = (out / "after.mtl").read_text()
        kept = {tuple(round(255 * float(c)) for c in line.split()[1:4]) for line in materials.splitlines() if line.startswith("Kd ")}
        self.assertLessEqual({RED, BLUE}, kept)
        self.assertIn("mtllib after.mtl", (out / "after.obj").read_text())
        self.assertIn("faceColours", json.loads((out / "showcase.json").read_text())[0]["bodies"][0])

    def test_says_what_is_wrong(self):
        _, said = self.run_demo("wrong", *self.halves()[:2], status=1)
        self.assertIn("--left and --right", said)
        empty = self.folder / "empty.ply"
        empty.write_text("ply\n")
        _, said = self.run_demo("wrong", "--left", empty, "--right", empty, status=1)
        self.assertIn(f"cannot read {empty}", said)
        sphere = self.folder / "open.ply"
        write_ply(sphere, *rings([-0.9, 0, 0.9], 20))
        _, said = self.run_demo("wrong", "--mesh", sphere, "--point", 0, 0, 0, "--normal", 0, 1, 0, "--width", 0.1, status=1)
        self.assertIn("not closed", said)


if __name__ == "__main__":
    Demo.program, Demo.folder = sys.argv[1], pathlib.Path(sys.argv[2])
    Demo.folder.mkdir(parents=True, exist_ok=True)
    unittest.main(argv=sys.argv[:1], verbosity=2)
