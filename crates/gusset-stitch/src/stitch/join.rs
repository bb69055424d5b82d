//! The stages of stitching in order, from two loops to one mesh.

use super::attach_strip::{AttachedStrips, attach_strip};
use super::combine::append_piece;
use super::common_points::{find_common_points, keep_mergeable_points, merge_common_points};
use super::existing_edges::ExistingEdges;
use super::extent::{Extent, select_arcs};
use super::facing::{self, check_tolerance};
use super::loop_pairing::{remove_nearest_pair, usable_rims};
use super::quality::Quality;
use super::section_strips::attach_section_strips;
use super::sense::{arcs_run_the_same_way, rims_disagree};
use super::stitch_request::{IndexMap, Options, Orientation, Request, Stitch};
use super::stitch_rim::{FreeEdges, Rim, shared_vertex};
use crate::boundary::{self, Boundary, boundary_loops};
use crate::repair::orient::{Outward, turn_outwards};
use gusset_base::alloc;
use gusset_base::error::{Error, Result, Side};
use gusset_base::geom::scale::common_unit;
use gusset_base::job::Job;
use gusset_mesh::{MeshView, concat, vertex_components};

/// Stitches two boundary loops, or their facing arcs, together by a strip of new faces.
///
/// If the loops are not given, the nearest pair is chosen. The distance of two loops is the mean
/// distance from the vertices of each to the nearest vertex of the other, the larger of both means.
/// Old positions never change, and every old face is kept.
///
/// An arc with one vertex gets a fan of triangles, which touches its piece only at that vertex. Two
/// arcs with one vertex each get one meridian and no face.
///
/// Rims may have points in common, up to the rounding of the positions. Their vertices are merged, and
/// strips without rows join the rims between them; a note reports it. Other rims get faces without
/// area where a vertex lies inside an edge. [`assemble`](crate::assemble::assemble()) splits such edges.
///
/// O(H log d) for the meshes' H half-edges and at most d edges at a vertex. Exact meridians take
/// O(N M) up to 2^21 pairs of vertices; larger lattices and the simple choices take O((N + M) log
/// M). The choice of loops adds a box test for each pair. Fairing n new vertices in k rows takes
/// O(n k^2). Intersection tests take O((n + F) log n) for F old faces in the strip's box. Each pair
/// of triangles with overlapping boxes adds a test: all pairs in the worst case, a wide fan. Extra
/// memory is linear in the meshes and the strip, except for
/// [`MeridianSearch::Exact`](super::MeridianSearch).
///
/// # Errors
/// [`Error::NoLoop`], [`Error::NoPairOfLoops`], [`Error::LoopTooShort`],
/// [`Error::LoopRepeatsVertex`], [`Error::LoopEdgeNotFree`], [`Error::LoopNotOriented`],
/// [`Error::LoopsShareVertex`], [`Error::PlanesUndecided`], [`Error::OrientationConflict`],
/// [`Error::NoStrip`], [`Error::OptionOutOfRange`], [`Error::MixedScalars`], [`Error::TooLarge`],
/// [`Error::OutOfMemory`], [`Error::Cancelled`].
pub fn stitch(request: &Request<'_>, options: &Options, job: &Job<'_>) -> Result<Stitch> {
    // Arcs do not admit a twist, even if the planes select whole loops.
    if matches!(options.extent, Extent::OpenArcs | Extent::Arcs(_)) {
        Error::require(options.twist == 0, "twist", options.twist as f64, "0 between arcs")?;
    }
    let RimsInCommonUnit { mut a, mut b, unit } = choose_rims(request, &job.sub_job(0.0, 0.35))?;
    cut_arcs(request, options, [&mut a, &mut b], unit, &job.sub_job(0.35, 0.4))?;
    let existing = match request.b {
        Some(_) => ExistingEdges::empty(),
        None => {
            if let Some(vertex) = shared_vertex(&a, &b)? {
                return Err(Error::LoopsShareVertex { vertex });
            }
            ExistingEdges::find(request.a, &a, &b)?
        }
    };

    let turn = must_turn(request, &a, &b, options.orientation)?;
    if turn {
        job.note(match request.b {
            Some(_) => "the pieces disagree in orientation: the second one was turned over",
            None => "the loops' components disagree in orientation: the second loop's component was turned over",
        });
    }
    options.note_unread_options(job);
    let options = &options.strip_options();

    // Combine both pieces in one mesh. Only the component of rim B is turned over.
    let mut pieces = vec![request.a];
    pieces.extend(request.b);
    let mut whole = concat::empty_mesh_with_room(pieces.iter().copied(), [0; 3])?;
    let mesh_b = request.b.unwrap_or(request.a);
    let mut turned_faces = if turn { faces_of_component(mesh_b, b.vertices[0])? } else { Vec::new() };
    let is_turned = |f: usize| turned_faces.binary_search(&(f as u32)).is_ok();
    let mut maps = match request.b {
        Some(second) => {
            let first = append_piece(&mut whole, request.a, &job.sub_job(0.4, 0.4), |_| false)?;
            [first, append_piece(&mut whole, second, &job.sub_job(0.4, 0.4), is_turned)?]
        }
        None => [append_piece(&mut whole, request.a, &job.sub_job(0.4, 0.4), is_turned)?, IndexMap::default()],
    };
    let map_b = if request.b.is_some() { &maps[1] } else { &maps[0] };
    a.vertices.iter_mut().for_each(|v| *v = maps[0].vertices[*v as usize]);
    b.vertices.iter_mut().for_each(|v| *v = map_b.vertices[*v as usize]);
    turned_faces.iter_mut().for_each(|f| *f = map_b.faces[*f as usize]);

    // On one oriented surface the rims run in opposite directions. Reverse B, so that they run side
    // by side.
    if turn {
        b.adapt_to_turned_surface();
    }
    b.reverse();
    let part = job.sub_job(0.4, 0.75);
    // A twist joins other points than the common ones.
    let mut common = match options.twist {
        0 => find_common_points(&whole, &a, &b, unit, &part.sub_job(0.0, 0.0))?,
        _ => Vec::new(),
    };
    if !common.is_empty() {
        keep_mergeable_points(&whole, &a, &b, &mut common, &part.sub_job(0.0, 0.1))?;
    }
    let AttachedStrips { mut strip, faces, rims, closed, meridians, matrix, parents, weights, checked } =
        if common.is_empty() {
            attach_strip(&mut whole, [a, b], unit, &existing, options, &part)?
        } else {
            let of_maps = maps.iter_mut().map(|map| &mut map.vertices);
            merge_common_points(&mut whole, [&mut a, &mut b], &common, of_maps)?;
            attach_section_strips(&mut whole, [a, b], common, unit, options, &part.sub_job(0.1, 1.0))?
        };
    let measured = if options.outward == Outward::Closed { 0.9 } else { 1.0 };
    let quality = Quality::measure(&whole, &strip, &job.sub_job(0.75, measured))?;
    let mut turned_outwards = Vec::new();
    if options.outward == Outward::Closed {
        turned_outwards = turn_outwards(&mut whole, &job.sub_job(measured, 1.0))?.turned;
        let of_strip = turned_outwards.iter().filter_map(|f| f.checked_sub(faces.start));
        of_strip.for_each(|f| strip.turn_face(f as usize));
    }
    Ok(Stitch {
        rims,
        closed,
        rows: (matrix.len() / meridians.len()) as u32 - 2,
        matrix,
        parents,
        weights,
        mesh: whole,
        strip,
        maps,
        intersections: checked.intersections,
        strip_faces: faces,
        meridians,
        finish: checked.finish,
        back_offs: checked.back_offs,
        turned: turn,
        turned_faces,
        turned_outwards,
        quality,
    })
}

/// Returns the faces of the component that contains a vertex, ascending.
fn faces_of_component(mesh: &MeshView<'_>, v: u32) -> Result<Vec<u32>> {
    let mut components = vertex_components(mesh)?;
    let own = components.find(v);
    let mut is_own = |f: &u32| mesh.face(*f as usize).next().is_some_and(|v| components.find(v) == own);
    alloc::gather((0..mesh.faces().len() as u32).filter(|f| is_own(f)))
}

/// Cuts the rims to the arcs that the options select.
fn cut_arcs(request: &Request<'_>, options: &Options, [a, b]: [&mut Rim; 2], unit: f64, job: &Job<'_>) -> Result<()> {
    check_tolerance(options.tolerance)?;
    let how =
        facing::Options { run: options.run, tolerance: options.tolerance.map(|t| t / unit), centres: options.centres };
    // The round-off is determined by the coarser scalar type.
    let scalar = request.b.unwrap_or(request.a).positions().scalar().min(request.a.positions().scalar());
    if let Some([arc_a, arc_b]) = select_arcs(a, b, options.extent, &how, scalar, job)? {
        a.cut_to_arc(arc_a)?;
        b.cut_to_arc(arc_b)?;
    }
    Ok(())
}

/// Two rims, each with its surface on the left, in a common unit.
struct RimsInCommonUnit {
    a: Rim,
    b: Rim,
    unit: f64,
}

fn choose_rims(request: &Request<'_>, job: &Job<'_>) -> Result<RimsInCommonUnit> {
    let options = boundary::Options::default();
    let boundary_a = boundary_loops(request.a, &options, &job.sub_job(0.0, 0.4))?;
    let second = request.b.map(|b| boundary_loops(b, &options, &job.sub_job(0.4, 0.8))).transpose()?;
    let (mesh_b, boundary_b) = (request.b.unwrap_or(request.a), second.as_ref().unwrap_or(&boundary_a));

    let rims = |mesh: &MeshView<'_>, boundary: &Boundary, vertices: Option<&[u32]>, side| match vertices {
        Some(vertices) => Ok(vec![Rim::from_vertices(mesh, &FreeEdges::from_boundary(boundary)?, vertices, side)?]),
        None => usable_rims(mesh, boundary),
    };
    let mut a = rims(request.a, &boundary_a, request.loop_a, Side::A)?;
    let mut b = rims(mesh_b, boundary_b, request.loop_b, Side::B)?;
    // Scale to a unit that keeps products of coordinates in range.
    let unit = common_unit(a.iter().chain(&b).flat_map(|rim| &rim.points));
    a.iter_mut().chain(&mut b).flat_map(|rim| &mut rim.points).for_each(|p| *p /= unit);
    if request.loop_a.is_some() && request.loop_b.is_some() {
        return Ok(RimsInCommonUnit { a: a.swap_remove(0), b: b.swap_remove(0), unit });
    }
    let (a, b) = remove_nearest_pair(a, b, request.b.is_none(), &job.sub_job(0.8, 1.0))?;
    Ok(RimsInCommonUnit { a, b, unit })
}

/// Returns true if the second piece must be turned over.
fn must_turn(request: &Request<'_>, a: &Rim, b: &Rim, orientation: Orientation) -> Result<bool> {
    if orientation == Orientation::Keep {
        return Ok(false);
    }
    if !(if a.closed { rims_disagree(a, b)? } else { arcs_run_the_same_way(&a.points, &b.points)? }) {
        return Ok(false);
    }
    if request.b.is_none() {
        let mut components = vertex_components(request.a)?;
        if components.find(a.vertices[0]) == components.find(b.vertices[0]) {
            return Ok(false);
        }
    }
    match orientation {
        Orientation::Refuse => Err(Error::OrientationConflict { face: b.face }),
        _ => Ok(true),
    }
}
