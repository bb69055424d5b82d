//! Nearest points of surfaces through any nodes: no node is nearer than the reported distance, and
//! the bound is at most the distance.

use crate::distance;
use crate::input;
use crate::input::{Cloud, Point, places};
use gusset::Job;
use gusset::surface::{Grid, Nodes, Scheme, Sheet, Surface};

/// Runs one case.
pub(crate) fn run(bytes: &[u8]) {
    let Some(input) = input::taken::<(Cloud, [u8; 2], [bool; 2], bool, Point)>(bytes) else { return };
    let (points, size, closed, four, query) = input;
    let [rows, columns] = size.map(|size| 2 + usize::from(size % 7));
    let (points, query) = (places(&points), query.at());
    if points.is_empty() {
        return;
    }
    // Closed directions end where they begin.
    let at = |k: usize, count: usize, closed: bool| if closed && k + 1 == count { 0 } else { k };
    let node = |i, j| points[(at(i, rows, closed[0]) * columns + at(j, columns, closed[1])) % points.len()];
    let nodes: Vec<f64> = (0..rows * columns).flat_map(|k| node(k / columns, k % columns).to_array()).collect();
    let scheme = if four { Scheme::FourPoint } else { Scheme::SixTap };
    let grid = Nodes::strided(nodes.clone(), rows, columns, 0, 0).and_then(|nodes| Grid::new(nodes, closed, scheme));
    let Ok(surface) = grid.and_then(|grid| Surface::new(vec![Sheet::Grid(grid)], None, &Job::default())) else {
        return;
    };
    let Some(found) = surface.closest(query, f64::INFINITY) else { return };
    let nearest =
        nodes.chunks(3).map(|node| distance(query, glam::DVec3::from_slice(node))).fold(f64::INFINITY, f64::min);
    let slack = 1e-9 * (1.0 + nearest) + surface.tolerance();
    assert!(found.bound <= found.distance && found.distance <= nearest + slack, "{found:?} {nearest}");
}
