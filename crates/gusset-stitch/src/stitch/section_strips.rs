//! Strips between rims with common points: one strip for each section between two of them.
//!
//! A **section** is a run of rim A and a run of rim B between two common points, or between a common
//! point and an end of an arc. If both runs are one edge, the edges are already one. Otherwise the
//! run with fewer edges takes the common points, and the other run has the vertices between them. So
//! the strip begins and ends at edges of the other rim, and leaves nothing open.
//!
//! A common point gets one triangle of each section whose runs both have inner vertices. A fan there
//! might repeat an edge of a piece, or of another section.

use super::attach_strip::AttachedStrips;
use super::combine::{append_strip, strips_as_mesh};
use super::existing_edges::ExistingEdges;
use super::fair_and_check::{CheckedStrip, fair_and_check};
use super::meridian::{MeridianEnds, Meridians};
use super::stitch_request::{Finish, Intersections, Options, Rows};
use super::stitch_rim::Rim;
use super::strip::Strip;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::Mesh;

/// Runs of both rims from one pair of places to another.
#[derive(Clone, Copy)]
struct Section {
    first: MeridianEnds,
    /// The number of edges of each run.
    edges: [u32; 2],
    /// True if the runs have their first point in common, and their last point.
    has_common_end: [bool; 2],
}

impl Section {
    /// Returns true if both runs are one edge with common ends.
    fn is_one_edge(&self) -> bool {
        self.edges == [1, 1] && self.has_common_end == [true, true]
    }

    /// Returns the rim whose run takes the common points: the one with fewer edges.
    fn rim_with_ends(&self) -> usize {
        usize::from(self.edges[1] < self.edges[0])
    }

    /// Returns the places of the run of rim `k` in the strip: the first place, and the count.
    fn strip_run(&self, k: usize) -> (u32, u32) {
        let [first, last] = self.has_common_end.map(|common| u32::from(common && k != self.rim_with_ends()));
        (self.first[k] + first, self.edges[k] + 1 - first - last)
    }

    /// Returns both sides of the strip, side by side: the run with the common points, with its
    /// surface on the left, and the other run, with its surface on the right.
    fn strip_sides(&self, rims: [&Rim; 2]) -> Result<[Rim; 2]> {
        let own = self.rim_with_ends();
        let side = |k: usize| {
            let (first, count) = self.strip_run(k);
            rims[k].arc_of_run(first as usize % rims[k].vertices.len(), count as usize)
        };
        let mut sides = [side(own)?, side(1 - own)?];
        if own == 1 {
            sides.iter_mut().for_each(Rim::reverse);
        }
        Ok(sides)
    }

    /// Appends the meridians of the section, except its common first point: the meridians of its strip,
    /// as places on the rims, and the common last point.
    fn append_meridians(&self, strip: Option<&Strip>, all: &mut Vec<MeridianEnds>) -> Result<()> {
        if let Some(strip) = strip {
            let own = self.rim_with_ends();
            let [(start, count), (other, others)] = [own, 1 - own].map(|k| self.strip_run(k));
            let place = |&[x, y]: &MeridianEnds| match own {
                0 => [start + x, other + y],
                _ => [other + others - 1 - y, start + count - 1 - x],
            };
            let before = all.len();
            alloc::extend(all, strip.meridians.iter().map(place))?;
            if own == 1 {
                all[before..].reverse();
            }
        }
        let last = [0, 1].map(|k| self.first[k] + self.edges[k]);
        if self.has_common_end[1] { alloc::push(all, last) } else { Ok(()) }
    }
}

/// Returns the sections between common points. On closed rims, the first common point is (0, 0).
fn divide_into_sections(common: &[MeridianEnds], rims: [&Rim; 2]) -> Result<Vec<Section>> {
    let last = rims.map(Rim::segment_count);
    let mut points = alloc::with_capacity(common.len() + 2)?;
    if common[0] != [0, 0] {
        points.push(([0, 0], false));
    }
    points.extend(common.iter().map(|&point| (point, true)));
    if common[common.len() - 1] != last {
        points.push((last, rims[0].closed));
    }
    alloc::collect(points.windows(2).map(|ends| Section {
        first: ends[0].0,
        edges: [0, 1].map(|k| ends[1].0[k] - ends[0].0[k]),
        has_common_end: [ends[0].1, ends[1].1],
    }))
}

/// Builds the strips between two rims that run side by side and have the points `common`, whose
/// vertices are merged. Appends the strips to `whole`.
///
/// # Errors
/// [`Error::NoStrip`], [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`].
pub(super) fn attach_section_strips(
    whole: &mut Mesh,
    [mut a, mut b]: [Rim; 2],
    mut common: Vec<MeridianEnds>,
    unit: f64,
    options: &Options,
    job: &Job<'_>,
) -> Result<AttachedStrips> {
    job.note(&format!("points that the rims have in common: {}; their vertices were merged", common.len()));
    if !matches!(options.rows, Rows::None | Rows::Count(0)) {
        job.note("a strip between rims with points in common has no rows");
    }
    let closed = a.closed;
    if closed {
        let ([i, j], n, m) = (common[0], a.segment_count(), b.segment_count());
        a.rotate_to_start_at(i as usize);
        b.rotate_to_start_at(j as usize);
        common.iter_mut().for_each(|point| *point = [(point[0] + n - i) % n, (point[1] + m - j) % m]);
    }
    let sections = divide_into_sections(&common, [&a, &b])?;
    let edges = RimEdges::new(whole, [&a, &b])?;
    let how = Options { rows: Rows::None, ..*options };
    let (first_vertex, first_face) = (whole.positions.len() as u32, whole.face_count() as u32);
    let mut checked = CheckedStrip { intersections: None, back_offs: 0, finish: Finish::Strip };
    let (mut meridians, mut parents, mut weights) = (Vec::new(), Vec::new(), Vec::new());
    let mut pairs = Vec::new();
    if sections.first().is_none_or(|section| section.has_common_end[0]) {
        alloc::push(&mut meridians, [0, 0])?;
    }
    for (k, section) in sections.iter().enumerate() {
        let part = job.sub_job_of_item(k, sections.len());
        if section.is_one_edge() {
            section.append_meridians(None, &mut meridians)?;
            continue;
        }
        let sides = section.strip_sides([&a, &b])?;
        let existing = edges.existing_edges(section, &sides)?;
        let mut strip = build_strip(sides, &existing, &how, &part.sub_job(0.0, 0.6))?;
        let found = fair_and_check(whole, &mut strip, unit, &existing, &how, &part.sub_job(0.6, 1.0))?;
        let attached = append_strip(whole, &strip, unit)?;
        section.append_meridians(Some(&strip), &mut meridians)?;
        let name = |v: u32| attached.mesh_vertex_of_strip_vertex[v as usize];
        alloc::extend(&mut parents, strip.parents.iter().map(|parents| parents.vertices.map(name)))?;
        alloc::extend(&mut weights, strip.parents.iter().map(|parents| parents.weights))?;
        alloc::append(&mut pairs, found.intersections.as_deref().unwrap_or_default())?;
        checked.back_offs = checked.back_offs.max(found.back_offs);
        if found.finish == Finish::Blend {
            checked.finish = Finish::Blend;
        }
    }
    if options.intersections != Intersections::Ignore {
        sort_distinct(&mut pairs);
        checked.intersections = Some(pairs);
    }
    let on_rim = |rim: &Rim, place: u32| rim.vertices[place as usize % rim.vertices.len()];
    let [row_a, row_b] = [(&a, 0), (&b, 1)].map(|(rim, k)| meridians.iter().map(move |ends| on_rim(rim, ends[k])));
    let mut matrix = alloc::collect(row_a)?;
    alloc::extend(&mut matrix, row_b)?;
    let strip = strips_as_mesh(whole, [&a.vertices, &b.vertices], first_vertex, first_face)?;
    let faces = first_face..whole.face_count() as u32;
    Ok(AttachedStrips {
        strip,
        faces,
        rims: [a.vertices, b.vertices],
        closed,
        meridians,
        matrix,
        parents,
        weights,
        checked,
    })
}

/// Builds the strip of a section. A rule that ignores existing edges gives way to the shortest
/// meridians.
fn build_strip(sides: [Rim; 2], existing: &ExistingEdges, options: &Options, job: &Job<'_>) -> Result<Strip> {
    let [a, b] = sides;
    let copies = [a.try_clone()?, b.try_clone()?];
    match Strip::build(a, b, existing, options, || 1.0, job) {
        Err(Error::NoStrip { .. }) if options.meridians == Meridians::Index => {
            let [a, b] = copies;
            let shortest = Options { meridians: Meridians::MinDiagonal, ..*options };
            Strip::build(a, b, existing, &shortest, || 1.0, job)
        }
        built => built,
    }
}

/// The edges of the mesh between vertices of both rims, each listed from both ends, ascending.
struct RimEdges(Vec<(u32, u32)>);

impl RimEdges {
    fn new(mesh: &Mesh, rims: [&Rim; 2]) -> Result<Self> {
        let mut on_rim = alloc::filled(false, mesh.positions.len())?;
        rims.iter().flat_map(|rim| &rim.vertices).for_each(|&v| on_rim[v as usize] = true);
        let mut edges = Vec::new();
        for face in mesh.faces() {
            for (k, &u) in face.iter().enumerate() {
                let v = face[(k + 1) % face.len()];
                if on_rim[u as usize] && on_rim[v as usize] {
                    alloc::extend(&mut edges, [(u, v), (v, u)])?;
                }
            }
        }
        sort_distinct(&mut edges);
        Ok(RimEdges(edges))
    }

    /// Returns the edges that the strip of a section must not repeat. The edges at common points,
    /// which bound the strip, are not among them.
    fn existing_edges(&self, section: &Section, sides: &[Rim; 2]) -> Result<ExistingEdges> {
        let [a, b] = sides.each_ref().map(|side| &side.vertices);
        let mut common = section.has_common_end;
        if section.rim_with_ends() == 1 {
            common.reverse();
        }
        let ends = [(a[0], b[0]), (a[a.len() - 1], b[b.len() - 1])];
        let bounds = |edge: &(u32, u32)| (0..2).any(|k| common[k] && ends[k] == *edge);
        let mut on_b = alloc::copied(b)?;
        sort_distinct(&mut on_b);
        let mut edges = Vec::new();
        for &u in a {
            let from = self.0.partition_point(|&(v, _)| v < u);
            let of_u = self.0[from..].iter().take_while(|&&(v, _)| v == u);
            let there = of_u.filter(|edge| on_b.binary_search(&edge.1).is_ok() && !bounds(edge)).copied();
            alloc::extend(&mut edges, there)?;
        }
        sort_distinct(&mut edges);
        let has_inner_vertices = section.edges.iter().all(|&edges| edges > 1);
        Ok(ExistingEdges::from_edges(edges).without_fans(common.map(|end| end && has_inner_vertices)))
    }
}
