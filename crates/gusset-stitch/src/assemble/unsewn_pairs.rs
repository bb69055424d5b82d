//! Pairs of whole loops that face each other before borders are sewn.
//!
//! Two rims may coincide along a part, and be apart elsewhere. Sewing merges the common edges, and
//! the rest of both rims becomes one loop, or several. This loop may be far wider than a slit or
//! a lens between unrelated borders. Its two sides are joined if their rims face each other as
//! whole loops: the search on the pieces before sewing decides.

use super::assemble_request::{Extent, MaxGap, Options};
use super::loop_edges::entries_of_vertex;
use super::piece_loops::PieceLoops;
use crate::repair::orient;
use crate::stitch::IndexMap;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{MeshView, NONE, concatenate};

/// Rims that coincide in part may be this many times as far apart as other whole loops: the common
/// points show that they belong together.
const MAX_GAP_TO_DEFAULT_GAP_RATIO: f64 = 2.0;

/// The loops of the pieces before sewing, and the pairs that face each other.
pub(super) struct UnsewnLoopPairs {
    /// Pairs of a vertex of the sewn mesh and a loop through it before sewing, ascending.
    loops_at_vertices: Vec<(u32, u32)>,
    /// The pairs of loops (smaller, larger), ascending.
    pairs: Vec<[u32; 2]>,
}

impl UnsewnLoopPairs {
    /// Returns true if the options join rims that coincide in part at any gap.
    pub(super) fn may_exist(options: &Options<'_>) -> bool {
        options.extent == Extent::LoopsAndParts && options.max_gap == MaxGap::Auto
    }

    /// Finds the pairs of whole loops. `names` has the vertex of the sewn mesh for each vertex of
    /// all pieces, or [`NONE`].
    ///
    /// O(H log d + V log V) for H half-edges and V vertices on loops.
    pub(super) fn find(
        pieces: &[MeshView<'_>],
        options: &Options<'_>,
        names: impl Iterator<Item = u32>,
        job: &Job<'_>,
    ) -> Result<Self> {
        let (mut mesh, places) = concatenate(pieces, &job.sub_job(0.0, 0.1))?;
        if !options.keep_orientation {
            let view = mesh.view(&job.sub_job(0.1, 0.2))?;
            mesh = orient::orient(&view, &orient::Options::default(), &job.sub_job(0.2, 0.5))?.mesh;
        }
        let (mut piece, mut maps) = (alloc::with_capacity(mesh.positions.len())?, alloc::with_capacity(pieces.len())?);
        for ((view, place), k) in pieces.iter().zip(&places).zip(0..) {
            let count = view.positions().len() as u32;
            piece.extend((0..count).map(|_| k));
            let vertices = alloc::collect(place.first_vertex..place.first_vertex + count)?;
            maps.push(IndexMap { vertices, faces: Vec::new() });
        }
        let loops = PieceLoops::new(&mesh, &piece, &[], &job.sub_job(0.5, 0.7))?;
        let excluded = loops.list_excluded_pairs(&maps, options)?;
        let used = alloc::filled(false, loops.rims.len())?;
        let whole = Options { extent: Extent::WholeLoops, ..*options };
        let mut search = loops.facing_search(&whole, &used, &excluded);
        search.whole_loop_gap_factor = MAX_GAP_TO_DEFAULT_GAP_RATIO;
        let found = search.find_facing_loops(&job.sub_job(0.7, 1.0))?;
        let mut pairs = alloc::collect(found.iter().map(|facing| {
            let [r, k] = facing.rims.map(|r| r as u32);
            [r.min(k), r.max(k)]
        }))?;
        pairs.sort_unstable();
        let names = alloc::gather(names)?;
        let named = |&(v, r): &(u32, u32)| (names[v as usize], r);
        let all = loops.vertex_loop_pairs()?;
        let mut loops_at_vertices = alloc::gather(all.iter().map(named).filter(|&(name, _)| name != NONE))?;
        sort_distinct(&mut loops_at_vertices);
        Ok(UnsewnLoopPairs { loops_at_vertices, pairs })
    }

    /// Returns true if two runs of vertices of the sewn mesh belong to the two loops of a pair.
    pub(super) fn join_runs(&self, first: &[u32], second: &[u32]) -> Result<bool> {
        let [first, second] = [self.loops_of_run(first)?, self.loops_of_run(second)?];
        let is_pair = |&r: &u32, &k: &u32| self.pairs.binary_search(&[r.min(k), r.max(k)]).is_ok();
        Ok(first.iter().any(|r| second.iter().any(|k| is_pair(r, k))))
    }

    /// Returns the loops that pass all vertices of a run. A vertex of no loop divides an edge, and
    /// is skipped.
    fn loops_of_run(&self, run: &[u32]) -> Result<Vec<u32>> {
        let loops_at = |v: u32| entries_of_vertex(&self.loops_at_vertices, v);
        let on_loops = || run.iter().filter(|&&v| !loops_at(v).is_empty());
        let Some(&first) = on_loops().next() else { return Ok(Vec::new()) };
        let passes = |r: u32| on_loops().all(|&v| self.loops_at_vertices.binary_search(&(v, r)).is_ok());
        alloc::gather(loops_at(first).iter().map(|&(_, r)| r).filter(|&r| passes(r)))
    }
}
