"""Draws two slabs of `truth.py`: the joint with the median distance from the removed surface, and the joint with the largest."""

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt  # noqa: E402  (the back end comes first)
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

OLD, NEW = np.array([0.80, 0.82, 0.86]), np.array([0.93, 0.60, 0.25])
AMBIENT = 0.35
# The visible part of the pieces around the removed surface, in sizes of the latter.
MARGIN = 0.25


def chosen(cases, sizes, who):
    """The names of the median and of the worst case, by the distance as part of the gap's size."""
    order = sorted((case[who]["rms"] / sizes[name], name) for name, case in cases.items() if case[who]["closed"])
    return {"median": order[len(order) // 2][1], "worst": order[-1][1]}


def frame(points):
    """The widest, the second and the least extent: across, away and up."""
    centred = points - points.mean(axis=0)
    axes = np.linalg.svd(centred.T @ centred)[0].T
    return axes if np.linalg.det(axes) > 0 else axes * [[1], [1], [-1]]


def draw(axes, truth, points, faces, first, title):
    turn = frame(truth.points)
    low, high = (truth.points @ turn.T).min(axis=0), (truth.points @ turn.T).max(axis=0)
    margin = MARGIN * (high - low).max()
    corners = (points @ turn.T)[faces]
    shown = ((corners.mean(axis=1) > low - margin) & (corners.mean(axis=1) < high + margin)).all(axis=1)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
    light = AMBIENT + (1 - AMBIENT) * np.abs(normals @ np.array([0.35, -0.8, 0.49]))
    colours = np.where((np.arange(len(faces)) >= first)[:, None], NEW, OLD) * np.minimum(light, 1)[:, None]
    edges = np.where((np.arange(len(faces)) >= first)[:, None], colours * 0.55, colours * 0.9)
    axes.add_collection3d(Poly3DCollection(corners[shown], facecolors=colours[shown], edgecolors=edges[shown], linewidths=0.3))
    low, high = low - margin, high + margin
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    axes.set_box_aspect(high - low, zoom=1.75)
    # The gap runs across the picture.
    axes.view_init(elev=25, azim=-75)
    axes.set_axis_off()
    axes.set_title(title, fontsize=10)


def write(rows, path):
    """`rows`: for each case its title, the removed surface, and by contender the points, the faces and the first new face."""
    columns = max(len(row[2]) for row in rows)
    figure = plt.figure(figsize=(3.6 * columns, 2.7 * len(rows)))
    for i, (title, truth, joints) in enumerate(rows):
        for j, (who, (points, faces, first)) in enumerate(joints.items()):
            axes = figure.add_subplot(len(rows), columns, i * columns + j + 1, projection="3d", proj_type="ortho")
            draw(axes, truth, points, faces, first, f"{title}: {who}")
    figure.subplots_adjust(0, 0, 1, 0.96, 0.02, 0.06)
    figure.savefig(path, dpi=110, pil_kwargs={"quality": 85, "optimize": True})
    plt.close(figure)
