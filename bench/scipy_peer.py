"""SciPy: the periodic cubic spline through the points of each outline, in the centripetal parameter."""

import numpy as np

from peers import Peer

interpolate = Peer("scipy.interpolate", after="scipy")


def build(outlines):
    """The points with the first one again at the end, and their parameters."""
    interpolate.make_interp_spline
    built = []
    for points in outlines:
        closed = np.concatenate([points, points[:1]])
        steps = np.sqrt(np.linalg.norm(np.diff(closed, axis=0), axis=1))
        built.append((np.concatenate([[0], np.cumsum(steps)]), closed))
    return built


def splines(built):
    make = interpolate.make_interp_spline
    return [make(knots, closed, k=3, bc_type="periodic") for knots, closed in built]


def sampled(built, found, fine):
    """Each spline as a polygon."""
    return [spline(np.linspace(0, knots[-1], fine * (len(knots) - 1), endpoint=False))
            for (knots, _), spline in zip(built, found)]
