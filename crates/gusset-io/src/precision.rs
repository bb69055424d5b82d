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
    if largest > 0.0
        && !lossy
        && let Some(mean) = mean_edge(mesh)
        && largest > MAX_MOVE_IN_EDGES * mean
    {
        return Err(WriteError::new(
            WriteErrorKind::Lossy,
            format!("single precision would move points by up to {largest:.3e}; the mean edge is {mean:.3e}; {remedy}"),
        ));
    }
    Ok(largest)
}

/// Returns the mean length of the faces' edges of finite length; `None` if it is 0 or there are none.
fn mean_edge(mesh: &Mesh) -> Option<f64> {
    let mut sum = 0.0;
    let mut count = 0_usize;
    for face in 0..mesh.face_count() {
        let vertices = mesh.face(face);
        let Some(&last) = vertices.last() else { continue };
        let mut from = mesh.positions.get(last as usize);
        for &vertex in vertices {
            let to = mesh.positions.get(vertex as usize);
            let length = (0..3).map(|axis| (from[axis] - to[axis]).powi(2)).sum::<f64>().sqrt();
            if length.is_finite() {
                sum += length;
                count += 1;
            }
            from = to;
        }
    }
    (sum > 0.0).then(|| sum / count as f64)
}

#[cfg(test)]
mod tests {
    use super::check_rounding;
    use crate::mesh::{Mesh, Positions};

    fn triangle(points: [[f64; 3]; 3]) -> Mesh {
        Mesh {
            positions: Positions::F64(points.to_vec()),
            face_offsets: vec![0, 3],
            corners: vec![0, 1, 2],
            ..Mesh::default()
        }
    }

    #[test]
    fn a_far_origin_is_refused_and_a_shift_is_exact() {
        // Single precision has steps of 1/16 at 600,000.
        let mesh = triangle([[600_000.0, 0.0, 0.0], [600_000.02, 0.0, 0.0], [600_000.0, 1.0, 0.0]]);
        let error = check_rounding(&mesh, [0.0; 3], false, "move it").expect_err("points move by 0.02");
        assert!(error.message.contains("2.0") && error.message.ends_with("move it"), "{error}");
        assert!((check_rounding(&mesh, [0.0; 3], true, "").expect("it is permitted") - 0.02).abs() < 1e-9);
        assert!(check_rounding(&mesh, [600_000.0, 0.0, 0.0], false, "").expect("the shift keeps digits") < 1e-8);
        assert_eq!(check_rounding(&triangle([[0.5; 3], [1.0; 3], [0.25; 3]]), [0.0; 3], false, ""), Ok(0.0));
    }

    #[test]
    fn points_without_a_place_are_not_measured() {
        let mesh = triangle([[f64::NAN, 0.0, 0.0], [f64::INFINITY, 600_000.02, 0.0], [0.0; 3]]);
        assert!(check_rounding(&mesh, [0.0; 3], false, "").is_ok_and(|largest| largest < 0.03));
        let mesh = triangle([[600_000.0, 0.0, f64::NAN], [600_000.02, 0.0, 0.0], [600_000.0, 0.001, 0.0]]);
        assert!(check_rounding(&mesh, [0.0; 3], false, "").is_err());
        // The largest number of single precision is 3.4e38.
        assert!(check_rounding(&triangle([[1e39, 0.0, 0.0], [0.0; 3], [0.0; 3]]), [0.0; 3], false, "").is_err());
    }
}
