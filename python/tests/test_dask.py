"""Many models over a Dask cluster: the same bytes as in one process, and a worker that is killed loses nothing."""

import os
import pathlib
import signal
import subprocess
import sys

import pytest

pytest.importorskip("distributed")

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples/dask"
if not EXAMPLES.is_dir():
    pytest.skip("the example is not here", allow_module_level=True)
sys.path.insert(0, str(EXAMPLES))

import assemble_many  # noqa: E402
import trimesh  # noqa: E402
from distributed import Client, LocalCluster  # noqa: E402

JOBS = 40


@pytest.fixture(scope="module")
def alone():
    return [assemble_many.run_formula(number) for number in range(JOBS)]


@pytest.fixture
def cluster():
    # Workers find what the tests find.
    before = os.environ.get("PYTHONPATH", "")
    os.environ["PYTHONPATH"] = os.pathsep.join([str(EXAMPLES), str(EXAMPLES.parents[1] / "python"), before])
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as made, Client(made) as client:
        yield made, client
    os.environ["PYTHONPATH"] = before


def test_models_are_closed_and_different(alone):
    assert all(summary["closed"] and summary["pieces"] == 4 for summary in alone)
    assert len({summary["digest"] for summary in alone}) == JOBS


def test_two_processes_give_the_same_bytes(alone, cluster):
    seen = []
    got = assemble_many.over(cluster[1], assemble_many.run_formula, range(JOBS), report=lambda *count: seen.append(count))
    assert got == alone
    assert seen == [(k, JOBS) for k in range(1, JOBS + 1)]
    assert len(cluster[1].run(os.getpid)) == 2


def test_a_killed_worker_loses_nothing(alone, cluster):
    made, client = cluster
    victim = next(iter(client.run(os.getpid).values()))

    def kill(done, count):
        if done == JOBS // 4:
            os.kill(victim, signal.SIGKILL)

    got = assemble_many.over(client, assemble_many.run_formula, range(JOBS), report=kill)
    assert got == alone
    assert victim not in client.run(os.getpid).values()


def test_folders_of_files(tmp_path):
    for number in range(3):
        folder = tmp_path / "in" / f"model_{number}"
        folder.mkdir(parents=True)
        for k, (points, faces) in enumerate(assemble_many.by_formula(number)):
            trimesh.Trimesh(points, faces, process=False).export(folder / f"{k}.ply")
    made = subprocess.run([sys.executable, EXAMPLES / "assemble_many.py", tmp_path / "in", tmp_path / "out"], capture_output=True, text=True)
    assert made.returncode == 0, made.stderr
    assert "3 models, 3 closed" in made.stdout
    for number in range(3):
        assert trimesh.load(tmp_path / "out" / f"model_{number}.ply").is_watertight
