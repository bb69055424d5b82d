//! The blocks whose normals may make given angles with a direction: one descent through the cones of normals.

use crate::alloc;
use crate::carcass::index::Cones;
use crate::error::Result;
use glam::DVec3;
use std::f64::consts::PI;

/// By how much an angle may be off where a curve is still found within rounding, in radians: the zero set of an angle is that of a function
/// that has the slope sin 2 alpha across it.
const PLAY: f64 = 1e-9;

/// That much about an angle.
fn about(angle: f64) -> [f64; 2] {
    let slope = libm::sin(2.0 * angle).abs();
    let play = if slope > 1e-8 { PLAY / slope } else { PLAY };
    [angle - play, angle + play]
}

/// True if normals at angles from `low` to `high` may have one of those given.
pub(super) fn have(goals: &[f64], unsigned: bool, [low, high]: [f64; 2]) -> bool {
    let meets = |angle: f64| {
        let [from, to] = about(angle);
        low <= to && from <= high
    };
    goals.iter().any(|&angle| meets(angle) || (unsigned && meets(PI - angle)))
}

/// The blocks, row after row, whose normals' least and greatest angle with a direction are `wanted`; those of a larger range are if those of a
/// smaller one are.
pub(super) fn blocks(
    cones: &Cones,
    direction: DVec3,
    wanted: impl Fn([f64; 2]) -> bool,
) -> Result<Vec<[u32; 2]>> {
    let mut found = Vec::new();
    let mut waiting: Vec<[usize; 3]> = Vec::new();
    let last = cones.levels() - 1;
    (0..4).for_each(|k| waiting.push([last, k / 2, k % 2]));
    while let Some([level, r, c]) = waiting.pop() {
        let Some(cone) = cones.get(level, r, c) else { continue };
        if !wanted(cone.angles(direction)) {
            continue;
        }
        if level == 0 {
            alloc::push(&mut found, [r as u32, c as u32])?;
            continue;
        }
        (0..4).for_each(|k| waiting.push([level - 1, 2 * r + k / 2, 2 * c + k % 2]));
    }
    found.sort_unstable();
    Ok(found)
}
