//! Fast boundary loops, for meshes with a regular boundary.
//!
//! Let N(u, v) be the number of half-edges from u to v minus the number from v to u. N is 0 at an
//! inner edge of an oriented surface, and 1 or -1 at a border edge. Give each vertex v a hash f(v),
//! injective and far from linear, and compute two sums:
//!
//! * For each vertex, s(v) = sum of N(v, u) f(u). Every corner with consecutive vertices p, v, n
//!   adds f(n) - f(p).
//! * Over all faces, the area inside the faces if vertex v were the point (v, v^2), in 64 bits. By
//!   the shoelace formula it is the sum of N(u, v) g(u, v) over all edges, where g(x, y) = x y (y -
//!   x). A triangle has (y - x)(z - x)(z - y).
//!
//! At an inner vertex s is 0. At a boundary vertex with one incoming border edge, from u, and one
//! outgoing, to w, it is f(w) - f(u). This is not 0, because f is injective. A first pass over the
//! corners computes the sums. A second pass gathers the half-edges between vertices with s != 0.
//! These are few more than the border itself, and are matched, checked and walked.
//!
//! **Irregular boundaries are detected**: for example a half-edge that occurs twice in one
//! direction, an edge with equal ends, or a vertex with several border edges. The result is then
//! `None`, and the caller uses the exact walk. The border B that was found must also explain both
//! sums: it must pass each vertex with s != 0 once, with s = f(w)
//! - f(u), and the area must be the area inside its loops.
//!
//! **Undetected cases.** Let R = N - B be the part that was not found. At every vertex v the sum of
//! R(v, u) f(u) is 0 in 32 bits, and R has the same number of incoming and outgoing edges. With one
//! of each, they would cancel in R. So R passes each of its vertices at least twice, with a
//! coincidence of hashes at each one, and a further coincidence of areas in 64 bits. In addition, N
//! does not detect an edge with two or more faces in each direction, in equal numbers.
//! Irregularities away from the boundary are not detected either.

use super::border_walker::DirectedHalfEdge;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::par;
use gusset_base::sort::sort;
use gusset_base::threads::lock;
use gusset_mesh::{FaceVisitor, MeshView, NONE};
use std::sync::{Mutex, PoisonError};

/// Number of faces that one thread visits at a time.
const FACES_PER_TASK: usize = 1 << 14;
/// Largest number of threads, because each sums into an array of its own.
const MAX_SUMMING_THREADS: usize = 8;

/// A half-edge between two vertices with s != 0.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct CandidateHalfEdge {
    /// The smaller end, and the larger end.
    sorted_ends: [u32; 2],
    /// True if the half-edge runs from the smaller to the larger end.
    is_ascending: bool,
    half_edge: u32,
}

const STAGE: &str = "walking along the boundary";

/// Number of border half-edges between two progress reports.
const HALF_EDGES_PER_REPORT: usize = 1 << 15;

/// Returns the closed walks of border half-edges, each from its smallest half-edge, ordered by
/// these. Returns `None` if the boundary is irregular. Two passes over the corners; extra memory: 4
/// bytes per vertex for each of at most 8 threads, and the border.
pub(super) fn find_regular_walks(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Option<Vec<Vec<DirectedHalfEdge>>>> {
    job.step(0.0, "looking for the boundary")?;
    // Determined once, because the query takes time.
    let threads = par::resolve_thread_count(
        mesh.faces().len().div_ceil(FACES_PER_TASK).min(MAX_SUMMING_THREADS),
        job.requested_threads(),
    );
    let sums = BorderDetectionSums::sum_over_mesh(mesh, threads)?;
    job.step(0.6, "looking for the boundary")?;
    let parts = par::map(threads, par::split_into_ranges(mesh.faces().len(), FACES_PER_TASK), |range| {
        let mut gather = CandidateCollector { sums: &sums, candidates: Vec::new() };
        mesh.faces().visit_faces(range, &mut gather)?;
        Ok(gather.candidates)
    })?;
    let mut candidates = Vec::new();
    alloc::append_all(&mut candidates, parts)?;
    let job = job.sub_job(0.9, 1.0);
    job.step(0.0, STAGE)?;
    let Some(border) = border_half_edges(candidates)? else {
        return Ok(None);
    };
    job.step(0.2, STAGE)?;
    match next_border_edges(&border)? {
        Some(next) if sums.are_explained_by_border(&border, &next) => {
            closed_walks(mesh, &border, next, &job.sub_job(0.4, 1.0)).map(Some)
        }
        _ => Ok(None),
    }
}

/// The hash f, injective because both steps are. The first step maps u and v to numbers that differ
/// by (u - v) (2 (u + v) + c), where the second factor is odd. The square and the shift break
/// linearity: otherwise sums of f would agree where sums of indices agree, and the area could be 0
/// there too.
fn vertex_hash(v: u32) -> u32 {
    let x = v.wrapping_mul(v.wrapping_mul(2).wrapping_add(0x9e37_79b1));
    x ^ (x >> 15)
}

/// The term g: the shoelace term of the edge from (x, x^2) to (y, y^2).
fn shoelace_term(x: u32, y: u32) -> u64 {
    (u64::from(x) * u64::from(y)).wrapping_mul(wrapping_difference_u64(y, x))
}

/// Returns x - y in 64 bits.
fn wrapping_difference_u64(x: u32, y: u32) -> u64 {
    u64::from(x).wrapping_sub(u64::from(y))
}

/// Both sums over some or all faces.
struct BorderDetectionSums {
    vertex_sums: Vec<u32>,
    shoelace_sum: u64,
}

impl FaceVisitor for BorderDetectionSums {
    #[inline(always)]
    fn visit_face(&mut self, _: u32, corners: &[u32]) -> Result<()> {
        let (count, first) = (corners.len(), corners[0]);
        let mut before = vertex_hash(corners[count - 1]);
        for (i, &here) in corners.iter().enumerate() {
            let after = corners[if i + 1 < count { i + 1 } else { 0 }];
            let sum = &mut self.vertex_sums[here as usize];
            *sum = sum.wrapping_add(vertex_hash(after).wrapping_sub(before));
            // The face as a fan of triangles (first, here, after). The first and the last of them
            // are degenerate.
            let area = wrapping_difference_u64(here, first)
                .wrapping_mul(wrapping_difference_u64(after, first))
                .wrapping_mul(wrapping_difference_u64(after, here));
            self.shoelace_sum = self.shoelace_sum.wrapping_add(area);
            before = vertex_hash(here);
        }
        Ok(())
    }
}

impl BorderDetectionSums {
    /// Sums over the whole mesh. Each thread sums into an array of its own. All additions wrap, so
    /// that their order does not matter.
    fn sum_over_mesh(mesh: &MeshView<'_>, threads: usize) -> Result<Self> {
        let idle: Mutex<Vec<BorderDetectionSums>> = Mutex::new(Vec::new());
        let pool = || lock(&idle);
        let added = par::map(threads, par::split_into_ranges(mesh.faces().len(), FACES_PER_TASK), |range| {
            let free = pool().pop();
            let mut partial = match free {
                Some(partial) => partial,
                None => BorderDetectionSums { vertex_sums: alloc::zeroed(mesh.positions().len())?, shoelace_sum: 0 },
            };
            mesh.faces().visit_faces(range, &mut partial)?;
            alloc::push(&mut pool(), partial)
        })?;
        added.into_iter().collect::<Result<()>>()?;
        let mut partials = idle.into_inner().unwrap_or_else(PoisonError::into_inner).into_iter();
        let mut sums = partials.next().unwrap_or(BorderDetectionSums { vertex_sums: Vec::new(), shoelace_sum: 0 });
        for partial in partials {
            sums.shoelace_sum = sums.shoelace_sum.wrapping_add(partial.shoelace_sum);
            let both = sums.vertex_sums.iter_mut().zip(partial.vertex_sums);
            both.for_each(|(sum, part)| *sum = sum.wrapping_add(part));
        }
        Ok(sums)
    }

    /// Returns true if s(v) is not 0.
    fn has_nonzero_sum(&self, v: u32) -> bool {
        self.vertex_sums[v as usize] != 0
    }

    /// Returns true if both sums match the border, in which edge `next[i]` follows edge i.
    fn are_explained_by_border(&self, border: &[(u32, u32, u32)], next: &[usize]) -> bool {
        let fits = |(&(u, v, _), &i): (&(u32, u32, u32), &usize)| {
            self.vertex_sums[v as usize] == vertex_hash(border[i].1).wrapping_sub(vertex_hash(u))
        };
        let area = border.iter().fold(0u64, |area, &(u, v, _)| area.wrapping_add(shoelace_term(u, v)));
        let flagged = self.vertex_sums.iter().filter(|&&sum| sum != 0).count();
        border.len() == flagged && border.iter().zip(next).all(fits) && area == self.shoelace_sum
    }
}

/// Gathers half-edges between vertices with s != 0.
struct CandidateCollector<'a> {
    sums: &'a BorderDetectionSums,
    candidates: Vec<CandidateHalfEdge>,
}

impl FaceVisitor for CandidateCollector<'_> {
    #[inline(always)]
    fn visit_face(&mut self, first: u32, corners: &[u32]) -> Result<()> {
        // Most faces lack flagged corners.
        if corners.iter().fold(false, |any, &v| any | self.sums.has_nonzero_sum(v)) {
            self.collect_candidates(first, corners)
        } else {
            Ok(())
        }
    }
}

impl CandidateCollector<'_> {
    fn collect_candidates(&mut self, first: u32, corners: &[u32]) -> Result<()> {
        let after = corners.iter().cycle().skip(1);
        for ((&u, &v), half_edge) in corners.iter().zip(after).zip(first..) {
            if self.sums.has_nonzero_sum(u) && self.sums.has_nonzero_sum(v) {
                alloc::push(
                    &mut self.candidates,
                    CandidateHalfEdge { sorted_ends: [u.min(v), u.max(v)], is_ascending: u <= v, half_edge },
                )?;
            }
        }
        Ok(())
    }
}

/// Returns the candidates without an opposite half-edge, as (start, end, half-edge) ordered by
/// start; `None` if an edge is irregular.
fn border_half_edges(mut candidates: Vec<CandidateHalfEdge>) -> Result<Option<Vec<(u32, u32, u32)>>> {
    candidates.sort_unstable();
    let mut border = alloc::with_capacity(candidates.len())?;
    for edge in candidates.chunk_by(|x, y| x.sorted_ends == y.sorted_ends) {
        match edge {
            &[CandidateHalfEdge { sorted_ends: [u, v], is_ascending: up, half_edge }] if u != v => {
                border.push(if up { (u, v, half_edge) } else { (v, u, half_edge) });
            }
            [x, y] if x.is_ascending != y.is_ascending => {}
            _ => return Ok(None),
        }
    }
    border.sort_unstable();
    Ok(Some(border))
}

/// Returns the next border edge of each; `None` if a vertex does not have exactly one incoming and
/// one outgoing edge.
fn next_border_edges(border: &[(u32, u32, u32)]) -> Result<Option<Vec<usize>>> {
    if border.windows(2).any(|pair| pair[0].0 == pair[1].0) {
        return Ok(None);
    }
    // Starts are distinct. If every end is a start, and the end of one edge only, `next` is a
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

fn closed_walks(
    mesh: &MeshView<'_>,
    border: &[(u32, u32, u32)],
    mut next: Vec<usize>,
    job: &Job<'_>,
) -> Result<Vec<Vec<DirectedHalfEdge>>> {
    job.step(0.0, STAGE)?;
    let mut order = alloc::collect((0..border.len()).map(|i| (border[i].2, i)))?;
    sort(&mut order, Ord::cmp, &job.sub_job(0.0, 0.5), STAGE)?;
    let job = job.sub_job(0.5, 1.0);
    let mut walks: Vec<Vec<DirectedHalfEdge>> = Vec::new();
    for (k, (_, first)) in order.into_iter().enumerate() {
        job.step_every(HALF_EDGES_PER_REPORT, k, border.len(), STAGE)?;
        let mut walk = Vec::new();
        let mut i = first;
        while next[i] != NONE as usize {
            alloc::push(&mut walk, DirectedHalfEdge { half_edge: border[i].2, forward: true })?;
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

    /// Checks the boundary loops of a mesh against the given lengths. Face i has the corners
    /// `faces[i]`.
    fn check_loop_lengths(vertices: u32, faces: &[&[u32]], regular: bool, lengths: &[usize]) {
        let points: Vec<[f64; 3]> = (0..vertices).map(|i| [f64::from(i), 0.5 * f64::from(i % 7), 0.0]).collect();
        let corners = faces.concat();
        let offsets: Vec<u32> = (0..=faces.len()).map(|f| faces[..f].concat().len() as u32).collect();
        let faces = Faces::polygons(&offsets, &corners).unwrap();
        let job = Job::default();
        let mesh = MeshView::new(Positions::from(points.as_slice()), faces, &job).unwrap();
        assert_eq!(find_regular_walks(&mesh, &job).unwrap().is_some(), regular);
        for survey in [Survey::WholeMesh, Survey::BoundaryOnly] {
            let found = boundary_loops(&mesh, &Options { survey, ..Options::default() }, &job).unwrap();
            assert_eq!(found.iter().map(|l| l.vertices.len()).collect::<Vec<_>>(), lengths);
        }
    }

    #[test]
    fn regular_boundaries_are_found_without_the_exact_walk() {
        check_loop_lengths(3, &[&[0, 1, 2]], true, &[3]);
        // A triangle, a square, a pentagon and a hexagon around vertex 0; and a tetrahedron.
        let round: [&[u32]; 4] = [&[0, 1, 2], &[0, 2, 3, 4], &[0, 4, 5, 6, 7], &[0, 7, 8, 9, 10, 1]];
        check_loop_lengths(11, &round, true, &[10]);
        check_loop_lengths(4, &[&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]], true, &[]);
        check_loop_lengths(8, &[&[0, 1, 2], &[3, 4, 5, 6, 7]], true, &[3, 5]);
        check_loop_lengths(5, &[&[0, 1, 2], &[2, 3, 4]], false, &[3, 3]);
    }

    /// Every second face of an octahedron: at each vertex, two neighbours precede it and the two
    /// opposite ones follow it. Three pairs of numbers with equal sums of f make all vertex sums
    /// vanish. The area does not vanish.
    #[test]
    fn a_planted_coincidence_is_noticed() {
        // The first pairs with this property among the numbers from 8 to 4000.
        let limit = 4000;
        let [[a, b], [c, d], [p, q]] = [[197, 1910], [2463, 3503], [2519, 3070]];
        let octahedron: [&[u32]; 4] = [&[a, c, p], &[a, d, q], &[b, c, q], &[b, d, p]];
        let mut total = HashMap::new();
        for (face, i) in octahedron.iter().flat_map(|face| (0..3).map(move |i| (face, i))) {
            let (before, v, after) = (face[(i + 2) % 3], face[i], face[(i + 1) % 3]);
            let sum: &mut u32 = total.entry(v).or_default();
            *sum = sum.wrapping_add(vertex_hash(after)).wrapping_sub(vertex_hash(before));
        }
        assert!(total.len() == 6 && total.values().all(|&sum| sum == 0), "the coincidence");
        check_loop_lengths(limit, &octahedron, false, &[3, 3, 3, 3]);
        // Next to a regular loop, and next to a loop that touches the octahedron.
        let [x, y, z, w] = octahedron;
        check_loop_lengths(limit, &[x, y, z, w, &[0, 1, 2]], false, &[3, 3, 3, 3, 3]);
        check_loop_lengths(limit, &[x, y, z, w, &[0, 1, a]], false, &[3, 3, 3, 3, 3]);
    }
}
