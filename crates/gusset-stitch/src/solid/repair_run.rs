//! The stages of a repair in order.

use super::corner_place::CornerPlace;
use super::duplicate_removal::mark_duplicates;
use super::edge_fans::EdgeFans;
use super::filled_holes::fill_open_holes;
use super::flat_faces::remove_flat_faces;
use super::largest_move::measure_largest_move;
use super::mesh_shape::MeshShape;
use super::near_gaps::close_near_gaps;
use super::patches::Patches;
use super::repair_request::{DropReason, History, Options, Repaired};
use super::repair_state::RepairState;
use super::settled_stages::{SettledStages, Stage};
use super::sew_borders::{SewCounts, sew_borders};
use super::sheet_pairs::Sheets;
use super::twin_edges::split_twin_edges;
use super::united_parts::{unite_all_faces, unite_parts};
use super::vertex_contacts::separate_vertex_contacts;
use crate::arrange::find_unbalanced_face;
use crate::check::{check, find_intersecting_faces, find_zero_area_faces};
use crate::repair::orient::{self, Outward, orient};
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::geom::disjoint_sets::DisjointSets;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, NONE, Opposite, Topology, concat};

/// Largest number of times that the stages run. A patch can have faces without area, and separated
/// sheets can have borders that coincide.
const MAX_ROUNDS: usize = 4;

/// Largest number of times that all rounds run. Each closing of gaps can bring others within reach.
const MAX_PASSES: usize = 16;

/// Largest number of unions of all faces.
const MAX_UNIONS: usize = 3;

const STAGE: &str = "repairing";

/// Repairs a mesh: see [the stages](super).
///
/// O(H log H) for H half-edges, plus the time of [`fill_holes`](crate::fill::fill_holes()) for each
/// hole, and of the search for intersecting faces. Linear extra memory. A second repair changes
/// nothing, unless the stages do not settle in the largest number of passes.
///
/// # Errors
/// * [`Error::OptionOutOfRange`](gusset_base::Error::OptionOutOfRange) for a tolerance that is
///   negative or not finite.
/// * The errors of [`fill_holes`](crate::fill::fill_holes()) for its options.
/// * [`Error::TooLarge`](gusset_base::Error::TooLarge),
///   [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
///   [`Error::Cancelled`](gusset_base::Error::Cancelled). Defects that remain are not errors; see
///   [`Repaired::after`].
pub fn repair(mesh: &MeshView<'_>, options: &Options, job: &Job<'_>) -> Result<Repaired> {
    let mut run = RepairRun::start(&[*mesh], options, &job.sub_job(0.0, 0.1))?;
    run.run_rounds(&job.sub_job(0.1, 0.8))?;
    run.conclude(&[*mesh], &job.sub_job(0.8, 1.0))
}

/// Returns the union of closed pieces: the border of all points whose winding number is at least 1.
///
/// Pieces may intersect, touch, coincide or lie within each other, and intersect themselves. Walls of cavities look
/// into the cavities. Faces that no other meets stay as they are; see [`unite`](crate::arrange::unite()). Vertices and
/// faces of the input are numbered piece after piece.
///
/// O((n + k) log n) for n triangles and k intersecting pairs.
///
/// # Errors
/// * [`Error::MeshNotClosed`](gusset_base::Error::MeshNotClosed) for a piece with a border, or with neighbouring faces that
///   are oriented differently.
/// * [`Error::EmptyMesh`](gusset_base::Error::EmptyMesh), [`Error::MixedScalars`](gusset_base::Error::MixedScalars),
///   [`Error::TooLarge`](gusset_base::Error::TooLarge), [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
///   [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn unite_solids(pieces: &[MeshView<'_>], job: &Job<'_>) -> Result<Repaired> {
    // Faces that rounding makes flat are dropped, and what this makes intersect is united again.
    let options = Options {
        leave_borders: true,
        leave_duplicates: true,
        leave_non_manifold: true,
        leave_holes: true,
        leave_fins: true,
        leave_orientation: true,
        ..Options::default()
    };
    let mut run = RepairRun::start(pieces, &options, &job.sub_job(0.0, 0.05))?;
    require_closed(pieces, |piece, job| has_border(piece, |_| true, job), &job.sub_job(0.05, 0.1))?;
    for pass in 0..MAX_UNIONS {
        let job = job.sub_job(0.1, 0.8).sub_job_of_item(pass, MAX_UNIONS);
        match unite_all_faces(&mut run.state, &job.sub_job(0.0, 0.6)) {
            // All edges have two faces, but some pass an edge in the same direction.
            Err(Error::MeshNotClosed { .. }) if pass == 0 => {
                require_closed(pieces, |_, _| Ok(true), &job.sub_job(0.9, 1.0))?;
            }
            Err(Error::MeshNotClosed { .. }) => break,
            done => done?,
        }
        run.run_rounds(&job.sub_job(0.6, 0.95))?;
        // Rounding can fold faces onto each other, which the next union removes.
        if run.intersections.as_ref().is_some_and(Vec::is_empty)
            && !run.has_border(|_| true, &job.sub_job(0.95, 1.0))?
        {
            break;
        }
    }
    run.conclude(pieces, &job.sub_job(0.8, 1.0))
}

/// Fails for the first piece that `is_doubtful` and not closed by itself.
fn require_closed(
    pieces: &[MeshView<'_>],
    is_doubtful: impl Fn(&MeshView<'_>, &Job<'_>) -> Result<bool>,
    job: &Job<'_>,
) -> Result<()> {
    for (input, piece) in pieces.iter().enumerate() {
        let job = job.sub_job_of_item(input, pieces.len());
        if is_doubtful(piece, &job.sub_job(0.0, 0.3))? {
            let found = find_unbalanced_face(piece, &job.sub_job(0.3, 1.0))?;
            found.map_or(Ok(()), |face| Err(Error::MeshNotClosed { input: input as u32, face }))?;
        }
    }
    Ok(())
}

/// Returns true if `counts` returns true for an edge that does not have exactly two faces.
fn has_border(mesh: &MeshView<'_>, counts: impl Fn(Opposite) -> bool, job: &Job<'_>) -> Result<bool> {
    let topology = Topology::new(mesh, &job.sub_job(0.0, 0.9))?;
    let border = topology.border_half_edges(&job.sub_job(0.9, 1.0))?;
    Ok(border.iter().any(|&h| counts(topology.opposite(h))))
}

/// The counts of changes that a result states.
#[derive(Clone, Copy, Default)]
struct ChangeCounts {
    sewing: SewCounts,
    split_vertices: u32,
    filled_holes: u32,
}

/// A repair in progress.
struct RepairRun<'o> {
    options: &'o Options,
    /// The numbers of vertices, corners and faces of each piece.
    inputs: Vec<[usize; 3]>,
    state: RepairState,
    settled: SettledStages,
    counts: ChangeCounts,
    /// A face of the input of each sheet that was attached, and one of the sheet that it was attached to.
    attached_faces: Vec<[u32; 2]>,
    /// The pairs of faces that intersect, if the last stage found them and changed nothing.
    intersections: Option<Vec<[u32; 2]>>,
}

impl<'o> RepairRun<'o> {
    fn start(pieces: &[MeshView<'_>], options: &'o Options, job: &Job<'_>) -> Result<Self> {
        let (whole, _) = concat::concatenate(pieces, job)?;
        let state = RepairState::unchanged(whole)?;
        let counts =
            |piece: &MeshView<'_>| [piece.positions().len(), piece.faces().half_edge_count(), piece.faces().len()];
        Ok(RepairRun {
            options,
            inputs: alloc::collect(pieces.iter().map(counts))?,
            state,
            settled: SettledStages::default(),
            counts: ChangeCounts::default(),
            attached_faces: Vec::new(),
            intersections: None,
        })
    }

    /// Returns the result, with the defects that remain.
    fn conclude(self, pieces: &[MeshView<'_>], job: &Job<'_>) -> Result<Repaired> {
        let RepairRun { mut state, inputs, counts, intersections, .. } = self;
        let places = state.finish(inputs.iter().map(|&[.., faces]| faces).sum())?;
        let (after, intersections) = {
            let view = state.mesh.view(&job.sub_job(0.0, 0.1))?;
            let after = check(&view, &job.sub_job(0.1, 0.5))?;
            let search = |_| find_intersecting_faces(&view, &job.sub_job(0.5, 1.0));
            (after, intersections.ok_or(()).or_else(search)?)
        };
        let tolerance = measure_largest_move(&state, pieces)?;
        job.step(1.0, STAGE)?;
        Ok(Repaired {
            history: history(&state, pieces, inputs, &places)?,
            mesh: state.mesh,
            face_origin: state.face_origin,
            vertex_origin: state.vertex_origin,
            turned: state.turned,
            dropped: state.dropped,
            welded_vertices: counts.sewing.welded_vertices,
            sewn_edges: counts.sewing.sewn_edges,
            split_faces: counts.sewing.split_faces,
            split_vertices: counts.split_vertices,
            filled_holes: counts.filled_holes,
            tolerance,
            after,
            intersections,
        })
    }

    /// Sews borders, unless the options leave them.
    fn sew(&mut self, round: usize, job: &Job<'_>) -> Result<()> {
        if !self.options.leave_borders && self.has_border(is_free, &job.sub_job(0.0, 0.2))? {
            let counts = sew_borders(&mut self.state, self.options.tolerance, round == 0, &job.sub_job(0.2, 0.8))?;
            self.counts.sewing.add(&counts);
            if round == 0 && self.options.tolerance.is_none() {
                self.counts.sewing.add(&close_near_gaps(&mut self.state, &job.sub_job(0.8, 1.0))?);
            }
        }
        Ok(())
    }

    /// Returns true if `counts` returns true for an edge that does not have exactly two faces.
    fn has_border(&self, counts: impl Fn(Opposite) -> bool, job: &Job<'_>) -> Result<bool> {
        has_border(&self.state.mesh.view(&job.sub_job(0.0, 0.3))?, counts, &job.sub_job(0.3, 1.0))
    }

    /// Runs all stages until nothing changes. Borders of separated sheets stay apart within a pass, and meet in the
    /// next one, as in a second repair. A pass is the last if it settles without a border, or only numbers vertices anew.
    fn run_rounds(&mut self, job: &Job<'_>) -> Result<()> {
        let mut shape = MeshShape::from_mesh(&self.state.mesh)?;
        for pass in 0..MAX_PASSES {
            // Later passes are shorter.
            let [start, end] = [pass, pass + 1].map(|pass| pass as f64 / (pass + 1) as f64);
            let job = job.sub_job(start, end);
            let (before, counts) = (self.state.revision(), self.counts);
            let mut is_settled = false;
            for round in 0..MAX_ROUNDS {
                let revision = self.state.revision();
                self.run_stages(round, &job.sub_job(0.0, 0.95).sub_job_of_item(round, MAX_ROUNDS))?;
                is_settled = self.state.revision() == revision;
                if is_settled {
                    break;
                }
            }
            if self.state.revision() == before || is_settled && !self.has_border(is_free, &job.sub_job(0.95, 1.0))? {
                break;
            }
            let last = std::mem::replace(&mut shape, MeshShape::from_mesh(&self.state.mesh)?);
            if shape == last {
                // The pass joined what it separated again.
                self.counts = counts;
                break;
            }
        }
        Ok(())
    }

    /// Runs all stages once, except those that have nothing more to do.
    fn run_stages(&mut self, round: usize, job: &Job<'_>) -> Result<()> {
        let sewing = if round == 0 { Stage::FirstSewing } else { Stage::LaterSewing };
        self.run_stage(sewing, &job.sub_job(0.0, 0.05), |run, job| run.sew(round, job))?;
        self.run_stage(Stage::FlatFaces, &job.sub_job(0.05, 0.1), Self::drop_flat_faces)?;
        self.run_stage(Stage::Duplicates, &job.sub_job(0.1, 0.2), Self::drop_duplicates)?;
        self.run_stage(Stage::Contacts, &job.sub_job(0.2, 0.25), Self::separate_contacts)?;
        self.run_stage(Stage::Holes, &job.sub_job(0.25, 0.5), Self::fill_holes)?;
        let changes = self.state.changes;
        self.run_stage(Stage::Sheets, &job.sub_job(0.5, 0.7), Self::separate_sheets)?;
        if self.state.changes != changes {
            self.run_stage(Stage::Holes, &job.sub_job(0.7, 0.85), Self::fill_holes)?;
        }
        self.drop_fins(&job.sub_job(0.85, 0.9))?;
        self.run_stage(Stage::Orientation, &job.sub_job(0.9, 0.92), Self::turn_outwards)?;
        self.run_stage(Stage::Intersections, &job.sub_job(0.92, 1.0), Self::remove_intersections)
    }

    /// Runs a stage, unless it has nothing more to do.
    fn run_stage(
        &mut self,
        stage: Stage,
        job: &Job<'_>,
        run: impl FnOnce(&mut Self, &Job<'_>) -> Result<()>,
    ) -> Result<()> {
        let before = self.state.revision();
        if !self.settled.contains(stage, before) {
            run(self, job)?;
            self.settled.record(stage, before, self.state.revision());
        }
        Ok(())
    }

    /// Unites the closed parts that intersect, or finds the faces that do.
    fn remove_intersections(&mut self, job: &Job<'_>) -> Result<()> {
        if self.options.leave_intersections {
            return Ok(());
        }
        self.intersections = unite_parts(&mut self.state, job)?;
        Ok(())
    }

    fn drop_flat_faces(&mut self, job: &Job<'_>) -> Result<()> {
        if self.options.leave_flat_faces {
            return Ok(());
        }
        let flat = find_zero_area_faces(&self.state.mesh.view(&job.sub_job(0.0, 0.1))?, &job.sub_job(0.1, 0.3))?;
        remove_flat_faces(&mut self.state, flat, find_zero_area_faces, &job.sub_job(0.3, 1.0))
    }

    fn drop_duplicates(&mut self, job: &Job<'_>) -> Result<()> {
        if self.options.leave_duplicates {
            return Ok(());
        }
        let marked = mark_duplicates(&self.state.mesh.view(&job.sub_job(0.0, 0.1))?, &job.sub_job(0.1, 1.0))?;
        marked.map_or(Ok(()), |reasons| self.state.drop_faces(&reasons))
    }

    /// Separates components that share vertices, but no edges.
    fn separate_contacts(&mut self, job: &Job<'_>) -> Result<()> {
        if self.options.leave_non_manifold {
            return Ok(());
        }
        let contacts = separate_vertex_contacts(&mut self.state, job)?;
        self.counts.split_vertices += contacts.copies;
        contacts.faces.iter().try_for_each(|&[f, g]| self.list_attached([[f, g], [g, f]]))
    }

    /// Lists pairs of an attached sheet's face and its host's face, by their faces of the input.
    fn list_attached<const N: usize>(&mut self, pairs: [[u32; 2]; N]) -> Result<()> {
        for pair in pairs {
            let origins = pair.map(|f| self.state.face_origin[f as usize]);
            if !origins.contains(&NONE) {
                alloc::push(&mut self.attached_faces, origins)?;
            }
        }
        Ok(())
    }

    /// Fills the holes, without changing other faces.
    fn fill_holes(&mut self, job: &Job<'_>) -> Result<()> {
        if self.options.leave_holes || !self.has_border(is_free, &job.sub_job(0.0, 0.2))? {
            return Ok(());
        }
        self.counts.filled_holes += fill_open_holes(&mut self.state, &self.options.fill, &job.sub_job(0.2, 1.0))?;
        Ok(())
    }

    /// Separates sheets that share edges or vertices.
    fn separate_sheets(&mut self, job: &Job<'_>) -> Result<()> {
        if self.options.leave_non_manifold {
            return Ok(());
        }
        let (sheets, topology) = self.find_sheets(&job.sub_job(0.0, 0.4))?;
        let separated = sheets.pairs.len();
        let (copies, attached) = sheets.separate(&mut self.state, &topology, &job.sub_job(0.4, 0.6))?;
        attached.into_iter().try_for_each(|pair| self.list_attached([pair]))?;
        if separated > 0 {
            let (twins, _) = self.find_sheets(&job.sub_job(0.6, 0.9))?;
            split_twin_edges(&mut self.state, &twins.pairs, &job.sub_job(0.9, 1.0))?;
        }
        self.counts.split_vertices += copies;
        Ok(())
    }

    fn find_sheets(&self, job: &Job<'_>) -> Result<(Sheets, Topology)> {
        let view = self.state.mesh.view(&job.sub_job(0.0, 0.1))?;
        let topology = Topology::new(&view, &job.sub_job(0.1, 0.3))?;
        let fans = EdgeFans::find(&view, &topology, &job.sub_job(0.3, 0.5))?;
        let patches = Patches::find(&view, &topology, &fans, &job.sub_job(0.5, 0.6))?;
        let sheets = Sheets::find(&view, &topology, &fans, &patches, &job.sub_job(0.6, 1.0))?;
        Ok((sheets, topology))
    }

    /// Drops the open sheets that were attached to a sheet which is closed now and has a larger area, and
    /// the open sheets attached to those. Attachments at patches are not known.
    fn drop_fins(&mut self, job: &Job<'_>) -> Result<()> {
        if self.options.leave_fins || self.attached_faces.is_empty() {
            return Ok(());
        }
        let reasons = {
            let view = self.state.mesh.view(&job.sub_job(0.0, 0.2))?;
            let topology = Topology::new(&view, &job.sub_job(0.2, 0.6))?;
            let faces = view.faces();
            let mut sets = DisjointSets::new(faces.len())?;
            let mut is_open = alloc::filled(false, faces.len())?;
            for h in (0..faces.half_edge_count() as u32).filter(|&h| !topology.is_ignored(h)) {
                job.sub_job(0.6, 0.8).step_within_list(h as usize, STAGE)?;
                match topology.opposite(h) {
                    Opposite::Mate(mate) => _ = sets.union(faces.face_of_half_edge(h), faces.face_of_half_edge(mate)),
                    _ => is_open[faces.face_of_half_edge(h) as usize] = true,
                }
            }
            let components = sets.into_roots(&job.sub_job(0.8, 1.0), STAGE)?;
            let mut areas = alloc::filled(0.0, faces.len())?;
            for f in 0..faces.len() {
                let root = components[f] as usize;
                is_open[root] |= is_open[f];
                areas[root] += area(&view, f);
            }
            let mut is_fin = alloc::filled(false, faces.len())?;
            let inputs = self.state.face_origin.iter().filter(|&&f| f != NONE).map(|&f| f as usize + 1).max();
            let mut face_of_input = alloc::filled(NONE, inputs.unwrap_or(0))?;
            for (f, &origin) in (0..).zip(&self.state.face_origin).filter(|&(_, &origin)| origin != NONE) {
                face_of_input[origin as usize] = f;
            }
            let component = |origin: u32| match face_of_input.get(origin as usize) {
                Some(&f) if f != NONE => Some(components[f as usize] as usize),
                _ => None,
            };
            // The area of a closed component, and of the host of a fin: fins can hold fins.
            let mut host_areas = alloc::filled(0.0, faces.len())?;
            (0..faces.len()).filter(|&f| !is_open[f]).for_each(|f| host_areas[f] = areas[f]);
            let mut is_changed = true;
            while std::mem::take(&mut is_changed) {
                job.step(0.9, STAGE)?;
                for &[sheet, host] in &self.attached_faces {
                    let (Some(sheet), Some(host)) = (component(sheet), component(host)) else { continue };
                    if is_open[sheet] && !is_fin[sheet] && areas[sheet] < host_areas[host] {
                        (is_fin[sheet], host_areas[sheet], is_changed) = (true, host_areas[host], true);
                    }
                }
            }
            alloc::collect(components.iter().map(|&root| is_fin[root as usize].then_some(DropReason::Fin)))?
        };
        self.state.drop_faces(&reasons)
    }

    /// Orients components consistently, and closed ones outwards.
    fn turn_outwards(&mut self, job: &Job<'_>) -> Result<()> {
        if self.options.leave_orientation {
            return Ok(());
        }
        let oriented = {
            let view = self.state.mesh.view(&job.sub_job(0.0, 0.1))?;
            orient(&view, &orient::Options { outward: Outward::Closed }, &job.sub_job(0.1, 1.0))?
        };
        (0..oriented.turned.len()).filter(|&f| oriented.turned[f]).for_each(|f| self.state.turn_face(f));
        Ok(())
    }
}

fn is_free(opposite: Opposite) -> bool {
    opposite == Opposite::Free
}

/// Returns the area of a face: the length of its vector area.
fn area(mesh: &MeshView<'_>, f: usize) -> f64 {
    let mut corners = mesh.face(f).map(|v| mesh.positions().get(v));
    let (Some(origin), Some(second)) = (corners.next(), corners.next()) else { return 0.0 };
    let mut before = second - origin;
    let mut sum = DVec3::ZERO;
    for p in corners {
        sum += before.cross(p - origin);
        before = p - origin;
    }
    sum.length() / 2.0
}

/// Returns the origins of corners and new vertices.
fn history(
    state: &RepairState,
    pieces: &[MeshView<'_>],
    inputs: Vec<[usize; 3]>,
    places: &[CornerPlace],
) -> Result<History> {
    let vertex = |mut corner: u32| {
        let mut first = 0;
        for piece in pieces {
            if (corner as usize) < piece.faces().half_edge_count() {
                return first + piece.faces().corner(corner);
            }
            corner -= piece.faces().half_edge_count() as u32;
            first += piece.positions().len() as u32;
        }
        NONE
    };
    let on_vertices = |place: &CornerPlace| {
        (place.corners.map(|corner| if corner == NONE { NONE } else { vertex(corner) }), place.weights)
    };
    let placed = alloc::collect(places.iter().map(on_vertices))?;
    let mut history = History { inputs, placed, ..History::default() };
    let old_faces = state.face_origin.iter().position(|&f| f == NONE).unwrap_or(state.face_origin.len());
    history.corners = alloc::copied(&state.corner_places[..state.mesh.face_offsets[old_faces] as usize])?;
    history.parents = alloc::collect(state.new_vertices.iter().map(|&(_, parents, _)| parents))?;
    history.weights = alloc::collect(state.new_vertices.iter().map(|&(.., weights)| weights))?;
    Ok(history)
}
