//! The surface through sections that is calm between them.
//!
//! Between two sections, corresponding points move along cubics whose slopes at a section are the same
//! combination a d + b d' of the difference quotients before and after it, for all its points. The
//! surface therefore contains all sections, and is as smooth across them as they are.
//!
//! Let c be the change of the section from one section to the next: the root mean square distance of
//! its motion from the mean translation along the section's normal, divided by the distance. Then
//! a : b = h' c'^2 : h c^2, for distances h and h'. For equal changes, this is the parabola through
//! three sections. Sections that do not change (c = 0) get their cylinder, whatever follows. This is
//! van Albada's limiter (1982) for whole sections. At an end, the slope continues the parabola.

use super::cardinal_pieces::CardinalPiece;
use super::curve_net::{blend_rows, cut_curve_at_places, row_distances};
use super::line_strips::LineStrips;
use super::net_curve::{CurvePlace, NetCurve};
use crate::Patches;
use crate::axis::NODES_PER_CUBIC;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;

const PROGRESS_STAGE: &str = "surface of a frame";

/// Changes below this part of the largest change are rounding.
const MIN_RELATIVE_CHANGE: f64 = 1e-6;

/// Computes the patches of the skin of closed or open sections. `places` holds, section by section, the
/// places of `nodes`. `closed` tells whether the first section follows the last one, and whether
/// sections are closed.
pub(super) fn skin_sections<const N: usize>(
    mut sections: Vec<NetCurve<N>>,
    places: &[CurvePlace],
    nodes: &[DVec3],
    closed: [bool; 2],
    job: &Job<'_>,
) -> Result<Patches<N>> {
    let width = nodes.len() / sections.len();
    let points = alloc::collect(sections.iter().map(NetCurve::is_single_point))?;
    let (cutting, comparing) = (job.sub_job(0.0, 0.1), job.sub_job(0.35, 0.4));
    let pieces = alloc::try_collect((0..sections.len()).map(|k| {
        cutting.step(k as f64 / points.len() as f64, PROGRESS_STAGE)?;
        let at = alloc::copied(&places[k * width..(k + 1) * width])?;
        let ends = |l: usize| nodes[k * width + l % width];
        let out_of_order = |l: usize| Error::CurvesOutOfOrder { row: k as u32, column: l as u32, curve: "row" };
        cut_curve_at_places(&mut sections[k], at, closed[1], ends, out_of_order)
    }))?;
    let strips = LineStrips::from_curves(&pieces, &points, &job.sub_job(0.1, 0.2))?;
    let refined = strips.refine_curves_to_cells(&pieces, &job.sub_job(0.2, 0.35))?;
    let distances = row_distances(&refined, closed[0])?;
    let changes = alloc::try_collect((0..distances.len()).map(|k| {
        comparing.step(k as f64 / distances.len() as f64, PROGRESS_STAGE)?;
        section_change(&refined[k], &refined[(k + 1) % refined.len()], distances[k])
    }))?;
    blend_rows(&refined, &calm_pieces(&distances, &changes, closed[0])?, &job.sub_job(0.4, 1.0))
}

/// The change of a section on the way to the next one.
fn section_change<const N: usize>(section: &[[DVec3; N]], next: &[[DVec3; N]], distance: f64) -> Result<f64> {
    let corners = |row: &[[DVec3; N]]| {
        alloc::gather(row.iter().map(|points| points[0]).chain(row.last().map(|points| points[N - 1])))
    };
    let (here, there) = (corners(section)?, corners(next)?);
    let unit = common_unit(&here).max(common_unit(&there));
    let area = |row: &[DVec3]| -> DVec3 {
        row.windows(2).map(|pair| ((pair[0] - row[0]) / unit).cross((pair[1] - row[0]) / unit)).sum()
    };
    let motions = || here.iter().zip(&there).map(|(p, q)| (q - p) / unit);
    let mean = motions().sum::<DVec3>() / here.len() as f64;
    let (a, b) = (area(&here), area(&there));
    let normal = (if a.dot(b) < 0.0 { a - b } else { a + b }).normalize_or_zero();
    let translation = if normal == DVec3::ZERO { mean } else { normal * mean.dot(normal) };
    let squares: f64 = motions().map(|motion| motion.distance_squared(translation)).sum();
    Ok((squares / here.len() as f64).sqrt() / (distance / unit))
}

/// The functions that blend sections in each interval between two of them.
fn calm_pieces(distances: &[f64], changes: &[f64], closed: bool) -> Result<Vec<CardinalPiece>> {
    let count = distances.len();
    let sections = count + usize::from(!closed);
    // If no section changes, only the distances count.
    let min = MIN_RELATIVE_CHANGE * changes.iter().copied().fold(f64::EPSILON, f64::max);
    // The weights of four sections in the slope at the section between intervals k and k + 1, of which
    // interval k leads from the first section to the second one.
    let inner_slope = |k: usize| {
        let next = (k + 1) % count;
        let weight = |own: usize, other: usize| {
            distances[other] * changes[other].max(min).powi(2) / distances[own].max(distances[other])
        };
        let (a, b) = (weight(k, next), weight(next, k));
        let (before, after) = (a / (a + b) / distances[k], b / (a + b) / distances[next]);
        [-before, before - after, after]
    };
    alloc::collect((0..count).map(|k| {
        let quotient = [0.0, -1.0 / distances[k], 1.0 / distances[k], 0.0];
        let inner_start = (closed || k > 0).then(|| inner_slope((k + count - 1) % count));
        let inner_end = (closed || k + 1 < count).then(|| inner_slope(k));
        let mirrored = |slope: [f64; 4]| std::array::from_fn(|i| 2.0 * quotient[i] - slope[i]);
        let start = inner_start.map(|[a, b, c]| [a, b, c, 0.0]);
        let end = inner_end.map(|[a, b, c]| [0.0, a, b, c]);
        let slopes = [start.or(end.map(mirrored)), end.or(start.map(mirrored))].map(|slope| slope.unwrap_or(quotient));
        let mut points = [[0.0; 4]; NODES_PER_CUBIC];
        for (i, points) in points[..4].iter_mut().enumerate() {
            let ends = [f64::from(i == 1), f64::from(i == 2)];
            let third = distances[k] / 3.0;
            *points = [ends[0], ends[0] + third * slopes[0][i], ends[1] - third * slopes[1][i], ends[1]];
        }
        let line = |i: usize| {
            let at = k + i;
            if closed { (at + sections - 1) % sections } else { at.saturating_sub(1).min(sections - 1) }
        };
        CardinalPiece { lines: std::array::from_fn(line), points }
    }))
}
