//! The quotient complex of a net by brute force from its definition, for comparison with the
//! library.

#![allow(dead_code, unreachable_pub)]

use gusset::net::complex::Complex;
use gusset::net::{Shape, Topology};
use std::collections::{BTreeMap, BTreeSet};

/// Classes by repeated relaxation over pairs of nodes that are one.
pub fn classes(nodes: usize, pairs: &[[usize; 2]]) -> Vec<usize> {
    let mut class: Vec<usize> = (0..nodes).collect();
    loop {
        let mut changed = false;
        for &[a, b] in pairs {
            let least = class[a].min(class[b]);
            changed |= class[a] != least || class[b] != least;
            (class[a], class[b]) = (least, least);
        }
        if !changed {
            return class;
        }
    }
}

/// The pairs that a topology names.
pub fn pairs(topology: &Topology) -> Vec<[usize; 2]> {
    let shape = topology.shape();
    let (h, w) = (shape.rows(), shape.columns());
    let mut pairs = Vec::new();
    for i in 0..h {
        for j in 0..w {
            let node = i * w + j;
            if topology.is_contracted(2 * node as u32) {
                pairs.push([node, i * w + (j + 1) % w]);
            }
            if topology.is_contracted(2 * node as u32 + 1) {
                pairs.push([node, (i + 1) % h * w + j]);
            }
        }
    }
    for seam in topology.seams() {
        pairs.extend(seam.pairs(shape).map(|pair| pair.map(|node| node as usize)));
    }
    pairs
}

/// The rest of a cell: its corners in turn, without repetitions of the corner before.
pub fn reduced(corners: [usize; 4]) -> Vec<usize> {
    let mut left = corners.to_vec();
    left.dedup();
    while left.len() > 1 && left.first() == left.last() {
        left.pop();
    }
    left
}

pub struct Oracle {
    pub class: Vec<usize>,
    pub vertices: usize,
    pub faces: Vec<Vec<usize>>,
    /// For each edge the faces that have it, and whether they run along it upwards.
    pub edges: BTreeMap<[usize; 2], Vec<(usize, bool)>>,
    /// Quads, triangles, digons, points, folds.
    pub kinds: [u64; 5],
    pub crossing: Option<usize>,
    pub components: usize,
    pub pinches: Vec<usize>,
}

impl Oracle {
    pub fn new(shape: Shape, pairs: &[[usize; 2]], present: impl Fn(usize, usize) -> bool) -> Oracle {
        let (h, w) = (shape.rows(), shape.columns());
        let class = classes(h * w, pairs);
        let mut oracle = Oracle {
            vertices: 0,
            faces: Vec::new(),
            edges: BTreeMap::new(),
            kinds: [0; 5],
            crossing: None,
            components: 0,
            pinches: Vec::new(),
            class,
        };
        let mut vertices = BTreeSet::new();
        for (i, j) in (0..h - 1).flat_map(|i| (0..w - 1).map(move |j| (i, j))).filter(|&(i, j)| present(i, j)) {
            let a = i * w + j;
            let corners = [a, a + 1, a + w + 1, a + w].map(|node| oracle.class[node]);
            vertices.extend(corners);
            for k in 0..4 {
                let ends = [corners[k], corners[(k + 1) % 4]];
                if ends[0] != ends[1] {
                    oracle.edges.entry([ends[0].min(ends[1]), ends[0].max(ends[1])]).or_default();
                }
            }
            let left = reduced(corners);
            let distinct = left.iter().collect::<BTreeSet<_>>().len();
            let kind = match (left.len(), distinct) {
                (4, 4) => 0,
                (3, 3) => 1,
                (2, 2) => 2,
                (1, 1) => 3,
                (4, 3) => 4,
                (4, 2) => {
                    oracle.crossing.get_or_insert(i * (w - 1) + j);
                    continue;
                }
                odd => panic!("{odd:?}"),
            };
            oracle.kinds[kind] += 1;
            if kind < 2 {
                for k in 0..left.len() {
                    let (from, to) = (left[k], left[(k + 1) % left.len()]);
                    let uses = oracle.edges.entry([from.min(to), from.max(to)]).or_default();
                    uses.push((oracle.faces.len(), from < to));
                }
                oracle.faces.push(left);
            }
        }
        oracle.vertices = vertices.len();
        oracle.components = components(&vertices, oracle.edges.keys());
        oracle.pinches = vertices.iter().copied().filter(|&v| oracle.fans(v) > 1).collect();
        oracle
    }

    /// Into how many pieces the faces at a vertex fall if they hang together only by edges at it.
    fn fans(&self, vertex: usize) -> usize {
        let faces: BTreeSet<usize> = (0..self.faces.len()).filter(|&f| self.faces[f].contains(&vertex)).collect();
        let joined: Vec<[usize; 2]> = (self.edges.iter().filter(|(edge, _)| edge.contains(&vertex)))
            .flat_map(|(_, uses)| uses.windows(2).map(|pair| [pair[0].0, pair[1].0]))
            .collect();
        components(&faces, joined.iter())
    }

    pub fn chi(&self) -> i64 {
        self.vertices as i64 - self.edges.len() as i64 + self.faces.len() as i64
    }

    fn edges_of(&self, wanted: impl Fn(&[(usize, bool)]) -> bool) -> Vec<[u32; 2]> {
        self.edges.iter().filter(|(_, uses)| wanted(uses)).map(|(edge, _)| edge.map(|v| v as u32)).collect()
    }

    /// Whether some way to turn the faces leaves no conflict, by trying all.
    fn orientable(&self) -> bool {
        let pairs: Vec<_> = self.edges.values().filter(|uses| uses.len() == 2).collect();
        (0u64..1 << self.faces.len()).any(|turned| {
            let up = |(face, up): (usize, bool)| up ^ (turned >> face & 1 == 1);
            pairs.iter().all(|uses| up(uses[0]) != up(uses[1]))
        })
    }

    /// All that the library says must be so.
    pub fn check(&self, complex: &Complex) {
        assert_eq!(complex.vertices, self.vertices as u64);
        assert_eq!(complex.edges, self.edges.len() as u64);
        let kinds = [complex.quads, complex.triangles, complex.digons, complex.points, complex.folds];
        assert_eq!(kinds, self.kinds);
        assert_eq!(complex.euler_characteristic(), self.chi());
        assert_eq!(complex.components, self.components as u64);
        assert_eq!(complex.wires, self.edges_of(<[_]>::is_empty));
        assert_eq!(complex.branches, self.edges_of(|uses| uses.len() > 2));
        assert_eq!(complex.conflicts, self.edges_of(|uses| uses.len() == 2 && uses[0].1 == uses[1].1));
        assert_eq!(complex.pinches, self.pinches.iter().map(|&v| v as u32).collect::<Vec<_>>());
        if self.faces.len() <= 12 {
            assert_eq!(complex.orientable, self.orientable());
        }
        self.check_boundary(complex);
    }

    fn check_boundary(&self, complex: &Complex) {
        let expected = self.edges_of(|uses| uses.len() == 1);
        assert_eq!(complex.boundary_edges, expected.len() as u64);
        let mut found = Vec::new();
        let mut forward = true;
        for k in 0..complex.boundary.len() {
            let chain = complex.boundary.get(k);
            for e in 0..complex.boundary.edge_count(k) {
                let (from, to) = (chain[e], chain[(e + 1) % chain.len()]);
                let edge = [from.min(to), from.max(to)];
                forward &= self.edges[&edge.map(|v| v as usize)][0].1 == (from < to);
                found.push(edge);
            }
            assert!(complex.boundary.open_chain_flags()[k] == 0 || !complex.branches.is_empty());
        }
        found.sort_unstable();
        assert_eq!(found, expected, "every edge of one face is in one chain, once");
        assert!(forward || !complex.conflicts.is_empty() || !complex.branches.is_empty(), "faces on the left");
    }
}

/// How many pieces the edges join the vertices to.
fn components<'a>(vertices: &BTreeSet<usize>, edges: impl Iterator<Item = &'a [usize; 2]>) -> usize {
    let at: BTreeMap<usize, usize> = vertices.iter().enumerate().map(|(k, &v)| (v, k)).collect();
    let pairs: Vec<_> = edges.map(|edge| edge.map(|v| at[&v])).collect();
    classes(vertices.len(), &pairs).iter().collect::<BTreeSet<_>>().len()
}

/// Numbers that look random: xorshift.
pub struct Dice(pub u64);

impl Dice {
    pub fn below(&mut self, n: u64) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) % n
    }
}

/// How many edges meet at each vertex: links between different classes, those with the same ends
/// once.
pub fn degrees(topology: &Topology) -> BTreeMap<u32, usize> {
    let shape = topology.shape();
    let class = gusset::net::NodeClasses::new(topology).unwrap().representatives().unwrap();
    let links = (0..2 * shape.node_count() as u32).filter(|&link| shape.joins_neighbours(link));
    let edges: std::collections::HashSet<[u32; 2]> = links
        .map(|link| shape.ends_of_link(link).map(|node| class[node as usize]))
        .filter(|[a, b]| a != b)
        .map(|[a, b]| [a.min(b), a.max(b)])
        .collect();
    let mut degrees = BTreeMap::new();
    for vertex in edges.into_iter().flatten() {
        *degrees.entry(vertex).or_insert(0) += 1;
    }
    degrees
}

/// Gauss and Bonnet for quads and triangles on a closed surface: the sum of 4 - degree is 4 chi
/// less the triangles.
pub fn check_gauss_bonnet(topology: &Topology, complex: &Complex) {
    let sum: i64 = degrees(topology).values().map(|&degree| 4 - degree as i64).sum();
    assert_eq!(sum, 4 * complex.euler_characteristic() - complex.triangles as i64);
}

/// Twice the area and six times the volume of the rest of the cells, cut into triangles;
/// `place` of a node.
pub fn area_and_volume(shape: Shape, place: impl Fn(usize, usize) -> glam::DVec3) -> (f64, f64) {
    let (mut area, mut volume) = (0.0, 0.0);
    for i in 0..shape.rows() - 1 {
        for j in 0..shape.columns() - 1 {
            let [a, b, c, d] = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)].map(|(i, j)| place(i, j));
            for [p, q, r] in [[a, b, c], [a, c, d]] {
                area += (q - p).cross(r - p).length();
                volume += p.dot(q.cross(r));
            }
        }
    }
    (area, volume)
}
