//! Consistent orientation of faces.
//!
//! Two faces at an edge with exactly two faces agree if they run it in opposite directions. A
//! breadth-first search from the smallest face of each component determines for every face whether
//! it agrees with the first face. The smaller side is turned over. If an edge contradicts the
//! search (a Moebius strip), the component is not orientable and stays unchanged. Edges with three
//! or more faces do not connect components, and neither do degenerate faces. A turned face keeps
//! its first corner.
//!
//! O(H log d) for H half-edges and at most d edges at a vertex, to pair the half-edges; the rest is
//! linear.

use super::nesting::ClosedComponents;
use glam::DVec3;
use gusset_base::alloc;
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{Mesh, MeshView, NONE, Opposite, Topology, concat};
use std::slice;

/// The side that closed components face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Outward {
    /// The side that most of the faces already face.
    #[default]
    Keep,
    /// Away from the solid that the closed components bound. A component that an even number of
    /// others encloses faces outwards. A component that an odd number encloses bounds a cavity, and
    /// faces inwards. Components that cross, or touch in more than vertices and edges, do not
    /// enclose each other.
    Closed,
}

choices! { for Outward:
    Keep => "Majority", "The orientation of most of their faces.";
    Closed => "Outwards", "Outwards; the walls of cavities face into the cavities.";
}

/// Options of [`orient`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// The side that closed components face.
    pub outward: Outward,
}

/// A component that is not orientable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OneSided {
    /// The smallest face of the component.
    pub face: u32,
    /// The smallest half-edge at which faces disagree, if faces along the breadth-first search
    /// agree.
    pub half_edge: u32,
}

/// An oriented mesh. Faces, vertices and half-edges keep their indices, except the half-edges of
/// turned faces.
#[derive(Debug, Clone, PartialEq)]
pub struct Oriented {
    /// The mesh. Positions keep their bits.
    pub mesh: Mesh,
    /// For each face, true if it was turned over.
    pub turned: Vec<bool>,
    /// The number of turned faces.
    pub turned_faces: u32,
    /// The number of components: sets of faces connected by edges with two faces. A degenerate face
    /// is its own component.
    pub components: u32,
    /// The number of closed components in which [`Outward::Closed`] overruled the majority.
    pub inverted_components: u32,
    /// The components that are not orientable, by their smallest faces.
    pub one_sided: Vec<OneSided>,
}

/// Number of faces between two progress reports.
const FACES_PER_REPORT: usize = 1 << 16;

const STAGE: &str = "orienting faces";

/// Makes the orientation of each component consistent, and turns over as few faces as possible. If
/// both sides have the same number of faces, the component's smallest face stays. Extra memory:
/// about 20 bytes per half-edge.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn orient(mesh: &MeshView<'_>, options: &Options, job: &Job<'_>) -> Result<Oriented> {
    let topology = Topology::new(mesh, &job.sub_job(0.0, 0.5))?;
    let count = mesh.faces().len();
    let mut turned = alloc::filled(false, count)?;
    let mut search = ComponentSearch::new(mesh, &topology)?;
    let (mut components, mut one_sided, mut closed) = (0, Vec::new(), ClosedComponents::default());
    for f in 0..count as u32 {
        if search.is_seen[f as usize] {
            continue;
        }
        components += 1;
        search.find_component(f, &mut turned, &job.sub_job(0.5, 0.9))?;
        let component = &search.component_faces;
        if search.half_edge != NONE {
            component.iter().for_each(|&g| turned[g as usize] = false);
            alloc::push(&mut one_sided, OneSided { face: f, half_edge: search.half_edge })?;
            continue;
        }
        let against = component.iter().filter(|&&g| turned[g as usize]).count();
        if 2 * against > component.len() {
            component.iter().for_each(|&g| turned[g as usize] ^= true);
        }
        if options.outward == Outward::Closed && search.is_closed {
            closed.push(component)?;
        }
    }
    let facing = Facing::new(mesh, &closed, &turned, &job.sub_job(0.9, 0.9))?;
    let inverted_components = facing.inward.len() as u32;
    for face in facing.inward.iter().flat_map(|&k| closed.faces(k)) {
        turned[*face as usize] ^= true;
    }
    job.step(0.9, STAGE)?;
    let mut oriented = concat::empty_mesh_with_room(slice::from_ref(mesh).iter(), [0; 3])?;
    concat::append_piece(&mut oriented, mesh, &job.sub_job(0.9, 0.9), |f| turned[f])?;
    job.step(1.0, STAGE)?;
    let turned_faces = turned.iter().filter(|&&t| t).count() as u32;
    Ok(Oriented { mesh: oriented, turned, turned_faces, components, inverted_components, one_sided })
}

/// Turns over, each as a whole, the closed and consistently oriented components of `mesh` that face
/// the wrong side; see [`Outward::Closed`].
///
/// The sign of its volume tells the side that a component faces. Every other component stays
/// unchanged: open ones, ones with an edge of three or more faces, ones whose faces disagree, and
/// ones whose volume is 0 up to rounding. Open components enclose nothing. A note to the host
/// reports it if a component is turned.
///
/// O(H log d) time, and about 20 bytes per half-edge, like [`orient`]. If the box of one component
/// contains the box of another, O(n log n) for their n faces, plus the faces that one ray from each
/// component meets.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn turn_outwards(mesh: &mut Mesh, job: &Job<'_>) -> Result<Outwards> {
    if mesh.face_count() == 0 {
        return Ok(Outwards::default());
    }
    let mut found = find_wrong_components(&mesh.view(&job.sub_job(0.0, 0.1))?, &job.sub_job(0.1, 0.95))?;
    job.step(0.95, STAGE)?;
    sort(&mut found.turned, Ord::cmp, &job.sub_job(0.95, 1.0), STAGE)?;
    for &f in &found.turned {
        mesh.turn_face(f as usize);
    }
    if !found.turned.is_empty() {
        let count = found.turned.len();
        job.note(&format!("faces turned over, because their closed components faced the wrong side: {count}"));
    }
    Ok(found)
}

/// The closed, consistently oriented components that were turned over or have no volume.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Outwards {
    /// The faces that were turned over, ascending.
    pub turned: Vec<u32>,
    /// One face of each component whose volume is 0 up to rounding. It stays unchanged.
    pub zero_volume: Vec<u32>,
}

/// Finds the components that face the wrong side, and those without volume.
pub(crate) fn find_wrong_components(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Outwards> {
    let topology = Topology::new(mesh, &job.sub_job(0.0, 0.6))?;
    let mut against = alloc::filled(false, mesh.faces().len())?;
    let mut search = ComponentSearch::new(mesh, &topology)?;
    let mut closed = ClosedComponents::default();
    for f in 0..mesh.faces().len() as u32 {
        if search.is_seen[f as usize] {
            continue;
        }
        search.find_component(f, &mut against, &job.sub_job(0.6, 0.8))?;
        let component = &search.component_faces;
        let consistent = search.half_edge == NONE && !component.iter().any(|&g| against[g as usize]);
        if search.is_closed && consistent {
            closed.push(component)?;
        }
    }
    let facing = Facing::new(mesh, &closed, &against, &job.sub_job(0.8, 1.0))?;
    let turned = alloc::gather(facing.inward.iter().flat_map(|&k| closed.faces(k)).copied())?;
    let zero_volume = alloc::collect(facing.zero_volume.iter().map(|&k| closed.faces(k)[0]))?;
    Ok(Outwards { turned, zero_volume })
}

/// The closed components that face the wrong side, and those without volume; ascending.
struct Facing {
    inward: Vec<usize>,
    zero_volume: Vec<usize>,
}

impl Facing {
    /// Judges each component by its volume and by the components that enclose it. `turned` marks
    /// faces that are turned over.
    fn new(mesh: &MeshView<'_>, closed: &ClosedComponents, turned: &[bool], job: &Job<'_>) -> Result<Self> {
        let depths = closed.depths(mesh, &job.sub_job(0.0, 0.9))?;
        let mut facing = Facing { inward: Vec::new(), zero_volume: Vec::new() };
        for (k, depth) in depths.iter().enumerate() {
            match is_inside_out(mesh, closed.faces(k), turned, &job.sub_job(0.9, 1.0))? {
                Some(inside_out) if inside_out != (depth % 2 == 1) => alloc::push(&mut facing.inward, k)?,
                Some(_) => {}
                None => alloc::push(&mut facing.zero_volume, k)?,
            }
        }
        Ok(facing)
    }
}

/// The breadth-first search through one component after another.
struct ComponentSearch<'m> {
    mesh: &'m MeshView<'m>,
    topology: &'m Topology,
    is_seen: Vec<bool>,
    /// The faces of the component, in the order of the search.
    component_faces: Vec<u32>,
    /// The number of faces of all components so far.
    reached_face_count: usize,
    /// The smallest contradicting half-edge, or [`NONE`].
    half_edge: u32,
    /// True if every edge of the component has two faces.
    is_closed: bool,
}

impl<'m> ComponentSearch<'m> {
    fn new(mesh: &'m MeshView<'m>, topology: &'m Topology) -> Result<Self> {
        let count = mesh.faces().len();
        Ok(ComponentSearch {
            mesh,
            topology,
            is_seen: alloc::filled(false, count)?,
            component_faces: alloc::with_capacity(count)?,
            reached_face_count: 0,
            half_edge: NONE,
            is_closed: true,
        })
    }

    /// Finds the component of face `f`. Marks in `turned` the faces that disagree with `f`.
    fn find_component(&mut self, f: u32, turned: &mut [bool], job: &Job<'_>) -> Result<()> {
        let faces = self.mesh.faces();
        (self.half_edge, self.is_closed) = (NONE, true);
        self.component_faces.clear();
        self.component_faces.push(f);
        self.is_seen[f as usize] = true;
        let mut next = 0;
        while let Some(&f) = self.component_faces.get(next) {
            job.step_every(FACES_PER_REPORT, self.reached_face_count, faces.len(), STAGE)?;
            self.reached_face_count += 1;
            next += 1;
            let proper = |&h: &u32| !self.topology.is_ignored(h);
            for h in faces.corner_range(f as usize).map(|h| h as u32).filter(proper) {
                let Opposite::Mate(mate) = self.topology.opposite(h) else {
                    self.is_closed = false;
                    continue;
                };
                let g = faces.face_of_half_edge(mate) as usize;
                let wanted = turned[f as usize] ^ (faces.corner(h) == faces.corner(mate));
                if !self.is_seen[g] {
                    self.is_seen[g] = true;
                    turned[g] = wanted;
                    self.component_faces.push(g as u32);
                } else if turned[g] != wanted {
                    self.half_edge = self.half_edge.min(h);
                }
            }
        }
        Ok(())
    }
}

/// Returns whether a closed set of faces, turned as `turned` marks, has a negative volume; `None`
/// if it is 0 up to rounding.
///
/// By the divergence theorem, 6 V = sum of p ((q - p) x (r - p)) over triangles p, q, r.
/// Coordinates are relative to a vertex of the set, in a power-of-two unit of its size.
fn is_inside_out(mesh: &MeshView<'_>, faces: &[u32], turned: &[bool], job: &Job<'_>) -> Result<Option<bool>> {
    let point = |v: u32| mesh.positions().get(v);
    let corners = || faces.iter().flat_map(|&f| mesh.face(f as usize));
    // Halve the coordinates, so that differences of the largest numbers do not overflow.
    let Some(first) = corners().next() else { return Ok(None) };
    let origin = point(first) * 0.5;
    let relative = |v: u32| point(v) * 0.5 - origin;
    let unit = common_unit(&[corners().map(relative).fold(DVec3::ZERO, |most, p| most.max(p.abs()))]);
    let at = |v: u32| relative(v) / unit;
    let (mut sum, mut size) = (0.0, 0.0);
    for (k, &f) in faces.iter().enumerate() {
        // Small components do not report progress.
        if k % FACES_PER_REPORT == FACES_PER_REPORT - 1 {
            job.step(0.0, STAGE)?;
        }
        let mut corners = mesh.face(f as usize).map(at);
        let (Some(first), Some(second)) = (corners.next(), corners.next()) else { continue };
        let mut before: DVec3 = second - first;
        for p in corners {
            let side = p - first;
            let term: f64 = first.dot(before.cross(side));
            sum += if turned[f as usize] { -term } else { term };
            size += first.length() * before.length() * side.length();
            before = side;
        }
    }
    let rounding = f64::EPSILON * (16.0 + faces.len() as f64) * size;
    Ok((f64::abs(sum) > rounding).then_some(sum < 0.0))
}
