//! Answers of the paper's search: the scale, and then every cell that it leaves. What the index of [`crate::carcass::Carcass`] must agree with.

use super::diameter::Diameters;
use super::object::{Object, incidence};
use super::scale::Scale;
use super::search::{Found, Goal, Options};
use crate::alloc;
use crate::carcass::cells::Cells;
use crate::carcass::closest::{Scratch, nearest};
use crate::carcass::line::Line;
use crate::carcass::solve::{Field, Roots, roots};
use crate::carcass::{Patch, Place, Sheet, each_sheet};
use crate::error::Result;
use crate::job::Job;
use glam::{DVec2, DVec3};

/// The nearest point of a sheet, task a): its distance and its place. The scale of the nodes leaves few cells; each is searched with proof, to
/// `tolerance`.
///
/// # Errors
/// Those of [`incidence`].
pub fn closest(
    sheet: &Sheet<'_>,
    diameters: &Diameters,
    query: DVec3,
    tolerance: f64,
    job: &Job<'_>,
) -> Result<(f64, Place)> {
    let found = incidence(sheet, diameters, Object::Point(query), &Options::new(Goal::Least), job)?;
    each_sheet!(sheet, cells => closest_of(cells, diameters, &found, query, tolerance, job))
}

fn closest_of<const N: usize>(
    cells: &impl Cells<N>,
    diameters: &Diameters,
    found: &Found,
    query: DVec3,
    tolerance: f64,
    job: &Job<'_>,
) -> Result<(f64, Place)> {
    let (mut scratch, mut best) = (Scratch::<N>::default(), None);
    let mut reach = found.least.1 * (1.0 + 1e-12);
    for (k, cell) in found.scale.cells().enumerate() {
        if k % 256 == 0 {
            job.step(0.5, "cells")?;
        }
        let [i, j] = cell;
        // The least node's distance is known now, and may exclude what an earlier one could not.
        let corner = cells.corner(i, j).distance(query);
        if corner - diameters.euclidean.get(cell) > reach {
            continue;
        }
        let there = nearest(&cells.patch(i, j), query, DVec2::splat(0.5), reach, tolerance, &mut scratch);
        if there.distance <= reach && best.is_none_or(|(distance, _)| there.distance < distance) {
            reach = there.distance;
            best = Some((
                there.distance,
                Place { sheet: 0, cell: [i as u32, j as u32], u: there.place.x, v: there.place.y },
            ));
        }
    }
    // The node itself, if nothing is better.
    let [i, j] = found.least.0;
    let side = |k: usize, at: usize| at.min(cells.counts()[k] - 1);
    let (row, column) = (side(0, i), side(1, j));
    let (u, v) = ((i - row) as f64, (j - column) as f64);
    Ok(best.unwrap_or((found.least.1, Place { sheet: 0, cell: [row as u32, column as u32], u, v })))
}

/// Where a line meets a sheet, task c): t and place of each simple crossing, by rising t; one on a side between cells may come from both. And
/// whether there is a spot that may touch.
///
/// # Errors
/// Those of [`incidence`].
pub fn line(
    sheet: &Sheet<'_>,
    diameters: &Diameters,
    line: &Line,
    tolerance: f64,
    job: &Job<'_>,
) -> Result<(Vec<(f64, Place)>, bool)> {
    let found = incidence(sheet, diameters, Object::Line(*line), &Options::new(Goal::Within(tolerance)), job)?;
    each_sheet!(sheet, cells => line_of(cells, &found.scale, line, tolerance, job))
}

fn line_of<const N: usize>(
    cells: &impl Cells<N>,
    scale: &Scale,
    line: &Line,
    tolerance: f64,
    job: &Job<'_>,
) -> Result<(Vec<(f64, Place)>, bool)> {
    let (across, along) = (line.direction.normalize().any_orthonormal_pair(), line.direction);
    let (mut hits, mut touches) = (Vec::new(), false);
    for (k, [i, j]) in scale.cells().enumerate() {
        if k % 256 == 0 {
            job.step(0.5, "cells")?;
        }
        let patch = cells.patch(i, j);
        let field = |direction: DVec3| plane_field(&patch, line.origin, direction);
        let reach = (patch.points[0][0] - line.origin).length() + line.origin.length();
        let mut found = Roots::default();
        roots([field(across.0), field(across.1)], 8.0 * f64::EPSILON * reach, tolerance, &mut found);
        touches |= !found.unresolved.is_empty();
        for DVec2 { x: u, y: v } in found.simple {
            let t = (patch.point(u, v) - line.origin).dot(along) / along.length_squared();
            if t >= line.from && t <= line.to {
                alloc::push(&mut hits, (t, Place { sheet: 0, cell: [i as u32, j as u32], u, v }))?;
            }
        }
    }
    hits.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok((hits, touches))
}

/// The cells that a plane crosses or comes as near as `tolerance`, task d): those of the scale of which no part can be cut off as clear of it.
///
/// Loops inside a cell count, and sides that the plane crosses twice: signs at nodes show neither (erratum E7).
///
/// # Errors
/// Those of [`incidence`].
pub fn plane_cells(
    sheet: &Sheet<'_>,
    diameters: &Diameters,
    point: DVec3,
    normal: DVec3,
    tolerance: f64,
    job: &Job<'_>,
) -> Result<Scale> {
    let object = Object::Plane { point, normal }.normalized()?;
    let Object::Plane { normal, .. } = object else { unreachable!("a plane stays one") };
    let mut scale = incidence(sheet, diameters, object, &Options::new(Goal::Within(tolerance)), job)?.scale;
    let mut candidates = alloc::with_capacity(scale.count())?;
    candidates.extend(scale.cells());
    for (k, cell) in candidates.into_iter().enumerate() {
        if k % 1024 == 0 {
            job.step(0.5, "cells")?;
        }
        let comes_near = each_sheet!(sheet, cells => {
            may_vanish(&plane_field(&Cells::patch(cells, cell[0], cell[1]), point, normal), tolerance, DEPTH)
        });
        scale.set(cell, comes_near);
    }
    Ok(scale)
}

/// Halvings of a cell before a plane that comes so near is taken to touch it.
const DEPTH: u32 = 20;

fn plane_field<const N: usize>(patch: &Patch<N>, point: DVec3, normal: DVec3) -> Field<N> {
    Field { c: patch.points.map(|row| row.map(|control| (control - point).dot(normal))) }
}

/// False if no value of a field is within the tolerance.
fn may_vanish<const N: usize>(field: &Field<N>, tolerance: f64, depth: u32) -> bool {
    let [low, high] = field.range();
    if low > tolerance || high < -tolerance {
        return false;
    }
    // Values at corners are taken: a zero between them is certain if their signs differ.
    let corners = [field.c[0][0], field.c[0][N - 1], field.c[N - 1][0], field.c[N - 1][N - 1]];
    let certain = corners.iter().any(|x| x.abs() <= tolerance)
        || (corners.iter().any(|&x| x > 0.0) && corners.iter().any(|&x| x < 0.0));
    certain || depth == 0 || field.quarters().iter().any(|part| may_vanish(part, tolerance, depth - 1))
}
