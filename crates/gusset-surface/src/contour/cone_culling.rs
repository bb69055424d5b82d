//! Finds the blocks whose normals may make given angles with a direction, in one descent through
//! the cones of normals.
//!
//! Invariant: the cone of a block contains the normals of all its cells, so no cell with the angle
//! is discarded. Cost: O(blocks visited).

use super::contour_source::levels_between;
use crate::index::ConePyramid;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use std::f64::consts::PI;

/// Tolerance of an angle within which rounding may still produce a curve, in radians. The zero set
/// of an angle is computed from a function whose slope across it is sin 2 alpha.
const ANGLE_SLACK_RADIANS: f64 = 1e-9;
/// Slopes below this count as zero.
const MIN_NONZERO_SLOPE: f64 = 1e-8;

/// The interval of the tolerance around an angle.
fn angle_tolerance_interval(angle: f64) -> [f64; 2] {
    let slope = libm::sin(2.0 * angle).abs();
    let slack = if slope > MIN_NONZERO_SLOPE { ANGLE_SLACK_RADIANS / slope } else { ANGLE_SLACK_RADIANS };
    [angle - slack, angle + slack]
}

/// True if normals at angles between `low` and `high` may have one of the given angles, which are
/// sorted.
pub(super) fn may_have_angle(angles: &[f64], unsigned: bool, [low, high]: [f64; 2]) -> bool {
    let near = |[low, high]: [f64; 2]| {
        let meets = |&angle: &f64| {
            let [from, to] = angle_tolerance_interval(angle);
            low <= to && from <= high
        };
        // With many angles, most of them need not be tested.
        !levels_between(angles, [low, high], 0.0).is_empty()
            || angles[levels_between(angles, [low, high], ANGLE_SLACK_RADIANS / MIN_NONZERO_SLOPE)].iter().any(meets)
    };
    near([low, high]) || (unsigned && near([PI - high, PI - low]))
}

/// The blocks, row by row, for which `wanted` accepts the smallest and largest angle of the normals
/// with a direction. If `wanted` accepts a range, it must accept every larger one.
pub(super) fn select_blocks_by_cones(
    cones: &ConePyramid,
    direction: DVec3,
    wanted: impl Fn([f64; 2]) -> bool,
) -> Result<Vec<[u32; 2]>> {
    let mut wanted_blocks = Vec::new();
    let mut waiting: Vec<[usize; 3]> = Vec::new();
    let last = cones.level_count() - 1;
    (0..4).for_each(|k| waiting.push([last, k / 2, k % 2]));
    while let Some([level, r, c]) = waiting.pop() {
        let Some(cone) = cones.cone_of_block(level, r, c) else { continue };
        if !wanted(cone.angle_range_to(direction)) {
            continue;
        }
        if level == 0 {
            alloc::push(&mut wanted_blocks, [r as u32, c as u32])?;
            continue;
        }
        (0..4).for_each(|k| waiting.push([level - 1, 2 * r + k / 2, 2 * c + k % 2]));
    }
    wanted_blocks.sort_unstable();
    Ok(wanted_blocks)
}

#[cfg(test)]
mod tests {
    use super::super::PointSpacing;
    use crate::{Grid, Nodes, Patches, Scheme, Sheet, Surface};
    use glam::DVec3;
    use gusset_base::Job;
    use gusset_base::testing::case_count;
    use std::f64::consts::{FRAC_PI_2, PI, TAU};

    fn random_point(random: &mut fastrand::Rng, size: f64) -> DVec3 {
        size * DVec3::from_array([0; 3].map(|_| 2.0 * random.f64() - 1.0))
    }

    fn torus_point(u: f64, v: f64) -> DVec3 {
        let (u, v) = (TAU * u, TAU * v);
        let r = 0.4 + 0.05 * (5.0 * u).sin() * (7.0 * v).cos();
        let ring = 1.0 + r * u.cos();
        DVec3::new(ring * v.cos(), ring * v.sin(), r * u.sin())
    }

    fn sampled_sheet(
        [h, w]: [usize; 2],
        closed: [bool; 2],
        scheme: Scheme,
        mut point: impl FnMut(f64, f64) -> DVec3,
    ) -> Sheet<'static> {
        let mut nodes = vec![DVec3::ZERO; (h + 1) * (w + 1)];
        for (i, j) in (0..=h).flat_map(|i| (0..=w).map(move |j| (i, j))) {
            let from = [(i, h, closed[0]), (j, w, closed[1])].map(|(k, n, closed)| if closed { k % n } else { k });
            nodes[i * (w + 1) + j] = if from == [i, j] {
                point(i as f64 / h as f64, j as f64 / w as f64)
            } else {
                nodes[from[0] * (w + 1) + from[1]]
            };
        }
        let data: Vec<f64> = nodes.iter().flat_map(DVec3::to_array).collect();
        Sheet::Grid(Grid::new(Nodes::strided(data, h + 1, w + 1, 0, 0).unwrap(), closed, scheme).unwrap())
    }

    fn test_sheets() -> Vec<Sheet<'static>> {
        let mut random = fastrand::Rng::with_seed(8);
        let wavy = |u: f64, v: f64| DVec3::new(u, v, 0.1 * (9.0 * u).sin() * (7.0 * v + 1.0).cos());
        let bowl = |u: f64, v: f64| DVec3::new(u * (TAU * v).cos(), u * (TAU * v).sin(), 0.3 * u * u);
        let mut all = Vec::new();
        for scheme in [Scheme::SixTap, Scheme::FourPoint] {
            all.push(sampled_sheet([41, 73], [true; 2], scheme, torus_point));
            all.push(sampled_sheet([35, 40], [false; 2], scheme, wavy));
            all.push(sampled_sheet([25, 44], [false, true], scheme, bowl));
            all.push(sampled_sheet([30, 31], [false; 2], scheme, |u, v| wavy(u, v) + random_point(&mut random, 0.004)));
            all.push(sampled_sheet([34, 50], [true; 2], scheme, |u, v| {
                torus_point(u, v) + random_point(&mut random, 0.004)
            }));
            all.push(sampled_sheet([20, 20], [false; 2], scheme, |u, v| DVec3::new(u, v, 0.0)));
        }
        for degree in [3, 5] {
            let mut points = Vec::new();
            for (i, a, b) in (0..30).flat_map(|i| (0..=degree).flat_map(move |a| (0..=degree).map(move |b| (i, a, b))))
            {
                let at = |k: usize, a: usize| (k as f64 + a as f64 / degree as f64) / 10.0;
                points.push(wavy(at(i / 6, a), at(i % 6, b)) + random_point(&mut random, 1e-4));
            }
            all.push(match degree {
                3 => Sheet::Cubic(Patches::new(&points, [3; 2], 5, 6).unwrap()),
                _ => Sheet::High(Patches::new(&points, [degree; 2], 5, 6).unwrap()),
            });
        }
        all
    }

    /// Blocks that cones exclude do not contribute to a result: it has the same bits with cones
    /// that exclude nothing.
    #[test]
    fn results_are_equal_without_cones() {
        let (job, mut random) = (Job::default(), fastrand::Rng::with_seed(5));
        for (number, sheet) in test_sheets().into_iter().enumerate().step_by(if cfg!(debug_assertions) { 5 } else { 1 })
        {
            let sharp = Surface::new(vec![sheet.clone()], None, &job).unwrap();
            let mut blunt = Surface::new(vec![sheet], None, &job).unwrap();
            blunt.disable_cones(&job).unwrap();
            let directions = [DVec3::Z, DVec3::new(0.3, -0.5, 0.8), random_point(&mut random, 1.0)];
            let questions = directions.into_iter().flat_map(|d| [(d, false), (d, true)]);
            let stride = 6 / case_count(6) as usize;
            for (direction, unsigned) in questions.skip(number % stride).step_by(stride) {
                let max = if unsigned { FRAC_PI_2 } else { PI };
                let angles = [0.0, 1e-3, 0.6, FRAC_PI_2, 2.0, PI];
                let angles = angles.into_iter().filter(|&angle| angle <= max);
                let angles: Vec<f64> = angles.skip(number % stride % 3).step_by(stride.div_ceil(2)).collect();
                let ask =
                    |of: &Surface<'_>| of.isophotes(direction, &angles, unsigned, PointSpacing::Auto, &job).unwrap();
                let (found, truth) = (ask(&sharp), ask(&blunt));
                assert_eq!(found, truth, "sheet {number}, {direction}, unsigned {unsigned}");
                for &angle in &angles {
                    let ask = |of: &Surface<'_>| of.nearest_angle(direction, angle, unsigned, &job).unwrap().unwrap();
                    let (found, truth) = (ask(&sharp), ask(&blunt));
                    let name = format!("sheet {number}, {direction}, {angle}, unsigned {unsigned}");
                    assert_eq!(
                        (found.place, found.normal, found.angle),
                        (truth.place, truth.normal, truth.angle),
                        "{name}"
                    );
                    assert_eq!(found.deviation, truth.deviation, "{name}");
                    assert!((found.bound - truth.bound).abs() <= 1e-9, "{name}: {} {}", found.bound, truth.bound);
                }
            }
        }
    }
}
