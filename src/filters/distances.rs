//! What filters say of distances that they have measured.

/// A line of text: how many, the largest, the mean and the root of the mean square.
pub(super) fn account(of_what: &str, distances: impl Iterator<Item = f64>) -> String {
    let (mut count, mut largest, mut sum) = (0u64, 0.0f64, 0.0);
    // Squares relative to the largest so far, which neither overflow nor vanish.
    let mut squares = 0.0;
    for distance in distances {
        count += 1;
        sum += distance;
        if distance > largest {
            squares = squares * (largest / distance) * (largest / distance);
            largest = distance;
        }
        if largest > 0.0 {
            squares += (distance / largest) * (distance / largest);
        }
    }
    let number = count.max(1) as f64;
    let root = largest * (squares / number).sqrt();
    format!(
        "{count} {of_what}: largest distance {largest:.6e}, mean {:.6e}, root mean square {root:.6e}\n",
        sum / number
    )
}
