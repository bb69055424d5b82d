//! Meshes cut into pieces whose borders lie on one another, but have vertices of their own.
#![allow(unreachable_pub, reason = "modules of one program")]

use crate::common::Soup;
use std::collections::{BTreeMap, HashMap};

/// Each face of a soup as triangles round its first corner.
pub fn triangulated(soup: &Soup) -> Soup {
    let mut other = Soup { points: soup.points.clone(), offsets: vec![0], corners: Vec::new() };
    for face in soup.faces() {
        (1..face.len() - 1).for_each(|k| other.face(&[face[0], face[k], face[k + 1]]));
    }
    other
}

/// The faces in pieces with vertices of their own, and further vertices on the borders of each
/// piece: `more(piece, edge)` places between 0 and 1, ascending, counted from the edge's smaller
/// vertex. Faces gain corners; triangles are cut to fans.
pub fn cut(
    whole: &Soup,
    piece: impl Fn(usize) -> usize,
    more: impl Fn(usize, (u32, u32)) -> Vec<f64>,
    fans: bool,
) -> Soup {
    let mut faces_at: BTreeMap<(u32, u32), Vec<usize>> = BTreeMap::new();
    let sides = |face: &[u32]| (0..face.len()).map(|k| (face[k], face[(k + 1) % face.len()])).collect::<Vec<_>>();
    for (f, face) in whole.faces().enumerate() {
        for (u, v) in sides(face) {
            faces_at.entry((u.min(v), u.max(v))).or_default().push(f);
        }
    }
    let mut soup = Soup { offsets: vec![0], ..Soup::default() };
    let mut names = HashMap::new();
    let mut name = |soup: &mut Soup, key: (usize, u32, u32, usize), point: [f64; 3]| {
        *names.entry(key).or_insert_with(|| {
            soup.points.push(point);
            soup.points.len() as u32 - 1
        })
    };
    for (f, face) in whole.faces().enumerate() {
        let mut ring = Vec::new();
        for (u, v) in sides(face) {
            let edge = (u.min(v), u.max(v));
            ring.push(name(&mut soup, (piece(f), u, u, 0), whole.points[u as usize]));
            if faces_at[&edge].iter().all(|&g| piece(g) == piece(f)) {
                continue;
            }
            let [p, q] = [edge.0, edge.1].map(|v| whole.points[v as usize]);
            let mut inner: Vec<u32> = more(piece(f), edge)
                .iter()
                .enumerate()
                .map(|(k, t)| {
                    name(
                        &mut soup,
                        (piece(f), edge.0, edge.1, k),
                        [0, 1, 2].map(|axis| p[axis] + t * (q[axis] - p[axis])),
                    )
                })
                .collect();
            if u > v {
                inner.reverse();
            }
            ring.extend(inner);
        }
        if fans && ring.len() > 3 {
            let centre = [0, 1, 2]
                .map(|axis| face.iter().map(|&v| whole.points[v as usize][axis]).sum::<f64>() / face.len() as f64);
            soup.points.push(centre);
            let c = soup.points.len() as u32 - 1;
            (0..ring.len()).for_each(|k| soup.face(&[ring[k], ring[(k + 1) % ring.len()], c]));
        } else {
            soup.face(&ring);
        }
    }
    soup
}

/// Numbers that follow from a seed, a piece and an edge: `from` to `to` places, apart from each
/// other and from the ends.
pub fn places(seed: u64, piece: usize, (u, v): (u32, u32), from: usize, to: usize) -> Vec<f64> {
    let mut state = seed ^ (piece as u64) << 40 ^ u64::from(u) << 20 ^ u64::from(v);
    let mut next = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    };
    let count = from + (next() * (to - from + 1) as f64) as usize;
    (0..count).map(|k| (k as f64 + 0.2 + 0.6 * next()) / count as f64).collect()
}
