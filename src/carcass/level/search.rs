//! The arcs of a sheet: block by block, cell by cell, level by level.

use super::cell::{Keys, Link, Mark, SIDES, arcs, one_sign};
use super::lattice::Lattice;
use super::refine::{is_straight, middle, refine};
use super::side::{crossings, positive};
use super::source::{Sides, Source};
use crate::alloc;
use crate::carcass::Patch;
use crate::carcass::cells::Cells;
use crate::carcass::solve::Field;
use crate::error::Result;
use crate::job::Job;
use crate::par;
use glam::DVec2;

/// Blocks that are one thread's work.
const CHUNK: usize = 16;
/// Chunks between two reports of progress.
const CHUNKS: usize = 16;

/// An arc of a level's zero set over a cell.
#[derive(Debug, Clone, Copy)]
pub(super) struct Arc {
    pub(super) level: u32,
    pub(super) cell: [u32; 2],
    /// The keys of the marks that it begins and ends with.
    pub(super) keys: [u64; 2],
    /// Where these are.
    pub(super) ends: [DVec2; 2],
    /// The places between: from where to where among all.
    pub(super) inner: [u32; 2],
    /// True if the next arc begins elsewhere than this one ends: across a side where fields jump.
    pub(super) jumps: bool,
}

/// What was found on a sheet.
#[derive(Debug, Default)]
pub(super) struct Found {
    pub(super) arcs: Vec<Arc>,
    pub(super) inner: Vec<DVec2>,
    /// Cells, and where in them, that are unresolved.
    pub(super) unresolved: Vec<([u32; 2], DVec2)>,
}

impl Found {
    fn append(&mut self, other: &Found) -> Result<()> {
        let shift = self.inner.len() as u32;
        alloc::append(&mut self.inner, &other.inner)?;
        alloc::append(&mut self.unresolved, &other.unresolved)?;
        alloc::reserve(&mut self.arcs, other.arcs.len())?;
        self.arcs.extend(other.arcs.iter().map(|arc| Arc { inner: arc.inner.map(|k| k + shift), ..*arc }));
        Ok(())
    }
}

/// What a search of a sheet needs to know.
pub(super) struct Search<'a, C, S> {
    pub(super) cells: &'a C,
    pub(super) source: &'a S,
    pub(super) lattice: Lattice,
    /// How far chords may be from the curve; `None`: marks only.
    pub(super) chord: Option<f64>,
}

/// Room for the work on a cell.
#[derive(Default)]
struct Scratch {
    marks: Vec<Mark>,
    links: Vec<Link>,
}

/// One level in a cell.
struct Piece<'a, const M: usize> {
    cell: [usize; 2],
    level: usize,
    field: &'a Field<M>,
    noise: f64,
    /// How far it and the surface are from bilinear.
    deviation: f64,
    /// Polynomials along the sides.
    sides: [[f64; M]; SIDES],
    /// Signs at the corners 2 u + v.
    corners: [bool; 4],
}

impl<C, S> Search<'_, C, S> {
    /// The arcs in the given blocks, `(row, column)` of `block(k)` for k < `count`.
    pub(super) fn run<const N: usize, const M: usize>(
        &self,
        count: usize,
        block: impl Fn(usize) -> [u32; 2] + Sync,
        job: &Job<'_>,
    ) -> Result<Found>
    where
        C: Cells<N>,
        S: Source<M>,
    {
        let mut found = Found::default();
        for first in (0..count).step_by(CHUNK * CHUNKS) {
            job.step(first as f64 / count as f64, "contours")?;
            let blocks = (count - first).min(CHUNK * CHUNKS);
            let parts = par::chunks(job.threads(), blocks, CHUNK, |range| {
                let mut part = Found::default();
                let mut scratch = Scratch::default();
                for k in range {
                    self.block(block(first + k), &mut scratch, &mut part)?;
                }
                Ok(part)
            });
            for part in parts {
                let part: Found = part?;
                if found.arcs.is_empty() && found.unresolved.is_empty() {
                    found = part;
                } else {
                    found.append(&part)?;
                }
            }
        }
        Ok(found)
    }

    fn block<const N: usize, const M: usize>(
        &self,
        block: [u32; 2],
        scratch: &mut Scratch,
        found: &mut Found,
    ) -> Result<()>
    where
        C: Cells<N>,
        S: Source<M>,
    {
        let [rows, columns] = self.lattice.block(block);
        let Some(block) = self.source.block([rows.clone(), columns.clone()]) else { return Ok(()) };
        for cell in rows.flat_map(|i| columns.clone().map(move |j| [i, j])) {
            if !self.source.may_cross(&block, cell) {
                continue;
            }
            let base = self.source.base(&block, cell);
            let mut patch = None;
            for level in self.source.levels(&base) {
                let noise = self.source.noise(&base);
                let field = snapped(self.source.field(&base, level), noise);
                let [low, high] = field.range();
                // With rounding: where sides are alike only, a neighbour's may have marks that this cell's own have not.
                if low > noise || high < -noise {
                    continue;
                }
                if self.source.sides() != Sides::Alike && one_sign(&field) {
                    if high - low <= noise {
                        // All of the cell, as far as one can tell.
                        alloc::push(&mut found.unresolved, (cell.map(|k| k as u32), DVec2::splat(0.5)))?;
                    }
                    continue;
                }
                let (sides, corners) = match self.source.sides() {
                    Sides::Alike => self.common_border(&block, cell, &field, level),
                    _ => own_border(&field),
                };
                let deviation = self.source.deviation(&block);
                let piece = Piece { cell, level, field: &field, noise, deviation, sides, corners };
                self.piece(&piece, &mut patch, scratch, found)?;
            }
        }
        Ok(())
    }

    /// The polynomials along a cell's sides and the signs at its corners, as the cells have them that own them.
    fn common_border<const M: usize>(
        &self,
        block: &S::Block,
        cell: [usize; 2],
        own: &Field<M>,
        level: usize,
    ) -> ([[f64; M]; SIDES], [bool; 4])
    where
        S: Source<M>,
    {
        let ([low_v, mut high_u, mut high_v, low_u], mut corners) = own_border(own);
        for after in [[true, false], [false, true], [true, true]] {
            let (owner, ends) = self.lattice.owner(cell, after);
            let field = if owner == cell {
                *own
            } else {
                let base = self.source.base(block, owner);
                snapped(self.source.field(&base, level), self.source.noise(&base))
            };
            let corner = field.c[if ends[0] { M - 1 } else { 0 }][if ends[1] { M - 1 } else { 0 }];
            corners[2 * usize::from(after[0]) + usize::from(after[1])] = positive(corner);
            match after {
                [true, false] => high_u = field.c[if ends[0] { M - 1 } else { 0 }],
                [false, true] => high_v = field.c.map(|row| row[if ends[1] { M - 1 } else { 0 }]),
                _ => {}
            }
        }
        ([low_v, high_u, high_v, low_u], corners)
    }

    /// The arcs of one level in one cell.
    fn piece<const N: usize, const M: usize>(
        &self,
        piece: &Piece<'_, M>,
        patch: &mut Option<Patch<N>>,
        scratch: &mut Scratch,
        found: &mut Found,
    ) -> Result<()>
    where
        C: Cells<N>,
        S: Source<M>,
    {
        let Scratch { marks, links } = scratch;
        links.clear();
        self.marks(piece, marks);
        let [i, j] = piece.cell;
        let cell = [i as u32, j as u32];
        let number = (i * self.lattice.counts[1] + j) as u64;
        let mut keys = Keys(1 << 63 | number << 24);
        let unresolved = arcs(piece.field, marks, piece.corners, piece.noise, &mut keys, |link| links.push(link));
        if let Some(at) = unresolved {
            alloc::push(&mut found.unresolved, (cell, at))?;
        }
        for link in links.iter() {
            // Places of the arc itself: what is amid its ends need not be near it.
            let places = || {
                let amid = middle(piece.field, link, piece.noise).unwrap_or(link.from.at);
                [link.from.at, amid, link.to.at]
            };
            let keeps = self.source.keeps(piece.cell, piece.level, places);
            if keeps.is_none() {
                alloc::push(&mut found.unresolved, (cell, link.from.at))?;
            }
            if keeps != Some(true) {
                continue;
            }
            let first = found.inner.len() as u32;
            let corners = || [(i, j), (i, j + 1), (i + 1, j), (i + 1, j + 1)].map(|(i, j)| self.cells.corner(i, j));
            let straight = |chord: f64| {
                piece.deviation < chord && is_straight(&corners(), piece.field, link, piece.deviation, chord)
            };
            if let Some(chord) = self.chord.filter(|&chord| !straight(chord)) {
                let patch = patch.get_or_insert_with(|| self.cells.patch(i, j));
                if let Some(at) = refine(patch, piece.field, link, chord, piece.noise, &mut found.inner) {
                    alloc::push(&mut found.unresolved, (cell, at))?;
                }
            }
            let arc = Arc {
                level: piece.level as u32,
                cell,
                keys: [link.from.key, link.to.key],
                ends: [link.from.at, link.to.at],
                inner: [first, found.inner.len() as u32],
                jumps: false,
            };
            alloc::push(&mut found.arcs, arc)?;
        }
        Ok(())
    }

    /// Where a level crosses the sides of a cell.
    fn marks<const M: usize>(&self, piece: &Piece<'_, M>, marks: &mut Vec<Mark>)
    where
        S: Source<M>,
    {
        marks.clear();
        let apart = self.source.sides() == Sides::Apart;
        let [c00, c01, c10, c11] = piece.corners;
        let ends = [[c00, c10], [c10, c11], [c01, c11], [c00, c01]];
        for (side, (c, ends)) in piece.sides.iter().zip(ends).enumerate() {
            // Where fields jump, the two cells at a side have marks of their own.
            let which = u64::from(apart && (side == 1 || side == 2));
            let key = (2 * self.lattice.side(piece.cell, side) + which) << 6;
            let mut count = 0;
            crossings(c, ends, |crossing| {
                let t = crossing.t;
                let at = [DVec2::new(t, 0.0), DVec2::new(1.0, t), DVec2::new(t, 1.0), DVec2::new(0.0, t)][side];
                marks.push(Mark { key: key | count, at, side, rising: crossing.rising });
                count += 1;
            });
        }
    }
}

/// What cannot be told from 0 is 0: so what lies in a plane within rounding lies in it, and is no heap of tiny curves. The same
/// coefficients stay the same.
#[inline]
fn snapped<const M: usize>(field: Field<M>, noise: f64) -> Field<M> {
    Field { c: field.c.map(|row| row.map(|x| if x.abs() <= noise { 0.0 } else { x })) }
}

/// As the cell has it itself.
#[inline]
fn own_border<const M: usize>(field: &Field<M>) -> ([[f64; M]; SIDES], [bool; 4]) {
    let c = &field.c;
    let sides = [c.map(|row| row[0]), c[M - 1], c.map(|row| row[M - 1]), c[0]];
    (sides, [c[0][0], c[0][M - 1], c[M - 1][0], c[M - 1][M - 1]].map(positive))
}
