//! The parts into which curves cut a hole.

use super::super::patch_rim::{OldFaces, PatchRim};
use super::crease_bridges::CreaseBridge;
use super::crease_ends::{CreaseAlongRim, CreaseEnd, RimCorners};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::sort::sort_distinct;
use gusset_mesh::NONE;

/// The curves of a vertex that lies on no curve.
const NO_CURVES_OF_VERTEX: [u32; 2] = [NONE; 2];

/// A part of a hole.
pub(in super::super) struct HolePart {
    /// The part's rim, along the hole's rim and along curves, in the unit of the hole. It knows
    /// only the old triangles on its own side of the creases.
    pub(in super::super) rim: PatchRim,
    /// For each vertex of the part's rim, its number on the hole's rim, or after those the number
    /// of a curve's vertex.
    pub(in super::super) names: Vec<u32>,
    /// The curves that each vertex lies on.
    curves_of_vertices: Vec<[u32; 2]>,
    /// The number of vertices of the hole's rim.
    count: usize,
}

impl HolePart {
    /// Returns true if two vertices of the part's rim must not get an edge: `taken` vertices of the
    /// hole's rim, or two vertices of one curve, because the part across the curve has these too.
    pub(in super::super) fn is_taken_edge(&self, u: u32, v: u32, taken: &dyn Fn(u32, u32) -> bool) -> bool {
        let [of_u, of_v] = [u, v].map(|v| self.curves_of_vertices[v as usize]);
        let on_one = of_u.iter().any(|curve| *curve != NONE && of_v.contains(curve));
        let [u, v] = [u, v].map(|v| self.names[v as usize]);
        on_one || (u.max(v) as usize) < self.count && taken(u, v)
    }
}

/// The rim, the creases and the bridges that the outlines of parts follow.
pub(super) struct PartOutlines<'a> {
    pub(super) rim: &'a PatchRim,
    pub(super) corners: &'a RimCorners,
    pub(super) ends: &'a [CreaseEnd],
    pub(super) along_rim: &'a [CreaseAlongRim],
    /// The bridge of each end, if it has one.
    pub(super) bridges: &'a [Option<CreaseBridge>],
}

impl PartOutlines<'_> {
    /// Returns the parts between bridges, or one part for the whole rim if it only touches creases.
    ///
    /// Returns `None` without parts, or if a part has only vertices on creases. `points` are the
    /// vertices of the curves. O(n) per part for n old vertices.
    pub(super) fn build_parts(&self, points: &[DVec3]) -> Result<Option<Vec<HolePart>>> {
        let count = self.rim.rim_vertex_count;
        // For each rim vertex, the end that has it as its tip or that follows the rim there.
        let mut end_at = alloc::filled(None, count)?;
        for (k, end) in self.ends.iter().enumerate().filter(|&(k, _)| self.bridges[k].is_some()) {
            end.rim_vertices_along_crease(count).for_each(|v| end_at[v] = Some(k));
        }
        let at = |v: usize| end_at[v].and_then(|k: usize| Some((&self.ends[k], self.bridges[k].as_ref()?)));
        let mut crease_at = alloc::filled(None, count)?;
        for (k, crease) in self.along_rim.iter().enumerate() {
            crease.rim_vertices_along_crease(count).for_each(|v| crease_at[v] = Some(k));
        }
        let mut parts = Vec::new();
        if self.bridges.iter().all(Option::is_none) && !self.along_rim.is_empty() {
            let mut outline = PartOutline::new(self);
            (0..count).try_for_each(|v| outline.follow_rim(v, crease_at[v]))?;
            alloc::push(&mut parts, outline)?;
        }
        let mut is_used = alloc::filled(false, self.ends.len())?;
        for first in 0..self.ends.len() {
            let mut outline = PartOutline::new(self);
            let mut start = first;
            while let (false, Some(leaving)) = (is_used[start], &self.bridges[start]) {
                is_used[start] = true;
                outline.enter_hole_rim(&self.ends[start], leaving.curve)?;
                let mut v = (self.ends[start].tip_vertex + 1) % count;
                let (end, bridge) = loop {
                    match at(v) {
                        Some((end, bridge)) if v == end.tip_vertex => break (end, bridge),
                        Some((end, bridge)) => outline.follow_crease(v, end, bridge.curve)?,
                        None => outline.follow_rim(v, crease_at[v])?,
                    }
                    v = (v + 1) % count;
                };
                outline.leave_hole_rim(end, bridge.curve)?;
                outline.follow_bridge(&bridge.inner_vertices)?;
                start = bridge.other_end;
            }
            if !outline.hole_vertex_numbers.is_empty() {
                alloc::push(&mut parts, outline)?;
            }
        }
        if parts.is_empty() || !parts.iter().all(|outline| outline.curves_of_vertices.contains(&NO_CURVES_OF_VERTEX)) {
            return Ok(None);
        }
        alloc::try_collect(parts.into_iter().map(|outline| outline.build_part(points))).map(Some)
    }
}

/// The rim of a part under construction.
struct PartOutline<'a> {
    rim: &'a PatchRim,
    corners: &'a RimCorners,
    along_rim: &'a [CreaseAlongRim],
    hole_vertex_numbers: Vec<u32>,
    curves_of_vertices: Vec<[u32; 2]>,
    /// The old triangles on this side of the creases.
    old_triangles: Vec<u32>,
}

impl<'a> PartOutline<'a> {
    fn new(&PartOutlines { rim, corners, along_rim, .. }: &PartOutlines<'a>) -> Self {
        PartOutline {
            rim,
            corners,
            along_rim,
            hole_vertex_numbers: Vec::new(),
            curves_of_vertices: Vec::new(),
            old_triangles: Vec::new(),
        }
    }

    fn push_vertex(&mut self, name: usize, curves: [u32; 2]) -> Result<()> {
        alloc::push(&mut self.hole_vertex_numbers, name as u32)?;
        alloc::push(&mut self.curves_of_vertices, curves)
    }

    fn push_faces_at(&mut self, v: usize) -> Result<()> {
        alloc::extend(&mut self.old_triangles, self.corners.get(v).iter().map(|&(t, _, _)| t))
    }

    /// Appends a vertex of the hole's rim, which may lie on a crease along the rim.
    fn follow_rim(&mut self, v: usize, crease: Option<usize>) -> Result<()> {
        let Some(k) = crease else {
            self.push_vertex(v, NO_CURVES_OF_VERTEX)?;
            return self.push_faces_at(v);
        };
        // Touches are numbered downwards, because curves are numbered from 0 upwards.
        self.push_vertex(v, [NONE - 1 - k as u32, NONE])?;
        let crease = &self.along_rim[k];
        if v == crease.first_vertex {
            alloc::append(&mut self.old_triangles, &crease.triangles_at_ends[0])?;
        }
        if v == (crease.first_vertex + crease.edge_count) % self.rim.rim_vertex_count {
            alloc::append(&mut self.old_triangles, &crease.triangles_at_ends[1])?;
        }
        Ok(())
    }

    /// Appends a vertex of the hole's rim at which the rim follows a crease.
    fn follow_crease(&mut self, v: usize, end: &CreaseEnd, curve: u32) -> Result<()> {
        self.push_vertex(v, [curve, NONE])?;
        let side = usize::from(end.following_rim_edges < 0);
        if v == end.base_vertex { alloc::append(&mut self.old_triangles, &end.triangles_beside[side]) } else { Ok(()) }
    }

    /// Appends the tip of the end at which the part's outline enters the hole's rim.
    fn enter_hole_rim(&mut self, end: &CreaseEnd, curve: u32) -> Result<()> {
        self.push_vertex(end.tip_vertex, [curve, NONE])?;
        if end.following_rim_edges > 0 {
            self.push_faces_at(end.tip_vertex)
        } else {
            alloc::append(&mut self.old_triangles, &end.triangles_beside[1])
        }
    }

    /// Appends the tip of the end at which the part's outline leaves the hole's rim.
    fn leave_hole_rim(&mut self, end: &CreaseEnd, curve: u32) -> Result<()> {
        self.push_vertex(end.tip_vertex, [curve, NONE])?;
        if end.following_rim_edges < 0 {
            self.push_faces_at(end.tip_vertex)
        } else {
            alloc::append(&mut self.old_triangles, &end.triangles_beside[0])
        }
    }

    /// Appends the inner vertices of a bridge.
    fn follow_bridge(&mut self, inner: &[(u32, [u32; 2])]) -> Result<()> {
        inner.iter().try_for_each(|&(name, curves)| self.push_vertex(name as usize, curves))
    }

    /// Builds the part inside this outline. O(n) for n old vertices.
    fn build_part(mut self, points: &[DVec3]) -> Result<HolePart> {
        let (rim, count, n) = (self.rim, self.rim.rim_vertex_count, self.hole_vertex_numbers.len());
        let mut numbers = alloc::filled(NONE, rim.points.len())?;
        let mut own = alloc::with_capacity(n + rim.points.len())?;
        for (k, &name) in self.hole_vertex_numbers.iter().enumerate() {
            let name = name as usize;
            own.push(if name < count { rim.points[name] } else { points[name - count] });
            if name < count {
                numbers[name] = k as u32;
            }
        }
        let is_own = |v: u32| (v as usize) < count && numbers[v as usize] != NONE;
        let mut sides = alloc::gather(rim.first_ring_sides.iter().copied().filter(|&(u, v)| is_own(u) || is_own(v)))?;
        let mut number = |v: u32| {
            let number = &mut numbers[v as usize];
            if *number == NONE {
                *number = own.len() as u32;
                own.push(rim.points[v as usize]);
            }
            *number
        };
        sort_distinct(&mut self.old_triangles);
        let around = alloc::collect(self.old_triangles.iter().map(|&t| rim.first_ring[t as usize].map(&mut number)))?;
        sides.iter_mut().for_each(|(u, v)| (*u, *v) = (number(*u), number(*v)));
        let mut is_near = alloc::filled(false, rim.points.len())?;
        self.old_triangles
            .iter()
            .for_each(|&t| rim.first_ring[t as usize].iter().for_each(|&v| is_near[v as usize] = true));
        let next_to = rim.second_ring_triangles.iter().filter(|triangle| triangle.iter().any(|&v| is_near[v as usize]));
        let beyond = alloc::gather(next_to.map(|triangle| triangle.map(&mut number)))?;
        let mut across = alloc::with_capacity(n)?;
        for (k, &name) in self.hole_vertex_numbers.iter().enumerate() {
            let next = (k + 1) % n;
            let is_crease = self.curves_of_vertices[k]
                .iter()
                .any(|curve| *curve != NONE && self.curves_of_vertices[next].contains(curve));
            across.push(if is_crease { DVec3::ZERO } else { rim.normals_across_edges[name as usize] });
            if is_crease {
                alloc::push(&mut sides, (k as u32, next as u32))?;
            }
        }
        let is_whole = |(&name, &curves): (&u32, &[u32; 2])| {
            curves == NO_CURVES_OF_VERTEX && rim.has_complete_one_ring[name as usize]
        };
        let whole = alloc::collect(self.hole_vertex_numbers.iter().zip(&self.curves_of_vertices).map(is_whole))?;
        let part = rim.rim_of_part(
            own,
            OldFaces { first_ring: around, second_ring_triangles: beyond, first_ring_sides: sides },
            across,
            whole,
        )?;
        Ok(HolePart { rim: part, names: self.hole_vertex_numbers, curves_of_vertices: self.curves_of_vertices, count })
    }
}
