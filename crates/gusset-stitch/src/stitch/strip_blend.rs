//! A blend that replaces a strip: triangles as fine as those around it, on a surface tangent to
//! both pieces; see [`crate::blend`].

use super::grid::FaceList;
use super::guide_curves::GuideCurves;
use super::strip::{RimParents, Strip};
use super::strip_neighbourhood::StripNeighbourhood;
use crate::blend::{self, BlendFairing, MAX_FAN_TRIANGLES, NewVertexLimits, OldRing, SecondRing};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::triangle_places::nearest_places;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{MAX_ELEMENTS, Mesh};

/// The width, in mean radii of the larger rim, from which a blend follows the strip.
const MIN_BLENDED_GAP_RADII: f64 = 3.0;
/// The same width with a guide, which is nearer to the old surface than the strip, relative to that.
const GUIDED_REACH_RATIO: f64 = 0.2;
/// The limits on blends. A gap that needs more vertices, or longer edges, is too wide for a blend.
const BLEND_VERTEX_LIMITS: NewVertexLimits =
    NewVertexLimits { max_estimated_vertices: 50_000, max_vertices_per_rim_vertex: 16, max_side_growth: 2.0 };

/// The fairing attempts, in order, until nothing intersects.
pub(super) const FAIRING_ATTEMPTS: [BlendFairing; 4] = [
    BlendFairing { rounds: 2, unfolds: false },
    BlendFairing { rounds: 2, unfolds: true },
    BlendFairing { rounds: 1, unfolds: true },
    BlendFairing::WITHOUT_FAIRING,
];

/// The faces and vertices that replace the strip's.
pub(super) struct StripBlend {
    pub(super) faces: FaceList,
    /// The new vertices, in the rims' unit.
    pub(super) points: Vec<DVec3>,
    /// The positions without fairing.
    pub(super) unfaired: Vec<DVec3>,
    pub(super) parents: Vec<RimParents>,
}

/// Plans the blend for a strip of triangles without rows. Returns `None` if the blend would need
/// too many vertices. One pass over all old faces.
pub(super) fn plan_strip_blend(
    whole: &Mesh,
    strip: &Strip,
    unit: f64,
    job: &Job<'_>,
) -> Result<Option<blend::BlendPlan<impl Fn(u32, u32) -> bool + use<>>>> {
    let (mut ring, edges) = old_ring_of_strip(whole, strip, unit, &job.sub_job(0.0, 0.0))?;
    let taken = move |u: u32, v: u32| edges.binary_search(&(u.min(v), u.max(v))).is_ok();
    let triangles = alloc::copied(strip.faces.corners.as_chunks::<3>().0)?;
    let curves = if strip.has_wide_gap() { GuideCurves::new(strip)? } else { None };
    if curves.is_some() {
        ring.max_width_without_springs *= GUIDED_REACH_RATIO;
    }
    let origin = ring.origin;
    let guide = curves.as_ref().map(|curves| {
        move |points: &mut [DVec3]| {
            points.iter_mut().for_each(|p| *p += origin);
            let parents = parents_of_new_vertices(strip, points, &job.sub_job(0.0, 0.0))?;
            points.iter_mut().zip(&parents).for_each(|(p, parents)| *p = curves.point_at(parents) - origin);
            Ok(())
        }
    });
    let guide = guide.as_ref().map(|guide| guide as &blend::GuideSurface<'_>);
    blend::BlendPlan::new(ring, triangles, BLEND_VERTEX_LIMITS, taken, guide, job)
}

/// Creates the blend that replaces the strip.
pub(super) fn create_strip_blend(
    plan: &blend::BlendPlan<impl Fn(u32, u32) -> bool>,
    strip: &Strip,
    way: BlendFairing,
    job: &Job<'_>,
) -> Result<StripBlend> {
    let made = plan.create_blend(way, &job.sub_job(0.0, 0.9))?;
    Error::check_count("corners of the strip", 3 * made.triangles.len() as u64, MAX_ELEMENTS)?;
    Ok(StripBlend {
        faces: FaceList {
            offsets: alloc::collect((0..made.triangles.len() as u32 + 1).map(|t| 3 * t))?,
            corners: alloc::copied(made.triangles.as_flattened())?,
        },
        parents: parents_of_new_vertices(strip, &made.unfaired, &job.sub_job(0.9, 1.0))?,
        points: made.points,
        unfaired: made.unfaired,
    })
}

/// Returns the parents of each new vertex: the corners of the strip's triangle nearest to its
/// position without fairing.
fn parents_of_new_vertices(strip: &Strip, unfaired: &[DVec3], job: &Job<'_>) -> Result<Vec<RimParents>> {
    let rims = alloc::gather(strip.a.points.iter().chain(&strip.b.points).copied())?;
    let found = nearest_places(&rims, strip.faces.corners.as_chunks::<3>().0, unfaired, "refining", job)?;
    alloc::collect(found.into_iter().map(|(vertices, weights)| RimParents { vertices, weights }))
}

/// Returns the old faces around a strip, and their edges between two rim vertices, the smaller
/// first, ascending.
fn old_ring_of_strip(whole: &Mesh, strip: &Strip, unit: f64, job: &Job<'_>) -> Result<(OldRing, Vec<(u32, u32)>)> {
    let around = StripNeighbourhood::new(whole, strip, unit, Vec::new())?;
    let old = around.old_triangles(|face| face.iter().any(|&v| around.rim.contains(v)), job)?.corners;
    let rims = strip.a.vertices.iter().chain(&strip.b.vertices);
    let mut names = alloc::gather(rims.clone().copied())?;
    let rim = names.len();
    let mut on_rim = alloc::gather(rims.zip(0u32..).map(|(&v, k)| (v, k)))?;
    on_rim.sort_unstable();
    let number_on_rim = |v: u32| on_rim.binary_search_by_key(&v, |&(v, _)| v).ok().map(|at| on_rim[at].1);
    // The triangles at rim A come first, whatever the order of the pieces in the mesh.
    let is_at_a = |v: u32| number_on_rim(v).is_some_and(|k| (k as usize) < strip.a.vertices.len());
    let has_corner_on_a = |corners: &[u32; 3]| corners.iter().any(|&v| is_at_a(v));
    let mut beside = alloc::gather(old.iter().copied().filter(has_corner_on_a))?;
    alloc::extend(&mut beside, old.iter().copied().filter(|corners| !has_corner_on_a(corners)))?;
    let others = numbers_in_order(beside.as_flattened().iter().copied().filter(|&v| !around.rim.contains(v)), rim)?;
    let number = |v: u32| number_on_rim(v).unwrap_or_else(|| others[others.partition_point(|&(other, _)| other < v)].1);
    let triangles = alloc::collect(beside.iter().map(|triangle| triangle.map(number)))?;
    let mut by_number = alloc::copied(&others)?;
    by_number.sort_unstable_by_key(|&(_, k)| k);
    alloc::extend(&mut names, by_number.iter().map(|&(v, _)| v))?;
    let origin = strip.a.points[0];
    let points = alloc::collect(names.iter().map(|&v| around.position(v) - origin))?;

    let touching = whole.faces().filter(|face| face.iter().any(|&v| around.rim.contains(v)));
    let sides = touching.flat_map(|face| face.iter().zip(face.iter().cycle().skip(1)));
    let sides = alloc::gather(sides.map(|(&u, &v)| (number(u), number(v))))?;
    let is_rim = |&&(u, v): &&(u32, u32)| u.max(v) < rim as u32;
    let mut edges = alloc::gather(sides.iter().filter(is_rim).map(|&(u, v)| (u.min(v), u.max(v))))?;
    sort_distinct(&mut edges);
    let mut valence = alloc::filled(0usize, rim)?;
    triangles.as_flattened().iter().filter(|&&v| (v as usize) < rim).for_each(|&v| valence[v as usize] += 1);
    let is_end = |v: u32| around.end_vertices.binary_search(&v).is_ok();
    let centred = alloc::collect((0..rim).map(|k| valence[k] <= MAX_FAN_TRIANGLES && !is_end(names[k])))?;
    let reach = MIN_BLENDED_GAP_RADII * strip.a.mean_radius().max(strip.b.mean_radius());
    let rims = vec![(strip.a.vertices.len(), strip.a.closed), (strip.b.vertices.len(), strip.b.closed)];
    let beyond = SecondRing::default();
    Ok((
        OldRing {
            points,
            origin,
            triangles,
            sides,
            has_laplacian_in_energy: centred,
            rim_lengths_and_closedness: rims,
            max_width_without_springs: reach,
            smoothing_passes_of_rest_curvature: None,
            second_ring: beyond,
        },
        edges,
    ))
}

/// Numbers vertices from `first` on, in the order of their first occurrence. Returns pairs of vertex
/// and number, ascending by vertex.
fn numbers_in_order(vertices: impl Iterator<Item = u32> + Clone, first: usize) -> Result<Vec<(u32, u32)>> {
    let mut found = alloc::gather(vertices.zip(0u32..))?;
    found.sort_unstable();
    found.dedup_by_key(|&mut (v, _)| v);
    found.sort_unstable_by_key(|&(_, place)| place);
    found.iter_mut().zip(first as u32..).for_each(|((_, place), number)| *place = number);
    found.sort_unstable();
    Ok(found)
}
