"""Calls let other threads run, stop when they are told to, and leave nothing behind."""

import gc
import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
import shapes

import gusset_mesh as gm

TESTS = os.path.dirname(os.path.abspath(__file__))


def big(rows=700):
    """A bumpy square with many holes, which takes a while to fill."""
    nodes = shapes.grid(rows, rows, lambda u, v: 0.1 * np.sin(40 * u) * np.cos(30 * v)).reshape(-1, 3)
    faces = shapes.quads(rows, rows)
    kept = (np.arange(len(faces)) // 3 + np.arange(len(faces)) // (rows - 1)) % 7 != 0
    return gm.Mesh(nodes, faces[kept].astype(np.uint32))


def test_progress_rises_and_may_cancel():
    seen = []
    made = gm.fill(big(100), progress=lambda part, what: seen.append((part, what)))
    parts = [part for part, _ in seen]
    assert parts == sorted(parts) and 0 <= parts[0] and parts[-1] <= 1 and all(what for _, what in seen)
    assert made.mesh.face_count > 0

    class Enough(Exception):
        pass

    def stop(part, what):
        if part > 0.3:
            raise Enough(what)

    with pytest.raises(Enough):
        gm.fill(big(100), progress=stop)
    with pytest.raises(Enough):
        gm.filters.fill(big(100), progress=stop)
    # The context is usable again, and nothing is remembered.
    assert gm.fill(big(100)).mesh.face_count == made.mesh.face_count


def test_calls_within_callbacks():
    inner = []
    gm.fill(big(60), progress=lambda part, what: inner.append(gm.check(shapes.cap()).report.euler))
    assert set(inner) == {1}


INTERRUPTED = """
import sys, time, os, signal, threading
sys.path.insert(0, {tests!r})
import numpy as np, gusset_mesh as gm
from test_calls import big
one = big(900)
pieces = [gm.Mesh(np.asarray(one.points) + [0, 0, 0.003 * k], one.faces) for k in range(4)]
sent = []
def send():
    time.sleep({after})
    sent.append(time.perf_counter())
    os.kill(os.getpid(), signal.SIGINT)
threading.Thread(target=send).start()
start = time.perf_counter()
try:
    {job}
    print("ended", time.perf_counter() - start)
except KeyboardInterrupt:
    print("stopped", time.perf_counter() - sent[0])
assert gm.weld((np.eye(3), [[0, 1, 2]])).mesh.vertex_count == 3
"""


@pytest.mark.parametrize("job", ["gm.join(pieces, fill=True)", "gm.filters.join(*pieces)"])
@pytest.mark.parametrize("after", [0.2, 1.0])
def test_ctrl_c_stops_a_long_call(job, after):
    said = subprocess.run([sys.executable, "-c", INTERRUPTED.format(tests=TESTS, after=after, job=job)], capture_output=True, text=True)
    assert said.returncode == 0, said.stderr
    what, seconds = said.stdout.split()
    # Soon is some tenths of a second on a busy machine; the measured figures are in the notes of `make bench`.
    assert what == "stopped" and float(seconds) < 2


def test_other_threads_run_meanwhile():
    counted = [0]
    stop = threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.perf_counter()
    gm.fill(big(150), threads=1)
    passed, seen = time.perf_counter() - start, counted[0]
    stop.set()
    thread.join()
    assert seen > 50 * passed


def test_many_threads_give_the_same_bytes():
    expected = gm.join([shapes.cap(), shapes.cap(-1)], fill=True).mesh.points.tobytes()
    mesh = gm.Mesh(*shapes.cap())
    got, failed = [], []

    def work():
        try:
            for _ in range(20):
                got.append(gm.join([mesh, shapes.cap(-1)], fill=True).mesh.points.tobytes())
                gm.boundary_loops(mesh)
        except BaseException as error:  # noqa: BLE001
            failed.append(error)

    threads = [threading.Thread(target=work) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not failed and set(got) == {expected} and len(got) == 160


def resident():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="no /proc")
def test_many_calls_leave_nothing():
    mesh = gm.Mesh(*shapes.cap(rows=2, columns=8))
    bad = gm.Mesh(mesh.points * np.nan, mesh.faces)
    surface = gm.Surface(shapes.grid(5, 5))

    def each():
        gm.weld(mesh).mesh.points.sum()
        gm.boundary_loops(mesh)[0].vertices.sum()
        gm.filters.check(mesh)
        surface.nearest([[0.1, 0.2, 3]])
        try:
            gm.check(bad)
        except gm.InputError:
            pass

    for _ in range(1000):
        each()
    gc.collect()
    before = resident()
    for _ in range(4000):  # five calls each
        each()
    gc.collect()
    assert resident() - before < 1 << 18


def test_a_forked_process_works():
    code = ("import os, numpy as np, gusset_mesh as gm\n"
            "mesh = (np.eye(3), [[0, 1, 2]])\n"
            "gm.weld(mesh)\n"
            "child = os.fork()\n"
            "gm.weld(mesh, threads=2)\n"
            "os._exit(0) if child == 0 else None\n"
            "assert os.waitpid(child, 0)[1] == 0")
    assert subprocess.run([sys.executable, "-c", code], timeout=60).returncode == 0
