//! What a deformation does to a net: is it soft or hard (paper, "soft and hard deformations of a net")?
//!
//! The paper looks for glued nodes where the Jacobian determinant of the deformation is zero. That is neither necessary nor
//! sufficient: (x, y, 0) has determinant 0 everywhere and leaves a sheet in a plane z = const as it is, and rolling a sheet up
//! to a cylinder has a positive one and closes the sheet. A link is contracted if and only if the deformation brings its
//! ends together; so the links themselves are measured here, those that lead back to the first row and column among them, and the
//! determinant tells where space is turned inside out.

use super::field::{Step, deform};
use super::hidden::Hidden;
use super::topology::{GluingType, Links, classify_node};
use super::{Classes, Net, Planes, Real, Topology, each};
use crate::alloc;
use crate::error::{Error, Result};
use crate::job::Job;
use crate::par;
use glam::{DMat3, DVec3};

/// A link that a deformation has contracted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Contracted {
    /// The link.
    pub link: u32,
    /// What its first node's star has become, with all new links contracted; links that lead back count.
    pub star: GluingType,
}

/// What a deformation does to a net.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    /// Of each link, those that lead back included: its new length divided by its old one. NaN if it had none, or an end is
    /// missing.
    pub links: Vec<f64>,
    /// Of each cell: its new area divided by its old one, negative where the surface is folded over; if a field was given,
    /// where its determinant is. NaN if it had none, or is not there.
    pub cells: Vec<f64>,
    /// Of each cell, the determinant of the field's Jacobian at its centre; empty if no field was given.
    pub determinants: Vec<f64>,
    /// The links that have become a point: longer than the tolerance before and not glued, not longer now.
    pub contracted: Vec<Contracted>,
    /// The glued links whose ends are farther apart than the tolerance now.
    pub torn: Vec<u32>,
    /// The cells that are turned the other way than most.
    pub folded: Vec<u32>,
}

impl Analysis {
    /// Soft: nothing newly glued, nothing torn, nothing folded over. Else it is hard.
    pub fn is_soft(&self) -> bool {
        self.contracted.is_empty() && self.torn.is_empty() && self.folded.is_empty()
    }
}

/// Compares a net after a deformation with what it was before. `tolerance`: lengths up to it are none.
///
/// A fold is found where two neighbouring cells that faced the same way, within 90 degrees, now do not. O(nodes), 24 bytes a
/// node.
///
/// # Errors
/// [`Error::OptionOutOfRange`] for a tolerance that is negative, infinite or NaN, [`Error::SidesDiffer`],
/// [`Error::CrossingCell`] if what is newly glued is no surface, [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn analyse(before: &Net<'_>, after: &Net<'_>, tolerance: f64, job: &Job<'_>) -> Result<Analysis> {
    if before.shape() != after.shape() {
        let (a, b) = (before.shape().node_count() as u32, after.shape().node_count() as u32);
        return Err(Error::SidesDiffer { a, b });
    }
    let mut found = compare(before, after, tolerance, job)?;
    let signs = each!(before.coordinates(), old => each!(after.coordinates(), new => turned(old, new)))?;
    sign(&mut found, &signs);
    Ok(found)
}

/// As [`analyse`], of what fields do to a net, which stays as it is. The determinants are found by central differences; where they
/// have another sign than in most cells, the net is folded over. Also 8 bytes a node, and a copy of the net.
///
/// # Errors
/// Also those of [`deform`].
pub fn analyse_field(net: &Net<'_>, steps: &[Step<'_>], tolerance: f64, job: &Job<'_>) -> Result<Analysis> {
    let mut after = net.copied()?;
    deform(&mut after, steps, &job.part(0.0, 0.3))?;
    let mut found = compare(net, &after, tolerance, &job.part(0.3, 0.6))?;
    job.step(0.6, "analyse")?;
    let determinants = each!(net.coordinates(), planes => determinants(planes, steps, job.threads()))?;
    let turned = |&determinant: &f64| if determinant < 0.0 { -1 } else { 1 };
    let signs: Vec<i8> = alloc::collect(determinants.iter().map(turned))?;
    found.determinants = determinants;
    sign(&mut found, &signs);
    Ok(found)
}

/// The topology with more links contracted: the gluings that a hard deformation has brought about made part of the net.
/// Follow it with [`snap`](super::field::snap).
///
/// # Errors
/// [`Error::NoSuchLink`], [`Error::CrossingCell`], [`Error::OutOfMemory`].
pub fn absorb(topology: &Topology, links: impl IntoIterator<Item = u32>) -> Result<Topology> {
    let (shape, mut matrix) = (topology.shape(), topology.matrix()?);
    for link in links {
        if link as usize >= 2 * shape.node_count() {
            return Err(Error::NoSuchLink { link: link.into() });
        }
        matrix.set(link, true);
    }
    let glued = Topology::new(shape, Links::Matrix(matrix), topology.seams())?;
    Ok(glued.with_reversed(topology.is_reversed()))
}

/// All but what takes signs.
fn compare(before: &Net<'_>, after: &Net<'_>, tolerance: f64, job: &Job<'_>) -> Result<Analysis> {
    if !(tolerance >= 0.0 && tolerance.is_finite()) {
        return Err(Error::OptionOutOfRange { option: "tolerance", value: tolerance });
    }
    job.step(0.0, "analyse")?;
    let (shape, classes) = (before.shape(), Classes::of(before.topology())?);
    let mut links = alloc::zeroed(2 * shape.node_count())?;
    let rows = links.chunks_mut(2 * shape.columns()).enumerate();
    let changes = each!(before.coordinates(), old => each!(after.coordinates(), new => {
        let row = |(i, ratios)| row_of_links((old, new), i, ratios, &classes, tolerance);
        par::map(job.threads(), rows, row)
    }));
    let (mut contracted, mut torn) = (Vec::new(), Vec::new());
    for change in changes {
        let (new, lost) = change?;
        alloc::append(&mut contracted, &new)?;
        alloc::append(&mut torn, &lost)?;
    }
    let contracted = with_stars(before.topology(), &contracted)?;
    let mut cells = alloc::filled(f64::NAN, shape.cell_count())?;
    let hidden = Hidden::of(before)?;
    each!(before.coordinates(), old => each!(after.coordinates(), new => {
        par::map(job.threads(), cells.chunks_mut(shape.columns() - 1).enumerate(), |(i, ratios)| {
            for (j, ratio) in ratios.iter_mut().enumerate().filter(|&(j, _)| !hidden.contains(i, j)) {
                *ratio = area_vector(new, i, j).length() / area_vector(old, i, j).length();
                // 0 / 0 is NaN already; an area out of nothing has no ratio either.
                *ratio = if ratio.is_infinite() { f64::NAN } else { *ratio };
            }
        });
    }));
    Ok(Analysis { links, cells, determinants: Vec::new(), contracted, torn, folded: Vec::new() })
}

/// The ratios of the links of row i, those newly contracted, and those torn.
fn row_of_links<A: Real, B: Real>(
    (old, new): (&Planes<'_, A>, &Planes<'_, B>),
    i: usize,
    ratios: &mut [f64],
    classes: &Classes,
    tolerance: f64,
) -> Result<(Vec<u32>, Vec<u32>)> {
    let shape = old.shape();
    let (mut contracted, mut torn) = (Vec::new(), Vec::new());
    for (link, ratio) in (2 * shape.node(i, 0)..).zip(ratios) {
        let [(a, b), (c, d)] = shape.ends(link).map(|node| shape.place(node));
        let before = old.get(a, b).distance(old.get(c, d));
        let after = new.get(a, b).distance(new.get(c, d));
        *ratio = if before > 0.0 { after / before } else { f64::NAN };
        let glued = classes.contracts(link);
        if !glued && after <= tolerance && before > tolerance {
            alloc::push(&mut contracted, link)?;
        } else if glued && after > tolerance {
            alloc::push(&mut torn, link)?;
        }
    }
    Ok((contracted, torn))
}

/// The types of the stars at newly contracted links.
fn with_stars(topology: &Topology, links: &[u32]) -> Result<Vec<Contracted>> {
    if links.is_empty() {
        return Ok(Vec::new());
    }
    let classes = Classes::of(&absorb(topology, links.iter().copied())?)?;
    let mut contracted = alloc::with_capacity(links.len())?;
    contracted.extend(links.iter().filter_map(|&link| {
        let (i, j) = topology.shape().place(link / 2);
        classify_node(&classes, i, j, true).map(|star| Contracted { link, star })
    }));
    Ok(contracted)
}

/// Twice the area vector of cell (i, j).
fn area_vector<T: Real>(planes: &Planes<'_, T>, i: usize, j: usize) -> DVec3 {
    (planes.get(i + 1, j + 1) - planes.get(i, j)).cross(planes.get(i + 1, j) - planes.get(i, j + 1))
}

/// Of each cell, 1 or -1: two neighbours differ if a fold has come between them. Each row of cells goes on from the one above at its first cell.
fn turned<A: Real, B: Real>(old: &Planes<'_, A>, new: &Planes<'_, B>) -> Result<Vec<i8>> {
    let shape = old.shape();
    let mut signs = alloc::with_capacity::<i8>(shape.cell_count())?;
    let mut above = [DVec3::ZERO; 2];
    let mut above_sign = 1;
    for i in 0..shape.rows() - 1 {
        let (mut last, mut last_sign) = (above, above_sign);
        for j in 0..shape.columns() - 1 {
            let vectors = [area_vector(old, i, j), area_vector(new, i, j)];
            if vectors.iter().all(|vector| vector.length_squared() > 0.0) {
                let folded = last[0].dot(vectors[0]) > 0.0 && last[1].dot(vectors[1]) < 0.0;
                (last, last_sign) = (vectors, if folded { -last_sign } else { last_sign });
            }
            if j == 0 {
                (above, above_sign) = (last, last_sign);
            }
            signs.push(last_sign);
        }
    }
    Ok(signs)
}

/// Gives the ratios of cells their signs, and finds those that differ from most.
fn sign(found: &mut Analysis, signs: &[i8]) {
    let balance: i64 =
        found.cells.iter().zip(signs).filter(|(ratio, _)| !ratio.is_nan()).map(|(_, &sign)| i64::from(sign)).sum();
    let most = if balance < 0 { -1 } else { 1 };
    // Without a field, which way is over is for the majority to say.
    let over = if found.determinants.is_empty() { most } else { 1 };
    for (cell, (ratio, &sign)) in found.cells.iter_mut().zip(signs).enumerate() {
        *ratio *= f64::from(sign * over);
        if sign != most && !ratio.is_nan() {
            found.folded.push(cell as u32);
        }
    }
}

/// The determinants of the Jacobian at the centres of all cells, by central differences.
fn determinants<T: Real>(planes: &Planes<'_, T>, steps: &[Step<'_>], threads: usize) -> Result<Vec<f64>> {
    let columns = planes.shape().columns() - 1;
    let mut determinants = alloc::zeroed(planes.shape().cell_count())?;
    let results = par::map(threads, determinants.chunks_mut(columns).enumerate(), |(i, row)| {
        for (j, determinant) in row.iter_mut().enumerate() {
            let [a, b, c, d] = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)].map(|(i, j)| planes.get(i, j));
            let size = (c - a).length() + (d - b).length();
            *determinant = jacobian((a + b + c + d) / 4.0, size, steps).determinant();
        }
        Ok(())
    });
    results.into_iter().collect::<Result<()>>()?;
    Ok(determinants)
}

/// The Jacobian of a chain of fields at a point, by central differences over a step that balances what they neglect with what
/// rounding does: the cube root of the precision, times the larger of `size` and the coordinates.
pub fn jacobian(point: DVec3, size: f64, steps: &[Step<'_>]) -> DMat3 {
    let step = 6e-6 * size.max(point.abs().max_element());
    let offsets = DVec3::AXES.map(|axis| step * axis);
    let points = [0, 1, 2].map(|k| [point + offsets[k], point - offsets[k]]);
    let [mut x, mut y, mut z] = [0, 1, 2].map(|axis| points.as_flattened().iter().map(|p| p[axis]).collect::<Vec<_>>());
    for step in steps.iter().filter(|step| step.strength != 0.0) {
        step.field.map(step.strength, [&mut x, &mut y, &mut z]);
    }
    let column = |k: usize| {
        let of = |values: &[f64]| values[2 * k] - values[2 * k + 1];
        // The step as it was rounded.
        DVec3::new(of(&x), of(&y), of(&z)) / (points[k][0][k] - points[k][1][k])
    };
    DMat3::from_cols(column(0), column(1), column(2))
}
