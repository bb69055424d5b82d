//! The stages of assembly in order, from pieces to one mesh and its report.

use super::assemble_request::{Assembly, Joint, LeftLoop, MaxGap, Options, Outcome, Overlaps, Reason};
use super::base::Base;
use super::candidates::Facing;
use super::given_pair::GivenPair;
use super::piece_loops::Loops;
use super::trimmed::Spoilt;
use crate::stitch::combine::append_strip;
use crate::stitch::fair_and_check::fair_and_check;
use crate::stitch::loop_pairing::mean_gap;
use crate::stitch::stitch_rim::shared_vertex;
use crate::stitch::strip::Strip;
use crate::stitch::{self, Finish, Rows};
use crate::trim::{Trimmed, trim};
use gusset_base::alloc;
use gusset_base::error::{Error, Result};
use gusset_base::job::Job;
use gusset_base::sort;
use gusset_mesh::{MeshView, NONE};

/// How wide gaps between trimmed pieces are, in mean edges of the coarsest, if the caller says
/// nothing; the second where parts would be left alone.
const GAP_EDGES: [f64; 2] = [2.5, 4.0];
/// Rounds in which what is left of trimmed pieces gets less where it cannot be joined; in the first
/// of them where strips cut, and after these such strips are refused.
const MAX_ROUNDS: u32 = 10;
const ROUNDS_OF_STRIPS: u32 = 4;
/// After so many rounds patches that still cut lose their rims whole.
const WHOLE_AFTER: u32 = 6;
/// How often loops are looked for that strips have left facing each other.
const MORE_PASSES: usize = 2;

/// Assembles open pieces into one mesh: coincident borders are sewn, components oriented alike,
/// loops that face each other across a gap stitched, holes filled, and closed components turned
/// outwards, as the options say.
///
/// O(H log d) for the pieces' H half-edges, O(V log V) for the V vertices on loops, the time of
/// each strip as for [`stitch()`](crate::stitch::stitch()), and where strips are faired or tested
/// for intersections a pass over all faces for each. Linear extra memory.
///
/// # Errors
/// [`Error::EmptyMesh`] without pieces, [`Error::MixedScalars`], [`Error::OptionOutOfRange`] for a
/// gap or tolerance that is negative or not finite, [`Error::BadLoopPair`] for one of `pairs` or
/// `excluded` that names no loops that can be joined, [`Error::TooLarge`], [`Error::OutOfMemory`],
/// [`Error::Cancelled`]. That two loops cannot be joined is no error: see
/// [`Joint::outcome`].
pub fn assemble(pieces: &[MeshView<'_>], options: &Options<'_>, job: &Job<'_>) -> Result<Assembly> {
    if let MaxGap::Given(gap) = options.max_gap {
        Error::require((0.0..f64::INFINITY).contains(&gap), "max_gap", gap)?;
    }
    let Overlaps::Trim(how) = options.overlaps else {
        let mut base = Base::new(pieces, None, options, &job.part(0.0, 0.3))?;
        base.done.left = join(&mut base, options, &mut Cuts::Kept, &job.part(0.3, 0.8))?;
        return finished(base, options, &job.part(0.8, 1.0)).map(|(done, _)| done);
    };
    let mut trimmed = trim(pieces, &how, &job.part(0.0, 0.4))?;
    // Pieces that were cut where they overlap are near each other there: no loop is to look
    // farther, unless parts are left alone.
    let mut edges = GAP_EDGES[0];
    // What is left small and alone, and what makes strips or patches cut, goes, and all is done
    // once more.
    let mut round = 0;
    loop {
        let part = |round: u32| 1.0 - 0.6 * 0.7f64.powi(round as i32);
        let (now, then) = (job.part(part(round), part(round + 1)), job.part(part(round + 1), part(round + 1)));
        let refuses = round >= ROUNDS_OF_STRIPS;
        let gap_of = |edges: f64| match options.max_gap {
            MaxGap::Auto => MaxGap::Given(edges * trimmed.spacing),
            given => given,
        };
        let how_wide = Options { max_gap: gap_of(edges), ..*options };
        let (done, cuts) = joined(pieces, &trimmed, &how_wide, gap_of(GAP_EDGES[1]), refuses, &now)?;
        let is_final = refuses || cuts.is_empty();
        if is_final && round >= MAX_ROUNDS {
            return Ok(done);
        }
        round += 1;
        let spoilt = Spoilt::of(pieces, &done, &cuts, how.least_island(), round > WHOLE_AFTER, &then)?;
        let widens = spoilt.has_alone() && edges == GAP_EDGES[0] && options.max_gap == MaxGap::Auto;
        if widens {
            edges = GAP_EDGES[1];
        }
        if !spoilt.take_out(pieces, &mut trimmed, &done, !widens) && !widens {
            if is_final {
                return Ok(done);
            }
            round = ROUNDS_OF_STRIPS;
        }
    }
}

/// What becomes of strips that cut other faces.
enum Cuts {
    /// They are kept, as all are.
    Kept,
    /// They are kept, and these are the pairs of faces.
    Listed(Vec<[u32; 2]>),
    /// They are refused.
    Refused,
}

/// Joins what is left of the pieces; also the pairs of faces that cut each other: those of strips,
/// before anything is filled, unless `refuses` says that such strips are not made; else those of
/// patches.
fn joined(
    pieces: &[MeshView<'_>],
    trimmed: &Trimmed,
    options: &Options<'_>,
    wide: MaxGap,
    refuses: bool,
    job: &Job<'_>,
) -> Result<(Assembly, Vec<[u32; 2]>)> {
    let mut base = Base::new(pieces, Some(trimmed), options, &job.part(0.0, 0.3))?;
    let mut cuts = if refuses { Cuts::Refused } else { Cuts::Listed(Vec::new()) };
    base.done.left = join(&mut base, options, &mut cuts, &job.part(0.3, 0.7))?;
    // Where three pieces meet, the first strips leave loops that face each other, of what is one
    // component now. Sides of a seam may be farther apart than loops of which nothing is known.
    let again = Options { within_components: true, pairs: &[], max_gap: wide, ..*options };
    for pass in 0..MORE_PASSES {
        let before = base.done.joints.len();
        alloc::grow(&mut base.piece, base.done.mesh.positions.len(), NONE)?;
        base.done.left = join(&mut base, &again, &mut cuts, &job.part(0.7, 0.8).share(pass, MORE_PASSES))?;
        if base.done.joints[before..].iter().all(|joint| joint.outcome != Outcome::Joined) {
            break;
        }
    }
    match cuts {
        Cuts::Listed(cuts) if !cuts.is_empty() => Ok((base.done, cuts)),
        _ => finished(base, options, &job.part(0.8, 1.0)),
    }
}

/// Fills and turns what was joined; also the pairs of faces that patches cut.
fn finished(mut base: Base, options: &Options<'_>, job: &Job<'_>) -> Result<(Assembly, Vec<[u32; 2]>)> {
    let is_near = |left: &&LeftLoop| matches!(left.reason, Reason::LooksAway | Reason::Taken | Reason::NotJoined);
    base.done.near_loops_left = base.done.left.iter().filter(is_near).count() as u32;
    if base.done.near_loops_left > 0 {
        job.note("loops are left although others are near: the account of the assembly says why");
    }
    base.finish(options, job)
}

/// Joins the loops that face each other, as the options say, and returns those that are left.
fn join(base: &mut Base, options: &Options<'_>, cuts: &mut Cuts, job: &Job<'_>) -> Result<Vec<LeftLoop>> {
    let mut loops = Loops::of(base, &job.part(0.0, 0.2))?;
    let excluded = excluded_pairs(base, &loops, options)?;
    let mut found = chosen_pairs(base, &loops, options, &excluded, &job.part(0.2, 0.4))?;
    if options.within_components && matches!(cuts, Cuts::Listed(_) | Cuts::Refused) {
        found.retain(|facing| loops.is_seam(facing));
    }
    let joined_wholly = alloc::collect(found.iter().map(|facing| facing.arcs.is_none()))?;

    // Components that face each other are made to agree, nearest first.
    let outcomes = base.make_agree(&mut loops, &mut found, options.keep_orientation)?;
    alloc::reserve(&mut base.done.joints, found.len())?;
    let mut hangs = alloc::filled(false, loops.rims.len())?;
    let mut tried = alloc::filled(false, loops.rims.len())?;
    let mut edges = loops.edges_between(&base.done.mesh)?;
    let mean_side = std::cell::OnceCell::new();
    options.strip.note_unread(job);
    let strips = stitch::Options { twist: 0, ..options.strip.strip_options() };
    for (k, (facing, outcome)) in found.iter().zip(outcomes).enumerate() {
        let part = job.part(0.4, 1.0).share(k, found.len());
        let sides = loops.sides(facing)?;
        facing.rims.iter().for_each(|&r| tried[r] = true);
        let shared = shared_vertex(&sides[0], &sides[1])?.is_some();
        let outcome = if outcome == Outcome::Joined && shared { Outcome::ShareVertex } else { outcome };
        let whole = joined_wholly[k];
        let mut joint = Joint {
            sides: [alloc::copied(&sides[0].vertices)?, alloc::copied(&sides[1].vertices)?],
            whole,
            gap: facing.gap * loops.unit,
            outcome,
            finish: Finish::Strip,
            vertices: 0..0,
            faces: 0..0,
            intersections: None,
        };
        if outcome == Outcome::Joined {
            let bridges = edges.between(facing.rims, &sides)?;
            let [a, mut b] = sides;
            b.reverse();
            let is_slit = facing.rims[0] == facing.rims[1];
            // At its ends there are edges already.
            let strips = if is_slit { stitch::Options { rows: Rows::None, ..strips } } else { strips };
            let mean = || *mean_side.get_or_init(|| base.done.mesh.mean_side()) / loops.unit;
            match Strip::build(a, b, &bridges, &strips, mean, &part.part(0.0, 0.6)) {
                Err(Error::NoStrip { .. }) => joint.outcome = Outcome::NoStrip,
                Err(error) => return Err(error),
                Ok(mut strip) => {
                    let (mesh, part) = (&base.done.mesh, part.part(0.6, 1.0));
                    let checked = fair_and_check(mesh, &mut strip, loops.unit, &bridges, &strips, &part)?;
                    let pairs = checked.intersections.as_deref().unwrap_or_default();
                    match cuts {
                        Cuts::Refused if !pairs.is_empty() => {
                            joint.outcome = Outcome::WouldCut;
                            base.done.joints.push(joint);
                            continue;
                        }
                        Cuts::Listed(all) => alloc::append(all, pairs)?,
                        Cuts::Kept | Cuts::Refused => {}
                    }
                    let attached = append_strip(&mut base.done.mesh, &strip, loops.unit)?;
                    edges.enter_strip(&strip)?;
                    let name = |v: u32| attached.names[v as usize];
                    let new = strip.parents.iter().map(|parents| (parents.vertices.map(name), parents.weights));
                    base.done.history.enter(new)?;
                    joint.sides = [strip.a.vertices, strip.b.vertices];
                    joint.vertices = attached.vertices;
                    joint.faces = attached.faces;
                    joint.intersections = checked.intersections;
                    joint.finish = checked.finish;
                    facing.rims.iter().for_each(|&r| hangs[r] = true);
                }
            }
        }
        base.done.joints.push(joint);
    }
    left_loops(loops, options, &excluded, [&hangs, &tried], &job.part(1.0, 1.0))
}

/// The loops that no strip hangs on, with the reasons.
fn left_loops(
    loops: Loops,
    options: &Options<'_>,
    excluded: &[[u32; 2]],
    [hangs, tried]: [&[bool]; 2],
    job: &Job<'_>,
) -> Result<Vec<LeftLoop>> {
    let without = alloc::collect(hangs.iter().map(|&hangs| !hangs))?;
    let explained = loops.search(options, hangs, excluded).explain(&without, job)?;
    let mut left = loops.others;
    for (r, (rim, found)) in loops.rims.into_iter().zip(explained).enumerate() {
        if let Some(found) = found {
            let reason = if tried[r] { Reason::NotJoined } else { found.reason };
            let [gap, allowed_gap] = [found.gap, found.allowed].map(|length| length * loops.unit);
            alloc::push(&mut left, LeftLoop { vertices: rim.vertices, reason, gap, allowed_gap })?;
        }
    }
    sort::stable(&mut left, &|x, y| x.vertices.iter().min().cmp(&y.vertices.iter().min()));
    Ok(left)
}

/// The pairs of loops (smaller, larger) that are not to be joined, in ascending order.
fn excluded_pairs(base: &Base, loops: &Loops, options: &Options<'_>) -> Result<Vec<[u32; 2]>> {
    let places = loops.places()?;
    let mut excluded = Vec::new();
    for (k, pair) in options.excluded.iter().enumerate() {
        GivenPair { option: "excluded", number: k as u32, pair }.check_exists(&base.done.maps)?;
        let (first, second) = (loops.named(base, &places, pair[0])?, loops.named(base, &places, pair[1])?);
        let pairs = first.iter().flat_map(|&r| second.iter().map(move |&s| [r.min(s) as u32, r.max(s) as u32]));
        alloc::extend(&mut excluded, pairs)?;
    }
    excluded.sort_unstable();
    Ok(excluded)
}

/// The pairs that were given, and after them those that are found.
fn chosen_pairs(
    base: &Base,
    loops: &Loops,
    options: &Options<'_>,
    excluded: &[[u32; 2]],
    job: &Job<'_>,
) -> Result<Vec<Facing>> {
    let places = loops.places()?;
    let mut taken = alloc::filled(false, loops.rims.len())?;
    let mut found: Vec<Facing> = Vec::new();
    for (k, pair) in options.pairs.iter().enumerate() {
        let given = GivenPair { option: "pairs", number: k as u32, pair };
        given.check_exists(&base.done.maps)?;
        let rims = given.rims(|selector| loops.named(base, &places, selector), &taken, |r| loops.slits[r].is_some())?;
        rims.iter().for_each(|&r| taken[r] = true);
        let facing = match &loops.slits[rims[0]] {
            Some(slit) if rims[0] == rims[1] => slit.facing(rims[0]),
            _ => Facing {
                rims,
                arcs: None,
                gap: mean_gap(&loops.rims[rims[0]], &loops.rims[rims[1]], &job.part(0.0, 0.0))?,
            },
        };
        alloc::push(&mut found, facing)?;
    }
    if options.max_gap != MaxGap::Given(0.0) {
        let search = loops.search(options, &taken, excluded);
        let mut seen = alloc::gather(search.slits())?;
        seen.iter().for_each(|facing| taken[facing.rims[0]] = true);
        alloc::append(&mut seen, &loops.search(options, &taken, excluded).run(job)?)?;
        let first = |found: &Facing| found.arcs.map_or(0, |arcs| arcs[0].first);
        sort::stable(&mut seen, &|x, y| {
            x.gap.total_cmp(&y.gap).then(x.rims.cmp(&y.rims)).then(first(x).cmp(&first(y)))
        });
        alloc::append(&mut found, &seen)?;
    }
    Ok(found)
}
