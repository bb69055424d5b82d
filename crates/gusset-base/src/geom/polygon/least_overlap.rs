//! The split of a small polygon whose triangles overlap least.
//!
//! Dynamic programming over all splits (Klincsek, *Minimal triangulations of polygonal domains*,
//! 1980): the best split between two corners is the best triangle on them with the best splits on
//! its sides. Splits are compared by the area that is turned over, then by their flat triangles,
//! then by the length of diagonals.

use crate::alloc;
use crate::error::Result;
use glam::DVec2;

/// Most corners of a polygon that is searched: the time grows with their cube.
pub(super) const MAX_SEARCH_CORNERS: usize = 40;
/// Triangles are flat up to this area, relative to the square of the polygon's extent.
const MAX_FLAT_AREA: f64 = 1e-12;

/// Faults of a split, the worst first.
#[derive(Clone, Copy, Default, PartialEq, PartialOrd)]
struct SplitCost {
    turned_area: f64,
    flat_count: f64,
    diagonals: f64,
}

impl SplitCost {
    fn plus(self, other: Self) -> Self {
        Self {
            turned_area: self.turned_area + other.turned_area,
            flat_count: self.flat_count + other.flat_count,
            diagonals: self.diagonals + other.diagonals,
        }
    }
}

/// Replaces triangles of a polygon by the split that overlaps least. `flat` are its points in the
/// plane, anticlockwise.
pub(super) fn split_with_least_overlap(flat: &[DVec2], triangles: &mut Vec<[u32; 3]>) -> Result<()> {
    let count = flat.len();
    let extent = flat.iter().fold(0.0_f64, |most, point| most.max(point.abs().max_element()));
    let max_flat = MAX_FLAT_AREA * extent * extent;
    // For each pair of corners: the cost of the best split between them, and the third corner of its triangle.
    let mut best = alloc::filled((SplitCost::default(), 0_usize), count * count)?;
    for span in 2..count {
        for start in 0..count - span {
            let end = start + span;
            let diagonal = if span + 1 < count { flat[start].distance(flat[end]) } else { 0.0 };
            let mut least: Option<(SplitCost, usize)> = None;
            for middle in start + 1..end {
                let triangle = triangle_cost([start, middle, end].map(|corner| flat[corner]), max_flat, diagonal);
                let cost = best[start * count + middle].0.plus(best[middle * count + end].0).plus(triangle);
                if least.is_none_or(|(old, _)| cost < old) {
                    least = Some((cost, middle));
                }
            }
            best[start * count + end] = least.unwrap_or((SplitCost::default(), start + 1));
        }
    }
    triangles.clear();
    let mut open = alloc::with_capacity(count)?;
    open.push((0, count - 1));
    while let Some((start, end)) = open.pop() {
        if end - start >= 2 {
            let middle = best[start * count + end].1;
            alloc::push(triangles, [start, middle, end].map(|corner| corner as u32))?;
            alloc::append(&mut open, &[(start, middle), (middle, end)])?;
        }
    }
    Ok(())
}

fn triangle_cost([a, b, c]: [DVec2; 3], max_flat: f64, diagonal: f64) -> SplitCost {
    let area = (b - a).perp_dot(c - a);
    SplitCost {
        turned_area: if area < -max_flat { -area } else { 0.0 },
        flat_count: f64::from(u8::from(area.abs() <= max_flat)),
        diagonals: diagonal,
    }
}
