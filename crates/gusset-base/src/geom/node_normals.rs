//! Normals of a surface at a grid of nodes.
//!
//! The tangent of a row or column at a node is the tangent of the circle through the node and its
//! two neighbours. The normal is perpendicular to the tangents of the row and the column. It is
//! exact on planes and spheres for any distribution of nodes, because three points of a sphere lie
//! on a circle of the sphere. It is also exact on cylinders whose rulings are rows or columns.

use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use glam::DVec3;

/// Computes the unit normals of nodes, row by row: the derivative across the rows times the
/// derivative across the columns. `closed` tells whether the first row follows the last, and
/// whether the first column follows the last. A normal is zero where the nodes do not determine it.
/// A row or column that is a single point is a pole; its normal is perpendicular to all lines that
/// end there. O(nodes), unless long runs of nodes coincide.
///
/// # Errors
/// [`Error::OutOfMemory`](crate::Error::OutOfMemory), [`Error::Cancelled`](crate::Error::Cancelled).
pub fn node_normals(
    nodes: &[DVec3],
    [rows, columns]: [usize; 2],
    closed: [bool; 2],
    job: &Job<'_>,
    stage: &'static str,
) -> Result<Vec<DVec3>> {
    let at = |i: usize, j: usize| nodes[i * columns + j];
    let along = |i: usize, j: usize| tangent_of_circle_at_point(rows, closed[0], i, |i| at(i, j));
    let across = |i: usize, j: usize| tangent_of_circle_at_point(columns, closed[1], j, |j| at(i, j));
    let normals = (0..rows * columns).map(|k| {
        let (i, j) = (k / columns, k % columns);
        along(i, j).cross(across(i, j)).normalize_or_zero()
    });
    let mut normals = alloc::collect_cancellable(normals, job, stage)?;
    job.step(1.0, stage)?;
    for (i, sign) in [(0, 1.0), (rows - 1, -1.0)] {
        if !closed[0] && (1..columns).all(|j| at(i, j) == at(i, 0)) {
            let normal = sign * turning_axis(columns, closed[1], |j| along(i, j));
            normals[i * columns..(i + 1) * columns].fill(normal);
        }
    }
    for (j, sign) in [(0, -1.0), (columns - 1, 1.0)] {
        if !closed[1] && (1..rows).all(|i| at(i, j) == at(0, j)) {
            let normal = sign * turning_axis(rows, closed[0], |i| across(i, j));
            (0..rows).for_each(|i| normals[i * columns + j] = normal);
        }
    }
    Ok(normals)
}

/// Returns the tangent direction, at point `k`, of the circle through the point and its nearest
/// distinct neighbours on either side. At an end of an open line the circle passes through the next
/// two points.
pub fn tangent_of_circle_at_point(count: usize, closed: bool, k: usize, at: impl Fn(usize) -> DVec3) -> DVec3 {
    let p = at(k);
    // The distinct points on one side, the nearest first, inverted about p. Inversion maps the
    // circle to a line along the tangent.
    let side = |step: usize, end: usize| {
        let places = (1..=end).map(move |m| (k + m * step) % count);
        places.map(&at).map(|q| q - p).filter(|d| *d != DVec3::ZERO).map(|d| d / d.length_squared())
    };
    let last = if closed { count - 1 } else { count - 1 - k };
    let first = if closed { count - 1 } else { k };
    let (mut ahead, mut behind) = (side(1, last), side(count - 1, first));
    let direction = match (ahead.next(), behind.next()) {
        (Some(next), Some(before)) => next - before,
        (Some(next), None) => ahead.find(|far| *far != next).map_or(next, |far| next - far),
        (None, Some(before)) => behind.find(|far| *far != before).map_or(-before, |far| far - before),
        (None, None) => DVec3::ZERO,
    };
    direction.normalize_or_zero()
}

/// Returns the axis about which successive vectors turn.
fn turning_axis(count: usize, closed: bool, direction: impl Fn(usize) -> DVec3) -> DVec3 {
    let end = if closed { count } else { count - 1 };
    (0..end).map(|k| direction(k).cross(direction((k + 1) % count))).sum::<DVec3>().normalize_or_zero()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_of_spheres_are_exact() {
        let (rows, columns) = (9, 14);
        for closed in [false, true] {
            let round = |j: usize| if closed { j as f64 / columns as f64 } else { 0.7 * (j as f64 / 13.0).powi(2) };
            let nodes: Vec<DVec3> = (0..rows * columns)
                .map(|k| {
                    let a = std::f64::consts::PI * (k / columns) as f64 / 8.0;
                    let b = std::f64::consts::TAU * round(k % columns);
                    let radius = if k / columns % 8 == 0 { 0.0 } else { a.sin() };
                    DVec3::new(radius * b.cos(), radius * b.sin(), a.cos())
                })
                .collect();
            let normals = node_normals(&nodes, [rows, columns], [false, closed], &Job::default(), "").unwrap();
            for (n, p) in normals.iter().zip(&nodes) {
                assert!((*n - *p).length() < 1e-12, "{n} {p}");
            }
            // Transposed nodes face inwards.
            let turned: Vec<DVec3> = (0..rows * columns).map(|k| nodes[(k % rows) * columns + k / rows]).collect();
            let normals = node_normals(&turned, [columns, rows], [closed, false], &Job::default(), "").unwrap();
            for (n, p) in normals.iter().zip(&turned) {
                assert!((*n + *p).length() < 1e-12, "{n} {p}");
            }
        }
    }
}
