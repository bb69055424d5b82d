//! Texture coordinates across new faces.
//!
//! Texture coordinates are interpolated across a gap like other values if both sides are on one
//! chart. Scans of one object are on one chart, and so are both sides of a cut. Between different
//! charts, interpolated values are meaningless. Each new face then extends the chart of its base,
//! and the charts meet in a seam in the middle.
//!
//! **Charts.** Rim edges that share a vertex are on one chart if their faces have the same values
//! there. The new faces between charts of two rims vote whether these are one chart. A face votes
//! yes if the interpolated value at its opposite corners is close to the extended chart of its
//! base. Close means within half of the way from the base, or half of the base.
//!
//! **Cuts.** A chart that closes around an object is cut somewhere. At a vertex of the cut, old
//! corners have different values. A new face between two rims uses the values on its own side of
//! the cut: the values nearest to the extended chart of its base. The jump of a cut is added where
//! that is nearer, so that a texture that repeats stays continuous. A face whose values are still
//! far off extends the chart of its base.
//!
//! **Extension.** The base's old face is unfolded about the base into the plane of the new face.
//! Let a corner have the position x along the base and the distance y from its line. The third
//! corner of the old face has a positive y. The new corner's value is the value of the old face's
//! affine map at (x, -y). This gives affine weights of the three corners of the old face, which are
//! equal for all channels.

use super::rims::{RimEdgeEnd, RimEdges};
use super::table::{FACES_PER_REPORT, STAGE, SourceTable};
use super::values::Output;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{Mesh, NONE};
use std::ops::Range;

/// Charts are extended by at most this number of heights of the old face, because needles
/// extrapolate badly.
const MAX_EXTENSION_HEIGHTS: f64 = 64.0;
/// Smallest height of a face, relative to its base. Lower faces do not define a direction.
const MIN_RELATIVE_HEIGHT: f64 = 1e-6;
/// Values on both sides agree if they differ by less than this fraction of the way from the base.
const MAX_RELATIVE_DEVIATION: f64 = 0.5;
/// Largest number of different jumps, counting both directions. Jumps that differ by less than this
/// fraction are the same.
const MAX_CHART_JUMPS: usize = 32;
const MAX_RELATIVE_JUMP_DIFFERENCE: f64 = 1e-3;
/// Jumps, and deviations from an extended chart, are long if they exceed this multiple of the usual
/// length of a base.
const MIN_LONG_JUMP_IN_BASE_LENGTHS: f64 = 4.0;
/// Values at a vertex are the same if they differ by less than this fraction of the largest one.
const MAX_RELATIVE_VALUE_DIFFERENCE: f64 = 1e-6;

/// The base of a new face, given by corners of the result.
#[derive(Debug, Clone, Copy, PartialEq)]
struct FaceBase {
    /// The old face's corners at both ends of the base, and one corner off its line.
    corners: [u32; 3],
}

/// The cuts of charts: whether there are any, the long jumps in both directions, and the square of
/// the usual length of a base.
struct ChartCuts {
    has_cuts: bool,
    long_jumps: Vec<Vec<f64>>,
    usual_squared_base_length: f64,
}

/// An old corner whose value a new corner uses, across a cut if there is a jump.
struct SourceCorner<'a> {
    corner: u32,
    jump: Option<&'a [f64]>,
    weight: f64,
}

/// The data of new faces for texture coordinates.
#[derive(Debug, Default, PartialEq)]
pub(super) struct ChartContinuation {
    /// The first corner of each new face in the result, then the end of the last one.
    offsets: Vec<u32>,
    /// The base at each rim edge.
    bases: Vec<FaceBase>,
    /// The rim edge of each new face, or [`NONE`].
    base_of: Vec<u32>,
    /// For each new corner, the weights of its base's three corners in the extended chart.
    base_corner_weights: Vec<[f64; 3]>,
    /// For each new corner, the old vertices whose values are interpolated.
    interpolated_vertices: SourceTable,
    /// Both ends of the rim edges, sorted by vertex.
    rim_edge_ends: Vec<RimEdgeEnd>,
}

impl ChartContinuation {
    /// Prepares the new faces, which begin at `first_face`. `spread` returns the old vertices whose
    /// values a vertex uses.
    pub(super) fn new<I: Iterator<Item = (u32, f64)>>(
        mesh: &Mesh,
        first_face: usize,
        rims: RimEdges,
        spread: impl Fn(u32) -> I,
        job: &Job<'_>,
    ) -> Result<ChartContinuation> {
        let at = |corner: u32| mesh.positions.get(mesh.corner(corner as usize));
        let bases = alloc::collect(rims.edges.iter().map(|&edge| FaceBase::new(mesh, edge)))?;
        let offsets = alloc::copied(&mesh.face_offsets[first_face..])?;
        let (first, end) = (offsets[0], offsets[offsets.len() - 1]);
        let mut weights = alloc::with_capacity((end - first) as usize)?;
        let mut shares = SourceTable::with_capacity((end - first) as usize, (end - first) as usize)?;
        for (f, (range, &base)) in offsets.windows(2).zip(&rims.base_of_new_face).enumerate() {
            job.step_every(FACES_PER_REPORT, f, rims.base_of_new_face.len(), STAGE)?;
            for corner in range[0]..range[1] {
                let Some(own) = bases.get(base as usize) else {
                    weights.push([0.0; 3]);
                    shares.push(None)?;
                    continue;
                };
                let v = mesh.corner(corner as usize);
                let [start, end, _] = own.corners.map(|corner| mesh.corner(corner as usize));
                weights.push(match v {
                    v if v == start => [1.0, 0.0, 0.0],
                    v if v == end => [0.0, 1.0, 0.0],
                    _ => affine_weights_beyond_base(own.corners.map(at), at(corner)),
                });
                shares.push(spread(v))?;
            }
        }
        Ok(ChartContinuation {
            offsets,
            bases,
            base_of: rims.base_of_new_face,
            base_corner_weights: weights,
            interpolated_vertices: shares,
            rim_edge_ends: rims.edge_ends,
        })
    }

    /// Where charts differ, replaces the interpolated values of new corners by the extended charts
    /// of their bases. `values` holds the values of all corners of the result.
    pub(super) fn extend_charts(&self, values: &mut Output<'_>, job: &Job<'_>) -> Result<()> {
        if self.base_of.is_empty() {
            return Ok(());
        }
        let mut charts = self.charts_along_rims(values, job)?;
        let cuts = self.find_chart_cuts(&mut charts, values, job)?;
        let edges = self.choose_chart_sides(&cuts, values, &job.sub_job(0.0, 0.3))?;
        self.merge_charts_by_vote(&mut charts, &edges, values, &job.sub_job(0.3, 0.7))?;
        let job = job.sub_job(0.7, 1.0);
        for (f, (range, &base)) in self.offsets.windows(2).zip(&self.base_of).enumerate() {
            job.step_every(FACES_PER_REPORT, f, self.base_of.len(), STAGE)?;
            let corners = range[0]..range[1];
            let mut all = corners.clone().flat_map(|corner| self.rim_edges_at(&edges, corner));
            let is_one = base == NONE || all.all(|edge| charts.find(edge) == charts.find(base));
            if is_one
                && !(cuts.has_cuts
                    && base != NONE
                    && self.face_crosses_cut(values, corners.clone(), base, cuts.usual_squared_base_length))
            {
                continue;
            }
            for corner in corners {
                for c in 0..values.components {
                    let value = self.extended_chart_value(values, corner, base, c);
                    values.set(corner as usize, c, value);
                }
            }
        }
        Ok(())
    }

    /// The rim edges whose values are interpolated at a new corner.
    fn rim_edges_at<'a>(&self, edges: &'a [u32], corner: u32) -> impl Iterator<Item = u32> + 'a {
        let own = &edges[self.interpolated_vertices.entry_range((corner - self.offsets[0]) as usize)];
        own.iter().copied().filter(|&edge| edge != NONE)
    }

    /// For each share, the rim edge at whose end it takes its value; [`NONE`] if its vertex is not
    /// on a rim edge. Where charts are cut, interpolates again with the values on the base's side.
    fn choose_chart_sides(&self, cuts: &ChartCuts, values: &mut Output<'_>, job: &Job<'_>) -> Result<Vec<u32>> {
        let mut edges = alloc::filled(NONE, self.interpolated_vertices.source_indices().len())?;
        let mut chosen = Vec::new();
        let first = self.offsets[0];
        for (f, (range, &base)) in self.offsets.windows(2).zip(&self.base_of).enumerate() {
            job.step_every(FACES_PER_REPORT, f, self.base_of.len(), STAGE)?;
            for corner in range[0]..range[1] {
                let places = self.interpolated_vertices.entry_range((corner - first) as usize);
                let mut other = false;
                chosen.clear();
                let shares = self.interpolated_vertices.entries((corner - first) as usize);
                for (edge, (vertex, weight)) in edges[places.clone()].iter_mut().zip(shares) {
                    let ends = self.rim_ends_at(vertex);
                    let Some(usual) = ends.iter().find(|end| end.edge == base).or(ends.first()) else { continue };
                    let (end, jump) = match cuts.has_cuts && usual.edge != base {
                        true => self.nearest_rim_end(values, ends, (corner, base), cuts),
                        false => (usual, None),
                    };
                    other |= end.corner != usual.corner || jump.is_some();
                    *edge = end.edge;
                    alloc::push(&mut chosen, SourceCorner { corner: end.corner, jump, weight })?;
                }
                if other && chosen.len() == places.len() {
                    write_weighted_mean(values, corner, &chosen);
                }
            }
        }
        Ok(edges)
    }

    /// The end at a vertex that is nearest, by its value, to the extended chart of a base at a new
    /// corner. Also returns the jump that leads there, if any.
    fn nearest_rim_end<'a>(
        &self,
        values: &Output<'_>,
        ends: &'a [RimEdgeEnd],
        (corner, base): (u32, u32),
        cuts: &'a ChartCuts,
    ) -> (&'a RimEdgeEnd, Option<&'a [f64]>) {
        let mut best = (f64::INFINITY, &ends[0], None);
        for end in ends {
            for jump in std::iter::once(None).chain(cuts.long_jumps.iter().map(|jump| Some(&jump[..]))) {
                let off = |c| {
                    value_with_jump(values, end.corner, jump, c) - self.extended_chart_value(values, corner, base, c)
                };
                let off: f64 = (0..values.components).map(|c| off(c).powi(2)).sum();
                if off < best.0 {
                    best = (off, end, jump);
                }
            }
        }
        (best.1, best.2)
    }

    /// Finds where charts are cut along the rims.
    fn find_chart_cuts(&self, charts: &mut DisjointSets, values: &Output<'_>, job: &Job<'_>) -> Result<ChartCuts> {
        let mut cuts = ChartCuts {
            has_cuts: false,
            long_jumps: Vec::new(),
            usual_squared_base_length: self.median_squared_base_length(values)?,
        };
        for (k, ends) in self.rim_edge_ends.chunk_by(|a, b| a.vertex == b.vertex).enumerate() {
            job.step_within_list(k, STAGE)?;
            let &[a, b] = ends else { continue };
            // A vertex where different charts meet is not a cut.
            if have_same_values(values, [a.corner, b.corner]) || charts.find(a.edge) != charts.find(b.edge) {
                continue;
            }
            cuts.has_cuts = true;
            let jump = |c| values.get(a.corner as usize, c) - values.get(b.corner as usize, c);
            let size: f64 = (0..values.components).map(|c| jump(c).powi(2)).sum();
            let is_known = |known: &Vec<f64>| {
                let off: f64 = known.iter().enumerate().map(|(c, x)| (jump(c) - x).powi(2)).sum();
                off <= MAX_RELATIVE_JUMP_DIFFERENCE * MAX_RELATIVE_JUMP_DIFFERENCE * size
            };
            let is_long =
                size > MIN_LONG_JUMP_IN_BASE_LENGTHS * MIN_LONG_JUMP_IN_BASE_LENGTHS * cuts.usual_squared_base_length;
            if is_long && cuts.long_jumps.len() < MAX_CHART_JUMPS && !cuts.long_jumps.iter().any(is_known) {
                for sign in [1.0, -1.0] {
                    let there = alloc::collect((0..values.components).map(|c| sign * jump(c)))?;
                    alloc::push(&mut cuts.long_jumps, there)?;
                }
            }
        }
        Ok(cuts)
    }

    /// The median of the squared lengths of bases in values.
    fn median_squared_base_length(&self, values: &Output<'_>) -> Result<f64> {
        let way = |base: &FaceBase| {
            let [from, to, _] = base.corners.map(|corner| corner as usize);
            (0..values.components).map(|c| (values.get(to, c) - values.get(from, c)).powi(2)).sum::<f64>()
        };
        let mut ways = alloc::collect(self.bases.iter().map(way))?;
        let middle = ways.len() / 2;
        Ok(if ways.is_empty() { 0.0 } else { *ways.select_nth_unstable_by(middle, f64::total_cmp).1 })
    }

    fn rim_ends_at(&self, vertex: u32) -> &[RimEdgeEnd] {
        let start = self.rim_edge_ends.partition_point(|end| end.vertex < vertex);
        let count = self.rim_edge_ends[start..].partition_point(|end| end.vertex == vertex);
        &self.rim_edge_ends[start..start + count]
    }

    /// The charts of rim edges, as far as the values at their ends determine them.
    fn charts_along_rims(&self, values: &Output<'_>, job: &Job<'_>) -> Result<DisjointSets> {
        let mut charts = DisjointSets::new(self.bases.len())?;
        let pairs = self.rim_edge_ends.windows(2).filter(|pair| pair[0].vertex == pair[1].vertex);
        for (k, pair) in pairs.enumerate() {
            job.step_within_list(k, STAGE)?;
            if have_same_values(values, [pair[0].corner, pair[1].corner]) {
                charts.union(pair[0].edge, pair[1].edge);
            }
        }
        Ok(charts)
    }

    /// Merges charts if most faces between them vote for it.
    fn merge_charts_by_vote(
        &self,
        charts: &mut DisjointSets,
        edges: &[u32],
        values: &Output<'_>,
        job: &Job<'_>,
    ) -> Result<()> {
        let mut votes = Vec::new();
        for (f, (range, &base)) in self.offsets.windows(2).zip(&self.base_of).enumerate() {
            job.step_every(FACES_PER_REPORT, f, self.base_of.len(), STAGE)?;
            if base == NONE {
                continue;
            }
            let own = charts.find(base);
            for corner in range[0]..range[1] {
                for edge in self.rim_edges_at(edges, corner) {
                    let other = charts.find(edge);
                    if other != own {
                        let agrees = self.is_near_extended_chart(values, corner, base);
                        alloc::push(&mut votes, (own.min(other), own.max(other), agrees))?;
                    }
                }
            }
        }
        let job = job.sub_job(1.0, 1.0);
        sort(&mut votes, Ord::cmp, &job, STAGE)?;
        for (k, between) in votes.chunk_by(|x, y| (x.0, x.1) == (y.0, y.1)).enumerate() {
            job.step_within_list(k, STAGE)?;
            let no = between.partition_point(|vote| !vote.2);
            if between.len() - no > no {
                charts.union(between[0].0, between[0].1);
            }
        }
        Ok(())
    }

    /// Returns true if the attribute value at a new corner is close to the value that extends the
    /// chart across the base edge.
    fn is_near_extended_chart(&self, values: &Output<'_>, corner: u32, base: u32) -> bool {
        let (off, way) = self.squared_deviation_and_distance(values, corner, base);
        off <= MAX_RELATIVE_DEVIATION * MAX_RELATIVE_DEVIATION * way
    }

    /// True if a value of a new face deviates from the extended chart of its base by much more than
    /// the size of faces.
    fn face_crosses_cut(&self, values: &Output<'_>, mut corners: Range<u32>, base: u32, usual: f64) -> bool {
        corners.any(|corner| {
            let (off, way) = self.squared_deviation_and_distance(values, corner, base);
            off > MIN_LONG_JUMP_IN_BASE_LENGTHS * MIN_LONG_JUMP_IN_BASE_LENGTHS * way.max(usual)
        })
    }

    /// Returns two squares: the deviation of the value at a new corner from the extended chart of
    /// its base, and the size of the extension. The size combines the distance of the extended
    /// value from the base with the length of the base.
    fn squared_deviation_and_distance(&self, values: &Output<'_>, corner: u32, base: u32) -> (f64, f64) {
        let FaceBase { corners: [start, end, _] } = self.bases[base as usize];
        let value = |corner: u32, c: usize| values.get(corner as usize, c);
        let (mut off, mut way) = (0.0, 0.0);
        for c in 0..values.components {
            let (there, [from, to]) =
                (self.extended_chart_value(values, corner, base, c), [start, end].map(|at| value(at, c)));
            off += (value(corner, c) - there).powi(2);
            // Values may change only along the base.
            way += (there - f64::midpoint(from, to)).powi(2) + (to - from).powi(2);
        }
        (off, way)
    }

    /// A component of the value at a new corner in the extended chart of its base.
    fn extended_chart_value(&self, values: &Output<'_>, corner: u32, base: u32, c: usize) -> f64 {
        let weights = self.base_corner_weights[(corner - self.offsets[0]) as usize];
        let at = self.bases[base as usize].corners.map(|corner| values.get(corner as usize, c));
        let there: f64 = at.iter().zip(weights).map(|(value, weight)| weight * value).sum();
        // If the extension overflows, it stops at the base.
        if there.is_finite() { there } else { at[0] }
    }
}

impl FaceBase {
    /// Creates the base, with the corner of the face farthest from the line of the edge.
    fn new(mesh: &Mesh, [start, end]: [u32; 2]) -> FaceBase {
        let f = mesh.face_of_corner(start);
        let at = |corner: u32| mesh.positions.get(mesh.corner(corner as usize));
        let (p, way) = (at(start), at(end) - at(start));
        let off = |corner: u32| (at(corner) - p).reject_from_normalized(way.normalize_or_zero()).length_squared();
        let others =
            (mesh.face_offsets[f]..mesh.face_offsets[f + 1]).filter(|&corner| corner != start && corner != end);
        let mut far = (f64::NEG_INFINITY, start);
        for corner in others {
            if off(corner) > far.0 {
                far = (off(corner), corner);
            }
        }
        FaceBase { corners: [start, end, far.1] }
    }
}

/// True if two old corners have the same values.
fn have_same_values(values: &Output<'_>, corners: [u32; 2]) -> bool {
    (0..values.components).all(|c| {
        let [x, y] = corners.map(|corner| values.get(corner as usize, c));
        (x - y).abs() <= MAX_RELATIVE_VALUE_DIFFERENCE * x.abs().max(y.abs())
    })
}

/// A component of the value at an old corner, plus the jump if there is one.
fn value_with_jump(values: &Output<'_>, corner: u32, jump: Option<&[f64]>, c: usize) -> f64 {
    values.get(corner as usize, c) + jump.map_or(0.0, |jump| jump[c])
}

/// Writes the weighted mean of old corners to a new one.
fn write_weighted_mean(values: &mut Output<'_>, corner: u32, of: &[SourceCorner<'_>]) {
    let total: f64 = of.iter().map(|side| side.weight).sum();
    for c in 0..values.components {
        let at = |side: &SourceCorner<'_>| value_with_jump(values, side.corner, side.jump, c);
        // Relative to the first value, so that equal values stay unchanged.
        let first = at(&of[0]);
        let off: f64 = of.iter().map(|side| side.weight * (at(side) - first)).sum();
        values.set(corner as usize, c, first + off / total);
    }
}

/// The affine weights of the corners `[p, q, r]` of an old face at a point beyond its base.
fn affine_weights_beyond_base([p, q, r]: [DVec3; 3], at: DVec3) -> [f64; 3] {
    let unit = common_unit(&[p - r, q - r, at - r]);
    let [p, q, at] = [p, q, at].map(|point| (point - r) / unit);
    let (length, along) = (p.distance(q), (q - p).normalize_or_zero());
    let plane = |point: DVec3| {
        let x = (point - p).dot(along);
        (x, (point - p - x * along).length())
    };
    let ((x, y), (far_x, height)) = (plane(at), plane(DVec3::ZERO));
    let third = if height > MIN_RELATIVE_HEIGHT * length { -(y / height).min(MAX_EXTENSION_HEIGHTS) } else { 0.0 };
    let second = (x - third * far_x) / length;
    if second.is_finite() { [1.0 - second - third, second, third] } else { [0.5, 0.5, 0.0] }
}
