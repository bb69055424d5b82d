//! The least value of a function on the unit square, by trial.

/// Returns the least value that steps downhill find from the best of 5 x 5 places, or `None` if that
/// place is above `limit`. The last step is 1e-9.
pub fn least_value(value_at: &dyn Fn(f64, f64) -> f64, limit: f64) -> Option<f64> {
    let starts = (0..25).map(|k| (f64::from(k / 5) / 4.0, f64::from(k % 5) / 4.0));
    let valued = starts.map(|(u, v)| (u, v, value_at(u, v)));
    let (mut u, mut v, mut value) = valued.min_by(|a, b| a.2.total_cmp(&b.2))?;
    if value > limit {
        return None;
    }
    let mut step = 0.25;
    while step > 1e-9 {
        let around =
            [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (1.0, 1.0), (-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0)];
        let tries = around.map(|(x, y)| ((u + step * x).clamp(0.0, 1.0), (v + step * y).clamp(0.0, 1.0)));
        let lower = tries.into_iter().map(|(x, y)| (x, y, value_at(x, y))).find(|place| place.2 < value);
        match lower {
            Some(place) => (u, v, value) = place,
            None => step *= 0.5,
        }
    }
    Some(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bowl_has_its_bottom_inside_or_at_the_border() {
        let bowl = |x: f64, y: f64| least_value(&move |u, v| (u - x).powi(2) + (v - y).powi(2), 0.5);
        assert!(bowl(0.3, 0.7).unwrap() < 1e-15);
        assert!((bowl(1.5, 0.5).unwrap() - 0.25).abs() < 1e-15);
        assert_eq!(bowl(3.0, 0.0), None);
    }
}
