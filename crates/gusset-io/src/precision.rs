//! Moves of points by rounding to single precision.

use crate::error::{WriteError, WriteErrorKind};
use crate::mesh::{Mesh, Positions};

/// Largest distance by which a format may move a point, in mean edges.
const MAX_MOVE_IN_EDGES: f64 = 1e-3;

/// Refuses to round the mesh's points, less `origin`, to single precision if that moves one by more than a thousandth of the mean edge,
/// unless `lossy`. Returns the largest move: 0 if all points are exact.
pub(crate) fn check_rounding(mesh: &Mesh, origin: [f64; 3], lossy: bool, remedy: &str) -> Result<f64, WriteError> {
    let Positions::F64(points) = &mesh.positions else { return Ok(0.0) };
    let mut largest: f64 = 0.0;
    for point in points {
        for axis in 0..3 {
            let shifted = point[axis] - origin[axis];
            largest = largest.max((f64::from(shifted as f32) - shifted).abs());
        }
    }
    if largest > 0.0 && !lossy {
        let mean = mean_edge(mesh);
        if largest > MAX_MOVE_IN_EDGES * mean {
            return Err(WriteError::new(
                WriteErrorKind::Lossy,
                format!(
                    "single precision would move points by up to {largest:.3e}; the mean edge is {mean:.3e}; {remedy}"
                ),
            ));
        }
    }
    Ok(largest)
}

fn mean_edge(mesh: &Mesh) -> f64 {
    let mut sum = 0.0;
    for face in 0..mesh.face_count() {
        let vertices = mesh.face(face);
        for (place, &vertex) in vertices.iter().enumerate() {
            let [a, b] = [vertex, vertices[(place + 1) % vertices.len()]].map(|v| mesh.positions.get(v as usize));
            sum += (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum::<f64>().sqrt();
        }
    }
    sum / (mesh.corners.len().max(1)) as f64
}
