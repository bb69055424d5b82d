"""The page docs/guides/python.md as a program: pieces.py [FOLDER for pictures]"""

import sys

#! [setup]
import numpy as np
import pyvista as pv

import gusset_mesh as gm
#! [setup]

PICTURES = sys.argv[1] if len(sys.argv) > 1 else None


def picture(name, meshes, zoom=1.35, **how):
    """Draws meshes side by side, off screen."""
    if PICTURES is None:
        return
    plotter = pv.Plotter(off_screen=True, shape=(1, len(meshes)), window_size=(480 * len(meshes), 420), border=False)
    for k, (title, mesh, more) in enumerate(meshes):
        plotter.subplot(0, k)
        plotter.set_background("#fbfaf7")
        for one in mesh if isinstance(mesh, list) else [mesh]:
            plotter.add_mesh(one, **{"smooth_shading": False, "show_scalar_bar": False, "specular": 0.2, **how, **more})
        plotter.add_text(title, font_size=11, color="#333333", position="lower_edge")
        plotter.view_vector((1, -1.6, 0.9))
        plotter.camera.zoom(zoom)
    plotter.screenshot(f"{PICTURES}/{name}.jpg")


#! [pieces]
def quarter(number):
    """A quarter of a bumpy ball, open on all sides, with a number and a height to carry along."""
    polar, angle = np.meshgrid(np.linspace(0.3, np.pi - 0.3, 30), np.linspace(0.05, np.pi / 2 - 0.05, 20) + number * np.pi / 2)
    radius = 1 + 0.12 * np.sin(3 * polar) * np.cos(4 * angle)
    x, y, z = radius * np.sin(polar) * np.cos(angle), radius * np.sin(polar) * np.sin(angle), radius * np.cos(polar)
    piece = pv.StructuredGrid(x, y, z).extract_surface(algorithm="dataset_surface", pass_pointid=False, pass_cellid=False)
    piece.point_data["height"] = piece.points[:, 2]
    piece.cell_data["piece"] = np.full(piece.n_cells, number)
    return piece


pieces = [quarter(number) for number in range(4)]
#! [pieces]

#! [assemble]
whole = pieces[0].gusset.join(*pieces[1:], fill=True)
print(f"{whole.n_cells} faces, closed: {whole.is_manifold}, volume {whole.volume:.3f}")
print("carried along:", whole.point_data.keys(), whole.cell_data.keys())
#! [assemble]
picture("python_pieces", [("four pieces", pieces, {"scalars": "piece", "clim": (0, 3), "cmap": "tab10", "show_edges": True}),
                          ("assembled", whole, {"scalars": "piece", "clim": (0, 3), "cmap": "tab10", "show_edges": True}),
                          ("their heights, carried over", whole, {"scalars": "height", "cmap": "viridis"})])

#! [report]
made = gm.join(pieces, fill=True)
for joint in made.joints:
    print(f"{joint.face_count} faces across a gap of {joint.gap:.3f}")
print(f"{(made.report.holes.status == 'filled').sum()} holes filled, {made.report.loops_left} loops left")
#! [report]

#! [filters]
hills = pv.ParametricRandomHills(random_seed=4, u_res=60, v_res=60).triangulate()
middles, top = hills.cell_centers().points, hills.points[hills.points[:, 2].argmax()]
torn = hills.extract_cells(np.flatnonzero(np.linalg.norm(middles - top, axis=1) > 3)).extract_surface(algorithm="dataset_surface")
plain = torn.gusset.fill()  # the outer border of a sheet is not a hole
fair = torn.gusset.fill(finish="blend")
print(gm.filters.fill(torn, plan_only=True)[1].splitlines()[0])
#! [filters]
for filled in (plain, fair):
    filled.cell_data["new"] = np.arange(filled.n_cells) >= torn.n_cells
picture("python_holes", [("a summit is missing", torn, {"color": "#7d9bb5"}),
                         ("least weight", plain, {"scalars": "new", "cmap": ["#7d9bb5", "#d99a1c"]}),
                         ("refined and fair", fair, {"scalars": "new", "cmap": ["#7d9bb5", "#d99a1c"]})], zoom=1.15)

#! [errors]
points = np.array(whole.points)
points[17] = np.nan
try:
    gm.check((points, [[16, 17, 18]]))
except gm.InputError as error:
    print(error.name, error.element, error.index)
#! [errors]
