//! Trimming from the meshes to the faces that are kept.

use super::STAGE;
use super::covers::{Covers, Same};
use super::crossings::{add_touching, crossings};
use super::layer::Layer;
use super::region::{Region, Rims};
use super::trim_request::{Options, Trimmed};
use crate::align::common_unit_of;
use gusset_base::alloc;
use gusset_base::error::{Element, Error, Result};
use gusset_base::geom::Aabb;
use gusset_base::geom::kd_tree::{KdTree, Radius};
use gusset_base::geom::triangle_places::TriangleTree;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::MeshView;
use std::ops::ControlFlow;

/// Surfaces that are no farther apart are one, in mean edges, if the caller says nothing.
const EDGES: f64 = 4.0;
/// Surfaces whose normals differ by more are two, in radians, if the caller says nothing.
const ANGLE: f64 = std::f64::consts::FRAC_PI_3;
/// The least width of gaps, in mean edges.
const GAP: f64 = 0.5;
/// Earlier pieces are kept though later ones are more confident, by no more than this, in mean
/// edges: where two have a border in common, noise is not to say which is.
const BIAS: f64 = 3.0;
/// Margins are smoothed so many times, for a smooth line between the pieces, and count for no more
/// than this.
const SMOOTHINGS: usize = 6;
const MAX_MARGIN: f64 = 8.0;
/// Rounds in which faces that cannot be kept go, and others come in their place.
const MAX_ROUNDS: usize = 12;

/// Says which faces of overlapping pieces are kept, so that no two surfaces lie on each other, and
/// narrow gaps are left where they did.
///
/// O(V log F) for each piece and those near it, on the job's threads. Memory: linear.
///
/// # Errors
/// [`Error::EmptyMesh`] without pieces, [`Error::OptionOutOfRange`] for a distance or an angle out
/// of range, [`Error::InputsDiffer`] for viewpoints of fewer pieces, [`Error::NotFinite`]
/// for a viewpoint that is nowhere, [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn trim(pieces: &[MeshView<'_>], options: &Options<'_>, job: &Job<'_>) -> Result<Trimmed> {
    if pieces.is_empty() {
        return Err(Error::EmptyMesh { what: "pieces" });
    }
    if let Some(distance) = options.max_distance {
        Error::require((0.0..f64::INFINITY).contains(&distance), "max_distance", distance)?;
    }
    let angle = options.max_angle;
    Error::require((0.0..std::f64::consts::FRAC_PI_2).contains(&angle), "max_angle", angle)?;
    if !options.viewpoints.is_empty() && options.viewpoints.len() < pieces.len() {
        return Err(Error::InputsDiffer { given: options.viewpoints.len() as u64, needed: pieces.len() as u64 });
    }
    for (&viewpoint, k) in options.viewpoints.iter().zip(0..) {
        Error::check_finite(Element::Point, k, viewpoint)?;
    }
    let unit = common_unit_of(pieces, job)?;
    let all = pieces.iter().map(|piece| bounds(piece, unit)).fold(Aabb::EMPTY, Aabb::union);
    let origin = if all.is_empty() { glam::DVec3::ZERO } else { all.centre() };
    let count = pieces.len();
    let (prepare, look) = (job.part(0.0, 0.3), job.part(0.3, 0.8));
    let mut layers = alloc::with_capacity(count)?;
    for (k, piece) in pieces.iter().enumerate() {
        layers.push(Layer::new(piece, k, unit, origin, options, &prepare.share(k, count))?);
    }
    let trees = alloc::try_collect(layers.iter().map(|layer| {
        let Layer { scan, triangles, .. } = layer;
        TriangleTree::new(&scan.points, triangles, "looking at the pieces", &prepare.part(1.0, 1.0))
    }))?;
    let same = Same {
        distance: options.max_distance.map(|distance| distance / unit),
        edges: EDGES,
        cosine: libm::cos(if angle == 0.0 { ANGLE } else { angle }),
    };
    let covers = alloc::try_collect((0..count).map(|k| Covers::new(&layers, &trees, k, &same, &look.share(k, count))))?;
    let mut pairs = Vec::new();
    for (k, covers) in (0..).zip(&covers) {
        alloc::extend(&mut pairs, covers.pieces()?.into_iter().map(|j| [j.min(k), j.max(k)]))?;
    }
    sort_distinct(&mut pairs);
    let min_faces = options.least();
    let job = job.part(0.8, 1.0);
    let mut regions = alloc::try_collect(
        pieces.iter().enumerate().map(|(k, piece)| Region::new(piece, &job.part(0.0, 0.1).share(k, count))),
    )?;
    let mut cut = 0;
    for round in 0..MAX_ROUNDS {
        let job = job.part(0.1, 1.0).share(round, MAX_ROUNDS);
        // What cannot be kept competes with nothing: others are kept in its place.
        let mut lost = false;
        for k in 0..count {
            let done = 0.7 * k as f64 / count as f64;
            lost |= keep(&layers, &covers, &mut regions, k, min_faces, &job.part(done, done))?;
        }
        if lost && round + 2 < MAX_ROUNDS {
            continue;
        }
        if round + 2 < MAX_ROUNDS {
            let mut back = false;
            for k in 0..count {
                job.step(0.7, STAGE)?;
                let is_kept = |piece: u32, face: u32| regions[piece as usize].keeps[face as usize];
                let on = (0..layers[k].scan.points.len()).map(|v| covers[k].is_on(v, is_kept));
                let on = alloc::collect_cancellable(on, &job.part(0.7, 0.7), STAGE)?;
                back |= regions[k].give_back(&on, min_faces, &job.part(0.7, 0.7))?;
            }
            if back {
                continue;
            }
        }
        let mut found = crossings(&layers, &regions, &job.part(0.7, 1.0))?;
        add_touching(&layers, &regions, &pairs, &mut found)?;
        if found.iter().all(Vec::is_empty) {
            break;
        }
        for (region, faces) in regions.iter_mut().zip(&found) {
            cut += faces.len() as u32;
            region.lose(faces)?;
        }
    }
    let kept =
        |region: &Region<'_, '_>| alloc::gather((0..).zip(&region.keeps).filter(|(_, keeps)| **keeps).map(|(f, _)| f));
    Ok(Trimmed {
        kept: alloc::try_collect(regions.iter().map(kept))?,
        covered: alloc::collect(covers.iter().map(Covers::count))?,
        pairs,
        spacing: unit * layers.iter().map(|layer| layer.scan.spacing).fold(0.0, f64::max),
        crossings: cut,
    })
}

/// Chooses what is kept of piece `k`, of which nothing lies on what is kept of the pieces before
/// it: where it is as confident as those after it, give or take [`BIAS`]. True if islands were
/// lost.
fn keep(
    layers: &[Layer],
    covers: &[Covers],
    regions: &mut [Region<'_, '_>],
    k: usize,
    min_faces: u32,
    job: &Job<'_>,
) -> Result<bool> {
    let layer = &layers[k];
    let (before, rest) = regions.split_at_mut(k);
    let (own, after) = rest.split_at_mut(1);
    let points = &layer.scan.points;
    job.step(0.0, STAGE)?;
    // What is after it, and not lost.
    let competes = |piece: u32, face: u32| match (piece as usize).checked_sub(k + 1) {
        Some(j) => !after[j].lost[face as usize],
        None => false,
    };
    let margin = |v| covers[k].margin(v, layer.confidence[v], competes).clamp(-MAX_MARGIN, MAX_MARGIN);
    let mut margins = alloc::collect_cancellable((0..points.len()).map(margin), job, STAGE)?;
    own[0].smooth(&mut margins, SMOOTHINGS, job)?;
    let mut rims = [Rims::default(), Rims::default()];
    for (region, other) in before.iter().zip(layers) {
        job.step(0.0, STAGE)?;
        if layer.scan.bounds.is_within(&other.scan.bounds, GAP * other.scan.spacing) {
            region.rim(&other.scan, &mut rims, job)?;
        }
    }
    let trees = alloc::try_collect(rims.iter().map(|rims| KdTree::new(&rims.points, job, STAGE)))?;
    let gap = Radius::new((GAP * layer.scan.spacing).max(f64::MIN_POSITIVE));
    let is_near_rim = |v: usize| {
        let bars = |rims: &Rims, r: u32| rims.normals[r as usize].dot(layer.scan.normals[v]) > 0.0;
        // Borders that meet as they are need no gap.
        let count = if layer.scan.rim.contains(v as u32) { 1 } else { 2 };
        rims.iter().zip(&trees).take(count).any(|(rims, tree)| {
            let visit = |r| if bars(rims, r) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
            tree.visit_within(points[v], gap, &mut |_, r| visit(r)).is_break()
        })
    };
    let mut barred = alloc::with_capacity(points.len())?;
    for v in 0..points.len() {
        job.step_every(1 << 14, v, points.len(), STAGE)?;
        let is_kept = |piece: u32, face: u32| before.get(piece as usize).is_some_and(|r| r.keeps[face as usize]);
        barred.push(covers[k].is_on(v, is_kept) || is_near_rim(v));
    }
    job.step(0.0, STAGE)?;
    let wanted: Vec<bool> = alloc::collect(margins.iter().map(|&margin| margin > -BIAS))?;
    let shown = alloc::collect_cancellable((0..points.len()).map(|v| covers[k].is_on(v, competes)), job, STAGE)?;
    job.step(0.0, STAGE)?;
    own[0].keep_where(&wanted, &barred, &shown, min_faces, job)
}

/// The box of what faces use.
fn bounds(piece: &MeshView<'_>, unit: f64) -> Aabb {
    Aabb::from_points((0..piece.faces().len()).flat_map(|f| piece.face(f).map(|v| piece.positions().get(v) / unit)))
}
