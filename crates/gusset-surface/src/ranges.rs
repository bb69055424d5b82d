//! Interval arithmetic for vectors: cross products, and angles to an axis.

/// Ranges of the components of the cross product of two vectors, each given by ranges of
/// components.
pub(crate) fn cross_product_ranges(u: [[f64; 2]; 3], v: [[f64; 2]; 3]) -> [[f64; 2]; 3] {
    [0, 1, 2].map(|k| {
        let (k, l) = ((k + 1) % 3, (k + 2) % 3);
        let (first, second) = (interval_product(u[k], v[l]), interval_product(u[l], v[k]));
        [first[0] - second[1], first[1] - second[0]]
    })
}

/// The product of two intervals.
fn interval_product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    let products = [a[0] * b[0], a[0] * b[1], a[1] * b[0], a[1] * b[1]];
    let (low, high) = (|x: f64, y: f64| if x < y { x } else { y }, |x: f64, y: f64| if x > y { x } else { y });
    [
        low(low(products[0], products[1]), low(products[2], products[3])),
        high(high(products[0], products[1]), high(products[2], products[3])),
    ]
}

/// The smallest and the largest angle between the third axis and a vector whose components lie
/// within ranges.
pub(crate) fn angle_range_to_third_axis(ranges: &[[f64; 2]; 3], noise: f64) -> [f64; 2] {
    let [first, second, along] = ranges.map(|[low, high]| [low - noise, high + noise]);
    let least = |[low, high]: [f64; 2]| if low > 0.0 { low } else { (-high).max(0.0) };
    let most = |[low, high]: [f64; 2]| high.max(-low);
    let length = |x: f64, y: f64| (x * x + y * y).sqrt();
    let (near, far) = (length(least(first), least(second)), length(most(first), most(second)));
    // A larger distance from the axis increases the angle in front of the origin, and decreases it
    // behind. At height 0, where the range of a pole's normals may end, all vectors except zero are
    // perpendicular to the axis.
    let low = libm::atan2(if along[1] > 0.0 { near } else { far }, along[1]);
    let high = libm::atan2(if along[0] >= 0.0 { far } else { near }, along[0]);
    [low - 1e-12, high + 1e-12]
}
