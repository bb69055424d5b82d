//! Curves of points whose normals make given angles with a direction: silhouettes at 90 degrees, in
//! general isophotes.
//!
//! With H the component of N = S_u x S_v along the direction and P the square of what is across it,
//! the angle is alpha where H has the sign of cos alpha and sin^2 alpha H^2 = cos^2 alpha P; at 90
//! degrees where H = 0; at 0 and 180 where both components across are 0, which is so at single
//! points. None of it suffers from cancellation, whatever the angle.

use super::cone_culling;
use super::creases::creases;
use super::lattice::Lattice;
use super::normals::squares;
use super::paths::{self, ContourSet};
use super::point_spacing::{PointSpacing, add_leus_points};
use super::projected_normals::{Corners, ProjectedNormals, frame};
use super::search::FoundArcs;
use super::search::Search;
use super::source::{Continuity, Source, between};
use crate::alloc;
#[cfg(doc)]
use crate::error::Error;
use crate::error::Result;
use crate::job::Job;
use crate::par;
use crate::surface::cells::Cells;
use crate::surface::checks::{direction, require, rising};
use crate::surface::index::{Cones, Pyramid};
use crate::surface::ranges::angles;
use crate::surface::subdivision::Field;
use crate::surface::{Grid, NormalKind, Paths, Place, Sheet, Surface};
use glam::{DVec2, DVec3};
use std::f64::consts::PI;
use std::ops::Range;

/// Sines and cosines smaller than that are 0.
const MIN_SINE: f64 = 1e-8;
/// By how much the angles of points may be off for rounding, in radians.
const ANGLE_TOLERANCE: f64 = 1e-6;
/// Blocks that are one thread's work, and such works between two reports of progress.
const CHUNK: usize = 64;
const CHUNKS: usize = 16;

/// H = 0.
struct Silhouette<'a, C, const N: usize>(ProjectedNormals<'a, C>);

impl<C: Cells<N>, const N: usize, const M: usize> Source<M> for Silhouette<'_, C, N> {
    type Block = Corners;
    type Base = (Field<M>, f64);
    type Cache = ();

    fn block(&self, cells: [Range<usize>; 2], (): &mut ()) -> Option<Corners> {
        Some(self.0.corners(&cells))
    }

    fn may_cross(&self, block: &Corners, cell: [usize; 2]) -> bool {
        let [low, high] = block.ranges(cell)[2];
        if low > 0.0 || high < 0.0 {
            return false;
        }
        let of = self.0.hodographs::<N>(cell);
        let rounding_error = self.0.rounding_error(&of);
        let [low, high] = of.ranges()[2];
        low <= rounding_error && high >= -rounding_error
    }

    fn base(&self, _: &Corners, cell: [usize; 2], (): &mut ()) -> (Field<M>, f64) {
        let of = self.0.hodographs::<N>(cell);
        (of.normal(2), self.0.rounding_error(&of))
    }

    fn level_count(&self) -> usize {
        1
    }

    fn levels(&self, _: &(Field<M>, f64)) -> Range<usize> {
        0..1
    }

    fn field(&self, base: &(Field<M>, f64), _: usize) -> Field<M> {
        base.0
    }

    fn continuity(&self) -> Continuity {
        self.0.continuity
    }

    fn rounding_error(&self, base: &(Field<M>, f64)) -> f64 {
        base.1
    }
}

/// sin^2 alpha H^2 = cos^2 alpha P.
struct Isophotes<'a, C, const N: usize, const H: usize> {
    normals: ProjectedNormals<'a, C>,
    /// Sines and cosines.
    angles: &'a [[f64; 2]],
    radians: &'a [f64],
    unsigned: bool,
}

/// The squares that the angles of a cell share.
struct Squares<const M: usize> {
    along: Field<M>,
    across: Field<M>,
    rounding_error: f64,
    levels: Range<usize>,
}

impl<C, const N: usize, const H: usize> Isophotes<'_, C, N, H> {
    /// The angles that are in a range, or whose supplements are, and what lies between them.
    fn within(&self, [low, high]: [f64; 2]) -> Range<usize> {
        let own = between(self.radians, [low, high], 0.0);
        if !self.unsigned {
            return own;
        }
        match between(self.radians, [PI - high, PI - low], 0.0) {
            others if others.is_empty() => own,
            others if own.is_empty() => others,
            others => own.start.min(others.start)..own.end.max(others.end),
        }
    }
}

impl<C: Cells<N>, const N: usize, const H: usize, const M: usize> Source<M> for Isophotes<'_, C, N, H> {
    type Block = Corners;
    type Base = Squares<M>;
    type Cache = ();

    fn block(&self, cells: [Range<usize>; 2], (): &mut ()) -> Option<Corners> {
        Some(self.normals.corners(&cells))
    }

    fn may_cross(&self, block: &Corners, cell: [usize; 2]) -> bool {
        if self.within(angles(&block.ranges(cell), 0.0)).is_empty() {
            return false;
        }
        let of = self.normals.hodographs::<N>(cell);
        !self.within(angles(&of.ranges(), self.normals.rounding_error(&of))).is_empty()
    }

    fn base(&self, _: &Corners, cell: [usize; 2], (): &mut ()) -> Squares<M> {
        let of = self.normals.hodographs::<N>(cell);
        let [first, second, along]: [Field<H>; 3] = std::array::from_fn(|k| of.normal(k));
        let [u, v] = of.speeds();
        let levels = self.within(angles(&of.ranges(), self.normals.rounding_error(&of)));
        let rounding_error = 4.0 * u * v * self.normals.rounding_error(&of);
        Squares { along: squares(&[along]), across: squares(&[first, second]), rounding_error, levels }
    }

    fn level_count(&self) -> usize {
        self.angles.len().max(1)
    }

    fn levels(&self, base: &Squares<M>) -> Range<usize> {
        base.levels.clone()
    }

    /// Rising with the cosine of the angle, where this has the sign of cos alpha.
    fn field(&self, base: &Squares<M>, level: usize) -> Field<M> {
        let [sin, cos] = self.angles[level];
        let sign = if cos < 0.0 && !self.unsigned { -1.0 } else { 1.0 };
        base.along.combined(sign * sin * sin, &base.across, -sign * cos * cos)
    }

    /// The equation holds of pi - alpha too: of its arcs, those on which H has the sign of cos
    /// alpha. The sign is one along an arc, since H and P vanish together only where the normal is
    /// none, as at poles, where it says nothing. Next to such a place within a cell, what is linked
    /// without being resolved may have both.
    fn keeps(&self, cell: [usize; 2], level: usize, places: impl FnOnce() -> [DVec2; 3]) -> Option<bool> {
        if self.unsigned {
            return Some(true);
        }
        let rounding_error = self.normals.rounding_error(&self.normals.hodographs::<N>(cell));
        let patch = self.normals.cells.patch(cell[0], cell[1]);
        let sign = self.angles[level][1].signum();
        let along = places().map(|at| sign * patch.jet(at.x, at.y).normal().dot(self.normals.frame[2]));
        let (right, wrong) = (along.iter().any(|&x| x > rounding_error), along.iter().any(|&x| x < -rounding_error));
        if right && wrong { None } else { Some(!wrong) }
    }

    fn continuity(&self) -> Continuity {
        self.normals.continuity
    }

    fn rounding_error(&self, base: &Squares<M>) -> f64 {
        base.rounding_error
    }
}

/// The angles of a query, by kind.
#[derive(Default)]
struct AngleClasses {
    silhouettes: Vec<u32>,
    /// Of 0 and 180 degrees: the sign of the cosine.
    poles: Vec<(u32, f64)>,
    others: Vec<[f64; 2]>,
    radians: Vec<f64>,
    /// All but those of 0 and 180 degrees.
    crossed: Vec<f64>,
    numbers: Vec<u32>,
}

impl Surface<'_> {
    /// Where the surface's normal makes given angles with a direction: curves in the order of the
    /// angles (`levels` of the paths) and of their lowest cells. At 90 degrees they are the
    /// silhouettes of the surface seen along the direction. At 0 and 180 degrees there are points
    /// in place of curves: paths of one point each. To the left of curves, seen from where the
    /// normals point to, angles are smaller.
    ///
    /// `angles`: in radians, rising, from 0 to pi; `unsigned`: a normal and its opposite are the
    /// same, and angles end at pi / 2.
    ///
    /// The angles are those of the interpolant's normals, which are of order three. Those at nodes
    /// are of order four, and so are the [`Surface::contours`] of their cosines.
    ///
    /// Every curve is found, as [`Surface::section`] finds them, if the surface is regular. On
    /// sheets of patches and of the four-point scheme, whose normals jump between cells, curves run
    /// along the side between cells where the angle jumps past the one asked for; where that goes
    /// on for more than a cell they end, and the ends and the sides are listed as unresolved. At
    /// poles, where the normal is none, a curve ends or passes; a pole that may have the angle
    /// itself is listed as unresolved. The first such question builds the cones of normals,
    /// O(cells); after that about O(cells that are crossed).
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for a direction that is 0 or not finite, and for angles that do
    /// not rise or are out of range; [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn isophotes(
        &self,
        axis: DVec3,
        angles: &[f64],
        unsigned: bool,
        spacing: PointSpacing,
        job: &Job<'_>,
    ) -> Result<Paths> {
        let axis = direction(axis, "direction")?;
        rising(angles, "angles")?;
        let max = if unsigned { 0.5 * PI } else { PI };
        angles.iter().try_for_each(|&angle| require((0.0..=max + 1e-15).contains(&angle), "angles", angle))?;
        let classes = AngleClasses::new(angles, unsigned)?;
        let chord = self.chord(spacing)?;
        let frame = frame(axis);
        let max_coordinate = self.max_coordinate();
        let (mut curves, mut points) = (ContourSet { threads: job.threads(), ..ContourSet::default() }, Vec::new());
        for k in 0..self.len() {
            let (part, (sheet, index)) = (self.sheet_job(k, job), self.indexed(k));
            let (cones, part) = (self.cones(k, &part.part(0.0, 0.5))?, part.part(0.5, 1.0));
            let is_smooth = |grid: &Grid<'_>| grid.axes().iter().all(|axis| axis.is_smooth());
            let continuity = match sheet {
                Sheet::Grid(grid) if is_smooth(grid) => Continuity::UpToRounding,
                _ => Continuity::Discontinuous,
            };
            let search = IsophoteSearch {
                sheet: k,
                cells: &(),
                index,
                cones,
                frame,
                max_coordinate,
                continuity,
                chord,
                unsigned,
            };
            let (lattice, found) = (Lattice::of(sheet), (&mut curves, &mut points));
            match sheet {
                Sheet::Grid(cells) => search.over(cells).find::<4, 6, 11>(&classes, lattice, found, &part)?,
                Sheet::Cubic(cells) => search.over(cells).find::<4, 6, 11>(&classes, lattice, found, &part)?,
                Sheet::High(cells) => search.over(cells).find::<8, 14, 27>(&classes, lattice, found, &part)?,
            }
        }
        let mut found = paths::paths(self, &curves.sheets, curves.unresolved, &job.part(0.9, 1.0))?;
        paths::add_points(self, &points, &mut found)?;
        self.report_angles(axis, angles, unsigned, &mut found)?;
        add_leus_points(found, spacing)
    }

    /// Reports the places of curves where the normal is regular and makes another angle: once for
    /// points of a cell that follow each other.
    fn report_angles(&self, axis: DVec3, angles: &[f64], unsigned: bool, paths: &mut Paths) -> Result<()> {
        let mut last: Option<Place> = None;
        for k in 0..paths.len() {
            let goal = angles[paths.levels[k] as usize];
            for at in paths.ends[k] as usize..paths.ends[k + 1] as usize {
                let (place, normal) = (paths.places[at], paths.normals[at]);
                let along = normal.dot(axis);
                let angle = libm::atan2(normal.cross(axis).length(), if unsigned { along.abs() } else { along });
                let known = last.is_some_and(|last| (last.sheet, last.cell) == (place.sheet, place.cell));
                if (angle - goal).abs() > ANGLE_TOLERANCE
                    && !known
                    && self.local(place).normal.kind == NormalKind::Regular
                {
                    alloc::push(&mut paths.unresolved, place)?;
                    last = Some(place);
                }
            }
        }
        Ok(())
    }

    /// The greatest coordinate.
    pub(super) fn max_coordinate(&self) -> f64 {
        let [low, high] = self.bounds();
        low.abs().max(high.abs()).max_element()
    }
}

impl AngleClasses {
    fn new(angles: &[f64], unsigned: bool) -> Result<Self> {
        let mut classes = AngleClasses::default();
        for (k, &angle) in angles.iter().enumerate() {
            let (sin, cos) = (libm::sin(angle), libm::cos(angle));
            if sin.abs() >= MIN_SINE {
                alloc::push(&mut classes.crossed, angle)?;
            }
            if cos.abs() < MIN_SINE {
                alloc::push(&mut classes.silhouettes, k as u32)?;
            } else if sin.abs() < MIN_SINE {
                alloc::push(&mut classes.poles, (k as u32, cos))?;
                if unsigned {
                    alloc::push(&mut classes.poles, (k as u32, -cos))?;
                }
            } else {
                alloc::push(&mut classes.others, [sin, cos])?;
                alloc::push(&mut classes.radians, angle)?;
                alloc::push(&mut classes.numbers, k as u32)?;
            }
        }
        Ok(classes)
    }
}

/// The search of one sheet.
struct IsophoteSearch<'a, C> {
    sheet: usize,
    cells: &'a C,
    index: &'a Pyramid,
    cones: &'a Cones,
    frame: [DVec3; 3],
    max_coordinate: f64,
    continuity: Continuity,
    chord: Option<f64>,
    unsigned: bool,
}

impl<'a> IsophoteSearch<'a, ()> {
    /// The same over the sheet's cells.
    fn over<C>(self, cells: &'a C) -> IsophoteSearch<'a, C> {
        let IsophoteSearch { sheet, index, cones, frame, max_coordinate, continuity, chord, unsigned, .. } = self;
        IsophoteSearch { sheet, cells, index, cones, frame, max_coordinate, continuity, chord, unsigned }
    }
}

impl<C> IsophoteSearch<'_, C> {
    fn normals(&self) -> ProjectedNormals<'_, C> {
        ProjectedNormals {
            cells: self.cells,
            index: self.index,
            frame: self.frame,
            max_coordinate: self.max_coordinate,
            continuity: self.continuity,
        }
    }

    /// The blocks that may have one of some angles, row after row.
    fn blocks(&self, angles: &[f64]) -> Result<Vec<[u32; 2]>> {
        cone_culling::blocks(self.cones, self.frame[2], |range| cone_culling::may_have(angles, self.unsigned, range))
    }

    fn find<const N: usize, const H: usize, const M: usize>(
        &self,
        classes: &AngleClasses,
        lattice: Lattice,
        (curves, points): (&mut ContourSet, &mut Vec<(u32, Place)>),
        job: &Job<'_>,
    ) -> Result<()>
    where
        C: Cells<N>,
    {
        let jumps = self.continuity == Continuity::Discontinuous;
        let IsophoteSearch { cells, chord, .. } = *self;
        let passes = classes.silhouettes.len()
            + usize::from(!classes.others.is_empty())
            + classes.poles.len()
            + usize::from(jumps);
        let mut pass = 0;
        let mut next = || {
            pass += 1;
            job.share(pass - 1, passes)
        };
        let blocks = if classes.silhouettes.is_empty() { Vec::new() } else { self.blocks(&[0.5 * PI])? };
        for &number in &classes.silhouettes {
            let source = Silhouette::<C, N>(self.normals());
            let search = Search { cells, source: &source, lattice, chord };
            let mut found = search.run::<N, H>(blocks.len(), |k| blocks[k], &next())?;
            found.arcs.iter_mut().for_each(|arc| arc.level = number);
            curves.add(self.sheet, found, &lattice, jumps)?;
        }
        if !classes.others.is_empty() {
            let (normals, unsigned) = (self.normals(), self.unsigned);
            let source = Isophotes::<C, N, H> { normals, angles: &classes.others, radians: &classes.radians, unsigned };
            let search = Search { cells, source: &source, lattice, chord };
            let blocks = self.blocks(&classes.radians)?;
            let found = search.run::<N, M>(blocks.len(), |k| blocks[k], &next())?;
            curves.add(self.sheet, found, &lattice, jumps)?;
            if let Some((_, paths)) = curves.sheets.last_mut() {
                paths.paths.iter_mut().for_each(|path| path.level = classes.numbers[path.level as usize]);
            }
        }
        if jumps {
            let mut found = FoundArcs::default();
            creases(
                &self.normals(),
                self.cones,
                &lattice,
                &classes.crossed,
                self.unsigned,
                &mut found.unresolved,
                &next(),
            )?;
            curves.add(self.sheet, found, &lattice, true)?;
        }
        for &(number, sign) in &classes.poles {
            self.poles::<N, H>(sign, number, &lattice, curves, points, &next())?;
        }
        Ok(())
    }

    /// The points where the normal has the direction, or the opposite one.
    fn poles<const N: usize, const H: usize>(
        &self,
        sign: f64,
        number: u32,
        lattice: &Lattice,
        curves: &mut ContourSet,
        points: &mut Vec<(u32, Place)>,
        job: &Job<'_>,
    ) -> Result<()>
    where
        C: Cells<N>,
    {
        let normals = self.normals();
        let blocks = self.blocks(&[if sign > 0.0 { 0.0 } else { PI }])?;
        let count = blocks.len();
        for first in (0..count).step_by(CHUNK * CHUNKS) {
            job.step(first as f64 / count as f64, "contours")?;
            let parts = par::chunks(job.threads(), (count - first).min(CHUNK * CHUNKS), CHUNK, |range| {
                let mut all = Vec::new();
                for k in range {
                    let (corners, cells) = normals.block(lattice, blocks[first + k]);
                    for cell in cells {
                        if let Some(roots) = normals.roots::<N, H>(&corners, cell, sign)? {
                            alloc::push(&mut all, (cell.map(|k| k as u32), roots))?;
                        }
                    }
                }
                Ok(all)
            });
            for part in parts {
                let part: Vec<_> = part?;
                for (cell, (crossing_by_corners, unresolved)) in part {
                    let place = |at: DVec2| Place { sheet: self.sheet as u32, cell, u: at.x, v: at.y };
                    for at in crossing_by_corners {
                        let [i, j] = cell.map(|k| k as usize);
                        let along = self.cells.patch(i, j).jet(at.x, at.y).normal().dot(self.frame[2]);
                        if along * sign > 0.0 {
                            alloc::push(points, (number, place(at)))?;
                        }
                    }
                    for at in unresolved {
                        alloc::push(&mut curves.unresolved, place(at))?;
                    }
                }
            }
        }
        Ok(())
    }
}
