//! Sheets of faces: which two faces at an edge with three or more belong together.
//!
//! Two faces belong together if the solid lies in the wedge between them. In components that are
//! open or without volume, the solid lies behind each face. Faces of closed patches are paired
//! first, then the others, and then the pairs that bend least, up to a right angle. A vertex with
//! several fans of faces gets a copy for each fan after the first.

use super::edge_fans::EdgeFans;
use super::patches::Patches;
use super::repair_request::DropReason;
use super::repair_state::RepairState;
use super::solid_sides::{find_solid_sides, side_ahead};
use crate::check::join_corners_at_edge;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_base::sort::sort_stable;
use gusset_mesh::{MeshView, NONE, Opposite, Topology};

/// Largest number of faces at an edge of which pairs are sought by their bends. More faces are all
/// separated.
const MAX_FACES_COMPARED: usize = 64;

const STAGE: &str = "separating sheets";

/// The sheets of a mesh.
pub(super) struct Sheets {
    /// For each face, why it is dropped.
    pub(super) reasons: Vec<Option<DropReason>>,
    /// For each face, true if it is turned over.
    turned: Vec<bool>,
    /// The pairs of half-edges that remain together at edges with three or more faces.
    pub(super) pairs: Vec<[u32; 2]>,
    /// A face of each open sheet that was attached to an edge, and a face of the sheet that keeps
    /// the edge, or of another open sheet there.
    pub(super) attached: Vec<[u32; 2]>,
}

impl Sheets {
    /// Finds the sheets. O(H) for H half-edges, plus the squares of the numbers of faces at edges,
    /// which are at most 64.
    pub(super) fn find(
        mesh: &MeshView<'_>,
        topology: &Topology,
        fans: &EdgeFans,
        patches: &Patches,
        job: &Job<'_>,
    ) -> Result<Sheets> {
        let solid = find_solid_sides(mesh, topology, patches, &job.sub_job(0.0, 0.5))?;
        let count = mesh.faces().len();
        let (mut reasons, mut turned) = (alloc::filled(None, count)?, alloc::filled(false, count)?);
        for (f, sides) in solid.iter().enumerate() {
            match sides {
                Some([true, true]) => reasons[f] = Some(DropReason::Inside),
                Some([true, false]) => turned[f] = true,
                _ => {}
            }
        }
        let mut sheets = Sheets { reasons, turned, pairs: Vec::new(), attached: Vec::new() };
        for (k, fan) in fans.iter().enumerate() {
            job.sub_job(0.5, 1.0).step_within_list(k, STAGE)?;
            sheets.pair_faces(mesh, topology, fan, patches, &solid)?;
        }
        Ok(sheets)
    }

    /// Pairs the faces of an edge: faces of closed patches around the solid, then other faces.
    fn pair_faces(
        &mut self,
        mesh: &MeshView<'_>,
        topology: &Topology,
        fan: &[u32],
        patches: &Patches,
        solid: &[Option<[bool; 2]>],
    ) -> Result<()> {
        let face = |h: u32| mesh.faces().face_of_half_edge(h);
        // Faces with the solid on neither side may belong to a part with a hole.
        let is_wall = |f: u32| patches.is_closed(f) && solid[f as usize] != Some([false, false]);
        let walls = |wanted: bool| alloc::gather(fan.iter().copied().filter(|&h| is_wall(face(h)) == wanted));
        let (mut closed, open) = (walls(true)?, walls(false)?);
        let has_solid = closed.first().is_some_and(|&h| solid[face(h) as usize].is_some());
        closed.retain(|&h| self.reasons[face(h) as usize].is_none());
        if let Some(&host) = closed.first() {
            open.iter().try_for_each(|&h| alloc::push(&mut self.attached, [face(h), face(host)]))?;
        }
        for pair in open.windows(2).map(|pair| [face(pair[0]), face(pair[1])]) {
            alloc::extend(&mut self.attached, [pair, [pair[1], pair[0]]])?;
        }
        let is_back = |side: u32| side % 2 == 1;
        if has_solid {
            let is_solid = |side: u32| solid[side as usize / 2].is_some_and(|sides| sides[side as usize % 2]);
            self.pair_across_wedges(mesh, topology, &closed, &is_solid)?;
        } else if let [h, mate] = closed[..] {
            alloc::push(&mut self.pairs, [h, mate])?;
        } else {
            let rest = self.pair_across_wedges(mesh, topology, &closed, &is_back)?;
            self.pair_least_bends(mesh, topology, &rest)?;
        }
        let rest = self.pair_across_wedges(mesh, topology, &open, &is_back)?;
        self.pair_least_bends(mesh, topology, &rest)
    }

    /// Pairs faces that follow each other around an edge if the sides that face each other are
    /// solid. Returns the half-edges without a partner.
    fn pair_across_wedges(
        &mut self,
        mesh: &MeshView<'_>,
        topology: &Topology,
        fan: &[u32],
        is_solid: &dyn Fn(u32) -> bool,
    ) -> Result<Vec<u32>> {
        let mut is_paired = alloc::filled(false, fan.len())?;
        for k in 0..fan.len() {
            let next = (k + 1) % fan.len();
            let [ahead, behind] = [side_ahead(mesh, topology, fan[k]), side_ahead(mesh, topology, fan[next]) ^ 1];
            if next != k && is_solid(ahead) && is_solid(behind) && !is_paired[k] && !is_paired[next] {
                (is_paired[k], is_paired[next]) = (true, true);
                alloc::push(&mut self.pairs, [fan[k], fan[next]])?;
            }
        }
        alloc::gather(fan.iter().zip(&is_paired).filter(|&(_, &is_paired)| !is_paired).map(|(&h, _)| h))
    }

    /// Pairs the faces that bend least, up to a right angle.
    fn pair_least_bends(&mut self, mesh: &MeshView<'_>, topology: &Topology, rest: &[u32]) -> Result<()> {
        if rest.len() > MAX_FACES_COMPARED {
            return Ok(());
        }
        let directions = alloc::collect(rest.iter().map(|&h| direction_from_edge(mesh, topology, h)))?;
        let mut bends = Vec::new();
        for i in 0..rest.len() {
            for j in i + 1..rest.len() {
                let cosine = directions[i].dot(directions[j]);
                if cosine < 0.0 {
                    alloc::push(&mut bends, (cosine, i, j))?;
                }
            }
        }
        sort_stable(&mut bends, &|a, b| a.0.total_cmp(&b.0));
        let mut is_paired = [false; MAX_FACES_COMPARED];
        for &(_, i, j) in &bends {
            if !is_paired[i] && !is_paired[j] {
                (is_paired[i], is_paired[j]) = (true, true);
                alloc::push(&mut self.pairs, [rest[i], rest[j]])?;
            }
        }
        Ok(())
    }

    /// Gives each sheet its own vertices, turns faces over and drops faces. Returns the number of
    /// new vertices.
    pub(super) fn separate(
        self,
        state: &mut RepairState,
        topology: &Topology,
        job: &Job<'_>,
    ) -> Result<(u32, Vec<[u32; 2]>)> {
        let Sheets { reasons, turned, pairs, mut attached } = self;
        let (corners, copies) = {
            let view = state.mesh.view(&job.sub_job(0.0, 0.1))?;
            split_vertices(&view, topology, &pairs, &reasons, &job.sub_job(0.1, 0.8))?
        };
        state.copy_vertices(&copies)?;
        state.mesh.face_corners = corners;
        for f in (0..turned.len()).filter(|&f| turned[f]) {
            state.turn_face(f);
        }
        let mut number = 0;
        let mut numbers = alloc::filled(NONE, reasons.len())?;
        for (f, reason) in reasons.iter().enumerate() {
            if reason.is_none() {
                numbers[f] = number;
                number += 1;
            }
        }
        attached.iter_mut().for_each(|pair| *pair = pair.map(|f| numbers[f as usize]));
        attached.retain(|pair| !pair.contains(&NONE));
        state.drop_faces(&reasons)?;
        Ok((copies.len() as u32, attached))
    }
}

/// Returns the corners with a vertex of its own for each fan, and the old vertex of each new one.
fn split_vertices(
    mesh: &MeshView<'_>,
    topology: &Topology,
    pairs: &[[u32; 2]],
    reasons: &[Option<DropReason>],
    job: &Job<'_>,
) -> Result<(Vec<u32>, Vec<u32>)> {
    let (faces, count) = (mesh.faces(), mesh.faces().half_edge_count());
    let mut fans = DisjointSets::new(count)?;
    job.sub_job(0.0, 0.5).work_in_ranges(STAGE, count, |range| {
        for h in range.map(|h| h as u32).filter(|&h| !topology.is_ignored(h)) {
            match topology.opposite(h) {
                Opposite::Mate(mate) if h < mate => join_corners_at_edge(mesh, topology, [h, mate], &mut fans),
                _ => {}
            }
        }
        Ok(())
    })?;
    pairs.iter().for_each(|&pair| join_corners_at_edge(mesh, topology, pair, &mut fans));
    let (mut corners, mut copies) = (alloc::collect(faces.corners(0..count))?, Vec::new());
    // The first fan of each vertex keeps it.
    let mut is_owned = alloc::filled(false, mesh.positions().len())?;
    for h in 0..count as u32 {
        job.sub_job(0.5, 1.0).step_within_list(h as usize, STAGE)?;
        if topology.is_ignored(h) || reasons[faces.face_of_half_edge(h) as usize].is_some() {
            continue;
        }
        let (v, root) = (corners[h as usize] as usize, fans.find(h));
        if root != h {
            corners[h as usize] = corners[root as usize];
        } else if !is_owned[v] {
            is_owned[v] = true;
        } else {
            corners[h as usize] = (mesh.positions().len() + copies.len()) as u32;
            alloc::push(&mut copies, v as u32)?;
        }
    }
    Ok((corners, copies))
}

/// Returns the unit vector from an edge into its face, perpendicular to the edge.
pub(super) fn direction_from_edge(mesh: &MeshView<'_>, topology: &Topology, h: u32) -> DVec3 {
    let point = |h: u32| mesh.positions().get(mesh.faces().corner(h));
    let start = point(h);
    let along = (point(topology.next(mesh, h)) - start).normalize_or_zero();
    let across = point(topology.previous(mesh, h)) - start;
    (across - along * across.dot(along)).normalize_or_zero()
}
