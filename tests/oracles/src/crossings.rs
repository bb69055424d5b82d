//! Which triangles an edge of another one crosses.

use crate::distances::Triangle;
use glam::DVec3;

/// Whether a segment crosses a triangle.
fn crosses([a, b]: [DVec3; 2], [p, q, r]: Triangle) -> bool {
    let volume = |x: DVec3, y: DVec3, z: DVec3| (x - a).cross(y - a).dot(z - a);
    let above = |x: DVec3| (q - p).cross(r - p).dot(x - p);
    let signs = [volume(b, p, q), volume(b, q, r), volume(b, r, p)].map(|x| x > 0.0);
    (above(a) > 0.0) != (above(b) > 0.0) && signs[0] == signs[1] && signs[1] == signs[2]
}

/// All pairs of triangles of which the first one has an edge that crosses the second one.
pub fn crossing_pairs(triangles: &[Triangle]) -> Vec<[usize; 2]> {
    let boxes: Vec<[DVec3; 2]> = triangles.iter().map(|&[p, q, r]| [p.min(q).min(r), p.max(q).max(r)]).collect();
    let mut found = Vec::new();
    for (m, one) in triangles.iter().enumerate() {
        for (n, &other) in triangles.iter().enumerate() {
            let meets = boxes[m][0].cmple(boxes[n][1]).all() && boxes[n][0].cmple(boxes[m][1]).all();
            if m != n && meets && (0..3).any(|k| crosses([one[k], one[(k + 1) % 3]], other)) {
                found.push([m, n]);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_edge_through_a_triangle_is_found() {
        let flat = [DVec3::ZERO, DVec3::X, DVec3::Y];
        let upright = |x: f64| [DVec3::new(x, 0.2, -1.0), DVec3::new(x, 0.2, 1.0), DVec3::new(x, 0.3, 1.0)];
        assert_eq!(crossing_pairs(&[flat, upright(0.2), upright(0.9)]), [[1, 0]]);
    }
}
