"""Intersecting triangles by CGAL, for kinds.py. The program kind_cuts.cpp is compiled when it is first needed."""

import shutil
import subprocess
from functools import cache
from pathlib import Path

import numpy as np

SOURCE = Path(__file__).with_suffix(".cpp")
FOLDER = SOURCE.parent.parent / "build" / "kinds"
HEADERS = Path("/usr/include/CGAL"), Path("/usr/local/include/CGAL")


@cache
def program():
    """The running program, or None without a compiler or CGAL."""
    compiler = shutil.which("c++")
    if compiler is None or not any(path.exists() for path in HEADERS):
        return None
    built = FOLDER / "kind_cuts"
    if not built.exists() or built.stat().st_mtime < SOURCE.stat().st_mtime:
        FOLDER.mkdir(parents=True, exist_ok=True)
        # CGAL needs the rounding of floating-point numbers as it sets it.
        subprocess.run([compiler, "-std=c++17", "-O1", "-frounding-math", SOURCE, "-o", built, "-lgmp", "-lmpfr"], check=True)
    return subprocess.Popen([built], stdin=subprocess.PIPE, stdout=subprocess.PIPE)


def count_cuts(points, triangles):
    """The number of pairs of triangles that intersect, or None without CGAL."""
    judge = program()
    if judge is None:
        return None
    judge.stdin.write(np.array([len(points), len(triangles)], dtype=np.uint64).tobytes())
    judge.stdin.write(np.ascontiguousarray(points, dtype=np.float64).tobytes())
    judge.stdin.write(np.ascontiguousarray(triangles, dtype=np.uint32).tobytes())
    judge.stdin.flush()
    return int(judge.stdout.readline())
