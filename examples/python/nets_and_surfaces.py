"""The sections of docs/guides/python.md on nets, curves and surfaces as a program."""

import numpy as np

import gusset_mesh as gm

#! [fields]
strip = gm.Net.primitive(shape="plane", size=(1, 2 * np.pi, 0), rows=65, columns=9)
ring = strip.deform(gm.fields.wrap_cylinder("x", 1.0)).glue(detect=1e-9)
twisted = ring.deform(gm.fields.twist("x", rate=0.5), gm.fields.taper("x", rate=-0.3))
print("a ring with", len(ring.complex().report.boundary_offsets) - 1, "borders, twisted to an area of", round(twisted.measure().area, 3))
#! [fields]

#! [gluing]
sheet = gm.Net.primitive(shape="plane", size=(4, 1, 0), rows=5, columns=33)
band = sheet.set_gluing(seams=[gm.seam((0, 0), (1, 0), (4, 32), (-1, 0), 5)])
print("a Moebius band:", not band.complex().is_orientable, "with", len(band.groups()), "points of two nodes")
#! [gluing]

#! [bridges]
tube = gm.Net.primitive(shape="tube", radius=1, height=0.1, rows=2, columns=65)
film = gm.Net.concatenate([tube, tube.translate([0, 0, 1])], direction="down", rows=31).set_bridge(0, tension=1)
at_rest, report = film.settle()
print("a catenoid:", report.converged, "with a neck of", np.hypot(*at_rest.nodes[17, :, :2].T).min().round(2))
#! [bridges]

#! [resolutions]
hills = gm.Net.from_heights(np.sin(np.linspace(0, 6, 200))[:, None] * np.cos(np.linspace(0, 4, 150)))
coarse = hills.decimate(0.05)
flat, report = coarse.net.planarise()
print(coarse.net.shape, "deviate by", round(coarse.deviation, 3), "planar:", report.converged)
#! [resolutions]

#! [scenes]
scene = gm.Scene()
wheel = scene.add(gm.Net.primitive(shape="torus", radius=1, minor_radius=0.2))
axle = scene.add_group()
for side in (-1, 1):
    place = scene.add_group()
    scene.set_entry(place, transform=[[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, side]])
    scene.add_child(place, wheel)
    scene.add_child(axle, place)
print(scene.report.net_instances, "wheels in one net of", scene.flatten().shape)
data = hills.encode(bits=12)
print(len(data), "bytes for", hills.nodes.nbytes, "of", gm.Net.decode(data).shape)
#! [scenes]

#! [curves]
curve = gm.Curve.from_controls([[0, 0], [3, 2], [-2, 2], [1, 0]])
middle = curve.places_at([curve.length / 2])
print("crosses itself at", curve.intersect().points[0].round(3), "middle", curve.evaluate(middle).derivatives[0, 0].round(3))
#! [curves]

#! [frames]
angle = np.linspace(0, 2 * np.pi, 24, endpoint=False)
sections = [np.stack([r * np.cos(angle), 0.6 * r * np.sin(angle), 0 * angle + z], axis=1) for z, r in enumerate([0.8, 1, 1.1, 0.9])]
frame = gm.Frame(sections, closed=True)
hull = gm.Sheet.from_frame(frame)
print("a rib of", round(frame.curve_along(0).length, 3), "and a girth of", round(frame.slice([0, 0, 1.5], [0, 0, 1]).curve.length, 3))
#! [frames]

#! [surfaces]
surface = gm.Surface(hull)
nearest = surface.distance(gm.Line([2, 0, 0], [0, 0, 1]))
print("the line is", round(nearest.distance, 3), "away,", len(surface.region([1, 0, 1], 0.3)), "cells are near")
inner, deviation = hull.offset(-0.1)
print(f"an offset with a deviation of {deviation:.4f}")
#! [surfaces]

#! [strips]
strip = gm.strip(sections[0], sections[1], closed=True, rows="count", row_count=2)
edges = gm.winged(strip.mesh).edges
print(len(edges), "edges,", (edges.left == 2**32 - 1).sum() + (edges.right == 2**32 - 1).sum(), "of them at the border")
#! [strips]
