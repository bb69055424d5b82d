//! The places on other pieces that vertices lie on.

use super::trim_piece::TrimPiece;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::triangle_places::TriangleTree;
use gusset_base::job::Job;
use gusset_base::par;

const STAGE: &str = "looking for overlaps";
const VERTICES_PER_TASK: usize = 1 << 9;

/// The criterion for two pieces showing one surface.
#[derive(Clone, Copy)]
pub(super) struct SameSurfaceCriterion {
    /// The largest distance; `None` means `distance_in_mean_edges` mean edges of the coarser piece.
    pub(super) distance: Option<f64>,
    pub(super) distance_in_mean_edges: f64,
    pub(super) cosine: f64,
}

impl SameSurfaceCriterion {
    fn max_distance(&self, a: &TrimPiece, b: &TrimPiece) -> f64 {
        self.distance.unwrap_or(self.distance_in_mean_edges * a.scan.spacing.max(b.scan.spacing))
    }
}

/// A place that a vertex lies on.
#[derive(Clone, Copy)]
struct CoverPlace {
    piece: u32,
    face: u32,
    confidence: f64,
}

/// The places that the vertices of a piece lie on, at most one on each other piece.
pub(super) struct VertexCovers {
    place_range_ends: Vec<u32>,
    places: Vec<CoverPlace>,
}

impl VertexCovers {
    /// Finds the places. O(log F) for each vertex of piece `k` and each piece near it.
    pub(super) fn new(
        layers: &[TrimPiece],
        trees: &[TriangleTree<'_>],
        k: usize,
        same: &SameSurfaceCriterion,
        job: &Job<'_>,
    ) -> Result<VertexCovers> {
        let own = &layers[k];
        let is_near = |j: &usize| {
            let other = &layers[*j];
            let reach = same.max_distance(own, other);
            *j != k && own.scan.bounds.is_within(&other.scan.bounds, reach) && !other.triangles.is_empty()
        };
        let near = alloc::gather((0..layers.len()).filter(is_near))?;
        let chunks = par::split_into_ranges(own.scan.points.len(), VERTICES_PER_TASK);
        let parts = par::map_cancellable(job, STAGE, chunks, |range| -> Result<VertexCovers> {
            let mut part = VertexCovers { place_range_ends: alloc::with_capacity(range.len())?, places: Vec::new() };
            // The triangle of the previous vertex on each piece.
            let mut guesses = alloc::filled(None, near.len())?;
            for v in range {
                let (p, n) = (own.scan.points[v], own.scan.normals[v]);
                let on = |(&j, guess): (&usize, &mut Option<u32>)| {
                    let reach = same.max_distance(own, &layers[j]);
                    let (face, confidence) = find_cover(&layers[j], &trees[j], p, n, reach, same.cosine, guess)?;
                    Some(CoverPlace { piece: j as u32, face, confidence })
                };
                if n != DVec3::ZERO {
                    alloc::extend(&mut part.places, near.iter().zip(&mut guesses).filter_map(on))?;
                }
                part.place_range_ends.push(part.places.len() as u32);
            }
            Ok(part)
        })?;
        let mut all =
            VertexCovers { place_range_ends: alloc::with_capacity(own.scan.points.len())?, places: Vec::new() };
        for part in parts {
            let part = part?;
            let first = all.places.len() as u32;
            all.place_range_ends.extend(part.place_range_ends.iter().map(|end| first + end));
            alloc::append(&mut all.places, &part.places)?;
        }
        Ok(all)
    }

    fn covers_at(&self, v: usize) -> &[CoverPlace] {
        let start = v.checked_sub(1).map_or(0, |before| self.place_range_ends[before]);
        &self.places[start as usize..self.place_range_ends[v] as usize]
    }

    /// Returns the number of vertices that lie on another piece.
    pub(super) fn covered_vertex_count(&self) -> u32 {
        (0..self.place_range_ends.len()).filter(|&v| !self.covers_at(v).is_empty()).count() as u32
    }

    /// Returns the pieces that at least one vertex lies on, ascending.
    pub(super) fn covering_pieces(&self) -> Result<Vec<u32>> {
        let mut pieces = Vec::new();
        for cover in &self.places {
            if !pieces.contains(&cover.piece) {
                alloc::push(&mut pieces, cover.piece)?;
            }
        }
        pieces.sort_unstable();
        Ok(pieces)
    }

    /// Returns true if a vertex lies on a face that satisfies `is_kept`.
    pub(super) fn is_covered_where(&self, v: usize, is_kept: impl Fn(u32, u32) -> bool) -> bool {
        self.covers_at(v).iter().any(|cover| is_kept(cover.piece, cover.face))
    }

    /// Returns the vertex's confidence minus the largest confidence of its places on faces that
    /// satisfy `competes`; infinity if there are none.
    pub(super) fn confidence_margin(&self, v: usize, confidence: f64, competes: impl Fn(u32, u32) -> bool) -> f64 {
        let on = self.covers_at(v).iter().filter(|cover| competes(cover.piece, cover.face));
        on.map(|cover| confidence - cover.confidence).fold(f64::INFINITY, f64::min)
    }
}

/// Returns the face and the confidence of the place on a piece that a point with a normal lies on,
/// or `None`. `guess` is the triangle of a nearby point.
fn find_cover(
    other: &TrimPiece,
    tree: &TriangleTree<'_>,
    p: DVec3,
    n: DVec3,
    reach: f64,
    cosine: f64,
    guess: &mut Option<u32>,
) -> Option<(u32, f64)> {
    let scan = &other.scan;
    if scan.bounds.distance_squared(p) > reach * reach {
        return None;
    }
    let place = tree.nearest_with_guess(p, reach * reach, *guess)?;
    *guess = Some(place.triangle);
    let corners = other.triangles[place.triangle as usize];
    let with = || corners.into_iter().zip(place.weights).filter(|&(_, weight)| weight > 0.0);
    // Beyond a border, the nearest place lies on the border.
    if with().all(|(v, _)| scan.is_rim_vertex.contains(v)) {
        return None;
    }
    let normal = with().map(|(v, weight)| scan.normals[v as usize] * weight).sum::<DVec3>();
    if normal.dot(n) < cosine * normal.length() {
        return None;
    }
    let confidence = with().map(|(v, weight)| other.confidence[v as usize] * weight).sum();
    Some((other.faces[place.triangle as usize], confidence))
}
