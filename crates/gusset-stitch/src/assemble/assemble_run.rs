//! The stages of assembly in order, from pieces to one mesh and its report.

use super::assemble_request::{Assembly, Joint, LeftLoop, MaxGap, Options, Outcome, Overlaps, Reason};
use super::candidates::FacingLoops;
use super::combined_pieces::CombinedPieces;
use super::covered_faces::list_lost_faces;
use super::face_removals::FaceRemovals;
use super::given_pair::GivenLoopPair;
use super::piece_loops::PieceLoops;
use super::unsewn_pairs::UnsewnLoopPairs;
use crate::stitch::combine::append_strip;
use crate::stitch::existing_edges::ExistingEdges;
use crate::stitch::facing::Arc;
use crate::stitch::fair_and_check::fair_and_check;
use crate::stitch::loop_pairing::mean_gap;
use crate::stitch::rim_order::RimOrder;
use crate::stitch::stitch_rim::{Rim, have_coincident_vertices, shared_vertex};
use crate::stitch::strip::Strip;
use crate::stitch::{self, Finish, Intersections, Rows};
use crate::trim::{KeptFacesOfPieces, trim};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_mesh::{Mesh, MeshView, NONE};

/// Default widths of gaps between trimmed pieces, in mean edges of the coarsest; the second applies
/// if parts would stay unjoined.
const DEFAULT_GAP_MEAN_EDGES: [f64; 2] = [2.5, 4.0];
/// Number of rounds that remove faces of trimmed pieces where they cannot be joined.
const MAX_REMOVAL_ROUNDS: u32 = 10;
/// Number of first rounds that accept intersecting strips and remove faces around them. Later
/// rounds refuse such strips.
const ROUNDS_WITH_INTERSECTING_STRIPS: u32 = 4;
/// After this number of rounds, the whole rim of a patch that still intersects is removed.
const MAX_ROUNDS_BEFORE_WHOLE_RIM: u32 = 6;
/// Number of additional passes over loops that the strips left facing each other.
const ADDITIONAL_JOINING_PASSES: usize = 2;

/// Assembles open pieces into one mesh.
///
/// As the options request, coincident borders are sewn, components oriented consistently, loops
/// that face each other across a gap stitched, holes filled, and closed components turned outwards.
///
/// O(H log d) for the pieces' H half-edges, O(V log V) for the V vertices on loops, plus the time
/// of each strip as for [`stitch()`](crate::stitch::stitch()). If strips are faired or tested for
/// intersections, each takes a pass over all faces. Linear extra memory.
///
/// # Errors
/// * [`Error::EmptyMesh`] without pieces, [`Error::MixedScalars`].
/// * [`Error::OptionOutOfRange`] for a gap or tolerance that is negative or not finite.
/// * [`Error::BadLoopPair`] for an entry of `pairs` or `excluded` that does not name loops that can
///   be joined.
/// * [`Error::TooLarge`], [`Error::OutOfMemory`], [`Error::Cancelled`]. Two loops that cannot be
///   joined are not an error; see [`Joint::outcome`].
pub fn assemble(pieces: &[MeshView<'_>], options: &Options<'_>, job: &Job<'_>) -> Result<Assembly> {
    if let MaxGap::Given(gap) = options.max_gap {
        Error::require((0.0..f64::INFINITY).contains(&gap), "max_gap", gap, "finite and at least 0")?;
    }
    let Overlaps::Trim(how) = options.overlaps else {
        let mut base = CombinedPieces::new(pieces, None, options, &job.sub_job(0.0, 0.3))?;
        base.assembly.left = join_facing_loops(
            pieces,
            &mut base,
            options,
            &mut IntersectingStripTreatment::Kept,
            &job.sub_job(0.3, 0.8),
        )?;
        return base.fill_and_turn(options, &job.sub_job(0.8, 1.0)).map(|(assembly, _)| assembly);
    };
    let mut trimmed = trim(pieces, &how, &job.sub_job(0.0, 0.4))?;
    // Pieces that were cut along an overlap are near each other, so the gap is narrow unless parts
    // stay unjoined.
    let mut edges = DEFAULT_GAP_MEAN_EDGES[0];
    // Each round removes small unjoined parts, and faces around strips and patches that intersect;
    // then it starts again.
    let mut round = 0;
    let same = how.same_surface_limits(trimmed.spacing);
    let mut assembly = loop {
        let part = |round: u32| 1.0 - 0.6 * 0.7f64.powi(round as i32);
        let (now, then) = (job.sub_job(part(round), part(round + 1)), job.sub_job(part(round + 1), part(round + 1)));
        let refuses = round >= ROUNDS_WITH_INTERSECTING_STRIPS;
        let gap_of = |edges: f64| match options.max_gap {
            MaxGap::Auto => MaxGap::Given(edges * trimmed.spacing),
            given => given,
        };
        let how_wide = Options { max_gap: gap_of(edges), ..*options };
        let (assembly, cuts) =
            join_trimmed_pieces(pieces, &trimmed, &how_wide, gap_of(DEFAULT_GAP_MEAN_EDGES[1]), refuses, &now)?;
        let is_final = refuses || cuts.is_empty();
        if is_final && round >= MAX_REMOVAL_ROUNDS {
            break assembly;
        }
        round += 1;
        let spoilt = FaceRemovals::new(
            pieces,
            &assembly,
            &cuts,
            how.min_island_faces(),
            round > MAX_ROUNDS_BEFORE_WHOLE_RIM,
            same,
            &then,
        )?;
        let widens =
            spoilt.has_unjoined_parts() && edges == DEFAULT_GAP_MEAN_EDGES[0] && options.max_gap == MaxGap::Auto;
        if widens {
            edges = DEFAULT_GAP_MEAN_EDGES[1];
        }
        if !spoilt.remove_faces_from(pieces, &mut trimmed, &assembly, !widens) && !widens {
            if is_final {
                break assembly;
            }
            round = ROUNDS_WITH_INTERSECTING_STRIPS;
        }
    };
    assembly.lost_faces = list_lost_faces(pieces, &assembly, same, &job.sub_job(1.0, 1.0))?;
    let lost = assembly.lost_faces.len();
    if lost > 0 {
        job.note(&format!(
            "faces dropped by trimming that no kept face covers: {lost}; the report of the assembly lists them"
        ));
    }
    Ok(assembly)
}

/// The treatment of strips that intersect other faces.
enum IntersectingStripTreatment {
    /// Kept, without a list.
    Kept,
    /// Kept, and the pairs of faces are listed.
    Listed(Vec<[u32; 2]>),
    /// Refused.
    Refused,
}

/// Joins the remaining parts of the pieces. Also returns pairs of intersecting faces.
///
/// If strips intersect, holes stay open, and the pairs have faces of strips. Otherwise fills the
/// holes, and returns the pairs with faces of patches. `refuses` leaves out strips that intersect.
fn join_trimmed_pieces(
    pieces: &[MeshView<'_>],
    trimmed: &KeptFacesOfPieces,
    options: &Options<'_>,
    wide: MaxGap,
    refuses: bool,
    job: &Job<'_>,
) -> Result<(Assembly, Vec<[u32; 2]>)> {
    let mut base = CombinedPieces::new(pieces, Some(trimmed), options, &job.sub_job(0.0, 0.3))?;
    let mut cuts =
        if refuses { IntersectingStripTreatment::Refused } else { IntersectingStripTreatment::Listed(Vec::new()) };
    base.assembly.left = join_facing_loops(pieces, &mut base, options, &mut cuts, &job.sub_job(0.3, 0.7))?;
    // Where three pieces meet, the first strips leave loops that face each other, now on one
    // component. The sides of such a seam may be farther apart than unrelated loops.
    let again = Options { within_components: true, pairs: &[], max_gap: wide, ..*options };
    for pass in 0..ADDITIONAL_JOINING_PASSES {
        let before = base.assembly.joints.len();
        alloc::grow(&mut base.piece_of_vertex, base.assembly.mesh.positions.len(), NONE)?;
        base.assembly.left = join_facing_loops(
            pieces,
            &mut base,
            &again,
            &mut cuts,
            &job.sub_job(0.7, 0.8).sub_job_of_item(pass, ADDITIONAL_JOINING_PASSES),
        )?;
        if base.assembly.joints[before..].iter().all(|joint| joint.outcome != Outcome::Joined) {
            break;
        }
    }
    match cuts {
        IntersectingStripTreatment::Listed(cuts) if !cuts.is_empty() => Ok((base.into_joined(), cuts)),
        _ => base.fill_and_turn(options, &job.sub_job(0.8, 1.0)),
    }
}

/// Joins the loops that face each other, as the options request, and returns the loops that are
/// left.
fn join_facing_loops(
    pieces: &[MeshView<'_>],
    base: &mut CombinedPieces,
    options: &Options<'_>,
    cuts: &mut IntersectingStripTreatment,
    job: &Job<'_>,
) -> Result<Vec<LeftLoop>> {
    let CombinedPieces { assembly, piece_of_vertex: piece, vertices_merged_by_sewing: seam, .. } = &*base;
    let mut loops = PieceLoops::new(&assembly.mesh, piece, seam, &job.sub_job(0.0, 0.15))?;
    let excluded = loops.list_excluded_pairs(&assembly.maps, options)?;
    let wide = list_wide_slits(pieces, base, &loops, options, &job.sub_job(0.15, 0.2))?;
    let mut found = choose_loop_pairs(base, &loops, options, &excluded, &wide, &job.sub_job(0.2, 0.4))?;
    if options.within_components
        && matches!(cuts, IntersectingStripTreatment::Listed(_) | IntersectingStripTreatment::Refused)
    {
        found.retain(|facing| loops.is_seam(facing));
    }
    let joined_wholly = alloc::collect(found.iter().map(|facing| facing.arcs.is_none()))?;

    // Make components that face each other agree, nearest first.
    let outcomes = base.make_orientations_agree(&mut loops, &mut found, options.keep_orientation)?;
    alloc::reserve(&mut base.assembly.joints, found.len())?;
    let mut has_strip = alloc::filled(false, loops.rims.len())?;
    let mut tried = alloc::filled(false, loops.rims.len())?;
    let mut edges = loops.edges_between_rims(&base.assembly.mesh)?;
    let mean_side = std::cell::OnceCell::new();
    options.strip.note_unread_options(job);
    let strips = stitch::Options { twist: 0, ..options.strip.strip_options() };
    for (k, (facing, outcome)) in found.iter().zip(outcomes).enumerate() {
        let part = job.sub_job(0.4, 1.0).sub_job_of_item(k, found.len());
        let sides = loops.facing_sides(facing)?;
        facing.rims.iter().for_each(|&r| tried[r] = true);
        let shared = shared_vertex(&sides[0], &sides[1])?.is_some()
            || have_coincident_vertices(&sides[0], &sides[1], base.tolerance / loops.unit, &part.sub_job(0.0, 0.0))?;
        let outcome = if outcome == Outcome::Joined && shared { Outcome::ShareVertex } else { outcome };
        let whole = joined_wholly[k];
        let mut joint = Joint {
            sides: [alloc::copied(&sides[0].vertices)?, alloc::copied(&sides[1].vertices)?],
            whole,
            gap: facing.mean_gap * loops.unit,
            outcome,
            finish: Finish::Strip,
            vertices: 0..0,
            faces: 0..0,
            intersections: None,
            cut_length: 0.0,
            blend_avoids_cuts: false,
        };
        if outcome == Outcome::Joined {
            let order = RimOrder::new(&sides[0], &sides[1]);
            let existing = order.sort_edges(edges.existing_edges_between(facing.rims, &sides)?)?;
            let [a, mut b] = sides;
            b.reverse();
            let [a, b] = order.sort_rims([a, b]);
            let is_slit = facing.rims[0] == facing.rims[1];
            // The ends of a slit already have edges.
            let strips = if is_slit { stitch::Options { rows: Rows::None, ..strips } } else { strips };
            let mean = || *mean_side.get_or_init(|| base.assembly.mesh.mean_side_length()) / loops.unit;
            match Strip::build(a, b, &existing, &strips, mean, &part.sub_job(0.0, 0.6)) {
                Err(Error::NoStrip { .. }) => joint.outcome = Outcome::NoStrip,
                Err(error) => return Err(error),
                Ok(mut strip) => {
                    let (mesh, part) = (&base.assembly.mesh, part.sub_job(0.6, 1.0));
                    let checked = fair_and_check(mesh, &mut strip, loops.unit, &existing, &strips, &part)?;
                    let pairs = checked.intersections.as_deref().unwrap_or_default();
                    match cuts {
                        IntersectingStripTreatment::Refused if !pairs.is_empty() => {
                            joint.outcome = Outcome::WouldCut;
                            base.assembly.joints.push(joint);
                            continue;
                        }
                        IntersectingStripTreatment::Listed(all) => alloc::append(all, pairs)?,
                        IntersectingStripTreatment::Kept if !pairs.is_empty() => {
                            let [a, mut b] = loops.facing_sides(facing)?;
                            b.reverse();
                            let sides = order.sort_rims([a, b]);
                            joint.blend_avoids_cuts = does_blend_avoid_cuts(
                                mesh,
                                sides,
                                &existing,
                                loops.unit,
                                &strips,
                                &part.sub_job(1.0, 1.0),
                            )?;
                        }
                        IntersectingStripTreatment::Kept | IntersectingStripTreatment::Refused => {}
                    }
                    let attached = append_strip(&mut base.assembly.mesh, &strip, loops.unit)?;
                    edges.add_strip_edges(&strip)?;
                    let name = |v: u32| attached.mesh_vertex_of_strip_vertex[v as usize];
                    let new = strip.parents.iter().map(|parents| (parents.vertices.map(name), parents.weights));
                    base.assembly.history.add_parents(new)?;
                    joint.sides = order.given_rims(&mut strip);
                    joint.vertices = attached.vertices;
                    joint.faces = attached.faces;
                    joint.intersections = checked.intersections;
                    joint.finish = checked.finish;
                    facing.rims.iter().for_each(|&r| has_strip[r] = true);
                }
            }
        }
        base.assembly.joints.push(joint);
    }
    list_left_loops(loops, options, &excluded, [&has_strip, &tried], &job.sub_job(1.0, 1.0))
}

/// Returns true if a blend between two sides would not intersect other faces. Only strips whose
/// intersections are avoided, and that are not blends, are compared with a blend.
fn does_blend_avoid_cuts(
    mesh: &Mesh,
    [a, b]: [Rim; 2],
    existing: &ExistingEdges,
    unit: f64,
    options: &stitch::Options,
    job: &Job<'_>,
) -> Result<bool> {
    if options.finish == Finish::Blend || options.intersections != Intersections::Auto {
        return Ok(false);
    }
    let options = stitch::Options { finish: Finish::Blend, ..*options };
    let mut strip = match Strip::build(a, b, existing, &options.strip_options(), || 1.0, job) {
        Err(Error::NoStrip { .. }) => return Ok(false),
        strip => strip?,
    };
    let checked = fair_and_check(mesh, &mut strip, unit, existing, &options.strip_options(), job)?;
    Ok(checked.finish == Finish::Blend && checked.intersections.is_some_and(|pairs| pairs.is_empty()))
}

/// Returns the loops without a strip, and the reasons.
fn list_left_loops(
    mut loops: PieceLoops,
    options: &Options<'_>,
    excluded: &[[u32; 2]],
    [has_strip, tried]: [&[bool]; 2],
    job: &Job<'_>,
) -> Result<Vec<LeftLoop>> {
    let without = alloc::collect(has_strip.iter().map(|&has_strip| !has_strip))?;
    let explained = loops.facing_search(options, has_strip, excluded).explain_left_loops(&without, job)?;
    let mut left = std::mem::take(&mut loops.loops_without_strip);
    for (r, found) in explained.iter().enumerate() {
        let Some(found) = found else { continue };
        let vertices = std::mem::take(&mut loops.rims[r].vertices);
        let reason = if tried[r] { Reason::NotJoined } else { found.reason };
        let [gap, allowed_gap] = [found.mean_gap, found.allowed_gap].map(|length| length * loops.unit);
        alloc::push(&mut left, LeftLoop { vertices, origin: [NONE; 2], reason, gap, allowed_gap, filled: false })?;
    }
    let smallest = |left: &LeftLoop| left.vertices.iter().fold(NONE, |smallest, &v| smallest.min(v));
    sort::sort_stable(&mut left, &|x, y| smallest(x).cmp(&smallest(y)));
    Ok(left)
}

/// Returns the wide slits to be joined with themselves, in ascending order: their sides belonged to
/// two whole loops that faced each other before sewing.
fn list_wide_slits(
    pieces: &[MeshView<'_>],
    base: &CombinedPieces,
    loops: &PieceLoops,
    options: &Options<'_>,
    job: &Job<'_>,
) -> Result<Vec<usize>> {
    if !UnsewnLoopPairs::may_exist(options) {
        return Ok(Vec::new());
    }
    let search = loops.facing_search(options, &[], &[]);
    let is_wide = |r: &usize| {
        let slit = loops.slits[*r].filter(|slit| slit.is_opposed);
        slit.is_some_and(|slit| !(slit.may_be_closed && slit.mean_gap <= search.max_slit_gap(*r)))
    };
    let mut wide = alloc::gather((0..loops.rims.len()).filter(is_wide))?;
    if !wide.is_empty() {
        let names = base.assembly.maps.iter().flat_map(|map| &map.vertices).copied();
        let pairs = UnsewnLoopPairs::find(pieces, options, names, job)?;
        let sides_are_paired = |&r: &usize| -> Result<bool> {
            let (Some(slit), rim) = (loops.slits[r], &loops.rims[r]) else { return Ok(false) };
            let side = |arc: Arc| alloc::collect(arc.places(rim.vertices.len()).map(|i| rim.vertices[i]));
            pairs.join_runs(&side(slit.arcs[0])?, &side(slit.arcs[1])?)
        };
        let paired = alloc::try_collect(wide.iter().map(sides_are_paired))?;
        let mut paired = paired.into_iter();
        wide.retain(|_| paired.next() == Some(true));
    }
    Ok(wide)
}

/// Returns the given pairs, then the pairs found by the search.
fn choose_loop_pairs(
    base: &CombinedPieces,
    loops: &PieceLoops,
    options: &Options<'_>,
    excluded: &[[u32; 2]],
    wide: &[usize],
    job: &Job<'_>,
) -> Result<Vec<FacingLoops>> {
    let places = loops.vertex_loop_pairs()?;
    let mut taken = alloc::filled(false, loops.rims.len())?;
    let mut found: Vec<FacingLoops> = Vec::new();
    for (k, pair) in options.pairs.iter().enumerate() {
        let given = GivenLoopPair { option: "pairs", pair_index: k as u32, pair };
        given.check_pieces_and_vertices_exist(&base.assembly.maps)?;
        let rims = given.find_named_rims(
            |selector| loops.select_loops(&base.assembly.maps, &places, selector),
            &taken,
            |r| loops.slits[r].is_some(),
        )?;
        rims.iter().for_each(|&r| taken[r] = true);
        let facing = match &loops.slits[rims[0]] {
            Some(slit) if rims[0] == rims[1] => slit.as_facing_loops(rims[0]),
            _ => FacingLoops {
                rims,
                arcs: None,
                mean_gap: mean_gap(&loops.rims[rims[0]], &loops.rims[rims[1]], &job.sub_job(0.0, 0.0))?,
            },
        };
        alloc::push(&mut found, facing)?;
    }
    if options.max_gap != MaxGap::Given(0.0) {
        let search = loops.facing_search(options, &taken, excluded);
        let mut seen = alloc::gather(search.unused_slits(wide))?;
        seen.iter().for_each(|facing| taken[facing.rims[0]] = true);
        let facing = loops.facing_search(options, &taken, excluded).find_facing_loops(&job.sub_job(0.0, 0.8))?;
        facing.iter().flat_map(|facing| facing.rims).for_each(|r| taken[r] = true);
        alloc::append(&mut seen, &facing)?;
        let lone = loops.facing_search(options, &taken, excluded).pair_lone_loops(&job.sub_job(0.8, 1.0))?;
        alloc::append(&mut seen, &lone)?;
        let first = |found: &FacingLoops| found.arcs.map_or(0, |arcs| arcs[0].first);
        sort::sort_stable(&mut seen, &|x, y| {
            x.mean_gap.total_cmp(&y.mean_gap).then(x.rims.cmp(&y.rims)).then(first(x).cmp(&first(y)))
        });
        alloc::append(&mut found, &seen)?;
    }
    Ok(found)
}
