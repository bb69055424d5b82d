//! Sections by parallel planes, and contours of scalar fields that are given at the corners of
//! cells.
//!
//! Both are zero sets of a scalar that is interpolated like the surface. For a plane, the scalar is
//! the signed distance. See [`super::contour_search`].

use super::contour_lattice::ContourLattice;
use super::contour_paths::SheetContourSet;
use super::contour_search::ContourSearch;
use super::contour_source::{NodalScalarSource, PlaneDistanceSource};
use super::planes::{self, Planes};
use super::point_spacing::{PointSpacing, add_leus_points};
use crate::axis::{GridAxis, Scheme};
use crate::cells::CELLS_PER_BLOCK_SIDE;
use crate::checks::{check_ascending, check_finite, unit_vector};
use crate::{Paths, Sheet, Surface, each_sheet};
use gusset_base::error::{Component, Element, Error, Result};
use gusset_base::job::Job;

impl Surface<'_> {
    /// Finds the sections of the surface with parallel planes. Curves are sorted by plane (`levels`
    /// of the paths), then by lowest cell. They run along the cross product of the planes' normal
    /// and the surface's normal.
    ///
    /// Finds every curve, also inside a cell. On a closed surface all curves are closed. A plane
    /// through a corner of cells is treated as if it were infinitesimally below the corner. A plane
    /// that touches the surface at corners from below therefore yields no curve. A plane that
    /// touches it from above yields closed curves around the contact, however narrow.
    ///
    /// Cells are listed as unresolved where the plane touches the surface elsewhere, or contains a
    /// piece of it, so that rounding decides. Curves as small as the tolerance are listed as
    /// unresolved too. Open ends on different sheets that meet within the tolerance are joined.
    ///
    /// # Errors
    /// [`Error::OptionOutOfRange`] if the planes are not finite, lack a normal, or are not
    /// ascending; [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn section(&self, planes: &Planes<'_>, spacing: PointSpacing, job: &Job<'_>) -> Result<Paths> {
        let normal = unit_vector(planes.normal, "normal")?;
        check_finite(planes.point, "point")?;
        check_ascending(planes.levels, "levels")?;
        let chord = self.chord_tolerance(spacing)?;
        let max_coordinate = self.max_coordinate().max(planes.point.abs().max_element());
        // A few rounding errors of coordinates of this size.
        let rounding_error = 16.0 * f64::EPSILON * max_coordinate;
        let mut contours = SheetContourSet::default();
        for k in 0..self.len() {
            let (part, (sheet, index)) = (self.sheet_job(k, job), self.sheet_and_index(k));
            let lattice = ContourLattice::new(sheet);
            let blocks = planes::blocks_crossed_by_planes(
                index,
                lattice.block_counts(),
                planes.point,
                normal,
                planes.levels,
                rounding_error,
            )?;
            let block = |k: usize| blocks[k];
            let jumps = !matches!(sheet, Sheet::Grid(_));
            let found = match sheet {
                Sheet::Grid(grid) => {
                    let axes = grid.axes();
                    let value = |i: usize, j: usize| (grid.nodes().get(i, j) - planes.point).dot(normal);
                    let excess = axes[0].lebesgue_constant() * axes[1].lebesgue_constant() - 1.0;
                    // The normal is a unit vector, so the deviation of the surface bounds the
                    // deviation of the product.
                    let deviation = |i: usize, j: usize| {
                        index.distance_bound_from_bilinear_patches(i / CELLS_PER_BLOCK_SIDE, j / CELLS_PER_BLOCK_SIDE)
                            + rounding_error
                    };
                    let source = NodalScalarSource {
                        axes,
                        scalar_at_node: value,
                        levels: planes.levels,
                        rounding_error,
                        excess,
                        deviation,
                    };
                    ContourSearch { cells: grid, source: &source, lattice, chord }.find_arcs(
                        blocks.len(),
                        block,
                        &part,
                    )?
                }
                Sheet::Cubic(cells) => {
                    let source = PlaneDistanceSource {
                        cells,
                        normal,
                        origin: planes.point,
                        levels: planes.levels,
                        rounding_error,
                    };
                    ContourSearch { cells, source: &source, lattice, chord }.find_arcs(blocks.len(), block, &part)?
                }
                Sheet::High(cells) => {
                    let source = PlaneDistanceSource {
                        cells,
                        normal,
                        origin: planes.point,
                        levels: planes.levels,
                        rounding_error,
                    };
                    ContourSearch { cells, source: &source, lattice, chord }.find_arcs(blocks.len(), block, &part)?
                }
            };
            contours.add_sheet_arcs(k, found, &lattice, jumps, job.requested_threads())?;
        }
        add_leus_points(contours.into_paths(self, &job.sub_job(0.9, 1.0))?, spacing)
    }

    /// Finds the contours of a scalar field that is given at the corners of the cells: the curves
    /// where it has one of the values `levels`, which are ascending. Between corners, the field is
    /// interpolated like a sheet through nodes; on sheets of patches, by the six-tap scheme. Seen
    /// from the side of the normals, larger values are to the left of a curve.
    ///
    /// `values` holds the values of all sheets, one after the other, each row by row. A sheet has
    /// one row and one column more than cells. In a closed direction the last line repeats the
    /// first one, and is not read. Otherwise, the search is like [`Surface::section`].
    ///
    /// # Errors
    /// [`Error::ArrayTooShort`] or [`Error::TooLarge`] if the number of values is wrong;
    /// [`Error::NotFinite`] with the index of the value; [`Error::OptionOutOfRange`] if levels are
    /// not finite or not ascending; [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn contours(&self, values: &[f64], levels: &[f64], spacing: PointSpacing, job: &Job<'_>) -> Result<Paths> {
        check_ascending(levels, "levels")?;
        let chord = self.chord_tolerance(spacing)?;
        self.check_field_values(values)?;
        let mut contours = SheetContourSet::default();
        let mut first = 0;
        for k in 0..self.len() {
            let (part, (sheet, _)) = (self.sheet_job(k, job), self.sheet_and_index(k));
            let lattice = ContourLattice::new(sheet);
            let [rows, columns] = sheet.cells().map(|count| count + 1);
            let own = &values[first..first + rows * columns];
            first += rows * columns;
            let largest = own.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            let made = [GridAxis::new(rows, false, Scheme::SixTap), GridAxis::new(columns, false, Scheme::SixTap)];
            let axes = match sheet {
                Sheet::Grid(grid) => grid.axes(),
                _ => [&made[0], &made[1]],
            };
            let value = |i: usize, j: usize| own[i * columns + j];
            let excess = axes[0].lebesgue_constant() * axes[1].lebesgue_constant() - 1.0;
            let rounding_error = 16.0 * f64::EPSILON * largest;
            let source = NodalScalarSource {
                axes,
                scalar_at_node: value,
                levels,
                rounding_error,
                excess,
                deviation: |_, _| f64::INFINITY,
            };
            let [_, across] = lattice.block_counts();
            let block = |k: usize| [(k / across) as u32, (k % across) as u32];
            let count = lattice.block_counts()[0] * across;
            let found = each_sheet!(sheet, cells => {
                ContourSearch { cells, source: &source, lattice, chord }.find_arcs(count, block, &part)
            })?;
            contours.add_sheet_arcs(k, found, &lattice, false, job.requested_threads())?;
        }
        add_leus_points(contours.into_paths(self, &job.sub_job(0.9, 1.0))?, spacing)
    }

    /// The job of sheet k: its share of the search.
    pub(super) fn sheet_job<'a>(&self, k: usize, job: &Job<'a>) -> Job<'a> {
        job.sub_job(0.0, 0.9).sub_job_of_item(k, self.len())
    }

    fn check_field_values(&self, values: &[f64]) -> Result<()> {
        let (count, given) = (self.node_count(), values.len() as u64);
        if given < count {
            return Err(Error::ArrayTooShort { what: "values", needed: 8 * count, given: 8 * given });
        }
        Error::check_count("values", given, count)?;
        match values.iter().position(|value| !value.is_finite()) {
            Some(node) => Err(Error::NotFinite {
                element: Element::Node,
                index: node as u64,
                component: Component::Value,
                value: values[node],
            }),
            None => Ok(()),
        }
    }
}
