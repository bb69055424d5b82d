//! Trimming from the meshes to the faces that are kept.

use super::crossings::crossings;
use super::layer::Layer;
use super::margins::{Same, margins};
use super::region::Region;
use super::request::{Options, Trimmed};
use crate::align::common_unit_of;
use crate::alloc;
use crate::error::{Error, Result};
use crate::geom::Aabb;
use crate::geom::triangle_places::TriangleTree;
use crate::job::Job;
use crate::mesh::MeshView;

/// Surfaces that are no farther apart are one, in mean edges, if the caller says nothing.
const EDGES: f64 = 4.0;
/// Surfaces whose normals differ by more are two, in radians, if the caller says nothing.
const ANGLE: f64 = std::f64::consts::FRAC_PI_3;
/// Parts of fewer faces are no surface, if the caller says nothing.
const MIN_FACES: u32 = 30;
/// What a vertex is more confident by than what it lies on, in mean edges: as one side of a line
/// gains what the other loses, the gap is as wide.
const GAP: f64 = 0.5;
/// Rounds in which faces go that cut others.
const MAX_ROUNDS: usize = 8;

/// Says which faces of overlapping pieces are kept, so that no two surfaces lie on each other, and
/// narrow gaps are left where they did.
///
/// O(V log F) for each piece and those near it, on the job's threads. Memory: linear.
///
/// # Errors
/// [`Error::EmptyMesh`] without pieces, [`Error::OptionOutOfRange`] for a distance or an angle out
/// of range, [`Error::InputsDiffer`] for eyes of fewer pieces, [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn trim(pieces: &[MeshView<'_>], options: &Options<'_>, job: &Job<'_>) -> Result<Trimmed> {
    if pieces.is_empty() {
        return Err(Error::EmptyMesh { what: "pieces" });
    }
    if let Some(distance) = options.max_distance {
        Error::require((0.0..f64::INFINITY).contains(&distance), "max_distance", distance)?;
    }
    let angle = options.max_angle;
    Error::require((0.0..std::f64::consts::FRAC_PI_2).contains(&angle), "max_angle", angle)?;
    if !options.eyes.is_empty() && options.eyes.len() < pieces.len() {
        return Err(Error::InputsDiffer { given: options.eyes.len() as u64, needed: pieces.len() as u64 });
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
    let margins: Vec<Vec<f64>> =
        alloc::try_collect((0..count).map(|k| margins(&layers, &trees, k, &same, &look.share(k, count))))?;
    let min_faces = if options.min_faces == 0 { MIN_FACES } else { options.min_faces };
    let clear = job.part(0.8, 0.9);
    let mut regions = alloc::with_capacity(count)?;
    for (k, piece) in pieces.iter().enumerate() {
        let mut region = Region::new(piece, &clear.share(k, count))?;
        region.keep_where(|v| margins[k][v as usize] > GAP);
        region.clean(min_faces, &clear.share(k, count))?;
        regions.push(region);
    }
    let mut cut = 0;
    for _ in 0..MAX_ROUNDS {
        let found = crossings(&layers, pieces, &regions, &margins, &job.part(0.9, 1.0))?;
        if found.iter().all(Vec::is_empty) {
            break;
        }
        for (region, faces) in regions.iter_mut().zip(&found).filter(|(_, faces)| !faces.is_empty()) {
            cut += faces.len() as u32;
            region.take_out(faces)?;
            region.clean(min_faces, &job.part(0.9, 1.0))?;
        }
    }
    let kept = |region: &Region<'_, '_>| alloc::gather((0..).zip(&region.keeps).filter(|(_, keeps)| **keeps).map(|(f, _)| f));
    Ok(Trimmed {
        kept: alloc::try_collect(regions.iter().map(kept))?,
        covered: alloc::collect(margins.iter().map(|m| m.iter().filter(|m| m.is_finite()).count() as u32))?,
        crossings: cut,
    })
}

/// The box of what faces use.
fn bounds(piece: &MeshView<'_>, unit: f64) -> Aabb {
    Aabb::of((0..piece.faces().len()).flat_map(|f| piece.face(f).map(|v| piece.positions().get(v) / unit)))
}
