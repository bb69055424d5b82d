//! Sections by parallel planes, and contours of scalar fields that are given at the corners of
//! cells.
//!
//! Both are zero sets of a scalar that is interpolated as the surface is: of a plane, of its
//! distance. See [`super::contour_search`].

use super::contour_lattice::Lattice;
use super::contour_search::ContourSearch;
use super::paths::ContourSet;
use super::planes::{self, Planes};
use super::point_spacing::{PointSpacing, add_leus_points};
use super::source::{Nodal, Plane};
use crate::axis::{Axis, Scheme};
use crate::cells::BLOCK;
use crate::checks::{direction, finite, rising};
use crate::{Paths, Sheet, Surface, each_sheet};
use gusset_base::error::{Element, Error, Result};
use gusset_base::job::Job;

impl Surface<'_> {
    /// Where parallel planes cut the surface: curves in the order of the planes (`levels` of the
    /// paths) and of their lowest cells. They run along the cross product of the planes' normal and
    /// the surface's.
    ///
    /// Every curve is found, also one within a cell; on a closed surface all are closed. A plane
    /// that passes through a corner is taken as infinitely little below it: one that touches the
    /// surface in corners from below gives nothing there, one that touches it from above closed
    /// curves round the contact, however narrow. Where the plane touches the surface elsewhere or
    /// contains a piece of it, so that curves cannot be told within rounding, the cells are listed
    /// as unresolved; a curve no larger than the tolerance too. Open ends of sheets that meet
    /// within the tolerance are joined.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] for planes that are not finite, have no normal, or do not rise;
    /// and as [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn section(&self, planes: &Planes<'_>, spacing: PointSpacing, job: &Job<'_>) -> Result<Paths> {
        let normal = direction(planes.normal, "normal")?;
        finite(planes.point, "point")?;
        rising(planes.levels, "levels")?;
        let chord = self.chord(spacing)?;
        let max_coordinate = self.max_coordinate().max(planes.point.abs().max_element());
        // A few roundings of coordinates of this size.
        let rounding_error = 16.0 * f64::EPSILON * max_coordinate;
        let mut contours = ContourSet::default();
        for k in 0..self.len() {
            let (part, (sheet, index)) = (self.sheet_job(k, job), self.indexed(k));
            let lattice = Lattice::of(sheet);
            let blocks = planes::blocks(index, lattice.blocks(), planes.point, normal, planes.levels, rounding_error)?;
            let block = |k: usize| blocks[k];
            let jumps = !matches!(sheet, Sheet::Grid(_));
            let found = match sheet {
                Sheet::Grid(grid) => {
                    let axes = grid.axes();
                    let value = |i: usize, j: usize| (grid.nodes().get(i, j) - planes.point).dot(normal);
                    let excess = axes[0].lebesgue() * axes[1].lebesgue() - 1.0;
                    // The normal is a unit vector: what the surface deviates by, its product with
                    // the normal does at most.
                    let deviation = |i: usize, j: usize| index.deviation(i / BLOCK, j / BLOCK) + rounding_error;
                    let source = Nodal { axes, value, levels: planes.levels, rounding_error, excess, deviation };
                    ContourSearch { cells: grid, source: &source, lattice, chord }.run(blocks.len(), block, &part)?
                }
                Sheet::Cubic(cells) => {
                    let source = Plane { cells, normal, origin: planes.point, levels: planes.levels, rounding_error };
                    ContourSearch { cells, source: &source, lattice, chord }.run(blocks.len(), block, &part)?
                }
                Sheet::High(cells) => {
                    let source = Plane { cells, normal, origin: planes.point, levels: planes.levels, rounding_error };
                    ContourSearch { cells, source: &source, lattice, chord }.run(blocks.len(), block, &part)?
                }
            };
            contours.add(k, found, &lattice, jumps, job.threads())?;
        }
        add_leus_points(contours.paths(self, &job.part(0.9, 1.0))?, spacing)
    }

    /// The contours of a scalar field that is given at the corners of the cells: where it takes the
    /// values of `levels`, which rise. Between corners it is interpolated as a sheet through nodes
    /// is; for patches, with the scheme of six taps. Greater values are to the left of the curves,
    /// seen from where the normals point to.
    ///
    /// `values`: of all sheets, one after the other, each row after row: one more row and column
    /// than there are cells; the last line of a closed direction repeats the first and is not read.
    /// For the rest, as [`Surface::section`].
    ///
    /// # Errors
    /// [`Error::ArrayTooShort`], or [`Error::TooLarge`] if there are too many; [`Error::NotFinite`]
    /// with the number of the value; [`Error::OptionOutOfRange`] for levels that are not finite or
    /// do not rise; [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn contours(&self, values: &[f64], levels: &[f64], spacing: PointSpacing, job: &Job<'_>) -> Result<Paths> {
        rising(levels, "levels")?;
        let chord = self.chord(spacing)?;
        self.check_values(values)?;
        let mut contours = ContourSet::default();
        let mut first = 0;
        for k in 0..self.len() {
            let (part, (sheet, _)) = (self.sheet_job(k, job), self.indexed(k));
            let lattice = Lattice::of(sheet);
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
            let rounding_error = 16.0 * f64::EPSILON * largest;
            let source = Nodal { axes, value, levels, rounding_error, excess, deviation: |_, _| f64::INFINITY };
            let [_, across] = lattice.blocks();
            let block = |k: usize| [(k / across) as u32, (k % across) as u32];
            let count = lattice.blocks()[0] * across;
            let found = each_sheet!(sheet, cells => ContourSearch { cells, source: &source, lattice, chord }.run(count, block, &part))?;
            contours.add(k, found, &lattice, false, job.threads())?;
        }
        add_leus_points(contours.paths(self, &job.part(0.9, 1.0))?, spacing)
    }

    /// The share of sheet k in the search.
    pub(super) fn sheet_job<'a>(&self, k: usize, job: &Job<'a>) -> Job<'a> {
        job.part(0.0, 0.9).share(k, self.len())
    }

    fn check_values(&self, values: &[f64]) -> Result<()> {
        let (count, given) = (self.node_count(), values.len() as u64);
        if given < count {
            return Err(Error::ArrayTooShort { what: "values", needed: 8 * count, given: 8 * given });
        }
        Error::check_count("values", given, count)?;
        match values.iter().position(|value| !value.is_finite()) {
            Some(node) => Err(Error::NotFinite { element: Element::Node, index: node as u64, value: values[node] }),
            None => Ok(()),
        }
    }
}
