//! Kept faces of different pieces that intersect or touch each other.

use super::STAGE;
use super::kept_faces::KeptFaces;
use super::trim_piece::TrimPiece;
use crate::intersect::{TriangleSoup, intersecting_pairs_where};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use std::sync::atomic::{AtomicBool, Ordering};

/// Returns the faces of each piece that intersect a face of an earlier piece. O(F log F).
pub(super) fn find_crossing_faces(
    layers: &[TrimPiece],
    regions: &[KeptFaces<'_, '_>],
    job: &Job<'_>,
) -> Result<Vec<Vec<u32>>> {
    let mut points: Vec<DVec3> = Vec::new();
    // The triangles, and the piece and face of each.
    let (mut triangles, mut owners): (Vec<[u32; 3]>, Vec<[u32; 2]>) = (Vec::new(), Vec::new());
    for ((layer, region), k) in layers.iter().zip(regions).zip(0..) {
        let first = points.len() as u32;
        job.step(0.0, STAGE)?;
        alloc::append(&mut points, &layer.scan.points)?;
        let kept = layer.triangles.iter().zip(&layer.faces).filter(|(_, f)| region.is_kept_face[**f as usize]);
        for (n, (triangle, &f)) in kept.enumerate() {
            job.sub_job(0.0, 0.0).step_within_list(n, STAGE)?;
            alloc::push(&mut triangles, triangle.map(|v| v + first))?;
            alloc::push(&mut owners, [k, f])?;
        }
    }
    let soup =
        TriangleSoup { position_of_vertex: |v: u32| points[v as usize], new_triangles: &triangles, old_triangles: &[] };
    // Choose the face of the later piece, as elsewhere. Without a fixed rule, faces of both pieces
    // could be removed at one place.
    let worse = |s: u32, t: u32| if owners[s as usize][0] > owners[t as usize][0] { s } else { t };
    // List each face once, by any of its pairs. If many faces intersect one, not all pairs are
    // listed, and the result does not depend on the order.
    let is_found = alloc::collect((0..triangles.len()).map(|_| AtomicBool::new(false)))?;
    job.step(0.0, STAGE)?;
    let wanted = |s: u32, t: u32| {
        owners[s as usize][0] != owners[t as usize][0] && !is_found[worse(s, t) as usize].load(Ordering::Relaxed)
    };
    let list = |s: u32, t: u32| !is_found[worse(s, t) as usize].swap(true, Ordering::Relaxed);
    let mut crossing_faces = alloc::filled(Vec::new(), layers.len())?;
    for [s, t] in intersecting_pairs_where(&soup, &wanted, &list, job)? {
        let [k, f] = owners[worse(s, t) as usize];
        alloc::push(&mut crossing_faces[k as usize], f)?;
    }
    crossing_faces.iter_mut().for_each(sort_distinct);
    Ok(crossing_faces)
}

/// Adds faces that touch another piece exactly at a vertex without sharing an edge: strips and
/// seams do not fit there.
///
/// Applies only to pieces that overlap. If none of the pieces at a vertex shares an edge, the first
/// is kept. O(r log r) for r rim edges.
pub(super) fn add_touching_faces(
    layers: &[TrimPiece],
    regions: &[KeptFaces<'_, '_>],
    pairs: &[[u32; 2]],
    crossing_faces: &mut [Vec<u32>],
) -> Result<()> {
    // Add 0, so that -0 equals 0.
    let key = |p: DVec3| p.to_array().map(|x| (x + 0.0).to_bits());
    let mut edges = Vec::new();
    for ((layer, region), k) in layers.iter().zip(regions).zip(0u32..) {
        region.visit_rim_edges(|f, ends| {
            alloc::push(&mut edges, (ends.map(|v| key(layer.scan.points[v as usize])), k, f))
        })?;
    }
    // The edges as pairs of positions, and the ends of edges that two pieces share.
    let mut sides = alloc::collect(edges.iter().map(|&([p, q], k, _)| ([p.min(q), p.max(q)], k)))?;
    sides.sort_unstable();
    let mut held = Vec::new();
    for together in sides.chunk_by(|a, b| a.0 == b.0).filter(|all| all.iter().any(|side| side.1 != all[0].1)) {
        for &([p, q], k) in together {
            alloc::append(&mut held, &[(p, k), (q, k)])?;
        }
    }
    sort_distinct(&mut held);
    let mut places = alloc::gather(edges.iter().flat_map(|&([p, q], k, f)| [(p, k, f), (q, k, f)]))?;
    sort_distinct(&mut places);
    for place in places.chunk_by(|a, b| a.0 == b.0).filter(|place| place.iter().any(|end| end.1 != place[0].1)) {
        let first = place[0].1;
        let is_held = |k: u32| held.binary_search(&(place[0].0, k)).is_ok();
        let any = place.iter().any(|&(_, k, _)| is_held(k));
        let overlaps = |k: u32| place.iter().any(|&(_, j, _)| pairs.binary_search(&[j.min(k), j.max(k)]).is_ok());
        for &(_, k, f) in place.iter().filter(|&&(_, k, _)| !is_held(k) && (any || k != first) && overlaps(k)) {
            alloc::push(&mut crossing_faces[k as usize], f)?;
        }
    }
    crossing_faces.iter_mut().for_each(sort_distinct);
    Ok(())
}
