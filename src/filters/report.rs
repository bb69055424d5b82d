//! Lines of the reports that filters give as text.

/// Appends a formatted line to a text.
macro_rules! push_line {
    ($text:expr, $($arg:tt)*) => {{
        use std::fmt::Write as _;
        // Writing to a string cannot fail.
        let _ = writeln!($text, $($arg)*);
    }};
}
pub(super) use push_line;

/// A line on distances: their number, the largest, the mean and the root mean square.
pub(super) fn distances(of_what: &str, distances: impl Iterator<Item = f64>) -> String {
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
