//! The whole of stitching: from two loops to one mesh.

use super::combine::{Combination, IndexMap, strip_alone};
use super::meridian::{Pair, index_rule::index_meridians, min_area::min_area};
use super::pairing::{nearest_pair, usable_rims};
use super::quality::Quality;
use super::rim::{Bridges, FreeEdges, Rim, shared_vertex};
use super::sense::run_the_same_way;
use super::start::closest_pair;
use super::strip::triangles;
use crate::alloc;
use crate::boundary::{self, Boundary, boundary_loops};
use crate::error::{Error, Result, Side};
use crate::geom::scale::common_unit;
use crate::job::Job;
use crate::mesh::{Mesh, MeshView, Sets};
use std::ops::Range;

/// How meridians are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Meridians {
    /// The strip of least area, by exact dynamic programming: O(N M).
    #[default]
    MinArea,
    /// The paper's rule by index: O(N + M). Good for evenly spaced rims.
    Index,
}

/// What happens if the second piece is oriented against the first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Orientation {
    /// Its faces are turned over. Two loops of one connected piece are taken as they are: turning is no way out there.
    #[default]
    Fix,
    /// [`Error::OrientationConflict`].
    Refuse,
    /// The rims are not compared: the faces are taken to be right as they are.
    Keep,
}

/// How to stitch.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// The choice of meridians.
    pub meridians: Meridians,
    /// What to do about a second piece that is inside out.
    pub orientation: Orientation,
    /// The first meridian joins the closest pair; with a twist, the vertex of rim B that comes this many places later,
    /// counted in the direction in which rim A runs (negative: earlier).
    pub twist: i64,
}

/// What to stitch: two loops of two meshes, or of one.
///
/// A loop is the list of its vertices in order, in either direction, each consecutive pair (and the last with the first)
/// being an edge with exactly one face. `None` leaves the choice open: the nearest loops are taken, see
/// [`stitch()`].
#[derive(Clone, Copy)]
pub struct Request<'a> {
    /// The first piece.
    pub a: &'a MeshView<'a>,
    /// Its loop.
    pub loop_a: Option<&'a [u32]>,
    /// The second piece; `None` if both loops are of the first.
    pub b: Option<&'a MeshView<'a>>,
    /// The second loop.
    pub loop_b: Option<&'a [u32]>,
}

/// The result of stitching.
#[derive(Debug, Clone, PartialEq)]
pub struct Stitch {
    /// Both pieces and the strip: vertices of A, then of B; faces of A, then of B, then the strip. Positions are in the scalar
    /// type of A and keep their bits.
    pub mesh: Mesh,
    /// The strip alone: the N vertices of rim A in order, then the M of rim B, and N + M triangles.
    pub strip: Mesh,
    /// Old indices to new ones, for each piece; the second is empty if there is only one piece.
    pub maps: [IndexMap; 2],
    /// The strip's faces in [`Stitch::mesh`].
    pub strip_faces: Range<u32>,
    /// The vertices of each rim in [`Stitch::mesh`], from the first meridian on, side by side: rim A has its surface on the
    /// left, rim B on the right.
    pub rims: [Vec<u32>; 2],
    /// The meridians as places (i, j) on the rims, from (0, 0) to (N, M); place N is place 0 again. The paper's matrix H.
    pub meridians: Vec<Pair>,
    /// The second piece was turned over.
    pub turned: bool,
    /// Measures of the result.
    pub quality: Quality,
}

/// Stitches two boundary loops together by a closed band of triangles.
///
/// Loops that are left open are chosen as the two nearest ones: the least mean distance from the vertices of each to the
/// nearest vertex of the other. Positions are never changed, no vertex is added, and every face is kept.
///
/// O(H log d) for the meshes' H half-edges, plus O(N M) ([`Meridians::MinArea`]) or O(N + M) ([`Meridians::Index`]) and O((N + M) log M).
/// Extra memory is linear in the meshes and the table's of [`Meridians::MinArea`]: one byte for each of N M pairs, at most 64 MiB, and
/// 48 (M + 1) (1 + N M / 2^26) bytes.
///
/// # Errors
/// [`Error::NoLoop`], [`Error::LoopTooShort`], [`Error::LoopRepeatsVertex`], [`Error::LoopEdgeNotFree`], [`Error::LoopNotOriented`],
/// [`Error::LoopsShareVertex`], [`Error::OrientationConflict`], [`Error::NoStrip`], [`Error::MixedScalars`], [`Error::TooLarge`],
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn stitch(request: &Request<'_>, options: &Options, job: &Job<'_>) -> Result<Stitch> {
    let (mut a, mut b) = choose_rims(request, &job.part(0.0, 0.4))?;
    let bridges = match request.b {
        Some(_) => Bridges::none(),
        None => {
            if let Some(vertex) = shared_vertex(&a, &b)? {
                return Err(Error::LoopsShareVertex { vertex });
            }
            Bridges::between(request.a, &a, &b)?
        }
    };

    // On one oriented surface the rims run opposite ways; run B backwards, and they run side by side.
    let turn = must_turn(request, &a, &b, options.orientation)?;
    if turn {
        job.note("the second piece was inside out and has been turned over");
    } else {
        b.reverse();
    }
    let (i, j) = closest_pair(&a, &b, &bridges)?.ok_or(Error::NoStrip { vertex: a.vertices[0] })?;
    a.start_at(i);
    let count = b.vertices.len() as i64;
    b.start_at((j as i64 + options.twist.rem_euclid(count)).rem_euclid(count) as usize);

    let meridians = choose_meridians(&a, &b, &bridges, options.meridians, &job.part(0.4, 0.7))?;
    let triangles = triangles(&a, &b, &meridians, &bridges)?;
    job.step(0.7, "putting the pieces together")?;

    let mut pieces = vec![request.a];
    pieces.extend(request.b);
    let mut whole = Combination::new(&pieces, triangles.len())?;
    let maps = match request.b {
        Some(second) => [whole.append(request.a, |_| false)?, whole.append(second, |_| turn)?],
        None if turn => {
            let mut components = Sets::of_vertices(request.a)?;
            let root = components.root(b.vertices[0]);
            let is_second = |f: usize| request.a.face(f).next().is_some_and(|v| components.root(v) == root);
            [whole.append(request.a, is_second)?, IndexMap::default()]
        }
        None => [whole.append(request.a, |_| false)?, IndexMap::default()],
    };
    let map_b = if request.b.is_some() { &maps[1] } else { &maps[0] };
    let rim_a = alloc::collect(a.vertices.iter().map(|&v| maps[0].vertices[v as usize]))?;
    let rim_b = alloc::collect(b.vertices.iter().map(|&v| map_b.vertices[v as usize]))?;
    let strip_faces = whole.append_strip(&triangles, &rim_a, &rim_b);
    let mesh = whole.mesh;
    let strip = strip_alone(&mesh, &triangles, &rim_a, &rim_b)?;
    let quality = Quality::of(&mesh, &strip, &job.part(0.75, 1.0))?;
    Ok(Stitch { mesh, strip, maps, strip_faces, rims: [rim_a, rim_b], meridians, turned: turn, quality })
}

fn choose_meridians(a: &Rim, b: &Rim, bridges: &Bridges, rule: Meridians, job: &Job<'_>) -> Result<Vec<Pair>> {
    match rule {
        Meridians::Index => index_meridians(a.vertices.len() as u32, b.vertices.len() as u32),
        Meridians::MinArea => {
            let taken = |i: usize, j: usize| bridges.has(a.vertices[i], b.vertices[j]);
            let forbidden = (!bridges.is_empty()).then_some(taken);
            min_area(&a.points, &b.points, forbidden, job)?.ok_or(Error::NoStrip { vertex: a.vertices[0] })
        }
    }
}

/// The two rims, each with its surface on the left.
fn choose_rims(request: &Request<'_>, job: &Job<'_>) -> Result<(Rim, Rim)> {
    let options = boundary::Options::default();
    let boundary_a = boundary_loops(request.a, &options, &job.part(0.0, 0.4))?;
    let second = request.b.map(|b| boundary_loops(b, &options, &job.part(0.4, 0.8))).transpose()?;
    let (mesh_b, boundary_b) = (request.b.unwrap_or(request.a), second.as_ref().unwrap_or(&boundary_a));

    let rims = |mesh: &MeshView<'_>, boundary: &Boundary, vertices: Option<&[u32]>, side| match vertices {
        Some(vertices) => Ok(vec![Rim::given(mesh, &FreeEdges::of(boundary)?, vertices, side)?]),
        None => usable_rims(mesh, boundary),
    };
    let mut a = rims(request.a, &boundary_a, request.loop_a, Side::A)?;
    let mut b = rims(mesh_b, boundary_b, request.loop_b, Side::B)?;
    // From here on in a unit that keeps products of coordinates in range.
    let unit = common_unit(a.iter().chain(&b).flat_map(|rim| &rim.points));
    a.iter_mut().chain(&mut b).flat_map(|rim| &mut rim.points).for_each(|p| *p /= unit);
    if request.loop_a.is_some() && request.loop_b.is_some() {
        return Ok((a.swap_remove(0), b.swap_remove(0)));
    }
    nearest_pair(a, b, request.b.is_none(), &job.part(0.8, 1.0))
}

/// True if the second piece has to be turned over.
fn must_turn(request: &Request<'_>, a: &Rim, b: &Rim, orientation: Orientation) -> Result<bool> {
    if orientation == Orientation::Keep || !run_the_same_way(&a.points, &b.points) {
        return Ok(false);
    }
    if request.b.is_none() {
        let mut components = Sets::of_vertices(request.a)?;
        if components.root(a.vertices[0]) == components.root(b.vertices[0]) {
            return Ok(false);
        }
    }
    match orientation {
        Orientation::Refuse => Err(Error::OrientationConflict { face: b.face }),
        _ => Ok(true),
    }
}
