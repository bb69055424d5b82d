//! Task e) of the paper: intersections of two surfaces.
//!
//! 1. Both pyramids are descended together to find the pairs of cells that may meet (`cell_pairs`).
//! 2. Over a pair, the points with A(s, t) = B(u, v) are curves in four parameters. A box of
//!    parameters is excluded, or proven to contain a graph (`solution_chart`), whose arc is
//!    followed from side to side (`arc_search`). Other boxes are halved (`pair_search`).
//! 3. Unresolved boxes are clustered. The relative second form resolves clusters (`contact`,
//!    `height_graph`): points where the surfaces touch, and points where branches cross.
//! 4. Arcs are chained (`intersection_chain`, `arc_links`), also through crossings and across
//!    unresolved places (`chain_bridges`).
//!
//! Proven: every common point of the given surfaces lies in a pair of cells of step 1. It lies in a
//! box whose arc was found or is shorter than the resolution, within the radius of a contact, or in
//! a cell reported as unresolved. Bounds are computed in double precision, with an allowance for
//! rounding (`rounding_error`).
//!
//! One decision is made from points and is not proven. If a curve is closer to a side of a box than
//! a thousandth of the resolution, it may run along the side, touch it or cross it. The decision
//! assigns the curve to one of the boxes on both sides. A curve along a side is found from both,
//! and kept once (`overlapping_arcs`).
//!
//! Self-intersections (`self_intersection`) take the same steps. They differ for cells that have
//! points in common (`cell_joints`, `adjacent_cells`, `poles`), and in how arcs are joined
//! (`trails`).

mod arc_search;
mod arc_refinement;
mod chain_bridges;
mod solution_chart;
mod contact;
mod coordinate_net;
mod intersection_equation;
mod height_graph;
mod intersection_chain;
mod self_intersection;
mod cell_joints;
mod arc_links;
mod adjacent_cells;
mod overlapping_arcs;
mod cell_pairs;
mod pair_places;
mod poles;
mod pair_search;
mod trails;

pub use cell_pairs::{CellPair, MAX_PAIRS};
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::{alloc, par};

use super::cells::SheetCells;
use super::path::{Contact, ContactKind};
use super::{Paths, Place, Sheet, Surface, each_sheet};
use chain_bridges::IntersectedSurfaces;
use contact::{ContactSearch, CriticalPoint, EXPLAINED_AS_APART, NOT_EXPLAINED};
use coordinate_net::CoordinateNet;
use glam::{DVec3, DVec4};
use intersection_chain::{ChainedArcs, chain_arcs};
use overlapping_arcs::OverlappingArcs;
use pair_places::PairPlaces;
use pair_search::{CellPairTask, FoundArcsAndBalls, IntersectionArc};
use solution_chart::ParameterBox;
use std::ops::Range;

/// Number of pairs of cells that a thread solves in one task.
const PAIRS_PER_CHUNK: usize = 32;
/// Number of boxes of parameters examined between two progress reports.
const BOXES_PER_REPORT: usize = 1 << 16;
/// Number of boxes examined for a pair of cells before the pair is postponed.
const MAX_BOXES_BEFORE_POSTPONING: usize = 256;
/// Number of boxes examined for all postponed pairs together. Each pair gets at least
/// [`MAX_BOXES_BEFORE_POSTPONING`].
const MAX_POSTPONED_BOXES: usize = 1 << 22;
/// Largest number of boxes for a postponed pair.
const MAX_BOXES_PER_POSTPONED_PAIR: usize = 1 << 17;

/// Length of arcs that may be lost, in resolutions. Arcs of many successive boxes, as at poles, are
/// shorter than a resolution together.
const SHORTEST_ARC_IN_RESOLUTIONS: f64 = 1.0 / 32.0;

/// Options for intersections.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// Largest distance of the curve from the chords between its points. `None` means 1e-4 times
    /// the diagonal of the smaller surface's bounding box. Infinity means that points are only
    /// computed where the curve crosses sides of cells.
    pub chord: Option<f64>,
    /// Surfaces touch wherever they are apart, or overlap, by at most this length. Branches are
    /// found and separated by the smallest of this and the surfaces' own tolerances; shorter
    /// branches may be lost. `None` means the smaller of the surfaces' own tolerances.
    pub tolerance: Option<f64>,
}

/// The value, which must be positive, or the default.
fn positive_or_default(option: &'static str, value: Option<f64>, default: f64) -> Result<f64> {
    match value {
        Some(value) if value.is_nan() || value <= 0.0 => {
            Err(Error::OptionOutOfRange { option, value, allowed: "above 0".into() })
        }
        _ => Ok(value.unwrap_or(default)),
    }
}

impl Surface<'_> {
    /// Finds the curves in which two surfaces meet. `places` are on this surface, `others` on the
    /// other one. Curves run along N_A x N_B, and closed curves are marked as closed. Finds every
    /// branch that is not part of a contact and is longer than the tolerance (the smallest of the
    /// option and the surfaces' own).
    ///
    /// `contacts` holds the points where, within the tolerance, the surfaces touch or two branches
    /// cross. At a contact, the surfaces are graphs over a plane, and the difference of their
    /// second derivatives is proven definite or indefinite over the whole unresolved neighbourhood.
    /// Surfaces that overlap by more than the tolerance meet in a curve instead. Surfaces that are
    /// farther apart do not meet.
    ///
    /// The radius of a contact is at most about four times sqrt(2 tolerance / k), where k is the
    /// smallest curvature of the difference. Inside it, the curve is omitted, and a path that
    /// enters continues straight to the point. N_A x N_B points alternately towards a crossing and
    /// away from it, so paths turn there. Each of the four branches is joined to the neighbour that
    /// leads back to it, so that a figure of eight becomes two closed paths with a common point. If
    /// no neighbour leads back, paths are as straight as possible.
    ///
    /// `unresolved` holds the cells of this surface where the surfaces coincide or touch in another
    /// way: along a curve, at a pole, at the border of a sheet or to a higher order. Curves may end
    /// there. They are joined across such a place if a chord is as close to both surfaces as
    /// elsewhere. Points are on this surface. They agree with the places on the other surface
    /// within rounding, and at crossings within the tolerance.
    ///
    /// Time and memory are proportional to the number of pairs of cells within the tolerance of
    /// each other, with a limit for each pair. Surfaces that coincide have many such pairs.
    /// Self-intersections are not included; see [`Surface::meet_itself`].
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`]; [`Error::TooLarge`] above [`MAX_PAIRS`] pairs of cells;
    /// [`Error::OutOfMemory`]; [`Error::Cancelled`].
    pub fn meet(&self, other: &Surface<'_>, options: &Options, job: &Job<'_>) -> Result<Paths> {
        let chord = positive_or_default("chord", options.chord, 1e-4 * self.box_diagonal().min(other.box_diagonal()))?;
        let tolerance = positive_or_default("tolerance", options.tolerance, self.tolerance().min(other.tolerance()))?;
        Error::require(tolerance.is_finite(), "tolerance", tolerance, "finite and above 0")?;
        let rounding = net_rounding_error(self.box_diagonal().max(other.box_diagonal()));
        let resolution = tolerance.min(self.tolerance().min(other.tolerance())).max(8.0 * rounding);
        let pairs = self.candidate_cell_pairs(other, tolerance, &job.sub_job(0.0, 0.2))?;
        let origin = 0.5 * (self.bounds()[0] + self.bounds()[1]);
        let intersection = SurfaceIntersection {
            pair_places: PairPlaces { surfaces: [self, other], pairs: &pairs, origin },
            tolerance,
            resolution,
            max_lost_length: SHORTEST_ARC_IN_RESOLUTIONS * resolution,
            chord_tolerance: chord.max(resolution),
        };
        let pair_numbers = alloc::collect((0..pairs.len()).map(|k| k as u32))?;
        let pieces = intersection.solve_pairs(&pair_numbers, &job.sub_job(0.2, 0.9))?;
        let pieces = intersection.cut_overlapping_arcs(&pieces, &job.sub_job(0.9, 0.9))?.unwrap_or(pieces);
        let search = ContactSearch {
            surfaces: [self, other],
            pairs: &pairs,
            balls: &pieces.balls,
            origin,
            tolerance,
            resolution: intersection.resolution,
        };
        let critical = search.resolve_clusters(&job.sub_job(0.9, 0.92))?;
        let chained = chain_arcs(
            &pieces,
            &critical,
            &intersection,
            [tolerance, intersection.resolution],
            &job.sub_job(0.92, 0.92),
        )?;
        let mut paths = intersection.build_paths(&pieces, &chained, &critical.points, &job.sub_job(0.92, 1.0))?;
        for (k, ball) in pieces.balls.iter().enumerate() {
            let is_explained = chained.is_ball_explained[k]
                || match critical.explanations[k] {
                    NOT_EXPLAINED => false,
                    EXPLAINED_AS_APART => true,
                    n => {
                        chained.crossings.is_joined_crossing[n as usize]
                            || critical.points[n as usize].gap.abs() <= tolerance
                    }
                };
            if is_explained {
                continue;
            }
            let [place, _] = intersection.pair_places.clamped_places(ball.pair, ball.parameters);
            alloc::push(&mut paths.unresolved, place)?;
        }
        alloc::extend(&mut paths.unresolved, intersection.loose_path_ends(&pieces, &chained))?;
        let cell = |place: &Place| (place.sheet, place.cell);
        sort::sort_stable(&mut paths.unresolved, &|a, b| cell(a).cmp(&cell(b)));
        paths.unresolved.dedup_by_key(|place| cell(place));
        for point in critical.points.iter().filter(|point| point.gap.abs() <= tolerance) {
            alloc::push(&mut paths.contacts, intersection.contact_at(point))?;
        }
        Ok(paths)
    }
}

/// Two surfaces to intersect.
struct SurfaceIntersection<'a> {
    pair_places: PairPlaces<'a>,
    tolerance: f64,
    /// Accuracy of the ends of arcs: the surfaces' own tolerance, if the option is greater.
    resolution: f64,
    /// Length up to which arcs may be lost.
    max_lost_length: f64,
    chord_tolerance: f64,
}

/// For the row and the column of a cell, whether the sheet has another cell before and after it.
fn cell_has_neighbours(sheet: &Sheet<'_>, cell: [u32; 2]) -> [[bool; 2]; 2] {
    let (cells, seams) = (sheet.cells(), sheet.has_exact_seams());
    match sheet {
        Sheet::Grid(_) => [0, 1].map(|k| [seams[k] || cell[k] > 0, seams[k] || (cell[k] as usize) < cells[k] - 1]),
        // Sides of given patches may differ slightly, so each patch keeps its own.
        Sheet::Cubic(_) | Sheet::High(_) => [[false; 2]; 2],
    }
}

/// Bound of the rounding error of coordinate nets up to `size`, and of their halves.
fn net_rounding_error(size: f64) -> f64 {
    16.0 * f64::EPSILON * size
}

impl IntersectedSurfaces for SurfaceIntersection<'_> {
    fn sheets_of_pair(&self, pair: u32) -> [u32; 2] {
        self.pair_places.pairs[pair as usize].sheets
    }

    fn cell_of_first_surface(&self, pair: u32) -> [u32; 2] {
        self.pair_places.pairs[pair as usize].cells[0]
    }

    fn point_of_pair(&self, pair: u32, x: DVec4) -> DVec3 {
        self.pair_places.point_of_first_surface(pair, x)
    }

    fn is_chord_near_surfaces(&self, [from, to]: [DVec3; 2]) -> bool {
        let is_near = |point: DVec3, of: &Surface<'_>| {
            of.closest(self.pair_places.origin + point, self.chord_tolerance).is_some()
        };
        let near = |point: DVec3| self.pair_places.surfaces.iter().all(|surface| is_near(point, surface));
        [0.5, 0.25, 0.75].into_iter().all(|part| near(from.lerp(to, part)))
    }
}

impl SurfaceIntersection<'_> {
    /// Finds the arcs of some pairs of cells, in the order of the pairs.
    fn solve_pairs(&self, pairs: &[u32], job: &Job<'_>) -> Result<FoundArcsAndBalls> {
        let mut pieces = FoundArcsAndBalls::default();
        self.solve_pairs_within_box_limit(
            pairs,
            MAX_BOXES_BEFORE_POSTPONING,
            false,
            &mut pieces,
            &job.sub_job(0.0, 0.8),
        )?;
        let again = std::mem::take(&mut pieces.exhausted_pairs);
        if !again.is_empty() {
            let max_boxes =
                (MAX_POSTPONED_BOXES / again.len()).clamp(MAX_BOXES_BEFORE_POSTPONING, MAX_BOXES_PER_POSTPONED_PAIR);
            self.solve_pairs_within_box_limit(&again, max_boxes, true, &mut pieces, &job.sub_job(0.8, 1.0))?;
            sort::sort_stable(&mut pieces.arcs, &|a, b| (a.pair, a.first_point).cmp(&(b.pair, b.first_point)));
            sort::sort_stable(&mut pieces.balls, &|a, b| a.pair.cmp(&b.pair));
        }
        Ok(pieces)
    }

    /// Adds the arcs of some pairs.
    fn solve_pairs_within_box_limit(
        &self,
        pairs: &[u32],
        max_boxes_per_pair: usize,
        is_last_round: bool,
        pieces: &mut FoundArcsAndBalls,
        job: &Job<'_>,
    ) -> Result<()> {
        let chunk = if is_last_round { 1 } else { PAIRS_PER_CHUNK };
        // Most pairs need one or two boxes. Postponed pairs may need all that are permitted.
        let batch = if is_last_round { BOXES_PER_REPORT.div_ceil(max_boxes_per_pair) } else { BOXES_PER_REPORT / 16 };
        for (k, part) in pairs.chunks(batch).enumerate() {
            let [from, to] = [k, k + 1].map(|k| ((k * batch) as f64 / pairs.len() as f64).min(1.0));
            let ranges = par::split_into_ranges(part.len(), chunk);
            let parts_found = par::map_jobs(&job.sub_job(from, to), "intersection", ranges, |range, job| {
                self.find_arcs_of_pairs(&part[range], max_boxes_per_pair, is_last_round, job)
            })?;
            parts_found.iter().try_for_each(|part| pieces.append_arcs(part))?;
        }
        Ok(())
    }

    /// Finds the arcs of some pairs of any sheets.
    fn find_arcs_of_pairs(
        &self,
        pairs: &[u32],
        max_boxes: usize,
        last: bool,
        job: &Job<'_>,
    ) -> Result<FoundArcsAndBalls> {
        let mut pieces = FoundArcsAndBalls::default();
        let sheets = |&k: &u32| self.pair_places.pairs[k as usize].sheets;
        for run in pairs.chunk_by(|k, n| sheets(k) == sheets(n)) {
            let [a, b] = sheets(&run[0]);
            let (one, other) =
                (self.pair_places.surfaces[0].sheet(a as usize), self.pair_places.surfaces[1].sheet(b as usize));
            let task = |k: u32, rounding_error: f64| self.pair_task(k, rounding_error, max_boxes, last);
            each_sheet!(one, cells_a => each_sheet!(other, cells_b => {
                self.solve_pairs_of_sheets(cells_a, cells_b, run, &task, &mut pieces, job)?;
            }));
        }
        Ok(pieces)
    }

    /// For the four parameters of pair k, whether the sheet has another cell before and after.
    fn pair_has_neighbours(&self, k: u32) -> [[bool; 2]; 4] {
        let CellPair { sheets: [a, b], cells: [p, q] } = self.pair_places.pairs[k as usize];
        let [one, other] =
            [self.pair_places.surfaces[0].sheet(a as usize), self.pair_places.surfaces[1].sheet(b as usize)];
        let ([s, t], [u, v]) = (cell_has_neighbours(one, p), cell_has_neighbours(other, q));
        [s, t, u, v]
    }

    /// The parameters for solving pair k.
    fn pair_task(&self, k: u32, rounding_error: f64, max_boxes: usize, last: bool) -> CellPairTask {
        let [tolerance, resolution] = [self.tolerance, self.resolution].map(|length| length.max(8.0 * rounding_error));
        let (neighbours, chord, shortest) =
            (self.pair_has_neighbours(k), self.chord_tolerance, self.max_lost_length.max(4.0 * rounding_error));
        CellPairTask {
            pair: k,
            neighbours,
            tolerance,
            resolution,
            max_lost_length: shortest,
            chord_tolerance: chord,
            max_boxes,
            is_last_round: last,
            rounding_error,
        }
    }

    /// Adds the arcs of pairs of two sheets.
    fn solve_pairs_of_sheets<const N: usize, const M: usize>(
        &self,
        a: &impl SheetCells<N>,
        b: &impl SheetCells<M>,
        pairs: &[u32],
        task: &impl Fn(u32, f64) -> CellPairTask,
        pieces: &mut FoundArcsAndBalls,
        job: &Job<'_>,
    ) -> Result<()> {
        let mut whole = ParameterBox::<N, M>::WHOLE_PATCHES;
        let (mut last, mut size_a) = (None, 0.0);
        for &k in pairs {
            let [p, q] = self.pair_places.pairs[k as usize].cells;
            // Pairs with the same cell of A are successive.
            if last != Some(p) {
                (whole.nets.a, size_a) =
                    CoordinateNet::new(&a.cell_patch(p[0] as usize, p[1] as usize), self.pair_places.origin);
                last = Some(p);
            }
            let size_b;
            (whole.nets.b, size_b) =
                CoordinateNet::new(&b.cell_patch(q[0] as usize, q[1] as usize), self.pair_places.origin);
            task(k, net_rounding_error(size_a.max(size_b))).solve_pair(&whole, pieces, job)?;
        }
        Ok(())
    }

    /// Cuts arcs along sides where other arcs on the same side end. Returns `None` if nothing was
    /// cut.
    fn cut_overlapping_arcs(&self, pieces: &FoundArcsAndBalls, job: &Job<'_>) -> Result<Option<FoundArcsAndBalls>> {
        let (resolution, chord) = (self.resolution, self.chord_tolerance);
        OverlappingArcs { arcs_and_balls: pieces, pair_places: &self.pair_places, resolution, chord_tolerance: chord }
            .cut_arcs_along_sides(job)
    }

    /// The ends of paths that are not at the border of a sheet. Something is unresolved there.
    fn loose_path_ends(&self, pieces: &FoundArcsAndBalls, chained: &ChainedArcs) -> impl Iterator<Item = Place> {
        let open = chained.chains.iter().filter(|chain| !chain.closed);
        let ends = open.flat_map(|chain| [(chain.arcs[0], 0), (chain.arcs[chain.arcs.len() - 1], 1)]);
        ends.filter_map(|(arc, k)| {
            let IntersectionArc { pair, first_point: from, end_point: to, at_border, .. } = pieces.arcs[arc as usize];
            let x = pieces.points[[from, to - 1][k] as usize];
            (!at_border[k] && !self.may_continue_to_border(pair, x))
                .then(|| self.pair_places.clamped_places(pair, x)[0])
        })
    }

    /// Whether a curve that ends here may continue to the border of a sheet in an arc too short to
    /// be found.
    fn may_continue_to_border(&self, pair: u32, x: DVec4) -> bool {
        let neighbours = self.pair_has_neighbours(pair);
        let columns = self.pair_places.origin_and_frame_at(pair, x).1.derivatives;
        (0..4).any(|k| {
            let near = |away: f64, side: usize| !neighbours[k][side] && away * columns[k].length() <= self.resolution;
            near(x[k], 0) || near(1.0 - x[k], 1)
        })
    }

    fn contact_at(&self, point: &CriticalPoint) -> Contact {
        let [place, other] = self.pair_places.clamped_places(point.pair, point.parameters);
        let kind = if point.is_saddle { ContactKind::Crossing } else { ContactKind::Point };
        Contact { kind, place, other, gap: point.gap, radius: point.radius }
    }

    /// Converts chains of arcs to paths, with the critical points they pass through.
    fn build_paths(
        &self,
        pieces: &FoundArcsAndBalls,
        chained: &ChainedArcs,
        critical: &[CriticalPoint],
        job: &Job<'_>,
    ) -> Result<Paths> {
        let chains = &chained.chains;
        let mut paths = Paths { ends: vec![0], ..Paths::default() };
        for (k, chain) in chains.iter().enumerate() {
            let arcs = || chain.arcs.iter().map(|&arc| &pieces.arcs[arc as usize]);
            // Joints within a pair of cells result from halving boxes, and are omitted. A curve of
            // few arcs needs them.
            let is_long =
                chain.arcs.len() > 8 && arcs().any(|arc| arc.pair != pieces.arcs[chain.arcs[0] as usize].pair);
            let mut last: Option<(u32, DVec3)> = None;
            for (n, arc) in arcs().enumerate() {
                if paths.places.len() & 0xffff == 0 {
                    job.step(k as f64 / chains.len() as f64, "paths")?;
                }
                let spare = |&(pair, point): &(u32, DVec3)| {
                    is_long && pair == arc.pair && point.distance(arc.ends[0]) < self.chord_tolerance
                };
                let skips = usize::from(last.as_ref().is_some_and(spare));
                if skips == 0 {
                    last = Some((arc.pair, arc.ends[0]));
                }
                let number = chain.arcs[n];
                let nodes = &chained.crossings.nodes;
                let node = nodes.binary_search_by_key(&number, |&(arc, _)| arc).ok();
                // The next arc begins at the end of this one.
                let ends_here = node.is_some() || n + 1 == chain.arcs.len() && !chain.closed;
                let points: Range<usize> =
                    arc.first_point as usize + skips..arc.end_point as usize - usize::from(!ends_here);
                for &x in &pieces.points[points] {
                    let [place, other] = self.pair_places.places_clamped_into_cells(arc.pair, x);
                    alloc::push(&mut paths.places, place)?;
                    alloc::push(&mut paths.others, other)?;
                }
                if let Some(node) = node {
                    let CriticalPoint { pair, parameters: x, .. } = critical[nodes[node].1 as usize];
                    let [place, other] = self.pair_places.clamped_places(pair, x);
                    alloc::push(&mut paths.places, place)?;
                    alloc::push(&mut paths.others, other)?;
                    last = None;
                }
            }
            alloc::push(&mut paths.ends, paths.places.len() as u32)?;
            alloc::push(&mut paths.closed, chain.closed)?;
        }
        self.evaluate_paths(&mut paths)?;
        let size = self.pair_places.surfaces.map(Surface::box_diagonal);
        paths.drop_repeated_points(net_rounding_error(size[0].max(size[1])));
        Ok(paths)
    }

    /// Evaluates points and normals at the places of paths.
    fn evaluate_paths(&self, paths: &mut Paths) -> Result<()> {
        paths.levels = alloc::filled(0, paths.len())?;
        paths.points = alloc::with_capacity(paths.places.len())?;
        paths.normals = alloc::with_capacity(paths.places.len())?;
        for run in paths.places.chunk_by(|p, q| (p.sheet, p.cell) == (q.sheet, q.cell)) {
            let (sheet, [i, j]) = (self.pair_places.surfaces[0].sheet(run[0].sheet as usize), run[0].cell);
            each_sheet!(sheet, cells => {
                let patch = SheetCells::cell_patch(cells, i as usize, j as usize);
                for &place in run {
                    let jet = patch.jet(place.u, place.v);
                    paths.points.push(jet.point);
                    paths.normals.push(self.pair_places.surfaces[0].normal_with_known_jet(place, &jet));
                }
            });
        }
        Ok(())
    }
}
