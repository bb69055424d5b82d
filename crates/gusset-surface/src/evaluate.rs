//! Points, normals and curvatures at many places, and parameters of whole sheets.
//!
//! Curvatures follow from the two fundamental forms in an orthonormal basis of the tangent plane.

use super::{Jet, Normal, NormalKind, Place, Sheet, Surface};
use glam::DVec3;
use gusset_base::error::{Element, Error, Result};
use gusset_base::job::Job;
use gusset_base::{alloc, par};

/// Number of places that a thread evaluates in one task.
const PLACES_PER_TASK: usize = 1 << 10;
/// Number of tasks between two progress reports.
const TASKS_PER_REPORT: usize = 32;

/// Curvatures of a surface at a point. They are positive where the surface bends towards its
/// normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curvatures {
    /// The larger and the smaller principal curvature.
    pub principal: [f64; 2],
    /// The principal directions: perpendicular unit tangents. At an umbilic, any two perpendicular
    /// tangents.
    pub directions: [DVec3; 2],
    /// The mean curvature: half the sum of the principal curvatures.
    pub mean: f64,
    /// The Gaussian curvature: the product of the principal curvatures.
    pub gaussian: f64,
}

/// Derivatives, normal and curvatures at a point of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LocalGeometry {
    /// The point and its derivatives with respect to the parameters of the cell.
    pub jet: Jet,
    /// The normal.
    pub normal: Normal,
    /// The curvatures; `None` where the surface is not regular.
    pub curvatures: Option<Curvatures>,
}

impl Jet {
    /// Principal curvatures and directions for the normal S_u x S_v; `None` where the surface is
    /// not regular.
    pub fn principal(&self) -> Option<Curvatures> {
        let normal = self.normal().try_normalize()?;
        // An orthonormal basis of the tangent plane: e = a S_u, f = b S_u + c S_v.
        let e = self.u.try_normalize()?;
        let f = normal.cross(e);
        let a = 1.0 / self.u.length();
        let c = 1.0 / self.v.dot(f);
        let b = -self.v.dot(e) * a * c;
        let [l, m, n] = [self.uu.dot(normal), self.uv.dot(normal), self.vv.dot(normal)];
        // The second fundamental form in this basis.
        let (p, q, r) = (a * a * l, a * (b * l + c * m), b * b * l + 2.0 * b * c * m + c * c * n);
        let (mean, half) = (0.5 * (p + r), 0.5 * (p - r));
        let radius = (half * half + q * q).sqrt();
        let along = if half >= 0.0 { (radius + half) * e + q * f } else { q * e + (radius - half) * f };
        let first = along.try_normalize().unwrap_or(e);
        let directions = [first, normal.cross(first)];
        let principal = [mean + radius, mean - radius];
        (mean.is_finite() && radius.is_finite()).then_some(Curvatures {
            principal,
            directions,
            mean,
            gaussian: p * r - q * q,
        })
    }
}

impl Place {
    /// Parameters in the whole sheet: the cell's row and column plus the parameters within the
    /// cell.
    pub fn parameters(&self) -> [f64; 2] {
        [f64::from(self.cell[0]) + self.u, f64::from(self.cell[1]) + self.v]
    }
}

impl Sheet<'_> {
    /// The cell at parameters of the whole sheet, and the parameters within it. Wraps parameters
    /// around in closed directions, and clamps them in open ones. `None` for NaN and infinity.
    pub fn locate(&self, u: f64, v: f64) -> Option<([usize; 2], [f64; 2])> {
        let (counts, closed) = (self.cells(), self.is_closed());
        let (mut cell, mut at) = ([0; 2], [0.0; 2]);
        for (k, t) in [u, v].into_iter().enumerate() {
            if !t.is_finite() {
                return None;
            }
            let count = counts[k] as f64;
            let t = if closed[k] { t - (t / count).floor() * count } else { t }.clamp(0.0, count);
            cell[k] = (t as usize).min(counts[k] - 1);
            at[k] = t - cell[k] as f64;
        }
        Some((cell, at))
    }
}

impl Surface<'_> {
    /// The place at parameters (u, v) of a sheet, in which node (i, j) has the parameters (i, j).
    /// Wraps parameters around in closed directions, and clamps them in open ones.
    ///
    /// # Errors
    /// [`Error::NoSuch`] if the sheet does not exist, or the parameters are not finite.
    pub fn place(&self, sheet: usize, [u, v]: [f64; 2]) -> Result<Place> {
        let location = if sheet < self.len() { self.sheet(sheet).locate(u, v) } else { None };
        let ([i, j], [u, v]) =
            location.ok_or(Error::NoSuch { element: Element::Place, index: 0, count: self.len() as u64 })?;
        Ok(Place { sheet: sheet as u32, cell: [i as u32, j as u32], u, v })
    }

    /// Whether a place exists: its sheet and cell exist, and its parameters are between 0 and 1.
    pub fn has_place(&self, place: &Place) -> bool {
        let within = |t: f64| (0.0..=1.0).contains(&t);
        let sheet = place.sheet as usize;
        sheet < self.len() && within(place.u) && within(place.v) && {
            let [rows, columns] = self.sheet(sheet).cells();
            (place.cell[0] as usize) < rows && (place.cell[1] as usize) < columns
        }
    }

    /// Derivatives, normal and curvatures at a place. The place must exist.
    pub fn local_geometry(&self, place: Place) -> LocalGeometry {
        let ([i, j], sheet) = (place.cell.map(|k| k as usize), self.sheet(place.sheet as usize));
        let jet = self.jet(place);
        let normal = sheet.normal_or_limit(i, j, place.u, place.v);
        let curvatures = if normal.kind == NormalKind::Regular { jet.principal() } else { None };
        LocalGeometry { jet, normal, curvatures }
    }

    /// Derivatives, normals and curvatures at many places. O(1) for each place, but O(cells of the
    /// side) at a collapsed side.
    ///
    /// # Errors
    /// [`Error::NoSuch`] with the first place that does not exist, [`Error::OutOfMemory`],
    /// [`Error::Cancelled`].
    pub fn evaluate(&self, places: &[Place], job: &Job<'_>) -> Result<Vec<LocalGeometry>> {
        if let Some(index) = places.iter().position(|place| !self.has_place(place)) {
            return Err(Error::NoSuch { element: Element::Place, index: index as u64, count: self.len() as u64 });
        }
        let mut geometries = alloc::with_capacity(places.len())?;
        for round in places.chunks(PLACES_PER_TASK * TASKS_PER_REPORT) {
            job.step(geometries.len() as f64 / places.len() as f64, "evaluating")?;
            let work = |range: std::ops::Range<usize>| {
                alloc::collect(round[range].iter().map(|&place| self.local_geometry(place)))
            };
            for part in par::map(job.requested_threads(), par::split_into_ranges(round.len(), PLACES_PER_TASK), work)? {
                geometries.append(&mut part?);
            }
        }
        Ok(geometries)
    }
}
