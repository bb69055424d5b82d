//! The patch of one hole: triangulation, refinement and fairing, in this order.

use super::clip::{clip_ears, mean_normal};
use super::refine::refine;
use super::request::{Fairing, Options, Refinement, Weight};
use super::triangulate::{Polygon, minimum_weight};
use crate::alloc;
use crate::error::Result;
use crate::fair::{Plate, Weights, thin_plate};
use crate::geom::scale::common_unit;
use crate::job::Job;
use crate::remesh::PatchMesh;
use glam::DVec3;

/// Loops of at most this many vertices are triangulated as a whole.
const MAX_EXACT_RIM: usize = 500;
/// A rim is planar if it deviates from a plane by no more than this part of its size.
const MAX_RELATIVE_DEVIATION: f64 = 1e-6;
/// New vertices of a hole at the most, if the caller says nothing.
const MAX_NEW_VERTICES: u32 = 50_000;

/// A hole and what lies round it, in numbers of its own: the rim's vertices from 0 on, in the
/// direction in which new faces run along it (the surface is on the right), and then the other old
/// vertices.
pub(crate) struct Rim {
    /// How many vertices the rim has.
    pub(crate) count: usize,
    /// The rim's points and the other old vertices'.
    pub(crate) points: Vec<DVec3>,
    /// The old faces with a vertex on the rim, as triangles.
    pub(crate) around: Vec<[u32; 3]>,
    /// The vector area of the old face at the edge from each rim vertex to the next; 0 if it is not
    /// known.
    pub(crate) across: Vec<DVec3>,
    /// The mean length of the old edges at each rim vertex.
    pub(crate) scale: Vec<f64>,
    /// True of the rim vertices that have faces all round once the hole is filled.
    pub(crate) whole: Vec<bool>,
}

/// The plan: the rim's vertices keep their numbers in the [`Rim`], and `points` come after them.
pub(crate) struct Patch {
    /// The new vertices.
    pub(crate) points: Vec<DVec3>,
    /// The new faces.
    pub(crate) triangles: Vec<[u32; 3]>,
}

/// Plans how a hole is filled; `None` if every triangulation would have an edge that is `taken`,
/// which is asked of numbers of rim vertices.
///
/// O(n^3) for a rim of n <= 500 vertices and 40 n^2 bytes; O(n log n), and linear memory, for
/// longer ones. Refinement and fairing of m new vertices: O(m log m), and O(m^1.5) for the sparse
/// factor.
pub(crate) fn patch(
    rim: &Rim,
    options: &Options,
    taken: &impl Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Option<Patch>> {
    let unit = common_unit(&rim.points);
    let origin = rim.points[0] / unit;
    let points = alloc::collect(rim.points.iter().map(|&p| p / unit - origin))?;
    let Some(triangles) = triangulate(rim, &points[..rim.count], options, taken, &job.part(0.0, 0.4))? else {
        return Ok(None);
    };
    let Refinement::RimDensity(limit) = options.refinement else {
        return Ok(Some(Patch { points: Vec::new(), triangles }));
    };
    let limit = if limit == 0 { MAX_NEW_VERTICES } else { limit };
    let mut mesh = PatchMesh::new(alloc::copied(&points[..rim.count])?, triangles)?;
    let scale = alloc::collect(rim.scale.iter().map(|s| s / unit))?;
    refine(&mut mesh, scale, limit, taken, &job.part(0.4, 0.6))?;
    if options.fairing == Fairing::ThinPlate {
        fair(rim, &points, &mut mesh, &job.part(0.6, 1.0))?;
    }
    let new = alloc::collect(mesh.points[rim.count..].iter().map(|&p| (p + origin) * unit))?;
    Ok(Some(Patch { points: new, triangles: mesh.triangles }))
}

fn triangulate(
    rim: &Rim,
    points: &[DVec3],
    options: &Options,
    taken: &impl Fn(u32, u32) -> bool,
    job: &Job<'_>,
) -> Result<Option<Vec<[u32; 3]>>> {
    let n = points.len();
    if n > MAX_EXACT_RIM {
        let Some(triangles) = clip_ears(points, taken, job)? else {
            return Ok(None);
        };
        // The shape of the ears is what was left at their turn.
        let mut mesh = PatchMesh::new(alloc::copied(points)?, triangles)?;
        mesh.relax(n, taken, &job.part(1.0, 1.0))?;
        return Ok(Some(mesh.triangles));
    }
    let squared = |i: usize| points[i].distance_squared(points[(i + 1) % n]);
    // The work starts from the longest side, wherever the caller's loop begins.
    let root = (0..n).rev().max_by(|&i, &j| squared(i).total_cmp(&squared(j))).unwrap_or(0);
    let name = |i: usize| ((root + 1 + i) % n) as u32;
    let own = alloc::collect((0..n).map(|i| points[name(i) as usize]))?;
    let across = alloc::collect((0..n).map(|i| unit_vector(rim.across[name(i) as usize])))?;
    // On a plane the surface beyond the rim has no say.
    let flat = options.weight == Weight::AreaAndBend && is_planar(points);
    let weight = if flat { Weight::Area } else { options.weight };
    let polygon = Polygon { points: &own, across: &across };
    let found = minimum_weight(&polygon, weight, |i, k| taken(name(i), name(k)), job)?;
    Ok(found.map(|mut triangles| {
        triangles.iter_mut().for_each(|triangle| *triangle = triangle.map(|v| name(v as usize)));
        triangles
    }))
}

/// True if all points are as near to their mean plane as round-off of single precision may have
/// left them.
fn is_planar(points: &[DVec3]) -> bool {
    let normal = mean_normal(points);
    let size = points.iter().map(|p| p.distance(points[0])).fold(0.0, f64::max);
    points.iter().all(|&p| (p - points[0]).dot(normal).abs() <= MAX_RELATIVE_DEVIATION * size)
}

/// The direction of a vector of any length; 0 for 0.
fn unit_vector(v: DVec3) -> DVec3 {
    (v / common_unit(&[v])).normalize_or_zero()
}

/// Moves the new vertices of `mesh`; the rim and the old vertices round it stay.
fn fair(rim: &Rim, points: &[DVec3], mesh: &mut PatchMesh, job: &Job<'_>) -> Result<()> {
    let (n, old, new) = (rim.count, points.len(), mesh.points.len() - rim.count);
    // The rim, the old vertices, the new ones.
    let mut all = alloc::with_capacity(old + new)?;
    all.extend_from_slice(points);
    all.extend_from_slice(&mesh.points[n..]);
    let name = |v: u32| if (v as usize) < n { v } else { v + (old - n) as u32 };
    let mut triangles = alloc::with_capacity(rim.around.len() + mesh.triangles.len())?;
    triangles.extend_from_slice(&rim.around);
    triangles.extend(mesh.triangles.iter().map(|triangle| triangle.map(name)));
    let mut free = alloc::filled(false, old + new)?;
    free[old..].fill(true);
    let mut centres = alloc::copied(&free)?;
    centres[..n].copy_from_slice(&rim.whole);
    let plate = Plate {
        triangles: &triangles,
        free: &free,
        centres: &centres,
        weights: Weights::Cotangent,
        shape: None,
        layout: None,
    };
    thin_plate(&mut all, &plate, job)?;
    mesh.points[n..].copy_from_slice(&all[old..]);
    Ok(())
}
