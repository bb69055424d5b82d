//! Kept faces of different pieces that cut each other.

use super::layer::Layer;
use super::region::Region;
use crate::alloc;
use crate::error::Result;
use crate::intersect::{Soup, intersecting_pairs};
use crate::job::Job;
use crate::mesh::MeshView;
use glam::DVec3;

/// The faces that cut one of another piece and are less confident than it, for each piece; of equal
/// ones that of the later piece. O(F log F).
pub(super) fn crossings(
    layers: &[Layer],
    meshes: &[MeshView<'_>],
    regions: &[Region<'_, '_>],
    job: &Job<'_>,
) -> Result<Vec<Vec<u32>>> {
    let mut starts = alloc::with_capacity(layers.len() + 1)?;
    starts.push(0u32);
    let mut points: Vec<DVec3> = Vec::new();
    // Triangles, the pieces and the faces that they are of.
    let (mut triangles, mut of): (Vec<[u32; 3]>, Vec<[u32; 2]>) = (Vec::new(), Vec::new());
    for (k, (layer, mesh)) in layers.iter().zip(meshes).enumerate() {
        let first = starts[k];
        alloc::append(&mut points, &layer.scan.points)?;
        starts.push(points.len() as u32);
        for f in (0..mesh.faces().len()).filter(|&f| regions[k].keeps[f]) {
            let mut corners = mesh.face(f);
            let apex = corners.next().unwrap_or(0) + first;
            for (u, v) in corners.clone().zip(corners.skip(1)) {
                alloc::push(&mut triangles, [apex, u + first, v + first])?;
                alloc::push(&mut of, [k as u32, f as u32])?;
            }
        }
    }
    let soup = Soup { at: |v: u32| points[v as usize], new: &triangles, old: &[] };
    let mut found = alloc::filled(Vec::new(), layers.len())?;
    for pair in intersecting_pairs(&soup, job)? {
        let [a, b] = pair.map(|t| of[t as usize]);
        if a[0] == b[0] {
            continue;
        }
        let confidence = |[k, f]: [u32; 2]| {
            let own = meshes[k as usize].face(f as usize).map(|v| layers[k as usize].confidence[v as usize]);
            own.fold(f64::INFINITY, f64::min)
        };
        let first_is_worse = confidence(a).total_cmp(&confidence(b)).is_lt();
        let worse = if first_is_worse { a } else { b };
        alloc::push(&mut found[worse[0] as usize], worse[1])?;
    }
    Ok(found)
}
