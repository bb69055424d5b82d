//! Detection of the gluing of a net from its coordinates.
//!
//! Neighbours that coincide are contracted links. Otherwise only the rim is examined. A run of at
//! least two rim nodes that coincide with others, in the same direction or reversed, is a seam.
//! These seams cover closed rows and columns, reversed sides and folded sides. A single pair of
//! coincident nodes is a touch and not glued. Candidate pairs are found in a uniform grid, sorted
//! by cell. O(nodes), plus O(r log r) for r rim nodes.

use super::coincidence::{are_coincident, for_each_coincident_link};
use super::topology::{ContractedLinks, LinkMatrix, Seam, SeamRun, Topology};
use super::{Coordinates, NodeClasses, Shape, each};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use std::cmp::Ordering;

/// The maximum number of coincident rim nodes with which a rim node is paired.
const MAX_PARTNERS_PER_NODE: usize = 8;

/// Returns the topology that coordinates imply, in canonical form ([`Topology::canonical_form`]):
/// coincident neighbours, and runs of at least two coincident rim nodes. Tolerance 0: equal
/// coordinates (0 and -0 are equal). O(nodes), and a sort of the rim.
///
/// # Errors
/// [`Error::OptionOutOfRange`](gusset_base::Error::OptionOutOfRange) for a tolerance that is
/// negative or not finite, [`Error::CrossingCell`](gusset_base::Error::CrossingCell) for a cell
/// whose pairs of opposite corners coincide separately,
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn detect_gluing(coordinates: &Coordinates<'_>, tolerance: f64, job: &Job<'_>) -> Result<Topology> {
    Error::require(tolerance.is_finite() && tolerance >= 0.0, "tolerance", tolerance, "finite and at least 0")?;
    let shape = coordinates.shape();
    let mut matrix = LinkMatrix::empty(shape)?;
    each!(coordinates, planes => for_each_coincident_link(planes, tolerance, &job.sub_job(0.0, 0.5), |link| {
        if shape.joins_neighbours(link) {
            matrix.set_contracted(link, true);
        }
        Ok(())
    }))?;
    let near = Topology::new(shape, ContractedLinks::Matrix(matrix), &[])?;
    let classes = NodeClasses::new(&near)?;
    let rim = NetRim { shape, coordinates, tolerance };
    let seams = rim.seams_of_pairs(&rim.coincident_pairs(&classes)?, &classes)?;
    job.step(0.8, "detecting gluings")?;
    Topology::new(shape, ContractedLinks::Matrix(near.to_link_matrix()?), &seams)?.canonical_form()
}

/// The nodes of the four sides, numbered around the net: the first row forwards, the last column
/// down, the last row backwards, the first column up. Each corner appears once.
struct NetRim<'a> {
    shape: Shape,
    coordinates: &'a Coordinates<'a>,
    tolerance: f64,
}

impl NetRim<'_> {
    fn len(&self) -> usize {
        2 * (self.shape.rows() + self.shape.columns()) - 4
    }

    /// Where the four sides start, and the end.
    fn first_rim_nodes_of_sides(&self) -> [usize; 5] {
        let (h, w) = (self.shape.rows() - 1, self.shape.columns() - 1);
        [0, w, w + h, 2 * w + h, 2 * (w + h)]
    }

    fn row_and_column(&self, k: usize) -> (usize, usize) {
        let (h, w) = (self.shape.rows() - 1, self.shape.columns() - 1);
        match k {
            k if k < w => (0, k),
            k if k < w + h => (k - w, w),
            k if k < 2 * w + h => (h, 2 * w + h - k),
            k => (2 * (w + h) - k, 0),
        }
    }

    fn position(&self, k: usize) -> DVec3 {
        let (i, j) = self.row_and_column(k % self.len());
        self.coordinates.get(i, j)
    }

    fn class_of_rim_node(&self, classes: &NodeClasses, k: usize) -> u32 {
        let (i, j) = self.row_and_column(k % self.len());
        classes.representative(self.shape.node(i, j))
    }

    /// Coincident pairs of rim nodes that are not one vertex by links alone, each vertex by its
    /// first node.
    fn coincident_pairs(&self, classes: &NodeClasses) -> Result<Vec<[usize; 2]>> {
        let mut nodes: Vec<(u32, usize)> =
            alloc::collect((0..self.len()).map(|k| (self.class_of_rim_node(classes, k), k)))?;
        nodes.sort_unstable();
        nodes.dedup_by_key(|node| node.0);
        let finite = nodes.iter().filter(|node| self.position(node.1).is_finite());
        let mut sorted: Vec<(GridCell, usize)> = alloc::gather(finite.map(|&(_, k)| (self.grid_cell(k), k)))?;
        sorted.sort_unstable_by(|a, b| compare_cells(&a.0, &b.0).then(a.1.cmp(&b.1)));
        // Nodes within the tolerance lie in one cell or in adjacent ones; cells along z are
        // consecutive.
        let near: &[f64] = if self.tolerance > 0.0 { &[-1.0, 0.0, 1.0] } else { &[0.0] };
        let (first, last) = (near[0], near[near.len() - 1]);
        let mut pairs = Vec::new();
        for (at, &([x, y, z], k)) in sorted.iter().enumerate() {
            // Each pair is found from its first node.
            let candidates =
                near.iter().flat_map(|dx| near.iter().map(move |dy| [x + dx, y + dy])).flat_map(|[x, y]| {
                    let rest = &sorted[at + 1..];
                    let from = rest.partition_point(|other| compare_cells(&other.0, &[x, y, z + first]).is_lt());
                    rest[from..].iter().take_while(move |other| compare_cells(&other.0, &[x, y, z + last]).is_le())
                });
            let partners =
                candidates.filter(|&&(_, l)| are_coincident(self.position(k), self.position(l), self.tolerance));
            for &(_, l) in partners.take(MAX_PARTNERS_PER_NODE) {
                alloc::push(&mut pairs, [k.min(l), k.max(l)])?;
            }
        }
        Ok(pairs)
    }

    /// Returns the grid cell of a rim node, 1 % wider than the tolerance for rounding. Without a
    /// tolerance, or with one below the spacing of numbers, each position is a cell.
    fn grid_cell(&self, k: usize) -> GridCell {
        self.position(k).to_array().map(|x| {
            let at = (x / (self.tolerance * 1.01)).floor();
            // Adding 0 makes -0 and 0 equal.
            (if self.tolerance > 0.0 && at.is_finite() { at } else { x }) + 0.0
        })
    }

    /// Returns the seams of the pairs. Pairs with equal sums of their places form a reversed run,
    /// pairs with equal differences a run in the same direction, both modulo the length of the rim.
    /// Every run is found from both its sides; a topology merges the two.
    fn seams_of_pairs(&self, pairs: &[[usize; 2]], classes: &NodeClasses) -> Result<Vec<Seam>> {
        let n = self.len();
        let mut seams = Vec::new();
        for reversed in [true, false] {
            let line = |k: usize, l: usize| if reversed { (k + l) % n } else { (l + n - k) % n };
            let mut sorted = alloc::gather(pairs.iter().flat_map(|&[k, l]| [(line(k, l), k), (line(l, k), l)]))?;
            sort_distinct(&mut sorted);
            for line in sorted.chunk_by(|a, b| a.0 == b.0) {
                let pairing = RimPairing { place_sum_or_difference: line[0].0, reversed, rim_node_count: n };
                for (start, count) in runs_modulo(line, n) {
                    self.add_seam_run(pairing, start, count, classes, &mut seams)?;
                }
            }
        }
        Ok(seams)
    }

    /// Adds a run, cut where either side turns a corner. The run is extended by one pair at each
    /// end if that pair coincides but was not compared because links already glue it.
    fn add_seam_run(
        &self,
        pairing: RimPairing,
        start: usize,
        count: usize,
        classes: &NodeClasses,
        seams: &mut Vec<Seam>,
    ) -> Result<()> {
        let n = self.len();
        let same = |k: usize| {
            self.class_of_rim_node(classes, k) == self.class_of_rim_node(classes, pairing.partner_of_rim_node(k))
                || are_coincident(self.position(k), self.position(pairing.partner_of_rim_node(k)), self.tolerance)
        };
        let before = usize::from(count < n && same(start + n - 1));
        let after = usize::from(count < n && same(start + count));
        let (mut k, mut steps) = (start + n - before, before + count + after - 1);
        // A fold is its own partner.
        if pairing.reversed && pairing.partner_of_rim_node(k) % n == (k + steps) % n {
            steps /= 2;
        }
        while steps > 0 {
            let (a, b) = (
                self.straight_run_to_corner(k, true),
                self.straight_run_to_corner(pairing.partner_of_rim_node(k), !pairing.reversed),
            );
            let straight = a.1.min(b.1).min(steps);
            alloc::push(seams, Seam { a: a.0, b: b.0, count: straight as u32 + 1 })?;
            (k, steps) = (k + straight, steps - straight);
        }
        Ok(())
    }

    /// Returns the straight run from rim node k round the rim, or back, and the number of steps up
    /// to the corner.
    fn straight_run_to_corner(&self, k: usize, forwards: bool) -> (SeamRun, usize) {
        let (k, corners) = (k % self.len(), self.first_rim_nodes_of_sides());
        // Back from a corner leads along the previous side.
        let k = if k == 0 && !forwards { corners[4] } else { k };
        let side = (0..4).rposition(|side| if forwards { corners[side] <= k } else { corners[side] < k }).unwrap_or(0);
        let steps = if forwards { corners[side + 1] - k } else { k - corners[side] };
        let (i, j) = self.row_and_column(k);
        let along = if forwards { 1 } else { -1 };
        let (row_step, column_step) = [(0, along), (along, 0), (0, -along), (-along, 0)][side];
        (SeamRun { row: i as u32, column: j as u32, row_step, column_step }, steps)
    }
}

/// A grid cell: three whole numbers, or three coordinates.
type GridCell = [f64; 3];

fn compare_cells(a: &GridCell, b: &GridCell) -> Ordering {
    a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2]))
}

/// A map from rim nodes to their partners.
#[derive(Clone, Copy)]
struct RimPairing {
    /// The sum of the two places, or their difference.
    place_sum_or_difference: usize,
    reversed: bool,
    rim_node_count: usize,
}

impl RimPairing {
    fn partner_of_rim_node(self, k: usize) -> usize {
        let k = k % self.rim_node_count;
        (if self.reversed {
            self.place_sum_or_difference + self.rim_node_count - k
        } else {
            k + self.place_sum_or_difference
        }) % self.rim_node_count
    }
}

/// Runs of consecutive numbers modulo n, as first number and count.
fn runs_modulo(line: &[(usize, usize)], n: usize) -> impl Iterator<Item = (usize, usize)> {
    let wraps = line.len() < n && line[0].1 == 0 && line[line.len() - 1].1 == n - 1;
    let runs = move || line.chunk_by(|a, b| a.1 + 1 == b.1).map(|run| (run[0].1, run.len()));
    let head = if wraps { runs().next().map_or(0, |run| run.1) } else { 0 };
    let count = runs().count();
    let joined = move |(at, (start, len)): (usize, (usize, usize))| match at {
        0 if wraps => None,
        at if wraps && at + 1 == count => Some((start, len + head)),
        _ => Some((start, len)),
    };
    runs().enumerate().filter_map(joined)
}
