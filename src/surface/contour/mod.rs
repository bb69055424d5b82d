//! Tasks d) and b) of the paper: sections by planes, contours of scalar fields, and curves of points whose normals make a given angle
//! with a direction. All are zero sets of polynomials over the cells.
//!
//! `source` says what the polynomials are, `search` goes through the blocks that they may vanish in, `cell` finds the arcs in a cell,
//! `simple` those that corners alone show, `refine` the points between, `chain` links arcs, `paths` makes curves of all sheets. Points are
//! computed on the interpolant: they are of its order, four; the order of chords between them is two, whence the refinement.

mod cell;
mod chain;
mod creases;
mod facing;
mod frame;
mod isophote;
mod lattice;
mod nearest;
mod normals;
mod paths;
mod planes;
mod point_spacing;
mod refine;
mod search;
mod seen;
mod side;
mod simple;
mod source;

use super::axis::{Axis, Scheme};
use super::cells::BLOCK;
use super::{Paths, Place, Sheet, Surface, each_sheet};
use crate::alloc;
use crate::error::{Element, Error, Result};
use crate::job::Job;
use chain::{Strands, chain};
use glam::DVec3;
use lattice::Lattice;
pub use nearest::NearestAngle;
use search::{Found, Search};
use source::{Nodal, Plane};

/// What is between the points where a curve crosses the lines of the surface.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Between {
    /// As many points of the surface as keep the chords within 1e-4 of the diagonal of the surface's box.
    #[default]
    Auto,
    /// As many points of the surface as keep the chords within this length.
    Chord(f64),
    /// Nothing: chords, as the paper has them at first. Their order is two.
    Nothing,
    /// As many points of the paper's approximation of higher order: on the cubic through the crossings with the neighbouring lines of
    /// the surface, two before and two behind, over their chords. These points are near the surface, not on it: of order four where
    /// crossings are evenly spaced, and less reliable where they cluster. Each has the place of the crossing before it.
    Leus(u32),
}

/// Parallel planes.
#[derive(Debug, Clone, Copy)]
pub struct Planes<'a> {
    /// A point of the plane of offset 0.
    pub point: DVec3,
    /// Not 0; of any length.
    pub normal: DVec3,
    /// How far the planes are from the point, along the normal; rising.
    pub offsets: &'a [f64],
}

/// The strands of sheets, and what could not be resolved.
#[derive(Default)]
struct Gathered {
    threads: usize,
    sheets: Vec<(usize, Strands)>,
    unresolved: Vec<Place>,
}

impl Gathered {
    fn add(&mut self, sheet: usize, mut found: Found, lattice: &Lattice, apart: bool) -> Result<()> {
        alloc::reserve(&mut self.unresolved, found.unresolved.len())?;
        let place =
            |&([i, j], at): &([u32; 2], glam::DVec2)| Place { sheet: sheet as u32, cell: [i, j], u: at.x, v: at.y };
        self.unresolved.extend(found.unresolved.iter().map(place));
        let strands = chain(&mut found, lattice, apart, self.threads)?;
        alloc::push(&mut self.sheets, (sheet, strands))
    }
}

impl Surface<'_> {
    /// Where parallel planes cut the surface: curves in the order of the planes (`levels` of the paths) and of their lowest cells. They run
    /// along the cross product of the planes' normal and the surface's.
    ///
    /// Every curve is found, also one within a cell; on a closed surface all are closed. A plane that passes through a corner is taken as
    /// infinitely little below it. Where the plane touches the surface or contains a piece of it, so that curves cannot be told within
    /// rounding, the cells are listed as unresolved; a curve no larger than the tolerance too. Open ends of sheets that meet within
    /// the tolerance are joined.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for planes that are not finite, have no normal, or do not rise; and as [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn section(&self, planes: &Planes<'_>, between: Between, job: &Job<'_>) -> Result<Paths> {
        let normal = direction(planes.normal, "normal")?;
        finite(planes.point, "point")?;
        rising(planes.offsets, "offsets")?;
        let chord = self.chord(between)?;
        let reach = self.reach().max(planes.point.abs().max_element());
        // A few roundings of coordinates of this size.
        let noise = 16.0 * f64::EPSILON * reach;
        let mut gathered = Gathered { threads: job.threads(), ..Gathered::default() };
        for k in 0..self.len() {
            let (part, (sheet, index)) = (self.part(k, job), self.indexed(k));
            let lattice = lattice(sheet);
            let blocks = planes::blocks(index, lattice.blocks(), planes.point, normal, planes.offsets, noise)?;
            let block = |k: usize| blocks[k];
            let apart = !matches!(sheet, Sheet::Grid(_));
            let found = match sheet {
                Sheet::Grid(grid) => {
                    let axes = grid.axes();
                    let value = |i: usize, j: usize| (grid.nodes().get(i, j) - planes.point).dot(normal);
                    let excess = axes[0].lebesgue() * axes[1].lebesgue() - 1.0;
                    // The normal is a unit vector: what the surface deviates by, its product with the normal does at most.
                    let deviation = |i: usize, j: usize| index.deviation(i / BLOCK, j / BLOCK) + noise;
                    let source = Nodal { axes, value, levels: planes.offsets, noise, excess, deviation };
                    Search { cells: grid, source: &source, lattice, chord }.run(blocks.len(), block, &part)?
                }
                Sheet::Cubic(cells) => {
                    let source = Plane { cells, normal, origin: planes.point, levels: planes.offsets, noise };
                    Search { cells, source: &source, lattice, chord }.run::<4, 4>(blocks.len(), block, &part)?
                }
                Sheet::High(cells) => {
                    let source = Plane { cells, normal, origin: planes.point, levels: planes.offsets, noise };
                    Search { cells, source: &source, lattice, chord }.run::<8, 8>(blocks.len(), block, &part)?
                }
            };
            gathered.add(k, found, &lattice, apart)?;
        }
        point_spacing::between(paths::paths(self, &gathered.sheets, gathered.unresolved, &job.part(0.9, 1.0))?, between)
    }

    /// The contours of a scalar field that is given at the corners of the cells: where it takes the values of `levels`, which rise. Between
    /// corners it is interpolated as a sheet through nodes is; for patches, with the scheme of six taps. Greater values are to the left of
    /// the curves, seen from where the normals point to.
    ///
    /// `values`: of all sheets, one after the other, each row after row: one more row and column than there are cells; the last line of a
    /// closed direction repeats the first and is not read. For the rest, as [`Surface::section`].
    ///
    /// # Errors
    /// [`Error::ArrayTooShort`], or [`Error::TooLarge`] if there are too many; [`Error::NotFinite`] with the number of the value;
    /// [`Error::OptionOutOfRange`] for levels that are not finite or do not rise; [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn contours(&self, values: &[f64], levels: &[f64], between: Between, job: &Job<'_>) -> Result<Paths> {
        rising(levels, "levels")?;
        let chord = self.chord(between)?;
        self.check_values(values)?;
        let mut gathered = Gathered { threads: job.threads(), ..Gathered::default() };
        let mut first = 0;
        for k in 0..self.len() {
            let (part, (sheet, _)) = (self.part(k, job), self.indexed(k));
            let lattice = lattice(sheet);
            let [rows, columns] = sheet.cells().map(|count| count + 1);
            let own = &values[first..first + rows * columns];
            first += rows * columns;
            let largest = own.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            let made = [Axis::new(rows, false, Scheme::SixTap), Axis::new(columns, false, Scheme::SixTap)];
            let axes = match sheet {
                Sheet::Grid(grid) => grid.axes(),
                _ => [&made[0], &made[1]],
            };
            let value = |i: usize, j: usize| own[i * columns + j];
            let excess = axes[0].lebesgue() * axes[1].lebesgue() - 1.0;
            let noise = 16.0 * f64::EPSILON * largest;
            let source = Nodal { axes, value, levels, noise, excess, deviation: |_, _| f64::INFINITY };
            let [_, across] = lattice.blocks();
            let block = |k: usize| [(k / across) as u32, (k % across) as u32];
            let count = lattice.blocks()[0] * across;
            let found = each_sheet!(sheet, cells => Search { cells, source: &source, lattice, chord }.run(count, block, &part))?;
            gathered.add(k, found, &lattice, false)?;
        }
        point_spacing::between(paths::paths(self, &gathered.sheets, gathered.unresolved, &job.part(0.9, 1.0))?, between)
    }

    /// The share of sheet k in the search.
    fn part<'a>(&self, k: usize, job: &Job<'a>) -> Job<'a> {
        job.part(0.0, 0.9).share(k, self.len())
    }

    fn check_values(&self, values: &[f64]) -> Result<()> {
        let of = |sheet: &Sheet<'_>| sheet.cells().map(|count| count as u64 + 1);
        let count: u64 = (0..self.len()).map(|k| of(self.sheet(k))).map(|[rows, columns]| rows * columns).sum();
        let given = values.len() as u64;
        if given < count {
            return Err(Error::ArrayTooShort { what: "values", needed: 8 * count, given: 8 * given });
        }
        if given > count {
            return Err(Error::TooLarge { what: "values", count: given, limit: count });
        }
        match values.iter().position(|value| !value.is_finite()) {
            Some(node) => Err(Error::NotFinite { element: Element::Node, index: node as u64, value: values[node] }),
            None => Ok(()),
        }
    }

    /// The length that chords are held to.
    fn chord(&self, between: Between) -> Result<Option<f64>> {
        let [low, high] = self.bounds();
        match between {
            Between::Auto => Ok(Some(1e-4 * low.distance(high))),
            Between::Nothing => Ok(None),
            Between::Leus(count) if count <= point_spacing::MOST => Ok(None),
            Between::Leus(count) => Err(Error::OptionOutOfRange { option: "points", value: count.into() }),
            Between::Chord(chord) if chord > 0.0 && chord.is_finite() => Ok(Some(chord.max(self.tolerance()))),
            Between::Chord(value) => Err(Error::OptionOutOfRange { option: "chord", value }),
        }
    }
}

fn lattice(sheet: &Sheet<'_>) -> Lattice {
    let closed = match sheet {
        Sheet::Grid(grid) => grid.is_closed(),
        _ => [false; 2],
    };
    Lattice { counts: sheet.cells(), closed }
}

/// A direction's unit vector.
fn direction(given: DVec3, option: &'static str) -> Result<DVec3> {
    finite(given, option)?;
    // Neither overflow nor underflow.
    let largest = given.abs().max_element();
    if largest > 0.0 { Ok((given / largest).normalize()) } else { Err(Error::OptionOutOfRange { option, value: 0.0 }) }
}

fn finite(given: DVec3, option: &'static str) -> Result<()> {
    match given.to_array().into_iter().find(|x| !x.is_finite()) {
        Some(value) => Err(Error::OptionOutOfRange { option, value }),
        None => Ok(()),
    }
}

/// Levels, by whatever name, are finite and rise.
fn rising(levels: &[f64], option: &'static str) -> Result<()> {
    let bad = levels.iter().enumerate().find(|&(k, level)| !level.is_finite() || (k > 0 && *level <= levels[k - 1]));
    match bad {
        Some((_, &value)) => Err(Error::OptionOutOfRange { option, value }),
        None => Ok(()),
    }
}
