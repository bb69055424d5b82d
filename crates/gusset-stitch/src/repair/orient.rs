//! Orientation: faces are turned over until neighbours agree.
//!
//! Two faces at an edge of exactly two agree if they run it in opposite directions. From the
//! smallest face of each component on, a breadth-first search across such edges says of every face
//! whether it agrees with the first one; the smaller side is turned. A component where some edge
//! contradicts the search (a Moebius strip) cannot be oriented and stays as it is. Edges of three
//! or more faces connect nothing, nor do degenerate faces. A turned face keeps its first corner.
//! O(H log d) for H half-edges and at most d edges at a vertex, which pairing the half-edges takes;
//! the rest is linear.

use glam::DVec3;
use gusset_base::alloc;
use gusset_base::choices;
use gusset_base::error::Result;
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_base::sort::sort;
use gusset_mesh::{Across, Mesh, MeshView, NONE, Topology, concat};
use std::slice;

/// Which way closed components face.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Outward {
    /// As most of their faces do.
    #[default]
    Keep,
    /// Outwards, each by its own volume: of shells inside one another each one encloses what is
    /// within it.
    Closed,
}

choices! { for Outward:
    Keep => "Majority", "The orientation of most of their faces.";
    Closed => "Outwards", "Outwards, each by its own volume, even inside others.";
}

/// How to orient.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// What becomes of closed components.
    pub outward: Outward,
}

/// A component that cannot be oriented.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OneSided {
    /// Its smallest face.
    pub face: u32,
    /// The smallest half-edge at which its faces disagree when those along the breadth-first search
    /// agree.
    pub half_edge: u32,
}

/// An oriented mesh. Faces, half-edges and vertices have their old numbers, but for the half-edges
/// of turned faces.
#[derive(Debug, Clone, PartialEq)]
pub struct Oriented {
    /// The mesh; positions keep their bits.
    pub mesh: Mesh,
    /// Per face, whether it was turned over.
    pub turned: Vec<bool>,
    /// How many were.
    pub turned_faces: u32,
    /// Sets of faces that hang together across edges with two faces; a degenerate face is one of
    /// its own.
    pub components: u32,
    /// Closed components that face outwards now and, turning as few faces as possible, would not.
    pub inverted_components: u32,
    /// The components that cannot be oriented, by their smallest faces.
    pub one_sided: Vec<OneSided>,
}

/// Faces between two progress reports.
const REPORT_INTERVAL: usize = 1 << 16;

const STAGE: &str = "orienting faces";

/// Makes the orientation of each component consistent, turning as few faces as possible; where both
/// sides are as many, the component's smallest face stays. Extra memory: about 20 bytes a
/// half-edge.
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn orient(mesh: &MeshView<'_>, options: &Options, job: &Job<'_>) -> Result<Oriented> {
    let topology = Topology::new(mesh, &job.part(0.0, 0.5))?;
    let count = mesh.faces().len();
    let mut turned = alloc::filled(false, count)?;
    let mut search = Search::new(mesh, &topology)?;
    let (mut components, mut inverted_components, mut one_sided) = (0, 0, Vec::new());
    for f in 0..count as u32 {
        if search.seen[f as usize] {
            continue;
        }
        components += 1;
        search.component(f, &mut turned, &job.part(0.5, 0.9))?;
        let found = &search.found;
        if search.half_edge != NONE {
            found.iter().for_each(|&g| turned[g as usize] = false);
            alloc::push(&mut one_sided, OneSided { face: f, half_edge: search.half_edge })?;
            continue;
        }
        let against = found.iter().filter(|&&g| turned[g as usize]).count();
        let mut invert = 2 * against > found.len();
        if options.outward == Outward::Closed && search.closed {
            // What faces inwards as the search left it is to be inverted.
            let inward = faces_inward(mesh, found, &turned, &job.part(0.9, 0.9))?.unwrap_or(invert);
            inverted_components += u32::from(inward != invert);
            invert = inward;
        }
        if invert {
            found.iter().for_each(|&g| turned[g as usize] ^= true);
        }
    }
    job.step(0.9, STAGE)?;
    let mut oriented = concat::empty(slice::from_ref(mesh).iter(), [0; 3])?;
    concat::append(&mut oriented, mesh, &job.part(0.9, 0.9), |f| turned[f])?;
    job.step(1.0, STAGE)?;
    let turned_faces = turned.iter().filter(|&&t| t).count() as u32;
    Ok(Oriented { mesh: oriented, turned, turned_faces, components, inverted_components, one_sided })
}

/// Turns over, each as a whole, the components of `mesh` that are closed, consistently oriented and
/// face inwards: their volume is negative by more than rounding. Every other component stays as it
/// is, bit for bit: an open one, one with an edge of three or more faces, one whose faces disagree.
/// Of shells inside one another each one faces outwards then, the walls of a cavity too. A note to
/// the host says so if anything is turned.
///
/// O(H log d), and about 20 bytes a half-edge, as for [`orient`].
///
/// # Errors
/// [`Error::OutOfMemory`](gusset_base::Error::OutOfMemory),
/// [`Error::Cancelled`](gusset_base::Error::Cancelled).
pub fn turn_outwards(mesh: &mut Mesh, job: &Job<'_>) -> Result<Outwards> {
    if mesh.face_count() == 0 {
        return Ok(Outwards::default());
    }
    let mut found = inward_components(&mesh.view(&job.part(0.0, 0.1))?, &job.part(0.1, 0.95))?;
    job.step(0.95, STAGE)?;
    sort(&mut found.turned, Ord::cmp, &job.part(0.95, 1.0), STAGE)?;
    for &f in &found.turned {
        mesh.turn_face(f as usize);
    }
    if !found.turned.is_empty() {
        job.note("what is closed and was inside out has been turned over");
    }
    Ok(found)
}

/// The closed, consistently oriented components that do not face outwards.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Outwards {
    /// The faces that were turned over, ascending.
    pub turned: Vec<u32>,
    /// A face of each component that encloses no volume up to rounding, and stays as it is.
    pub zero_volume: Vec<u32>,
}

/// What faces inwards, and what neither way.
fn inward_components(mesh: &MeshView<'_>, job: &Job<'_>) -> Result<Outwards> {
    let topology = Topology::new(mesh, &job.part(0.0, 0.6))?;
    let mut against = alloc::filled(false, mesh.faces().len())?;
    let mut search = Search::new(mesh, &topology)?;
    let mut outwards = Outwards::default();
    for f in 0..mesh.faces().len() as u32 {
        if search.seen[f as usize] {
            continue;
        }
        search.component(f, &mut against, &job.part(0.6, 1.0))?;
        let found = &search.found;
        let consistent = search.half_edge == NONE && !found.iter().any(|&g| against[g as usize]);
        if search.closed && consistent {
            match faces_inward(mesh, found, &against, &job.part(1.0, 1.0))? {
                Some(true) => alloc::append(&mut outwards.turned, found)?,
                Some(false) => {}
                None => alloc::push(&mut outwards.zero_volume, f)?,
            }
        }
    }
    Ok(outwards)
}

/// The search through one component after another.
struct Search<'m> {
    mesh: &'m MeshView<'m>,
    topology: &'m Topology,
    seen: Vec<bool>,
    /// The faces of the component, in the order found.
    found: Vec<u32>,
    /// How many faces all components had so far.
    reached: usize,
    /// The smallest half-edge that contradicts, or none.
    half_edge: u32,
    /// Every edge of the component has two faces.
    closed: bool,
}

impl<'m> Search<'m> {
    fn new(mesh: &'m MeshView<'m>, topology: &'m Topology) -> Result<Self> {
        let count = mesh.faces().len();
        Ok(Search {
            mesh,
            topology,
            seen: alloc::filled(false, count)?,
            found: alloc::with_capacity(count)?,
            reached: 0,
            half_edge: NONE,
            closed: true,
        })
    }

    /// Finds the component of face `f`, and in `turned` which of its faces disagree with `f`.
    fn component(&mut self, f: u32, turned: &mut [bool], job: &Job<'_>) -> Result<()> {
        let faces = self.mesh.faces();
        (self.half_edge, self.closed) = (NONE, true);
        self.found.clear();
        self.found.push(f);
        self.seen[f as usize] = true;
        let mut next = 0;
        while let Some(&f) = self.found.get(next) {
            job.step_every(REPORT_INTERVAL, self.reached, faces.len(), STAGE)?;
            self.reached += 1;
            next += 1;
            let proper = |&h: &u32| !self.topology.is_ignored(h);
            for h in faces.range(f as usize).map(|h| h as u32).filter(proper) {
                let Across::Mate(mate) = self.topology.across(h) else {
                    self.closed = false;
                    continue;
                };
                let g = faces.face_of(mate) as usize;
                let wanted = turned[f as usize] ^ (faces.corner(h) == faces.corner(mate));
                if !self.seen[g] {
                    self.seen[g] = true;
                    turned[g] = wanted;
                    self.found.push(g as u32);
                } else if turned[g] != wanted {
                    self.half_edge = self.half_edge.min(h);
                }
            }
        }
        Ok(())
    }
}

/// Whether a closed set of faces, turned as `turned` says, has a negative volume; `None` if it is 0
/// up to rounding.
///
/// By the divergence theorem, 6 V = sum of p ((q - p) x (r - p)) over triangles p, q, r, with
/// coordinates from a vertex of the set in a power-of-two unit of its size.
fn faces_inward(mesh: &MeshView<'_>, found: &[u32], turned: &[bool], job: &Job<'_>) -> Result<Option<bool>> {
    let point = |v: u32| mesh.positions().get(v);
    let corners = || found.iter().flat_map(|&f| mesh.face(f as usize));
    // Halves, so that differences of the largest numbers do not overflow.
    let Some(first) = corners().next() else { return Ok(None) };
    let origin = point(first) * 0.5;
    let relative = |v: u32| point(v) * 0.5 - origin;
    let unit = common_unit(&[corners().map(relative).fold(DVec3::ZERO, |most, p| most.max(p.abs()))]);
    let at = |v: u32| relative(v) / unit;
    let (mut sum, mut size) = (0.0, 0.0);
    for (k, &f) in found.iter().enumerate() {
        // Many components of few faces each report nothing.
        if k % REPORT_INTERVAL == REPORT_INTERVAL - 1 {
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
    let rounding = f64::EPSILON * (16.0 + found.len() as f64) * size;
    Ok((f64::abs(sum) > rounding).then_some(sum < 0.0))
}
