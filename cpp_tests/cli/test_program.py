"""The program as a citizen of its system: many files, pipes, signals, full disks, names: test_program.py PROGRAM PLUGIN FOLDER."""

import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

import meshes
from meshes import read_obj, read_off, tube, write_obj, write_off

DONE, USAGE, FILE, PLUGIN, REFUSED, CANCELLED, MEMORY, DEFECTS = range(8)

CUBE = [(x, y, z) for x in (0, 2) for y in (0, 3) for z in (0, 5)]
CUBE_FACES = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]


class Program(unittest.TestCase):
    program = None

    def expect(self, status, *arguments, says=""):
        return self.program.expect(self, status, *arguments, says=says)

    def at(self, name):
        return self.program.folder / name

    def run_raw(self, *arguments, **keywords):
        return subprocess.run(self.program.command(*arguments), cwd=self.program.folder, capture_output=True, timeout=300, **keywords)

    def setUp(self):
        write_obj(self.at("tube.obj"), *tube(12, 0, 1))
        write_obj(self.at("cube.obj"), CUBE, CUBE_FACES)

    def test_help_fits_a_screen_and_begins_with_an_example(self):
        listed = self.expect(DONE, "--help").stdout.split("Commands:\n")[1].split("\n\n")[0]
        names = re.findall(r"(?m)^  ([a-z]+) ", listed)
        self.assertGreaterEqual(len(names), 16)
        for name in names:
            text = self.expect(DONE, name, "--help").stdout
            self.assertTrue(text.startswith(f"Example: gusset {name} "), name)
            self.assertLessEqual(len(text.splitlines()), 60, name)
            self.assertLessEqual(max(map(len, text.splitlines())), 100, name)

    def test_strict_check(self):
        self.expect(DONE, "check", "tube.obj")
        self.expect(DEFECTS, "check", "tube.obj", "--strict")
        self.expect(DONE, "check", "cube.obj", "--strict")
        self.expect(DEFECTS, "check", "cube.obj", "tube.obj", "--strict")

    def test_strict_check_of_intersections(self):
        # Two cubes of which each is closed.
        both = CUBE + [(x + 1, y + 1, z + 1) for x, y, z in CUBE]
        write_obj(self.at("cubes.obj"), both, CUBE_FACES + [[v + 8 for v in face] for face in CUBE_FACES])
        self.expect(DONE, "check", "cubes.obj", "--strict")
        self.expect(DONE, "check", "cube.obj", "--intersections", "--strict", says="no faces intersect\n")
        self.expect(DONE, "check", "cubes.obj", "--intersections", says="pairs of faces intersect: ")
        found = self.expect(DEFECTS, "check", "cubes.obj", "--intersections", "--strict", "--json", "--listed", "2")
        report = json.loads(found.stdout)
        self.assertGreater(report["values"]["intersections"], 2)
        self.assertRegex(report["report"][-1], r"^\d+ pairs of faces intersect: \d+-\d+ \d+-\d+ \.\.\.$")

    def test_info(self):
        found = json.loads(self.expect(DONE, "info", "cube.obj", "--json").stdout)
        self.assertEqual(found["box"], {"min": [0, 0, 0], "max": [2, 3, 5], "size": [2, 3, 5]})
        self.assertAlmostEqual(found["area"], 2 * (6 + 10 + 15))
        self.assertAlmostEqual(abs(found["volume"]), 30)
        self.assertEqual([round(x, 12) for x in found["centre"]], [1, 1.5, 2.5])
        self.assertIs(found["closed"], True)
        found = json.loads(self.expect(DONE, "info", "tube.obj", "--json").stdout)
        self.assertIsNone(found["volume"])
        # Two files: a list.
        self.assertEqual(len(json.loads(self.expect(DONE, "info", "tube.obj", "cube.obj", "--json").stdout)["files"]), 2)

    def test_many_files(self):
        folder = self.at("many")
        folder.mkdir(exist_ok=True)
        for k in range(5):
            write_obj(folder / f"tube{k}.obj", *tube(6 + k, 0, 1))
        (folder / "notes.md").write_text("not a mesh")
        self.expect(USAGE, "fill", "many", says="--out-dir")
        self.expect(DONE, "fill", "many", "--out-dir", "filled", "--to", "off", "--jobs", "3", says="many/tube4.obj: filled 2 of 2")
        self.assertEqual(sorted(path.name for path in self.at("filled").iterdir()), [f"tube{k}.off" for k in range(5)])
        for k in range(5):
            self.assertEqual(meshes.rims(read_off(self.at(f"filled/tube{k}.off"))[1]), 0)
        # One bad file does not stop the others, and decides the exit status.
        (folder / "bad.obj").write_text("v 1\n")
        report = json.loads(self.expect(FILE, "check", "many", "--json").stdout)["files"]
        self.assertEqual([("error" in one) for one in report], [True] + 5 * [False])
        (folder / "bad.obj").unlink()
        self.expect(DONE, "convert", "many", "--out-dir", "converted", "--to", "stl")
        self.assertEqual(len(list(self.at("converted").iterdir())), 5)
        # Nothing is lost: results of one name are refused, and results that would replace inputs.
        write_off(folder / "tube0.off", CUBE, CUBE_FACES)
        self.expect(USAGE, "convert", "many", "--out-dir", "one", "--to", "ply", says="several inputs would become one/tube0.ply")
        (folder / "tube0.off").unlink()
        self.expect(USAGE, "fill", "many", "--out-dir", "many", says="many/tube0.obj would replace an input")
        self.at("empty").mkdir(exist_ok=True)
        self.expect(FILE, "check", "empty", says="the folder has no mesh files")

    def test_pipes(self):
        write_off(self.at("cube.off"), CUBE, CUBE_FACES)
        done = self.run_raw("convert", "-", "-o", "-", "--to", "off", input=self.at("cube.off").read_bytes())
        self.assertEqual((done.returncode, done.stderr), (DONE, b""))
        self.at("piped.off").write_bytes(done.stdout)
        self.assertEqual(read_off(self.at("piped.off")), ([tuple(map(float, p)) for p in CUBE], CUBE_FACES))
        done = self.run_raw("fill", "-", "-o", "-", "--to", "ply", "--text", input=self.at("tube.obj").read_bytes())
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertTrue(done.stdout.startswith(b"ply\n"))
        self.assertIn(b"filled 2 of 2", done.stderr)
        self.expect(USAGE, "convert", "cube.off", "-o", "-", says="--to")
        done = self.run_raw("check", "-", input=b"\x00\x01\x02")
        self.assertIn(b"--from", done.stderr)
        self.assertEqual(done.returncode, FILE)

    def test_a_closed_pipe_is_no_failure(self):
        command = " ".join(map(str, self.program.command("filters")))
        done = subprocess.run(["bash", "-c", f"set -o pipefail; {command} | head -n 1"], capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (DONE, ""))

    def test_the_same_file_in_and_out(self):
        self.expect(DONE, "fill", "tube.obj", "-o", "tube.obj")
        self.assertEqual(meshes.rims(read_obj(self.at("tube.obj"))[1]), 0)

    def test_a_failure_keeps_the_old_file(self):
        self.at("old.ply").write_bytes(b"precious")
        self.at("bad.obj").write_text("v 0 0 0\nf 1 2 3\n")
        self.expect(FILE, "convert", "bad.obj", "-o", "old.ply")
        self.expect(REFUSED, "weld", "cube.obj", "--tolerance", "-2", "-o", "old.ply")
        self.assertEqual(self.at("old.ply").read_bytes(), b"precious")
        self.assertEqual([path for path in self.program.folder.iterdir() if path.name.startswith(".gusset")], [])

    def test_a_full_disk(self):
        if os.geteuid() != 0 or subprocess.run(["mountpoint", "-q", "/dev/shm"]).returncode != 0:
            self.skipTest("needs root to mount a small disk")
        disk = self.at("disk")
        disk.mkdir(exist_ok=True)
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", disk], capture_output=True).returncode != 0:
            self.skipTest("mounting is not permitted")
        try:
            (disk / "old.obj").write_text("precious")
            write_obj(self.at("large.obj"), *tube(4000, 0, 1))
            self.expect(FILE, "convert", "large.obj", "-o", "disk/old.obj", says="disk/old.obj: ")
            self.assertEqual([path.name for path in disk.iterdir()], ["old.obj"])
            self.assertEqual((disk / "old.obj").read_text(), "precious")
        finally:
            subprocess.run(["umount", disk], check=True)

    @unittest.skipUnless(hasattr(signal, "SIGXFSZ"), "needs limits of files")
    def test_a_limit_of_the_size_of_files(self):
        import resource
        self.at("old.obj").write_text("precious")
        write_obj(self.at("large.obj"), *tube(4000, 0, 1))
        done = subprocess.run(self.program.command("convert", "large.obj", "-o", "old.obj"), cwd=self.program.folder, text=True,
                              capture_output=True, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000)))
        self.assertEqual(done.returncode, FILE, done.stderr)
        self.assertIn("old.obj: ", done.stderr)
        self.assertEqual(self.at("old.obj").read_text(), "precious")

    @unittest.skipUnless(hasattr(os, "mkfifo"), "needs named pipes")
    def test_a_pipe_without_a_reader(self):
        self.at("pipe.obj").unlink(missing_ok=True)
        os.mkfifo(self.at("pipe.obj"))
        self.expect(FILE, "convert", "cube.obj", "-o", "pipe.obj", says="no program reads this pipe")

    def test_interrupts_cancel(self):
        rows = 1500
        points = [(x, y, (x * y) % 7) for x in range(rows) for y in range(rows)]
        faces = [[x * rows + y, (x + 1) * rows + y, (x + 1) * rows + y + 1, x * rows + y + 1] for x in range(rows - 1) for y in range(rows - 1)]
        write_off(self.at("large.off"), points, faces)
        self.at("kept.ply").write_bytes(b"precious")
        for sent in (signal.SIGINT, signal.SIGTERM):
            process = subprocess.Popen(self.program.command("fill", "large.off", "-o", "kept.ply", "--progress"), cwd=self.program.folder,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            # The run has begun once it tells of its progress.
            process.stderr.readline()
            process.send_signal(sent)
            _, told = process.communicate(timeout=60)
            self.assertEqual(process.returncode, CANCELLED, told)
            self.assertIn("cancelled", told)
            self.assertEqual(self.at("kept.ply").read_bytes(), b"precious")
        self.assertEqual([path for path in self.program.folder.iterdir() if path.name.startswith(".gusset")], [])

    def test_names_that_are_not_utf8(self):
        name = os.fsdecode(b"caf\xe9\n.obj")
        write_obj(self.at(name), CUBE, CUBE_FACES)
        out = os.fsdecode(b"\xff.off")
        done = self.run_raw("convert", name, "-o", out, "--json")
        self.assertEqual(done.returncode, DONE, done.stderr)
        self.assertEqual(len(read_off(self.at(out))[1]), 6)
        report = json.loads(done.stdout)
        # Control characters do not reach the terminal.
        self.assertNotIn("\n", report["inputs"][0]["file"])

    def test_pipes_and_devices_are_not_opened(self):
        os.mkfifo(self.at("pipe.obj")) if not self.at("pipe.obj").exists() else None
        self.expect(FILE, "check", "pipe.obj", says="not a regular file")
        self.at("device.ply").unlink(missing_ok=True)
        self.at("device.ply").symlink_to("/dev/zero")
        self.expect(FILE, "check", "device.ply", says="not a regular file")

    def test_angles_are_degrees(self):
        told = json.loads(self.expect(DONE, "filters", "trim", "--json").stdout)
        angle = next(param for param in told["parameters"] if param["id"] == "max_angle")
        self.assertEqual((angle["default"], angle["unit"]), (60, "degree"))
        write_obj(self.at("near.obj"), *tube(12, 0.5, 1.5))
        report = json.loads(self.expect(DONE, "trim", "tube.obj", "near.obj", "--max-angle", "45", "-n", "--json").stdout)
        self.assertEqual(report["parameters"]["max_angle"], 45)
        self.expect(REFUSED, "trim", "tube.obj", "near.obj", "--max-angle", "135", "-n", says="max_angle")

    def test_smooth(self):
        write_obj(self.at("high.obj"), *tube(9, 1.5, 2))
        report = json.loads(self.expect(DONE, "stitch", "tube.obj", "high.obj", "--smooth", "-n", "--json").stdout)
        self.assertEqual(report["parameters"]["finish"], "blend")
        self.expect(USAGE, "stitch", "tube.obj", "high.obj", "--smooth", "--finish", "strip", "-n", says="--smooth sets finish=blend; leave out --smooth or --finish")

    def test_page(self):
        self.expect(DONE, "fill", "tube.obj", "-o", "filled.obj", "--html", "page.html")
        page = self.at("page.html").read_text()
        self.assertIn('"name":"Before"', page)
        self.assertNotIn("@TITLE@", page)
        self.assertGreater(len(page), 100_000)
        self.expect(DONE, "fill", "tube.obj", "-o", "filled.obj", "--html", "again.html")
        self.assertEqual(self.at("again.html").read_text(), page)


if __name__ == "__main__":
    Program.program = meshes.Program(*sys.argv[1:4])
    unittest.main(argv=sys.argv[:1])
