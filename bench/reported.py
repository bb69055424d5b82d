"""The small cases of ../shared/data/cases, one row each: what is expected, and what the default gives now. `python bench/reported.py
FOLDER` needs gusset_mesh, numpy, scipy and trimesh."""

import gzip
import sys
import tempfile
from pathlib import Path

import numpy as np

import gusset_mesh as gm
from gusset_mesh import filters
from kind_curves import crosses
from kind_judge import Look

FOLDER = Path(sys.argv[1] if len(sys.argv) > 1 else "../shared/data/cases")


def read(name):
    if not name.endswith(".gz"):
        return gm.read(FOLDER / name)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / name.removesuffix(".gz")
        path.write_bytes(gzip.decompress((FOLDER / name).read_bytes()))
        return gm.read(path)


def look(name):
    return Look(read(name).mesh)


def curves(*names):
    """The lines and points of OBJ files, which are read here without the library."""
    made = []
    for name in names:
        points, lines = [], []
        for head, *rest in map(str.split, filter(str.strip, (FOLDER / name).read_text().splitlines())):
            if head == "v":
                points.append([float(x) for x in rest])
            elif head in ("l", "p"):
                lines.append([int(c) - 1 for c in rest])
        rings = [len(line) > 1 and line[0] == line[-1] for line in lines]
        made.append(gm.Curves([np.array(points)[line[:-1] if ring else line] for line, ring in zip(lines, rings)], closed=rings))
    return made


def area(name):
    return f"area {Look(read(name).mesh).area:.6g}"


def state(made):
    seen = made if isinstance(made, Look) else Look(made)
    words = f"V {seen.vertices}, loops {seen.loops}, flat faces {seen.flat}, V - E + F = {seen.euler}"
    return words + f", volume {seen.volume:.6g}" * seen.closed


def joined(*names, **options):
    return state(filters.join(*map(read, names), **options)[0])


def pair(name):
    return [read(f"{name}_{side}.off.gz") for side in "ab"]


def trimmed(name):
    made = Look(filters.join(*pair(name), overlaps="trim")[0])
    return f"bodies {made.bodies}, loops {made.loops}, flat faces {made.flat}"


def ends_of_loft():
    points = np.asarray(filters.loft(*curves("sections_two_rectangles.obj"))[0].points)
    sides = [np.ptp(points[abs(points[:, 2] - z) < 1e-9, :2], axis=0) for z in (points[:, 2].min(), points[:, 2].max())]
    return f"areas {sides[0].prod():.6g} and {sides[1].prod():.6g}"


def radius_of_step():
    given, = curves("sections_step.obj")
    radii = [np.hypot(*given[k][:, :2].T).mean() for k in range(len(given))]
    heights = [given[k][0, 2] for k in range(len(given))]
    points = np.asarray(filters.loft(given)[0].points)
    step = next(k for k in range(len(radii) - 1) if abs(radii[k] - radii[k + 1]) < 1e-6)
    between = points[(points[:, 2] >= heights[step]) & (points[:, 2] <= heights[step + 1])]
    off = np.hypot(*between[:, :2].T)
    return f"radius {off.min():.4f} to {off.max():.4f}; given {radii[step]:.4f}"


def waypoints(**options):
    points = np.loadtxt(FOLDER / "waypoints_crowded.csv", delimiter=",", skiprows=1)
    made = gm.Outline(points, **options)
    sampled = made.curve.sample(2000).points[:, :2]
    return f"crosses itself: {crosses(sampled, closed=False)}, statuses {sorted(set(map(str, made.statuses)))}"


def ring():
    made = gm.Outline(np.loadtxt(FOLDER / "ring_end_almost_repeated.csv", delimiter=",", skiprows=1), closed=True)
    off = abs(np.linalg.norm(made.curve.sample(800).points, axis=1) - 1).max()
    return f"radius off by {off:.1e}, statuses {sorted(set(map(str, made.statuses)))}"


def net(order):
    made = Look(filters.smooth_net(*curves(f"net_across_{order}.obj", "net_along.obj"))[0])
    return f"area {made.area:.9g}, loops {len(made.loops)}"


def flat_normals():
    """The box as a file without normals has it."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "box.obj"
        gm.save(path, gm.Mesh(*merged(filters.fill(read("box_flat_normals.glb"))[0])))
        return state(gm.read(path).mesh)


def merged(mesh):
    """A mesh with the vertices that coincide as one."""
    points, names = np.unique(mesh.points, axis=0, return_inverse=True)
    return points, names.reshape(-1)[mesh.triangles()].astype(np.uint32)


def latlon():
    lon, lat = np.radians(np.linspace(-180.5, 179.5, 37)), np.radians(np.linspace(-90, 90, 19))
    la, lo = np.meshgrid(lat, lon, indexing="ij")
    points = np.stack([np.cos(la) * np.cos(lo), np.cos(la) * np.sin(lo), np.sin(la)], axis=2).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(18), np.arange(36), indexing="ij")
    a = (i * 37 + j).ravel()
    return state(gm.weld((points, np.stack([a, a + 1, a + 38, a + 37], axis=1)), vertices="all", collapse="allow", unused="remove").mesh)


def both(first, second):
    return f"{first}; {second}"


TILES = [f"gap_tile_{name}.obj" for name in ("00", "01", "10", "11")]
CASES = [
    *((name, "4 faces, closed", lambda name=name: both(f"{read(name).mesh.face_count} faces", gm.check(gm.weld(read(name), vertices="all").mesh)))
      for name in ("stl_capitals.stl", "stl_blank_first.stl", "stl_binary_solid_one_byte_more.stl", "off_counts_in_first_line.off",
                   "obj_slashes_1.obj", "obj_slashes_2.obj", "obj_normals_named_but_absent.obj")),
    ("obj_interleaved_negative.obj", "V 24, closed", lambda: state(read("obj_interleaved_negative.obj").mesh)),
    ("u_profile.obj", "area 70", lambda: area("u_profile.obj")),
    ("wall_with_window.obj", "area 39.2, volume 4.8", lambda: both(area("wall_with_window.obj"), state(read("wall_with_window.obj").mesh))),
    ("box_flat_normals.glb, fill; equal points merged", "closed, V 8", flat_normals),
    ("tube_8 + tube_12", "V 36, loops [8, 12], flat faces 0", lambda: joined("tube_8.obj", "tube_12.obj")),
    ("strip_fine + strip_coarse", "loops [10]", lambda: joined("strip_fine.obj", "strip_coarse.obj")),
    ("sheet_fine + sheet_coarse", "one loop", lambda: joined("sheet_fine.obj", "sheet_coarse.obj")),
    ("gap_tile_*, holes=fill", "loops [60]", lambda: joined(*TILES, holes="fill")),
    ("hollow.stl, join", "volume 183.6", lambda: joined("hollow.stl")),
    ("hollow.stl, orient", "volume 183.6", lambda: state(filters.orient(filters.weld(read("hollow.stl"), vertices="all_vertices")[0], outward="outwards")[0])),
    ("debris.obj, fill", "hole closed; loops of debris 3, 4 stay", lambda: state(filters.fill(read("debris.obj"))[0])),
    *((f"{name}, repair", "closed, no flat faces", lambda name=name: state(filters.repair(read(name))[0]))
      for name in ("both_sides.obj", "one_wall_twice.obj", "triangle_without_area.stl")),
    ("gap_wider_than_edges.obj, tolerance=0.05", "one loop, no flat faces", lambda: joined("gap_wider_than_edges.obj", tolerance=0.05)),
    ("far_west + far_east", "one body", lambda: joined("far_west.obj", "far_east.obj")),
    ("shed_split_ridge.obj", "V 12, volume 177.2", lambda: joined("shed_split_ridge.obj")),
    ("ring_big.STL, fill", "closed, V - E + F = 0", lambda: state(filters.fill(read("ring_big.STL"))[0])),
    *((f"{name}, stitch", "one body, loops [40, 48], no flat faces", lambda name=name: state(filters.stitch(*pair(name))[0]))
      for name in ("elbow75", "elbow90")),
    ("lost_island, overlaps=trim", "the island stays: 2 bodies", lambda: trimmed("lost_island")),
    *((name, "loops [48, 48], no flat faces", lambda name=name: state(filters.join(*pair(name))[0]))
      for name in ("partial_coincidence0", "partial_coincidence2")),
    ("sections_step.obj", "radius 1 between equal sections", radius_of_step),
    ("sections_two_rectangles.obj", "areas 50 and 32", ends_of_loft),
    ("sections_to_a_point.obj", "a closed tip: one loop, V - E + F = 1", lambda: state(filters.loft(*curves("sections_to_a_point.obj"))[0])),
    ("sections_both_ways_round.obj", "untwisted", lambda: filters.loft(*curves("sections_both_ways_round.obj"))[1].splitlines()[1]),
    ("net_across_sorted + net_along", "the same area", lambda: net("sorted")),
    ("net_across_unsorted + net_along", "the same area", lambda: net("unsorted")),
    ("waypoints_crowded.csv", "no loops", waypoints),
    ("waypoints_crowded.csv, median", "no loops, or a status", lambda: waypoints(method="median")),
    ("ring_almost_repeated.py", "1e-3, or a status", ring),
    ("pentagram.obj", "5 places", lambda: f"{len(filters.curve_meet(*curves('pentagram.obj'))[0])} places"),
    ("triangle_in_square.obj", "area 56", lambda: f"area {Look(filters.strip(*curves('triangle_in_square.obj'))[0]).area:.6g}"),
    ("latlon.py", "V 614, V - E + F = 2", latlon),
]


def main():
    print("| case | expected | now |\n|---|---|---|")
    for name, expected, run in CASES:
        try:
            now = str(run())
        except gm.Error as error:
            now = f"refused: {error}"
        print(f"| {name} | {expected} | {now} |")


if __name__ == "__main__":
    main()
