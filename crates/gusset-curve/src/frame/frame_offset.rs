//! Offset frames, such as a shoe around a foot.
//!
//! This is Nadopta's application: the body of a shoe is the foot's body plus room for comfort, more
//! in some places than in others. Each node moves by its own distance, and new curves pass through
//! the moved nodes. Directions come from circles through neighbouring nodes
//! ([`node_normals`](gusset_base::geom::node_normals)), so that frames of planes, cylinders and
//! spheres keep their kind.

use super::{Correspondence, Frame, FrameOptions, NodeGrid, frame};
use crate::identify::{Outlines, Points};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::geom::node_normals::{node_normals, tangent_of_circle_at_point};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;

const PROGRESS_STAGE: &str = "offsetting a frame";

/// A section determines the outward side only if the cosine of the angle between the body's normal
/// and the section's outward direction is at least this.
const MIN_OUTWARD_COSINE: f64 = 0.05;

/// The direction in which nodes move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum OffsetDirection {
    /// Along the normals of the body.
    #[default]
    Normal,
    /// Within the planes of their sections.
    InSection,
}

/// Offsets the nodes of a frame and passes curves through them.
///
/// Closed sections move outwards, or inwards for negative distances. Open sections move along the
/// derivative across sections times the derivative along a section. Within sections, open ones move
/// away from the chord between their ends. Nodes without a defined direction stay.
///
/// `distances` has one value for all nodes, for each section, or for each node. `options` are the
/// options of the curves; the nodes already correspond.
///
/// # Errors
/// [`Error::ValuesDiffer`] for another number of distances, [`Error::BadValue`] for one that is not
/// finite, and the errors of [`frame`].
pub fn offset(
    grid: &NodeGrid,
    closed: bool,
    distances: &[f64],
    direction: OffsetDirection,
    options: &FrameOptions<'_>,
    job: &Job<'_>,
) -> Result<Frame> {
    let (rows, columns) = (grid.rows, grid.columns);
    let distance = node_distances(distances, [rows, columns])?;
    // With coordinates near 1, squares and their inverses stay in range.
    job.step(0.0, PROGRESS_STAGE)?;
    let unit = common_unit(&grid.nodes);
    let nodes = grid.nodes.iter().map(|&p| p / unit);
    let nodes = &alloc::collect_cancellable(nodes, &job.sub_job(0.0, 0.05), PROGRESS_STAGE)?[..];
    let areas = alloc::collect(nodes.chunks_exact(columns).map(section_area_vector))?;
    let inside = (0..rows * columns).map(|k| {
        let row = &nodes[k / columns * columns..][..columns];
        tangent_of_circle_at_point(columns, closed, k % columns, |j| row[j])
            .cross(areas[k / columns])
            .normalize_or_zero()
    });
    let inside = alloc::collect_cancellable(inside, &job.sub_job(0.05, 0.1), PROGRESS_STAGE)?;
    let directions = match direction {
        OffsetDirection::InSection => inside,
        OffsetDirection::Normal => {
            let normal_job = job.sub_job(0.1, 0.2);
            let mut normals =
                node_normals(nodes, [rows, columns], [options.ring, closed], &normal_job, PROGRESS_STAGE)?;
            // The outward side of the sections. Where a body is as flat as its sections, most of
            // the other nodes decide.
            let outwards: f64 = normals.iter().zip(&inside).map(|(n, out)| n.dot(*out)).sum();
            for (n, out) in normals.iter_mut().zip(&inside).filter(|_| closed) {
                let own = n.dot(*out);
                let side = if own.abs() < MIN_OUTWARD_COSINE { outwards } else { own };
                *n = if side < 0.0 { -*n } else { *n };
            }
            normals
        }
    };
    let moved = (0..rows * columns).map(|k| (grid.nodes[k] + distance(k) * directions[k]).to_array());
    let moved = alloc::collect_cancellable(moved, &job.sub_job(0.2, 0.25), PROGRESS_STAGE)?;
    let offsets = alloc::collect((0..rows + 1).map(|k| (k * columns) as u32))?;
    let sections = Outlines { points: Points::from(&moved[..]), offsets: Some(&offsets), closed, constraints: &[] };
    let options = FrameOptions {
        correspondence: Correspondence::Given,
        smooth_corners: grid.corners.is_empty(),
        missing: &[],
        ..*options
    };
    frame(&sections, &options, &job.sub_job(0.25, 1.0))
}

/// Returns the distance of each node, given one value for all, one for each row, or one for each
/// node.
pub fn node_distances(distances: &[f64], [rows, columns]: [usize; 2]) -> Result<impl Fn(usize) -> f64> {
    let count = rows * columns;
    if let Some((k, &value)) = distances.iter().enumerate().find(|(_, value)| !value.is_finite()) {
        return Err(Error::BadValue { element: Element::Node, index: k as u64, input: 0, value });
    }
    let share = match distances.len() {
        1 => count,
        n if n == count => 1,
        n if n == rows => columns,
        n => return Err(Error::ValuesDiffer { input: 0, given: n as u64, needed: count as u64 }),
    };
    Ok(move |k: usize| distances[k / share])
}

/// Returns the area vector of a section. Seen against it, the section runs counter-clockwise.
fn section_area_vector(row: &[DVec3]) -> DVec3 {
    let turn = |pair: &[DVec3]| (pair[0] - row[0]).cross(pair[1] - row[0]);
    row.windows(2).map(turn).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use gusset_base::job::Progress;
    use std::cell::Cell;
    use std::ops::ControlFlow;
    use std::time::{Duration, Instant};

    /// Counts the reports of the offset, and cancels the call where its curves begin.
    #[derive(Default)]
    struct OffsetReports(Cell<usize>);

    impl Progress for OffsetReports {
        fn step(&self, _: f64, stage: &'static str) -> ControlFlow<()> {
            self.0.set(self.0.get() + 1);
            if stage == PROGRESS_STAGE { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        }
    }

    #[test]
    fn long_sections_take_linear_time_and_report() {
        // The area of each section must not be computed once for each of its nodes.
        let (rows, columns) = (15, 20_000);
        let node = |k: usize| {
            let angle = std::f64::consts::TAU * (k % columns) as f64 / columns as f64;
            DVec3::new(angle.cos(), angle.sin(), (k / columns) as f64)
        };
        let grid = NodeGrid {
            rows,
            columns,
            nodes: (0..rows * columns).map(node).collect(),
            across: Vec::new(),
            along: Vec::new(),
            turned: vec![0; rows],
            ambiguous: Vec::new(),
            corners: Vec::new(),
            filled: Vec::new(),
            max_twist: 0.0,
            max_gap: 0.0,
            min_sine: 1.0,
        };
        for direction in [OffsetDirection::InSection, OffsetDirection::Normal] {
            let (reports, start) = (OffsetReports::default(), Instant::now());
            let options = FrameOptions::new(Correspondence::Given);
            let found = offset(&grid, true, &[0.5], direction, &options, &Job::new(1, &reports));
            assert_eq!(found, Err(Error::Cancelled));
            assert!(reports.0.get() >= 9, "{}", reports.0.get());
            assert!(start.elapsed() < Duration::from_secs(30));
        }
    }
}
