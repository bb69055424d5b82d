//! The strip between two rims: first meridian, remaining meridians, rows and faces.

use super::existing_edges::ExistingEdges;
use super::first_meridian::{Start, closest_vertex_pair, vertex_pair_by_best_rotation};
use super::grid::{FaceList, MeridianGrid};
use super::meridian::{
    self, MeridianChoice, MeridianEnds, Meridians, RimPair, StepPenalty, choose_meridians, choose_meridians_near_path,
    sorted_forbidden_nodes,
};
use super::stitch_request::{Cells, Options, Rows};
use super::stitch_rim::Rim;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::par;

/// A second start is used if its relative gain exceeds this.
const MIN_RELATIVE_GAIN_OF_SECOND_START: f64 = 1.0 / (1 << 20) as f64;

/// The width of a wide gap, in mean radii of the smaller rim.
const MIN_WIDE_GAP_RADII: f64 = 1.0;

/// The largest number of new vertices that [`Rows::MeanEdge`] makes in more than
/// [`MIN_AUTOMATIC_ROWS`].
const MAX_AUTOMATIC_ROW_VERTICES: usize = 50_000;
/// A number of rows that [`Rows::MeanEdge`] may always make.
const MIN_AUTOMATIC_ROWS: usize = 16;

/// Lattices with fewer nodes are searched on one thread.
const MIN_NODES_PER_THREAD: usize = 1 << 14;

/// A strip that is not yet part of a mesh.
pub(crate) struct Strip {
    /// The rims, side by side from the first meridian on.
    pub(crate) a: Rim,
    pub(crate) b: Rim,
    pub(crate) meridians: Vec<MeridianEnds>,
    pub(crate) grid: MeridianGrid,
    pub(crate) faces: FaceList,
    /// The parents of each new vertex.
    pub(crate) parents: Vec<RimParents>,
}

/// The rim vertices that a new vertex is interpolated from.
#[derive(Clone, Copy)]
pub(crate) struct RimParents {
    /// Strip vertices. In a row, they are the ends of the meridian, the end on rim B twice.
    pub(crate) vertices: [u32; 3],
    /// The weight of each parent, at least 0, with sum 1. In a row the last is 0.
    pub(crate) weights: [f64; 3],
}

impl Strip {
    /// Builds a strip between two rims that run side by side, rim A with its surface on the left,
    /// and rim B on the right. `mean_side` returns the mean side of the faces around the strip, in
    /// the rims' unit; it is called only if the rows depend on it.
    ///
    /// # Errors
    /// [`Error::NoStrip`], [`Error::OptionOutOfRange`], [`Error::TooLarge`],
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub(crate) fn build(
        mut a: Rim,
        mut b: Rim,
        existing: &ExistingEdges,
        options: &Options,
        mean_side: impl Fn() -> f64,
        job: &Job<'_>,
    ) -> Result<Strip> {
        let meridians = if a.closed {
            choose_best_first_meridian(&mut a, &mut b, existing, options, job)?
        } else if options.twist != 0 {
            return Err(Error::OptionOutOfRange {
                option: "twist",
                value: options.twist as f64,
                allowed: "0 between arcs".into(),
            });
        } else {
            meridians_from_given_start(&a, &b, existing, options, job)?
                .ok_or(Error::NoStrip { vertex: a.vertices[0] })?
                .pairs
        };
        job.step(1.0, meridian::STAGE)?;
        let strip = Strip::from_meridians(a, b, meridians, existing, options, mean_side, job)?;
        job.step(1.0, meridian::STAGE)?;
        Ok(strip)
    }

    /// Builds a strip between two rims from given meridians.
    ///
    /// # Errors
    /// [`Error::NoStrip`], [`Error::TooLarge`], [`Error::OutOfMemory`].
    pub(super) fn from_meridians(
        a: Rim,
        b: Rim,
        meridians: Vec<MeridianEnds>,
        existing: &ExistingEdges,
        options: &Options,
        mean_side: impl Fn() -> f64,
        job: &Job<'_>,
    ) -> Result<Strip> {
        let rows = match options.rows {
            Rows::None => 0,
            Rows::Count(count) => count,
            Rows::MeanEdge => {
                let lengths = meridians.iter().map(|&[i, j]| a.point(i).distance(b.point(j)));
                let mean_meridian = lengths.sum::<f64>() / meridians.len() as f64;
                let wanted = (mean_meridian / mean_side()).round() - 1.0;
                let most = (MAX_AUTOMATIC_ROW_VERTICES / meridians.len()).max(MIN_AUTOMATIC_ROWS) as f64;
                if wanted > most {
                    job.note("rows as wide as the faces would need too many vertices, so the rows are wider: set their number");
                }
                wanted.clamp(0.0, most) as u32
            }
        };
        let grid = MeridianGrid::new(&a, &b, &meridians, rows)?;
        let faces = grid.build_faces(&a, &b, existing, options.cells == Cells::Quads)?;
        let parents = parents_in_rows(&grid)?;
        Ok(Strip { a, b, meridians, grid, faces, parents })
    }

    /// Replaces the meridians, and the number of rows. After an error, the strip is unchanged.
    ///
    /// # Errors
    /// [`Error::NoStrip`], [`Error::TooLarge`], [`Error::OutOfMemory`].
    pub(super) fn set_meridians(
        &mut self,
        meridians: Vec<MeridianEnds>,
        rows: u32,
        existing: &ExistingEdges,
        options: &Options,
    ) -> Result<()> {
        let grid = MeridianGrid::new(&self.a, &self.b, &meridians, rows)?;
        let faces = grid.build_faces(&self.a, &self.b, existing, options.cells == Cells::Quads)?;
        let parents = parents_in_rows(&grid)?;
        (self.grid, self.faces, self.parents, self.meridians) = (grid, faces, parents, meridians);
        Ok(())
    }

    /// Returns the mean length of the meridians, in mean radii of the smaller rim.
    pub(super) fn gap_in_radii(&self) -> f64 {
        let lengths = self.meridians.iter().map(|&[i, j]| self.a.point(i).distance(self.b.point(j)));
        let radius = self.a.mean_radius().min(self.b.mean_radius());
        lengths.sum::<f64>() / (radius * self.meridians.len() as f64)
    }

    /// Returns true if the gap is wider than [`MIN_WIDE_GAP_RADII`].
    pub(super) fn has_wide_gap(&self) -> bool {
        self.gap_in_radii() > MIN_WIDE_GAP_RADII
    }

    /// Returns the number of rim vertices, which come first in the strip.
    pub(crate) fn rim_count(&self) -> usize {
        self.a.vertices.len() + self.b.vertices.len()
    }
}

/// Returns the parents of the vertices in rows.
fn parents_in_rows(grid: &MeridianGrid) -> Result<Vec<RimParents>> {
    let new = grid.meridian_ends().zip(&grid.columns_and_fractions);
    let parents =
        new.map(|([a, b], &(_, weight))| RimParents { vertices: [a, b, b], weights: [1.0 - weight, weight, 0.0] });
    alloc::gather(parents)
}

/// Rotates the rims to the best first meridian, and returns the meridians from there.
fn choose_best_first_meridian(
    a: &mut Rim,
    b: &mut Rim,
    existing: &ExistingEdges,
    options: &Options,
    job: &Job<'_>,
) -> Result<Vec<MeridianEnds>> {
    let none = Error::NoStrip { vertex: a.vertices[0] };
    let count = b.vertices.len();
    let (i, j) = closest_vertex_pair(a, b, existing, &job.sub_job(0.0, 0.2))?.ok_or(none)?;
    let j = ((j as i64 + options.twist.rem_euclid(count as i64)).rem_euclid(count as i64)) as usize;
    let second = match options.start {
        Start::Auto if options.twist == 0 => {
            vertex_pair_by_best_rotation(a, b, existing, &job.sub_job(0.2, 0.2))?.filter(|&other| other != (i, j))
        }
        _ => None,
    };
    a.rotate_to_start_at(i);
    b.rotate_to_start_at(j);
    let job = job.sub_job(0.2, 1.0);
    job.step(0.0, meridian::STAGE)?;
    let Some((i2, j2)) = second else {
        return meridians_from_given_start(a, b, existing, options, &job)?.map(|chosen| chosen.pairs).ok_or(none);
    };
    let (mut other_a, mut other_b) = (a.try_clone()?, b.try_clone()?);
    job.step(0.0, meridian::STAGE)?;
    other_a.rotate_to_start_at((i2 + a.vertices.len() - i) % a.vertices.len());
    other_b.rotate_to_start_at((j2 + count - j) % count);
    let linear = matches!(options.meridians, Meridians::Index | Meridians::ArcLength | Meridians::Greedy);
    let threads = if linear || a.vertices.len() * count < MIN_NODES_PER_THREAD { 1 } else { job.requested_threads() };
    let (first, other) = par::run_both(
        &job.with_threads(threads),
        meridian::STAGE,
        |job| meridians_from_given_start(a, b, existing, options, job),
        |job| meridians_from_given_start(&other_a, &other_b, existing, options, job),
    )?;
    let is_better = |other: &MeridianChoice| match &first {
        Some(first) => other.cost < first.cost * (1.0 - MIN_RELATIVE_GAIN_OF_SECOND_START),
        None => true,
    };
    match other.filter(is_better) {
        Some(other) => {
            (*a, *b) = (other_a, other_b);
            Ok(other.pairs)
        }
        None => first.map(|chosen| chosen.pairs).ok_or(none),
    }
}

/// Returns the best meridians from the given first meridian.
pub(crate) fn meridians_from_given_start(
    a: &Rim,
    b: &Rim,
    existing: &ExistingEdges,
    options: &Options,
    job: &Job<'_>,
) -> Result<Option<MeridianChoice>> {
    with_rim_pair(a, b, existing, options, &[], |rims| choose_meridians(rims, options.meridians, options.search, job))
}

/// Returns the best meridians near a path, with penalties on some steps.
pub(super) fn meridians_near_path(
    a: &Rim,
    b: &Rim,
    existing: &ExistingEdges,
    options: &Options,
    path: &[MeridianEnds],
    penalties: &[StepPenalty],
    job: &Job<'_>,
) -> Result<Option<MeridianChoice>> {
    with_rim_pair(a, b, existing, options, penalties, |rims| {
        choose_meridians_near_path(rims, options.meridians, path, job)
    })
}

fn with_rim_pair<T>(
    a: &Rim,
    b: &Rim,
    existing: &ExistingEdges,
    options: &Options,
    penalties: &[StepPenalty],
    find: impl FnOnce(&RimPair<'_>) -> Result<T>,
) -> Result<T> {
    let (n, m) = (a.vertices.len() as u32, b.vertices.len() as u32);
    // With interior rows, no meridian is a single edge.
    let forbidden = match options.rows {
        Rows::None => sorted_forbidden_nodes(existing.lattice_nodes(a, b)?.into_iter(), n, m, a.closed)?,
        _ => Vec::new(),
    };
    let (line_a, line_b) = (a.closed_points()?, b.closed_points()?);
    let sides = Some([a.normals.as_slice(), b.normals.as_slice()]);
    find(&RimPair {
        a: &line_a,
        b: &line_b,
        closed: a.closed,
        forbidden: &forbidden,
        face_normals_along_rims: sides,
        penalties,
    })
}
