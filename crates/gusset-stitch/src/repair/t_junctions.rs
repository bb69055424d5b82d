//! T-junctions of borders: vertices of one border inside a free edge of another, and the splits
//! that make both borders match.
//!
//! A vertex lies on an edge if the edge is within the vertex's reach and its ends are beyond it.
//! The edge must be longer than twice the reach, and its face must not have a corner near the
//! vertex. Edges are found in a box tree. Coincident vertices are one place, and an edge is split
//! once at each place.
//!
//! **Only useful splits are made.** The splits divide the free edges into pieces, which are
//! compared by the places of their ends. If exactly two coincide, they can be sewn. A split is
//! dropped if neither piece beside it can be sewn. This merges the two pieces, and the remaining
//! splits are compared again. So vertices that merely touch an edge stay unchanged, and three
//! sheets on one line are left as by welding. Splits that would turn over a part of a triangle are
//! dropped too.
//!
//! O((V + E) log V) for V vertices and E edges of borders with few places on each edge. Each
//! comparison takes as much again; there are at most [`MAX_SPLIT_FILTER_PASSES`].

use super::sew_edges::{free_vertices, is_free};
use super::split_face::{SplitFace, has_upright_parts};
use super::vertex_clusters::VertexClusters;
use super::weld_tolerance::{ToleranceSource, WeldDistances};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::box_tree::{BoxTree, spatial_order};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::{sort, sort_distinct};
use gusset_mesh::{MeshView, Topology, half_edges, unordered};

/// Number of edges in a leaf of the tree.
const EDGES_PER_LEAF: usize = 4;

/// Largest number of comparisons of the remaining splits.
const MAX_SPLIT_FILTER_PASSES: usize = 16;

/// Number of vertices between two progress reports.
const VERTICES_PER_REPORT: usize = 1 << 10;

/// Number of visited leaves between two progress reports.
const LEAVES_PER_REPORT: usize = 1 << 16;

/// Number of faces between two progress reports.
const FACES_PER_REPORT: usize = 1 << 16;

const STAGE: &str = "finding T-junctions";

/// A free edge in the direction of its face.
#[derive(Clone, Copy)]
pub(super) struct FreeEdge {
    pub(super) half_edge: u32,
    pub(super) face: u32,
    pub(super) ends: [u32; 2],
}

/// A split of a free edge.
#[derive(Clone, Copy)]
pub(super) struct EdgeSplit {
    /// The index of the edge.
    pub(super) edge: u32,
    /// The position along the edge, from 0 to 1.
    pub(super) edge_parameter: f64,
    /// The smallest of the coincident vertices at this place.
    pub(super) vertex: u32,
}

/// The splits of free edges.
pub(super) struct TJunctions {
    /// The free edges, in the order of their half-edges.
    pub(super) edges: Vec<FreeEdge>,
    /// The splits, ordered by edge and along each edge.
    pub(super) splits: Vec<EdgeSplit>,
    /// Vertices that lie on a free edge that is not split there, ascending.
    pub(super) vertices_on_unsplit_edges: Vec<u32>,
}

impl TJunctions {
    /// Finds the splits that make borders match.
    pub(super) fn find(
        mesh: &MeshView<'_>,
        topology: &Topology,
        source: ToleranceSource,
        job: &Job<'_>,
    ) -> Result<Self> {
        let faces = mesh.faces().len();
        let mut edges = Vec::new();
        for face in 0..faces {
            job.sub_job(0.0, 0.0).step_every(FACES_PER_REPORT, face, faces, STAGE)?;
            let free = half_edges(mesh, face).filter(|&(h, ..)| is_free(topology, h));
            let free = free.map(|(half_edge, u, v)| FreeEdge { half_edge, face: face as u32, ends: [u, v] });
            alloc::extend(&mut edges, free)?;
        }
        job.step(0.0, STAGE)?;
        let members = free_vertices(mesh, topology)?;
        job.step(0.0, STAGE)?;
        let tolerance = WeldDistances::find_for_members(mesh, &members, source, false, &job.sub_job(0.0, 0.1))?;
        let clusters = VertexClusters::cluster_members(
            mesh,
            &members,
            &tolerance.max_distance_of_member,
            None,
            &job.sub_job(0.1, 0.3),
        )?;
        let border = FreeBorder { mesh, edges: &edges, edge_ends: &members, clusters: &clusters.representative };
        let mut splits = border.find_places_on_edges(&tolerance.max_distance_of_member, &job.sub_job(0.3, 0.7))?;
        job.step(0.7, STAGE)?;
        let mut left = alloc::gather(splits.iter().map(|split| split.vertex))?;
        border.keep_useful_splits(&mut splits, &job.sub_job(0.7, 1.0))?;
        job.step(1.0, STAGE)?;
        let mut used = alloc::gather(splits.iter().map(|split| split.vertex))?;
        sort_distinct(&mut used);
        sort_distinct(&mut left);
        left.retain(|v| used.binary_search(v).is_err());
        Ok(TJunctions { edges, splits, vertices_on_unsplit_edges: left })
    }
}

/// The free edges, and the clusters of their ends.
struct FreeBorder<'a> {
    mesh: &'a MeshView<'a>,
    edges: &'a [FreeEdge],
    /// The ends of the edges, ascending.
    edge_ends: &'a [u32],
    /// For each vertex, the smallest coincident vertex.
    clusters: &'a [u32],
}

impl FreeBorder<'_> {
    fn cluster_of(&self, v: u32) -> u32 {
        self.clusters[v as usize]
    }

    /// Returns all places on edges, by edge and along each edge. `reach` has an entry per member;
    /// empty for 0.
    fn find_places_on_edges(&self, reach: &[f64], job: &Job<'_>) -> Result<Vec<EdgeSplit>> {
        let points = self.edge_ends.iter().map(|&v| self.mesh.positions().get(v));
        let points = alloc::collect_cancellable(points, &job.sub_job(0.0, 0.0), STAGE)?;
        job.step(0.0, STAGE)?;
        let unit = common_unit(&points);
        let ends = |e: u32| self.edges[e as usize].ends.map(|v| self.mesh.positions().get(v) / unit);
        // A vertex cannot lie inside an edge of length 0.
        let has_length = |&e: &u32| ends(e)[0] != ends(e)[1];
        let mut long = Vec::new();
        job.sub_job(0.0, 0.0).work_in_ranges(STAGE, self.edges.len(), |range| {
            alloc::extend(&mut long, (range.start as u32..range.end as u32).filter(has_length))
        })?;
        let mut boxes = alloc::with_capacity(long.len())?;
        job.sub_job(0.0, 0.0).work_in_ranges(STAGE, long.len(), |range| {
            boxes.extend(long[range].iter().map(|&e| Aabb::from_points(ends(e))));
            Ok(())
        })?;
        let order = spatial_order(&boxes, EDGES_PER_LEAF, &job.sub_job(0.0, 0.2), STAGE)?;
        let around = |group: &[u32]| group.iter().fold(Aabb::EMPTY, |whole, &e| whole.union(boxes[e as usize]));
        let groups =
            alloc::collect_cancellable(order.chunks(EDGES_PER_LEAF).map(around), &job.sub_job(0.2, 0.2), STAGE)?;
        let tree = BoxTree::new_cancellable(groups.into_iter(), &job.sub_job(0.2, 0.2), STAGE)?;
        let mut splits: Vec<EdgeSplit> = Vec::new();
        let mut leaves = 0;
        for (i, (&v, &p)) in self.edge_ends.iter().zip(&points).enumerate() {
            let here = job.sub_job(0.2, 0.6).sub_job_of_item(i, points.len());
            if i % VERTICES_PER_REPORT == 0 {
                here.step(0.0, STAGE)?;
            }
            // A vertex at the exact position of its representative finds the same places.
            let first = self.edge_ends.binary_search(&self.cluster_of(v)).unwrap_or(i);
            if first < i && points[first] == p && reach.get(first) == reach.get(i) {
                continue;
            }
            let (point, reach) = (p / unit, reach.get(i).map_or(0.0, |reach| reach / unit));
            tree.visit_overlapping(&Aabb::from_points([point]), reach, |leaf| {
                leaves += 1;
                if leaves % LEAVES_PER_REPORT == 0 {
                    here.step(0.0, STAGE)?;
                }
                for &place in &order[EDGES_PER_LEAF * leaf..order.len().min(EDGES_PER_LEAF * (leaf + 1))] {
                    let e = long[place as usize];
                    if let Some(at) = position_along_edge(ends(e), point, reach)
                        && self.face_of_edge_has_no_corner_near(v, e)
                    {
                        alloc::push(
                            &mut splits,
                            EdgeSplit { edge: e, edge_parameter: at, vertex: self.cluster_of(v) },
                        )?;
                    }
                }
                Ok(())
            })?;
        }
        let by_place = |a: &EdgeSplit, b: &EdgeSplit| a.edge_parameter.total_cmp(&b.edge_parameter);
        let by_vertex = |a: &EdgeSplit, b: &EdgeSplit| a.edge.cmp(&b.edge).then(a.vertex.cmp(&b.vertex));
        sort(&mut splits, |a, b| by_vertex(a, b).then(by_place(a, b)), &job.sub_job(0.6, 0.8), STAGE)?;
        job.step(0.8, STAGE)?;
        splits.dedup_by_key(|split| (split.edge, split.vertex));
        let along =
            |a: &EdgeSplit, b: &EdgeSplit| a.edge.cmp(&b.edge).then(by_place(a, b)).then(a.vertex.cmp(&b.vertex));
        sort(&mut splits, along, &job.sub_job(0.8, 1.0), STAGE)?;
        Ok(splits)
    }

    /// Returns true if all corners of the face of edge `e` are in other clusters than `v`.
    fn face_of_edge_has_no_corner_near(&self, v: u32, e: u32) -> bool {
        let cluster = self.cluster_of(v);
        self.mesh.face(self.edges[e as usize].face as usize).all(|corner| self.cluster_of(corner) != cluster)
    }

    /// Drops splits that do not help sewing or that would turn triangles over, until all remaining
    /// splits are useful.
    fn keep_useful_splits(&self, splits: &mut Vec<EdgeSplit>, job: &Job<'_>) -> Result<()> {
        for pass in 0..MAX_SPLIT_FILTER_PASSES {
            let before = splits.len();
            if before > 0 {
                let job = job.sub_job_of_item(pass, MAX_SPLIT_FILTER_PASSES);
                self.keep_splits_that_match(splits, &job)?;
                job.step(1.0, STAGE)?;
                self.keep_splits_without_turned_parts(splits, &job)?;
            }
            if splits.len() == before {
                break;
            }
        }
        Ok(())
    }

    /// Drops splits without an adjacent piece that coincides with exactly one other.
    fn keep_splits_that_match(&self, splits: &mut Vec<EdgeSplit>, job: &Job<'_>) -> Result<()> {
        // Edge e with splits from index j has pieces from index j + e, one more than splits.
        let mut pieces = alloc::with_capacity(splits.len() + self.edges.len())?;
        let mut rest = splits.iter().peekable();
        for (e, edge) in self.edges.iter().enumerate() {
            let [mut from, end] = edge.ends.map(|v| self.cluster_of(v));
            job.sub_job(0.0, 0.0).step_every(FACES_PER_REPORT, e, self.edges.len(), STAGE)?;
            while let Some(split) = rest.next_if(|split| split.edge as usize == e) {
                pieces.push((unordered([from, split.vertex]), pieces.len() as u32));
                from = split.vertex;
            }
            pieces.push((unordered([from, end]), pieces.len() as u32));
        }
        let mut matched = alloc::filled(false, pieces.len())?;
        sort(&mut pieces, Ord::cmp, job, STAGE)?;
        job.step(1.0, STAGE)?;
        for (k, together) in pieces.chunk_by(|a, b| a.0 == b.0).enumerate() {
            job.sub_job(1.0, 1.0).step_every(FACES_PER_REPORT, k, pieces.len(), STAGE)?;
            let [_, _] = together else { continue };
            together.iter().for_each(|&(_, piece)| matched[piece as usize] = true);
        }
        job.step(1.0, STAGE)?;
        let mut j = 0;
        splits.retain(|split| {
            let piece = j + split.edge as usize;
            j += 1;
            matched[piece] || matched[piece + 1]
        });
        Ok(())
    }

    /// Drops the splits of triangles that would have parts turned over.
    fn keep_splits_without_turned_parts(&self, splits: &mut Vec<EdgeSplit>, job: &Job<'_>) -> Result<()> {
        let face = |split: &EdgeSplit| self.edges[split.edge as usize].face;
        let mut upright = alloc::with_capacity(splits.len())?;
        let mut split_face = SplitFace::default();
        for (k, of_face) in splits.chunk_by(|a, b| face(a) == face(b)).enumerate() {
            job.sub_job(1.0, 1.0).step_every(FACES_PER_REPORT, k, splits.len(), STAGE)?;
            let f = face(&of_face[0]) as usize;
            let places = of_face
                .iter()
                .map(|split| (self.edges[split.edge as usize].half_edge, split.edge_parameter, split.vertex));
            split_face.set_face(self.mesh, f, places)?;
            let fits = has_upright_parts(self.mesh, f, &split_face);
            upright.extend(of_face.iter().map(|_| fits));
        }
        let mut fits = upright.into_iter();
        splits.retain(|_| fits.next() == Some(true));
        Ok(())
    }
}

/// Returns the position along the edge `p`, `q` of a point within `reach` of the edge and beyond
/// `reach` from its ends.
fn position_along_edge([p, q]: [DVec3; 2], point: DVec3, reach: f64) -> Option<f64> {
    let (along, from) = (q - p, point - p);
    let squared = reach * reach;
    let at = from.dot(along) / along.length_squared();
    let inside = along.length_squared() > 4.0 * squared && 0.0 < at && at < 1.0;
    let is_near = inside && (from - at * along).length_squared() <= squared;
    (is_near && from.length_squared() > squared && (point - q).length_squared() > squared).then_some(at)
}
