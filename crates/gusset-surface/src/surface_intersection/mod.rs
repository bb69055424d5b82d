//! Task e) of the paper: where two surfaces meet.
//!
//! 1. Pairs of cells that may meet are found by descending both pyramids together (`pairs`).
//! 2. Over a pair the points with A(s, t) = B(u, v) are curves in the four parameters. A box of
//!    parameters is excluded, or proved to have a graph (`chart`), whose arc is followed from side
//!    to side (`arc`); else it is halved (`solve`).
//! 3. Unresolved boxes are clustered, and clusters resolved by the relative second form (`contact`,
//!    `graph`): points where the surfaces touch, and points where branches cross.
//! 4. Arcs are chained (`intersection_chain`, `links`), through crossings and across unresolved places too
//!    (`bridge`).
//!
//! Proved: every point that the declared surfaces have in common lies in a pair of cells of step 1,
//! and in a box that has an arc through it, or is shorter than the resolution, or is within the
//! radius of a contact, or is reported as unresolved. Bounds are computed in double precision, with
//! room for rounding (`rounding_error`).
//! One thing is judged by points and not proved: whether a curve that is nearer than a thousandth
//! of the resolution to a side of a box runs along it, touches it or crosses it, which decides
//! between the boxes on both sides. One that runs along a side is found from both, and kept once
//! (`overlap`).
//!
//! Where one surface meets itself: `itself`, by the same steps, but for cells that have points in
//! common (`joints`, `near`, `poles`), and for the way in which arcs are joined (`trails`).

mod arc;
mod arc_refinement;
mod bridge;
mod chart;
mod contact;
mod coordinate_net;
mod equation;
mod graph;
mod intersection_chain;
mod itself;
mod joints;
mod links;
mod near;
mod overlap;
mod pairs;
mod places;
mod poles;
mod solve;
mod trails;

use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_base::{alloc, par};
pub use pairs::{CellPair, MAX_PAIRS};

use super::cells::Cells;
use super::path::{Contact, ContactKind};
use super::{Paths, Place, Sheet, Surface, each_sheet};
use bridge::Surroundings;
use chart::ParameterBox;
use contact::{APART, ContactSearch, CriticalPoint, UNRESOLVED};
use coordinate_net::Net;
use glam::{DVec3, DVec4};
use intersection_chain::{Chained, chains};
use overlap::Overlaps;
use places::PairPlaces;
use solve::{Arc, FoundArcs, PairTask};
use std::ops::Range;

/// Pairs of cells that one thread takes at a time.
const PAIRS_PER_CHUNK: usize = 32;
/// Boxes of parameters examined between two steps of the job.
const BOXES_PER_STEP: usize = 1 << 16;
/// Boxes examined for a pair of cells before it is put back.
const FIRST_MAX_BOXES: usize = 256;
/// Boxes examined for all the pairs that were put back: shared among them, but each gets
/// [`FIRST_MAX_BOXES`] again at least.
const SECOND_TOTAL_BOXES: usize = 1 << 22;
/// The most for one of them.
const SECOND_MAX_BOXES: usize = 1 << 17;

/// Arcs that may be lost, in resolutions: those of many boxes in a row, as at poles, are less than
/// that together.
const SHORTEST_ARC_SHARE: f64 = 1.0 / 32.0;

/// How intersections are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// The greatest distance of the curve from the chords between its points; `None`: 1e-4 of the
    /// diagonal of the smaller surface's box; infinity: points are only where it crosses sides of
    /// cells of either surface.
    pub chord: Option<f64>,
    /// Surfaces that are apart, or overlap, by no more than this all over touch there. Branches are
    /// found and told apart by the smaller one of the surfaces' own tolerances, if this is not
    /// smaller yet: shorter ones may be lost. `None`: that one.
    pub tolerance: Option<f64>,
}

/// The value, which must be positive, or the default.
fn positive(option: &'static str, value: Option<f64>, default: f64) -> Result<f64> {
    match value {
        Some(value) if value.is_nan() || value <= 0.0 => Err(Error::OptionOutOfRange { option, value }),
        _ => Ok(value.unwrap_or(default)),
    }
}

impl Surface<'_> {
    /// The curves in which two surfaces meet: `places` on this one, `others` on the other one; they
    /// run along N_A x N_B, closed ones closed. Every branch is found that is longer
    /// than the tolerance, or the surfaces' own if that is smaller, and not part of a contact.
    ///
    /// Where the surfaces touch in a point, or two branches cross, to the tolerance, the point is
    /// in `contacts`: if they are graphs over a plane there whose second derivatives differ by a
    /// definite or an indefinite form, proved over all that is not resolved otherwise. Surfaces
    /// that overlap by more than the tolerance have a curve there, and those that are farther apart
    /// have nothing. What is within the contact's radius, at most some four times the root of twice
    /// the tolerance over the least curvature of that difference, is left out, and a path that
    /// comes to it goes straight to its point. As N_A x N_B points to a crossing and away from it
    /// in turn, paths turn there: each of the four branches is joined with the neighbour that leads
    /// back to it, so that a figure of eight is two closed paths with one point in common; else as
    /// straight as can be.
    ///
    /// Cells of this surface where the two touch along a curve, at a pole, at the border of a
    /// sheet, or to a higher order, or coincide, are in `unresolved`, and curves may end there; they are
    /// joined across such a place where a chord is as near to both surfaces as elsewhere. The
    /// points are those of this surface; the other one's are the same but for rounding, and but for
    /// the tolerance at crossings.
    ///
    /// Work and memory in proportion to the pairs of cells that may be within the tolerance of each
    /// other, with a limit for each; where surfaces coincide there are many. For where one surface
    /// meets itself see [`Surface::meet_itself`]: each surface is taken as it is here.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`]; [`Error::TooLarge`] above [`MAX_PAIRS`] pairs of cells;
    /// [`Error::OutOfMemory`]; [`Error::Cancelled`].
    pub fn meet(&self, other: &Surface<'_>, options: &Options, job: &Job<'_>) -> Result<Paths> {
        let chord = positive("chord", options.chord, 1e-4 * self.diagonal().min(other.diagonal()))?;
        let tolerance = positive("tolerance", options.tolerance, self.tolerance().min(other.tolerance()))?;
        Error::require(tolerance.is_finite(), "tolerance", tolerance)?;
        let rounding = rounding_error(self.diagonal().max(other.diagonal()));
        let resolution = tolerance.min(self.tolerance().min(other.tolerance())).max(8.0 * rounding);
        let pairs = self.candidates(other, tolerance, &job.part(0.0, 0.2))?;
        let origin = 0.5 * (self.bounds()[0] + self.bounds()[1]);
        let intersection = Intersection {
            places: PairPlaces { surfaces: [self, other], pairs: &pairs, origin },
            tolerance,
            resolution,
            shortest: SHORTEST_ARC_SHARE * resolution,
            chord: chord.max(resolution),
        };
        let all = alloc::collect((0..pairs.len()).map(|k| k as u32))?;
        let pieces = intersection.solve(&all, &job.part(0.2, 0.9))?;
        let pieces = intersection.cut_overlaps(&pieces, &job.part(0.9, 0.9))?.unwrap_or(pieces);
        let search = ContactSearch {
            surfaces: [self, other],
            pairs: &pairs,
            balls: &pieces.balls,
            origin,
            tolerance,
            resolution: intersection.resolution,
        };
        let critical = search.run(&job.part(0.9, 0.92))?;
        let chained =
            chains(&pieces, &critical, &intersection, [tolerance, intersection.resolution], &job.part(0.92, 0.92))?;
        let mut paths = intersection.paths(&pieces, &chained, &critical.points, &job.part(0.92, 1.0))?;
        for (k, ball) in pieces.balls.iter().enumerate() {
            let is_explained = chained.passed[k]
                || match critical.of_ball[k] {
                    UNRESOLVED => false,
                    APART => true,
                    n => chained.crossings.joined[n as usize] || critical.points[n as usize].gap.abs() <= tolerance,
                };
            if is_explained {
                continue;
            }
            let [place, _] = intersection.places.places(ball.pair, ball.x);
            alloc::push(&mut paths.unresolved, place)?;
        }
        alloc::extend(&mut paths.unresolved, intersection.loose_ends(&pieces, &chained))?;
        let cell = |place: &Place| (place.sheet, place.cell);
        sort::stable(&mut paths.unresolved, &|a, b| cell(a).cmp(&cell(b)));
        paths.unresolved.dedup_by_key(|place| cell(place));
        for point in critical.points.iter().filter(|point| point.gap.abs() <= tolerance) {
            alloc::push(&mut paths.contacts, intersection.contact(point))?;
        }
        Ok(paths)
    }
}

/// Two surfaces that are intersected.
struct Intersection<'a> {
    places: PairPlaces<'a>,
    tolerance: f64,
    /// How exactly ends of arcs are known: the surfaces' own tolerance, if the one that is asked for
    /// is greater.
    resolution: f64,
    /// Arcs up to this may be lost.
    shortest: f64,
    chord: f64,
}

/// For rows and columns of a sheet, whether another cell is below and above one of them.
fn neighbours(sheet: &Sheet<'_>, cell: [u32; 2]) -> [[bool; 2]; 2] {
    let (cells, seams) = (sheet.cells(), sheet.seams());
    match sheet {
        Sheet::Grid(_) => [0, 1].map(|k| [seams[k] || cell[k] > 0, seams[k] || (cell[k] as usize) < cells[k] - 1]),
        // The sides of patches that are given may differ a little: each patch keeps its own.
        Sheet::Cubic(_) | Sheet::High(_) => [[false; 2]; 2],
    }
}

/// What nets of coordinates up to `size`, and their halvings, may be off by.
fn rounding_error(size: f64) -> f64 {
    16.0 * f64::EPSILON * size
}

impl Surroundings for Intersection<'_> {
    fn sheets(&self, pair: u32) -> [u32; 2] {
        self.places.pairs[pair as usize].sheets
    }

    fn cell(&self, pair: u32) -> [u32; 2] {
        self.places.pairs[pair as usize].cells[0]
    }

    fn point(&self, pair: u32, x: DVec4) -> DVec3 {
        self.places.point(pair, x)
    }

    fn contain(&self, [from, to]: [DVec3; 2]) -> bool {
        let is_near = |point: DVec3, of: &Surface<'_>| of.closest(self.places.origin + point, self.chord).is_some();
        let near = |point: DVec3| self.places.surfaces.iter().all(|surface| is_near(point, surface));
        [0.5, 0.25, 0.75].into_iter().all(|part| near(from.lerp(to, part)))
    }
}

impl Intersection<'_> {
    /// The arcs of some of the pairs, in their order.
    fn solve(&self, which: &[u32], job: &Job<'_>) -> Result<FoundArcs> {
        let mut pieces = FoundArcs::default();
        self.solve_all(which, FIRST_MAX_BOXES, false, &mut pieces, &job.part(0.0, 0.8))?;
        let again = std::mem::take(&mut pieces.exhausted);
        if !again.is_empty() {
            let max_boxes = (SECOND_TOTAL_BOXES / again.len()).clamp(FIRST_MAX_BOXES, SECOND_MAX_BOXES);
            self.solve_all(&again, max_boxes, true, &mut pieces, &job.part(0.8, 1.0))?;
            sort::stable(&mut pieces.arcs, &|a, b| (a.pair, a.from).cmp(&(b.pair, b.from)));
            sort::stable(&mut pieces.balls, &|a, b| a.pair.cmp(&b.pair));
        }
        Ok(pieces)
    }

    /// Adds the arcs of some of the pairs.
    fn solve_all(
        &self,
        which: &[u32],
        max_boxes: usize,
        last: bool,
        pieces: &mut FoundArcs,
        job: &Job<'_>,
    ) -> Result<()> {
        let chunk = if last { 1 } else { PAIRS_PER_CHUNK };
        // Most pairs take a box or two, those that are done again all they may.
        let batch = if last { BOXES_PER_STEP.div_ceil(max_boxes) } else { BOXES_PER_STEP / 16 };
        for (k, part) in which.chunks(batch).enumerate() {
            let [from, to] = [k, k + 1].map(|k| ((k * batch) as f64 / which.len() as f64).min(1.0));
            let ranges = par::ranges(part.len(), chunk);
            let found = par::map_jobs(&job.part(from, to), "intersection", ranges, |range, job| {
                self.chunk(&part[range], max_boxes, last, job)
            })?;
            found.iter().try_for_each(|found| pieces.append(found))?;
        }
        Ok(())
    }

    /// The arcs of some pairs, whichever their sheets are.
    fn chunk(&self, which: &[u32], max_boxes: usize, last: bool, job: &Job<'_>) -> Result<FoundArcs> {
        let mut pieces = FoundArcs::default();
        let sheets = |&k: &u32| self.places.pairs[k as usize].sheets;
        for run in which.chunk_by(|k, n| sheets(k) == sheets(n)) {
            let [a, b] = sheets(&run[0]);
            let (one, other) = (self.places.surfaces[0].sheet(a as usize), self.places.surfaces[1].sheet(b as usize));
            let task = |k: u32, rounding_error: f64| self.task(k, rounding_error, max_boxes, last);
            each_sheet!(one, cells_a => each_sheet!(other, cells_b => {
                self.run(cells_a, cells_b, run, &task, &mut pieces, job)?;
            }));
        }
        Ok(pieces)
    }

    /// For the parameters of pair k, whether another cell is below and above.
    fn neighbours(&self, k: u32) -> [[bool; 2]; 4] {
        let CellPair { sheets: [a, b], cells: [p, q] } = self.places.pairs[k as usize];
        let [one, other] = [self.places.surfaces[0].sheet(a as usize), self.places.surfaces[1].sheet(b as usize)];
        let ([s, t], [u, v]) = (neighbours(one, p), neighbours(other, q));
        [s, t, u, v]
    }

    /// How pair k is to be solved.
    fn task(&self, k: u32, rounding_error: f64, max_boxes: usize, last: bool) -> PairTask {
        let [tolerance, resolution] = [self.tolerance, self.resolution].map(|length| length.max(8.0 * rounding_error));
        let (neighbours, chord, shortest) = (self.neighbours(k), self.chord, self.shortest.max(4.0 * rounding_error));
        PairTask { pair: k, neighbours, tolerance, resolution, shortest, chord, max_boxes, last, rounding_error }
    }

    /// The arcs of pairs of two sheets.
    fn run<const N: usize, const M: usize>(
        &self,
        a: &impl Cells<N>,
        b: &impl Cells<M>,
        which: &[u32],
        task: &impl Fn(u32, f64) -> PairTask,
        pieces: &mut FoundArcs,
        job: &Job<'_>,
    ) -> Result<()> {
        let mut whole = ParameterBox::<N, M>::WHOLE;
        let (mut last, mut size_a) = (None, 0.0);
        for &k in which {
            let [p, q] = self.places.pairs[k as usize].cells;
            // Pairs of one cell of A follow each other.
            if last != Some(p) {
                (whole.nets.a, size_a) = Net::new(&a.patch(p[0] as usize, p[1] as usize), self.places.origin);
                last = Some(p);
            }
            let size_b;
            (whole.nets.b, size_b) = Net::new(&b.patch(q[0] as usize, q[1] as usize), self.places.origin);
            task(k, rounding_error(size_a.max(size_b))).solve(&whole, pieces, job)?;
        }
        Ok(())
    }

    /// The arcs, those along sides that others share cut where these end; `None` if they are as
    /// they were.
    fn cut_overlaps(&self, pieces: &FoundArcs, job: &Job<'_>) -> Result<Option<FoundArcs>> {
        let (resolution, chord) = (self.resolution, self.chord);
        Overlaps { pieces, places: &self.places, resolution, chord }.cut(job)
    }

    /// Where paths end, but not at the border of a sheet: something is not resolved there.
    fn loose_ends(&self, pieces: &FoundArcs, chained: &Chained) -> impl Iterator<Item = Place> {
        let open = chained.chains.iter().filter(|chain| !chain.closed);
        let ends = open.flat_map(|chain| [(chain.arcs[0], 0), (chain.arcs[chain.arcs.len() - 1], 1)]);
        ends.filter_map(|(arc, k)| {
            let Arc { pair, from, to, at_border, .. } = pieces.arcs[arc as usize];
            let x = pieces.points[[from, to - 1][k] as usize];
            (!at_border[k] && !self.is_near_border(pair, x)).then(|| self.places.places(pair, x)[0])
        })
    }

    /// Whether a curve that ends there may have been lost on the way to the border of a sheet.
    fn is_near_border(&self, pair: u32, x: DVec4) -> bool {
        let neighbours = self.neighbours(pair);
        let columns = self.places.frame(pair, x).1.columns;
        (0..4).any(|k| {
            let near = |away: f64, side: usize| !neighbours[k][side] && away * columns[k].length() <= self.resolution;
            near(x[k], 0) || near(1.0 - x[k], 1)
        })
    }

    fn contact(&self, point: &CriticalPoint) -> Contact {
        let [place, other] = self.places.places(point.pair, point.x);
        let kind = if point.is_saddle { ContactKind::Crossing } else { ContactKind::Point };
        Contact { kind, place, other, gap: point.gap, radius: point.radius }
    }

    /// The points of chains of arcs, with the critical points that they pass.
    fn paths(&self, pieces: &FoundArcs, chained: &Chained, critical: &[CriticalPoint], job: &Job<'_>) -> Result<Paths> {
        let chains = &chained.chains;
        let mut paths = Paths { ends: vec![0], ..Paths::default() };
        for (k, chain) in chains.iter().enumerate() {
            let arcs = || chain.arcs.iter().map(|&arc| &pieces.arcs[arc as usize]);
            // Joints within a pair of cells are where boxes were halved; a curve of few arcs needs
            // them all the same.
            let is_long =
                chain.arcs.len() > 8 && arcs().any(|arc| arc.pair != pieces.arcs[chain.arcs[0] as usize].pair);
            let mut last: Option<(u32, DVec3)> = None;
            for (n, arc) in arcs().enumerate() {
                if paths.places.len() & 0xffff == 0 {
                    job.step(k as f64 / chains.len() as f64, "paths")?;
                }
                let spare = |&(pair, point): &(u32, DVec3)| {
                    is_long && pair == arc.pair && point.distance(arc.ends[0]) < self.chord
                };
                let skips = usize::from(last.as_ref().is_some_and(spare));
                if skips == 0 {
                    last = Some((arc.pair, arc.ends[0]));
                }
                let number = chain.arcs[n];
                let nodes = &chained.crossings.nodes;
                let node = nodes.binary_search_by_key(&number, |&(arc, _)| arc).ok();
                // Where the next arc begins is where this one ends.
                let ends_here = node.is_some() || n + 1 == chain.arcs.len() && !chain.closed;
                let points: Range<usize> = arc.from as usize + skips..arc.to as usize - usize::from(!ends_here);
                for &x in &pieces.points[points] {
                    let [place, other] = self.places.places_inside(arc.pair, x);
                    alloc::push(&mut paths.places, place)?;
                    alloc::push(&mut paths.others, other)?;
                }
                if let Some(node) = node {
                    let CriticalPoint { pair, x, .. } = critical[nodes[node].1 as usize];
                    let [place, other] = self.places.places(pair, x);
                    alloc::push(&mut paths.places, place)?;
                    alloc::push(&mut paths.others, other)?;
                    last = None;
                }
            }
            alloc::push(&mut paths.ends, paths.places.len() as u32)?;
            alloc::push(&mut paths.closed, chain.closed)?;
        }
        self.evaluate(&mut paths)?;
        let size = self.places.surfaces.map(Surface::diagonal);
        paths.drop_repeats(rounding_error(size[0].max(size[1])));
        Ok(paths)
    }

    /// The points and normals at the places of paths.
    fn evaluate(&self, paths: &mut Paths) -> Result<()> {
        paths.levels = alloc::filled(0, paths.len())?;
        paths.points = alloc::with_capacity(paths.places.len())?;
        paths.normals = alloc::with_capacity(paths.places.len())?;
        for run in paths.places.chunk_by(|p, q| (p.sheet, p.cell) == (q.sheet, q.cell)) {
            let (sheet, [i, j]) = (self.places.surfaces[0].sheet(run[0].sheet as usize), run[0].cell);
            each_sheet!(sheet, cells => {
                let patch = Cells::patch(cells, i as usize, j as usize);
                for &place in run {
                    let jet = patch.jet(place.u, place.v);
                    paths.points.push(jet.point);
                    paths.normals.push(self.places.surfaces[0].normal_by(place, &jet));
                }
            });
        }
        Ok(())
    }
}
