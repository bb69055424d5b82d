"""docs/benchmarks.md and docs/benchmarks.svg, from the entries of one full run."""

import re
import subprocess
import time
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from plot import write_plot
from report import number

QUALITIES = {
    "faces": "new faces", "intersections": "intersections", "closed": "closed", "min_angle": "least angle",
    "aspect": "worst aspect", "dihedral_p95": "dihedral p95", "dihedral_max": "dihedral max", "area": "area",
}
HEAD = """# Benchmarks

Written by `make bench`; do not edit. {date}, {cpu}, {cores} cores, {memory}.
gusset {gusset}; {peers}.

Ours and the peers run by turns in one process on the same arrays; medians; ratio = peer / ours, so that above 1 gusset is
faster. The machine is shared: absolute times move, ratios within one run are what to trust. Meshes are made at run time from
the bunny of the Debian package glmark2-data: `jagged` lacks the faces whose middle lies in -0.3 < y < -0.2, `planar` lacks the
slab itself, cut exactly; sizes in names are faces or the vertices of the two rims.

![Time against size](benchmarks.svg)
"""
PARRY = re.compile(r'parry3d-f64 = "=(.+)"')
SECTIONS = {
    "boundary": """## Boundary loops

From arrays to ordered loops. `read` is one pass over the indices, the limit of the hardware. `meshlib-prebuilt` walks a mesh
that is built already. `boundary` is GUSSET_SURVEY_BOUNDARY_ONLY, `boundary-full` the default, which reports everything unusual.""",
    "boundary-full": "",
    "winged": "## Winged-edge tables\n\nFrom arrays to the table; the peers build their half-edges.",
    "attributes": """## Attributes

Normals of vertices, texture coordinates of corners and numbers of faces carried over to two joined grids of half a million faces;
`limit` copies as many bytes on one thread. `values_per_second`: numbers written.""",
    "join": """## Joins, from arrays to arrays

Loops found, the strip made, the whole mesh handed back. `gusset-index` and the like are other choices of meridians of our own
beside the default, the best continuation.""",
    "join-strip": """## Joins, the strip alone

Everything else is known: for gusset two rims and their first meridian, for the peers a mesh with its holes found.""",
    "python": """## A call from Python

One triangle is checked: by the Python package, and by a loop in C. `overhead_us`: what Python adds to a call, in microseconds.""",
    "dask": """## Models over Dask

Bumpy balls in four quarters assembled over a cluster of this machine: milliseconds a model with two workers beside one.""",
    "tiles": """## One mesh in tiles

A torus in 256 tiles over two ranks, one tile at a time in memory: peak megabytes of a rank and its limit.""",
    "truth": """## Joins beside the surface that was there

Slabs cut out of closed meshes, 1, 2, 4 and 8 % of their size wide, exactly or along their own edges: six of CGAL's collection
(the Debian package libcgal-demo), the bunny, and two that are made at run time. `ratio`: the peer's distance from the removed
surface divided by ours (root mean square in both directions, geometric mean over the slabs). `default` has the loops' pairs given,
as MeshLib has; for
`untuned` nothing is given but the pieces. `best`: a blend; `cgal` is a bridge of two triangles, the hole
triangulated, refined and faired. `clean`: closed, and no new face meets another; `wrong_bridges`: between loops that do not belong
together; `under_15_share`: of the new triangles.""",
    "elbow": """## Joints between bent tubes

Two straight tubes of 48 and 40 segments whose axes continue each other along an arc of 60 to 120 degrees, with bend radii of 1.5 to
4 radii of the tube. `ratio`: the peer's distance from the torus divided by ours (root mean square, geometric mean over the bend
radii). `meshlib` is stitchHoles beside our strip, `meshlib-nicely` stitchHolesNicely beside our blend. `bend`: the largest angle
between neighbouring faces in degrees; `neck`: the least radius of a section of the joint, in radii of the tube.""",
    "fill": """## Holes

`truth`: discs cut out of the same closed meshes, along their own edges, 1, 2, 5, 10 and 20 % of their size wide. `ratio`: the
peer's distance from the removed surface divided by ours (root mean square in both directions, geometric mean over the discs).
Distances are at least a hundredth of the mean edge. `plain`: no new vertices, everybody's defaults; `fair`: refined and faired.
`clean`: closed, and no new
face meets another; `cuts`: pairs that do, of all discs. `rim-N`: a wavy rim of N vertices with one ring of faces, from arrays to
arrays; `unchecked`: without the search for cuts. `holes-81-in-8M`: two bunnies, every triangle cut into 64, with 81 holes.""",
    "repair": """## Repairs

Closed meshes of libcgal-demo and generated ones with seeded defects, 30 cases of each kind; `mixed` combines most kinds. `ratio`: the
peer's distance from the original divided by ours (root mean square in both directions, geometric mean over the cases that both make
valid; distances are at least 1e-7 of the diagonal). `valid`: CGAL finds the result closed, manifold, without intersections or degenerate
faces, and bounding a volume. `lost`: parts of the originals of which the result has less than half. `kept`: the share of faces farther
than three edges from a defect that are there bit for bit. `again`: results that a second repair does not change. MeshLib computes in single
precision, and so do the cases.""",
    "section": """## Sections of meshes

A bumpy torus of a million triangles, cut by 1 and by 100 parallel planes: ordered polylines with nesting, from arrays. CGAL's slicer starts
from its mesh and builds its tree; trimesh and VTK start from their meshes. VTK's cutter leaves segments unordered. `same_result`: equal
numbers of polylines, for CGAL also of points, for VTK of segments.""",
    "unite": """## Unions

1,000 pairs of random solids: balls, tori, boxes, cylinders and capsules, and a quarter of them a solid and its moved copy. Times are
medians, from arrays to arrays. `volume_difference`: the largest relative difference of the volumes of both unions.""",
    "align": """## Scans aligned

The ten views of the Stanford bunny at their published poses, each but the first disturbed by 3 degrees and 3 % of the size, 20 times.
`recovered`: the share of seeds in which every view is found again within 0.5 degrees and 0.5 % of the size of its published pose.
`meshlib` is MultiwayICP, point to plane, a sample each 2 mm; `trueform` aligns two clouds: each view to all before it.

`free-bunny`: each view rotated and moved at random, 100 times, without a start. `wrong`: the share of seeds with a trusted view that is not
at its place. `open3d` registers every two views by FPFH features and RANSAC, then by ICP; the pairs with the most inliers place the views.""",
    "trim": """## Scans joined

The ten views at their published poses; in metres, root mean square both ways between the result and the reference model, whose base
is open: holes wider than 2 cm are left. `closed`: all filled. `kept`: vertices that equal a vertex of a view bit for bit. The
peer's is a
fusion by voxels with as many faces, at sigma of 1.5 voxels.""",
    "join-memory": "## Memory of joins\n\nHow far memory rises above what is held before, in a process of its own.",
    "rows": """## Rows of new vertices

gusset from arrays to arrays, at its best a blend; `-5`: five rows, thin-plate fairing and intersections backed off; MeshLib's
stitchHolesNicely on a mesh with its holes found, subdivided to the mean edge and smoothed. `-mean-edge`: as many rows as the
mean edge asks for. `-unfair`: without fairing. `-area`: least-area meridians, without fairing.""",
    "outline": """## Outlines

Curves through the points of 249 closed plane outlines, 34,820 points, all in one call; ns for each point, one thread.
The outlines: sections like those of a foot, by formula; letters of the Debian package fonts-dejavu-core; random smooth ones. `sisl`
is s1356 with the first point again at the end, `occt` Perform() of a periodic Geom2dAPI_Interpolate, `scipy` make_interp_spline
(k = 3, periodic) with its parameters given: cubic splines all. `gusset-automatic` is the same with as many threads as the machine
has. `section` is the sections by themselves, `composite` and `composite-median` the default curve by the bisector and the median,
`self` the default with the parameters of its own triangles, `cubic` the C2 cubic spline, `blend` sections blended linearly.""",
    "outline-accuracy": """How far the outline is from the curve through 16 or 32 of its points: the farthest of 2048 points of the
outline, by the outline's size, the median over twenty outlines like sections of a foot, in thousandths. Ours is `composite`.
`formula`: generated; `data`: from files, where these are there.""",
    "net": """## Nets

A torus of 10^6 or 10^7 nodes in single precision, one thread. Half-edge meshes (OpenMesh, CGAL; C++) have each point once and quads;
VTK and PyVista (Python) take it as a structured grid. `bandwidth` scales as many numbers in place, `memcpy` copies them: the limits of
the hardware. `affine` moves all points; `normals` are normals of the nodes; VTK computes them on polygons of the grid that are made
before;
`concat` joins two nets of half the size (PyVista's must touch); `classes` names the nodes that are one point, for us from the
gluing, for VTK from their places; `memory` is bytes a node. `stream` is compression at 14 bits a coordinate: bits for each node
that is there, and times to encode and decode. Draco (DracoPy) takes the triangles of the grid, EDGEBREAKER, at the level of
7 and 10 that is smaller. The torus is rough as a scan is, or `-smooth`; the others are scans, where the folder of data is there.
`gusset-automatic` has as many threads as the machine.""",
    "carcass": """## Surfaces

Questions about smooth surfaces. The torus has radii 1 and 0.4, with 708 x 1413 nodes (`1e6`), 2236 x 4473 (`1e7`) or 101 x 101
(`1e4`); `wavy` is the open sheet z = 0.2 sin 5x cos 4y with 1000 x 1000. The peers CGAL, Embree and parry3d-f64 (the crate)
take two triangles for each cell of the same nodes; for `equal-accuracy` ours has 25 x 49 nodes and the peers the two million
triangles, with the same distance from the torus. All answer one question after the other in one thread: ours in one call,
`sorted` for all in Morton's order, else at random.

`build`: from the arrays that each takes to where it can be asked. `cgal` is the tree with its points, which closest points
need, `cgal-tree` without. `gusset-automatic` and `embree-automatic` have as many threads as the machine. `near`: queries within
0.02 of the surface, or a little more; `far`: in its box, doubled. `line`: all intersections of a line, for Embree by a filter
that lets every hit pass, for parry by a walk through its hierarchy; `ray`: the first. `plane`: an oblique plane; `cgal` is
Polygon_mesh_slicer, its tree made before, and `cgal-segments` all_intersections, which gives segments in no order; ours gives
points where the section crosses sides of cells, `gusset-chord`, and for equal accuracy ours at all, more of them, so that
chords are within 8e-7 of the surface. `memory`: bytes of the index for each node, beside nodes or triangles;
`memory-equal-accuracy`: in all, with them. `threads`: ours by as many threads as the machine has, beside one. Embree computes
in single precision.

`spline`: beside kernels of CAD, on a bicubic C2 spline through the same 51 x 101 nodes of the torus; `occt-exact` is the torus
itself as rational patches, `gusset-nodes` ours through the nodes themselves. SISL: s1954, s1856, s1851 with s1314, s1859 with
s1310. Open CASCADE: GeomAPI_ProjectPointOnSurf with the surface given before (`-anew`: with each point), IntCS and IntSS;
`occt` is Debian's from C++, `ocp` cadquery-ocp from Python, in a process of its own after the others. `ssi`: with the torus
moved by (0.7, 0.2, 0.1); for `ssi-exact` ours has 97 x 193 nodes, so as to be nearer the torus than Open CASCADE. Chords of
ours are within 1e-5 of the surfaces.""",
    "assemble": "## Assembly",
    "meridians": "## The paper's rule by index\n\nBeside its loops as printed, mended, and beside the bare closed form.",
}
CAPTION = """
Strips judged by CGAL and elementary geometry: pairs of intersecting triangles with a new face among them; every edge of the
strip with two faces; degrees; aspect = circumradius / (2 inradius), "-" for a degenerate triangle; dihedral = the bend at edges
of the strip.
"""


ACCURACIES = {
    "max_error": "largest error", "chord_error": "of chords", "wrong": "wrong", "queries": "of", "unproven": "unproven",
    "unproven_error": "their error", "hits": "hits", "curves": "curves",
    "points": "points", "closed": "closed", "ordered": "ordered",
    "unresolved": "unresolved"}
TRUTHS = {
    "cases": "slabs", "closed": "closed", "clean": "clean", "untuned_closed": "untuned closed", "untuned_clean": "untuned clean",
    "wrong_bridges": "wrong bridges", "min_angle_median": "least angle, median", "dihedral_p95_median": "dihedral p95, median",
    "under_15_share": "under 15 degrees"}
ACCURACY_CAPTION = """
Beside the formula of the surface. Closest points: the error of the distance; wrong: an error above 0.002; unproven: answers that
report no proof, which count in neither number. Lines: how far the hits are
from the surface; wrong: not as many hits as there are. Curves: how far their points are from the surface or from both surfaces, and
the same for the middles between points, where these are the answer.
"""


def line(cells):
    return "| " + " | ".join(str(cell).replace("|", "\\|") for cell in cells) + " |"


def table(head, rows):
    return "\n".join([line(head), line(["---"] * len(head)), *map(line, rows)]) + "\n"


def split(entry):
    module, name, peer = entry["id"].split("/")
    return module, name, peer


def times(entries):
    # Hosts in C++ and in Python come from two programs: a case's peers together.
    names = [split(e)[1] for e in entries]
    entries = sorted(entries, key=lambda e: names.index(split(e)[1]))
    return table(
        ["case", "peer", "ours", "peer", "ratio", ""],
        [[f"`{module}/{name}`", peer, f"{number(e['ours'])} {e['unit']}", f"{number(e['peer'])} {e['unit']}", number(e["ratio"]),
          e.get("failed", "")] for e in entries for module, name, peer in [split(e)]])


def shown(value):
    return ("yes" if value else "no") if isinstance(value, bool) else number(value) if isinstance(value, float) else value


def qualities(entries):
    """One row for each case and contender, ours first."""
    rows = {}
    for e in entries:
        _, name, peer = split(e)
        own, theirs = e["quality"], e["quality"].get("peer")
        for who, quality in (("gusset", own), (peer, theirs)):
            if quality and "faces" in quality:
                rows[name, who] = [f"`{name}`", who, *("-" if quality.get(q) is None else shown(quality[q]) for q in QUALITIES)]
    # Cases in their order, ours first in each.
    cases = list(dict.fromkeys(name for name, _ in rows))
    ordered = sorted(rows, key=lambda key: (cases.index(key[0]), not key[1].startswith("gusset")))
    return table(["case", "by", *QUALITIES.values()], [rows[key] for key in ordered]) + CAPTION if rows else ""


def accuracies(entries):
    """Errors beside the formula; one row for each case and contender, ours first."""
    rows = {}
    for e in entries:
        _, name, peer = split(e)
        for who, quality in (("gusset", e["quality"]), (peer, e["quality"].get("peer"))):
            if quality and "max_error" in quality:
                rows[name, who] = [f"`{name}`", who, *("-" if quality.get(q) is None else exact(quality[q]) for q in ACCURACIES)]
    cases = list(dict.fromkeys(name for name, _ in rows))
    ordered = sorted(rows, key=lambda key: (cases.index(key[0]), not key[1].startswith("gusset")))
    return table(["case", "by", *ACCURACIES.values()], [rows[key] for key in ordered]) + ACCURACY_CAPTION if rows else ""


ELBOWS = {"cases": "cases", "closed": "closed", "cuts": "cuts", "bend": "bend", "neck": "neck"}
FILLS = {
    "cases": "cases", "closed": "closed", "clean": "clean", "peer_clean": "peer clean", "cuts": "cuts", "peer_cuts": "peer cuts",
    "min_angle_median": "least angle, median",
}
REPAIRS = {"cases": "cases", "valid": "valid", "lost": "lost", "kept": "kept", "ms": "ms, median", "idempotent": "again"}
TRUTH_PICTURE = """![joints beside the surface that was there](truth.jpg)

New faces are orange. Our best joints: the median by relative distance, and the worst.
"""


def truths(entries):
    """Shares and medians over the slabs; one row for each contender."""
    rows = []
    for e in entries:
        _, name, peer = split(e)
        for who, quality in (("gusset", e["quality"]), (peer, e["quality"]["peer"])):
            rows.append([f"`{name}`", who, *("-" if quality.get(q) is None else shown(quality[q]) for q in TRUTHS)])
    return table(["case", "by", *TRUTHS.values()], rows)


def elbows(entries):
    """The worst over the bend radii; one row for each contender."""
    rows = []
    for e in entries:
        _, name, peer = split(e)
        for who, quality in (("gusset", e["quality"]), (peer, e["quality"]["peer"])):
            rows.append([f"`{name}`", f"{who} beside {peer}" if who == "gusset" else who,
                         *("-" if quality.get(q) is None else shown(quality[q]) for q in ELBOWS)])
    return table(["case", "by", *ELBOWS.values()], rows)


def fills(entries):
    """Shares and counts over the discs."""
    rows = [[f"`{split(e)[1]}`", split(e)[2], *(shown(e["quality"][q]) for q in FILLS)] for e in entries if "cases" in e["quality"]]
    return table(["case", "peer", *FILLS.values()], rows)


def repairs(entries):
    """Sums and means over the cases of a kind; ours once for each kind."""
    rows = {}
    for e in entries:
        _, name, peer = split(e)
        for who, quality in (("gusset", e["quality"]), (peer, e["quality"]["peer"])):
            rows[name, who] = [f"`{name}`", who, *("-" if quality.get(q) is None else shown(quality[q]) for q in REPAIRS)]
    return table(["case", "by", *REPAIRS.values()], list(rows.values()))


def exact(value):
    return f"{value:.2g}" if isinstance(value, float) else shown(value)


def versions():
    said = []
    for package, name in ("meshlib", "MeshLib"), ("vtk", "VTK"), ("bpy", "Blender"), ("scipy", "SciPy"), ("pyvista", "PyVista"), ("DracoPy", "DracoPy"), \
            ("pymeshfix", "pymeshfix"), ("pymeshlab", "PyMeshLab"), ("manifold3d", "manifold3d"), ("trimesh", "trimesh"):
        try:
            said.append(f"{name} {version(package)}")
        except PackageNotFoundError:
            said.append(f"{name} not installed")
    debian = {"libopenmesh-dev": "OpenMesh", "libcgal-dev": "CGAL", "libsisl-dev": "SISL", "libocct-modeling-algorithms-dev": "Open CASCADE",
              "libembree-dev": "Embree"}
    for package, name in debian.items():
        found = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], capture_output=True, text=True).stdout
        said.append(f"{name} {found} (Debian)")
    said.append(f"parry3d-f64 {PARRY.search(Path('bench/parry/Cargo.toml').read_text())[1]}")
    for venv in "ocp-7.8.1", "ocp-newest":
        found = next(Path("build").glob(f"bench-{venv}/lib/python*/site-packages/cadquery_ocp-*.dist-info"), None)
        said.append(f"{venv}: " + (f"cadquery-ocp {found.stem.split('-')[1]}" if found else "not installed"))
    return ", ".join(said)


def machine():
    with open("/proc/cpuinfo") as file:
        lines = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    with open("/proc/meminfo") as file:
        kibibytes = int(file.readline().split()[1])
    return dict(cpu=lines[0], cores=len(lines), memory=f"{kibibytes / 2**20:.0f} GiB")


def write_page(entries, folder, gusset):
    folder.mkdir(exist_ok=True)
    write_plot(entries, folder / "benchmarks.svg")
    parts = [HEAD.format(date=time.strftime("%Y-%m-%d"), gusset=gusset, peers=versions(), **machine())]
    for module, text in SECTIONS.items():
        mine = [e for e in entries if split(e)[0] == module]
        if mine:
            parts += [text + "\n" if text else "", times(mine)]
        if mine and module in ("join-strip", "rows", "assemble"):
            judged = [e for e in entries if split(e)[0] in (module, module.removesuffix("-strip"))]
            parts.append(qualities(judged))
        if mine and module == "truth":
            parts += [truths(mine), TRUTH_PICTURE]
        if mine and module == "elbow":
            parts.append(elbows(mine))
        if mine and module == "repair":
            parts.append(repairs(mine))
        if mine and module == "fill":
            parts.append(fills(mine))
        if module == "carcass":
            parts.append(accuracies(mine))
    (folder / "benchmarks.md").write_text("\n".join(part for part in parts if part))
