//! Classification of a deformation as soft or hard (Deryagin, "Soft and hard deformations of a
//! net").
//!
//! The paper looks for glued nodes where the Jacobian determinant of the deformation vanishes. This
//! condition is neither necessary nor sufficient. The map (x, y, 0) has determinant 0 everywhere
//! but leaves a sheet in a plane z = const unchanged. Rolling a sheet up to a cylinder has a
//! positive determinant but closes the sheet. A deformation contracts a link if and only if it
//! brings the link's ends together. The links are therefore measured, including closing links, and
//! the determinant shows where space is inverted. O(nodes).

use super::field::{DeformationStep, deform};
use super::hidden_cells::HiddenCells;
use super::topology::{ContractedLinks, GluingType, classify_node};
use super::{Net, NodeClasses, Real, Topology, XyzMatrices, chunks, each, fold};
use glam::{DMat3, DVec3};
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::job::Job;

/// A link that a deformation has contracted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ContractedLink {
    /// The link.
    pub link: u32,
    /// The type of its first node's star with all new links contracted, closing links included.
    pub star: GluingType,
}

/// The effect of a deformation on a net.
#[derive(Debug, Clone, PartialEq)]
pub struct DeformationAnalysis {
    /// The ratio of new to old length of each link, closing links included. NaN if the old length
    /// is 0 or an end is missing.
    pub links: Vec<f64>,
    /// The ratio of new to old area of each cell, negative where the surface is folded over or, if
    /// a field was given, where the determinant is negative. NaN if the old area is 0 or the cell
    /// is missing.
    pub cells: Vec<f64>,
    /// The determinant of the field's Jacobian at the centre of each cell; empty without a field.
    pub determinants: Vec<f64>,
    /// The links contracted to a point: longer than the tolerance before, not glued, and at most
    /// that long now.
    pub contracted: Vec<ContractedLink>,
    /// The glued links whose ends are farther apart than the tolerance now.
    pub torn: Vec<u32>,
    /// The cells whose orientation differs from the majority.
    pub folded: Vec<u32>,
}

impl DeformationAnalysis {
    /// Returns true for a soft deformation: no new gluing, no tear, no fold. Otherwise it is hard.
    pub fn is_soft(&self) -> bool {
        self.contracted.is_empty() && self.torn.is_empty() && self.folded.is_empty()
    }
}

/// Compares a net after a deformation with the net before. Lengths up to `tolerance` count as 0.
///
/// The net is folded at a link if the two cells of the link lie on the same side of it in one
/// plane. It is folded in a cell if two opposite sides of the cell cross. Folds that existed before
/// do not count. Both tests allow for the tolerance and the rounding of the coordinates, and skip
/// cells that are not wider than that.
///
/// Folds divide each connected component of cells into two sides, and the smaller side is folded.
/// If a fold ends within the surface and divides nothing, the cells along it are folded. Invertible
/// affine maps fold nothing, and bending folds nothing until a dihedral angle vanishes. Links
/// across seams are tested only at closed sides. O(nodes), 24 bytes a node, and 9 more if there are
/// folds.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a tolerance that is negative, infinite or NaN,
/// [`Error::SidesDiffer`], [`Error::CrossingCell`] if the new gluing crosses a cell,
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn analyse(before: &Net<'_>, after: &Net<'_>, tolerance: f64, job: &Job<'_>) -> Result<DeformationAnalysis> {
    if before.shape() != after.shape() {
        let (a, b) = (before.shape().node_count() as u32, after.shape().node_count() as u32);
        return Err(Error::SidesDiffer { a, b });
    }
    let mut found = analyse_without_signs(before, after, tolerance, &job.sub_job(0.0, 0.5))?;
    negate_ratios_of_folded_cells(
        &mut found,
        &fold::signs_of_turned_over_cells(before, after, tolerance, &job.sub_job(0.5, 1.0))?,
    );
    Ok(found)
}

/// Classifies a chain of fields like [`analyse`], without changing the net. Determinants are found
/// by central differences. Cells whose sign differs from the majority are folded. A determinant
/// below the error of the differences counts as 0 and has an undefined sign. If all signs agree,
/// folds are found as in [`analyse`]. Takes 8 bytes a node more, and a copy of the net.
///
/// # Errors
/// The errors of [`analyse`] and [`deform`].
pub fn analyse_field(
    net: &Net<'_>,
    steps: &[DeformationStep<'_>],
    tolerance: f64,
    job: &Job<'_>,
) -> Result<DeformationAnalysis> {
    let mut after = net.copied()?;
    deform(&mut after, steps, &job.sub_job(0.0, 0.3))?;
    let mut found = analyse_without_signs(net, &after, tolerance, &job.sub_job(0.3, 0.6))?;
    found.determinants =
        each!(net.coordinates(), planes => jacobian_determinants(planes, steps, &job.sub_job(0.6, 0.8)))?;
    if !mark_minority_signs_as_folds(&mut found) {
        negate_ratios_of_folded_cells(
            &mut found,
            &fold::signs_of_turned_over_cells(net, &after, tolerance, &job.sub_job(0.8, 1.0))?,
        );
    }
    Ok(found)
}

/// Contracts more links of a topology, which makes the gluings of a hard deformation part of the
/// net. Follow it with [`snap_glued_nodes`](super::field::snap_glued_nodes).
///
/// # Errors
/// [`Error::NoSuch`], [`Error::CrossingCell`], [`Error::OutOfMemory`].
pub fn contract_links(topology: &Topology, links: impl IntoIterator<Item = u32>, job: &Job<'_>) -> Result<Topology> {
    let (shape, mut matrix) = (topology.shape(), topology.to_link_matrix()?);
    for link in links {
        if link as usize >= shape.link_count() {
            return Err(Error::NoSuch { element: Element::Link, index: link.into(), count: shape.link_count() as u64 });
        }
        matrix.set_contracted(link, true);
    }
    let glued = Topology::new_cancellable(shape, ContractedLinks::Matrix(matrix), topology.seams(), job, "absorbing")?;
    Ok(glued.with_reversed(topology.is_reversed()))
}

/// Compares two nets without signs.
fn analyse_without_signs(
    before: &Net<'_>,
    after: &Net<'_>,
    tolerance: f64,
    job: &Job<'_>,
) -> Result<DeformationAnalysis> {
    Error::require(tolerance.is_finite() && tolerance >= 0.0, "tolerance", tolerance, "finite and at least 0")?;
    job.step(0.0, "analyse")?;
    let (shape, classes) = (before.shape(), NodeClasses::new(before.topology())?);
    let mut links = alloc::zeroed(shape.link_count())?;
    let width = 2 * shape.columns();
    let changes: Vec<_> = each!(before.coordinates(), old => each!(after.coordinates(), new => {
        let row = |i: usize, ratios: &mut [f64]| write_length_ratios_of_row((old, new), i, ratios, &classes, tolerance);
        chunks::map_rows(&mut links, width, (&job.sub_job(0.0, 0.5), "analyse"), row)?.collect()
    }));
    let (mut contracted, mut torn) = (Vec::new(), Vec::new());
    for change in changes {
        let (new, lost) = change?;
        alloc::append(&mut contracted, &new)?;
        alloc::append(&mut torn, &lost)?;
    }
    let contracted = classify_contracted_links(before.topology(), &contracted, &job.sub_job(0.5, 0.5))?;
    let mut cells = alloc::filled(f64::NAN, shape.cell_count())?;
    let hidden = HiddenCells::new(before)?;
    each!(before.coordinates(), old => each!(after.coordinates(), new => {
        chunks::map_rows(&mut cells, shape.columns() - 1, (&job.sub_job(0.5, 1.0), "analyse"), |i, ratios| {
            for (j, ratio) in ratios.iter_mut().enumerate().filter(|&(j, _)| !hidden.contains(i, j)) {
                *ratio = area_vector(new, i, j).length() / area_vector(old, i, j).length();
                // 0 / 0 is NaN already; the ratio of an area grown from 0 is NaN too.
                *ratio = if ratio.is_infinite() { f64::NAN } else { *ratio };
            }
        })?
        .for_each(drop);
    }));
    Ok(DeformationAnalysis { links, cells, determinants: Vec::new(), contracted, torn, folded: Vec::new() })
}

/// Writes for each link of row i its new length divided by its old one. Returns two lists: the
/// links newly contracted, and the glued links that are torn.
fn write_length_ratios_of_row<A: Real, B: Real>(
    (old, new): (&XyzMatrices<'_, A>, &XyzMatrices<'_, B>),
    i: usize,
    ratios: &mut [f64],
    classes: &NodeClasses,
    tolerance: f64,
) -> Result<(Vec<u32>, Vec<u32>)> {
    let shape = old.shape();
    let (mut contracted, mut torn) = (Vec::new(), Vec::new());
    for (link, ratio) in (shape.horizontal_link(i, 0)..).zip(ratios) {
        let [(a, b), (c, d)] = shape.ends_of_link(link).map(|node| shape.row_and_column(node));
        let before = old.get(a, b).distance(old.get(c, d));
        let after = new.get(a, b).distance(new.get(c, d));
        *ratio = if before > 0.0 { after / before } else { f64::NAN };
        let glued = classes.has_identified_ends(link);
        if !glued && after <= tolerance && before > tolerance {
            alloc::push(&mut contracted, link)?;
        } else if glued && after > tolerance {
            alloc::push(&mut torn, link)?;
        }
    }
    Ok((contracted, torn))
}

/// Returns the types of the stars at newly contracted links.
fn classify_contracted_links(topology: &Topology, links: &[u32], job: &Job<'_>) -> Result<Vec<ContractedLink>> {
    if links.is_empty() {
        return Ok(Vec::new());
    }
    let classes = NodeClasses::new_cancellable(&contract_links(topology, links.iter().copied(), job)?, job, "analyse")?;
    alloc::gather(links.iter().filter_map(|&link| {
        let (i, j) = topology.shape().row_and_column(link / 2);
        classify_node(&classes, i, j, true).map(|star| ContractedLink { link, star })
    }))
}

/// Returns twice the area vector of cell (i, j).
fn area_vector<T: Real>(planes: &XyzMatrices<'_, T>, i: usize, j: usize) -> DVec3 {
    (planes.get(i + 1, j + 1) - planes.get(i, j)).cross(planes.get(i + 1, j) - planes.get(i, j + 1))
}

/// Records the existing cells of sign -1 as folded. `signs` has one sign for each cell, or is
/// empty.
fn negate_ratios_of_folded_cells(analysis: &mut DeformationAnalysis, signs: &[i8]) {
    for ((cell, ratio), _) in (0..).zip(&mut analysis.cells).zip(signs).filter(|&(_, &sign)| sign < 0) {
        *ratio = -*ratio;
        if !ratio.is_nan() {
            analysis.folded.push(cell);
        }
    }
}

/// Gives ratios the signs of the determinants, and records the cells whose sign differs from the
/// majority. Returns false if all signs agree.
fn mark_minority_signs_as_folds(analysis: &mut DeformationAnalysis) -> bool {
    let sign = |determinant: f64| i64::from(determinant > 0.0) - i64::from(determinant < 0.0);
    let existing = analysis.cells.iter_mut().zip(&analysis.determinants).filter(|(ratio, _)| !ratio.is_nan());
    let balance: i64 = existing.map(|(_, &determinant)| sign(determinant)).sum();
    for ((cell, ratio), &determinant) in (0..).zip(&mut analysis.cells).zip(&analysis.determinants) {
        if determinant < 0.0 {
            *ratio = -*ratio;
        }
        if !ratio.is_nan() && sign(determinant) * (if balance < 0 { -1 } else { 1 }) < 0 {
            analysis.folded.push(cell);
        }
    }
    !analysis.folded.is_empty()
}

/// Returns the determinants of the Jacobian at the centres of all cells, by central differences.
fn jacobian_determinants<T: Real>(
    planes: &XyzMatrices<'_, T>,
    steps: &[DeformationStep<'_>],
    job: &Job<'_>,
) -> Result<Vec<f64>> {
    let columns = planes.shape().columns() - 1;
    let mut determinants = alloc::zeroed(planes.shape().cell_count())?;
    chunks::map_rows(&mut determinants, columns, (job, "analyse"), |i, row| {
        for (j, determinant) in row.iter_mut().enumerate() {
            let [a, b, c, d] = planes.cell_corners(i, j);
            let size = (c - a).length() + (d - b).length();
            let (jacobian, error) = jacobian_by_central_differences((a + b + c + d) / 4.0, size, steps);
            let [x, y, z] = [jacobian.x_axis, jacobian.y_axis, jacobian.z_axis];
            // The error bound of the determinant, from the error bound of each column.
            let off = error * (x.cross(y).length() + y.cross(z).length() + z.cross(x).length());
            *determinant = if jacobian.determinant().abs() <= off { 0.0 } else { jacobian.determinant() };
        }
    })?
    .for_each(drop);
    Ok(determinants)
}

/// Returns the Jacobian of a chain of fields at a point, by central differences, and an error bound
/// of its columns. The step balances truncation against rounding: the cube root of the precision,
/// times the larger of `size` and the coordinates.
pub fn jacobian_by_central_differences(point: DVec3, size: f64, steps: &[DeformationStep<'_>]) -> (DMat3, f64) {
    let step = 6e-6 * size.max(point.abs().max_element());
    let offsets = DVec3::AXES.map(|axis| step * axis);
    let points = [0, 1, 2].map(|k| [point + offsets[k], point - offsets[k]]);
    let [mut x, mut y, mut z] = [0, 1, 2].map(|axis| points.as_flattened().iter().map(|p| p[axis]).collect::<Vec<_>>());
    for step in steps.iter().filter(|step| step.strength != 0.0) {
        step.field.map_points(step.strength, [&mut x, &mut y, &mut z]);
    }
    let column = |k: usize| {
        let of = |values: &[f64]| values[2 * k] - values[2 * k + 1];
        // The rounded step.
        DVec3::new(of(&x), of(&y), of(&z)) / (points[k][0][k] - points[k][1][k])
    };
    let jacobian = DMat3::from_cols(column(0), column(1), column(2));
    let largest = |values: &[f64]| values.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let ratio = [0, 1, 2].map(|k| jacobian.col(k).length()).into_iter().fold(0.0, f64::max);
    // The rounding errors of the results and their terms, doubled to allow for truncation.
    let rounded =
        largest(&x).max(largest(&y)).max(largest(&z)).max(ratio * point.abs().max_element()).max(ratio * size);
    (jacobian, 32.0 * f64::EPSILON * rounded / step)
}
