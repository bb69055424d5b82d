//! The combined pieces: welded, oriented, and finally filled and turned outwards.

use super::assemble_request::{Assembly, LeftLoop, Options, Overlaps, Reason, Selector};
use super::origin_history::History;
use super::touching_borders::close_touching_borders;
use super::unsewn_pairs::UnsewnLoopPairs;
use crate::boundary::{self, boundary_loops};
use crate::fill::{self, HoleStatus, Keep, LoopSelection, fill_holes};
use crate::repair::near_borders::NearBorders;
use crate::repair::orient::{self, Outward, turn_outwards};
use crate::repair::sew::{Sew, sew};
use crate::repair::weld::weld;
use crate::stitch::{Finish, IndexMap};
use crate::trim::{KeptFacesOfPieces, TrimmedPieces};
use gusset_base::alloc;
use gusset_base::error::Result;
use gusset_base::job::Job;
use gusset_base::sort::sort_distinct;
use gusset_mesh::{Defect, MeshView, NONE, concat, unordered};
use std::slice;

/// The combined pieces, welded and oriented.
pub(super) struct CombinedPieces {
    pub(super) assembly: Assembly,
    /// For each vertex of the mesh, the first piece that it comes from.
    pub(super) piece_of_vertex: Vec<u32>,
    /// The number of faces of the pieces. Faces of strips follow.
    pub(super) old_face_count: usize,
    /// The vertices that sewing merged from several, ascending.
    pub(super) vertices_merged_by_sewing: Vec<u32>,
    /// The largest distance between coincident vertices; 0 if borders are not sewn.
    pub(super) tolerance: f64,
    /// Pairs of overlapping pieces, which agree in orientation.
    pub(super) overlapping_pairs: Vec<[u32; 2]>,
}

impl CombinedPieces {
    /// Combines the pieces. `trimmed` has the remaining parts of the pieces if they were trimmed.
    pub(super) fn new(
        pieces: &[MeshView<'_>],
        trimmed: Option<&KeptFacesOfPieces>,
        options: &Options<'_>,
        job: &Job<'_>,
    ) -> Result<Self> {
        let start = &job.sub_job(0.0, 0.0);
        let TrimmedPieces { mut mesh, piece_offsets: places, mut vertex_map, mut face_map, faces, corners } =
            match trimmed {
                Some(trimmed) => TrimmedPieces::new(pieces, trimmed, start)?,
                None => place_pieces_side_by_side(pieces, start)?,
            };
        let trimmed_faces = face_map.iter().filter(|&&f| f == NONE).count() as u32;
        let (mut welded_vertices, mut sewn_edges, mut splits, mut tolerance) = (0, 0, 0, 0.0);
        let mut near = NearBorders::default();
        let (mut seam, mut joints) = (Vec::new(), Vec::new());
        let mut history = History::new(pieces)?;
        if let Some(how) = &options.weld {
            let (view, part) = (mesh.view(&job.sub_job(0.0, 0.1))?, job.sub_job(0.1, 0.5));
            let mut sewn = match options.edge_to_edge {
                true => Sew::from_weld(weld(&view, how, &part.sub_job(0.0, 0.8))?)?,
                false => sew(&view, how, &part.sub_job(0.0, 0.8))?,
            };
            let vertices_of = |sewn_map: &[u32], selector: Selector| {
                let Some(place) = places.get(selector.piece as usize) else { return Ok(Vec::new()) };
                let of_piece = &vertex_map[place.first_vertex as usize..];
                let of_piece = &of_piece[..pieces[selector.piece as usize].positions().len()];
                let named = match selector.vertex {
                    NONE => of_piece,
                    vertex => of_piece.get(vertex as usize).map(slice::from_ref).unwrap_or_default(),
                };
                alloc::gather(named.iter().filter(|&&v| v != NONE).map(|&v| sewn_map[v as usize]))
            };
            near = sewn.near;
            let unsewn_pairs = |sewn_map: &[u32], job: &Job<'_>| {
                let names = vertex_map.iter().map(|&v| if v == NONE { NONE } else { sewn_map[v as usize] });
                UnsewnLoopPairs::find(pieces, options, names, job)
            };
            joints = close_touching_borders(&mut sewn, options, vertices_of, unsewn_pairs, &part.sub_job(0.8, 1.0))?;
            (welded_vertices, sewn_edges, splits, tolerance) =
                (sewn.welded_vertices, sewn.sewn_edges, sewn.splits, sewn.tolerance);
            let through = |before: &mut [u32], after: &[u32]| {
                before.iter_mut().filter(|v| **v != NONE).for_each(|v| *v = after[*v as usize]);
            };
            through(&mut vertex_map, &sewn.vertex_map);
            through(&mut face_map, &sewn.face_map);
            (mesh, seam) = (sewn.mesh, sewn.seam_vertices);
            (history.corner_origins, history.face_origin) = (sewn.corner_origins, Some(sewn.face_origin));
            history.add_parents(sewn.new_vertices.iter().map(|&([a, b], at)| ([a, b, b], [1.0 - at, at, 0.0])))?;
        }
        if trimmed.is_some() {
            history.compose_with_trimming(faces, corners);
        }
        let mut turned = alloc::filled(false, mesh.face_count())?;
        let mut one_sided = Vec::new();
        if !options.keep_orientation && mesh.face_count() > 0 {
            let how = orient::Options::default();
            let oriented = orient::orient(&mesh.view(&job.sub_job(0.5, 0.6))?, &how, &job.sub_job(0.6, 1.0))?;
            (mesh, turned) = (oriented.mesh, oriented.turned);
            one_sided = alloc::collect(oriented.one_sided.iter().map(|component| component.face))?;
        }
        let mut piece = alloc::filled(NONE, mesh.positions.len())?;
        let mut maps = alloc::with_capacity(pieces.len())?;
        for (k, (view, place)) in pieces.iter().zip(&places).enumerate() {
            let vertices = &vertex_map[place.first_vertex as usize..][..view.positions().len()];
            let faces = &face_map[place.first_face as usize..][..view.faces().len()];
            for &v in vertices.iter().filter(|&&v| v != NONE) {
                piece[v as usize] = piece[v as usize].min(k as u32);
            }
            maps.push(IndexMap { vertices: alloc::copied(vertices)?, faces: alloc::copied(faces)? });
        }
        let piece_faces = history.face_origin.as_ref().map_or(mesh.face_count(), Vec::len);
        let done = Assembly {
            mesh,
            maps,
            turned,
            trimmed_faces,
            lost_faces: Vec::new(),
            welded_vertices,
            sewn_edges,
            splits,
            near,
            one_sided,
            zero_volume: Vec::new(),
            joints,
            left: Vec::new(),
            holes: Vec::new(),
            hole_intersections: None,
            hole_cut_lengths: Vec::new(),
            hole_rims: Vec::new(),
            history,
            loops_left: 0,
            near_loops_left: 0,
            non_manifold_edges: 0,
        };
        let alike = trimmed.map_or(Ok(Vec::new()), |trimmed| alloc::copied(&trimmed.pairs))?;
        Ok(CombinedPieces {
            assembly: done,
            piece_of_vertex: piece,
            old_face_count: piece_faces,
            vertices_merged_by_sewing: seam,
            tolerance,
            overlapping_pairs: alike,
        })
    }

    /// Ends joining: the list of turned faces keeps the faces of the pieces.
    pub(super) fn into_joined(self) -> Assembly {
        let mut assembly = self.assembly;
        assembly.turned.truncate(self.old_face_count);
        assembly
    }

    /// Fills holes and turns components, as the options request. Also returns the pairs of
    /// intersecting faces, at least one of which belongs to a patch.
    pub(super) fn fill_and_turn(self, options: &Options<'_>, job: &Job<'_>) -> Result<(Assembly, Vec<[u32; 2]>)> {
        let mut assembly = self.into_joined();
        let mut cuts = Vec::new();
        if assembly.mesh.face_count() == 0 {
            return Ok((assembly, cuts));
        }
        if let Some(how) = &options.fill {
            let finish = match options.strip.finish {
                Finish::Blend => Finish::Blend,
                Finish::Strip => how.finish,
            };
            let keep = match (how.keep, options.overlaps) {
                (Keep::Auto, Overlaps::Trim(_)) => Keep::OuterBorders,
                (keep, _) => keep,
            };
            let how = fill::Options { outward: Outward::Keep, plan_only: false, keep, finish, ..*how };
            let filled = fill_holes(
                &assembly.mesh.view(&job.sub_job(0.0, 0.1))?,
                LoopSelection::All,
                &how,
                &job.sub_job(0.1, 0.4),
            )?;
            (assembly.mesh, assembly.holes, assembly.hole_rims) = (filled.mesh, filled.holes, filled.rims);
            cuts = alloc::copied(filled.intersections.as_deref().unwrap_or_default())?;
            assembly.hole_intersections = filled.intersections;
            mark_filled_loops(&mut assembly)?;
            assembly.history.add_parents(filled.parents.into_iter().zip(filled.weights))?;
        }
        let is_near = |left: &&LeftLoop| matches!(left.reason, Reason::LooksAway | Reason::Taken | Reason::NotJoined);
        assembly.near_loops_left = assembly.left.iter().filter(|left| !left.filled).filter(is_near).count() as u32;
        if assembly.near_loops_left > 0 {
            let count = assembly.near_loops_left;
            job.note(&format!(
                "loops left although others are near: {count}; the report of the assembly gives the reasons"
            ));
        }
        if options.outward == Outward::Closed && !options.keep_orientation {
            let outwards = turn_outwards(&mut assembly.mesh, &job.sub_job(0.4, 0.6))?;
            assembly.zero_volume = outwards.zero_volume;
            if !assembly.zero_volume.is_empty() {
                let count = assembly.zero_volume.len();
                job.note(&format!("closed components without volume: {count}; give each piece only once"));
            }
            for f in outwards.turned {
                // The faces of strips and patches follow the faces of the pieces.
                if let Some(turned) = assembly.turned.get_mut(f as usize) {
                    *turned ^= true;
                }
            }
        }
        let view = assembly.mesh.view(&job.sub_job(0.6, 0.7))?;
        let boundary = boundary_loops(&view, &boundary::Options::default(), &job.sub_job(0.7, 1.0))?;
        assembly.loops_left = boundary.len() as u32;
        let is_edge = |defect: &&Defect| matches!(defect, Defect::NonManifoldEdge { .. });
        assembly.non_manifold_edges = boundary.defects().iter().filter(is_edge).count() as u32;
        assembly.add_report_details(&job.sub_job(1.0, 1.0))?;
        Ok((assembly, cuts))
    }
}

/// Marks the left loops all of whose edges are edges of filled holes.
fn mark_filled_loops(assembly: &mut Assembly) -> Result<()> {
    let edges = |vertices: &[u32]| {
        let next = vertices.iter().copied().cycle().skip(1);
        alloc::gather(vertices.iter().copied().zip(next).map(|(u, v)| unordered([u, v])))
    };
    let mut filled = Vec::new();
    for hole in assembly.holes.iter().filter(|hole| hole.status == HoleStatus::Filled) {
        alloc::append(&mut filled, &edges(&assembly.hole_rims[hole.rim.clone()])?)?;
    }
    sort_distinct(&mut filled);
    for left in &mut assembly.left {
        left.filled = edges(&left.vertices)?.iter().all(|edge| filled.binary_search(edge).is_ok());
    }
    Ok(())
}

/// Places the pieces side by side. All faces and corners remain, so their origins are empty.
fn place_pieces_side_by_side(pieces: &[MeshView<'_>], job: &Job<'_>) -> Result<TrimmedPieces> {
    let (mesh, places) = concat::concatenate(pieces, job)?;
    let vertex_map = alloc::collect(0..mesh.positions.len() as u32)?;
    let face_map = alloc::collect(0..mesh.face_count() as u32)?;
    Ok(TrimmedPieces { mesh, piece_offsets: places, vertex_map, face_map, faces: Vec::new(), corners: Vec::new() })
}
