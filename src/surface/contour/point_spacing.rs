//! The paper's own approximation of a section: the chord between two crossings with lines of the surface, and, of higher order, the curve
//! through the crossings with the neighbouring lines too.

use super::Between;
use crate::alloc;
use crate::error::{Error, Result};
use crate::surface::Paths;
use glam::DVec3;

/// The most points between two crossings.
pub(super) const MOST: u32 = 1000;

/// Adds the points of [`Between::Leus`] to paths that consist of crossings; other paths stay as they are.
pub(super) fn between(given: Paths, between: Between) -> Result<Paths> {
    let count = match between {
        Between::Leus(count) if count > 0 => count as usize,
        _ => return Ok(given),
    };
    let total = (given.points.len() as u64).saturating_mul(count as u64 + 1);
    if total > u32::MAX.into() {
        return Err(Error::TooLarge { what: "points of curves", count: total, limit: u32::MAX.into() });
    }
    let mut made = Paths { ends: vec![0], unresolved: given.unresolved, ..Paths::default() };
    for k in 0..given.closed.len() {
        let range = given.ends[k] as usize..given.ends[k + 1] as usize;
        let (points, closed) = (&given.points[range.clone()], given.closed[k]);
        alloc::reserve(&mut made.points, points.len() * (count + 1))?;
        alloc::reserve(&mut made.places, points.len() * (count + 1))?;
        alloc::reserve(&mut made.normals, points.len() * (count + 1))?;
        for (i, at) in range.clone().enumerate() {
            let (place, normal) = (given.places[at], given.normals[at]);
            made.points.push(points[i]);
            made.places.push(place);
            made.normals.push(normal);
            if i + 1 == points.len() && !closed {
                break;
            }
            let next = given.normals[range.start + (i + 1) % points.len()];
            for step in 1..=count {
                let t = step as f64 / (count + 1) as f64;
                made.points.push(cubic(points, closed, i, t));
                made.places.push(place);
                made.normals.push(normal.lerp(next, t).normalize_or_zero());
            }
        }
        alloc::push(&mut made.ends, made.points.len() as u32)?;
    }
    (made.closed, made.levels) = (given.closed, given.levels);
    Ok(made)
}

/// The cubic through points i - 1 to i + 2, or as many as there are, over their chords: at part t of the way from point i to the next.
fn cubic(points: &[DVec3], closed: bool, i: usize, t: f64) -> DVec3 {
    let n = points.len();
    let (first, count) = if closed {
        if n >= 4 { (i + n - 1, 4) } else { (i, n) }
    } else {
        (i.saturating_sub(1).min(n.saturating_sub(4)), n.min(4))
    };
    let at = |k: usize| points[(first + k) % n];
    let mut knots = [0.0; 4];
    for k in 1..count {
        knots[k] = knots[k - 1] + at(k).distance(at(k - 1));
    }
    let own = if closed { usize::from(n >= 4) } else { i - first };
    let x = knots[own] + t * (knots[own + 1] - knots[own]);
    // Lagrange's form.
    let weight = |k: usize| -> f64 {
        (0..count).filter(|&other| other != k).map(|other| (x - knots[other]) / (knots[k] - knots[other])).product()
    };
    (0..count).map(|k| weight(k) * at(k)).sum()
}
