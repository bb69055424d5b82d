//! Attachment of one strip between two rims to the combined mesh.

use super::combine::{append_strip, strips_as_mesh};
use super::existing_edges::ExistingEdges;
use super::fair_and_check::{CheckedStrip, fair_and_check};
use super::meridian::MeridianEnds;
use super::rim_order::RimOrder;
use super::stitch_request::Options;
use super::stitch_rim::Rim;
use super::strip::{RimParents, Strip};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::Mesh;
use std::ops::Range;

/// The strips of a stitch in the combined mesh, for the fields of [`Stitch`](super::Stitch) with
/// the same names.
pub(super) struct AttachedStrips {
    pub(super) strip: Mesh,
    pub(super) faces: Range<u32>,
    pub(super) rims: [Vec<u32>; 2],
    pub(super) closed: bool,
    pub(super) meridians: Vec<MeridianEnds>,
    pub(super) matrix: Vec<u32>,
    pub(super) parents: Vec<[u32; 3]>,
    pub(super) weights: Vec<[f64; 3]>,
    pub(super) checked: CheckedStrip,
}

/// Builds the strip between two rims that run side by side, and appends it to `whole`.
pub(super) fn attach_strip(
    whole: &mut Mesh,
    [a, b]: [Rim; 2],
    unit: f64,
    existing: &ExistingEdges,
    options: &Options,
    job: &Job<'_>,
) -> Result<AttachedStrips> {
    let mean_side = || whole.mean_side_length() / unit;
    // A twist, and the existing edges, are counted from rim A.
    let has_order = options.twist == 0 && existing.is_empty();
    let order = if has_order { RimOrder::new(&a, &b) } else { RimOrder::GIVEN };
    let [a, b] = order.sort_rims([a, b]);
    let mut strip = Strip::build(a, b, existing, options, mean_side, &job.sub_job(0.0, 0.57))?;
    if strip.meridians.iter().any(|&[i, j]| strip.a.point(i) == strip.b.point(j)) {
        job.note("the rims have points in common that were not merged, so faces of the strip have no area");
    }
    let checked = fair_and_check(whole, &mut strip, unit, existing, options, &job.sub_job(0.57, 1.0))?;
    job.step(1.0, "putting the pieces together")?;
    let attached = append_strip(whole, &strip, unit)?;

    let name = |v: u32| attached.mesh_vertex_of_strip_vertex[v as usize];
    let matrix = order.given_matrix(alloc::collect(strip.grid.matrix.iter().map(|&v| name(v)))?);
    let (meridians, closed) = (order.given_meridians(&strip)?, strip.a.closed);
    let is_in_rows = strip.grid.row_count() > 0;
    let parents_and_weights = |parents: &RimParents| {
        let vertices = parents.vertices.map(name);
        if is_in_rows { order.given_parents(vertices, parents.weights) } else { (vertices, parents.weights) }
    };
    let parents = alloc::collect(strip.parents.iter().map(|parents| parents_and_weights(parents).0))?;
    let weights = alloc::collect(strip.parents.iter().map(|parents| parents_and_weights(parents).1))?;
    let rims = order.given_rims(&mut strip);
    let strip = strips_as_mesh(whole, rims.each_ref(), attached.vertices.start, attached.faces.start)?;
    Ok(AttachedStrips { strip, faces: attached.faces, rims, closed, meridians, matrix, parents, weights, checked })
}
