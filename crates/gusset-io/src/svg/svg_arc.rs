//! Elliptical arcs of paths, by their ends (SVG 1.1, appendix F.6).

/// An arc by its centre, which is convenient to draw.
pub(super) struct CentredArc {
    pub(super) centre: [f64; 2],
    /// Vectors from the centre to angle 0 and to angle 90 degrees.
    pub(super) axes: [[f64; 2]; 2],
    /// Angle of the start, and the signed angle to the end.
    pub(super) angles: [f64; 2],
}

impl CentredArc {
    /// Returns `None` if the arc is a line, because a radius is 0 or the ends are equal.
    pub(super) fn from_ends(
        start: [f64; 2],
        end: [f64; 2],
        radii: [f64; 2],
        rotation_degrees: f64,
        [is_large, is_positive]: [bool; 2],
    ) -> Option<Self> {
        let [mut rx, mut ry] = radii.map(f64::abs);
        if !(rx > 0.0 && ry > 0.0) || start == end {
            return None;
        }
        let (sin, cos) = rotation_degrees.to_radians().sin_cos();
        let half = [(start[0] - end[0]) / 2.0, (start[1] - end[1]) / 2.0];
        // The start relative to the middle of the chord, along the axes.
        let [x, y] = [cos * half[0] + sin * half[1], -sin * half[0] + cos * half[1]];
        let excess = (x / rx).powi(2) + (y / ry).powi(2);
        if excess > 1.0 {
            rx *= excess.sqrt();
            ry *= excess.sqrt();
        }
        let ratio = (1.0 / excess.min(1.0) - 1.0).max(0.0).sqrt();
        let ratio = if is_large == is_positive { -ratio } else { ratio };
        let [u, v] = [ratio * rx * y / ry, -ratio * ry * x / rx];
        let centre = [cos * u - sin * v + (start[0] + end[0]) / 2.0, sin * u + cos * v + (start[1] + end[1]) / 2.0];
        let first = ((y - v) / ry).atan2((x - u) / rx);
        let last = ((-y - v) / ry).atan2((-x - u) / rx);
        let mut sweep = last - first;
        if is_positive && sweep < 0.0 {
            sweep += std::f64::consts::TAU;
        } else if !is_positive && sweep > 0.0 {
            sweep -= std::f64::consts::TAU;
        }
        let axes = [[rx * cos, rx * sin], [-ry * sin, ry * cos]];
        Some(Self { centre, axes, angles: [first, sweep] })
    }
}
