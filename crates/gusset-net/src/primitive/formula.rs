//! Formulas of shapes that are not swept profiles. O(1) a node.

use super::unit_circle::point_on_unit_circle;
use crate::closure::Cuboid;

/// From -1 at the first of `count` to 1 at the last, symmetric bit for bit.
pub(super) fn symmetric_parameter(k: usize, count: usize) -> f64 {
    (2.0 * k as f64 - (count - 1) as f64) / (count - 1) as f64
}

/// Returns the map from the square -1..1 to the unit disc that takes concentric squares to circles.
fn square_to_disc([u, v]: [f64; 2]) -> [f64; 2] {
    let (ring, length) = (u.abs().max(v.abs()), (u * u + v * v).sqrt());
    if ring == 0.0 { [0.0, 0.0] } else { [u / length * ring, v / length * ring] }
}

/// Returns the map from the square to the unit sphere that takes its centre to the top, concentric
/// squares to parallels and its rim to the bottom.
pub(super) fn square_to_sphere([u, v]: [f64; 2]) -> [f64; 3] {
    let (ring, length) = (u.abs().max(v.abs()), (u * u + v * v).sqrt());
    match ring {
        0.0 => [0.0, 0.0, 1.0],
        1.0 => [0.0, 0.0, -1.0],
        _ => {
            let (s, c) = (libm::sin(std::f64::consts::PI * ring), libm::cos(std::f64::consts::PI * ring));
            [s * (u / length), s * (v / length), c]
        }
    }
}

/// Returns the point of node (i, j) on a box.
pub(super) fn point_on_box(cuboid: &Cuboid, size: [f64; 3], i: usize, j: usize) -> [f64; 3] {
    let place = cuboid.lattice_point(i, j);
    [0, 1, 2].map(|x| f64::from(place[x]) * size[x] / f64::from(cuboid.cells[x]) - size[x] / 2.0)
}

/// Returns a point of the square over a rectangle, highest in the middle and 0 at its rim.
pub(super) fn point_on_bulge(size: [f64; 2], thickness: f64, [u, v]: [f64; 2]) -> [f64; 3] {
    [size[0] / 2.0 * u, size[1] / 2.0 * v, thickness / 2.0 * ((1.0 - u * u) * (1.0 - v * v))]
}

/// Returns the point at `from_middle` on a line through the circle of `radius` at `k` n-ths of a
/// turn, which rotates half as fast.
pub(super) fn moebius_strip_point(radius: f64, from_middle: f64, k: usize, n: usize) -> [f64; 3] {
    let ([c, s], [half_c, half_s]) = (point_on_unit_circle(k, n), point_on_unit_circle(k, 2 * n));
    let distance = radius + from_middle * half_c;
    [distance * c, distance * s, from_middle * half_s]
}

/// Returns the figure eight (sin v, sin 2v) at `section` n-ths of a turn, swept as the line of
/// [`moebius_strip_point`].
pub(super) fn figure_eight_bottle_point(
    radius: f64,
    minor_radius: f64,
    section: [usize; 2],
    around: [usize; 2],
) -> [f64; 3] {
    let [[c, s], [half_c, half_s]] =
        [point_on_unit_circle(around[0], around[1]), point_on_unit_circle(around[0], 2 * around[1])];
    let (p, q) = (point_on_unit_circle(section[0], section[1])[1], point_on_unit_circle(2 * section[0], section[1])[1]);
    let distance = radius + minor_radius * (half_c * p - half_s * q);
    [distance * c, distance * s, minor_radius * (half_s * p + half_c * q)]
}

/// Boy's surface in the parametrisation of Kusner and Bryant. With w in the unit disc and d = w^6 +
/// sqrt(5) w^3 - 1,
///
/// g = (-3/2 Im(w (1 - w^4) / d), -3/2 Re(w (1 + w^4) / d), Im((1 + w^6) / d) - 1/2),
///
/// and the point is g / |g|^2. All terms are multiplied by |d|^2, which may be nearly 0.
pub(super) fn boy_surface_point(square: [f64; 2]) -> [f64; 3] {
    let w = square_to_disc(square);
    let times = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a * c - b * d, a * d + b * c];
    let w2 = times(w, w);
    let (w3, w4) = (times(w2, w), times(w2, w2));
    let w6 = times(w3, w3);
    let root = 5f64.sqrt();
    let d = [w6[0] + root * w3[0] - 1.0, w6[1] + root * w3[1]];
    let conjugate = [d[0], -d[1]];
    let minus = times(times(w, [1.0 - w4[0], -w4[1]]), conjugate);
    let plus = times(times(w, [1.0 + w4[0], w4[1]]), conjugate);
    let six = times([1.0 + w6[0], w6[1]], conjugate);
    let norm = d[0] * d[0] + d[1] * d[1];
    let g = [-1.5 * minus[1], -1.5 * plus[0], six[1] - norm / 2.0];
    let length = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    if length == 0.0 { [0.0; 3] } else { g.map(|x| x * norm / length) }
}
