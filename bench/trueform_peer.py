"""trueform: registration of two clouds of points."""

import numpy as np

from peers import Peer

tf = Peer("trueform")


def cloud(points, normals, pose):
    built = tf.PointCloud(np.ascontiguousarray(points, dtype=np.float64))
    built.transformation = np.ascontiguousarray(pose)
    return built, np.ascontiguousarray(normals)


def aligned(views, poses):
    """View after view, each to all before it at once, as it aligns two clouds; the first stays."""
    found = [poses[0]]
    for k in range(1, len(views)):
        moved = [views[j].points @ found[j][:3, :3].T + found[j][:3, 3] for j in range(k)]
        turned = [views[j].normals @ found[j][:3, :3].T for j in range(k)]
        target = cloud(np.concatenate(moved), np.concatenate(turned), np.eye(4))
        pose = poses[k]
        # Far points first count, then the nearest half alone.
        for outliers in 0.3, 0.5:
            source, _ = cloud(views[k].points, views[k].normals, pose)
            step = tf.fit_icp_alignment(source, target, max_iterations=100, n_samples=5000, outlier_proportion=outliers)
            pose = np.asarray(step) @ pose
        found.append(pose)
    return found
