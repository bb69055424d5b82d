#!/usr/bin/env python3
"""Scans that overlap, made one closed mesh: scans.py PROGRAM FOLDER OUT.ply. `make scans FOLDER=... OUT=...` calls it. The folder
has PLY files, meshes or range images. A .conf file may give their poses, like the files of the Stanford 3D Scanning Repository.
Without it, each scan must lie within a tenth of the object's size of its pose. Pictures of the aligned scans and of the model are
written beside OUT
if PyVista is installed."""

import json
import pathlib
import subprocess
import sys


def inputs_of(folder):
    lists = sorted(folder.glob("*.conf"))
    return lists[:1] or sorted(folder.glob("*.ply"))


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    sys.stderr.write(done.stderr)
    if done.returncode != 0:
        sys.exit(done.returncode)
    return json.loads(done.stdout)


def picture(path, meshes):
    """A mesh from four sides."""
    try:
        import pyvista
    except ImportError:
        print("no pictures: PyVista is not installed")
        return
    plotter = pyvista.Plotter(off_screen=True, shape=(1, 4), window_size=(2000, 560), border=False)
    read = [pyvista.read(mesh) for mesh in meshes]
    for side in range(4):
        plotter.subplot(0, side)
        for mesh in read:
            plotter.add_mesh(mesh, color="#c9b58f", smooth_shading=False, backface_params={"color": "#8c4f3d"})
        plotter.view_xy()
        plotter.camera.azimuth = 90 * side
        plotter.camera.zoom(1.3)
    plotter.screenshot(path)
    print(path)


def main():
    program, folder, out = (pathlib.Path(word) for word in sys.argv[1:4])
    inputs = inputs_of(folder)
    if not inputs:
        sys.exit(f"{folder}: there are no .ply files")
    before = out.with_suffix(".aligned.ply")
    run(program, "run", "align", *inputs, "-o", before, "--json")
    report = run(program, "join", "--align", "--overlaps", "trim", "--holes", "fill", *inputs, "-o", out, "--json")
    values = report["values"]
    for line in report["report"]:
        if "may lie wrong" in line:
            print(line)
    print(f"{len(report['inputs'])} scans, {values['trusted_pieces']:g} trusted to lie right; {values['trimmed_faces']:g} faces trimmed, "
          f"{values['filled_holes']:g} holes filled, {values['boundary_loops']:g} boundary loops left: {out}")
    picture(out.with_suffix(".aligned.png"), [before])
    picture(out.with_suffix(".png"), [out])
    before.unlink()


if __name__ == "__main__":
    main()
