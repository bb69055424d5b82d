//! Removes triangles that rounding has made thinner than a tolerance.
//!
//! A needle loses its shortest side. A cap, whose tip is near its longest side, and the triangle
//! beyond that side are replaced by the other two triangles of their quad.

use super::solid::{Solid, numbers_where};
use glam::DVec3;
use gusset_base::NONE;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::bit_set::BitSet;
use gusset_base::sort::sort_by_bucket;

/// A flat triangle.
enum FlatKind {
    /// A side, from corner k to the next, is short.
    Needle(usize),
    /// The corner opposite to the side from corner k is near it.
    Cap(usize),
}

impl Solid {
    /// Returns how a triangle is flat, or `None`.
    fn flatness(&self, triangle: [u32; 3], tolerance: f64) -> Option<FlatKind> {
        let at = triangle.map(|v| self.points[v as usize]);
        let sides = [0, 1, 2].map(|k| at[(k + 1) % 3] - at[k]);
        let lengths = sides.map(DVec3::length);
        let by_length = |i: &usize, j: &usize| lengths[*i].total_cmp(&lengths[*j]);
        let (shortest, longest) = ((0..3).min_by(by_length)?, (0..3).max_by(by_length)?);
        if lengths[shortest] <= tolerance {
            return Some(FlatKind::Needle(shortest));
        }
        let height = sides[longest].cross(sides[shortest]).length() / lengths[longest];
        (height <= tolerance).then_some(FlatKind::Cap(longest))
    }

    /// Removes flat triangles among those given, in turn. All others meet none. Returns false if nothing changes.
    /// Vertices of the input stay. O(n log n) for n triangles.
    pub(super) fn mend_flat_triangles(&mut self, among: &[u32], tolerance: f64) -> Result<bool> {
        let (count, corners) = (self.points.len(), self.triangles.len());
        let sides = self.triangles.iter().flat_map(|t| [[t[0], t[1]], [t[1], t[2]], [t[2], t[0]]]);
        let mut edges = alloc::gather(sides.zip(0u32..).map(|([p, q], h)| [p.min(q), p.max(q), h]))?;
        sort_by_bucket(&mut edges, count, |edge| edge[0])?;
        let half_edges = |p: u32, q: u32| {
            let ends = [p.min(q), p.max(q)];
            let start = edges.partition_point(|edge| [edge[0], edge[1]] < ends);
            let length = edges[start..].iter().take_while(|edge| [edge[0], edge[1]] == ends).count();
            &edges[start..start + length]
        };
        let mut targets = alloc::collect((0..count).map(|v| v as u32))?;
        let (mut used, mut replaced) = (BitSet::new(count)?, BitSet::new(corners)?);
        let mut is_changed = false;
        for &t in among {
            let triangle = self.triangles[t as usize];
            if replaced.contains(t) || triangle.iter().any(|&v| used.contains(v)) {
                continue;
            }
            match self.flatness(triangle, tolerance) {
                Some(FlatKind::Needle(k)) => {
                    let ends = [triangle[k], triangle[(k + 1) % 3]];
                    let Some(movable) = (0..2).find(|&j| self.vertices[ends[j] as usize] == NONE) else { continue };
                    targets[ends[movable] as usize] = ends[1 - movable];
                    ends.iter().for_each(|&v| used.insert(v));
                    is_changed = true;
                }
                Some(FlatKind::Cap(k)) => {
                    let [p, q, tip] = [triangle[k], triangle[(k + 1) % 3], triangle[(k + 2) % 3]];
                    let [first, second] = half_edges(p, q) else { continue };
                    let beyond = if first[2] / 3 == t { second[2] } else { first[2] };
                    let (other, j) = (beyond / 3, beyond as usize % 3);
                    let neighbour = self.triangles[other as usize];
                    let far = neighbour[(j + 2) % 3];
                    let is_opposed = neighbour[j] == q;
                    if !is_opposed || far == tip || replaced.contains(other) || !half_edges(tip, far).is_empty() {
                        continue;
                    }
                    self.triangles[t as usize] = [p, far, tip];
                    self.triangles[other as usize] = [far, q, tip];
                    self.faces[t as usize] = self.faces[other as usize];
                    [t, other].iter().for_each(|&t| replaced.insert(t));
                    [p, q, tip, far].iter().for_each(|&v| used.insert(v));
                    is_changed = true;
                }
                None => {}
            }
        }
        // All other triangles still meet none.
        among.iter().for_each(|&t| replaced.insert(t));
        for (t, triangle) in (0..).zip(&mut self.triangles) {
            let moved = triangle.map(|v| targets[v as usize]);
            if moved != *triangle {
                replaced.insert(t);
            }
            *triangle = moved;
        }
        let is_simple = |[a, b, c]: [u32; 3]| a != b && b != c && c != a;
        let kept = alloc::gather((0..corners as u32).filter(|&t| is_simple(self.triangles[t as usize])))?;
        self.suspects = Some(numbers_where(kept.len(), |k| replaced.contains(kept[k]))?);
        self.faces = alloc::collect(kept.iter().map(|&t| self.faces[t as usize]))?;
        self.triangles = alloc::collect(kept.iter().map(|&t| self.triangles[t as usize]))?;
        Ok(is_changed)
    }
}
