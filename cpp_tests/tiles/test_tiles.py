"""One mesh in tiles, over MPI ranks and with blocks on disk: test_tiles.py CASE PROGRAMS FOLDER MPIRUN

Compares the program's report with its files, which tiles_gather reads as one mesh, and with the counts of a torus: R x C tiles of n
x n cells with a gap of one cell between them are as many cells as R (n + 1) x C (n + 1)."""

import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

# Every program may run as root here, more ranks than processors too, and without reading another process's memory.
MPI_OPTIONS = ["--oversubscribe", "--bind-to", "none", "--mca", "btl_vader_single_copy_mechanism", "none"]
os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def run(ranks, *options, status=0):
    """Runs the program on this many ranks in the folder of the test, and returns its output; 0 ranks: without mpirun."""
    start = [MPIRUN, *MPI_OPTIONS, "-n", str(ranks)] if ranks else []
    done = subprocess.run([*start, PROGRAMS / "tiles", *map(str, options)], capture_output=True, text=True, cwd=FOLDER, timeout=300)
    assert done.returncode == status, f"status {done.returncode}, not {status}: {options}\n{done.stdout}{done.stderr}"
    return done.stdout + done.stderr if status else done.stdout


def gathered(folder, *options):
    """The same of the files of finished tiles, read as one mesh."""
    done = subprocess.run([PROGRAMS / "tiles_gather", *options, folder], capture_output=True, text=True, cwd=FOLDER, timeout=300)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def word(pattern, text):
    found = re.search(pattern, text)
    assert found, f"no {pattern} in\n{text}"
    return found.group(1)


def said_hash(text):
    return word(r"(?m)^hash: ([0-9a-f]{16})$", text)


def counts(text):
    return tuple(int(word(rf"(\d+) {what}", text)) for what in ("vertices", "edges", "faces, (?:Euler|1 comp)"))


def peak(text):
    """Megabytes of the rank that needs most."""
    return max(float(x) for x in re.findall(r"([0-9.]+) MB of memory", text))


class Tiles(unittest.TestCase):
    def same_everywhere(self, *options, cells=None):
        """1, 2 and 4 ranks, with all blocks in memory or few: one hash, files of one content, and a closed torus."""
        whole = run(0, *options, "--out", "alone")
        hashes, first = {said_hash(whole)}, None
        for ranks in (1, 2, 4):
            for in_memory in (-1, 1, 3):
                folder = f"out_{ranks}_{in_memory}"
                text = run(ranks, *options, "--in-memory", in_memory, "--scratch", "scratch", "--out", folder)
                on_disk = sum(float(x) for x in re.findall(r"([0-9.]+) MB on disk", text))
                self.assertEqual(on_disk > 0, in_memory > 0, text)
                hashes.add(said_hash(text))
                self.assertEqual(counts(text), counts(whole))
                files = {path.name: path.read_bytes() for path in (FOLDER / folder).iterdir()}
                first = first or files
                self.assertTrue(files == first, "files differ")
        self.assertEqual(list((FOLDER / "scratch").iterdir()), [], "blocks are left on disk")
        seen = gathered("alone")
        hashes |= {said_hash(seen), said_hash(gathered("alone", "--sums"))}
        self.assertEqual(len(hashes), 1, hashes)
        self.assertEqual(counts(seen), counts(whole))
        if cells is not None:
            self.assertEqual(counts(whole), (cells, 3 * cells, 2 * cells))
        return whole

    def test_coincident(self):
        text = self.same_everywhere("--tiles", 3, 5, "--cells", 24, cells=15 * 24 * 24)
        self.assertIn("30 seams, 15 junctions, 0 faces", text)

    def test_apart(self):
        text = self.same_everywhere("--tiles", 4, 4, "--cells", 24, "--gap", cells=16 * 25 * 25)
        self.assertIn(f"32 seams, 16 junctions, {16 * (25 * 25 - 24 * 24) * 2} faces", text)

    def test_mixed(self):
        self.same_everywhere("--tiles", 4, 4, "--cells", 24, "--gap", "--mixed")

    def test_small(self):
        """Two tiles are neighbours on both sides, four meet in four places."""
        for rows, columns in ((2, 2), (2, 3), (5, 2)):
            for gap in (0, 1):
                options = ["--tiles", rows, columns, "--cells", 5] + ["--gap"] * gap
                texts = [run(ranks, *options, "--out", "small") for ranks in (0, 3)]
                self.assertEqual(said_hash(texts[0]), said_hash(texts[1]))
                self.assertEqual(said_hash(texts[0]), said_hash(gathered("small")))
                self.assertEqual(counts(texts[0])[0], rows * columns * (5 + gap) ** 2)
                shutil.rmtree(FOLDER / "small")
        # More ranks than tiles.
        self.assertEqual(said_hash(run(5, "--tiles", 2, 2, "--cells", 5)), said_hash(run(1, "--tiles", 2, 2, "--cells", 5)))

    def test_files(self):
        """Tiles of STL files; one that is missing or damaged is named."""
        options = ["--tiles", 3, 3, "--cells", 20, "--gap"]
        first = run(2, *options, "--save-input", "scans")
        self.assertEqual(said_hash(first), said_hash(run(2, *options, "--input", "scans", "--in-memory", 1, "--scratch", "scratch")))
        faces = sum((path.stat().st_size - 84) // 50 for path in (FOLDER / "scans").iterdir())
        self.assertIn(f"input: {faces} faces", first)
        turned, dropped = int(word(r"(\d+) turned", first)), int(word(r"(\d+) dropped", first))
        self.assertEqual(faces - dropped, 9 * 20 * 20 * 2)
        self.assertGreater(min(turned, dropped), 5)
        scan = FOLDER / "scans" / "tile_000004.stl"
        scan.write_bytes(scan.read_bytes()[:-50])
        self.assertRegex(run(2, *options, "--input", "scans", status=1), "tile 4: .*cut short")
        scan.unlink()
        self.assertRegex(run(0, *options, "--input", "scans", status=1), "tile 4: cannot read")
        # The tile of another place.
        shutil.copy(FOLDER / "scans" / "tile_000005.stl", scan)
        self.assertRegex(run(2, *options, "--input", "scans", status=1), "tile 4: the rim does not pass through corner 0")

    def test_ids(self):
        """Ids beyond 2^32, in the middle of a tile and from the first one on."""
        options = ["--tiles", 3, 3, "--cells", 10, "--gap"]
        for first in (2**32 - 500, 2**40 + 7):
            texts = [run(ranks, *options, "--first-id", first, "--out", f"ids_{first}") for ranks in (1, 2)]
            self.assertEqual(said_hash(texts[0]), said_hash(texts[1]))
            seen = gathered(f"ids_{first}")
            self.assertEqual(said_hash(texts[0]), said_hash(seen))
            self.assertIn(f"ids: {first} to {first + 9 * 121 - 1}", texts[0])

    def test_memory(self):
        """Memory does not grow with the number of tiles, and it would."""
        few, many = ["--tiles", 3, 3, "--cells", 110, "--gap"], ["--tiles", 8, 8, "--cells", 110, "--gap"]
        disk = ["--in-memory", 1, "--scratch", "scratch"]
        all_blocks = 55 * (111 * 111 * 24 + 110 * 110 * 24) / 1e6
        small, large = peak(run(1, *few, *disk)), run(1, *many, *disk)
        self.assertLess(peak(large) - small, 0.15 * all_blocks)
        self.assertGreater(peak(run(1, *many)) - small, 0.7 * all_blocks)
        self.assertGreater(float(word(r"([0-9.]+) MB on disk", large)), 0.9 * all_blocks)
        # Two ranks each have half.
        self.assertLess(peak(run(2, *many)) - small, 0.65 * all_blocks)
        self.assertIn("rank 0 needs no more memory than was allowed", run(1, *few, "--max-memory", 5, status=1))

    def test_rims(self):
        """A rank keeps the rims of all its tiles, and no more: 16 points to a side, then 18."""
        disk = ["--tiles", 40, 40, "--gap", "--in-memory", 1, "--scratch", "scratch"]
        grown = peak(run(0, *disk, "--cells", 17)) - peak(run(0, *disk, "--cells", 15))
        self.assertLess(grown, 1.5, "megabytes, where 112 bytes a point and tile are 0.4")

    def test_queues(self):
        """Rims of more than 4 kB each, to the own rank and to the other."""
        options = ["--tiles", 3, 4, "--cells", 400, "--gap"]
        self.assertEqual(said_hash(run(2, *options, "--in-memory", 1, "--scratch", "scratch")), said_hash(run(2, *options)))

    def test_scratch(self):
        """A folder that cannot be written to, and a full disk: the file is named, and nothing is left."""
        disk = ["--in-memory", 1, "--scratch"]
        self.assertIn("cannot write /proc/block", run(0, "--cells", 10, *disk, "/proc", status=1))
        with tempfile.TemporaryDirectory(dir=FOLDER) as small:
            if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=100k", "tmpfs", small], capture_output=True).returncode != 0:
                self.skipTest("no small disk can be mounted")
            try:
                # Full of the first few blocks, or of all but the last.
                for options, kilobytes in ((["--cells", 30], 100), (["--tiles", 3, 3, "--cells", 160, "--gap"], 9000)):
                    subprocess.run(["mount", "-o", f"remount,size={kilobytes}k", small], check=True)
                    self.assertRegex(run(0, *options, *disk, small, status=1), "cannot write .*/block.*: is the disk full")
                    self.assertEqual(os.listdir(small), [])
            finally:
                subprocess.run(["umount", small], check=True)

    def test_seams(self):
        """Bytes of a seam grow as the square root of a tile's faces: as its rim does."""
        for gap in ([], ["--gap"]):
            for cells in (10, 40, 160):
                text = run(2, "--tiles", 2, 3, "--cells", cells, *gap)
                most = int(word(r"(\d+) bytes a seam", text))
                self.assertEqual(most, 32 + 28 * (cells + 1))
                self.assertLessEqual(most, 60 + 20 * math.sqrt(2 * cells * cells))
                self.assertEqual(int(word(r"(\d+) for all", text)), 12 * most)
                self.assertEqual(int(word(r"(\d+) for junctions", text)), 6 * 3 * 60)

    def test_refused(self):
        """Wrong arguments: status 2 and a sentence."""
        for options, sentence in ((["--tiles", 1, 4], "at least 2 rows"), (["--cells", 1], "2 to 20000 cells"), (["--mixed"], "need a gap"),
                                  (["--gap", "--mixed", "--cells", 7], "even number"), (["--in-memory", 0], "at least 1 block"),
                                  (["--tiles", 3], "--tiles"), (["--cells", "many"], "--cells"), (["--no-such"], "--no-such"),
                                  (["--tiles", 65536, 65536], "tiles at most"),
                                  (["--tiles", 4096, 4096], "tiles at most"), (["--first-id", 2**63], "first id"),
                                  (["--input", "a", "--save-input", "b"], "either read or written")):
            self.assertIn(sentence, run(0, *options, status=2))
        self.assertEqual(run(2, "--mixed", status=2).count("need a gap"), 1)
        self.assertIn("--in-memory", run(0, "--help"))
        self.assertNotEqual(subprocess.run([PROGRAMS / "tiles_gather", FOLDER], capture_output=True).returncode, 0)
        # A folder that cannot be written to.
        (FOLDER / "file").write_text("")
        run(2, "--cells", 4, "--out", "file/out", status=1)

    def test_guide(self):
        """The commands of the guide."""
        path = f"{PROGRAMS}{os.pathsep}{pathlib.Path(MPIRUN).parent}{os.pathsep}{os.environ['PATH']}"
        done = subprocess.run([os.environ["GUIDE"]], capture_output=True, text=True, cwd=FOLDER, timeout=300,
                              env={**os.environ, "PATH": path, "MPI": " ".join([MPIRUN, *MPI_OPTIONS])})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        hashes = re.findall(r"(?m)^hash: (.*)$", done.stdout)
        self.assertEqual(len(hashes), 6)
        self.assertEqual(len(set(hashes)), 1)


if __name__ == "__main__":
    CASE, PROGRAMS, FOLDER, MPIRUN = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]), sys.argv[4]
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    if not shutil.which(MPIRUN):
        print("SKIPPED: there is no mpirun (openmpi-bin)")
        sys.exit()
    result = unittest.TextTestRunner(verbosity=2).run(Tiles(f"test_{CASE}"))
    shutil.rmtree(FOLDER)
    sys.exit(not result.wasSuccessful())
