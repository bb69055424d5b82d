//! Boundary loops at the speed of memory, for meshes that are ordinary along their boundary.
//!
//! For every corner of every face, with the vertices p, v, n one after another, add f(n) - f(p) to a sum kept for v. Round an
//! inner vertex of an oriented surface each neighbour is once the next and once the previous one, and the sum is 0. At a
//! boundary vertex with one border edge in, from u, and one out, to w, everything cancels but f(w) - f(u), which is not 0 as
//! f is one-to-one. So one pass over the corners and a second one that gathers the half-edges between vertices whose sums
//! are not 0 leave little more than the border itself, to be matched, checked and walked.
//!
//! Whatever is odd shows: a half-edge twice in one direction, an edge without length, a vertex with other than one border edge
//! in and one out. Then there is no answer here, and the exact way through all edges is taken. What cannot show: an edge
//! with as many faces one way as the other, two or more each, and places away from the boundary. And a loop all of whose
//! vertices are passed by other loops too, and whose sums of 64-bit hashes all vanish by coincidence.

use super::walk::Dart;
use crate::alloc;
use crate::error::Result;
use crate::job::Job;
use crate::mesh::{MeshView, NONE};
use crate::par;
use std::ops::Range;

/// Faces that one thread scans at a time.
const CHUNK: usize = 1 << 15;

/// A half-edge between two vertices whose sums are not 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Candidate {
    /// The smaller end, the larger end.
    ends: [u32; 2],
    /// Runs from the smaller to the larger.
    up: bool,
    half_edge: u32,
}

/// The closed walks of border half-edges, each from its smallest half-edge on, in the order of those; or `None` if something
/// along the boundary is odd. Two passes over the corners; extra memory 8 bytes a vertex, and the border.
pub(super) fn ordinary_walks(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Option<Vec<Vec<Dart>>>> {
    job.step(0.0, "looking for the boundary")?;
    let sums = sums(mesh)?;
    job.step(0.6, "looking for the boundary")?;
    let flags = Flags::of(&sums)?;
    drop(sums);
    let parts = par::chunks(job.threads(), mesh.faces().len(), CHUNK, |range| gather(mesh, &flags, range));
    let mut candidates = Vec::new();
    for part in parts {
        let part = part?;
        alloc::reserve(&mut candidates, part.len())?;
        candidates.extend(part);
    }
    job.step(0.9, "walking along the boundary")?;
    match border(candidates)? {
        Some(border) => walks(mesh, &border),
        None => Ok(None),
    }
}

/// f: one-to-one from the indices into 64 bits, and far from linear.
fn f(v: u32) -> u64 {
    let x = u64::from(v).wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    (x ^ (x >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9)
}

/// The sum of f(n) - f(p) over the corners of each vertex.
fn sums(mesh: &MeshView<'_>) -> Result<Vec<u64>> {
    let mut sums = alloc::filled(0u64, mesh.positions().len())?;
    let mut add = |p: u64, v: u32, n: u64| {
        let sum = &mut sums[v as usize];
        *sum = sum.wrapping_add(n).wrapping_sub(p);
    };
    for face in 0..mesh.faces().len() {
        let mut corners = mesh.face(face);
        if let (3, Some(a), Some(b), Some(c)) = (corners.len(), corners.next(), corners.next(), corners.next()) {
            let (x, y, z) = (f(a), f(b), f(c));
            add(z, a, y);
            add(x, b, z);
            add(y, c, x);
        } else {
            let corners = mesh.face(face);
            let after = corners.clone().cycle().skip(1);
            let before = corners.clone().cycle().skip(corners.len() - 1);
            for ((v, n), p) in corners.zip(after).zip(before) {
                add(f(p), v, f(n));
            }
        }
    }
    Ok(sums)
}

/// One bit a vertex: its sum is not 0.
struct Flags(Vec<u64>);

impl Flags {
    fn of(sums: &[u64]) -> Result<Self> {
        let word = |chunk: &[u64]| chunk.iter().enumerate().fold(0, |bits, (i, &s)| bits | u64::from(s != 0) << i);
        Ok(Flags(alloc::collect(sums.chunks(64).map(word))?))
    }

    fn has(&self, v: u32) -> bool {
        self.0[v as usize / 64] >> (v % 64) & 1 == 1
    }
}

/// The half-edges of some faces between vertices that are flagged.
fn gather(mesh: &MeshView<'_>, flags: &Flags, faces: Range<usize>) -> Result<Vec<Candidate>> {
    let mut found = Vec::new();
    for face in faces {
        let start = mesh.faces().range(face).start as u32;
        let corners = mesh.face(face);
        // Most faces have no flagged corner at all.
        if !corners.clone().any(|v| flags.has(v)) {
            continue;
        }
        let after = corners.clone().cycle().skip(1);
        for ((u, v), half_edge) in corners.zip(after).zip(start..) {
            if flags.has(u) && flags.has(v) {
                alloc::push(&mut found, Candidate { ends: [u.min(v), u.max(v)], up: u <= v, half_edge })?;
            }
        }
    }
    Ok(found)
}

/// Of the candidates those whose edge has no other half-edge, as (vertex where it starts, where it ends, half-edge), in the
/// order of their starts; `None` if an edge is odd.
fn border(mut candidates: Vec<Candidate>) -> Result<Option<Vec<(u32, u32, u32)>>> {
    candidates.sort_unstable();
    let mut border = alloc::with_capacity(candidates.len())?;
    for edge in candidates.chunk_by(|x, y| x.ends == y.ends) {
        match edge {
            &[Candidate { ends: [u, v], up, half_edge }] if u != v => {
                border.push(if up { (u, v, half_edge) } else { (v, u, half_edge) });
            }
            [x, y] if x.up != y.up => {}
            _ => return Ok(None),
        }
    }
    border.sort_unstable();
    Ok(Some(border))
}

/// Follows the border; `None` if a vertex has other than one edge in and one out.
fn walks(mesh: &MeshView<'_>, border: &[(u32, u32, u32)]) -> Result<Option<Vec<Vec<Dart>>>> {
    if border.windows(2).any(|pair| pair[0].0 == pair[1].0) {
        return Ok(None);
    }
    // Starts are distinct; every end being a start, each the end of one edge only, it is a permutation.
    let mut next = alloc::with_capacity(border.len())?;
    let mut reached = alloc::filled(false, border.len())?;
    for &(_, end, _) in border {
        match border.binary_search_by_key(&end, |&(start, _, _)| start) {
            Ok(i) if !reached[i] => {
                reached[i] = true;
                next.push(i);
            }
            _ => return Ok(None),
        }
    }
    let mut order = alloc::collect((0..border.len()).map(|i| (border[i].2, i)))?;
    order.sort_unstable();
    let mut walks: Vec<Vec<Dart>> = Vec::new();
    for (_, first) in order {
        let mut walk = Vec::new();
        let mut i = first;
        while next[i] != NONE as usize {
            alloc::push(&mut walk, Dart { half_edge: border[i].2, forward: true })?;
            i = std::mem::replace(&mut next[i], NONE as usize);
        }
        if !walk.is_empty() {
            debug_assert_eq!(walk[0].tail(mesh), border[first].0);
            alloc::push(&mut walks, walk)?;
        }
    }
    Ok(Some(walks))
}
