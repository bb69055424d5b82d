//! All triangulations of a few small loops by enumeration: the reference for the search.

use super::super::Weight;
use super::super::triangulation_cost::Polygon;
use glam::DVec3;

/// The state of a directed pair of vertices.
#[derive(Clone, Copy, PartialEq)]
enum SideState {
    Free,
    /// A triangle has yet to run along it.
    Wanted,
    /// A triangle with this normal runs along it.
    Run(DVec3),
    /// No triangle may run along it.
    Closed,
}

/// Closes the first wanted side by every possible third vertex, and so on.
pub(super) struct ExhaustiveTriangulation<'a> {
    weight: Weight,
    points: Vec<DVec3>,
    vertex_normals: Vec<DVec3>,
    normals_across_edges: Vec<DVec3>,
    next_vertex: Vec<usize>,
    unit: f64,
    side_states: Vec<SideState>,
    triangles: Vec<[u32; 3]>,
    /// The number of triangles of a complete triangulation.
    triangle_count: usize,
    is_forbidden_edge: &'a dyn Fn(u32, u32) -> bool,
    /// The least cost of the complete triangulations.
    best_cost: f64,
    /// Partial triangulations that cost at least this are skipped.
    cost_limit: f64,
}

impl<'a> ExhaustiveTriangulation<'a> {
    /// Returns the least cost below `cost_limit`; infinity if there is none.
    pub(super) fn least_cost(
        loops: &[Polygon],
        weight: Weight,
        taken: &'a dyn Fn(u32, u32) -> bool,
        cost_limit: f64,
    ) -> f64 {
        let mut search = ExhaustiveTriangulation::new(loops, weight, taken);
        search.cost_limit = cost_limit;
        search.close_first_wanted_side(0.0);
        search.best_cost
    }

    /// Returns the cost of the given triangles.
    pub(super) fn cost_of_triangles(loops: &[Polygon], weight: Weight, triangles: &[[u32; 3]]) -> f64 {
        let mut search = ExhaustiveTriangulation::new(loops, weight, &|_, _| false);
        triangles
            .iter()
            .map(|triangle| search.place_triangle(triangle.map(|v| v as usize)).expect("sides that are free"))
            .sum()
    }

    fn new(loops: &[Polygon], weight: Weight, taken: &'a dyn Fn(u32, u32) -> bool) -> Self {
        let all = |of: fn(&Polygon) -> &Vec<DVec3>| loops.iter().flat_map(of).copied().collect::<Vec<_>>();
        let points = all(|polygon| &polygon.points);
        let n = points.len();
        let mut next = Vec::new();
        for polygon in loops {
            let start = next.len();
            next.extend((0..polygon.points.len()).map(|i| start + (i + 1) % polygon.points.len()));
        }
        let mut sides = vec![SideState::Free; n * n];
        for (u, &v) in next.iter().enumerate() {
            sides[u * n + v] = SideState::Wanted;
            sides[v * n + u] = SideState::Closed;
        }
        let unit = (0..n).map(|u| points[u].distance(points[next[u]])).sum::<f64>() / 140.0;
        let (normals, across) = (all(|polygon| &polygon.normals), all(|polygon| &polygon.normals_across_edges));
        let count = n + 2 * loops.len() - 4;
        let (triangles, best, limit) = (Vec::new(), f64::INFINITY, f64::INFINITY);
        ExhaustiveTriangulation {
            weight,
            points,
            vertex_normals: normals,
            normals_across_edges: across,
            next_vertex: next,
            unit,
            side_states: sides,
            triangles,
            triangle_count: count,
            is_forbidden_edge: taken,
            best_cost: best,
            cost_limit: limit,
        }
    }

    fn close_first_wanted_side(&mut self, cost: f64) {
        if cost >= self.cost_limit {
            return;
        }
        let n = self.points.len();
        let Some(side) = self.side_states.iter().position(|&side| side == SideState::Wanted) else {
            if self.triangles.len() == self.triangle_count
                && is_connected_manifold(&self.triangles, n, &self.next_vertex)
            {
                (self.best_cost, self.cost_limit) = (cost, cost);
            }
            return;
        };
        if self.triangles.len() == self.triangle_count {
            return;
        }
        let (u, v) = (side / n, side % n);
        for w in (0..n).filter(|&w| w != u && w != v) {
            let before =
                [(u, v), (v, u), (v, w), (w, v), (w, u), (u, w)].map(|(a, b)| (a * n + b, self.side_states[a * n + b]));
            if let Some(more) = self.place_triangle([u, v, w]) {
                self.close_first_wanted_side(cost + more);
                self.triangles.pop();
            }
            before.iter().for_each(|&(at, side)| self.side_states[at] = side);
        }
    }

    /// Adds a triangle. Returns its cost, including the bends at its sides that now have two
    /// triangles, or `None` if the triangle is not possible.
    fn place_triangle(&mut self, corners: [usize; 3]) -> Option<f64> {
        let n = self.points.len();
        let pairs = [0, 1, 2].map(|k| (corners[k], corners[(k + 1) % 3]));
        let is_new = |&(u, v): &(usize, usize)| self.next_vertex[u] != v && self.next_vertex[v] != u;
        let can = |&(u, v): &(usize, usize)| matches!(self.side_states[u * n + v], SideState::Free | SideState::Wanted);
        let is_taken = |&(u, v): &(usize, usize)| (self.is_forbidden_edge)(u as u32, v as u32);
        if !pairs.iter().all(|pair| can(pair) && !(is_new(pair) && is_taken(pair))) {
            return None;
        }
        let [p, q, r] = corners.map(|v| self.points[v]);
        let cross = (q - p).cross(r - p);
        let normal = cross / cross.length();
        let bulge = |pair: &(usize, usize)| {
            let chord = (self.points[pair.1] - self.points[pair.0]) / self.unit;
            let [h, k] = [pair.0, pair.1].map(|v| chord.dot(self.vertex_normals[v]));
            if is_new(pair) { ((h * h + k * k) / 32.0).sqrt() } else { 0.0 }
        };
        let [x, y, z] = [bulge(&pairs[0]), bulge(&pairs[1]), bulge(&pairs[2])];
        let mut cost = match self.weight {
            Weight::Continuation => (x * x + y * y + z * z + x * y + x * z + y * z) / 6.0 / self.triangle_count as f64,
            _ => cross.length() / 2.0,
        };
        for (u, v) in pairs {
            let beyond = match self.side_states[v * n + u] {
                SideState::Run(beyond) => Some(beyond),
                SideState::Closed => Some(self.normals_across_edges[u]).filter(|&across| across != DVec3::ZERO),
                _ => None,
            };
            let cosine = beyond.map_or(1.0, |beyond| beyond.dot(normal).min(1.0));
            cost += match self.weight {
                // 2 sin(t / 2).
                Weight::Continuation => 2.0 * (cosine.clamp(-1.0, 1.0).acos() / 2.0).sin(),
                Weight::AreaAndBend => (1.0 - cosine) * self.points[u].distance_squared(self.points[v]),
                _ => 0.0,
            };
            self.side_states[u * n + v] = SideState::Run(normal);
            if self.side_states[v * n + u] == SideState::Free {
                self.side_states[v * n + u] = SideState::Wanted;
            }
        }
        self.triangles.push(corners.map(|v| v as u32));
        Some(cost)
    }
}

/// Returns true if the surface is connected, and the triangles at each vertex form one fan from its
/// outgoing to its incoming rim edge.
pub(super) fn is_connected_manifold(triangles: &[[u32; 3]], n: usize, next: &[usize]) -> bool {
    use std::collections::BTreeMap;
    let mut third = BTreeMap::new();
    for &[a, b, c] in triangles {
        for (u, v, w) in [(a, b, c), (b, c, a), (c, a, b)] {
            if third.insert((u as usize, v as usize), w as usize).is_some() {
                return false;
            }
        }
    }
    let fans = (0..n).all(|v| {
        let valence = triangles.iter().flatten().filter(|&&w| w as usize == v).count();
        let (mut u, mut steps) = (next[v], 0);
        // Walk from each side (v, u) to the third vertex of its triangle.
        while let Some(&w) = third.get(&(v, u)) {
            (u, steps) = (w, steps + 1);
            if steps > valence {
                return false;
            }
        }
        steps == valence && next[u] == v
    });
    let mut seen = vec![false; n];
    seen[0] = true;
    for _ in 0..n {
        for triangle in triangles {
            let any = triangle.iter().any(|&v| seen[v as usize]);
            triangle.iter().for_each(|&v| seen[v as usize] |= any);
        }
        if seen.iter().all(|&seen| seen) {
            break;
        }
    }
    fans && seen.iter().all(|&seen| seen)
}
