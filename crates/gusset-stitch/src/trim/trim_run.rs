//! The steps of trimming, from the meshes to the kept faces.

use super::STAGE;
use super::crossing_faces::{add_touching_faces, find_crossing_faces};
use super::kept_faces::{KeptFaceRims, KeptFaces};
use super::trim_piece::TrimPiece;
use super::trim_request::{DEFAULT_MAX_DISTANCE_MEAN_EDGES, KeptFacesOfPieces, Options};
use super::vertex_covers::{SameSurfaceCriterion, VertexCovers};
use crate::align::common_length_unit;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::geom::kd_tree::{KdTree, ScaledRadius};
use gusset_base::geom::triangle_places::TriangleTree;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::MeshView;
use std::ops::ControlFlow;

/// Smallest width of gaps, in mean edges.
const MIN_GAP_MEAN_EDGES: f64 = 0.5;
/// Advantage of earlier pieces in confidence, in mean edges. At a common border, noise must not
/// decide.
const EARLIER_PIECE_BIAS_MEAN_EDGES: f64 = 3.0;
/// Number of smoothing passes over the margins, for a smooth line between the pieces.
const MARGIN_SMOOTHING_PASSES: usize = 6;
/// Margins are clamped to this.
const MAX_CONFIDENCE_MARGIN: f64 = 8.0;
/// Largest number of rounds that remove faces and keep others in their place.
const MAX_TRIMMING_ROUNDS: usize = 12;

/// Selects the faces of overlapping pieces to keep, so that no two surfaces lie on each other.
/// Narrow gaps remain between them.
///
/// O(V log F) for each piece and those near it, on the job's threads. Memory: linear.
///
/// # Errors
/// * [`Error::EmptyMesh`] without pieces.
/// * [`Error::OptionOutOfRange`] for a distance or an angle out of range.
/// * [`Error::InputsDiffer`] for fewer viewpoints than pieces.
/// * [`Error::NotFinite`] for a viewpoint that is not finite.
/// * [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn trim(pieces: &[MeshView<'_>], options: &Options<'_>, job: &Job<'_>) -> Result<KeptFacesOfPieces> {
    if pieces.is_empty() {
        return Err(Error::EmptyMesh { what: "pieces" });
    }
    if let Some(distance) = options.max_distance {
        Error::require((0.0..f64::INFINITY).contains(&distance), "max_distance", distance, "finite and at least 0")?;
    }
    let angle = options.max_angle;
    Error::require(
        (0.0..std::f64::consts::FRAC_PI_2).contains(&angle),
        "max_angle",
        angle,
        "at least 0 and below pi / 2",
    )?;
    if !options.viewpoints.is_empty() && options.viewpoints.len() < pieces.len() {
        return Err(Error::InputsDiffer { given: options.viewpoints.len() as u64, needed: pieces.len() as u64 });
    }
    for (&viewpoint, k) in options.viewpoints.iter().zip(0..) {
        Error::check_finite(Element::Point, k, viewpoint)?;
    }
    let unit = common_length_unit(pieces, job)?;
    let all = pieces.iter().map(|piece| bounds_of_used_vertices(piece, unit)).fold(Aabb::EMPTY, Aabb::union);
    let origin = if all.is_empty() { glam::DVec3::ZERO } else { all.centre() };
    let count = pieces.len();
    let (prepare, look) = (job.sub_job(0.0, 0.3), job.sub_job(0.3, 0.8));
    let mut layers = alloc::with_capacity(count)?;
    for (k, piece) in pieces.iter().enumerate() {
        layers.push(TrimPiece::new(piece, k, unit, origin, options, &prepare.sub_job_of_item(k, count))?);
    }
    let trees = alloc::try_collect(layers.iter().map(|layer| {
        let TrimPiece { scan, triangles, .. } = layer;
        TriangleTree::new(&scan.points, triangles, "looking at the pieces", &prepare.sub_job(1.0, 1.0))
    }))?;
    let same = SameSurfaceCriterion {
        distance: options.max_distance.map(|distance| distance / unit),
        distance_in_mean_edges: DEFAULT_MAX_DISTANCE_MEAN_EDGES,
        cosine: options.min_normal_cosine(),
    };
    let covers = alloc::try_collect(
        (0..count).map(|k| VertexCovers::new(&layers, &trees, k, &same, &look.sub_job_of_item(k, count))),
    )?;
    let mut pairs = Vec::new();
    for (k, covers) in (0..).zip(&covers) {
        alloc::extend(&mut pairs, covers.covering_pieces()?.into_iter().map(|j| [j.min(k), j.max(k)]))?;
    }
    sort_distinct(&mut pairs);
    let min_faces = options.min_part_faces();
    let job = job.sub_job(0.8, 1.0);
    let mut regions = alloc::try_collect(
        pieces
            .iter()
            .enumerate()
            .map(|(k, piece)| KeptFaces::new(piece, &job.sub_job(0.0, 0.1).sub_job_of_item(k, count))),
    )?;
    let mut cut = 0;
    for round in 0..MAX_TRIMMING_ROUNDS {
        let job = job.sub_job(0.1, 1.0).sub_job_of_item(round, MAX_TRIMMING_ROUNDS);
        // Removed faces do not compete, so other faces are kept in their place.
        let mut lost = false;
        for k in 0..count {
            let done = 0.7 * k as f64 / count as f64;
            lost |= choose_kept_faces(&layers, &covers, &mut regions, k, min_faces, &job.sub_job(done, done))?;
        }
        if lost && round + 2 < MAX_TRIMMING_ROUNDS {
            continue;
        }
        if round + 2 < MAX_TRIMMING_ROUNDS {
            let mut back = false;
            for k in 0..count {
                job.step(0.7, STAGE)?;
                let is_kept = |piece: u32, face: u32| regions[piece as usize].is_kept_face[face as usize];
                let on = (0..layers[k].scan.points.len()).map(|v| covers[k].is_covered_where(v, is_kept));
                let on = alloc::collect_cancellable(on, &job.sub_job(0.7, 0.7), STAGE)?;
                back |= regions[k].restore_islands(&on, min_faces, &job.sub_job(0.7, 0.7))?;
            }
            if back {
                continue;
            }
        }
        let mut crossing_faces = find_crossing_faces(&layers, &regions, &job.sub_job(0.7, 1.0))?;
        add_touching_faces(&layers, &regions, &pairs, &mut crossing_faces)?;
        if crossing_faces.iter().all(Vec::is_empty) {
            break;
        }
        for (region, faces) in regions.iter_mut().zip(&crossing_faces) {
            cut += faces.len() as u32;
            region.remove_with_neighbours_for_good(faces)?;
        }
    }
    let kept = |region: &KeptFaces<'_, '_>| {
        alloc::gather((0..).zip(&region.is_kept_face).filter(|(_, keeps)| **keeps).map(|(f, _)| f))
    };
    Ok(KeptFacesOfPieces {
        kept: alloc::try_collect(regions.iter().map(kept))?,
        covered: alloc::collect(covers.iter().map(VertexCovers::covered_vertex_count))?,
        pairs,
        spacing: unit * layers.iter().map(|layer| layer.scan.spacing).fold(0.0, f64::max),
        crossings: cut,
    })
}

/// Chooses the faces of piece `k` to keep. They do not lie on kept faces of earlier pieces, and are
/// at least as confident as later pieces, up to [`EARLIER_PIECE_BIAS_MEAN_EDGES`]. Returns true if
/// islands were removed.
fn choose_kept_faces(
    layers: &[TrimPiece],
    covers: &[VertexCovers],
    regions: &mut [KeptFaces<'_, '_>],
    k: usize,
    min_faces: u32,
    job: &Job<'_>,
) -> Result<bool> {
    let layer = &layers[k];
    let (before, rest) = regions.split_at_mut(k);
    let (own, after) = rest.split_at_mut(1);
    let points = &layer.scan.points;
    job.step(0.0, STAGE)?;
    // Faces of later pieces compete unless they were removed.
    let competes = |piece: u32, face: u32| match (piece as usize).checked_sub(k + 1) {
        Some(j) => !after[j].is_lost_face[face as usize],
        None => false,
    };
    let margin = |v| {
        covers[k]
            .confidence_margin(v, layer.confidence[v], competes)
            .clamp(-MAX_CONFIDENCE_MARGIN, MAX_CONFIDENCE_MARGIN)
    };
    let mut margins = alloc::collect_cancellable((0..points.len()).map(margin), job, STAGE)?;
    own[0].smooth_vertex_values(&mut margins, MARGIN_SMOOTHING_PASSES, job)?;
    let mut rims = [KeptFaceRims::default(), KeptFaceRims::default()];
    for (region, other) in before.iter().zip(layers) {
        job.step(0.0, STAGE)?;
        if layer.scan.bounds.is_within(&other.scan.bounds, MIN_GAP_MEAN_EDGES * other.scan.spacing) {
            region.add_rim_points(&other.scan, &mut rims, job)?;
        }
    }
    let trees = alloc::try_collect(rims.iter().map(|rims| KdTree::new(&rims.points, job, STAGE)))?;
    let gap = ScaledRadius::new((MIN_GAP_MEAN_EDGES * layer.scan.spacing).max(f64::MIN_POSITIVE));
    let is_near_rim = |v: usize| {
        let bars = |rims: &KeptFaceRims, r: u32| rims.normals[r as usize].dot(layer.scan.normals[v]) > 0.0;
        // Borders that already meet need no gap.
        let count = if layer.scan.is_rim_vertex.contains(v as u32) { 1 } else { 2 };
        rims.iter().zip(&trees).take(count).any(|(rims, tree)| {
            let visit = |r| if bars(rims, r) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
            tree.try_for_each_within(points[v], gap, &mut |_, r| visit(r)).is_break()
        })
    };
    let mut barred = alloc::with_capacity(points.len())?;
    for v in 0..points.len() {
        job.step_every(1 << 14, v, points.len(), STAGE)?;
        let is_kept = |piece: u32, face: u32| before.get(piece as usize).is_some_and(|r| r.is_kept_face[face as usize]);
        barred.push(covers[k].is_covered_where(v, is_kept) || is_near_rim(v));
    }
    job.step(0.0, STAGE)?;
    let wanted: Vec<bool> = alloc::collect(margins.iter().map(|&margin| margin > -EARLIER_PIECE_BIAS_MEAN_EDGES))?;
    let shown =
        alloc::collect_cancellable((0..points.len()).map(|v| covers[k].is_covered_where(v, competes)), job, STAGE)?;
    job.step(0.0, STAGE)?;
    own[0].keep_faces_where(&wanted, &barred, &shown, min_faces, job)
}

/// Returns the box of the vertices that faces use.
fn bounds_of_used_vertices(piece: &MeshView<'_>, unit: f64) -> Aabb {
    Aabb::from_points((0..piece.faces().len()).flat_map(|f| piece.face(f).map(|v| piece.positions().get(v) / unit)))
}
