"""Open3D: global registration of two clouds by features, and views placed by the registrations with the most inliers."""

import itertools

import numpy as np

from peers import Peer

o3d = Peer("open3d")

# Radii as in Open3D's tutorial on global registration, in voxels.
NORMAL_RADIUS, FEATURE_RADIUS, INLIER_DISTANCE, FINE_DISTANCE = 2.0, 5.0, 1.5, 0.4
CHECKS, CONFIDENCE = 100_000, 0.999
VOXELS_PER_SIZE = 50


def prepared(view, voxel):
    """The cloud with normals of the mesh, and the features of its coarse copy."""
    reg = o3d.pipelines.registration
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(view.points))
    cloud.normals = o3d.utility.Vector3dVector(view.normals)
    coarse = cloud.voxel_down_sample(voxel)
    around = o3d.geometry.KDTreeSearchParamHybrid(radius=FEATURE_RADIUS * voxel, max_nn=100)
    return cloud, coarse, reg.compute_fpfh_feature(coarse, around)


def registered(moved, fixed, voxel):
    """The pose of one cloud on another, and the number of points that lie there."""
    reg = o3d.pipelines.registration
    limit = INLIER_DISTANCE * voxel
    checks = [reg.CorrespondenceCheckerBasedOnEdgeLength(0.9), reg.CorrespondenceCheckerBasedOnDistance(limit)]
    found = reg.registration_ransac_based_on_feature_matching(
        moved[1], fixed[1], moved[2], fixed[2], True, limit, reg.TransformationEstimationPointToPoint(False), 3, checks,
        reg.RANSACConvergenceCriteria(CHECKS, CONFIDENCE))
    fine = reg.registration_icp(
        moved[1], fixed[0], FINE_DISTANCE * voxel, found.transformation, reg.TransformationEstimationPointToPlane())
    return np.asarray(fine.transformation), fine.fitness * len(moved[1].points)


def refined(pose, moved, fixed, voxel):
    """The pose improved by all points."""
    reg = o3d.pipelines.registration
    fine = reg.registration_icp(moved[0], fixed[0], FINE_DISTANCE * voxel, pose, reg.TransformationEstimationPointToPlane())
    return np.asarray(fine.transformation)


def aligned_freely(views):
    """The poses of the views on the first; the registrations with the most inliers place them."""
    o3d.utility.random.seed(1)
    voxel = max(np.linalg.norm(np.ptp(view.points, axis=0)) for view in views) / VOXELS_PER_SIZE
    clouds = [prepared(view, voxel) for view in views]
    found = {}
    for i, k in itertools.combinations(range(len(views)), 2):
        pose, count = registered(clouds[k], clouds[i], voxel)
        found[i, k], found[k, i] = (count, pose), (count, np.linalg.inv(pose))
    poses = {0: np.eye(4)}
    while len(poses) < len(views):
        open_pairs = ((i, k) for i, k in found if i in poses and k not in poses)
        i, k = max(open_pairs, key=lambda pair: found[pair][0])
        poses[k] = poses[i] @ refined(found[i, k][1], clouds[k], clouds[i], voxel)
    return [poses[k] for k in range(len(views))]
