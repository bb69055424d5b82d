//! Boundary loops at the speed of memory, for meshes that are ordinary along their boundary.
//!
//! Let N(u, v) be the number of half-edges from u to v less the number of those from v to u: 0 at
//! an inner edge of an oriented surface, 1 or -1 at a border edge. Give each vertex v a number
//! f(v), one-to-one and far from linear, and keep two sums:
//!
//! * for each vertex, s(v) = sum of N(v, u) f(u): every corner with the vertices p, v, n one after
//!   another adds f(n) - f(p);
//! * in all, the area inside the faces if vertex v were the point (v, v^2), in 64 bits: by the
//!   shoelace formula it is the sum of N(u, v) g(u, v) over all edges, where g(x, y) = x y (y - x).
//!   A triangle has (y - x)(z - x)(z - y).
//!
//! At an inner vertex s is 0. At a boundary vertex with one border edge in, from u, and one out, to
//! w, it is f(w) - f(u), which is not 0 as f is one-to-one. So one pass over the corners and a
//! second one that gathers the half-edges between the vertices where s is not 0 leave little more
//! than the border itself, to be matched, checked and walked.
//!
//! **What is odd shows.** A half-edge twice in one direction, an edge without length, a vertex with
//! other than one border edge in and one out: then there is no answer here, and the exact way
//! through all edges is taken. So it is unless the border B that was found explains both sums: it
//! must pass each vertex whose s is not 0, once, with s = f(w) - f(u), and the area must be that
//! inside its loops.
//!
//! **What can hide.** Let R = N - B be what was not found. Then at every vertex v the sum of R(v,
//! u) f(u) is 0 in 32 bits, while R has as many edges into v as out of it. With one in and one out
//! they would be one edge, back and forth, which is none. So through each of its vertices R passes
//! twice or more, and at each of them hashes cancel by coincidence; and over all of R the areas do
//! so once more, in 64 bits. Also, N does not see an edge with as many faces one way as the other,
//! two or more each; nor does anything here see what is odd away from the boundary.

use super::walk::Dart;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::par;
use gusset_base::sort::sort;
use gusset_base::threads::lock;
use gusset_mesh::{MeshView, NONE, Visitor};
use std::sync::{Mutex, PoisonError};

/// Faces that one thread looks at at a time.
const CHUNK: usize = 1 << 14;
/// The most threads that take part, as each sums in an array of its own.
const MAX_SUMS: usize = 8;

/// A half-edge between two vertices whose sums are not 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Candidate {
    /// The smaller end, the larger end.
    ends: [u32; 2],
    /// Runs from the smaller to the larger.
    up: bool,
    half_edge: u32,
}

const STAGE: &str = "walking along the boundary";

/// Half-edges of the border between two progress reports.
const REPORT_INTERVAL: usize = 1 << 15;

/// The closed walks of border half-edges, each from its smallest half-edge on, in the order of
/// those; or `None` if something along the boundary is odd. Two passes over the corners; extra
/// memory 4 bytes a vertex for each thread, of which at most 8 take part, and the border.
pub(super) fn ordinary_walks(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Option<Vec<Vec<Dart>>>> {
    job.step(0.0, "looking for the boundary")?;
    // Settled once: asking the system takes a while.
    let threads = par::at_most(mesh.faces().len().div_ceil(CHUNK).min(MAX_SUMS), job.threads());
    let sums = Sums::of(mesh, threads)?;
    job.step(0.6, "looking for the boundary")?;
    let parts = par::map(threads, par::ranges(mesh.faces().len(), CHUNK), |range| {
        let mut gather = Gather { sums: &sums, found: Vec::new() };
        mesh.faces().visit(range, &mut gather)?;
        Ok(gather.found)
    })?;
    let mut candidates = Vec::new();
    alloc::append_all(&mut candidates, parts)?;
    let job = job.part(0.9, 1.0);
    job.step(0.0, STAGE)?;
    let Some(border) = border(candidates)? else {
        return Ok(None);
    };
    job.step(0.2, STAGE)?;
    match successors(&border)? {
        Some(next) if sums.are_of(&border, &next) => walks(mesh, &border, next, &job.part(0.4, 1.0)).map(Some),
        _ => Ok(None),
    }
}

/// f: one-to-one, as both steps are. The first one takes u and v to numbers that are
/// (u - v) (2 (u + v) + c) apart, where the second factor is odd. The square and the shift see to
/// it that sums of f do not agree just where sums of indices do: there the area may well be 0, too.
fn f(v: u32) -> u32 {
    let x = v.wrapping_mul(v.wrapping_mul(2).wrapping_add(0x9e37_79b1));
    x ^ (x >> 15)
}

/// g: the shoelace term of the edge from (x, x^2) to (y, y^2).
fn g(x: u32, y: u32) -> u64 {
    (u64::from(x) * u64::from(y)).wrapping_mul(minus(y, x))
}

/// x - y, in 64 bits.
fn minus(x: u32, y: u32) -> u64 {
    u64::from(x).wrapping_sub(u64::from(y))
}

/// Both sums over some faces or all.
struct Sums {
    of_vertex: Vec<u32>,
    area: u64,
}

impl Visitor for Sums {
    #[inline(always)]
    fn face(&mut self, _: u32, corners: &[u32]) -> Result<()> {
        let (count, first) = (corners.len(), corners[0]);
        let mut before = f(corners[count - 1]);
        for (i, &here) in corners.iter().enumerate() {
            let after = corners[if i + 1 < count { i + 1 } else { 0 }];
            let sum = &mut self.of_vertex[here as usize];
            *sum = sum.wrapping_add(f(after).wrapping_sub(before));
            // The face as a fan of triangles: first, here, after; the first and the last of them
            // have no area.
            let area = minus(here, first).wrapping_mul(minus(after, first)).wrapping_mul(minus(after, here));
            self.area = self.area.wrapping_add(area);
            before = f(here);
        }
        Ok(())
    }
}

impl Sums {
    /// Each thread sums in an array of its own. All additions wrap round, so that it does not
    /// matter who adds what.
    fn of(mesh: &MeshView<'_>, threads: usize) -> Result<Self> {
        let idle: Mutex<Vec<Sums>> = Mutex::new(Vec::new());
        let pool = || lock(&idle);
        let added = par::map(threads, par::ranges(mesh.faces().len(), CHUNK), |range| {
            let free = pool().pop();
            let mut partial = match free {
                Some(partial) => partial,
                None => Sums { of_vertex: alloc::zeroed(mesh.positions().len())?, area: 0 },
            };
            mesh.faces().visit(range, &mut partial)?;
            alloc::push(&mut pool(), partial)
        })?;
        added.into_iter().collect::<Result<()>>()?;
        let mut partials = idle.into_inner().unwrap_or_else(PoisonError::into_inner).into_iter();
        let mut sums = partials.next().unwrap_or(Sums { of_vertex: Vec::new(), area: 0 });
        for partial in partials {
            sums.area = sums.area.wrapping_add(partial.area);
            let both = sums.of_vertex.iter_mut().zip(partial.of_vertex);
            both.for_each(|(sum, part)| *sum = sum.wrapping_add(part));
        }
        Ok(sums)
    }

    /// s(v) is not 0.
    fn flags(&self, v: u32) -> bool {
        self.of_vertex[v as usize] != 0
    }

    /// True if both sums are those of the border, where edge `next[i]` follows edge i.
    fn are_of(&self, border: &[(u32, u32, u32)], next: &[usize]) -> bool {
        let fits = |(&(u, v, _), &i): (&(u32, u32, u32), &usize)| {
            self.of_vertex[v as usize] == f(border[i].1).wrapping_sub(f(u))
        };
        let area = border.iter().fold(0u64, |area, &(u, v, _)| area.wrapping_add(g(u, v)));
        let flagged = self.of_vertex.iter().filter(|&&sum| sum != 0).count();
        border.len() == flagged && border.iter().zip(next).all(fits) && area == self.area
    }
}

/// Gathers half-edges between vertices whose sums are not 0.
struct Gather<'a> {
    sums: &'a Sums,
    found: Vec<Candidate>,
}

impl Visitor for Gather<'_> {
    #[inline(always)]
    fn face(&mut self, first: u32, corners: &[u32]) -> Result<()> {
        // Most faces have no such corner at all.
        if corners.iter().fold(false, |any, &v| any | self.sums.flags(v)) { self.take(first, corners) } else { Ok(()) }
    }
}

impl Gather<'_> {
    fn take(&mut self, first: u32, corners: &[u32]) -> Result<()> {
        let after = corners.iter().cycle().skip(1);
        for ((&u, &v), half_edge) in corners.iter().zip(after).zip(first..) {
            if self.sums.flags(u) && self.sums.flags(v) {
                alloc::push(&mut self.found, Candidate { ends: [u.min(v), u.max(v)], up: u <= v, half_edge })?;
            }
        }
        Ok(())
    }
}

/// Of the candidates those whose edge has no other half-edge, as (vertex where it starts, where it
/// ends, half-edge), in the order of their starts; `None` if an edge is odd.
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

/// For each edge of the border the one that follows it; `None` if a vertex has other than one in
/// and one out.
fn successors(border: &[(u32, u32, u32)]) -> Result<Option<Vec<usize>>> {
    if border.windows(2).any(|pair| pair[0].0 == pair[1].0) {
        return Ok(None);
    }
    // Starts are distinct; every end being a start, each the end of one edge only, it is a
    // permutation.
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
    Ok(Some(next))
}

fn walks(
    mesh: &MeshView<'_>,
    border: &[(u32, u32, u32)],
    mut next: Vec<usize>,
    job: &Job<'_>,
) -> Result<Vec<Vec<Dart>>> {
    job.step(0.0, STAGE)?;
    let mut order = alloc::collect((0..border.len()).map(|i| (border[i].2, i)))?;
    sort(&mut order, Ord::cmp, &job.part(0.0, 0.5), STAGE)?;
    let job = job.part(0.5, 1.0);
    let mut walks: Vec<Vec<Dart>> = Vec::new();
    for (k, (_, first)) in order.into_iter().enumerate() {
        job.step_every(REPORT_INTERVAL, k, border.len(), STAGE)?;
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
    Ok(walks)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boundary::{Options, Survey, boundary_loops};
    use gusset_mesh::{Faces, Positions};
    use std::collections::HashMap;

    /// A mesh whose face i has the corners `faces[i]`; the boundary is that of some loops of the
    /// given lengths.
    fn check(vertices: u32, faces: &[&[u32]], ordinary: bool, lengths: &[usize]) {
        let points: Vec<[f64; 3]> = (0..vertices).map(|i| [f64::from(i), 0.5 * f64::from(i % 7), 0.0]).collect();
        let corners = faces.concat();
        let offsets: Vec<u32> = (0..=faces.len()).map(|f| faces[..f].concat().len() as u32).collect();
        let faces = Faces::polygons(&offsets, &corners).unwrap();
        let job = Job::default();
        let mesh = MeshView::new(Positions::from(points.as_slice()), faces, &job).unwrap();
        assert_eq!(ordinary_walks(&mesh, &job).unwrap().is_some(), ordinary);
        for survey in [Survey::WholeMesh, Survey::BoundaryOnly] {
            let found = boundary_loops(&mesh, &Options { survey, ..Options::default() }, &job).unwrap();
            assert_eq!(found.iter().map(|l| l.vertices.len()).collect::<Vec<_>>(), lengths);
        }
    }

    #[test]
    fn ordinary_boundaries_are_found_without_the_exact_way() {
        check(3, &[&[0, 1, 2]], true, &[3]);
        // A triangle, a square, a pentagon and a hexagon round vertex 0; and a tetrahedron.
        let round: [&[u32]; 4] = [&[0, 1, 2], &[0, 2, 3, 4], &[0, 4, 5, 6, 7], &[0, 7, 8, 9, 10, 1]];
        check(11, &round, true, &[10]);
        check(4, &[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]], true, &[]);
        check(8, &[&[0, 1, 2], &[3, 4, 5, 6, 7]], true, &[3, 5]);
        check(5, &[&[0, 1, 2], &[2, 3, 4]], false, &[3, 3]);
    }

    /// Every second face of an octahedron: each vertex has two neighbours before it and the two
    /// opposite ones after it. Three pairs of numbers with the same sum of f make all sums vanish;
    /// the area does not.
    #[test]
    fn a_planted_coincidence_is_noticed() {
        // The first of those among the numbers from 8 to 4000.
        let limit = 4000;
        let [[a, b], [c, d], [p, q]] = [[197, 1910], [2463, 3503], [2519, 3070]];
        let octahedron: [&[u32]; 4] = [&[a, c, p], &[a, d, q], &[b, c, q], &[b, d, p]];
        let mut total = HashMap::new();
        for (face, i) in octahedron.iter().flat_map(|face| (0..3).map(move |i| (face, i))) {
            let (before, v, after) = (face[(i + 2) % 3], face[i], face[(i + 1) % 3]);
            let sum: &mut u32 = total.entry(v).or_default();
            *sum = sum.wrapping_add(f(after)).wrapping_sub(f(before));
        }
        assert!(total.len() == 6 && total.values().all(|&sum| sum == 0), "the coincidence");
        check(limit, &octahedron, false, &[3, 3, 3, 3]);
        // Beside a loop that is ordinary, and one that touches the octahedron.
        let [x, y, z, w] = octahedron;
        check(limit, &[x, y, z, w, &[0, 1, 2]], false, &[3, 3, 3, 3, 3]);
        check(limit, &[x, y, z, w, &[0, 1, a]], false, &[3, 3, 3, 3, 3]);
    }
}
