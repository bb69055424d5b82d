//! Recognition of a rectangular grid in a mesh of triangles: quads with one diagonal each, in any
//! direction, and fans around poles.
//!
//! Each edge is labelled as a side or a diagonal by counting rules. A triangle has one diagonal, or
//! none at a pole. An inner vertex with T triangles has T - 4 diagonals, because four quads remain
//! when diagonals are removed. A vertex on the border has T - 2 diagonals, or T - 1 at a corner of
//! the grid. Labels that follow from these rules are propagated until none is left.
//!
//! At the border or next to a pole, one label determines all others, along the first row and then
//! row by row, so two attempts suffice. A torus has neither. There, a label that leads to a
//! contradiction is undone and set the other way, and a label that does not is kept. A torus with
//! irregular diagonals may therefore be rejected. Finally the quads are verified like the quads of
//! any
//! mesh, so only grids are accepted. O(edges) an attempt.

use super::grid::{RecognisedNet, net_of_grid};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort::Buckets;
use gusset_mesh::{Faces, MeshView, NONE, Opposite, Topology as Pairing};

/// Half-edges between two progress reports.
const HALF_EDGES_PER_REPORT: usize = 1 << 15;
const STAGE: &str = "triangles to cells";
/// A sphere with at most this many vertices, whose poles are not evident from their degrees, is
/// tried with every vertex as a pole. A larger sphere is tried only with the two vertices that are
/// farthest apart.
const MAX_POLE_TRIALS: usize = 400;

/// The label of an edge.
#[derive(Clone, Copy, PartialEq, Eq)]
enum EdgeLabel {
    Unknown,
    Side,
    Diagonal,
}

/// Returns the net whose cells are pairs of triangles of a mesh. `face_of_cell` has the first
/// triangle of each cell; at poles a cell is one triangle. All vertices keep their bits. Several
/// pairings may form a grid, for example if all diagonals are parallel. Then the first triangle
/// with a side decides: its first possible edge is the diagonal.
///
/// # Errors
/// [`Error::NoGrid`] with a triangle at the first contradiction, [`Error::OutOfMemory`],
/// [`Error::Cancelled`].
pub fn net_of_triangles(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<RecognisedNet> {
    let faces = mesh.faces();
    if let Some(face) = (0..faces.len()).find(|&f| faces.corner_range(f).len() != 3) {
        return Err(Error::NoGrid { face: face as u32 });
    }
    let pairing = Pairing::new(mesh, &job.sub_job(0.0, 0.4))?;
    let surface = TriangleSurface::new(mesh, &pairing)?;
    let mut refused = Error::NoGrid { face: 0 };
    let candidates = surface.pole_candidates()?;
    for (k, poles) in candidates.iter().enumerate() {
        let job = job.sub_job(0.4, 1.0).sub_job_of_item(k, candidates.len());
        job.step(0.0, STAGE)?;
        match surface.recognise_with_poles(mesh, *poles, &job) {
            Err(Error::NoGrid { face }) => refused = Error::NoGrid { face },
            found => return found,
        }
    }
    Err(refused)
}

/// A mesh of triangles: half-edge 3 f + k runs from corner k of face f.
struct TriangleSurface {
    /// The half-edge on the other side; `NONE` at the border.
    mates: Vec<u32>,
    start_vertices: Vec<u32>,
    /// For each vertex its edges, each by its smaller half-edge.
    edges_of_vertex: Buckets<u32>,
    /// For each vertex the number of its triangles, and whether it is on the border.
    triangle_counts: Vec<u32>,
    on_border: Vec<bool>,
}

impl TriangleSurface {
    fn new(mesh: &MeshView<'_>, pairing: &Pairing) -> Result<Self> {
        let (count, vertices) = (mesh.faces().half_edge_count() as u32, mesh.positions().len());
        let starts = alloc::collect((0..count as usize).map(|h| mesh.faces().corner(h as u32)))?;
        let (mut counts, mut on_border) = (alloc::filled(0u32, vertices)?, alloc::filled(false, vertices)?);
        let mut mates = alloc::with_capacity(count as usize)?;
        for h in 0..count {
            let (start, end) = (starts[h as usize], starts[next_half_edge(h) as usize]);
            counts[start as usize] += 1;
            let mate = match pairing.opposite(h) {
                _ if pairing.is_ignored(h) => return Err(no_grid_error(h)),
                Opposite::Singular => return Err(no_grid_error(h)),
                Opposite::Mate(mate) if starts[mate as usize] == start => return Err(no_grid_error(mate)),
                Opposite::Mate(mate) => mate,
                Opposite::Free => NONE,
            };
            if mate == NONE {
                (on_border[start as usize], on_border[end as usize]) = (true, true);
            }
            mates.push(mate);
        }
        let whole = (0..count).filter(|&h| h < mates[h as usize]);
        let ends =
            whole.flat_map(|h| [(starts[h as usize] as usize, h), (starts[next_half_edge(h) as usize] as usize, h)]);
        let edges = Buckets::new(vertices, 0, ends.clone())?;
        Ok(TriangleSurface {
            mates,
            start_vertices: starts,
            edges_of_vertex: edges,
            triangle_counts: counts,
            on_border,
        })
    }

    fn end_vertices(&self, h: u32) -> [u32; 2] {
        [self.start_vertices[h as usize], self.start_vertices[next_half_edge(h) as usize]]
    }

    /// Returns the smallest and the largest number of diagonals at a vertex that is not a pole.
    /// Returns `None` if the vertex cannot belong to a grid.
    fn diagonal_count_range(&self, v: u32) -> Option<[u32; 2]> {
        match (self.on_border[v as usize], self.triangle_counts[v as usize]) {
            (_, 0) | (true, 1) => Some([0, 0]),
            (true, 2) => Some([0, 1]),
            (true, count @ 3..=4) => Some([count - 2; 2]),
            (false, count @ 4..=8) => Some([count - 4; 2]),
            _ => None,
        }
    }

    /// Returns the poles to try: the poles that the degrees show, otherwise none, and then the
    /// farthest vertices.
    fn pole_candidates(&self) -> Result<Vec<[u32; 2]>> {
        let vertices = 0..self.triangle_counts.len() as u32;
        let mut odd = vertices.clone().filter(|&v| self.diagonal_count_range(v).is_none());
        let (first, second) = (odd.next(), odd.next());
        if let Some(third) = odd.next() {
            let h =
                (0..self.start_vertices.len() as u32).find(|&h| self.start_vertices[h as usize] == third).unwrap_or(0);
            return Err(no_grid_error(h));
        }
        let border = || vertices.clone().filter(|&v| self.on_border[v as usize]);
        let is_open = border().next().is_some();
        let mut found = Vec::new();
        match (first, second) {
            (Some(first), Some(second)) => alloc::push(&mut found, [first, second])?,
            (Some(first), None) => {
                if is_open {
                    alloc::push(&mut found, [first, NONE])?;
                }
                alloc::push(&mut found, [first, self.farthest_vertex(std::iter::once(first))?])?;
            }
            _ => {
                alloc::push(&mut found, [NONE; 2])?;
                if is_open {
                    // Every row is one step farther from the border than the previous row.
                    alloc::push(&mut found, [self.farthest_vertex(border())?, NONE])?;
                } else {
                    let used = || vertices.clone().filter(|&v| self.triangle_counts[v as usize] > 0);
                    let first = self.farthest_vertex(used().take(1))?;
                    alloc::push(&mut found, [first, self.farthest_vertex(std::iter::once(first))?])?;
                    if used().count() <= MAX_POLE_TRIALS {
                        for v in used() {
                            alloc::push(&mut found, [v, self.farthest_vertex(std::iter::once(v))?])?;
                        }
                    }
                }
            }
        }
        Ok(found)
    }

    /// Returns the vertex farthest from some others by edges, the first of several.
    fn farthest_vertex(&self, from: impl Iterator<Item = u32>) -> Result<u32> {
        let mut steps = alloc::filled(NONE, self.triangle_counts.len())?;
        let mut list = alloc::gather(from)?;
        list.iter().for_each(|&v| steps[v as usize] = 0);
        let (mut done, mut last) = (0, list.first().copied().unwrap_or(0));
        while let Some(&v) = list.get(done) {
            done += 1;
            if steps[v as usize] > steps[last as usize] || (steps[v as usize] == steps[last as usize] && v < last) {
                last = v;
            }
            for &h in self.edges_of_vertex.get(v as usize) {
                for other in self.end_vertices(h) {
                    if steps[other as usize] == NONE {
                        steps[other as usize] = steps[v as usize] + 1;
                        alloc::push(&mut list, other)?;
                    }
                }
            }
        }
        Ok(last)
    }

    /// Returns the grid with these poles. Tries each diagonal of the first unlabelled triangle.
    fn recognise_with_poles(&self, mesh: &MeshView<'_>, poles: [u32; 2], job: &Job<'_>) -> Result<RecognisedNet> {
        let mut labels = EdgeLabels::new(self, poles)?;
        labels.propagate_labels(job)?;
        let Some(face) = labels.next_undecided_face(0) else {
            return labels.build_net(mesh, job);
        };
        let (mark, mut refused) = (labels.labelled_edges.len(), no_grid_error(3 * face));
        for h in 3 * face..3 * face + 3 {
            labels.undo_labels_after(mark);
            if labels.label_of_half_edge[h as usize] != EdgeLabel::Unknown {
                continue;
            }
            match labels.decide_from_diagonal(h, job).and_then(|()| labels.build_net(mesh, job)) {
                Err(Error::NoGrid { face }) => refused = Error::NoGrid { face },
                found => return found,
            }
        }
        Err(refused)
    }
}

/// Returns the next half-edge of a triangle.
fn next_half_edge(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

fn no_grid_error(h: u32) -> Error {
    Error::NoGrid { face: h / 3 }
}

/// The label of each edge (side or diagonal of a quad), by half-edge, and the queue of labelled
/// edges whose neighbours are still to be checked.
struct EdgeLabels<'a> {
    surface: &'a TriangleSurface,
    poles: [u32; 2],
    label_of_half_edge: Vec<EdgeLabel>,
    /// The edges that were labelled, in order.
    labelled_edges: Vec<u32>,
    /// The number of labels that have been propagated.
    propagated_label_count: usize,
    /// For each vertex the number of its diagonals, and of its unlabelled edges.
    diagonal_counts: Vec<u32>,
    unlabelled_counts: Vec<u32>,
}

impl<'a> EdgeLabels<'a> {
    /// Labels the edges at the border and at poles as sides.
    fn new(surface: &'a TriangleSurface, poles: [u32; 2]) -> Result<Self> {
        let (count, vertices) = (surface.start_vertices.len(), surface.triangle_counts.len());
        let mut labels = EdgeLabels {
            surface,
            poles,
            label_of_half_edge: alloc::filled(EdgeLabel::Unknown, count)?,
            labelled_edges: Vec::new(),
            propagated_label_count: 0,
            diagonal_counts: alloc::filled(0, vertices)?,
            unlabelled_counts: alloc::collect((0..vertices).map(|v| surface.edges_of_vertex.get(v).len() as u32))?,
        };
        for h in 0..count as u32 {
            if surface.mates[h as usize] == NONE {
                labels.label_of_half_edge[h as usize] = EdgeLabel::Side;
            } else if labels.is_pole_triangle(h / 3) {
                labels.set_label(h, EdgeLabel::Side)?;
            }
        }
        for v in 0..vertices as u32 {
            labels.apply_vertex_rule(v)?;
        }
        for face in 0..count as u32 / 3 {
            labels.apply_face_rule(face)?;
        }
        Ok(labels)
    }

    /// Returns true for a triangle at a pole.
    fn is_pole_triangle(&self, face: u32) -> bool {
        (3 * face..3 * face + 3).any(|h| self.poles.contains(&self.surface.start_vertices[h as usize]))
    }

    /// Labels an edge; [`Error::NoGrid`] if it has another label.
    fn set_label(&mut self, h: u32, label: EdgeLabel) -> Result<()> {
        let before = self.label_of_half_edge[h as usize];
        if before != EdgeLabel::Unknown {
            return if before == label { Ok(()) } else { Err(no_grid_error(h)) };
        }
        for end in self.surface.end_vertices(h) {
            self.unlabelled_counts[end as usize] -= 1;
            self.diagonal_counts[end as usize] += u32::from(label == EdgeLabel::Diagonal);
        }
        (self.label_of_half_edge[h as usize], self.label_of_half_edge[self.surface.mates[h as usize] as usize]) =
            (label, label);
        alloc::push(&mut self.labelled_edges, h)
    }

    /// Removes labels until `mark` are left.
    fn undo_labels_after(&mut self, mark: usize) {
        while self.labelled_edges.len() > mark {
            let Some(h) = self.labelled_edges.pop() else { return };
            for end in self.surface.end_vertices(h) {
                self.unlabelled_counts[end as usize] += 1;
                self.diagonal_counts[end as usize] -=
                    u32::from(self.label_of_half_edge[h as usize] == EdgeLabel::Diagonal);
            }
            (self.label_of_half_edge[h as usize], self.label_of_half_edge[self.surface.mates[h as usize] as usize]) =
                (EdgeLabel::Unknown, EdgeLabel::Unknown);
        }
        self.propagated_label_count = mark;
    }

    /// Propagates the existing labels.
    fn propagate_labels(&mut self, job: &Job<'_>) -> Result<()> {
        while let Some(&h) = self.labelled_edges.get(self.propagated_label_count) {
            job.step_every(HALF_EDGES_PER_REPORT, self.propagated_label_count, self.label_of_half_edge.len(), STAGE)?;
            self.propagated_label_count += 1;
            self.apply_face_rule(h / 3)?;
            self.apply_face_rule(self.surface.mates[h as usize] / 3)?;
            let [a, b] = self.surface.end_vertices(h);
            self.apply_vertex_rule(a)?;
            self.apply_vertex_rule(b)?;
        }
        Ok(())
    }

    /// Applies the rule of a triangle: exactly one of its sides is the diagonal of a quad. At a
    /// pole, none is.
    fn apply_face_rule(&mut self, face: u32) -> Result<()> {
        let sides = 3 * face..3 * face + 3;
        let count =
            |labels: &Self, label| sides.clone().filter(|&h| labels.label_of_half_edge[h as usize] == label).count();
        if self.is_pole_triangle(face) {
            return if count(self, EdgeLabel::Diagonal) == 0 { Ok(()) } else { Err(no_grid_error(3 * face)) };
        }
        let label = match (count(self, EdgeLabel::Diagonal), count(self, EdgeLabel::Unknown)) {
            (0, 0) | (2.., _) => return Err(no_grid_error(3 * face)),
            (1, _) => EdgeLabel::Side,
            (0, 1) => EdgeLabel::Diagonal,
            _ => return Ok(()),
        };
        sides.clone().try_for_each(|h| {
            if self.label_of_half_edge[h as usize] == EdgeLabel::Unknown { self.set_label(h, label) } else { Ok(()) }
        })
    }

    /// Applies the rule of a vertex: the number of its diagonals.
    fn apply_vertex_rule(&mut self, v: u32) -> Result<()> {
        if self.poles.contains(&v) {
            return Ok(());
        }
        let surface = self.surface;
        let edges = surface.edges_of_vertex.get(v as usize);
        let here = edges.first().map_or(0, |&h| h);
        let [min, max] = surface.diagonal_count_range(v).ok_or(no_grid_error(here))?;
        let (found, unknown) = (self.diagonal_counts[v as usize], self.unlabelled_counts[v as usize]);
        let label = if found > max || found + unknown < min {
            return Err(no_grid_error(here));
        } else if found == max {
            EdgeLabel::Side
        } else if found + unknown == min {
            EdgeLabel::Diagonal
        } else {
            return Ok(());
        };
        edges.iter().try_for_each(|&h| {
            if self.label_of_half_edge[h as usize] == EdgeLabel::Unknown { self.set_label(h, label) } else { Ok(()) }
        })
    }

    /// Returns the next undecided face from `from` on, cyclically: one with a side and without a
    /// diagonal, or else one without any label.
    fn next_undecided_face(&self, from: u32) -> Option<u32> {
        let count = self.label_of_half_edge.len() as u32 / 3;
        let is = |face: u32, label| (3 * face..3 * face + 3).any(|h| self.label_of_half_edge[h as usize] == label);
        let faces = || (from..count).chain(0..from).filter(|&face| is(face, EdgeLabel::Unknown));
        faces().find(|&face| is(face, EdgeLabel::Side)).or_else(|| faces().next())
    }

    /// Makes an edge a diagonal, and then decides the others.
    fn decide_from_diagonal(&mut self, h: u32, job: &Job<'_>) -> Result<()> {
        self.set_label(h, EdgeLabel::Diagonal)?;
        self.propagate_labels(job)?;
        let mut from = h / 3;
        while let Some(face) = self.next_undecided_face(from) {
            from = face;
            let Some(h) = (3 * face..3 * face + 3).find(|&h| self.label_of_half_edge[h as usize] == EdgeLabel::Unknown)
            else {
                break;
            };
            let mark = self.labelled_edges.len();
            match self.set_label(h, EdgeLabel::Diagonal).and_then(|()| self.propagate_labels(job)) {
                Err(Error::NoGrid { .. }) => {
                    self.undo_labels_after(mark);
                    self.set_label(h, EdgeLabel::Side)?;
                    self.propagate_labels(job)?;
                }
                other => other?,
            }
        }
        Ok(())
    }

    /// Returns the net of the faces without diagonals.
    fn build_net(&self, mesh: &MeshView<'_>, job: &Job<'_>) -> Result<RecognisedNet> {
        let surface = self.surface;
        let (mut offsets, mut corners, mut triangles) = (alloc::filled(0u32, 1)?, Vec::new(), Vec::new());
        for face in 0..self.label_of_half_edge.len() as u32 / 3 {
            let diagonal =
                (3 * face..3 * face + 3).find(|&h| self.label_of_half_edge[h as usize] == EdgeLabel::Diagonal);
            let start = |h: u32| surface.start_vertices[h as usize];
            match diagonal.map(|h| (h, surface.mates[h as usize])) {
                // Skip the second triangle of a pair.
                Some((h, mate)) if mate < h => continue,
                Some((h, mate)) => alloc::append(
                    &mut corners,
                    &[
                        start(h),
                        start(next_half_edge(next_half_edge(mate))),
                        start(next_half_edge(h)),
                        start(next_half_edge(next_half_edge(h))),
                    ],
                )?,
                None => alloc::append(&mut corners, &[start(3 * face), start(3 * face + 1), start(3 * face + 2)])?,
            }
            alloc::push(&mut offsets, corners.len() as u32)?;
            alloc::push(&mut triangles, face)?;
        }
        let faces = Faces::polygons(&offsets, &corners)?;
        let view = MeshView::new(*mesh.positions(), faces, &job.sub_job(0.0, 0.2))?;
        match net_of_grid(&view, None, &job.sub_job(0.2, 1.0)) {
            Ok(mut found) => {
                found.face_of_cell.iter_mut().for_each(|face| *face = triangles[*face as usize]);
                Ok(found)
            }
            Err(Error::NoGrid { face }) => Err(Error::NoGrid { face: triangles[face as usize] }),
            Err(other) => Err(other),
        }
    }
}
