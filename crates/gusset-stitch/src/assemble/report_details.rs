//! Details of the report: how long cuts are, and which vertices of pieces the left loops pass.

use super::assemble_request::Assembly;
use crate::intersect::common_segment_length;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_mesh::{Mesh, NONE};

const STAGE: &str = "writing the report";

impl Assembly {
    /// Computes the lengths of all cuts, and finds a vertex of a piece on each left loop. O(V) for V
    /// vertices, and O(1) for each pair of intersecting triangles.
    pub(super) fn add_report_details(&mut self, job: &Job<'_>) -> Result<()> {
        for joint in &mut self.joints {
            joint.cut_length = cut_length(&self.mesh, joint.intersections.as_deref().unwrap_or_default(), job)?;
        }
        let pairs = self.hole_intersections.as_deref().unwrap_or_default();
        self.hole_cut_lengths = alloc::filled(0.0, self.holes.len())?;
        for (hole, length) in self.holes.iter().zip(&mut self.hole_cut_lengths) {
            let first = pairs.partition_point(|pair| pair[0] < hole.faces.start);
            let end = pairs.partition_point(|pair| pair[0] < hole.faces.end);
            *length = cut_length(&self.mesh, &pairs[first..end], job)?;
        }
        self.name_left_loops(job)
    }

    /// Finds the first vertex of a piece on each left loop.
    fn name_left_loops(&mut self, job: &Job<'_>) -> Result<()> {
        if self.left.is_empty() {
            return Ok(());
        }
        let mut origins = alloc::filled([NONE; 2], self.mesh.positions.len())?;
        for (map, k) in self.maps.iter().zip(0..) {
            job.step(0.0, STAGE)?;
            for (&name, v) in map.vertices.iter().zip(0..).filter(|&(&name, _)| name != NONE) {
                let origin = &mut origins[name as usize];
                *origin = if origin[0] == NONE { [k, v] } else { *origin };
            }
        }
        for left in &mut self.left {
            let of_pieces = left.vertices.iter().map(|&v| origins[v as usize]);
            left.origin = of_pieces.into_iter().find(|origin| origin[0] != NONE).unwrap_or([NONE; 2]);
        }
        Ok(())
    }
}

/// Returns the total length of the segments in which pairs of faces intersect. Polygons are fans
/// from their first corners.
fn cut_length(mesh: &Mesh, pairs: &[[u32; 2]], job: &Job<'_>) -> Result<f64> {
    let triangles = |f: u32| {
        let corners = mesh.face_offsets[f as usize] as usize..mesh.face_offsets[f as usize + 1] as usize;
        let at = |corner: usize| mesh.positions.get(mesh.corner(corner));
        let first = corners.start;
        (first + 1..corners.end - 1).map(move |corner| [at(first), at(corner), at(corner + 1)])
    };
    let mut total = 0.0;
    for (n, &[f, g]) in pairs.iter().enumerate() {
        job.step_within_list(n, STAGE)?;
        let both = triangles(f).flat_map(|t| triangles(g).map(move |u| [t, u]));
        total += both.map(|[t, u]| common_segment_length(t, u)).sum::<f64>();
    }
    Ok(total)
}
