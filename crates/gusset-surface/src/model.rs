//! Surfaces: sheets with their index.

use super::index::{BoxPyramid, ConePyramid, NormalCone};
use super::{Jet, Sheet, each_sheet};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::job::Job;

/// A point of a surface, given by sheet, cell and parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// The sheet.
    pub sheet: u32,
    /// Row and column of the cell.
    pub cell: [u32; 2],
    /// Parameter u within the cell, 0 to 1.
    pub u: f64,
    /// Parameter v within the cell, 0 to 1.
    pub v: f64,
}

/// Largest absolute coordinate that a sheet may have. Bounding boxes are in single precision.
pub const LARGEST_COORDINATE: f64 = 1e37;
/// Smallest value that the largest absolute coordinate of a sheet may have, unless it is 0. Boxes
/// in single precision would be much too large for a smaller surface.
pub const SMALLEST_COORDINATE: f64 = 1e-30;

/// A surface and its index. A surface is immutable, so any number of threads may query it.
#[derive(Debug)]
pub struct Surface<'a> {
    sheets: Vec<(Sheet<'a>, BoxPyramid)>,
    bounds: Aabb,
    tolerance: f64,
}

impl<'a> Surface<'a> {
    /// Builds the index of one or more sheets.
    ///
    /// `tolerance` is the length to which results are proven. `None` means 1e-9 times the diagonal
    /// of the surface's bounding box. The largest absolute coordinate of each sheet must be 0, or
    /// between [`SMALLEST_COORDINATE`] and [`LARGEST_COORDINATE`].
    ///
    /// # Errors
    /// [`Error::EmptyMesh`] if `sheets` is empty, [`Error::SheetOutOfRange`],
    /// [`Error::OptionOutOfRange`] if the tolerance is negative or not finite,
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn new(sheets: Vec<Sheet<'a>>, tolerance: Option<f64>, job: &Job<'_>) -> Result<Self> {
        let mut indexed = alloc::with_capacity(sheets.len())?;
        let mut bounds = Aabb::EMPTY;
        let count = sheets.len();
        for (k, sheet) in sheets.into_iter().enumerate() {
            let part = job.sub_job_of_item(k, count);
            let index = each_sheet!(&sheet, cells => BoxPyramid::build(cells, &part))?;
            check_single_precision_range(k, index.bounding_box())?;
            bounds = bounds.union(index.bounding_box());
            indexed.push((sheet, index));
        }
        if indexed.is_empty() {
            return Err(Error::EmptyMesh { what: "sheets" });
        }
        let tolerance = tolerance.unwrap_or(1e-9 * bounds.diagonal());
        Error::require(tolerance >= 0.0 && tolerance.is_finite(), "tolerance", tolerance, "finite and at least 0")?;
        Ok(Surface { sheets: indexed, bounds, tolerance })
    }

    /// The number of sheets.
    pub fn len(&self) -> usize {
        self.sheets.len()
    }

    /// Returns false: a surface has at least one sheet.
    pub fn is_empty(&self) -> bool {
        self.sheets.is_empty()
    }

    /// Sheet k.
    pub fn sheet(&self, k: usize) -> &Sheet<'a> {
        &self.sheets[k].0
    }

    /// Sheet k and its index.
    pub(crate) fn sheet_and_index(&self, k: usize) -> (&Sheet<'a>, &BoxPyramid) {
        let (sheet, index) = &self.sheets[k];
        (sheet, index)
    }

    /// The corners of the bounding box of the surface.
    pub fn bounds(&self) -> [DVec3; 2] {
        [self.bounds.low, self.bounds.high]
    }

    /// The length to which results are proven.
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The position and the derivatives at a place, with respect to the parameters of its cell.
    pub fn jet(&self, place: Place) -> Jet {
        let [i, j] = place.cell;
        self.sheet(place.sheet as usize).jet(i as usize, j as usize, place.u, place.v)
    }

    /// The unit normal at a place, or its limit at a pole; zero if no normal exists.
    pub fn normal(&self, place: Place) -> DVec3 {
        let [i, j] = place.cell;
        self.sheet(place.sheet as usize).normal(i as usize, j as usize, place.u, place.v)
    }

    /// The unit normal at a place whose derivatives are known.
    #[inline]
    pub(crate) fn normal_with_known_jet(&self, place: Place, jet: &Jet) -> DVec3 {
        jet.unit_normal_if_regular(self.max_derivative_rounding()).unwrap_or_else(|| self.normal(place))
    }

    /// True if the tangents at a place define a normal in spite of rounding.
    pub(crate) fn is_regular_at(&self, place: Place) -> bool {
        self.jet(place).unit_normal_if_regular(self.max_derivative_rounding()).is_some()
    }

    /// Upper bound of the error of a patch's derivatives that rounding of its control points
    /// causes.
    #[inline]
    fn max_derivative_rounding(&self) -> f64 {
        1024.0 * f64::EPSILON * self.max_coordinate()
    }

    /// The greatest absolute coordinate of the box.
    #[inline]
    pub(crate) fn max_coordinate(&self) -> f64 {
        self.bounds.low.abs().max(self.bounds.high.abs()).max_element()
    }

    /// The diagonal of the box.
    pub(crate) fn box_diagonal(&self) -> f64 {
        self.bounds.diagonal()
    }

    /// The number of cell corners of all sheets. For grids this is the number of nodes.
    pub fn node_count(&self) -> u64 {
        self.sheets.iter().map(|(sheet, _)| sheet.cells().map(|count| count as u64 + 1).iter().product::<u64>()).sum()
    }

    /// The number of cells of all sheets.
    pub fn cell_count(&self) -> u64 {
        self.sheets.iter().map(|(sheet, _)| sheet.cells().map(|count| count as u64).iter().product::<u64>()).sum()
    }

    /// Builds the cones of normals, unless they exist. Without this call, the first query about
    /// angles builds them. They take about 2/3 of a byte for each node. O(nodes).
    ///
    /// # Errors
    /// [`Error::OutOfMemory`], [`Error::Cancelled`].
    pub fn build_cones(&self, job: &Job<'_>) -> Result<()> {
        (0..self.len()).try_for_each(|k| self.cones_of_sheet(k, &job.sub_job_of_item(k, self.len())).map(|_| ()))
    }

    /// The cones of sheet k. Builds them if necessary.
    pub(crate) fn cones_of_sheet(&self, k: usize, job: &Job<'_>) -> Result<&ConePyramid> {
        let (sheet, index) = &self.sheets[k];
        each_sheet!(sheet, cells => index.get_or_build_cones(cells, job))
    }

    /// A cone that contains all unit normals of a block of a sheet, including the limits at poles.
    ///
    /// Block (r, c) of level k starts at the cell in row 4 r 2^k and column 4 c 2^k. It has 4 * 2^k
    /// rows and columns of cells, or fewer at the end of the sheet. The last level has at most two
    /// rows and two columns of blocks. Returns `None` if the block does not exist, or if the cones
    /// were not built.
    pub fn normal_cone(&self, sheet: usize, level: usize, [r, c]: [usize; 2]) -> Option<NormalCone> {
        self.sheets.get(sheet)?.1.cones_if_built()?.cone_of_block(level, r, c)
    }

    /// Size of the cones of normals in bytes; 0 before they are built.
    pub fn cone_bytes(&self) -> usize {
        self.sheets.iter().filter_map(|(_, index)| index.cones_if_built()).map(ConePyramid::byte_size).sum()
    }

    /// Size of the index in bytes, without the cones.
    pub fn index_bytes(&self) -> usize {
        self.sheets.iter().map(|(_, index)| index.byte_size()).sum()
    }
}

#[cfg(test)]
impl Surface<'_> {
    /// Builds cones that exclude nothing, so that searches run as if without cones.
    pub(crate) fn disable_cones(&mut self, job: &Job<'_>) -> Result<()> {
        self.build_cones(job)?;
        self.sheets.iter_mut().for_each(|(_, index)| index.replace_cones_by_full_cones());
        Ok(())
    }
}

/// Returns [`Error::SheetOutOfRange`] if single precision cannot hold the sheet's bounding box.
fn check_single_precision_range(sheet: usize, bounds: Aabb) -> Result<()> {
    // Overflows produce NaN, which is out of range too.
    let largest = [bounds.low, bounds.high]
        .iter()
        .flat_map(|corner| corner.abs().to_array())
        .fold(0.0, |most, x| if x > most || x.is_nan() { x } else { most });
    if largest == 0.0 || (SMALLEST_COORDINATE..=LARGEST_COORDINATE).contains(&largest) {
        return Ok(());
    }
    Err(Error::SheetOutOfRange { sheet: sheet as u64, value: if largest.is_nan() { f64::INFINITY } else { largest } })
}
