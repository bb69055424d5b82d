//! Answers of the paper's search: every cell that the mask leaves is halved until it is decided.
//!
//! An oracle for the index of [`crate::surface::Surface`]: they have nothing in common but the
//! patches.

use super::cell_mask::CellMask;
use super::diameter::Diameters;
use super::object::{Object, Target, incidence};
use super::search::{Goal, SearchOptions};
#[cfg(doc)]
use crate::error::Error;
use crate::error::Result;
use crate::job::Job;
use crate::surface::cells::Cells;
use crate::surface::checks::require;
use crate::surface::subdivision::Field;
use crate::surface::{Patch, Place, Sheet, each_sheet};
use glam::{DVec2, DVec3};

/// Halvings of a cell before it is left undecided.
const MAX_HALVINGS: u32 = 40;
/// Parts of a cell that are examined: at the centre of a sphere all are equally near.
const MAX_PARTS: usize = 1 << 16;

/// The nearest point of a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Its distance.
    pub distance: f64,
    /// Where it is; the sheet is 0.
    pub place: Place,
    /// No point of the sheet is nearer than this: the distance less the tolerance, or less where
    /// there is no proof.
    pub bound: f64,
}

/// The nearest point of a sheet, task a). The search by nodes leaves few cells; each is halved as
/// long as it may be nearer.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a tolerance that is no positive number; those of [`incidence`].
pub fn closest(
    sheet: &Sheet<'_>,
    diameters: &Diameters,
    query: DVec3,
    tolerance: f64,
    job: &Job<'_>,
) -> Result<Nearest> {
    check(tolerance)?;
    let found = incidence(sheet, diameters, Object::Point(query), &SearchOptions::new(Goal::Least), job)?;
    let (node, distance) = found.least;
    let [(row, u), (column, v)] = [0, 1].map(|k| {
        let last = sheet.cells()[k] - 1;
        if node[k] <= last { (node[k] as u32, 0.0) } else { (last as u32, 1.0) }
    });
    let mut best = Nearest { distance, place: Place { sheet: 0, cell: [row, column], u, v }, bound: distance };
    for (k, [i, j]) in found.mask.cells().enumerate() {
        if k % 256 == 0 {
            job.step(0.5, "cells")?;
        }
        each_sheet!(sheet, cells => {
            let near = Cells::corner(cells, i, j).distance(query) - diameters.euclidean.get([i, j]);
            if near <= best.distance * (1.0 + 1e-12) {
                refine(&Cells::patch(cells, i, j), query, [i, j], tolerance, &mut best);
            }
        });
    }
    Ok(Nearest { bound: best.bound.min(best.distance), ..best })
}

/// Looks for a nearer point in a patch.
fn refine<const N: usize>(patch: &Patch<N>, query: DVec3, cell: [usize; 2], tolerance: f64, best: &mut Nearest) {
    let mut parts = vec![(*patch, DVec2::ZERO, 1.0)];
    let mut examined = 0;
    while let Some((part, from, size)) = parts.pop() {
        examined += 1;
        let middle = part.point(0.5, 0.5);
        let distance = middle.distance(query);
        if distance < best.distance {
            let at = from + 0.5 * size;
            best.distance = distance;
            best.place = Place { sheet: 0, cell: cell.map(|k| k as u32), u: at.x, v: at.y };
        }
        // All of the part is on the far side of a plane across the direction of its middle.
        let direction = (query - middle).normalize_or_zero();
        let along = part.points.as_flattened().iter().map(|&point| (query - point).dot(direction));
        let bound = along.fold(f64::INFINITY, f64::min).max(0.0);
        if bound > best.distance - tolerance || size < 0.5_f64.powi(MAX_HALVINGS as i32) || examined > MAX_PARTS {
            best.bound = best.bound.min(bound);
            continue;
        }
        let half = 0.5 * size;
        let corners = [DVec2::ZERO, DVec2::Y, DVec2::X, DVec2::ONE];
        let quarters = part.quarters().into_iter().zip(corners);
        let first = parts.len();
        parts.extend(quarters.map(|(quarter, corner)| (quarter, from + half * corner, half)));
        // The nearest is looked at first.
        let far = |part: &Patch<N>| part.point(0.5, 0.5).distance_squared(query);
        parts[first..].sort_by(|a, b| far(&b.0).total_cmp(&far(&a.0)));
    }
}

/// The cells that have a point within a distance of an object: those of the mask of which not all
/// parts can be shown to be farther. None is missing; one that is there too many comes within the
/// tolerance of the distance, unless it was given up undecided.
///
/// With a distance of 0 these are the cells that a plane crosses or a line meets, tasks c) and d).
/// Loops inside a cell count, and sides that are crossed twice: signs at nodes show neither
/// (erratum E7).
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a tolerance that is no positive number; those of [`incidence`].
pub fn cells_within(
    sheet: &Sheet<'_>,
    diameters: &Diameters,
    object: Object,
    distance: f64,
    tolerance: f64,
    job: &Job<'_>,
) -> Result<CellMask> {
    check(tolerance)?;
    let target = object.target()?;
    let left = incidence(sheet, diameters, object, &SearchOptions::new(Goal::Within(distance)), job)?.mask;
    let mut within = left.clone();
    for (k, cell) in left.cells().enumerate() {
        if k % 256 == 0 {
            job.step(0.5, "cells")?;
        }
        let near = each_sheet!(sheet, cells => comes_near(&Cells::patch(cells, cell[0], cell[1]), &target, distance, tolerance));
        within.set(cell, near);
    }
    Ok(within)
}

fn check(tolerance: f64) -> Result<()> {
    require(tolerance > 0.0 && tolerance.is_finite(), "tolerance", tolerance)
}

/// False if no point of a patch is within a distance of the target.
fn comes_near<const N: usize>(patch: &Patch<N>, target: &Target, distance: f64, tolerance: f64) -> bool {
    let zero = Field { c: [[0.0; N]; N] };
    let mut coordinates = [zero; 3];
    for (field, axis) in coordinates.iter_mut().zip(target.axes()) {
        field.c = patch.points.map(|row| row.map(|point| (point - target.origin).dot(*axis)));
    }
    let rounding = patch.points.as_flattened().iter().map(|&point| target.rounding(point)).fold(0.0, f64::max);
    let mut parts = vec![(coordinates, 0)];
    let mut examined = 0;
    while let Some((fields, depth)) = parts.pop() {
        examined += 1;
        if target.gap_squared(&fields.map(|field| field.range())).sqrt() - rounding > distance {
            continue;
        }
        // A corner is a point of the surface.
        let corner = target.gap_squared(&fields.map(|field| [field.c[0][0]; 2])).sqrt();
        if corner <= distance + tolerance || depth == MAX_HALVINGS || examined > MAX_PARTS {
            return true;
        }
        let [x, y, z] = fields.map(|field| field.quarters());
        parts.extend((0..4).map(|k| ([x[k], y[k], z[k]], depth + 1)));
    }
    false
}
