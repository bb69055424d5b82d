//! The pairing of half-edges by a counting sort.
//!
//! Every vertex v has two buckets. Bucket 2v holds the half-edges that start at v and end at a
//! larger vertex. Bucket 2v + 1 holds the half-edges that end at v and start at a larger vertex.
//! The half-edges of one edge are thus in two adjacent buckets. In an oriented manifold each
//! half-edge of one bucket matches exactly one of the other by its far end, and short buckets are
//! simply scanned. Otherwise both buckets are sorted by the far end. Hashing is not used. The order
//! of the faces affects only the numbers of the half-edges.
//!
//! Each thread counts and distributes a part of the faces. The sum of all counts gives each thread
//! its positions in every bucket, so half-edges are in order for any number of threads. The pairs
//! are then made in ranges of vertices.

use super::defect::Defect;
use super::view::{FaceVisitor, Faces, MeshView};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::par;
use gusset_base::sort::sort;
use std::ops::Range;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};

/// Marks a half-edge whose edge has one face.
pub(super) const FREE_EDGE_MARK: u32 = u32::MAX;
/// Marks a half-edge whose edge has three or more faces.
pub(super) const NON_MANIFOLD_EDGE_MARK: u32 = u32::MAX - 1;

/// Faces or vertices that a thread processes between two progress reports.
const ELEMENTS_PER_REPORT: usize = 1 << 18;
/// Vertices whose buckets form one work item.
const VERTICES_PER_TASK: usize = 1 << 13;
/// The maximum number of threads that fill buckets. Each of them needs its own arrays of counts.
const MAX_BUCKET_THREADS: usize = 8;
/// The minimum number of faces for a thread.
const MIN_FACES_PER_THREAD: usize = 1 << 11;
/// The longest bucket that is scanned instead of sorted.
const MAX_UNSORTED_BUCKET_ENTRIES: usize = 32;
/// The longest bucket that is sorted without a progress report.
const MAX_UNREPORTED_BUCKET_ENTRIES: usize = 1 << 16;

/// The pairing of half-edges.
pub struct Topology {
    /// Per half-edge: its partner, [`FREE_EDGE_MARK`], [`NON_MANIFOLD_EDGE_MARK`], or itself if it
    /// is ignored.
    pub(super) mate: Vec<u32>,
    /// Per vertex: the number of half-edges that start there, without ignored ones.
    pub(super) corner_count: Vec<u32>,
    /// Sorted.
    pub(super) defects: Vec<Defect>,
}

const STAGE: &str = "pairing half-edges";

impl Topology {
    /// Pairs the half-edges of `mesh`. O(H log d) for H half-edges and vertices of degree d.
    ///
    /// Extra memory: 12 bytes a half-edge, 4 bytes a vertex, and 12 bytes a vertex for each of at
    /// most 8 threads. The result keeps 4 bytes a half-edge and 4 bytes a vertex.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
    /// [`Error::Cancelled`](gusset_base::Error::Cancelled).
    pub fn new(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Self> {
        let faces = mesh.faces();
        let mut parts = divide_faces_among_threads(mesh, job.requested_threads())?;
        run_on_each_thread(&mut parts, &job.sub_job(0.0, 0.3), |part, range| {
            faces.visit_faces(range, &mut HalfEdgeCounter { faces, thread_faces: part })
        })?;
        job.step(0.3, STAGE)?;
        let (corner_count, mut defects) = sum_corner_counts(&mut parts)?;
        job.step(0.3, STAGE)?;
        let count = turn_counts_into_offsets(&mut parts, mesh.positions().len(), &job.sub_job(0.3, 0.3))?;

        // Each entry packs (far end, half-edge) into one word. No two threads write to the same
        // entry.
        let entries: Vec<AtomicU64> = alloc::zeroed(count as usize)?;
        run_on_each_thread(&mut parts, &job.sub_job(0.3, 0.6), |part, range| {
            faces.visit_faces(range, &mut BucketFiller { thread_faces: part, entries: &entries })
        })?;
        let threads = parts.len();
        job.step(0.6, STAGE)?;
        // The last part's positions are now the ends of the buckets. Reused memory costs less than
        // new memory, so free the parts first.
        let (mut ends, mut ignored) = (Vec::new(), Vec::new());
        for part in parts {
            alloc::append(&mut ignored, &part.ignored_half_edges)?;
            ends = part.bucket_positions;
        }
        let mate: Vec<AtomicU32> = alloc::zeroed(faces.half_edge_count())?;
        ignored.iter().for_each(|&h| mate[h as usize].store(h, Ordering::Relaxed));

        let mut entries: Vec<u64> = entries.into_iter().map(AtomicU64::into_inner).collect();
        let (mut rest, mut first, mut long) = (entries.as_mut_slice(), 0, Vec::new());
        for block in split_into_blocks(0..mesh.positions().len(), ELEMENTS_PER_REPORT * threads) {
            job.step(0.6 + 0.4 * block.start as f64 / mesh.positions().len() as f64, STAGE)?;
            let mut work = Vec::new();
            for range in split_into_blocks(block, VERTICES_PER_TASK) {
                let ends = &ends[2 * range.start..2 * range.end];
                let end = ends.last().map_or(first, |&end| end);
                let (own, others) = rest.split_at_mut((end - first) as usize);
                work.push((first, ends, own));
                (rest, first) = (others, end);
            }
            let found = par::map(threads, work.into_iter(), |(first, ends, entries)| {
                pair_half_edges_in_buckets(faces, &mate, first, ends, entries)
            })?;
            for found in found {
                let found = found?;
                alloc::append(&mut defects, &found.defects)?;
                alloc::extend(&mut long, found.long_buckets)?;
            }
        }
        let job = job.sub_job(1.0, 1.0);
        for bucket in long {
            let bucket = &mut entries[bucket];
            sort(bucket, Ord::cmp, &job, STAGE)?;
            for (k, edge) in bucket.chunk_by(end_at_same_vertex).enumerate() {
                job.step_every(ELEMENTS_PER_REPORT, k, faces.half_edge_count(), STAGE)?;
                mark_half_edges_of_edge(faces, &mate, edge, &mut defects)?;
            }
        }
        sort(&mut defects, Ord::cmp, &job, STAGE)?;
        let mate = mate.into_iter().map(AtomicU32::into_inner).collect();
        Ok(Topology { mate, corner_count, defects })
    }
}

/// Divides `range` into consecutive ranges of `length` elements.
fn split_into_blocks(range: Range<usize>, length: usize) -> impl Iterator<Item = Range<usize>> {
    range.clone().step_by(length).map(move |first| first..range.end.min(first + length))
}

/// The faces that one thread puts into buckets.
struct ThreadFaces {
    faces: Range<usize>,
    /// Per bucket: first the number of its half-edges, later the position of the next one.
    bucket_positions: Vec<u32>,
    /// Per vertex: the number of half-edges that start there.
    corner_count: Vec<u32>,
    /// Half-edges that belong to no bucket.
    ignored_half_edges: Vec<u32>,
    defects: Vec<Defect>,
}

/// Divides the faces among the threads, with enough faces for each.
fn divide_faces_among_threads(mesh: &MeshView<'_>, threads: usize) -> Result<Vec<ThreadFaces>> {
    let (faces, vertices) = (mesh.faces().len(), mesh.positions().len());
    let threads = par::resolve_thread_count(faces.div_ceil(MIN_FACES_PER_THREAD).min(MAX_BUCKET_THREADS), threads);
    let mut parts = Vec::new();
    for faces in split_into_blocks(0..faces, faces.div_ceil(threads)) {
        let (places, corner_count) = (alloc::zeroed(2 * vertices)?, alloc::zeroed(vertices)?);
        parts.push(ThreadFaces {
            faces,
            bucket_positions: places,
            corner_count,
            ignored_half_edges: Vec::new(),
            defects: Vec::new(),
        });
    }
    Ok(parts)
}

/// Runs `work` on every part, each on its own thread, with progress reports.
fn run_on_each_thread(
    parts: &mut [ThreadFaces],
    job: &Job<'_>,
    work: impl Fn(&mut ThreadFaces, Range<usize>) -> Result<()> + Sync,
) -> Result<()> {
    let longest = parts.iter().map(|part| part.faces.len()).max().unwrap_or(0);
    for block in split_into_blocks(0..longest, ELEMENTS_PER_REPORT) {
        job.step(block.start as f64 / longest as f64, STAGE)?;
        let done = par::map(parts.len(), parts.iter_mut(), |part| {
            let at = |i: usize| part.faces.end.min(part.faces.start + i);
            let range = at(block.start)..at(block.end);
            work(part, range)
        })?;
        done.into_iter().collect::<Result<()>>()?;
    }
    Ok(())
}

/// Sums the parts' corner counts, and collects their degenerate faces.
fn sum_corner_counts(parts: &mut [ThreadFaces]) -> Result<(Vec<u32>, Vec<Defect>)> {
    let (mut counts, mut defects) = (Vec::new(), Vec::new());
    for part in parts {
        alloc::append(&mut defects, &part.defects)?;
        let more = std::mem::take(&mut part.corner_count);
        if counts.is_empty() {
            counts = more;
        } else {
            counts.iter_mut().zip(more).for_each(|(count, more)| *count += more);
        }
    }
    Ok((counts, defects))
}

/// Turns counts into positions: bucket after bucket, and within a bucket part after part. Returns
/// the number of half-edges.
fn turn_counts_into_offsets(parts: &mut [ThreadFaces], vertices: usize, job: &Job<'_>) -> Result<u32> {
    let mut next = 0;
    job.work_in_ranges(STAGE, 2 * vertices, |buckets| {
        for bucket in buckets {
            for part in parts.iter_mut() {
                let place = &mut part.bucket_positions[bucket];
                next += std::mem::replace(place, next);
            }
        }
        Ok(())
    })?;
    Ok(next)
}

/// Returns the bucket of a half-edge from `u` to `v`.
fn bucket_of_half_edge(u: u32, v: u32) -> usize {
    2 * u.min(v) as usize + usize::from(u > v)
}

/// Calls `visit` with the half-edges of a face as (index, start, end). Skips half-edges without
/// length, and the whole face if fewer than three remain. Returns the number of calls.
#[inline(always)]
fn visit_proper_half_edges(first: u32, corners: &[u32], mut visit: impl FnMut(u32, u32, u32)) -> usize {
    let end = |i: usize| corners[if i + 1 < corners.len() { i + 1 } else { 0 }];
    let count = (0..corners.len()).filter(|&i| corners[i] != end(i)).count();
    if count < 3 {
        return 0;
    }
    for (i, &u) in corners.iter().enumerate() {
        if u != end(i) {
            visit(first + i as u32, u, end(i));
        }
    }
    count
}

/// Returns a vertex that occurs twice in the face.
#[inline(always)]
fn find_repeated_vertex(corners: &[u32]) -> Result<Option<u32>> {
    if corners.len() <= 8 {
        let twice = |&i: &usize| corners[..i].contains(&corners[i]);
        return Ok((1..corners.len()).find(twice).map(|i| corners[i]));
    }
    let mut sorted = alloc::copied(corners)?;
    sorted.sort_unstable();
    Ok(sorted.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0]))
}

/// Counts half-edges and collects degenerate faces.
struct HalfEdgeCounter<'p> {
    faces: &'p Faces<'p>,
    thread_faces: &'p mut ThreadFaces,
}

impl FaceVisitor for HalfEdgeCounter<'_> {
    #[inline(always)]
    fn visit_face(&mut self, first: u32, corners: &[u32]) -> Result<()> {
        if let Some(vertex) = find_repeated_vertex(corners)? {
            let face = self.faces.face_of_half_edge(first);
            alloc::push(&mut self.thread_faces.defects, Defect::DegenerateFace { face, vertex })?;
        }
        visit_proper_half_edges(first, corners, |_, u, v| {
            self.thread_faces.bucket_positions[bucket_of_half_edge(u, v)] += 1;
            self.thread_faces.corner_count[u as usize] += 1;
        });
        Ok(())
    }
}

/// Puts half-edges into their buckets.
struct BucketFiller<'p> {
    thread_faces: &'p mut ThreadFaces,
    entries: &'p [AtomicU64],
}

impl FaceVisitor for BucketFiller<'_> {
    #[inline(always)]
    fn visit_face(&mut self, first: u32, corners: &[u32]) -> Result<()> {
        let places = &mut self.thread_faces.bucket_positions;
        let shown = visit_proper_half_edges(first, corners, |h, u, v| {
            let place = &mut places[bucket_of_half_edge(u, v)];
            self.entries[*place as usize].store(u64::from(u.max(v)) << 32 | u64::from(h), Ordering::Relaxed);
            *place += 1;
        });
        if shown == corners.len() { Ok(()) } else { self.record_ignored_half_edges(first, corners, shown) }
    }
}

impl BucketFiller<'_> {
    /// Records the half-edges of a face that were skipped.
    #[cold]
    fn record_ignored_half_edges(&mut self, first: u32, corners: &[u32], shown: usize) -> Result<()> {
        let after = corners.iter().cycle().skip(1);
        let ignored = corners.iter().zip(after).zip(first..).filter(|&((u, v), _)| shown == 0 || u == v);
        alloc::extend(&mut self.thread_faces.ignored_half_edges, ignored.map(|(_, h)| h))
    }
}

/// The leftovers of pairing a range of vertices.
#[derive(Default)]
struct PairingLeftovers {
    defects: Vec<Defect>,
    /// The buckets that are too long to process without progress reports.
    long_buckets: Vec<Range<usize>>,
}

/// Pairs the half-edges in the buckets of some vertices. The buckets start at `first` and end at
/// `ends`.
fn pair_half_edges_in_buckets(
    faces: &Faces<'_>,
    mate: &[AtomicU32],
    mut first: u32,
    ends: &[u32],
    mut entries: &mut [u64],
) -> Result<PairingLeftovers> {
    let mut found = PairingLeftovers::default();
    for end in ends.chunks_exact(2) {
        let (up, both) = (end[0] - first, end[1] - first);
        let bucket = first as usize..end[1] as usize;
        first = end[1];
        let (own, others) = std::mem::take(&mut entries).split_at_mut(both as usize);
        entries = others;
        let (ups, downs) = own.split_at_mut(up as usize);
        if pair_unless_ambiguous(mate, ups, downs) {
            continue;
        }
        if own.len() > MAX_UNREPORTED_BUCKET_ENTRIES {
            alloc::push(&mut found.long_buckets, bucket)?;
            continue;
        }
        own.sort_unstable();
        for edge in own.chunk_by(end_at_same_vertex) {
            mark_half_edges_of_edge(faces, mate, edge, &mut found.defects)?;
        }
    }
    Ok(found)
}

/// Returns true if two half-edges of one vertex's buckets have the same far end.
fn end_at_same_vertex(x: &u64, y: &u64) -> bool {
    x >> 32 == y >> 32
}

/// Pairs each upward half-edge with the downward one that has the same far end. Returns false if a
/// match is missing or ambiguous, or if there are too many half-edges to scan. The caller must then
/// overwrite the partners.
fn pair_unless_ambiguous(mate: &[AtomicU32], ups: &[u64], downs: &mut [u64]) -> bool {
    if ups.len() != downs.len() || ups.len() > MAX_UNSORTED_BUCKET_ENTRIES {
        return false;
    }
    for (i, &up) in ups.iter().enumerate() {
        let downs = &mut downs[i..];
        // Without an early exit, and without a branch that depends on the position.
        let (mut count, mut at) = (0, 0);
        for (k, &down) in downs.iter().enumerate() {
            let same = up >> 32 == down >> 32;
            count += usize::from(same);
            at = if same { k } else { at };
        }
        if count != 1 {
            return false;
        }
        link_opposite_half_edges(mate, up as u32, downs[at] as u32);
        downs.swap(0, at);
    }
    true
}

fn link_opposite_half_edges(mate: &[AtomicU32], g: u32, h: u32) {
    mate[g as usize].store(h, Ordering::Relaxed);
    mate[h as usize].store(g, Ordering::Relaxed);
}

/// Stores the relation of the half-edges of one edge, given in order.
fn mark_half_edges_of_edge(
    faces: &Faces<'_>,
    mate: &[AtomicU32],
    edge: &[u64],
    defects: &mut Vec<Defect>,
) -> Result<()> {
    let half_edge = |i: usize| edge[i] as u32;
    let set = |mark: u32| edge.iter().for_each(|&entry| mate[entry as u32 as usize].store(mark, Ordering::Relaxed));
    match edge.len() {
        1 => set(FREE_EDGE_MARK),
        2 => {
            let (g, h) = (half_edge(0), half_edge(1));
            link_opposite_half_edges(mate, g, h);
            if faces.corner(g) == faces.corner(h) {
                alloc::push(defects, Defect::OrientationConflict { half_edges: [g, h] })?;
            }
        }
        n => {
            set(NON_MANIFOLD_EDGE_MARK);
            alloc::push(defects, Defect::NonManifoldEdge { half_edge: half_edge(0), faces: n as u32 })?;
        }
    }
    Ok(())
}
