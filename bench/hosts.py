"""Other hosts: a small call through the Python package compared with C, models over Dask by two workers compared with one, and the
memory of one mesh in tiles compared with the limit of a rank."""

import os
import re
import statistics
import shutil
import subprocess
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ROWS = "python/call/c", "dask/two-workers/one-worker", "tiles/memory/limit"
RUNS, MODELS, FINENESS = 5, 200, 120
# Memory limit of a rank, in megabytes.
LIMIT = 2000

CALL = """
import statistics, time
import numpy as np
import gusset_mesh as gm
mesh = gm.Mesh(np.eye(3), np.array([[0, 1, 2]], np.uint32))
times = []
for _ in range(9):
    start = time.perf_counter()
    for _ in range(20000):
        gm.check(mesh)
    times.append((time.perf_counter() - start) / 20000 * 1e6)
print(statistics.median(times))
"""


def wanted(only):
    return any(only in row for row in ROWS)


def run(library, report, tools, only):
    venv, package = ROOT / "build/python-hosts", ROOT / "python"
    subprocess.run([ROOT / "scripts/venv.sh", venv, package / "requirements.txt", package / "requirements-hosts.txt"], check=True)
    python, native = venv / "bin/python", [library / "lib/libgusset.so", "gusset_mesh"]
    subprocess.run([python, "-B", "build_backend.py", *native], cwd=package, check=True)
    environment = {**os.environ, "PYTHONPATH": str(package)}

    def output(*command):
        return subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stdout

    if only in ROWS[0]:
        ours, theirs = [], []
        for _ in range(RUNS):
            ours.append(float(output(python, "-B", "-c", CALL)))
            theirs.append(float(output(tools / "call")))
        mine, other = statistics.median(ours), statistics.median(theirs)
        report.add("python/call", "c", mine, other, {"overhead_us": mine - other}, "us")
    if only in ROWS[1]:
        rates = {1: [], 2: []}
        for _ in range(RUNS):
            for workers, seen in rates.items():
                said = output(python, "-B", ROOT / "examples/dask/assemble_many.py", "--jobs", str(MODELS), "--rows", str(FINENESS), "--workers", str(workers))
                seen.append(float(re.search(r"([\d.]+) a second", said).group(1)))
        one, two = (1000 / statistics.median(rates[workers]) for workers in (1, 2))
        report.add("dask/two-workers", "one-worker", two, one, {"models": MODELS, "rows": FINENESS})
    if only in ROWS[2]:
        in_tiles(library, report)


def in_tiles(library, report):
    """12.9 million faces in 256 tiles, one at a time in memory."""
    folder = ROOT / "build/tiles"
    made = [["cmake", "-S", ROOT / "examples/tiles", "-B", folder, f"-DGUSSET_PREFIX={library}"], ["cmake", "--build", folder, "--parallel", "2"]]
    if not shutil.which("mpirun") or any(subprocess.run(command, capture_output=True).returncode for command in made):
        print("SKIPPED: tiles: there is no MPI, or no DIY: make test-hosts-all installs both")
        return
    with tempfile.TemporaryDirectory() as scratch:
        said = subprocess.run(["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", "2", folder / "tiles", "--tiles", "16", "16", "--cells", "158", "--gap",
                               "--in-memory", "1", "--scratch", scratch], check=True, capture_output=True, text=True).stdout
    peaks = [float(found) for found in re.findall(r"([\d.]+) MB of memory at the peak", said)]
    faces = int(re.search(r"(\d+) faces", said.replace(",", "").replace("'", "")).group(1))
    report.add("tiles/memory", "limit", max(peaks), LIMIT, {"faces": faces}, "MB")
