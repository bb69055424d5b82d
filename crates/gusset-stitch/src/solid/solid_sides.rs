//! The cells between faces, and the faces around the solid.
//!
//! A face has two sides. Sides are in one cell if one can walk from one to the other without
//! crossing a face: across an edge with two faces, or between faces that follow each other around
//! an edge. Crossing a face from its front to its back adds 1 to the winding number. If the winding
//! numbers agree along all walks, the solid consists of the cells with a winding number that is not
//! 0. Otherwise it consists of all cells except the one outside: faces point either way, or there
//! are walls between rooms.
//!
//! The cell outside of a connected set of faces is the one with negative volume: its faces bound it
//! from within. If more faces have the solid on neither side than on one, faces intersect, and the
//! solid is not known.

use super::edge_fans::EdgeFans;
use super::patches::Patches;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::Aabb;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::Buckets;
use gusset_mesh::{MeshView, NONE, Opposite, Topology};

const STAGE: &str = "finding cells";

/// For each face, whether the solid lies in front of it, and behind it; `None` if the face's
/// component is open, manifold or without volume, or if its solid is not known.
pub(super) type SolidSides = Vec<Option<[bool; 2]>>;

/// Finds the solid of each component of closed patches that has edges of several patches. Open
/// patches are left out. O(H) for H half-edges.
pub(super) fn find_solid_sides(
    mesh: &MeshView<'_>,
    topology: &Topology,
    patches: &Patches,
    job: &Job<'_>,
) -> Result<SolidSides> {
    let count = mesh.faces().len();
    if patches.closed_fans.is_empty() {
        return alloc::filled(None, count);
    }
    let components = edge_components(mesh, topology, &patches.closed_fans, &job.sub_job(0.0, 0.3))?;
    let mut is_examined = alloc::filled(false, count)?;
    for &h in patches.closed_fans.iter().flatten() {
        is_examined[components[mesh.faces().face_of_half_edge(h) as usize] as usize] = true;
    }
    let cells = cells_of_sides(mesh, topology, &patches.closed_fans, &job.sub_job(0.3, 0.6))?;
    let cells = Cells { mesh, cell_of_side: cells, components: &components };
    let outsides = cells.find_outsides(&|f| is_examined[components[f] as usize], &job.sub_job(0.6, 0.8))?;
    let has_solid = |f: usize| outsides[components[f] as usize] != NONE;
    let inside = cells.find_inside(&outsides, &has_solid, &job.sub_job(0.8, 1.0))?;
    // Faces that intersect connect cells that they should separate.
    let mut excess = alloc::filled(0i64, count)?;
    for f in (0..count).filter(|&f| has_solid(f)) {
        excess[components[f] as usize] += match (inside[2 * f], inside[2 * f + 1]) {
            (false, false) => 1,
            (true, true) => 0,
            _ => -1,
        };
    }
    let is_known = |f: usize| has_solid(f) && excess[components[f] as usize] < 0;
    alloc::collect((0..count).map(|f| is_known(f).then(|| [0, 1].map(|side| inside[2 * f + side]))))
}

/// Returns for each face the smallest face that is connected to it across edges.
fn edge_components(mesh: &MeshView<'_>, topology: &Topology, fans: &EdgeFans, job: &Job<'_>) -> Result<Vec<u32>> {
    let faces = mesh.faces();
    let mut sets = DisjointSets::new(faces.len())?;
    job.sub_job(0.0, 0.9).work_in_ranges(STAGE, faces.half_edge_count(), |range| {
        for h in range.map(|h| h as u32).filter(|&h| !topology.is_ignored(h)) {
            if let Opposite::Mate(mate) = topology.opposite(h)
                && h < mate
            {
                sets.union(faces.face_of_half_edge(h), faces.face_of_half_edge(mate));
            }
        }
        Ok(())
    })?;
    for pair in fans.iter().flat_map(|fan| fan.windows(2)) {
        sets.union(faces.face_of_half_edge(pair[0]), faces.face_of_half_edge(pair[1]));
    }
    sets.into_roots(&job.sub_job(0.9, 1.0), STAGE)
}

/// Returns the cell of each side: the smallest side in it. Face f has its front at 2 f and its back
/// at 2 f + 1.
fn cells_of_sides(mesh: &MeshView<'_>, topology: &Topology, fans: &EdgeFans, job: &Job<'_>) -> Result<Vec<u32>> {
    let faces = mesh.faces();
    let mut sets = DisjointSets::new(2 * faces.len())?;
    job.sub_job(0.0, 0.8).work_in_ranges(STAGE, faces.half_edge_count(), |range| {
        for h in range.map(|h| h as u32).filter(|&h| !topology.is_ignored(h)) {
            if let Opposite::Mate(mate) = topology.opposite(h)
                && h < mate
            {
                let (f, g) = (faces.face_of_half_edge(h), faces.face_of_half_edge(mate));
                let opposed = u32::from(faces.corner(h) == faces.corner(mate));
                sets.union(2 * f, 2 * g + opposed);
                sets.union(2 * f + 1, 2 * g + 1 - opposed);
            }
        }
        Ok(())
    })?;
    for fan in fans.iter() {
        for (k, &h) in fan.iter().enumerate() {
            let next = fan[(k + 1) % fan.len()];
            sets.union(side_ahead(mesh, topology, h), side_ahead(mesh, topology, next) ^ 1);
        }
    }
    sets.into_roots(&job.sub_job(0.8, 1.0), STAGE)
}

/// Returns the side of a face that looks along the counter-clockwise turn about its edge, from the
/// edge's smaller to its larger vertex.
pub(super) fn side_ahead(mesh: &MeshView<'_>, topology: &Topology, h: u32) -> u32 {
    let runs_up = mesh.faces().corner(h) < mesh.faces().corner(topology.next(mesh, h));
    2 * mesh.faces().face_of_half_edge(h) + u32::from(!runs_up)
}

/// The cells of a mesh.
struct Cells<'m> {
    mesh: &'m MeshView<'m>,
    /// The cell of each side: its smallest side.
    cell_of_side: Vec<u32>,
    /// The component of each face.
    components: &'m [u32],
}

impl Cells<'_> {
    /// Returns for each side whether it lies in the solid, starting from the cell outside of each
    /// component.
    fn find_inside(&self, outsides: &[u32], has_solid: &dyn Fn(usize) -> bool, job: &Job<'_>) -> Result<Vec<bool>> {
        let sides = (0..self.cell_of_side.len()).filter(|side| has_solid(side / 2));
        let sides = sides.map(|side| (self.cell_of_side[side] as usize, side as u32));
        let sides = Buckets::new_cancellable(self.cell_of_side.len(), 0u32, sides, &job.sub_job(0.0, 0.5), STAGE)?;
        let mut winding = alloc::filled(None, self.cell_of_side.len())?;
        let (mut inside, mut reached) = (alloc::filled(false, self.cell_of_side.len())?, Vec::new());
        for &outside in outsides.iter().filter(|&&cell| cell != NONE) {
            reached.clear();
            alloc::push(&mut reached, outside)?;
            winding[outside as usize] = Some(0i32);
            let (mut next, mut agrees) = (0, true);
            while let Some(&cell) = reached.get(next) {
                job.step_within_list(next, STAGE)?;
                next += 1;
                for &side in sides.get(cell as usize) {
                    let other = self.cell_of_side[side as usize ^ 1];
                    // The even side is the front; the winding number is larger behind it.
                    let step = if side % 2 == 0 { 1 } else { -1 };
                    let expected = winding[cell as usize].unwrap_or(0).saturating_add(step);
                    if winding[other as usize].is_none() {
                        winding[other as usize] = Some(expected);
                        alloc::push(&mut reached, other)?;
                    }
                    agrees &= winding[other as usize] == Some(expected);
                }
            }
            for &cell in &reached {
                let is_solid = if agrees { winding[cell as usize] != Some(0) } else { cell != outside };
                sides.get(cell as usize).iter().for_each(|&side| inside[side as usize] = is_solid);
            }
        }
        Ok(inside)
    }

    /// Returns the cell outside of each examined component, at the component's smallest face, and
    /// [`NONE`] elsewhere and for components without volume.
    ///
    /// By the divergence theorem, six times the volume of a cell is the sum of p ((q - p) x (r - p))
    /// over the triangles p, q, r around it.
    fn find_outsides(&self, examined: &dyn Fn(usize) -> bool, job: &Job<'_>) -> Result<Vec<u32>> {
        let count = self.components.len();
        let mut volumes = alloc::filled(0.0, self.cell_of_side.len())?;
        let mut rounding = alloc::filled(0.0, count)?;
        let unit = common_unit(&[Aabb::from_points(self.corner_points(examined)).size()]);
        for f in (0..count).filter(|&f| examined(f)) {
            job.sub_job(0.0, 0.8).step_within_list(f, STAGE)?;
            let component = self.components[f] as usize;
            let origin = self.mesh.face(component).next().map_or(DVec3::ZERO, |v| self.mesh.positions().get(v));
            let mut corners = self.mesh.face(f).map(|v| (self.mesh.positions().get(v) - origin) / unit);
            let (Some(first), Some(second)) = (corners.next(), corners.next()) else { continue };
            let mut before = second - first;
            for p in corners {
                let side = p - first;
                let volume = first.dot(before.cross(side));
                // Behind the face is the side for which the face's normal points outwards.
                volumes[self.cell_of_side[2 * f + 1] as usize] += volume;
                volumes[self.cell_of_side[2 * f] as usize] -= volume;
                rounding[component] += 4.0 * f64::EPSILON * first.length() * before.length() * side.length();
                before = side;
            }
        }
        let mut outsides = alloc::filled(NONE, count)?;
        for side in (0..self.cell_of_side.len()).filter(|side| examined(side / 2)) {
            let (cell, component) = (self.cell_of_side[side], self.components[side / 2] as usize);
            let least = match outsides[component] {
                NONE => -(count as f64).sqrt() * rounding[component],
                outside => volumes[outside as usize],
            };
            if volumes[cell as usize] < least {
                outsides[component] = cell;
            }
        }
        job.step(1.0, STAGE)?;
        Ok(outsides)
    }

    fn corner_points(&self, examined: &dyn Fn(usize) -> bool) -> impl Iterator<Item = DVec3> {
        let faces = (0..self.components.len()).filter(move |&f| examined(f));
        faces.flat_map(|f| self.mesh.face(f)).map(|v| self.mesh.positions().get(v))
    }
}
