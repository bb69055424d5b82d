//! A blend: instead of the strip's long triangles, triangles as fine as those round it, on a
//! surface that leaves both pieces along their tangents.
//!
//! The strip says which way the surface goes. Its sides are halved until they are as long as the
//! old ones at the rims (more exactly [`SIZE`] of them), short ones are collapsed, and vertices
//! added where angles are small ([`crate::remesh`]); then all new vertices move to where a thin
//! plate clamped to the old faces bends least ([`crate::fair`]), twice, or, where that cuts, with
//! care or less often. The plate is bent by itself as the strip is, its ridges averaged out: one
//! that is flat by itself would narrow to a neck between two tubes, and, a few radii long, to a
//! point. Across many radii it hangs on the strip. Creases that the old faces do not have are
//! ironed out. At last the sharp triangles at the shortest edges of the rims are refined: there the
//! plate would follow round-off.
//!
//! Sources: M. Botsch, L. Kobbelt, *A remeshing approach to multiresolution modeling* (2004), for
//! the order of the steps; P. Liepa, *Filling holes in meshes* (2003), for the plate. The constants
//! are those of the joints that were nearest to what had been cut out of closed meshes, and whose
//! angles were best (`make bench ONLY=truth`).

use super::grid::FaceList;
use super::neighbourhood::{MAX_FAN_TRIANGLES, Neighbourhood};
use super::rim::Rim;
use super::strip::{Parents, Strip};
use crate::alloc;
use crate::error::{Error, Result};
use crate::fair::{Plate, Shape, Weights, mean_curvature, thin_plate};
use crate::geom::kd_tree::KdTree;
use crate::job::Job;
use crate::mesh::{MAX_ELEMENTS, Mesh};
use crate::remesh::{PatchMesh, Sizing, even, growth, insert, needed};
use crate::sort::sort_distinct;
use glam::DVec3;

/// How long new sides are, in old ones.
const SIZE: f64 = 0.8;
/// What is tried, one after the other, until nothing cuts.
pub(super) const WAYS: [Way; 4] = [
    Way { rounds: 2, unfolds: false },
    Way { rounds: 2, unfolds: true },
    Way { rounds: 1, unfolds: true },
    Way { rounds: 0, unfolds: true },
];
/// Before that sharp triangles are left whose shortest side is below this part of the size.
const SHORTEST: f64 = 0.3;
/// And at last below this.
const SHORTEST_AT_LAST: f64 = 1e-3;
/// Rounds in which vertices move within the surface, before each solution and at last.
const SETTLE: [u32; 2] = [2, 5];
/// Averages over neighbours that make of the strip's curvature, which sits in its ridges, that of
/// the surface it stands for.
const SMOOTHING: u32 = 10;
/// How wide a blend is before it hangs on the strip, in mean radii of the larger rim.
const REACH: f64 = 3.0;
/// New vertices that the sizes may ask for, by an estimate; more if [`MAX_NEW_AT_RIM`] allows more.
/// Where more would be needed, all sides grow; where the estimate does not fit the shape, there are
/// at most twice as many.
const MAX_NEW: u32 = 50_000;
/// Where sides would have to grow by more, the gap is too wide for a blend.
const MAX_GROWTH: f64 = 2.0;
/// New vertices for each of the rims' that the sizes may ask for, and as many again for sharp
/// angles.
const MAX_NEW_AT_RIM: u32 = 16;
/// A triangle that turns by more is folded: the cosine.
const MIN_TURN: f64 = 0.2;
/// New triangles that bend by more than this against each other, and than twice what is usual
/// between the old faces at the rims, make a crease that those do not have: the cosine.
const MAX_SMOOTH_BEND: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// What is usual: so many of a hundred old edges do not bend by more.
const USUAL_PERCENT: usize = 95;
/// How often a vertex that folds a triangle is taken back halfway.
const MAX_HALVINGS: u32 = 8;

/// How a blend is faired.
#[derive(Clone, Copy)]
pub(super) struct Way {
    /// How often the plate is solved, with refinement before.
    rounds: u32,
    /// Vertices that fold a triangle stay behind: dearer in smoothness, where nothing cuts without.
    unfolds: bool,
}

/// What takes the place of a strip's faces and new vertices.
pub(super) struct Blend {
    pub(super) faces: FaceList,
    /// The new vertices, in the rims' unit.
    pub(super) points: Vec<DVec3>,
    /// Where they would be without fairing.
    pub(super) unfaired: Vec<DVec3>,
    pub(super) parents: Vec<Parents>,
}

/// What all ways begin with.
pub(super) struct Plan {
    patch: OldRing,
    /// The strip with sides as long as is wanted.
    mesh: PatchMesh,
    sizing: Sizing,
    /// The number of the rims' vertices.
    rim: usize,
    /// Creases of a smaller cosine are ironed out.
    min_cosine: f64,
    /// True of the rims' vertices where old creases end.
    creased: Vec<bool>,
}

impl Plan {
    /// Of a strip of triangles without rows; `None` if it would need too many vertices. O(T + n log
    /// n) for T triangles of the strip and n new vertices, and a pass over all old faces.
    pub(super) fn new(whole: &Mesh, strip: &Strip, unit: f64, job: &Job<'_>) -> Result<Option<Plan>> {
        let mut patch = OldRing::new(whole, strip, unit)?;
        let rim = strip.rim_count();
        let (usual, creased) = patch.bends(rim)?;
        // Of twice the angle.
        let min_cosine = MAX_SMOOTH_BEND.min(2.0 * usual * usual - 1.0);
        let corners = strip.faces.corners.as_chunks::<3>().0;
        let mut mesh = PatchMesh::new(alloc::copied(&patch.points[..rim])?, alloc::copied(corners)?)?;
        let mut size = patch.sizes(&[&strip.a, &strip.b])?;
        size.iter_mut().for_each(|s| *s *= SIZE);
        let at_rim = MAX_NEW_AT_RIM.saturating_mul(rim as u32);
        let limit = MAX_NEW.max(at_rim);
        let needed = needed(&mesh, &size);
        // Of sides without length.
        if !needed.is_finite() {
            return Ok(None);
        }
        let needed = needed.min(f64::from(limit));
        let grown = growth(&mesh, &size, limit);
        if grown > MAX_GROWTH {
            return Ok(None);
        }
        size.iter_mut().for_each(|s| *s *= grown);
        patch.draw_near(&size)?;
        let mut sizing = Sizing {
            size,
            unfaired: alloc::copied(&mesh.points)?,
            curvature: alloc::filled(DVec3::ZERO, rim)?,
            // Twice the estimate: for shapes that it does not fit.
            limit: rim + 2 * needed as usize + at_rim as usize,
            shortest: SHORTEST,
        };
        let taken = |u: u32, v: u32| patch.has_edge(u, v);
        even(&mut mesh, rim, &mut sizing, &taken, &job.part(0.0, 0.5))?;
        insert(&mut mesh, rim, &mut sizing, &taken, &job.part(0.5, 0.8))?;
        if mesh.points.len() >= sizing.limit {
            return Ok(None);
        }
        mesh.settle(rim, &taken, SETTLE[0], &job.part(0.8, 1.0))?;
        sizing.curvature = mean_curvature(&mesh.points, &mesh.triangles, rim, SMOOTHING, &job.part(1.0, 1.0))?;
        Ok(Some(Plan { patch, mesh, sizing, rim, min_cosine, creased }))
    }

    /// The blend in the place of the strip. For n new vertices O(n log n) and the plate's
    /// O(n^1.5), nearly linear on a narrow strip.
    pub(super) fn blend(&self, strip: &Strip, way: Way, job: &Job<'_>) -> Result<Blend> {
        let (patch, rim) = (&self.patch, self.rim);
        let (mut mesh, mut sizing) = (self.mesh.try_clone()?, self.sizing.try_clone()?);
        let taken = |u: u32, v: u32| patch.has_edge(u, v);
        for round in 0..way.rounds {
            let part = job.part(0.0, 0.6).share(round as usize, way.rounds as usize);
            if round > 0 {
                insert(&mut mesh, rim, &mut sizing, &taken, &part.part(0.0, 0.3))?;
                mesh.settle(rim, &taken, SETTLE[0], &part.part(0.3, 0.4))?;
            }
            patch.fair(&mut mesh, &sizing, way.unfolds, &part.part(0.4, 1.0))?;
        }
        mesh.iron(rim, self.min_cosine, &self.creased, &job.part(0.6, 0.7))?;
        sizing.shortest = SHORTEST_AT_LAST;
        insert(&mut mesh, rim, &mut sizing, &taken, &job.part(0.7, 0.8))?;
        mesh.settle(rim, &taken, SETTLE[1], &job.part(0.8, 0.9))?;

        Error::check_count("corners of the strip", 3 * mesh.triangles.len() as u64, MAX_ELEMENTS)?;
        let back = |points: &[DVec3]| alloc::collect(points[rim..].iter().map(|&p| p + patch.origin));
        let points = back(&mesh.points)?;
        Ok(Blend {
            faces: FaceList {
                offsets: alloc::collect((0..mesh.triangles.len() as u32 + 1).map(|t| 3 * t))?,
                corners: alloc::copied(mesh.triangles.as_flattened())?,
            },
            parents: parents(strip, &points, &job.part(0.9, 1.0))?,
            points,
            unfaired: back(&sizing.unfaired)?,
        })
    }
}

/// Of each point, the nearest vertex of either rim, and how far it is on the way between them.
fn parents(strip: &Strip, points: &[DVec3], job: &Job<'_>) -> Result<Vec<Parents>> {
    let n = strip.a.vertices.len() as u32;
    let trees = [
        KdTree::new(&strip.a.points, &job.part(0.0, 0.1), "refining")?,
        KdTree::new(&strip.b.points, &job.part(0.1, 0.2), "refining")?,
    ];
    alloc::collect(points.iter().map(|&p| {
        let [a, b] = [0, 1].map(|k| trees[k].nearest(p, f64::INFINITY, |_| true).unwrap_or((0.0, 0)));
        let (to_a, to_b) = (a.0.sqrt(), b.0.sqrt());
        let weight = if to_a + to_b > 0.0 { to_a / (to_a + to_b) } else { 0.5 };
        Parents { ends: [a.1, n + b.1], weight }
    }))
}

/// Moves the vertices of `mesh` from `rim` on to `places`, those of triangles that would fold only
/// part of the way; what folds then still is left to the search for cuts.
fn unfold(mesh: &mut PatchMesh, rim: usize, places: &[DVec3]) -> Result<()> {
    let start = alloc::copied(&mesh.points)?;
    let normal = |points: &[DVec3], triangle: [u32; 3]| {
        let [a, b, c] = triangle.map(|v| points[v as usize]);
        (b - a).cross(c - a)
    };
    let mut share = alloc::filled(1.0, places.len())?;
    for _ in 0..MAX_HALVINGS {
        for ((point, &from), (&to, &share)) in
            mesh.points[rim..].iter_mut().zip(&start[rim..]).zip(places.iter().zip(&share))
        {
            *point = from.lerp(to, share);
        }
        let mut folds = alloc::filled(false, places.len())?;
        for &triangle in &mesh.triangles {
            let (before, now) = (normal(&start, triangle), normal(&mesh.points, triangle));
            if before.dot(now) < MIN_TURN * before.length() * now.length() {
                triangle.iter().filter_map(|&v| (v as usize).checked_sub(rim)).for_each(|k| folds[k] = true);
            }
        }
        if !folds.contains(&true) {
            break;
        }
        share.iter_mut().zip(folds).filter(|(_, folds)| *folds).for_each(|(share, _)| *share *= 0.5);
    }
    Ok(())
}

/// The old faces that touch the rims: the rims' vertices first, in the strip's own numbers, then
/// others.
struct OldRing {
    /// In the rims' unit, from `origin`.
    points: Vec<DVec3>,
    origin: DVec3,
    triangles: Vec<[u32; 3]>,
    /// The faces' sides, face by face.
    sides: Vec<(u32, u32)>,
    /// The edges between two vertices of the rims, the smaller one first, ascending.
    edges: Vec<(u32, u32)>,
    /// True of the rims' vertices whose Laplacian the plate counts.
    centred: Vec<bool>,
    /// What is wider than this hangs on the strip's place; see [`Shape`].
    reach: f64,
}

impl OldRing {
    /// True if an old face has an edge between two vertices of the rims.
    fn has_edge(&self, u: u32, v: u32) -> bool {
        self.edges.binary_search(&(u.min(v), u.max(v))).is_ok()
    }

    /// How old faces at the rims bend against each other: the cosine that [`USUAL_PERCENT`] of a
    /// hundred edges reach, at least 0; and of which vertices of the rims an edge bends by more
    /// than [`MAX_SMOOTH_BEND`].
    fn bends(&self, rim: usize) -> Result<(f64, Vec<bool>)> {
        let mut edges = alloc::with_capacity(3 * self.triangles.len())?;
        for &[a, b, c] in &self.triangles {
            let [p, q, r] = [a, b, c].map(|v| self.points[v as usize]);
            let normal = (q - p).cross(r - p).normalize_or_zero();
            // A triangle without area has no direction.
            if normal != DVec3::ZERO {
                edges.extend([(a, b), (b, c), (c, a)].map(|(u, v)| (u.min(v), u.max(v), normal)));
            }
        }
        edges.sort_by_key(|&(u, v, _)| (u, v));
        let pairs = edges.windows(2).filter(|pair| (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1));
        let mut bends = alloc::gather(pairs.map(|pair| (pair[0].2.dot(pair[1].2), [pair[0].0, pair[0].1])))?;
        let mut creased = alloc::filled(false, rim)?;
        for (_, ends) in bends.iter().filter(|(cosine, _)| *cosine < MAX_SMOOTH_BEND) {
            ends.iter().filter(|&&v| (v as usize) < rim).for_each(|&v| creased[v as usize] = true);
        }
        bends.sort_unstable_by(|p, q| q.0.total_cmp(&p.0));
        let usual = bends.get(bends.len().saturating_sub(1) * USUAL_PERCENT / 100).map_or(1.0, |&(cosine, _)| cosine);
        Ok((usual.max(0.0), creased))
    }

    fn new(whole: &Mesh, strip: &Strip, unit: f64) -> Result<OldRing> {
        let around = Neighbourhood::new(whole, strip, unit, Vec::new())?;
        let old = around.old_triangles(|face| face.iter().any(|&v| around.rim.contains(v)))?.corners;
        let rims = strip.a.vertices.iter().chain(&strip.b.vertices);
        let mut names = alloc::gather(rims.clone().copied())?;
        let rim = names.len();
        let mut others = alloc::gather(old.as_flattened().iter().copied().filter(|&v| !around.rim.contains(v)))?;
        sort_distinct(&mut others);
        let mut on_rim = alloc::gather(rims.zip(0u32..).map(|(&v, k)| (v, k)))?;
        on_rim.sort_unstable();
        let number = |v: u32| match on_rim.binary_search_by_key(&v, |&(v, _)| v) {
            Ok(at) => on_rim[at].1,
            Err(_) => (rim + others.partition_point(|&other| other < v)) as u32,
        };
        let triangles = alloc::collect(old.iter().map(|triangle| triangle.map(number)))?;
        alloc::append(&mut names, &others)?;
        let origin = strip.a.points[0];
        let points = alloc::collect(names.iter().map(|&v| around.at(v) - origin))?;

        let touching = whole.faces().filter(|face| face.iter().any(|&v| around.rim.contains(v)));
        let sides = touching.flat_map(|face| face.iter().zip(face.iter().cycle().skip(1)));
        let sides = alloc::gather(sides.map(|(&u, &v)| (number(u), number(v))))?;
        let is_rim = |&&(u, v): &&(u32, u32)| u.max(v) < rim as u32;
        let mut edges = alloc::gather(sides.iter().filter(is_rim).map(|&(u, v)| (u.min(v), u.max(v))))?;
        sort_distinct(&mut edges);
        let mut valence = alloc::filled(0usize, rim)?;
        triangles.as_flattened().iter().filter(|&&v| (v as usize) < rim).for_each(|&v| valence[v as usize] += 1);
        let is_end = |v: u32| around.ends.binary_search(&v).is_ok();
        let centred = alloc::collect((0..rim).map(|k| valence[k] <= MAX_FAN_TRIANGLES && !is_end(names[k])))?;
        let reach = REACH * strip.a.radius().max(strip.b.radius());
        Ok(OldRing { points, origin, triangles, sides, edges, centred, reach })
    }

    /// The mean length of the old sides at each vertex of the rims, by their lengths, so that
    /// slivers count for little. Next to a vertex of larger size none is smaller than that less its
    /// distance: a corner that the rim cuts off says nothing about the surface.
    fn sizes(&self, rims: &[&Rim; 2]) -> Result<Vec<f64>> {
        let rim = self.centred.len();
        let mut sums = alloc::filled((0.0, 0.0), rim)?;
        for &(u, v) in &self.sides {
            let length = self.points[u as usize].distance(self.points[v as usize]);
            for end in [u, v].into_iter().filter(|&end| (end as usize) < rim) {
                sums[end as usize].0 += length * length;
                sums[end as usize].1 += length;
            }
        }
        let mut size = alloc::collect(sums.iter().map(|&(squares, sum)| if sum > 0.0 { squares / sum } else { 0.0 }))?;
        let mut first = 0;
        for side in rims {
            let n = side.vertices.len();
            // Twice round, if it is a loop, either way.
            let places = if side.closed { 2 * n } else { n };
            let mut pass = |u: usize, v: usize| {
                let distance = self.points[u].distance(self.points[v]);
                size[v] = f64::max(size[v], size[u] - distance);
            };
            let at = |k: usize| first + k % n;
            (1..places).for_each(|k| pass(at(k - 1), at(k)));
            (1..places).rev().for_each(|k| pass(at(k), at(k - 1)));
            first += n;
        }
        // Where no side has a length, any size does: nothing will be longer.
        Ok(size)
    }

    /// Draws the old vertices beyond the rims nearer to them, to where the next new ones would be:
    /// they are to tell the plate the slope at the rims, and tell little from afar.
    fn draw_near(&mut self, size: &[f64]) -> Result<()> {
        let rim = size.len();
        let mut anchors = alloc::filled((DVec3::ZERO, 0.0, 0.0), self.points.len() - rim)?;
        for triangle in &self.triangles {
            for &v in triangle.iter().filter(|&&v| v as usize >= rim) {
                for &end in triangle.iter().filter(|&&end| (end as usize) < rim) {
                    let (sum, reach, count) = &mut anchors[v as usize - rim];
                    *sum += self.points[end as usize];
                    *reach += size[end as usize];
                    *count += 1.0;
                }
            }
        }
        for (point, (sum, reach, count)) in self.points[rim..].iter_mut().zip(anchors) {
            if count > 0.0 {
                let (anchor, reach) = (sum / count, reach / count);
                *point = anchor + (*point - anchor).clamp_length_max(reach);
            }
        }
        Ok(())
    }

    /// Moves the vertices of `mesh` from `rim` on to where a thin plate would have them.
    fn fair(&self, mesh: &mut PatchMesh, sizing: &Sizing, unfolds: bool, job: &Job<'_>) -> Result<()> {
        let rim = self.centred.len();
        let (old, new) = (self.points.len(), mesh.points.len() - rim);
        let mut points = alloc::copied(&self.points)?;
        alloc::append(&mut points, &mesh.points[rim..])?;
        let name = |v: u32| if (v as usize) < rim { v } else { v + (old - rim) as u32 };
        let mut triangles = alloc::copied(&self.triangles)?;
        alloc::extend(&mut triangles, mesh.triangles.iter().map(|triangle| triangle.map(name)))?;
        let mut free = alloc::filled(false, old + new)?;
        free[old..].fill(true);
        let mut centres = alloc::copied(&free)?;
        centres[..rim].copy_from_slice(&self.centred);
        let mut curvature = alloc::copied(&sizing.curvature[..rim])?;
        alloc::append(&mut curvature, &alloc::filled(DVec3::ZERO, old - rim)?)?;
        alloc::append(&mut curvature, &sizing.curvature[rim..])?;
        let mut places = alloc::copied(&self.points)?;
        alloc::append(&mut places, &sizing.unfaired[rim..])?;
        let plate = Plate {
            triangles: &triangles,
            free: &free,
            centres: &centres,
            weights: Weights::Cotangent,
            shape: Some(Shape { curvature: &curvature, places: &places, reach: self.reach }),
            layout: None,
        };
        thin_plate(&mut points, &plate, job)?;
        if unfolds {
            return unfold(mesh, rim, &points[old..]);
        }
        mesh.points[rim..].copy_from_slice(&points[old..]);
        Ok(())
    }
}
