"""Assembles many models, each of pieces of its own, over a Dask cluster.

    assemble_many.py [--jobs 200] [--workers 2]      models by formula, on this machine
    assemble_many.py IN OUT                          each folder of IN has the pieces of one model; OUT gets NAME.ply
    assemble_many.py --scheduler tcp://HOST:8786     on a cluster that runs already
    assemble_many.py --slurm 64                      on 64 jobs of Slurm, by dask-jobqueue

If a worker dies, another worker repeats its jobs. The same models give the same bytes on any worker.
"""

import argparse
import contextlib
import hashlib
import pathlib
import sys
import time

import numpy as np
from distributed import Client, LocalCluster, as_completed

import gusset_mesh as gm


#! [job]
def assembled(name, pieces):
    """Joins the pieces of a model. Returns a summary, small enough to send between processes, and the mesh."""
    made = gm.join(pieces, fill=True, threads=1)  # a worker has one core
    mesh, check = made.mesh, gm.check(made.mesh)
    digest = hashlib.sha256(mesh.points.tobytes() + mesh.corners.tobytes()).hexdigest()
    summary = {"name": name, "pieces": len(pieces), "joints": len(made.joints), "faces": mesh.face_count,
               "closed": check.is_closed, "digest": digest}
    return summary, mesh
#! [job]


def by_formula(number, rows=40):
    """Returns the pieces of one model: the quarters of a bumpy ball, with narrow gaps between them."""
    random = np.random.default_rng(number)
    columns = 4 * (int(random.integers(14, 22)) * rows // 40)
    polar = np.linspace(0.25, np.pi - 0.25, rows)[:, None]
    bumps = random.normal(0, 0.04, 3)
    pieces = []
    for quarter in range(4):
        angle = np.linspace(0.04, np.pi / 2 - 0.04, columns // 4)[None, :] + quarter * np.pi / 2
        radius = 1 + bumps[0] * np.sin(3 * angle) + bumps[1] * np.cos(2 * polar) + bumps[2] * np.sin(polar + 2 * angle)
        points = np.stack([radius * np.sin(polar) * np.cos(angle), radius * np.sin(polar) * np.sin(angle),
                           radius * np.cos(polar) + 0 * angle], axis=2).reshape(-1, 3)
        i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns // 4 - 1), indexing="ij")
        a = (i * (columns // 4) + j).reshape(-1, 1)
        pieces.append((points, a + np.array([[0, columns // 4, columns // 4 + 1, 1]])))
    return pieces


def run_formula(number, rows=40):
    return assembled(f"ball {number}", by_formula(number, rows))[0]


def run_folder(folder, out):
    import trimesh
    folder = pathlib.Path(folder)
    pieces = [trimesh.load(file, process=False) for file in sorted(folder.iterdir()) if file.suffix in (".ply", ".obj", ".stl", ".off")]
    summary, mesh = assembled(folder.name, pieces)
    from gusset_mesh.trimesh import to_trimesh
    to_trimesh(mesh).export(pathlib.Path(out) / f"{folder.name}.ply")
    return summary


#! [map]
def over(client, run, *arguments, retries=3, report=lambda done, count: None):
    """Runs a job for each set of arguments on the cluster, and returns the results in order. If a worker dies, another repeats its jobs."""
    futures = client.map(run, *arguments, retries=retries, pure=False)
    for done, _ in enumerate(as_completed(futures), 1):
        report(done, len(futures))
    return client.gather(futures)
#! [map]


def bar(done, count):
    filled = 40 * done // max(count, 1)
    print(f"\r[{'#' * filled}{' ' * (40 - filled)}] {done}/{count}", end="\n" if done == count else "", file=sys.stderr, flush=True)


@contextlib.contextmanager
def cluster(options):
    """Yields a client of the cluster that the options name."""
    if options.scheduler:
        with Client(options.scheduler) as client:
            yield client
        return
    if options.slurm:
        from dask_jobqueue import SLURMCluster
        made = SLURMCluster(cores=1, processes=1, memory="2 GB", walltime="01:00:00")
        made.scale(jobs=options.slurm)
    else:
        made = LocalCluster(n_workers=options.workers, threads_per_worker=1, processes=True, dashboard_address=None)
    with made, Client(made) as client:
        yield client


def main():
    parser = argparse.ArgumentParser(description="Assembles many models over a Dask cluster.")
    parser.add_argument("folders", nargs="*", metavar="IN OUT", help="a folder of folders of pieces, and one for the results")
    parser.add_argument("--jobs", type=int, default=200, help="how many models by formula")
    parser.add_argument("--rows", type=int, default=40, help="how many rows of quads they have")
    parser.add_argument("--workers", type=int, default=2, help="processes on this machine")
    parser.add_argument("--scheduler", help="the address of a cluster that runs already")
    parser.add_argument("--slurm", type=int, metavar="JOBS", help="the number of Slurm jobs to start")
    options = parser.parse_args()
    if len(options.folders) not in (0, 2):
        parser.error("a folder of folders of pieces, and one for the results")
    with cluster(options) as client:
        start = time.perf_counter()
        if options.folders:
            source, out = options.folders
            pathlib.Path(out).mkdir(parents=True, exist_ok=True)
            names = sorted(str(folder) for folder in pathlib.Path(source).iterdir() if folder.is_dir())
            summaries = over(client, run_folder, names, [out] * len(names), report=bar)
        else:
            summaries = over(client, run_formula, range(options.jobs), [options.rows] * options.jobs, report=bar)
        seconds = time.perf_counter() - start
    for summary in summaries if options.folders else []:
        print(f"{summary['name']}: {summary['pieces']} pieces, {summary['joints']} joints, {summary['faces']} faces, "
              f"{'closed' if summary['closed'] else 'open'}")
    closed = sum(summary["closed"] for summary in summaries)
    print(f"{len(summaries)} models, {closed} closed, {sum(summary['faces'] for summary in summaries)} faces, "
          f"{len(summaries) / seconds:.1f} a second")


if __name__ == "__main__":
    main()
