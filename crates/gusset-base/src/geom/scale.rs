//! An exact change of unit: multiplication by a power of two.

use glam::DVec3;

/// Returns the largest power of two that does not exceed the largest absolute coordinate, clamped
/// to 2^-900 .. 2^900. Returns 1 if all coordinates are 0 or there are none.
///
/// Division by it is exact, so comparisons of lengths and areas keep their results. Products of a
/// few coordinates neither overflow nor underflow in any unit of the host.
pub fn common_unit<'a>(points: impl IntoIterator<Item = &'a DVec3>) -> f64 {
    let largest = points.into_iter().fold(0.0, |m: f64, p| m.max(p.abs().max_element()));
    if largest == 0.0 {
        return 1.0;
    }
    floor_to_power_of_two(largest)
}

/// Returns the largest power of two that does not exceed a positive number, clamped to 2^-900 ..
/// 2^900.
#[inline]
pub fn floor_to_power_of_two(x: f64) -> f64 {
    let exponent = ((x.to_bits() >> 52) & 0x7ff).clamp(1023 - 900, 1023 + 900);
    f64::from_bits(exponent << 52)
}

/// Returns the distance between two points of any magnitude.
#[inline]
pub fn overflow_safe_distance(p: DVec3, q: DVec3) -> f64 {
    let unit = common_unit(&[p, q]);
    (p / unit).distance(q / unit) * unit
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn common_unit_is_a_power_of_two_near_the_size_of_the_points() {
        for size in [1e-250, 1e-3, 1.0, 3.7, 1e12, 1.7e250] {
            let unit = common_unit(&[DVec3::new(0.0, -size, size / 2.0)]);
            assert!((1.0..2.0).contains(&(size / unit)), "{size}");
            assert_eq!(unit.to_bits() << 12, 0, "{unit} is a power of two");
        }
        assert_eq!(common_unit(&[DVec3::ZERO]), 1.0);
        assert_eq!(common_unit(&[]), 1.0);
        assert!((overflow_safe_distance(DVec3::X * 3e200, DVec3::Y * 4e200) / 5e200 - 1.0).abs() < 1e-15);
        assert!((overflow_safe_distance(DVec3::X * 3e-200, DVec3::Y * 4e-200) / 5e-200 - 1.0).abs() < 1e-15);
        assert!((f64::MAX / common_unit(&[DVec3::splat(f64::MAX)])).powi(2).is_finite());
    }
}
