//! Sweeps of a profile round the z axis, along a circle or a polygon. O(nodes).

use super::coordinates;
use super::profile::Point;
use crate::error::Result;
use crate::job::Job;
use crate::mesh::Scalar;
use crate::net::topology::{Links, Matrix};
use crate::net::{Net, Shape, Sides, Topology};

/// Row i is point i of the profile, column j in the direction of point j of the section.
pub(super) fn net(
    shape: Shape,
    profile: &[Point],
    section: &[Point],
    scalar: Scalar,
    job: &Job<'_>,
) -> Result<Net<'static>> {
    coordinates::rows(topology(shape, profile)?, scalar, job, |i, [x, y, z]| {
        let [distance, height] = profile[i];
        for ((x, y), &[u, v]) in x.iter_mut().zip(y).zip(section) {
            (*x, *y) = (distance * u, distance * v);
        }
        z.fill(height);
    })
}

/// Rows are closed, those on the axis contracted, and columns closed if the profile is. A closed
/// surface is oriented so that its volume is positive.
fn topology(shape: Shape, profile: &[Point]) -> Result<Topology> {
    let last = profile.len() - 1;
    let ring = last >= 3 && profile[0] == profile[last];
    let on_axis = |i: usize| profile[i][0] == 0.0;
    let sides = Sides { columns_closed: ring, pole_top: on_axis(0), pole_bottom: on_axis(last), ..Sides::TUBE };
    let topology = if (1..last).any(on_axis) {
        let mut matrix = Matrix::of_sides(shape, sides)?;
        for i in (1..last).filter(|&i| on_axis(i)) {
            (0..shape.columns() - 1).for_each(|j| matrix.set(shape.horizontal_link(i, j), true));
        }
        // A contracted row reduces its cells to triangles, or wires between two such rows: none is
        // crossed.
        Topology::assembled(shape, Links::Matrix(matrix), Vec::new(), false)
    } else {
        Topology::of_sides(shape, sides)
    };
    let closed = ring || (on_axis(0) && on_axis(last));
    Ok(topology.with_reversed(closed && volume(profile) < 0.0))
}

/// The volume that the profile encloses, up to a positive factor: truncated cones, signed by their
/// heights.
fn volume(profile: &[Point]) -> f64 {
    // Scaled, so that products stay in range.
    let scale = profile.iter().flatten().fold(f64::MIN_POSITIVE, |max, value| max.max(value.abs()));
    let cone = |ends: &[Point]| {
        let [[a, low], [b, high]] = [ends[0], ends[1]].map(|point| point.map(|value| value / scale));
        (a * a + a * b + b * b) * (high - low)
    };
    profile.windows(2).map(cone).sum()
}
