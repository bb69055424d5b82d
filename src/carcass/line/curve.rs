//! Where a curve meets the surface.
//!
//! Parts of the curve go down the index together with blocks of cells: of the two the larger is divided, and what is apart is dropped. What
//! a part of the curve and a cell have in common, `solve` finds with proof.

use super::search::Scratch;
use super::{Line, Which};
use crate::alloc;
use crate::carcass::cells::{BLOCK, Cells};
use crate::carcass::index::{Bounds, Pyramid};
use crate::carcass::solve::{Crossings, Room, Spot, crossings, halved};
use crate::carcass::{Carcass, Place, each_sheet};
use crate::error::{Error, Result};
use crate::job::Job;
use crate::outline::{CurveView, Place as CurvePlace};
use crate::par;
use glam::DVec3;

/// A point that a curve and a surface have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurveHit {
    /// Where on the curve.
    pub at: CurvePlace,
    /// From where to where the curve cannot be told from the surface, within the tolerance: twice the same where it passes through.
    pub span: [CurvePlace; 2],
    /// Where on the surface.
    pub place: Place,
    /// The point of the surface.
    pub point: DVec3,
    /// The unit normal there, or its limit at a pole; 0 if there is none.
    pub normal: DVec3,
    /// True if the curve touches the surface there, or nearly, or runs in it.
    pub tangent: bool,
    /// How often the hit counts: 1 where the curve passes through, 2 where it touches, 0 where it runs in the surface.
    pub multiplicity: u32,
}

/// A hit as one cell has it.
#[derive(Debug, Clone, Copy)]
struct Find {
    /// The segment and the parameter on it, as one number each.
    at: f64,
    span: [f64; 2],
    /// Where the curve is at the ends of the span, and how long it is.
    ends: [DVec3; 2],
    length: f64,
    place: Place,
    point: DVec3,
    tangent: bool,
}

/// The highest degree of a segment.
const MOST: usize = 7;
/// Segments that one thread takes at once.
const BATCH: usize = 64;
/// Finds on the same curve whose parameters differ by no more may be one.
const SAME: f64 = 1e-6;

impl Carcass<'_> {
    /// Where a curve meets the surface, in the order of the curve.
    ///
    /// A point at a joint of segments, on a side between cells or sheets, or at a pole is found once. None is missed: where touching or
    /// coincidence cannot be resolved, a hit is given for each such spot and marked tangent. About O(log cells) for each cell that the curve
    /// comes near to; bounded for each cell and segment that run in each other. The segments are shared out to the job's threads.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a segment of a degree above 7, [`Error::EmptyCurve`], [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn curve(&self, curve: &CurveView<'_>, which: Which, job: &Job<'_>) -> Result<Vec<CurveHit>> {
        if curve.is_empty() {
            return Err(Error::EmptyCurve);
        }
        if let Some(segment) = curve.segments().find(|segment| segment.len() > MOST + 1) {
            return Err(Error::OptionOutOfRange { option: "degree", value: (segment.len() - 1) as f64 });
        }
        let finds = self.finds(curve, which, job)?;
        let mut hits = self.hits(curve, finds)?;
        if which == Which::First && hits.first().is_some_and(|hit| hit.tangent) {
            // What belongs to the spot may go on.
            hits = self.hits(curve, self.finds(curve, Which::All, job)?)?;
        }
        if which != Which::All {
            hits.truncate(1);
        }
        Ok(hits)
    }

    /// The finds of all segments, or of the first ones up to some that have any.
    fn finds(&self, curve: &CurveView<'_>, which: Which, job: &Job<'_>) -> Result<Vec<Find>> {
        let mut finds = Vec::new();
        let count = curve.len();
        let round = BATCH * par::at_most(count.div_ceil(BATCH), job.threads());
        for from in (0..count).step_by(round) {
            job.step(from as f64 / count as f64, "curve and surface")?;
            let to = count.min(from + round);
            for part in par::chunks(job.threads(), to - from, BATCH, |range| {
                let mut finder = Finder::default();
                range.for_each(|k| self.segment(from + k, curve.segment(from + k), &mut finder));
                finder.finds
            }) {
                alloc::append(&mut finds, &part)?;
            }
            if which != Which::All && !finds.is_empty() {
                break;
            }
        }
        Ok(finds)
    }

    /// Adds the finds of segment k.
    fn segment(&self, k: usize, controls: &[DVec3], finder: &mut Finder) {
        if controls.iter().all(|&point| point == controls[0]) {
            // No more than the ends of its neighbours.
            return;
        }
        match controls.len() {
            2 => self.straight(k, [controls[0], controls[1]], finder),
            3 | 4 => self.curved::<4>(k, controls, finder),
            _ => self.curved::<8>(k, controls, finder),
        }
    }

    fn straight(&self, k: usize, [a, b]: [DVec3; 2], finder: &mut Finder) {
        self.search_line(&Line::segment(a, b), Which::All, &mut finder.lines);
        for hit in &finder.lines.hits {
            let ends = hit.span.map(|t| a.lerp(b, t));
            finder.finds.push(Find {
                at: k as f64 + hit.t,
                span: hit.span.map(|t| k as f64 + t),
                ends,
                length: ends[0].distance(ends[1]),
                place: hit.place,
                point: hit.point,
                tangent: hit.tangent,
            });
        }
    }

    fn curved<const M: usize>(&self, k: usize, controls: &[DVec3], finder: &mut Finder) {
        let part = Part { points: raised::<M>(controls), from: 0.0, size: 1.0 };
        for sheet in 0..self.len() {
            let (kind, index) = self.indexed(sheet);
            each_sheet!(kind, cells => {
                let search = Search { cells, index, sheet: sheet as u32, segment: k, tolerance: self.tolerance() };
                search.run(&part, &mut Room::default(), &mut finder.finds);
            });
        }
    }

    /// Makes hits of finds: each once, in the order of the curve.
    fn hits(&self, curve: &CurveView<'_>, mut finds: Vec<Find>) -> Result<Vec<CurveHit>> {
        finds.sort_unstable_by(|a, b| {
            let by_place = |place: &Place| (place.sheet, place.cell);
            a.at.total_cmp(&b.at).then_with(|| by_place(&a.place).cmp(&by_place(&b.place)))
        });
        let reach = self.reach();
        let mut kept: Vec<Find> = alloc::with_capacity(finds.len())?;
        for find in finds {
            let near = kept.iter_mut().rev().take_while(|other| other.tangent || find.at - other.at <= SAME);
            match { near }.find(|other| is_same(other, &find, reach)) {
                Some(other) => other.join(&find),
                None => kept.push(find),
            }
        }
        // A closed curve's end is its start.
        let round = curve.len() as f64;
        if let [first, .., last] = &mut kept[..]
            && curve.is_closed()
            && !first.tangent
            && !last.tangent
            && last.at - round + SAME >= first.at
            && first.point.distance(last.point) <= reach
        {
            kept.pop();
        }
        alloc::collect(kept.iter().map(|find| self.hit(curve, find)))
    }

    fn hit(&self, curve: &CurveView<'_>, find: &Find) -> CurveHit {
        let place = |at: f64| {
            let segment = (at as usize).min(curve.len() - 1);
            CurvePlace { segment: segment as u32, t: at - segment as f64 }
        };
        let normal = self.normal(find.place);
        let along = match curve.derivatives_at(&[place(find.at)], 1) {
            Ok(found) => found[1].normalize_or_zero(),
            Err(_) => DVec3::ZERO,
        };
        // At a pole, and not along the surface: it passes through.
        let pole = find.tangent && self.jet(find.place).unit_normal().is_none() && normal.dot(along).abs() > 1e-3;
        let runs_inside = find.length > self.longest_touch();
        let passes = !find.tangent || (pole && !runs_inside);
        CurveHit {
            at: place(find.at),
            span: if passes { [find.at; 2] } else { find.span }.map(place),
            place: find.place,
            point: find.point,
            normal,
            tangent: !passes,
            multiplicity: if passes { 1 } else { 2 * u32::from(!runs_inside) },
        }
    }
}

impl Find {
    /// Takes in what another cell or segment has found of the same hit.
    fn join(&mut self, other: &Find) {
        self.length += other.length;
        if other.span[1] > self.span[1] {
            (self.span[1], self.ends[1]) = (other.span[1], other.ends[1]);
        }
        if other.span[0] < self.span[0] {
            (self.span[0], self.ends[0]) = (other.span[0], other.ends[0]);
        }
        let first = (other.place.sheet, other.place.cell) < (self.place.sheet, self.place.cell);
        if first && !self.tangent && other.at == self.at {
            (self.place, self.point) = (other.place, other.point);
        }
    }
}

/// True for two finds of one hit: the same place of the curve and of the surface, or spots that run into each other.
fn is_same(a: &Find, b: &Find, reach: f64) -> bool {
    if a.tangent != b.tangent {
        return false;
    }
    if !a.tangent {
        return (b.at - a.at).abs() <= SAME && a.point.distance(b.point) <= reach;
    }
    let overlap = b.span[0] <= a.span[1] && a.span[0] <= b.span[1];
    let near = |x: f64, y: f64, p: DVec3, q: DVec3| (x - y).abs() <= 1e-3 && p.distance(q) <= 2.0 * reach;
    overlap || near(a.span[1], b.span[0], a.ends[1], b.ends[0]) || near(a.span[0], b.span[1], a.ends[0], b.ends[1])
}

/// The control points of a segment, raised to degree M - 1.
pub(super) fn raised<const M: usize>(controls: &[DVec3]) -> [DVec3; M] {
    let mut points = [DVec3::ZERO; M];
    points[..controls.len()].copy_from_slice(controls);
    for n in controls.len()..M {
        points[n] = points[n - 1];
        for k in (1..n).rev() {
            points[k] = points[k].lerp(points[k - 1], k as f64 / n as f64);
        }
    }
    points
}

/// What one thread finds.
#[derive(Default)]
struct Finder {
    lines: Scratch,
    finds: Vec<Find>,
}

/// A part of a segment.
#[derive(Clone)]
struct Part<const M: usize> {
    points: [DVec3; M],
    from: f64,
    size: f64,
}

impl<const M: usize> Part<M> {
    fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        self.points.iter().for_each(|&point| bounds.add(point));
        bounds
    }
}

/// A part of a segment and a block of cells, which has a box of this diagonal.
struct Entry<const M: usize> {
    part: Part<M>,
    diagonal: f64,
    level: usize,
    row: usize,
    column: usize,
}

/// Parts below this size are not halved: the cells are so small then that the curve is all of one piece.
const LEAST: f64 = 1e-9;

/// The search of a sheet for a segment.
struct Search<'a, C> {
    cells: &'a C,
    index: &'a Pyramid,
    sheet: u32,
    segment: usize,
    tolerance: f64,
}

impl<C> Search<'_, C> {
    fn run<const M: usize, const N: usize>(&self, whole: &Part<M>, room: &mut Room<M, N>, finds: &mut Vec<Find>)
    where
        C: Cells<N>,
    {
        let origin = self.index.origin();
        let part = Part { points: whole.points.map(|point| point - origin), ..*whole };
        let (levels, bounds) = (self.index.levels(), self.index.bounds());
        let reach = bounds.low.abs().max(bounds.high.abs()).length();
        let noise = 8.0 * f64::EPSILON * (reach + part.points.iter().map(|point| point.length()).fold(0.0, f64::max));
        let diagonal = bounds.low.distance(bounds.high);
        let mut waiting = vec![Entry { part, diagonal, level: levels.len(), row: 0, column: 0 }];
        let mut found = Crossings::default();
        while let Some(entry) = waiting.pop() {
            let Entry { part, diagonal, level, row, column } = entry;
            let bounds = part.bounds().grown(noise);
            if bounds.low.distance(bounds.high) > 2.0 * diagonal && part.size > LEAST {
                for (half, points) in halved(&part.points).into_iter().enumerate() {
                    let size = 0.5 * part.size;
                    let part = Part { points, size, from: part.from + half as f64 * size };
                    if level == levels.len() || self.touches(&part, noise, level, row, column) {
                        waiting.push(Entry { part, diagonal, level, row, column });
                    }
                }
            } else if level == 0 {
                self.block(&part, row, column, noise, room, &mut found, finds);
            } else {
                for child in 0..4 {
                    let (row, column) = (2 * row + child / 2, 2 * column + child % 2);
                    if self.touches(&part, noise, level - 1, row, column) {
                        let child = levels[level - 1].group(row / 2, column / 2).get(child);
                        let diagonal = child.low.distance(child.high);
                        waiting.push(Entry { part: part.clone(), diagonal, level: level - 1, row, column });
                    }
                }
            }
        }
    }

    /// False if the part is apart from the boxes of block (row, column) of a level.
    fn touches<const M: usize>(&self, part: &Part<M>, noise: f64, level: usize, row: usize, column: usize) -> bool {
        let level = &self.index.levels()[level];
        let block = level.group(row / 2, column / 2).get(2 * (row % 2) + column % 2);
        !block.is_empty()
            && part.bounds().grown(noise).meets(&block)
            && level.oriented(row, column).is_none_or(|oriented| oriented.meets_hull(&part.points))
    }

    /// Adds what the cells of a block have.
    #[allow(clippy::too_many_arguments, reason = "the last three are room that is used again")]
    fn block<const M: usize, const N: usize>(
        &self,
        part: &Part<M>,
        row: usize,
        column: usize,
        noise: f64,
        room: &mut Room<M, N>,
        found: &mut Crossings,
        finds: &mut Vec<Find>,
    ) where
        C: Cells<N>,
    {
        let [rows, columns] = self.cells.counts();
        let origin = self.index.origin();
        let deviation = self.index.deviation(row, column) + noise;
        let along = part.bounds();
        for i in row * BLOCK..rows.min((row + 1) * BLOCK) {
            for j in column * BLOCK..columns.min((column + 1) * BLOCK) {
                let mut cell = Bounds::EMPTY;
                for corner in [(i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)] {
                    cell.add(self.cells.corner(corner.0, corner.1) - origin);
                }
                if cell.grown(deviation).meets(&along) {
                    self.cell(part, [i, j], noise, room, found, finds);
                }
            }
        }
    }

    /// Adds what one cell has.
    fn cell<const M: usize, const N: usize>(
        &self,
        part: &Part<M>,
        [i, j]: [usize; 2],
        noise: f64,
        room: &mut Room<M, N>,
        found: &mut Crossings,
        finds: &mut Vec<Find>,
    ) where
        C: Cells<N>,
    {
        let origin = self.index.origin();
        let patch = self.cells.patch(i, j);
        let mut local = patch;
        local.points.as_flattened_mut().iter_mut().for_each(|point| *point -= origin);
        found.simple.clear();
        found.unresolved.clear();
        crossings(&part.points, &local, noise, self.tolerance, room, found);
        let along = |t: f64| self.segment as f64 + (part.from + part.size * t).clamp(0.0, 1.0);
        let simple = found.simple.iter().map(|crossing| (crossing.t, [crossing.t; 2], crossing.place, false));
        let spots = found.unresolved.iter().map(|Spot { place, low, high }| {
            (place.x, [low.x, high.x].map(|t| t.clamp(0.0, 1.0)), glam::DVec2::new(place.y, place.z), true)
        });
        for (t, span, at, tangent) in simple.chain(spots) {
            let ends = span.map(|t| part.point(t) + origin);
            finds.push(Find {
                at: along(t),
                span: span.map(along),
                ends,
                length: ends[0].distance(ends[1]),
                place: Place { sheet: self.sheet, cell: [i as u32, j as u32], u: at.x, v: at.y },
                point: patch.point(at.x, at.y),
                tangent,
            });
        }
    }
}

impl<const M: usize> Part<M> {
    fn point(&self, t: f64) -> DVec3 {
        let mut work = self.points;
        for count in (1..M).rev() {
            (0..count).for_each(|k| work[k] = work[k].lerp(work[k + 1], t));
        }
        work[0]
    }
}
