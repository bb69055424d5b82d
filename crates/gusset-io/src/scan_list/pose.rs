//! Poses of scans.

/// Rows of the 3 x 4 matrix that takes points of a scan into the scene.
pub(super) type Pose = [[f64; 4]; 3];

/// Returns the pose of a translation and a quaternion of any length that rotates the axes; `None` if a number is not finite, or the
/// quaternion has length 0.
pub(super) fn from_numbers(numbers: [f64; 7]) -> Option<Pose> {
    if !numbers.iter().all(|number| number.is_finite()) {
        return None;
    }
    let [tx, ty, tz, quaternion @ ..] = numbers;
    let largest = quaternion.iter().fold(0.0_f64, |largest, part| largest.max(part.abs()));
    if largest == 0.0 {
        return None;
    }
    let scaled = quaternion.map(|part| part / largest);
    let length = scaled.iter().map(|part| part * part).sum::<f64>().sqrt();
    let [i, j, k, w] = scaled.map(|part| part / length);
    Some([
        [1.0 - 2.0 * (j * j + k * k), 2.0 * (i * j + k * w), 2.0 * (i * k - j * w), tx],
        [2.0 * (i * j - k * w), 1.0 - 2.0 * (i * i + k * k), 2.0 * (j * k + i * w), ty],
        [2.0 * (i * k + j * w), 2.0 * (j * k - i * w), 1.0 - 2.0 * (i * i + j * j), tz],
    ])
}

/// Returns the pose that applies `first`, then `second`.
pub(super) fn product(second: &Pose, first: &Pose) -> Pose {
    let entry = |row: usize, column: usize| {
        (0..3).map(|k| second[row][k] * first[k][column]).sum::<f64>() + if column == 3 { second[row][3] } else { 0.0 }
    };
    [0, 1, 2].map(|row| [0, 1, 2, 3].map(|column| entry(row, column)))
}

/// Returns the point in the scene.
pub(super) fn placed_point(pose: &Pose, [x, y, z]: [f64; 3]) -> [f64; 3] {
    pose.map(|row| row[0] * x + row[1] * y + row[2] * z + row[3])
}

/// Returns the direction in the scene.
pub(super) fn placed_direction(pose: &Pose, [x, y, z]: [f64; 3]) -> [f64; 3] {
    pose.map(|row| row[0] * x + row[1] * y + row[2] * z)
}
