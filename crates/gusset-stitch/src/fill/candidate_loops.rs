//! Selects the loops to fill, and gives the reason for each loop that is left.

use super::fill_request::{HoleStatus, Keep, Limits, LoopSelection, Measures, Options};
use crate::boundary::{Boundary, LoopFlags};
use crate::stitch::{FreeEdges, check_loop_indices};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::scale::{common_unit, overflow_safe_distance};
use gusset_base::geom::{Aabb, triangle::double_area};
use gusset_mesh::{MeshView, vertex_components};
use std::collections::HashSet;

/// A loop, and whether it is to be filled.
pub(super) struct CandidateLoop {
    /// With the surface on the left if the loop is to be filled.
    pub(super) vertices: Vec<u32>,
    pub(super) status: HoleStatus,
    pub(super) measures: Measures,
}

/// Returns the loops of a selection. `unsewn` marks loops of the boundary that stay open unless
/// every loop is a hole.
pub(super) fn choose_loops(
    mesh: &MeshView<'_>,
    boundary: &Boundary,
    selection: LoopSelection<'_>,
    unsewn: &[bool],
    options: &Options,
) -> Result<Vec<CandidateLoop>> {
    match selection {
        LoopSelection::All => candidates_of_all_loops(mesh, boundary, unsewn, options),
        LoopSelection::Loops(loops) => {
            candidates_of_given_loops(mesh, boundary, loops.iter().copied(), &options.limits)
        }
        LoopSelection::Groups(loops) => {
            candidates_of_given_loops(mesh, boundary, loops.iter().map(|&(vertices, _)| vertices), &options.limits)
        }
    }
}

fn candidates_of_all_loops(
    mesh: &MeshView<'_>,
    boundary: &Boundary,
    unsewn: &[bool],
    options: &Options,
) -> Result<Vec<CandidateLoop>> {
    let mut usable = alloc::collect(boundary.iter().map(|found| status_of_flags(found.flags)))?;
    usable.iter_mut().zip(unsewn).for_each(|(status, &unsewn)| {
        if unsewn && options.keep != Keep::None && *status == HoleStatus::Filled {
            *status = HoleStatus::Unsewn;
        }
    });
    mark_loops_left_open(mesh, boundary, options.keep, &mut usable)?;
    let mut candidates = alloc::with_capacity(boundary.len())?;
    for (found, status) in boundary.iter().zip(usable) {
        let measures = loop_measures(mesh, found.vertices);
        let status = match status {
            HoleStatus::Filled => status_of_size(found.vertices, &measures, &options.limits),
            status => status,
        };
        candidates.push(CandidateLoop { vertices: alloc::copied(found.vertices)?, status, measures });
    }
    Ok(candidates)
}

/// Changes the status of the loops that [`Keep`] leaves open.
fn mark_loops_left_open(
    mesh: &MeshView<'_>,
    boundary: &Boundary,
    keep: Keep,
    statuses: &mut [HoleStatus],
) -> Result<()> {
    let usable = alloc::gather((0..boundary.len()).filter(|&i| statuses[i] == HoleStatus::Filled))?;
    let loops = || usable.iter().filter_map(|&i| Some((i, boundary.get(i)?)));
    match keep {
        Keep::None => {}
        Keep::Longest => {
            // The first of equally long loops.
            let longest = loops().max_by(|(i, a), (j, b)| a.length.total_cmp(&b.length).then(j.cmp(i)));
            longest.into_iter().for_each(|(i, _)| statuses[i] = HoleStatus::Kept);
        }
        Keep::OuterBorders => {
            let sheets = MeshComponents::new(mesh)?;
            let outer = loops().filter(|(_, found)| sheets.is_outer_border(mesh, found.vertices));
            outer.for_each(|(i, _)| statuses[i] = HoleStatus::Kept);
        }
        Keep::Auto => {
            let sheets = MeshComponents::new(mesh)?;
            // For each component, its outermost loop, and how far that reaches.
            let mut outermost = alloc::filled((0.0, usize::MAX), sheets.areas.len())?;
            for (i, found) in loops() {
                if sheets.is_loose(found.vertices) {
                    statuses[i] = HoleStatus::Loose;
                } else if let Some(reach) = sheets.reach_in_sheet(mesh, found.vertices) {
                    let most = &mut outermost[sheets.component[found.vertices[0] as usize] as usize];
                    *most = if reach > most.0 { (reach, i) } else { *most };
                }
            }
            outermost.iter().filter(|most| most.1 != usize::MAX).for_each(|most| statuses[most.1] = HoleStatus::Kept);
        }
    }
    Ok(())
}

/// Smallest ratio of a sheet's area vector to its area.
const MIN_SHEET_FLATNESS: f64 = 0.75;

/// The components of a mesh.
struct MeshComponents {
    /// Component number of each vertex.
    component: Vec<u32>,
    /// The unit in which areas neither overflow nor underflow, a power of two.
    unit: f64,
    /// Area and area vector of each component, in the unit.
    areas: Vec<(f64, DVec3)>,
    /// The number of vertices of each component.
    sizes: Vec<u32>,
}

impl MeshComponents {
    /// O(H) for H half-edges; extra memory: 48 bytes per vertex.
    fn new(mesh: &MeshView<'_>) -> Result<MeshComponents> {
        let mut sets = vertex_components(mesh)?;
        let component = alloc::collect((0..mesh.positions().len() as u32).map(|v| sets.find(v)))?;
        let largest = mesh
            .faces()
            .corners(0..mesh.faces().half_edge_count())
            .fold(DVec3::ZERO, |largest, v| largest.max(mesh.positions().get(v).abs()));
        let unit = common_unit([&largest]);
        let mut areas = alloc::filled((0.0, DVec3::ZERO), component.len())?;
        for f in 0..mesh.faces().len() {
            let corners = || mesh.face(f).map(|v| mesh.positions().get(v) / unit);
            let (Some(first), Some(vertex)) = (corners().next(), mesh.face(f).next()) else {
                continue;
            };
            let (whole, vector) = &mut areas[component[vertex as usize] as usize];
            for (p, q) in corners().skip(1).zip(corners().skip(2)) {
                *whole += double_area(first, p, q) / 2.0;
                *vector += (p - first).cross(q - first) / 2.0;
            }
        }
        let mut sizes = alloc::filled(0, component.len())?;
        component.iter().for_each(|&c| sizes[c as usize] += 1);
        Ok(MeshComponents { component, unit, areas, sizes })
    }

    /// Returns true if a simple loop passes all vertices of its component.
    fn is_loose(&self, vertices: &[u32]) -> bool {
        self.sizes[self.component[vertices[0] as usize] as usize] as usize == vertices.len()
    }

    /// Returns how far the loop's area vector reaches along the area vector of its component;
    /// `None` unless the component is a sheet.
    fn reach_in_sheet(&self, mesh: &MeshView<'_>, vertices: &[u32]) -> Option<f64> {
        let (area, own) = self.areas[self.component[vertices[0] as usize] as usize];
        (own.length() >= MIN_SHEET_FLATNESS * area)
            .then(|| self.area_vector(mesh, vertices).dot(own.normalize_or_zero()))
    }

    /// Returns true if the loop runs around the outside of its sheet; see [`Keep::OuterBorders`].
    fn is_outer_border(&self, mesh: &MeshView<'_>, vertices: &[u32]) -> bool {
        let (area, own) = self.areas[self.component[vertices[0] as usize] as usize];
        let vector = self.area_vector(mesh, vertices);
        vector.dot(own) > 0.0 && vector.length() >= 0.5 * area
    }

    /// Returns the area vector of a loop, in the unit.
    fn area_vector(&self, mesh: &MeshView<'_>, vertices: &[u32]) -> DVec3 {
        let origin = mesh.positions().get(vertices[0]) / self.unit;
        let at = |v: &u32| mesh.positions().get(*v) / self.unit - origin;
        vertices.iter().zip(vertices.iter().cycle().skip(1)).map(|(u, v)| at(u).cross(at(v)) / 2.0).sum()
    }
}

fn status_of_flags(flags: LoopFlags) -> HoleStatus {
    if flags.any(LoopFlags::OPEN) {
        HoleStatus::Open
    } else if flags.any(LoopFlags::NON_MANIFOLD) {
        HoleStatus::NonManifold
    } else if flags.any(LoopFlags::NOT_ORIENTED) {
        HoleStatus::NotOriented
    } else {
        HoleStatus::Filled
    }
}

/// Returns the given loops, which may run in either direction.
fn candidates_of_given_loops<'a>(
    mesh: &MeshView<'_>,
    boundary: &Boundary,
    loops: impl ExactSizeIterator<Item = &'a [u32]>,
    limits: &Limits,
) -> Result<Vec<CandidateLoop>> {
    let edges = FreeEdges::from_boundary(boundary)?;
    let mut used = HashSet::new();
    let mut candidates = alloc::with_capacity(loops.len())?;
    for (number, given) in (0..).zip(loops) {
        check_loop_indices(mesh, number, given)?;
        let mut vertices = alloc::copied(given)?;
        let mut status = status_of_given_loop(&edges, &vertices)?;
        let measures = loop_measures(mesh, &vertices);
        if status == HoleStatus::Filled {
            if edges.face_along(vertices[0], vertices[1]).is_none() {
                vertices.reverse();
            }
            let steps = || vertices.iter().zip(vertices.iter().cycle().skip(1)).map(|(&u, &v)| (u, v));
            status = if steps().any(|edge| used.contains(&edge)) {
                HoleStatus::NotFree
            } else {
                status_of_size(&vertices, &measures, limits)
            };
            if status == HoleStatus::Filled {
                alloc::insert_all(&mut used, steps())?;
            }
        }
        candidates.push(CandidateLoop { vertices, status, measures });
    }
    Ok(candidates)
}

fn status_of_given_loop(edges: &FreeEdges, vertices: &[u32]) -> Result<HoleStatus> {
    let mut sorted = alloc::copied(vertices)?;
    sorted.sort_unstable();
    if vertices.len() < 3 || sorted.windows(2).any(|pair| pair[0] == pair[1]) {
        return Ok(HoleStatus::NotSimple);
    }
    let steps = vertices.iter().zip(vertices.iter().cycle().skip(1));
    let (mut along, mut against) = (0, 0);
    for (&u, &v) in steps {
        match (edges.face_along(u, v), edges.face_along(v, u)) {
            (Some(_), _) => along += 1,
            (None, Some(_)) => against += 1,
            (None, None) => return Ok(HoleStatus::NotFree),
        }
    }
    Ok(if along > 0 && against > 0 { HoleStatus::NotOriented } else { HoleStatus::Filled })
}

fn status_of_size(vertices: &[u32], measures: &Measures, limits: &Limits) -> HoleStatus {
    let exceeds = |limit: Option<f64>, measure: f64| limit.is_some_and(|limit| measure > limit);
    if limits.edges.is_some_and(|limit| vertices.len() > limit as usize)
        || exceeds(limits.length, measures.length)
        || exceeds(limits.diameter, measures.diameter)
        || exceeds(limits.area, measures.area)
    {
        HoleStatus::TooLarge
    } else {
        HoleStatus::Filled
    }
}

fn loop_measures(mesh: &MeshView<'_>, vertices: &[u32]) -> Measures {
    let n = vertices.len();
    if n == 0 {
        return Measures::default();
    }
    let point = |i: usize| mesh.positions().get(vertices[i % n]);
    let whole = Aabb::from_points((0..n).map(point));
    // Only the area itself may overflow, not its square.
    let unit = common_unit([&whole.low, &whole.high]);
    let scaled = |i: usize| point(i) / unit;
    let centre = (0..n).map(|i| scaled(i) / n as f64).sum::<DVec3>();
    let double: f64 = (0..n).map(|i| double_area(centre, scaled(i), scaled(i + 1))).sum();
    Measures {
        length: (0..n).map(|i| overflow_safe_distance(point(i), point(i + 1))).sum(),
        diameter: overflow_safe_distance(whole.low, whole.high),
        area: unit * (double / 2.0) * unit,
    }
}

#[cfg(test)]
mod tests {
    use super::{HoleStatus, Keep, LoopSelection, Options, choose_loops};
    use crate::boundary::{self, boundary_loops};
    use gusset_base::job::Job;
    use gusset_mesh::{Faces, MeshView, Positions};

    /// The statuses, areas and lengths of the loops of a square sheet with a square hole.
    fn loops_of_sheet(size: f64, keep: Keep) -> Vec<(HoleStatus, f64, f64)> {
        let points: Vec<_> = (0..16).map(|k| [size * f64::from(k / 4), size * f64::from(k % 4), 0.0]).collect();
        let quads = (0..9).filter(|&k| k != 4).map(|k: u32| k / 3 * 4 + k % 3);
        let corners: Vec<_> = quads.map(|v| [v, v + 4, v + 5, v + 1]).collect();
        let faces = Faces::quads(&corners).unwrap();
        let mesh = MeshView::new(Positions::from(&points[..]), faces, &Job::default()).unwrap();
        let found = boundary_loops(&mesh, &boundary::Options::default(), &Job::default()).unwrap();
        let options = Options { keep, ..Options::default() };
        let chosen = choose_loops(&mesh, &found, LoopSelection::All, &[], &options).unwrap();
        chosen.iter().map(|one| (one.status, one.measures.area, one.measures.length)).collect()
    }

    #[test]
    fn outer_borders_and_areas_do_not_depend_on_the_unit() {
        for keep in [Keep::Auto, Keep::OuterBorders] {
            let expected = loops_of_sheet(1.0, keep);
            assert_eq!(expected.iter().map(|one| one.1).sum::<f64>(), 10.0);
            assert_eq!(expected.iter().filter(|one| one.0 == HoleStatus::Kept).count(), 1);
            for exponent in [-1000, -600, -300, 300, 400, 500, 510] {
                let size = 2f64.powi(exponent);
                let scaled = expected.iter().map(|&(status, area, length)| (status, size * area * size, size * length));
                assert_eq!(loops_of_sheet(size, keep), scaled.collect::<Vec<_>>(), "2^{exponent}");
            }
            // The areas overflow, but not the decisions.
            let large = loops_of_sheet(1e200, keep);
            assert!(large.iter().all(|one| one.1 == f64::INFINITY));
            assert!(large.iter().zip(&expected).all(|(a, b)| a.0 == b.0));
        }
    }
}
